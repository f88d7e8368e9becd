#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# To be sourced. A Debian 12 with nothing installed, in a folder below build/clean, thrown away after use. Needs root, debootstrap and
# a Debian mirror. The minimal system and the packages that apt fetched are kept, so that only the first time takes long.
clean=$root/build/clean
mirror=http://deb.debian.org/debian

unmount()
{
    local place
    for place in "$system/var/cache/apt/archives" "$system/proc"; do
        ! mountpoint -q "$place" || umount "$place"
    done
}

remove_system()
{
    unmount
    rm -rf --one-file-system "$system"
}

# fresh_system NAME: sets $system.
fresh_system()
{
    mkdir -p "$clean/fetched/partial"
    if [ ! -f "$clean/minimal.tar" ]; then
        debootstrap --variant=minbase bookworm "$clean/minimal" "$mirror" >"$clean/debootstrap.log" || return
        tar -C "$clean/minimal" -cf "$clean/minimal.tar.part" .
        mv "$clean/minimal.tar.part" "$clean/minimal.tar"
        rm -rf --one-file-system "$clean/minimal"
    fi
    system=$clean/$1
    remove_system
    mkdir "$system"
    trap remove_system EXIT
    tar -C "$system" -xf "$clean/minimal.tar"
    cp /etc/resolv.conf "$system/etc/resolv.conf"
    echo 'Binary::apt::APT::Keep-Downloaded-Packages "true"; APT::Keep-Downloaded-Packages "true";' \
        >"$system/etc/apt/apt.conf.d/99keep"
    mount -t proc proc "$system/proc"
    mount --bind "$clean/fetched" "$system/var/cache/apt/archives"
    inside 'apt-get -q update' >"$clean/apt.log" 2>&1
}

# inside COMMAND: in the system, as root, with an environment of nothing.
inside()
{
    chroot "$system" env -i HOME=/root LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
        PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin bash -c "$1" </dev/null
}

# install WORD...: packages or files, without what is only recommended.
install()
{
    inside "apt-get -q -y --no-install-recommends install $*" >"$clean/apt.log" 2>&1 || { tail -n 20 "$clean/apt.log"; return 1; }
}

# check TEXT COMMAND: COMMAND succeeds inside.
check()
{
    local said
    if said=$(inside "set -e; $2" 2>&1); then
        printf 'passed: %s\n' "$1"
    else
        printf 'FAIL: %s\n%s\n' "$1" "$said"
        return 1
    fi
}

# seconds COMMAND...: sets $seconds to what it took.
seconds()
{
    local start
    start=$(date +%s.%N)
    "$@" || return
    seconds=$(awk -v start="$start" -v end="$(date +%s.%N)" 'BEGIN { printf "%.0f", end - start }')
}
