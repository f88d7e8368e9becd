#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# installation_test.sh SOURCE BUILD COMPILER: what `cmake --install` puts into a folder works from there, wherever it is, and the
# examples of plugins outside of the tree are built with the installed headers, loaded and used.
set -euo pipefail
source=$1 build=$2 compiler=$3
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
place="$scratch/a place"
unset TAN_PLUGIN_PATH

check() { "$@" || { echo "FAIL: $*"; exit 1; }; }
installed() { check test -e "$place/$1"; }

for component in core program development; do
    cmake --install "$build" --prefix "$place" --component "$component" >"$scratch/files"
done
for file in bin/tan bin/tan-desktop lib/tan/libtan-ui.so.0 lib/tan/plugins include/tan/base.h \
    include/tan-plugin/plugins/api/{reader,builder,renderer,writer,editor}.h lib/cmake/TAn/TAnConfig.cmake share/man/man1/tan.1.gz share/man/man1/tan-desktop.1.gz \
    share/applications/org.tan.TAn.desktop share/mime/packages/org.tan.TAn.xml share/icons/hicolor/scalable/apps/org.tan.TAn.svg; do
    installed "$file"
done
if [ -e "$build/share/doc/tan/manual" ]; then
    installed share/doc/tan/manual/index.html
    installed share/doc/tan/manual/_images/window.png
fi
# Headers of sources that are not interfaces stay at home, and so does what belongs to the VTK readers.
check test "$(ls "$place/include/tan" | tr '\n' ' ')" = \
    "base.h build.h data.h mesh.h model.h query.h render.h transfer.h verify.h "
check test "$(ls "$place/include")" = "$(printf 'tan\ntan-plugin')"
check test ! -e "$place/include/tan-plugin/plugins/host"
check test ! -e "$place/lib/tan/plugins/tan-read-vtk"

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
# None of it needs the build's own folders.
for file in "$place"/bin/* "$place"/lib/tan/*.so.*.* "$place"/lib/tan/plugins/*.so; do
    if readelf -d "$file" | grep -E 'R(UN)?PATH' | grep -F "$build"; then
        echo "FAIL: $file has a path into the build"
        exit 1
    fi
done

# build_example NAME OPTION...: a folder of $source/examples against the installation, into $scratch/NAME.
build_example()
{
    local name=$1
    shift
    cmake -S "$source/examples/$name" -B "$scratch/$name" -DCMAKE_PREFIX_PATH="$place" -DCMAKE_CXX_COMPILER="$compiler" \
        -DCMAKE_BUILD_TYPE=Release "$@" >"$scratch/log" 2>&1 || { cat "$scratch/log"; exit 1; }
    cmake --build "$scratch/$name" >"$scratch/log" 2>&1 || { cat "$scratch/log"; exit 1; }
}

# The library alone, as on a machine without Qt.
build_example library -DCMAKE_DISABLE_FIND_PACKAGE_Qt6=ON
cd "$scratch"
check library/build_from_array wells.tan 2>messages
check tan info wells.tan >messages
check grep -q 'tetrahedra in the window' <(library/query_at_accuracy wells.tan 1)
check library/isosurface_to_file wells.tan 1 -0.5 surface.obj >messages
check test "$(grep -c '^f ' surface.obj)" = "$(sed 's/ .*//' messages)"
check library/picture_to_file wells.tan 1 picture.ppm
check test "$(head -c 15 picture.ppm)" = "P6 1024 768 255"
check test "$(library/query_at_accuracy none.tan 1 2>&1 | grep -c none.tan)" = 1
if readelf -d library/picture_to_file | grep -i qt; then
    echo "FAIL: a program of the library alone is linked with Qt"
    exit 1
fi

build_example reader
export TAN_PLUGIN_PATH=$scratch/reader
tan plugins --json | grep -A5 '"id": "example.grid-text"' | grep '"state": "loaded"' >/dev/null || { tan plugins; exit 1; }
echo "2 2 3  0 1 2 3  4 5 6 7  8 9 10 11" >cube.grid
tan build cube.grid -o cube.tan 2>messages
tan verify cube.tan --against cube.grid --lod 0 --json | grep '"ok": true' >/dev/null
echo "2 2 3  0 1 2 3  4 5 6 seven  8 9 10 11" >bad.grid
check test "$(tan info bad.grid 2>&1 | grep -c 'is no number')" = 1
# A file of its format is written by every command that writes surfaces.
build_example writer
export TAN_PLUGIN_PATH=$scratch/writer
tan isosurface wells.tan --value -0.5 -o surface.off >messages
check test "$(sed -n 2p surface.off)" = "$(sed 's/.*: \([0-9]*\) vertices, \([0-9]*\) triangles.*/\1 \2 0/' messages)"
tan extract wells.tan --error 1 -o boundary.off >messages
check test "$(grep -c '^3 ' boundary.off)" -gt 10
check grep -q boundary messages
check test "$(tan isosurface wells.tan --value -0.5 -o surface.of 2>&1 | grep -c '\.obj, \.off, \.ply')" = 1

# A renderer of somebody else: by its options, and refused with a sentence.
build_example renderer
export TAN_PLUGIN_PATH=$scratch/renderer
tan render wells.tan --mode example.shells --shells 3 --band '{"low": -1, "high": 0}' --size 64x48 -o shells.png --json >shells.json
check test "$(head -c 4 shells.png | tail -c 3)" = PNG
check grep -q '"triangles": [1-9]' shells.json
check test "$(tan render wells.tan --mode example.shells --shells 99 -o none.png 2>&1 | grep -c shells)" = 1
check test "$(tan render wells.tan --mode example.shells --band narrow -o none.png 2>&1 | grep -c 'A band is written')" = 1
check test ! -e none.png
build_example slice
for backend in cpu gl; do
    TAN_PLUGIN_PATH=$scratch/slice tan render wells.tan --mode example.slice --height 40 --size 64x48 --backend $backend -o slice.png \
        --json >slice.json 2>messages || grep -q OpenGL messages
done
check grep -q '"triangles": [1-9]' slice.json
build_example projection
for backend in gl cpu; do
    TAN_PLUGIN_PATH=$scratch/projection tan render wells.tan --mode example.projection --size 64x48 --backend $backend -o maximum.png \
        --json >maximum.json 2>messages || grep -qE 'EGL|needs 3.3' messages
done
check test "$(head -c 4 maximum.png | tail -c 3)" = PNG
check grep -q '"cells_drawn": [1-9]' maximum.json

# A builder: of what it takes, within its budget, with what it claims proved; what it does not take it says.
build_example builder
export TAN_PLUGIN_PATH=$scratch/builder
tan sample c60 --size 20 -o c60.nrrd >messages
tan sample scattered --size 12 -o ball.csv >messages
for data in c60.nrrd ball.csv; do
    tan build $data --builder example.budget --points 500 -o budget.tan --json >budget.json
    check grep -q '"builder": "example.budget"' budget.json
    check test "$(sed -n 's/.*"sites": \([0-9]*\).*/\1/p' budget.json)" -le 500
    check test "$(sed -n 's/.*"sites": \([0-9]*\).*/\1/p' budget.json)" -gt 100
    check tan verify budget.tan --against $data --json >verdict.json
    check grep -q '"ok": true' verdict.json
    check tan info budget.tan --json >info.json
    check grep -q 'example.budget' info.json
done
tan build c60.nrrd --builder example.budget --points 8000 --error 5 -o coarse.tan 2>messages >coarse.json --json
tan build c60.nrrd --error 5 -o same.tan 2>messages >same.json --json
check test "$(grep '"sites"' coarse.json)" = "$(grep '"sites"' same.json)"
check test "$(tan build c60.nrrd --builder example.budget --points 7 -o none.tan 2>&1 | grep -c points)" = 1
tan sample bent-duct --size 8 -o duct.xyz >messages
check test "$(tan build duct.xyz --builder example.budget -o none.tan 2>&1 | grep -c 'takes regular lattices')" = 1
check test ! -e none.tan

# An editor, from the user's own folder.
build_example editor
unset TAN_PLUGIN_PATH
export XDG_DATA_HOME=$scratch/data
mkdir -p "$XDG_DATA_HOME/tan/plugins"
cp editor/libband-editor.so "$XDG_DATA_HOME/tan/plugins"
tan plugins --json | grep -A5 '"id": "example.band-editor"' | grep '"state": "loaded"' >/dev/null || { tan plugins; exit 1; }
check grep -qF "$XDG_DATA_HOME/tan/plugins" <(tan plugins)

# All of them in the window, and by both back ends: the tests of this tree, with the plugins that were built outside of it.
mkdir outside home
cp {builder,editor,projection,reader,renderer,slice,writer}/lib*.so outside
for test in window pictures; do
    TAN_EXAMPLE_PLUGINS=$scratch/outside QT_QPA_PLATFORM=offscreen HOME=$scratch/home XDG_CONFIG_HOME=$scratch/home/config \
        XDG_CACHE_HOME=$scratch/home/cache XDG_DATA_HOME=$scratch/home/data \
        "$build/tests/tests-examples" $test >messages 2>&1 || { cat messages; exit 1; }
done

# A plugin of another build is refused, with both builds and the remedy.
sed -i 's|/tan-0\.1\.0|/tan-0.0.9|' "$XDG_DATA_HOME/tan/plugins/libband-editor.so"
tan plugins >messages
check grep -q 'tan-0.0.9.*tan-0.1.0.*Rebuild' messages
echo "passed"
