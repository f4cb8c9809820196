#!/usr/bin/env bash
# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Adds the package to CGAL's source tree, a git checkout of CGAL with a folder for each package, as the folder Parametric_surface_mesher,
# and shows that CGAL's own CMake finds it there: it is configured with find_package(CGAL) of that tree alone, and one example and one test
# are built and run, unless --no-build says otherwise. A folder that an earlier call of this script made is made anew.
#
#   scripts/add_to_cgal_tree.sh [--no-build] <folder of CGAL's source tree>
#
# Left out are what CGAL has in other places: README.md, COPYING, the top-level CMakeLists.txt, scripts/, and the Python module. The CMake
# modules are in cmake/modules/, which joins CGAL's own folder of that name when CGAL makes a release.
#
# Tried with the layout of the git tree made from releases 5.5 and 6.1 of CGAL (test/Parametric_surface_mesher/make_cgal_tree.py), whose
# CMake files are those of the git tree. Not tried: a real checkout; CGAL's target for the manual, whose files are in no release (looked at
# is only what it looks for); and making a release of CGAL with the package. By hand, for the list of packages in CGAL's manual: a line
# \package_listing{Parametric_surface_mesher} in Documentation/doc/Documentation/packages.txt.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
name=Parametric_surface_mesher

fail() {
  echo "$1" >&2
  exit 1
}

build=yes
if [ "${1:-}" = --no-build ]; then
  build=
  shift
fi
[ $# -eq 1 ] || fail "usage: scripts/add_to_cgal_tree.sh [--no-build] <folder of CGAL's source tree>"
[ -d "$1/Installation/package_info/Installation" ] || fail "$1 is no source tree of CGAL with a folder for each package, as git has it: \
it has no folder Installation/package_info/Installation."
tree=$(cd "$1" && pwd)
package=$tree/$name
# CGAL's word for a package that is not to be in releases; here it also tells that this script made the folder.
marker=$package/dont_submit
[ ! -e "$package" ] || [ -e "$marker" ] || fail "$package exists, and was not made by this script; please move it away."

echo "== Copying"
rm -rf "$package"
mkdir -p "$package/cmake/modules"
touch "$marker"
for folder in include test examples benchmark doc package_info; do
  cp -R "$root/$folder" "$package/$folder"
done
cp -R "$root"/cmake/Parametric_surface_mesher_*.cmake "$root/cmake/make_mesh_page_source.cmake" "$root/page" "$package/cmake/modules"
rm "$package/cmake/modules/Parametric_surface_mesher_install.cmake"
find "$package" -name __pycache__ -prune -exec rm -rf {} +

echo "== Looking at the layout"
for file in package_info/$name/{copyright,dependencies,description.txt,license.txt,long_description.txt,maintainer} \
  doc/$name/{Doxyfile.in,PackageDescription.txt,dependencies,examples.txt} {test,examples,benchmark}/$name/CMakeLists.txt; do
  [ -s "$package/$file" ] || fail "$package/$file is missing or empty."
done
while read -r dependency; do
  [ -d "$tree/$dependency/package_info" ] || [ "$dependency" = Manual ] \
    || fail "$dependency is in a list of dependencies, and no package of $tree."
done < <(cat "$package/package_info/$name/dependencies" "$package/doc/$name/dependencies")
while read -r example; do
  [ -e "$package/examples/$example" ] || fail "doc/$name/examples.txt lists $example, which does not exist."
done < <(sed -n 's/^\\example //p' "$package/doc/$name/examples.txt")
# The commands of the manual are those of CGAL's manual, whose files are in git only.
manual=$tree/Documentation/doc
if [ -d "$manual/resources" ]; then
  grep -rhoE '\\cgal[A-Za-z]+' "$package/doc" "$package/include" | sort -u | tr -d '\\' | while read -r command; do
    grep -rqE "\"$command(\{[0-9]\})?=" "$manual/resources" "$manual/CMakeLists.txt" \
      || fail "The manual has the command $command, which that of CGAL has not."
  done
fi
# In a release, the headers of all packages are in one folder, and so are the executables of each kind in CGAL's own builds.
(cd "$package/include" && find . -type f) | while read -r header; do
  for other in "$tree"/*/include/"$header"; do
    [ ! -e "$other" ] || [ "$other" -ef "$package/include/$header" ] || fail "$other has the name of a header of this package."
  done
done
for kind in examples test; do
  (cd "$package/$kind/$name" && ls -- *.cpp) | while read -r source; do
    for other in "$tree"/*/$kind/*/"$source"; do
      [ ! -e "$other" ] || [ "$other" -ef "$package/$kind/$name/$source" ] || fail "$other has the name of a program of this package."
    done
  done
done

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
quietly() {
  "$@" > "$work/log" 2>&1 || { tail -40 "$work/log"; fail "failed: $*"; }
}

echo "== Finding it with CGAL's CMake"
mkdir "$work/find"
cat > "$work/find/CMakeLists.txt" << END
cmake_minimum_required(VERSION 3.16)
project(Find CXX)
find_package(CGAL REQUIRED)
if(NOT "$package/include" IN_LIST CGAL_INCLUDE_DIRS)
  message(FATAL_ERROR "$package/include is not among the folders that CGAL's CMake takes headers from")
endif()
END
quietly cmake -S "$work/find" -B "$work/find/build" -DCMAKE_BUILD_TYPE=Release -DCGAL_DIR="$tree"
for kind in examples test benchmark; do
  echo "== Configuring $kind/$name"
  quietly cmake -S "$package/$kind/$name" -B "$work/$kind" -DCMAKE_BUILD_TYPE=Release -DCGAL_DIR="$tree"
done

if [ "$build" ]; then
  echo "== Building and running an example and a test"
  quietly cmake --build "$work/examples" --target mesh_own_formula
  quietly cmake --build "$work/test" --target test_metric_tensor
  "$work/examples/mesh_own_formula"
  "$work/test/test_metric_tensor" --gtest_brief=1
fi
echo "== $package is a package of that CGAL"
