#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# upgrade_test.sh FOLDER: from the packages of TAn 0.1 to those of FOLDER, in a Debian with nothing else installed. Those of 0.1 are built
# from its last commit, once; they are kept in build/clean/packages-0.1.
set -euo pipefail
root=$(cd -- "$(dirname -- "$0")/../.." && pwd)
. "$root/tests/package/clean_debian.sh"
. "$root/tests/package/common_checks.sh"
packages=$1 bin=/usr/bin
released=1cfbb5d1 # of 22 November 2026, the last that changed the packages of 0.1.0
old=$clean/packages-0.1

build_old_packages()
{
    local source=$clean/source-0.1
    rm -rf "$source"
    git clone --quiet --no-checkout "$root" "$source"
    git -C "$source" checkout --quiet "$released"
    (cd -- "$source" && ./dev package) >"$clean/build-0.1.log" 2>&1 || { tail -n 20 "$clean/build-0.1.log"; return 1; }
    mkdir -p "$old"
    cp "$source"/build/packages/*.deb "$old/"
    rm -rf "$source"
}

mkdir -p "$clean"
compgen -G "$old/tan_*.deb" >/dev/null || build_old_packages
fresh_system upgrade
make_expectations
mkdir -p "$system/packages" "$system/old"
cp "$packages"/*.deb "$system/packages/"
cp "$old"/*.deb "$system/old/"

install /old/tan_*.deb /old/tan-vtk-readers_*.deb xvfb xauth xdotool x11-apps
check 'what there was is 0.1' "tan --version | grep -F 'tan 0.1.'"
check 'a model of 0.1' "cd /work; tan sample c60 --size 32 -o c60.nrrd; tan build c60.nrrd -o old.tan; rm c60.nrrd"
inside 'dpkg -L tan tan-vtk-readers' | sort -u >"$clean/owned-by-0.1"

# As apt upgrades by itself, recommended packages included: whoever had the window keeps it.
check 'the upgrade' "apt-get -q -y install /packages/tan-core_*.deb /packages/tan_*.deb /packages/tan-desktop_*.deb /packages/tan-vtk-readers_*.deb"
check 'nothing is broken, and nothing of 0.1 is left' "apt-get -q check; [ -z \"\$(dpkg -l 'tan*' | grep '^ii.* 0\\.1')\" ]"
left=$(while read -r path; do
    [ ! -e "$system$path" ] || inside "dpkg -S '$path'" >/dev/null 2>&1 || echo "$path"
done <"$clean/owned-by-0.1")
[ -z "$left" ] || { printf 'FAIL: nobody owns what 0.1 installed: %s\n' "$left"; exit 1; }
check 'the model of 0.1 opens' "cd /work; tan verify old.tan; tan extract old.tan --error 1 -o old.vtu; rm old.tan old.vtu"
check_command_line
check_vtk
check_window 'the window is still there' "$bin/tan-desktop c60.tan"
