#!/bin/bash
# make_wheel.sh ROOT: the project's wheel for the Python of ROOT's Blender, built inside ROOT, into ROOT/wheel.
# It uses the root's shared libraries and so is good for that root alone. Needs root; the first time about 10 minutes.
set -euo pipefail
root=$(readlink -f "$1")
cd "$(dirname "$0")/../.."
source .ci/setup.sh
tools="$compiler_packages python3-pip python3-scikit-build-core"
inside() { chroot "$root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }
if [ ! -x "$root/usr/bin/ccache" ]; then
  inside apt-get update -q >/dev/null
  # shellcheck disable=SC2086
  inside apt-get install -y -q --no-install-recommends $tools >"$root/install.log" 2>&1
  inside apt-get clean; rm -rf "$root"/var/lib/apt/lists/*
fi
mkdir -p "$root/orogen"; rm -rf "$root"/orogen/{core,pybind11} "$root/wheel"
git ls-files -z -co --exclude-standard CMakeLists.txt pyproject.toml README.md LICENSE core | tar -c --null -T - | tar -x -C "$root/orogen"
# pybind11 of the host's environment: headers alone, and newer than trixie's.
need_venv "$(default_python)"
cp -r "$("$(venv_of "$(default_python)")/bin/python" -m pybind11 --cmakedir)/../../.." "$root/orogen/pybind11"
inside env -C /orogen CMAKE_BUILD_PARALLEL_LEVEL="$jobs" python3 -m pip wheel . -q --no-deps --no-index --no-build-isolation -w /wheel \
  -C cmake.define.pybind11_DIR=/orogen/pybind11/share/cmake/pybind11
