#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# bundle_test.sh FOLDER: the self-extracting archive and the .tar.gz of FOLDER on a Debian without Qt and VTK, in a folder with a space
# in its name. The system has what every desktop has: X, OpenGL, fonts.
set -euo pipefail
root=$(cd -- "$(dirname -- "$0")/../.." && pwd)
. "$root/tests/package/clean_debian.sh"
. "$root/tests/package/common_checks.sh"
packages=$1 bin='/opt/a folder/bin'

fresh_system bundle
make_expectations
mkdir -p "$system/packages"
cp "$packages"/*.sh "$packages"/*.tar.gz "$system/packages/"
install libegl1 libopengl0 libgl1 libgl1-mesa-dri libx11-6 libxext6 libfontconfig1 fonts-dejavu-core xvfb xauth xdotool x11-apps
check 'no Qt and no VTK are there' "[ -z \"\$(find /usr -name 'libQt*' -o -name 'libvtk*')\" ]"

seconds inside "mkdir -p '/opt/a folder'; sh /packages/tan-*.sh --skip-license --prefix='/opt/a folder' --exclude-subdir >/dev/null"
echo "install time: tan-*.sh $seconds s"
check_command_line
check_vtk
check_window 'the window starts' "\"$bin/tan-desktop\" c60.tan"
cp "$system/work/window.xwd" "$clean/bundle-window.xwd"
check 'the licences of all that is inside are there' "[ \$(ls '/opt/a folder/share/doc/tan/bundled' | wc -l) -gt 20 ]"
check 'nothing lies outside of the folder' "rm -r '/opt/a folder'; [ -z \"\$(find /usr /opt -iname '*libtan*')\" ]"

seconds inside "mkdir /opt/unpacked; tar -C /opt/unpacked --strip-components=1 -xf /packages/tan-*.tar.gz"
echo "install time: tan-*.tar.gz $seconds s"
bin=/opt/unpacked/bin
check_command_line
check_vtk
