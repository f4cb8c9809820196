#!/usr/bin/env bash
# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Makes the Debian packages of a build directory (build/ by default, where mesh_patch, and mesh_cad and the Python module if wanted, were
# built), installs them in a clean root of Debian 12, and tries them there: programs and module mesh a surface and a CAD file, the program
# of the README is compiled with CMake and with pkg-config, and the examples by themselves. Needs root, mmdebstrap, 1 GB and some minutes.
#
#   scripts/check_packages.sh [build directory]
#
# APT_OPTIONS, if set, is a file of apt's options for the clean root, for instance those of a proxy.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${1:-$root/build}
if [ ! -e "$build/CPackConfig.cmake" ]; then
  echo "$build is no build directory; configure and build one first: cmake -S . -B $build && cmake --build $build --target mesh_patch" >&2
  exit 2
fi
if [ "$(id -u)" -ne 0 ]; then
  echo "The packages are tried in a clean root, which only root can enter; start this script as root." >&2
  exit 2
fi
build=$(cd "$build" && pwd)
work=$(mktemp -d)
clean_root=$work/root
trap 'umount "$clean_root/proc" 2> /dev/null || true; rm -rf --one-file-system "$work"' EXIT

# quietly COMMAND...: shows what it prints if it fails
quietly() {
  "$@" > "$work/log" 2>&1 || { tail -40 "$work/log"; exit 1; }
}

# inside COMMAND...: in the clean root
inside() {
  chroot "$clean_root" env DEBIAN_FRONTEND=noninteractive "$@"
}

"$root/scripts/install_dependencies.sh" mmdebstrap file dpkg-dev
echo "== Making the packages"
quietly cpack --config "$build/CPackConfig.cmake" -B "$work/packages"
rm -rf "$work/packages/_CPack_Packages"
(cd "$work/packages" && ls -- *.deb)

echo "== Making a clean root"
quietly mmdebstrap --variant=minbase ${APT_OPTIONS:+"--aptopt=$APT_OPTIONS"} bookworm "$clean_root"
mount -t proc proc "$clean_root/proc"
mv "$work/packages" "$clean_root/packages"

echo "== Installing"
quietly inside apt-get update -qq
quietly inside sh -c 'apt-get install -y -qq --no-install-recommends /packages/*.deb'

echo "== Trying the programs"
inside mesh_patch peak --max-edge 0.1 --out /peak.off
if inside sh -c 'command -v mesh_cad' > /dev/null; then
  quietly inside apt-get install -y -qq --no-install-recommends occt-misc
  inside mesh_cad /usr/share/opencascade/data/step/linkrods.step --out /linkrods.msh
fi

if inside dpkg-query -W python3-parametric-surface-mesher > /dev/null 2>&1; then
  echo "== Trying the module"
  inside python3 -c '
import os
import parametric_surface_mesher as psm

hill = psm.mesh_surface("u, v, exp(-5*(u*u + v*v))", ((-1, 1), (-1, 1)), max_edge=0.1)
assert hill.angles().min() > 30
print(hill)
rods = "/usr/share/opencascade/data/step/linkrods.step"
if os.path.exists(rods):
    part = psm.mesh_cad(rods)
    part.save("/linkrods_of_python.msh")
    print(part)'
fi

echo "== Trying the headers"
quietly inside apt-get install -y -qq --no-install-recommends g++ cmake make pkg-config nlohmann-json3-dev
# The blocks of the README: the project, and hill.cpp.
mkdir "$clean_root/hill"
awk '/^```cmake$/ {f = "CMakeLists.txt"; next} /^```cpp$/ && !done {f = "hill.cpp"; done = 1; next} /^```$/ {f = ""} f {print > (dir "/" f)}' \
  dir="$clean_root/hill" "$root/README.md"
quietly inside cmake -S /hill -B /hill/build -DCMAKE_BUILD_TYPE=Release
quietly inside cmake --build /hill/build
inside /hill/build/hill
inside sh -c 'g++ -std=c++17 -O1 /hill/hill.cpp $(pkg-config --cflags --libs parametric_surface_mesher) -o /hill/hill && /hill/hill'
quietly inside cmake -S /usr/share/doc/Parametric_surface_mesher/examples/Parametric_surface_mesher -B /examples
quietly inside cmake --build /examples --target mesh_own_formula
inside /examples/mesh_own_formula
if inside sh -c 'command -v mesh_cad' > /dev/null; then
  quietly inside apt-get install -y -qq --no-install-recommends libocct-data-exchange-dev
  quietly inside cmake -S /usr/share/doc/Parametric_surface_mesher/examples/Parametric_surface_mesher -B /examples
  quietly inside cmake --build /examples --target mesh_cad_shape
  inside /examples/mesh_cad_shape /drilled_box.msh
fi
echo "== The packages work"
