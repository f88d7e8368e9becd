#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Proves that the parts of TAn can be left out (docs/developer/dependencies.md): builds the library alone, as on a machine without Qt and without all
# that is optional, installs it and builds a program of others with it; then `tan` without Qt, OpenGL, the network and CGAL, and
# looks whether it says so where they are asked for.
#   packaging/try_parts.sh [FOLDER [JOBS]]     FOLDER: default /var/tmp/tan-parts
set -euo pipefail

repository=$(cd -- "$(dirname -- "$0")/.." && pwd)
folder=${1:-/var/tmp/tan-parts}
jobs=${2:-$(nproc)}
less=(-DTAN_GL=OFF -DTAN_NETWORK=OFF -DTAN_CGAL=OFF)
# Not optimised: it is about what is compiled, not about how fast it runs.
common=(-G Ninja -S "$repository" -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O0 -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=16 -DTAN_WERROR=ON)
mkdir -p "$folder"
cd -- "$folder"

check() { "$@" || { echo "FAIL: $*"; exit 1; }; }

# says WORDS COMMAND...: the command fails, and says why in words with these among them.
says()
{
    local words=$1
    shift
    if "$@" >said 2>&1; then
        echo "FAIL: this works: $*"
        exit 1
    fi
    grep -qF -- "$words" said || { echo "FAIL: $* does not say '$words':"; cat said; exit 1; }
    echo "passed: '$*' says '$(tail -n 1 said)'"
}

echo '== the library alone'
without=()
for package in Qt6 OpenGL CURL CGAL ZLIB; do
    without+=("-DCMAKE_DISABLE_FIND_PACKAGE_$package=ON")
done
cmake "${common[@]}" -B library "${without[@]}" "${less[@]}" -DTAN_PROGRAMS=OFF -DCMAKE_INSTALL_LIBDIR=lib64 >configured
nice ninja -C library -j "$jobs" tan-core
rm -rf installed
for component in core development; do
    cmake --install library --prefix "$folder/installed" --component "$component" >messages
done
check test -e installed/lib64/libtan-core.so
check test "$(find installed -name '*.so*' | wc -l)" = 3
if readelf -d installed/lib64/libtan-core.so | grep -E 'Qt|EGL|curl|gmp|mpfr'; then
    echo 'FAIL: the library is linked with what was left out'
    exit 1
fi
cmake -G Ninja -S "$repository/examples/library" -B examples -DCMAKE_PREFIX_PATH="$folder/installed" -DCMAKE_DISABLE_FIND_PACKAGE_Qt6=ON >messages
cmake --build examples >messages
cmake --install examples --prefix "$folder/programs" >messages
check programs/bin/build_from_array wells.tan
check programs/bin/query_at_accuracy wells.tan 1
check programs/bin/picture_to_file wells.tan 1 wells.ppm
# Who asks for plugins is told that there are none.
printf 'cmake_minimum_required(VERSION 3.25)\nproject(Asks LANGUAGES CXX)\nfind_package(TAn REQUIRED COMPONENTS plugin)\n' >CMakeLists.txt
says plugin cmake -S . -B asks -DCMAKE_PREFIX_PATH="$folder/installed"
check cmake --install library --prefix "$folder/whole" >messages

echo '== tan without Qt, OpenGL, the network and CGAL'
cmake "${common[@]}" -B command_line -DCMAKE_DISABLE_FIND_PACKAGE_{OpenGL,CURL,CGAL,Qt6}=ON "${less[@]}" -DTAN_WINDOW=OFF >configured
nice ninja -C command_line -j "$jobs" tan plugins
tan() { command_line/bin/tan "$@"; }
check tan sample c60 --size 16 -o c60.nrrd
check tan build c60.nrrd -o c60.tan
check tan verify c60.tan --against c60.nrrd
check tan render c60.tan --isovalue 140 --size 64x48 --title C60 -o c60.png
says TAN_SERVER command_line/bin/tan serve .
says TAN_GL command_line/bin/tan render c60.tan --isovalue 140 --size 64x48 --backend gl -o gl.png
says TAN_NETWORK command_line/bin/tan info http://name:secret@127.0.0.1:1/c60.tan
check test "$(grep -c secret said)" = 0
says TAN_NETWORK command_line/bin/tan extract http://127.0.0.1:1/c60.tan --at-server --error 1 -o far.vtu
check tan sample scattered --size 8 -o points.csv
says TAN_CGAL command_line/bin/tan build points.csv -o points.tan
says TAN_CGAL command_line/bin/tan build points.csv --builder decimation -o points.tan
says TAN_CGAL command_line/bin/tan reproduce --tables 4 --data . -o tables
says tan-desktop command_line/bin/tan c60.tan
check cmake --install command_line --prefix "$folder/whole" >messages
check test ! -e whole/bin/tan-desktop
if ldd whole/bin/tan | grep libQt; then
    echo 'FAIL: tan needs Qt'
    exit 1
fi
check whole/bin/tan info c60.tan >messages
echo passed
