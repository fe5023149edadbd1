# shellcheck shell=bash
# Set-up for ./dev: Debian packages, virtual environments under .env/, private libraries.
# What is set up is stamped with a hash of what was asked, so that a second run is quick.

jobs=${OROGEN_JOBS:-$(nproc)}
bpy_versions="4.2.23 4.5.15 5.0.1 5.2.3"
pure_wheels="tifffile==2026.3.3" # of Python alone, that go into the extension's zip
export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1
export PIP_DISABLE_PIP_VERSION_CHECK=1 PIP_NO_INPUT=1

compiler_packages="build-essential cmake ninja-build ccache pkg-config ca-certificates
  libcgal-dev libopenvdb-dev libtbb-dev libglm-dev libeigen3-dev nlohmann-json3-dev libgeographiclib-dev
  libblosc-dev liblz4-dev zlib1g-dev libgtest-dev libbenchmark-dev python3 python3-dev python3-venv"
bpy_packages="libgl1 libegl1 libgl1-mesa-dri libx11-6 libxi6 libxfixes3 libxrender1 libxkbcommon0
  libsm6 libice6 libxxf86vm1 libgomp1"

say() { printf '\033[1m== %s\033[0m\n' "$*"; }
fail() { printf 'dev: %s\n' "$*" >&2; exit 1; }

# quietly CMD...: shows what the command printed only if it fails.
quietly() {
  local log
  log=$(mktemp)
  if "$@" >"$log" 2>&1; then rm -f "$log"; else
    cat "$log" >&2
    rm -f "$log"
    fail "this failed: $*"
  fi
}

# once NAME WHAT CMD...: runs CMD unless it last succeeded with the same WHAT.
once() {
  local stamp=.env/stamps/$1 what
  what=$(printf '%s' "$2" | sha256sum)
  shift 2
  [ "$(cat "$stamp" 2>/dev/null)" != "$what" ] || return 0
  "$@"
  mkdir -p .env/stamps
  printf '%s\n' "$what" >"$stamp"
}

# --- Debian packages ---------------------------------------------------------------------------

as_root() {
  if [ "$(id -u)" = 0 ]; then "$@"; else sudo "$@"; fi
}

# need_packages NAME...: installs those that are missing.
need_packages() {
  local have missing
  have=$(dpkg-query -W -f='${db:Status-Abbrev} ${Package}\n' 2>/dev/null | sed -n 's/^ii *//p') || true
  missing=$(printf '%s\n' "$@" | sort -u | comm -23 - <(sort -u <<<"$have"))
  [ -n "$missing" ] || return 0
  local line
  line=$(tr '\n' ' ' <<<"$missing")
  command -v apt-get >/dev/null ||
    fail "this machine has no apt-get; what Debian calls by these names is missing: $line"
  [ "$(id -u)" = 0 ] || command -v sudo >/dev/null ||
    fail "without root or sudo nothing can be installed; ask for: apt-get install $line"
  say "Installing Debian packages: $line"
  export DEBIAN_FRONTEND=noninteractive
  quietly as_root apt-get update -q -o DPkg::Lock::Timeout=300
  # shellcheck disable=SC2086
  quietly as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends \
    -o DPkg::Lock::Timeout=300 $missing
}

need_compiler() {
  local geographic=libgeographiclib-dev
  [ "$(. /etc/os-release && echo "${VERSION_ID:-}")" != 22.04 ] || geographic=libgeographic-dev
  # shellcheck disable=SC2086
  need_packages $compiler_packages $geographic
}

# --- Python ------------------------------------------------------------------------------------

# find_python 3.11: the interpreter of that version: the system's, pyenv's, or one on the path.
find_python() {
  local candidate
  for candidate in "/usr/bin/python$1" \
    $(printf '%s\n' "$HOME/.pyenv/versions/$1".*/bin/"python$1" | sort -rV) \
    "$(command -v "python$1" || true)"; do
    [ ! -x "$candidate" ] || { echo "$candidate"; return; }
  done
  return 1
}

# blender_pythons: those of Blender's versions that this machine has.
blender_pythons() {
  local version
  for version in ${OROGEN_PYTHONS:-3.11 3.13}; do
    if find_python $version >/dev/null; then echo $version; fi
  done
}

# default_python: what ./dev build makes the module for.
default_python() {
  local versions
  versions=$(blender_pythons)
  [ -n "$versions" ] || versions=$(/usr/bin/python3 -c 'import sys; print("%d.%d" % sys.version_info[:2])')
  echo "${versions%%$'\n'*}"
}

venv_of() { echo ".env/python-$1"; }

make_venv() { # DIR VERSION
  local python
  python=$(find_python "$2") || fail "no Python $2 on this machine"
  case $python in /usr/bin/*) need_packages "python$2-dev" "python$2-venv" ;; esac
  rm -rf "$1"
  quietly "$python" -m venv "$1"
  quietly "$1/bin/python" -m pip install -q --upgrade 'pip>=25.1'
}

install_groups() { # DIR VERSION GROUP...
  local dir=$1 version=$2
  shift 2
  say "Setting up $dir ($*)"
  [ -x "$dir/bin/python" ] || make_venv "$dir" "$version"
  quietly "$dir/bin/python" -m pip install -q "${@/#/--group=}"
}

# need_groups DIR VERSION GROUP...: a virtual environment with dependency groups of pyproject.toml.
need_groups() {
  local wanted
  wanted="$* $(find_python "$2") $(sed -n '/^\[dependency-groups\]/,/^\[/p' pyproject.toml)"
  [ -x "$1/bin/python" ] || rm -f ".env/stamps/$(basename "$1")"
  once "$(basename "$1")" "$wanted" install_groups "$@"
}

need_venv() { need_groups "$(venv_of "$1")" "$1" develop; }
need_validate() { need_groups .env/validate "$(default_python)" validate; }
need_docs() { need_groups .env/docs "$(default_python)" docs; }
need_format() {
  need_compiler
  need_groups .env/format "$(default_python)" format
}

# --- Blender, as the Python package bpy ----------------------------------------------------------

bpy_python() { case $1 in 4.* | 5.0.*) echo 3.11 ;; *) echo 3.13 ;; esac; }

# need_bpy 5.0.1: its own virtual environment; false where the machine lacks its Python.
need_bpy() {
  find_python "$(bpy_python "$1")" >/dev/null || return 1
  # shellcheck disable=SC2086
  need_packages $bpy_packages
  need_groups ".env/bpy-$1" "$(bpy_python "$1")" "bpy-$1"
}

# need_demo_bpy: the newest Blender of the default Python, into demo_bpy.
need_demo_bpy() {
  for demo_bpy in $(tr ' ' '\n' <<<"$bpy_versions" | sort -rV); do
    [ "$(bpy_python "$demo_bpy")" = "$(default_python)" ] || continue
    need_bpy "$demo_bpy"
    return
  done
  return 1
}

# --- test runners --------------------------------------------------------------------------------

results=()
left_out=()
failed=0

leave_out() { left_out+=("$*"); }

# runner NAME CMD...: runs a test program and keeps its closing lines for the end.
runner() {
  local name=$1 log
  shift
  log=$(mktemp)
  say "Testing: $name"
  if "$@" 2>&1 </dev/null | tee "$log"; then results+=("passed  $name"); else
    results+=("FAILED  $name")
    failed=1
  fi
  results+=("$(grep -E '^(100|[0-9]+)% tests passed|[0-9]+ (passed|failed|skipped|error).* in [0-9.]+|^Total Test time|^wheel' "$log" |
    tail -n 3 | sed 's/^/        /')")
  rm -f "$log"
}

closing_lines() {
  say "Tests"
  printf '%s\n' "${results[@]}"
  local line
  for line in ${left_out[@]+"${left_out[@]}"}; do printf 'left out  %s\n' "$line"; done
  [ "$failed" = 0 ] || fail "some tests failed"
}

# --- wheels ----------------------------------------------------------------------------------------

# source_hash: changes with anything a wheel is made of.
source_hash() {
  git ls-files -co --exclude-standard CMakeLists.txt pyproject.toml core .ci |
    LC_ALL=C sort | xargs sha256sum | sha256sum
}

build_private_libraries() {
  say "Building static libraries for the wheels"
  quietly bash .ci/private_libraries.sh "$1"
}

# need_private_libraries DIR: oneTBB, OpenVDB and blosc as static libraries.
need_private_libraries() {
  [ -f "$1/lib/libopenvdb.a" ] || rm -f .env/stamps/private_libraries
  once private_libraries "$(cat .ci/private_libraries.sh)" build_private_libraries "$1"
}
