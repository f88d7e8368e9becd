#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# rpm_test.sh FOLDER: the .rpm packages of FOLDER, installed by rpm in a Debian with nothing but the libraries that the .deb asks for.
# Proves that they put the files of the .deb into place, byte for byte, ask for the libraries that these need and for no others, run,
# and go without a trace. It does not prove that a distribution of RPM has these libraries, under these names and versions.
set -euo pipefail
root=$(cd -- "$(dirname -- "$0")/../.." && pwd)
. "$root/tests/package/clean_debian.sh"
. "$root/tests/package/common_checks.sh"
packages=$1 bin=/usr/bin

deb_of() { echo "$packages"/"$1"_*.deb; }
rpm_of() { echo "$packages"/"$1"-[0-9]*.rpm; }

# asked_by_deb NAME: the packages that it depends on, the first of alternatives, without versions and those of TAn.
asked_by_deb() { dpkg-deb -f "$(deb_of "$1")" Depends | tr ',' '\n' | sed 's/|.*//; s/(.*//; s/ //g' | grep -v '^tan'; }

# install_rpm NAME: Debian's rpm wants to be sure that it is meant, and knows none of Debian's own packages.
install_rpm() { inside "rpm --force-debian --nodeps -i /packages/$(basename -- "$(rpm_of "$1")")"; }

# check_files RPM DEB: what was installed is what the .deb holds.
check_files()
{
    local unpacked path
    unpacked=$(mktemp -d)
    dpkg-deb -x "$(deb_of "$2")" "$unpacked"
    diff <(cd -- "$unpacked" && find . ! -type d | sed 's/^\.//' | sort) \
        <(inside "rpm -ql $1" | while read -r path; do [ -d "$system$path" ] && [ ! -L "$system$path" ] || echo "$path"; done | sort) ||
        { echo "FAIL: $1 and $2 list different files"; return 1; }
    (cd -- "$unpacked" && find . -type f -print0) | while read -rd '' path; do
        cmp "$unpacked/$path" "$system/$path" || { echo "FAIL: $path is not that of the .deb"; return 1; }
    done || return
    (cd -- "$unpacked" && find . -type l -print0) | while read -rd '' path; do
        [ "$(readlink "$unpacked/$path")" = "$(readlink "$system/$path")" ] || { echo "FAIL: $path leads elsewhere"; return 1; }
    done || return
    rm -r "$unpacked"
    printf 'passed: %s has put the files of %s into place, byte for byte\n' "$1" "$2"
}

# check_requirements RPM DEB: each shared library that it asks for is there, and comes from a package that the .deb asks for, too.
check_requirements()
{
    local library file owner count=0
    while read -r library; do
        # Each of these pipes is read to its end: one that is closed earlier makes the whole fail.
        file=$(inside "ldconfig -p" | awk -v name="$library" '$1 == name && /x86-64|AArch64/ && !n++ { print $NF }')
        [ -n "$file" ] || { echo "FAIL: $1 asks for $library, which is not there"; return 1; }
        owner=$(inside "dpkg -S '$file' 2>/dev/null || dpkg -S '*/$(basename -- "$file")'" | sed -n '1s/:.*//p')
        asked_by_deb "$2" | grep -qx "$owner" || { echo "FAIL: $1 asks for $library; its package $owner is none that $2 asks for"; return 1; }
        count=$((count + 1))
    done < <(rpm -qp --requires "$(rpm_of "$1")" 2>/dev/null | sed -n 's/^\(lib[^()]*\.so[^()]*\)(.*/\1/p' | grep -v '^libtan' | sort -u)
    [ "$count" -gt 4 ] || { echo "FAIL: $1 asks for no more than $count libraries"; return 1; }
    printf 'passed: the %d libraries that %s asks for come from packages that %s asks for\n' "$count" "$1" "$2"
}

fresh_system rpm
make_expectations
mkdir -p "$system/packages"
cp "$packages"/*.rpm "$system/packages/"
# shellcheck disable=SC2046
install $(asked_by_deb tan-core) $(asked_by_deb tan) $(asked_by_deb tan-desktop) rpm xvfb xauth xdotool x11-apps

install_rpm tan-core
check_files tan-core tan-core
check_requirements tan-core tan-core
seconds install_rpm tan
echo "install time: tan-[0-9]*.rpm $seconds s, without what it needs"
check_files tan tan
check_requirements tan tan
install_rpm tan-desktop
check_files tan-desktop tan-desktop
check_requirements tan-desktop tan-desktop
check 'no package has a script' "[ -z \"\$(rpm -qp --scripts --triggers --filetriggers /packages/*.rpm 2>/dev/null)\" ]"
check_command_line
check_window 'the window starts' "$bin/tan-desktop c60.tan"
check 'without the VTK readers: told that they are missing' "! $bin/tan info /work/image.vti 2>/work/message; grep -F tan-vtk-readers /work/message"

# shellcheck disable=SC2046
install $(asked_by_deb tan-vtk-readers)
install_rpm tan-vtk-readers
check_files tan-vtk-readers tan-vtk-readers
check_requirements tan-vtk-readers tan-vtk-readers
check_vtk
install_rpm tan-devel
check_files tan-devel tan-dev
check 'nothing has changed since (rpm --verify)' 'rpm --verify --nodeps tan-core tan tan-desktop tan-vtk-readers tan-devel'

inside 'rpm -ql tan-core tan tan-desktop tan-vtk-readers tan-devel' | sort -u >"$clean/owned-by-rpm"
check 'erase' 'rpm --force-debian -e tan-devel tan-vtk-readers tan-desktop tan tan-core'
left=$(while read -r path; do
    # Folders that others use, too, may stay.
    [ ! -e "$system$path" ] || { [ -d "$system$path" ] && inside "dpkg -S '$path'" >/dev/null 2>&1; } || echo "$path"
done <"$clean/owned-by-rpm")
if [ -n "$left" ]; then
    printf 'FAIL: left behind: %s\n' "$left"
    exit 1
fi
echo 'passed: nothing is left'
