#!/usr/bin/env bash
# private_libraries.sh PREFIX: oneTBB, blosc and OpenVDB as static libraries for the wheel.
#
# The wheel is loaded into Blender, which brings a TBB and an OpenVDB of its own; only private copies
# are safe from those. They are built from Debian's (or Ubuntu's) source packages, fetched with a
# private apt configuration: nothing of the machine's own is changed. They are of the same version as
# the packaged headers, so that all rooms compile to the same objects with and without them.
set -euo pipefail
prefix=$1
work=$prefix/work
jobs=${OROGEN_JOBS:-$(nproc)}
codename=$(. /etc/os-release && echo "$VERSION_CODENAME")
mkdir -p "$work/lists/partial" "$work/sources"

# The machine's own lines for this release, asked for sources instead of packages.
private_sources() {
  local file
  : >"$work/orogen.list"
  for file in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
    [ ! -f "$file" ] || sed -nE "s/^deb (.* $codename(-updates|-security)? .*)/deb-src \1/p" "$file" >>"$work/orogen.list"
  done
  for file in /etc/apt/sources.list.d/*.sources; do
    [ ! -f "$file" ] ||
      awk -v RS= -v ORS='\n\n' -v suite="$codename" '$0 ~ "Suites:[^\n]*[ ]" suite "([ \n-]|$)"' "$file" |
      sed -E 's/^Types:.*/Types: deb-src/' >>"$work/orogen.sources"
  done
}

apt_private() {
  "$@" -o Dir::Etc::sourcelist=/dev/null -o Dir::Etc::sourceparts="$work/apt" \
    -o Dir::State::lists="$work/lists" -o Dir::Cache="$work" -o APT::Sandbox::User=root
}

fetch() {
  rm -rf "$work/apt" "$work"/orogen.*
  private_sources
  mkdir -p "$work/apt"
  find "$work" -maxdepth 1 -name 'orogen.*' -size +0 -exec mv {} "$work/apt/" \;
  apt_private apt-get -q update
  (cd "$work/sources" && rm -rf ./* &&
    apt_private apt-get -q source --download-only --tar-only openvdb onetbb c-blosc)
}

# static NAME OPTION...: unpacks and builds one library, and installs it into the prefix.
static() {
  local name=$1
  shift
  rm -rf "${work:?}/$name"
  mkdir "$work/$name"
  tar -xf "$work"/sources/"$name"_*.orig.tar.* -C "$work/$name" --strip-components=1
  # openvdb.cc registers every grid type: minutes of compiling for what we register by name.
  [ "$name" != openvdb ] || sed -i '/^ *openvdb\.cc$/d' "$work/openvdb/openvdb/openvdb/CMakeLists.txt"
  cmake -S "$work/$name" -B "$work/$name-build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_INSTALL_PREFIX="$prefix" -DCMAKE_INSTALL_LIBDIR=lib -DCMAKE_POLICY_VERSION_MINIMUM=3.5 \
    -DBUILD_SHARED_LIBS=OFF -DCMAKE_POSITION_INDEPENDENT_CODE=ON -DCMAKE_CXX_VISIBILITY_PRESET=hidden \
    -DCMAKE_C_COMPILER_LAUNCHER=ccache -DCMAKE_CXX_COMPILER_LAUNCHER=ccache "$@"
  cmake --build "$work/$name-build" -j "$jobs"
  cmake --install "$work/$name-build"
}

fetch
static onetbb -DTBB_TEST=OFF -DTBBMALLOC_BUILD=OFF -DTBB_STRICT=OFF
static c-blosc -DBUILD_STATIC=ON -DBUILD_SHARED=OFF -DBUILD_TESTS=OFF -DBUILD_FUZZERS=OFF \
  -DBUILD_BENCHMARKS=OFF -DDEACTIVATE_SNAPPY=ON -DDEACTIVATE_ZSTD=ON -DPREFER_EXTERNAL_LZ4=ON \
  -DPREFER_EXTERNAL_ZLIB=ON

static openvdb -DOPENVDB_CORE_STATIC=ON -DOPENVDB_CORE_SHARED=OFF \
  -DOPENVDB_BUILD_BINARIES=OFF -DOPENVDB_BUILD_VDB_PRINT=OFF -DUSE_IMATH_HALF=OFF \
  -DUSE_EXPLICIT_INSTANTIATION=OFF -DOPENVDB_USE_DELAYED_LOADING=OFF -DUSE_CCACHE=OFF

# The rooms use the packaged headers of the same version (see above); only OpenVDB's differ.
find "$prefix/include" -mindepth 1 -maxdepth 1 ! -name openvdb -exec rm -r {} +
cp "$(find /usr/lib -name liblz4.a | head -n 1)" "$(find /usr/lib -name libz.a | head -n 1)" "$prefix/lib/"
rm -rf "$work"
