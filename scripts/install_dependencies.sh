#!/usr/bin/env bash
# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Installs what is missing to build everything here, with the Debian packages, and the packages among the arguments. Asks nothing.
set -euo pipefail

packages=(
  g++ make cmake
  libcgal-dev libeigen3-dev libgmp-dev libmpfr-dev
  libboost-dev libboost-program-options-dev libboost-iostreams-dev zlib1g-dev nlohmann-json3-dev
  libgtest-dev libbenchmark-dev
  libtet1.5-dev
  libtbb-dev
  libocct-data-exchange-dev occt-misc
  pybind11-dev python3-numpy python3-dev
  libjs-three libegl-dev libgl-dev libpng-dev
  "$@"
)

if ! command -v apt-get > /dev/null || ! command -v dpkg-query > /dev/null; then
  echo "This system has no apt-get. Please install what these Debian packages contain: ${packages[*]}" >&2
  echo "Going on; cmake will say if something is missing." >&2
  exit 0
fi

missing=()
for package in "${packages[@]}"; do
  if [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2> /dev/null || true)" != installed ]; then
    missing+=("$package")
  fi
done

if [ ${#missing[@]} -eq 0 ]; then
  echo "== All packages needed are installed"
  exit 0
fi

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo > /dev/null; then
    echo "Missing packages, and neither root nor sudo to install them: ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi

echo "== Installing ${missing[*]}"
${as_root[@]+"${as_root[@]}"} apt-get update -qq
${as_root[@]+"${as_root[@]}"} env DEBIAN_FRONTEND=noninteractive \
  apt-get install -y -qq --no-install-recommends "${missing[@]}"
