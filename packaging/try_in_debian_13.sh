#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Tries, as root, that TAn builds with the compiler and the libraries of Debian 13, which are two years newer than those that it is developed
# with: configures this working tree as a user would (no preset, so no -Werror), builds the library, `tan` and the tests of the library, and
# runs these.
#   packaging/try_in_debian_13.sh [FOLDER [JOBS]]     FOLDER: default /var/tmp/tan-debian-13; it keeps the system and the build
set -euo pipefail

repository=$(cd -- "$(dirname -- "$0")/.." && pwd)
folder=${1:-/var/tmp/tan-debian-13}
jobs=${2:-$(nproc)}
system=$folder/root
mirror=http://deb.debian.org/debian

unmount()
{
    local place
    for place in "$system/source" "$system/proc"; do
        ! mountpoint -q "$place" || umount "$place"
    done
}
trap unmount EXIT

mkdir -p "$folder"
[ -e "$system/etc/debian_version" ] || debootstrap --variant=minbase trixie "$system" "$mirror"
cp /etc/resolv.conf "$system/etc/resolv.conf"
mkdir -p "$system/source" "$system/build"
unmount
mount -t proc proc "$system/proc"
mount --bind -o ro "$repository" "$system/source"

inside()
{
    local start=$SECONDS status=0
    chroot "$system" env -i HOME=/root LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive PATH=/usr/sbin:/usr/bin:/sbin:/bin \
        bash -c "$1" </dev/null || status=$?
    printf '== %s: exit %d after %d s\n' "$1" "$status" $((SECONDS - start))
    return "$status"
}

inside 'apt-get -q update'
packages=$(sed -n 's/^\(build\|run\) //p' "$repository/packaging/debian-packages.txt" | tr '\n' ' ')
inside "apt-get -q -y --no-install-recommends install $packages locales"
inside 'g++ --version | head -n 1; cmake --version | head -n 1; qmake6 -query QT_VERSION'
inside 'cmake -S /source -B /build -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=16'
inside "cmake --build /build -j $jobs --target tan plugins"
inside '/build/bin/tan sample c60 --size 24 -o /tmp/c60.nrrd && /build/bin/tan build /tmp/c60.nrrd -o /tmp/c60.tan && /build/bin/tan verify /tmp/c60.tan --against /tmp/c60.nrrd'
programs=$(cd -- "$repository/tests/core" && find . -mindepth 2 -name CMakeLists.txt -exec grep -l tan_test {} + |
    sed 's|^\./\(.*\)/CMakeLists.txt|tests-core-\1|; s|/|-|g' | sort | tr '\n' ' ')
inside "cmake --build /build -j $jobs --target test-locale $programs"
inside 'cd /build/tests/core && ctest --output-on-failure --timeout 900'
