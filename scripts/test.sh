#!/usr/bin/env bash
# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Installs what is missing, builds everything in build/tests/ and runs all tests; then those of the list in
# test/Parametric_surface_mesher/CMakeLists.txt, and mesh_patch, under the address and undefined-behaviour sanitizers in build/sanitize/.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"
scripts/install_dependencies.sh
# They read files back in tests, write .3mf files, or make the manual; what needs them is skipped without them.
scripts/install_dependencies.sh calculix-ccx gmsh python3-meshio lib3mf-dev doxygen libjs-mathjax \
  || echo "== Going on without CalculiX, Gmsh, meshio, lib3mf or Doxygen"
# The browser that pages of meshes are looked at in.
scripts/install_dependencies.sh chromium python3 || echo "== Going on without Chromium"
jobs=$(nproc)

# configure DIRECTORY [option...]: quiet unless it fails
configure() {
  local directory=$1 log
  shift
  echo "== Configuring $directory/"
  mkdir -p "$directory"
  log=$directory/configure.log
  cmake -S . -B "$directory" "$@" > "$log" 2>&1 || { cat "$log"; exit 1; }
}

# With -O1 it compiles in 0.8 of the time that -O3 takes, and the tests are as fast. So it is not in build/, whose programs are fast.
configure build/tests -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE="-O1 -DNDEBUG"
if grep -E "without (tests|programs)" build/tests/configure.log; then
  exit 1
fi
echo "== Building"
cmake --build build/tests -j "$jobs"
echo "== Testing"
ctest --test-dir build/tests --output-on-failure -j "$jobs"

# Without Open CASCADE, whose programs take long to build with sanitizers.
configure build/sanitize -DCMAKE_BUILD_TYPE=Release -DPARAMETRIC_SURFACE_MESHER_SANITIZE=address,undefined \
  -DPARAMETRIC_SURFACE_MESHER_WITH_BENCHMARKS=OFF -DCMAKE_DISABLE_FIND_PACKAGE_OpenCASCADE=ON
echo "== Building with sanitizers"
cmake --build build/sanitize -j "$jobs"
echo "== Testing with sanitizers"
ctest --test-dir build/sanitize --output-on-failure -j "$jobs"

echo "== All tests passed"
