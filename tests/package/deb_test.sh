#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# deb_test.sh FOLDER: the Debian packages of FOLDER in a Debian with nothing installed.
set -euo pipefail
root=$(cd -- "$(dirname -- "$0")/../.." && pwd)
. "$root/tests/package/clean_debian.sh"
. "$root/tests/package/common_checks.sh"
packages=$1 bin=/usr/bin

fresh_system deb
make_expectations
mkdir -p "$system/packages"
cp "$packages"/*.deb "$system/packages/"

# The library and its headers, on a machine without Qt: the examples, and a program that goes through all of the face.
install /packages/tan-core_*.deb /packages/tan-dev_*.deb cmake make g++
check 'no Qt is there' "[ -z \"\$(find /usr -name 'libQt*')\" ]"
cp -r "$root/tests/face/outsider" "$system/work/outsider"
check 'programs are built with the library alone' "cd /work; cp -r /usr/share/doc/tan-dev/examples/library .
    for folder in library outsider; do cmake -S \$folder -B \$folder/build -DCMAKE_BUILD_TYPE=Release; cmake --build \$folder/build; done"
check 'the examples run' "cd /work; library/build/build_from_array wells.tan; library/build/query_at_accuracy wells.tan 1
    library/build/isosurface_to_file wells.tan 1 -0.5 wells.obj; library/build/picture_to_file wells.tan 1 wells.ppm"
check 'all of the face works' 'cd /work; mkdir survey; outsider/build/survey survey'
# As others install programs: these have no run path, so it is the system that knows the library.
check 'installed programs find the library' "cd /work; for folder in library outsider; do cmake --install \$folder/build; done
    readelf -d /usr/local/bin/survey >survey.dynamic; ! grep -E 'R(UN)?PATH' survey.dynamic
    build_from_array installed.tan; mkdir installed; PATH=/usr/local/bin:\$PATH survey installed; rm /usr/local/bin/*"

# The command line, on a machine without a screen.
seconds install /packages/tan_*.deb
echo "install time: tan_*.deb $seconds s, all that it needs included"
check 'no window and no Qt are there' "[ -z \"\$(find /usr -name 'libQt*' -o -name tan-desktop)\" ]"
check_command_line without_window
check 'without the window: told what to install' "cd /work; ! '$bin/tan' c60.tan 2>message; grep -F tan-desktop message"

seconds install /packages/tan-desktop_*.deb
echo "install time: tan-desktop_*.deb $seconds s, all that it needs included"
check 'ffmpeg is suggested, and neither needed nor installed' \
    "dpkg -s tan-desktop | grep '^Suggests:.*ffmpeg'; ! dpkg -s tan tan-desktop | grep -E '^(Depends|Recommends):.*ffmpeg'; ! command -v ffmpeg"
check 'the dialogs of Qt speak German and Italian, too' "ls /usr/share/qt6/translations/qtbase_de.qm /usr/share/qt6/translations/qtbase_it.qm"
check_command_line
check 'without the VTK readers: told what to install' \
    "! '$bin/tan' info /work/image.vti 2>/work/message; grep -F 'apt install ./tan-vtk-readers_*.deb' /work/message"
seconds install /packages/tan-vtk-readers_*.deb
echo "install time: tan-vtk-readers_*.deb $seconds s"
check_vtk

install xvfb xauth xdotool x11-apps xdg-utils libfile-mimeinfo-perl libglib2.0-bin shared-mime-info desktop-file-utils
check 'the desktop knows models, also without their ending' "cd /work; cp c60.tan nameless
    [ \$(xdg-mime query filetype c60.tan) = application/x-tan-model ]
    gio info -a standard::content-type nameless | grep application/x-tan-model
    [ \$(xdg-mime query default application/x-tan-model) = org.tan.tan.desktop ]"
check_window 'a model opens by its type (xdg-open)' 'xdg-open c60.tan'
cp "$system/work/window.xwd" "$clean/deb-window.xwd"
check_window 'a model opens by its type (gio)' 'gio open c60.tan'

check 'the example plugin is built with the installed headers, without those of Qt' "! dpkg -s qt6-base-dev
    cp -r /usr/share/doc/tan-dev/examples/reader /work/example
    cd /work/example; cmake -B build -DCMAKE_BUILD_TYPE=Release; cmake --build build"
check 'and loaded, and reads a file' "cd /work; export TAN_PLUGIN_PATH=/work/example/build
    tan plugins | grep 'example.grid-text.*loaded'; echo '2 2 2  0 1 2 3 4 5 6 7' >cube.grid; tan build cube.grid -o cube.tan"

# Python, with what it takes alone.
seconds install /packages/python3-tan_*.deb
echo "install time: python3-tan_*.deb $seconds s, all that it needs included"
cat >"$system/work/try.py" <<'PYTHON'
import numpy, tan
z, y, x = numpy.mgrid[0:17, 0:17, 0:17]
model = tan.build(numpy.hypot(x - 8.0, y - 8.0), "pipe.tan", name="pipe")
mesh = model.mesh(error=1)
assert abs(mesh.volume() - 16**3) < 1e-6 and len(mesh.tetrahedra) > 100, mesh
assert model.render(mode="volume", size=(64, 48)).shape == (48, 64, 4)
assert tan.open("c60.tan").verify("c60.nrrd", levels=[4])
assert tan.build("c60.nrrd", "again.tan", error=2).mesh(error=4).error <= 4
assert not [line for line in open("/proc/self/maps") if "libQt" in line]
PYTHON
check 'the module builds, draws, reads and verifies, without Qt in the process' 'cd /work; python3 try.py'

inside 'dpkg -L tan-core tan tan-desktop tan-vtk-readers tan-dev python3-tan' | sort -u >"$clean/owned"
check 'purge' 'apt-get -q -y purge tan-core tan tan-desktop tan-vtk-readers tan-dev python3-tan'
left=$(while read -r path; do
    # Folders that others use, too, may stay.
    [ ! -e "$system$path" ] || { [ -d "$system$path" ] && inside "dpkg -S '$path'" >/dev/null 2>&1; } || echo "$path"
done <"$clean/owned")
left+=$(grep -rl x-tan "$system/usr/share/mime" "$system/usr/share/applications" || true)
left+=$(find "$system/var/lib/dpkg/info" -name 'tan*' -o -name 'python3-tan*')
if [ -n "$left" ]; then
    printf 'FAIL: left behind: %s\n' "$left"
    exit 1
fi
echo 'passed: nothing is left'
