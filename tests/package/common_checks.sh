#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# To be sourced. What every installation must do, in /work of a clean system, with the programs in $bin.

# What the programs of the build make, to compare with.
make_expectations()
{
    expected=$(mktemp -d)
    (
        cd "$expected"
        "$root/build/release/bin/tan" sample c60 --size 32 -o c60.nrrd
        "$root/build/release/bin/tan" build c60.nrrd -o c60.tan
        "$root/build/release/bin/tan" render c60.tan --error 1 --isovalue 140:orange --size 320x240 -o picture.png
    ) >/dev/null 2>&1
    mkdir -p "$system/work/expected"
    cp "$expected"/picture.png "$system/work/expected/"
    # A format that only VTK reads.
    cat >"$system/work/image.vti" <<'VTI'
<VTKFile type="ImageData" version="0.1" byte_order="LittleEndian"><ImageData WholeExtent="0 2 0 2 0 1" Origin="0 0 0" Spacing="1 1 1">
<Piece Extent="0 2 0 2 0 1"><PointData Scalars="a"><DataArray type="Float32" Name="a" format="ascii">
0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17</DataArray></PointData></Piece></ImageData></VTKFile>
VTI
    rm -r "$expected"
    plugins=$("$root/build/release/bin/tan" plugins --json | grep -c '"state": "loaded"')
}

# check_command_line [without_window]: the editor comes with the window.
check_command_line()
{
    local there=$plugins
    [ "${1:-}" != without_window ] || there=$((plugins - 1))
    check "all $there plugins are loaded" "[ \$('$bin/tan' plugins --json | grep -c '\"state\": \"loaded\"') = $there ]"
    check 'the manual is where Help looks for it' "test -s '$bin/../share/doc/tan/manual/index.html'"
    check 'sample, build, verify' "cd /work; '$bin/tan' sample c60 --size 32 -o c60.nrrd; '$bin/tan' build c60.nrrd -o c60.tan
        '$bin/tan' verify c60.tan --against c60.nrrd --lod 1"
    check 'the picture is that of the build, bit for bit' "cd /work
        '$bin/tan' render c60.tan --error 1 --isovalue 140:orange --size 320x240 -o picture.png; cmp picture.png expected/picture.png"
    # By the libraries that serve and that ask.
    check 'a packed model is served, and opened by its address' "cd /work; mkdir models; '$bin/tan' pack c60.tan -o models/c60.tan
        '$bin/tan' serve models --port 0 2>serve.log & server=\$!
        until address=\$(grep -o 'http://[^ ]*' serve.log); do sleep 0.1; done
        '$bin/tan' info \${address}c60.tan --json | grep -F '\"form\": \"packed\"'
        '$bin/tan' extract \${address}c60.tan --at-server --error 4 -o served.vtu
        kill -INT \$server; wait \$server; rm -r models"
}

check_vtk() { check 'a file that only VTK reads' "cd /work; '$bin/tan' info image.vti --json | grep -E '\"points\": 18'"; }

# check_window TEXT COMMAND: on a display of its own, COMMAND brings up a window with c60.tan in its title; what the screen shows then is
# kept in /work/window.xwd.
check_window()
{
    cat >"$system/work/window.sh" <<'INSIDE'
set -eu
"$@" &
# A search fails if a window goes while it looks.
find_window() { window=$(xdotool search --onlyvisible --name c60.tan 2>/dev/null | tail -n1) && [ -n "$window" ]; }
deadline=$((SECONDS + 60))
until find_window; do [ "$SECONDS" -lt "$deadline" ] || { echo 'no window came up'; exit 1; }; sleep 0.2; done
xdotool getwindowname "$window"
# The surface is of bone, as nothing else in the window is.
bone() { xwd -silent -root -out /work/window.xwd; tail -c $((1366 * 768 * 4)) /work/window.xwd | od -An -v -w4 -tu1 | awk '$3 > $1 + 15 && $3 < $1 + 45 && $2 > $1 { ++n } END { print n + 0 }'; }
until [ "$(bone)" -gt 10000 ]; do [ "$SECONDS" -lt "$deadline" ] || { echo 'no picture came'; exit 1; }; sleep 0.2; done
kill "$(xdotool getwindowpid "$window")"
wait || true
INSIDE
    check "$1" "cd /work; export XDG_RUNTIME_DIR=/tmp/runtime; mkdir -p -m 700 /tmp/runtime
        xvfb-run -a -s '-screen 0 1366x768x24' bash window.sh $2"
}
