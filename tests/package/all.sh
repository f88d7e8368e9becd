#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# all.sh FOLDER: tests the packages in FOLDER, as root. Ends with a table of their sizes and of the times that installing took.
set -euo pipefail
here=$(cd -- "$(dirname -- "$0")" && pwd)
packages=$(cd -- "$1" && pwd)
log=$(mktemp)
trap 'rm -f "$log"' EXIT

echo '== lintian'
lintian --allow-root --fail-on error "$packages"/*.deb
for part in deb upgrade rpm bundle wheel; do
    echo "== $part"
    "$here/${part}_test.sh" "$packages" 2>&1 | tee -a "$log"
done

echo '== sizes and times'
printf '%-34s %10s  %s\n' package size 'installed in'
for file in "$packages"/tan*; do
    name=$(basename -- "$file")
    # "install time: tan_*.deb 25 s": the pattern says which file is meant.
    time=$(while read -r _ _ pattern text; do
        # shellcheck disable=SC2053
        [[ $name != $pattern ]] || echo "$text"
    done < <(grep '^install time:' "$log"))
    printf '%-34s %7s kB  %s\n' "$name" "$(($(stat -c %s "$file") / 1000))" "${time:--}"
done
