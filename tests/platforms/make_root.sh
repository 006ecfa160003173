#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT

# usage: make_root.sh PLATFORM, one of cmake/toolchains/, such as aarch64-linux-gnu
#
# Fills build/platforms/PLATFORM/root with what Hardball and its tests need for another machine. Headers are those of
# this system's packages; zstd, GoogleTest and cpp-httplib come from their source packages in Debian's archive, and are
# compiled with the platform's tool chain. Does nothing if that was done before.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

platform=$1
project=$PWD
folder=build/platforms/$platform
root=$folder/root
sources=$PWD/build/platforms/sources
toolchain=$PWD/cmake/toolchains/$platform.cmake
[[ -f $toolchain ]] || { echo "make_root.sh: there is no $toolchain" >&2; exit 1; }
if [[ -f $root/complete && $root/complete -nt tests/platforms/make_root.sh ]]; then
  exit 0
fi
rm -rf "$folder"
mkdir -p "$root/include" "$root/lib/pkgconfig" "$root/share/cmake" "$root/lib/cmake/fmt"

# fetch_source PACKAGE: unpacks a source package into build/platforms/sources/PACKAGE. Its lists are apart from the system's.
fetch_source() {
  local package=$1 apt=$project/build/platforms/apt codename
  [[ ! -d $sources/$package ]] || return 0
  codename=$(. /etc/os-release && echo "$VERSION_CODENAME")
  mkdir -p "$apt/lists/partial" "$apt/cache/archives/partial" "$sources"
  echo "deb-src [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] http://deb.debian.org/debian $codename main" \
    >"$apt/sources.list"
  local options=(-q -o Dir::Etc::SourceList="$apt/sources.list" -o Dir::Etc::SourceParts=- -o Dir::State::Lists="$apt/lists"
    -o Dir::Cache="$apt/cache" -o APT::Sandbox::User=root)
  apt-get "${options[@]}" update
  (cd "$apt" && apt-get "${options[@]}" source --download-only "$package")
  dpkg-source --no-check -x "$apt/${package}"_*.dsc "$sources/$package.new"
  mv "$sources/$package.new" "$sources/$package"
}

# build_with_cmake SOURCE NAME OPTION...: compiles a library and installs it into the root.
build_with_cmake() {
  local source=$1 name=$2
  cmake -S "$source" -B "$folder/$name" -G Ninja -DCMAKE_TOOLCHAIN_FILE="$toolchain" -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_INSTALL_PREFIX="$project/$root" -DCMAKE_INSTALL_LIBDIR=lib -DCMAKE_CXX_FLAGS_RELEASE=-O1 \
    -DCMAKE_C_FLAGS_RELEASE=-O2 "${@:3}"
  cmake --build "$folder/$name" --target install
}

fetch_source libzstd
fetch_source cpp-httplib

# Headers alone.
for header in xxhash.h nlohmann toml++ CLI boost fmt; do
  cp -r "/usr/include/$header" "$root/include/"
done
for package in nlohmann_json CLI11; do
  cp -r /usr/share/cmake/$package "$root/share/cmake/"
done
cat >"$root/lib/cmake/fmt/fmt-config.cmake" <<'TEXT'
add_library(fmt::fmt INTERFACE IMPORTED)
target_include_directories(fmt::fmt INTERFACE ${CMAKE_CURRENT_LIST_DIR}/../../../include)
target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY=1)
TEXT
cp "$sources/cpp-httplib/httplib.h" "$root/include/"
cat >"$root/lib/pkgconfig/cpp-httplib.pc" <<TEXT
Name: cpp-httplib
Description: A header
Version: 0
Cflags: -I$project/$root/include
TEXT

# The files in assembly are of other systems.
build_with_cmake "$sources/libzstd/build/cmake" zstd -DZSTD_BUILD_PROGRAMS=OFF -DZSTD_BUILD_SHARED=OFF \
  -DZSTD_MULTITHREAD_SUPPORT=OFF -DZSTD_LEGACY_SUPPORT=OFF -DCMAKE_C_FLAGS=-DZSTD_DISABLE_ASM
build_with_cmake /usr/src/googletest googletest
touch "$root/complete"
