#!/usr/bin/env bash
# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Installs what is missing, builds mesh_patch and mesh_cad, and meshes the Utah teapot, the paper's four kinds of surface and
# a CAD file that a package of Debian brings along.
# Meshes (.off), pages to look at in a browser (.html), pictures (.png, .svg) and numbers (.json) go to build/demo/.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"
scripts/install_dependencies.sh

echo "== Configuring build/"
mkdir -p build
cmake -S . -B build -DCMAKE_BUILD_TYPE=Release > build/configure.log 2>&1 || { cat build/configure.log; exit 1; }

targets=(mesh_patch print_results_table)
# As far as what they need is installed.
if ! grep -q "without mesh_cad" build/configure.log; then
  targets+=(mesh_cad)
fi
echo "== Building ${targets[*]}"
cmake --build build --target "${targets[@]}" -j "$(nproc)"

programs=build/examples/Parametric_surface_mesher
out=build/demo
mkdir -p "$out"
results=()
picture=png
if grep -q "write pictures as .svg only" build/configure.log; then
  picture=svg
fi
pages=yes
if grep -q "without pages to look at" build/configure.log; then
  pages=
fi

# mesh NAME SURFACE [option...]
mesh() {
  local name=$1
  shift
  echo "== Meshing $name"
  "$programs/mesh_patch" "$@" --out "$out/$name.off" --picture "$out/$name.$picture" --json "$out/$name.json" \
    ${pages:+--page "$out/$name.html"}
  results+=("$out/$name.json")
}

mesh teapot examples/Parametric_surface_mesher/data/teapot.bpt --max-edge 0.12 --gamma 0.1
# edge lengths of 5000 triangles where curvature does not ask for more
mesh fold bend --max-edge 0.0304
mesh peak peak --max-edge 0.0455
mesh hole hole --max-edge 0.0477
mesh uniform_curvature cap --max-edge 0.0320

echo "== Drawing circumellipses in the domain of a coarse peak"
"$programs/mesh_patch" peak --quiet --max-edge 0.15 --gamma 0.25 --uv-picture "$out/circumellipses.svg" --ellipses 70

cad_file=/usr/share/opencascade/data/step/linkrods.step
if [ -e "$cad_file" ] && [ -x "$programs/mesh_cad" ]; then
  echo "== Meshing $cad_file"
  "$programs/mesh_cad" "$cad_file" --out "$out/linkrods.off" --picture "$out/linkrods.$picture" --json "$out/linkrods_cad.json" \
    ${pages:+--page "$out/linkrods.html"}
fi

echo
"$programs/print_results_table" "${results[@]}"
echo
echo "Meshes (.off), pages to look at in a browser (.html), pictures (.png, .svg) and numbers (.json) are in $out/"
