# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Installs two components: parametric-surface-mesher-dev, the headers with a config package for CMake, a file for pkg-config and, if the
# target doc was built, the manual; and parametric-surface-mesher, the programs. A third, python3-parametric-surface-mesher, is that of
# python/. CPack makes a Debian package of each that was built.

set(development_component parametric-surface-mesher-dev)
set(programs_component parametric-surface-mesher)

set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/Parametric_surface_mesher)
install(DIRECTORY include/CGAL DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT ${development_component} FILES_MATCHING PATTERN "*.h")
install(FILES COPYING README.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT ${development_component})
install(DIRECTORY examples/Parametric_surface_mesher DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples COMPONENT ${development_component})
install(DIRECTORY ${PROJECT_BINARY_DIR}/doc/html DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT ${development_component} OPTIONAL)
install(TARGETS Parametric_surface_mesher EXPORT Parametric_surface_mesherTargets COMPONENT ${development_component})
install(EXPORT Parametric_surface_mesherTargets
  NAMESPACE Parametric_surface_mesher::
  DESTINATION ${config_dir}
  COMPONENT ${development_component})
configure_package_config_file(cmake/Parametric_surface_mesherConfig.cmake.in
  ${PROJECT_BINARY_DIR}/Parametric_surface_mesherConfig.cmake
  INSTALL_DESTINATION ${config_dir})
# Before 1.0 each minor version may break its users.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/Parametric_surface_mesherConfigVersion.cmake
  COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES
  cmake/Parametric_surface_mesher_Open_cascade_support.cmake
  cmake/Parametric_surface_mesher_Med_support.cmake
  cmake/Parametric_surface_mesher_Page_support.cmake
  cmake/Parametric_surface_mesher_3mf_support.cmake
  cmake/Parametric_surface_mesher_optional_libraries.cmake
  cmake/Parametric_surface_mesher_programs.cmake
  cmake/make_mesh_page_source.cmake
  ${PROJECT_BINARY_DIR}/Parametric_surface_mesherConfig.cmake
  ${PROJECT_BINARY_DIR}/Parametric_surface_mesherConfigVersion.cmake
  DESTINATION ${config_dir}
  COMPONENT ${development_component})
install(DIRECTORY page DESTINATION ${config_dir} COMPONENT ${development_component})

# For those who build without CMake. The compiler option is the one that CGAL's own target has.
configure_file(cmake/parametric_surface_mesher.pc.in ${PROJECT_BINARY_DIR}/parametric_surface_mesher.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/parametric_surface_mesher.pc DESTINATION ${CMAKE_INSTALL_DATADIR}/pkgconfig
  COMPONENT ${development_component})

# The programs take long to build, and are installed if they were built.
foreach(program mesh_patch mesh_cad)
  if(TARGET ${program})
    install(TARGETS ${program} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT ${programs_component} OPTIONAL)
  endif()
endforeach()

if(is_top_level)
  set(CPACK_GENERATOR DEB)
  set(CPACK_PACKAGE_NAME parametric-surface-mesher)
  set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
  set(CPACK_PACKAGE_CONTACT "The authors of Parametric_surface_mesher <parametric-surface-mesher@example.org>")
  set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "triangle meshes of trimmed parametric surfaces and CAD files")
  set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/COPYING)
  set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
  set(CPACK_DEB_COMPONENT_INSTALL ON)
  set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
  set(CPACK_DEBIAN_PACKAGE_SECTION math)
  set(CPACK_STRIP_FILES ON)

  set(CPACK_COMPONENTS_ALL ${development_component})
  set(CPACK_DEBIAN_PARAMETRIC-SURFACE-MESHER-DEV_PACKAGE_NAME ${development_component})
  set(CPACK_DEBIAN_PARAMETRIC-SURFACE-MESHER-DEV_PACKAGE_ARCHITECTURE all)
  set(CPACK_DEBIAN_PARAMETRIC-SURFACE-MESHER-DEV_PACKAGE_DEPENDS
    "libcgal-dev (>= 5.5), libeigen3-dev, libboost-dev, libgmp-dev, libmpfr-dev")
  set(CPACK_DEBIAN_PARAMETRIC-SURFACE-MESHER-DEV_PACKAGE_SUGGESTS
    "libtbb-dev, libocct-data-exchange-dev, libmedc-dev, lib3mf-dev, libjs-three")
  set(CPACK_DEBIAN_PARAMETRIC-SURFACE-MESHER-DEV_PACKAGE_SECTION libdevel)

  set(CPACK_DEBIAN_PARAMETRIC-SURFACE-MESHER_PACKAGE_NAME ${programs_component})
  set(CPACK_DEBIAN_PARAMETRIC-SURFACE-MESHER_PACKAGE_SHLIBDEPS ON)

  # (python/CMakeLists.txt tells what it depends on.)
  set(python_component python3-parametric-surface-mesher)
  set(CPACK_DEBIAN_PYTHON3-PARAMETRIC-SURFACE-MESHER_PACKAGE_NAME ${python_component})
  set(CPACK_DEBIAN_PYTHON3-PARAMETRIC-SURFACE-MESHER_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PYTHON3-PARAMETRIC-SURFACE-MESHER_PACKAGE_SUGGESTS "python3-matplotlib")
  set(CPACK_DEBIAN_PYTHON3-PARAMETRIC-SURFACE-MESHER_PACKAGE_SECTION python)

  # Which programs were built is known when packages are made: without them, their packages would be empty. Programs of Debian find out
  # which packages the libraries are in that they are linked with.
  set(built_components "find_program(FILE_PROGRAM file)
find_program(DEPENDENCIES_PROGRAM dpkg-shlibdeps)
if(CPACK_GENERATOR STREQUAL DEB AND NOT (FILE_PROGRAM AND DEPENDENCIES_PROGRAM))
  message(FATAL_ERROR \"Making Debian packages needs the programs file and dpkg-shlibdeps; please install them (packages file, dpkg-dev)\")
endif()
")
  foreach(target_and_component "mesh_patch:${programs_component}" "parametric_surface_mesher_python:${python_component}")
    string(REPLACE ":" ";" target_and_component "${target_and_component}")
    list(GET target_and_component 0 target)
    list(GET target_and_component 1 component)
    if(TARGET ${target})
      string(APPEND built_components
        "if(EXISTS \"$<TARGET_FILE:${target}>\")\n  list(APPEND CPACK_COMPONENTS_ALL ${component})\nendif()\n")
    endif()
  endforeach()
  set(CPACK_PROJECT_CONFIG_FILE ${PROJECT_BINARY_DIR}/CPackComponents.cmake)
  file(GENERATE OUTPUT ${CPACK_PROJECT_CONFIG_FILE} CONTENT "${built_components}")
  include(CPack)
endif()
