#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# installed_examples_test.sh INSTALLED EXAMPLES: the programs and plugins of examples/, built in EXAMPLES with what is installed
# (tests/docs/build_examples.py), work with the installed program.
set -euo pipefail
place=$1 examples=$2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"

check() { "$@" || { echo "FAIL: $*"; exit 1; }; }
tan() { "$place/bin/tan" "$@"; }

check "$examples"/my-programs/build/build_from_array wells.tan 2>messages
check tan info wells.tan >messages
check grep -q 'tetrahedra in the window' <("$examples"/my-programs/build/query_at_accuracy wells.tan 1)
check "$examples"/my-programs/build/isosurface_to_file wells.tan 1 -0.5 surface.obj >messages
check test "$(grep -c '^f ' surface.obj)" = "$(sed 's/ .*//' messages)"
check "$examples"/my-programs/build/picture_to_file wells.tan 1 picture.ppm
check test "$(head -c 15 picture.ppm)" = "P6 1024 768 255"
check test "$("$examples"/my-programs/build/query_at_accuracy none.tan 1 2>&1 | grep -c none.tan)" = 1
# Installed, the programs find the library as well.
cmake --install "$examples"/my-programs/build --prefix "$scratch/installed" >messages
check test "$(ls "$scratch/installed/bin" | wc -l)" = 5
check "$scratch/installed/bin/query_at_accuracy" wells.tan 1 >messages
check "$(dirname -- "$0")/run_paths_test.sh" 10 "$scratch/installed" "$examples"/my-programs/build >messages
for program in picture_to_file view_to_picture; do
    if ldd "$examples"/my-programs/build/$program | grep -i libqt; then
        echo "FAIL: a program of the library is linked with Qt"
        exit 1
    fi
done
# The picture of a view is the one that `tan render` makes of the same session.
check "$examples"/my-programs/build/view_to_picture wells.tan view
check tan render view.tansession -o rendered.png >messages
check cmp view.png rendered.png
check test "$(stat -c %s view.png)" -gt 20000

export TAN_PLUGIN_PATH="$examples"/my-reader/build
tan plugins --json | grep -A5 '"id": "example.grid-text"' | grep '"state": "loaded"' >/dev/null || { tan plugins; exit 1; }
echo "2 2 3  0 1 2 3  4 5 6 7  8 9 10 11" >cube.grid
tan build cube.grid -o cube.tan 2>messages
tan verify cube.tan --against cube.grid --lod 0 --json | grep '"ok": true' >/dev/null
echo "2 2 3  0 1 2 3  4 5 6 seven  8 9 10 11" >bad.grid
check test "$(tan info bad.grid 2>&1 | grep -c 'is not a number')" = 1
# A file of its format is written by every command that writes surfaces.
export TAN_PLUGIN_PATH="$examples"/my-writer/build
tan isosurface wells.tan --value -0.5 -o surface.off >messages
check test "$(sed -n 2p surface.off)" = "$(sed -n 's/.*: \([0-9]*\) vertices, \([0-9]*\) triangles.*/\1 \2 0/p' messages)"
tan extract wells.tan --error 1 -o boundary.off >messages
check test "$(grep -c '^3 ' boundary.off)" -gt 10
check grep -q boundary messages
check test "$(tan isosurface wells.tan --value -0.5 -o surface.of 2>&1 | grep -c '\.obj, \.off, \.ply')" = 1

# A renderer of somebody else: by its options, and refused with a sentence.
export TAN_PLUGIN_PATH="$examples"/my-renderer/build
tan render wells.tan --mode example.shells --shells 3 --band '{"low": -1, "high": 0}' --size 64x48 -o shells.png --json >shells.json
check test "$(head -c 4 shells.png | tail -c 3)" = PNG
check grep -q '"triangles": [1-9]' shells.json
check test "$(tan render wells.tan --mode example.shells --shells 99 -o none.png 2>&1 | grep -c shells)" = 1
check test "$(tan render wells.tan --mode example.shells --band narrow -o none.png 2>&1 | grep -c 'A band is written')" = 1
check test ! -e none.png
for backend in cpu gl; do
    TAN_PLUGIN_PATH="$examples"/my-slice/build \
        tan render wells.tan --mode example.slice --height 40 --size 64x48 --backend $backend -o slice.png \
        --json >slice.json 2>messages || grep -q OpenGL messages
done
check grep -q '"triangles": [1-9]' slice.json
for backend in gl cpu; do
    TAN_PLUGIN_PATH="$examples"/my-projection/build \
        tan render wells.tan --mode example.projection --size 64x48 --backend $backend -o maximum.png \
        --json >maximum.json 2>messages || grep -qE 'EGL|needs 3.3' messages
done
check test "$(head -c 4 maximum.png | tail -c 3)" = PNG
check grep -q '"cells_drawn": [1-9]' maximum.json

# A builder: of what it takes, within its budget, with what it claims proved; what it does not take it says.
export TAN_PLUGIN_PATH="$examples"/my-builder/build
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
unset TAN_PLUGIN_PATH
export XDG_DATA_HOME=$scratch/data
mkdir -p "$XDG_DATA_HOME/tan/plugins"
cp "$examples"/plugins/libband-editor.so "$XDG_DATA_HOME/tan/plugins"
tan plugins --json | grep -A5 '"id": "example.band-editor"' | grep '"state": "loaded"' >/dev/null || { tan plugins; exit 1; }
check grep -qF "$XDG_DATA_HOME/tan/plugins" <(tan plugins)

# A plugin of another build is refused, with both builds and the remedy; one that was tampered with as damaged.
version=$(sed -n 's/^#define TAN_VERSION "\(.*\)"/\1/p' "$place/include/tan/version.h")
plugin=$XDG_DATA_HOME/tan/plugins/libband-editor.so
sed -i "s|/tan-${version//./\\.}|/tan-0.0.9|" "$plugin"
tan plugins >messages
check grep -q "It is not a plugin, or is damaged" messages
python3 - "$plugin" <<'END'
import struct, sys, zlib
content = bytearray(open(sys.argv[1], "rb").read())
start = content.index(b"TAn\0TAnPlug1") + 12
size, = struct.unpack_from("=I", content, start)
struct.pack_into("=I", content, start + 4, zlib.crc32(content[start + 8:start + 8 + size]))
open(sys.argv[1], "wb").write(content)
END
tan plugins >messages
check grep -q "tan-0.0.9.*tan-$version.*Rebuild" messages
echo "passed"
