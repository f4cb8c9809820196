#!/usr/bin/env bash
# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Makes the Debian packages of a build directory (build/ by default), installs them in a clean root of Debian 12, and tries them there: the
# programs mesh a surface and a CAD file, and the example of the README is compiled and run. Needs root, mmdebstrap, and some minutes.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$(cd "${1:-$root/build}" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

command -v mmdebstrap > /dev/null || "$root/scripts/install_dependencies.sh" mmdebstrap
echo "== Making the packages"
(cd "$work" && cpack --config "$build/CPackConfig.cmake" -B "$work/packages" > cpack.log) || { cat "$work/cpack.log"; exit 1; }

echo "== Making a clean root"
mmdebstrap --quiet --variant=minbase --include=g++,cmake,make,pkg-config bookworm "$work/root"
mkdir "$work/root/packages" "$work/root/hill"
cp "$work"/packages/*.deb "$work/root/packages/"

# The blocks of the README: the project, and hill.cpp.
awk '/^```cmake$/ {f = "CMakeLists.txt"; next} /^```cpp$/ && !done {f = "hill.cpp"; done = 1; next} /^```$/ {f = ""} f {print > (dir "/" f)}' \
  dir="$work/root/hill" "$root/README.md"

echo "== Installing"
chroot "$work/root" sh -c 'apt-get update -qq && DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends /packages/*.deb \
  libgmp-dev libmpfr-dev' > "$work/install.log" 2>&1 || { tail -20 "$work/install.log"; exit 1; }

echo "== Trying"
chroot "$work/root" mesh_patch peak --max-edge 0.1 --out /peak.off
chroot "$work/root" sh -c 'cd /hill && cmake -S . -B b -DCMAKE_BUILD_TYPE=Release > /dev/null && cmake --build b > /dev/null && b/hill'
chroot "$work/root" sh -c 'g++ -std=c++17 -O1 /hill/hill.cpp $(pkg-config --cflags --libs parametric_surface_mesher) -o /hill/hill && /hill/hill'
if [ -x "$work/root/usr/bin/mesh_cad" ]; then
  chroot "$work/root" sh -c 'DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends occt-misc' > "$work/install.log" 2>&1
  chroot "$work/root" mesh_cad /usr/share/opencascade/data/step/linkrods.step --out /linkrods.msh
fi
echo "== The packages work"
