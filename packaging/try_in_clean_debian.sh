#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Proves, as root, that a fresh clone works on a Debian 12 with nothing installed: makes a minimal system in FOLDER (kept there
# as a tar file, so only the first time takes long), clones this repository into it and runs ./dev run and ./dev test.
#   packaging/try_in_clean_debian.sh [FOLDER [BRANCH]]     FOLDER: default /var/tmp/tan-clean-debian
# A folder `shared` beside the repository is copied beside the clone, because tests take their datasets from there.
set -euo pipefail

repository=$(cd -- "$(dirname -- "$0")/.." && pwd)
folder=${1:-/var/tmp/tan-clean-debian}
branch=${2:-$(git -C "$repository" branch --show-current)}
system=$folder/root
mirror=http://deb.debian.org/debian

unmount() { ! mountpoint -q "$system/proc" || umount "$system/proc"; }

restore_pristine_system()
{
    mkdir -p "$folder"
    if [ ! -f "$folder/root.tar" ]; then
        debootstrap --variant=minbase bookworm "$system" "$mirror"
        tar -C "$system" -cf "$folder/root.tar.part" .
        mv "$folder/root.tar.part" "$folder/root.tar"
    fi
    unmount
    rm -rf --one-file-system "$system"
    mkdir "$system"
    tar -C "$system" -xf "$folder/root.tar"
    cp /etc/resolv.conf "$system/etc/resolv.conf"
}

inside()
{
    local start=$SECONDS status=0
    chroot "$system" env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin bash -c "$1" </dev/null || status=$?
    printf '== %s: exit %d after %d s\n' "$1" "$status" $((SECONDS - start))
    return "$status"
}

restore_pristine_system
git clone --quiet --no-hardlinks --branch "$branch" "$repository" "$system/root/tan"
[ ! -d "$repository/../shared" ] || cp -rL "$repository/../shared" "$system/root/shared"
mount -t proc proc "$system/proc"
trap unmount EXIT

inside '/root/tan/dev run'
inside 'test -s /root/tan/build/demo/c60.png'
inside 'cd / && /root/tan/dev run'
inside '/root/tan/dev test'
inside 'cd /root/tan && ./dev test'
