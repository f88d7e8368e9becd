#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# installation_test.sh BUILD FOLDER: what `cmake --install` puts into a folder works from there, wherever it is. It stays in
# "FOLDER/another place", where other tests use it.
set -euo pipefail
build=$1 scratch=$2
rm -rf "$scratch"
mkdir -p "$scratch"
place="$scratch/a place"
libraries=$(sed -n 's/^CMAKE_INSTALL_LIBDIR:[A-Z]*=//p' "$build/CMakeCache.txt")
version=$(sed -n 's/^CMAKE_PROJECT_VERSION:STATIC=//p' "$build/CMakeCache.txt")
unset TAN_PLUGIN_PATH

check() { "$@" || { echo "FAIL: $*"; exit 1; }; }
installed() { check test -e "$place/$1"; }

for component in core program window development; do
    cmake --install "$build" --prefix "$place" --component "$component" >"$scratch/files"
done
# Before 1.0 a library of another minor version is another library.
soname=so.$(cut -d. -f1,2 <<<"$version")
for file in bin/tan bin/tan-desktop "$libraries"/libtan-{core,picture}."$soname" "$libraries"/tan/libtan-{ui,plugin-host,widgets}."$soname" \
    "$libraries/tan/plugins" include/tan/base.h \
    include/tan-plugin/plugins/api/{reader,builder,renderer,writer,editor,tool}.h "$libraries/cmake/TAn/TAnConfig.cmake" share/man/man1/tan.1.gz share/man/man1/tan-desktop.1.gz \
    share/applications/org.tan.tan.desktop share/mime/packages/org.tan.tan.xml share/icons/hicolor/scalable/apps/org.tan.tan.svg; do
    installed "$file"
done
if [ -e "$build/share/doc/tan/manual" ]; then
    installed share/doc/tan/manual/index.html
    installed share/doc/tan/manual/_images/window.png
fi
# Headers of sources that are not interfaces stay at home, and so does what belongs to the VTK readers.
check test "$(ls "$place/include/tan" | tr '\n' ' ')" = \
    "base.h build.h data.h fwd.h mesh.h model.h open.h packed.h parameter.h picture.h query.h render.h tan.h transfer.h verify.h version.h view.h zones.h "
check test "$(ls "$place/include")" = "$(printf 'tan\ntan-plugin')"
check test ! -e "$place/include/tan-plugin/plugins/host"
check test ! -e "$place/$libraries/tan/plugins/tan-read-vtk"
check test ! -e "$place/$libraries/tan/plugins/tan-read-images"
check test ! -e "$place/$libraries/tan/plugins/tan-read-netcdf"
check test ! -e "$place/$libraries/tan/plugins/tan-read-hdf5"
check test ! -e "$place/$libraries/tan/plugins/tan-read-zarr"

# Every plugin of the build is there, and is found beside the program.
mv "$place" "$scratch/another place"
place="$scratch/another place"
tan() { "$place/bin/tan" "$@"; }
ids() { "$1" plugins --json | sed -n 's/.*"id": "\(.*\)",/\1/p' | sort; }
check test "$(ids "$place/bin/tan")" = "$(ids "$build/bin/tan")"
check test "$(ids "$place/bin/tan" | wc -l)" -gt 10
if tan plugins --json | grep '"state"' | grep -v '"loaded"'; then
    echo "FAIL: plugins that are not loaded"
    exit 1
fi
# None of it needs the build's own folders, and none looks into whatever folder is the current one.
for file in "$place"/bin/* "$place/$libraries"/*.so.*.* "$place/$libraries"/tan/*.so.*.* "$place/$libraries"/tan/plugins/*.so; do
    if readelf -d "$file" | grep -E 'R(UN)?PATH' | grep -F "$build"; then
        echo "FAIL: $file has a path into the build"
        exit 1
    fi
done
check "$(dirname -- "$0")/run_paths_test.sh" 20 "$place"
echo "passed"
