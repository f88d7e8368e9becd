#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# run_paths_test.sh LEAST FOLDER...: no program and no library in the folders (LEAST of them have a run path) looks for libraries in the
# current folder, which is where a file from anywhere may have been unpacked: each element of a run path begins with / or $ORIGIN. An
# empty one is the current folder to the loader, and so is one that is relative.
set -euo pipefail
least=$1
shift

# "FILE PATH" of each file that has one. readelf names files where there are several, and goes on after those that it cannot read.
run_paths()
{
    # What other tests build and install below tests/ is theirs.
    find "$@" \( -name outside -o -name installation \) -prune -o -type f \( -perm -u+x -o -name '*.so*' \) -print0 | { LC_ALL=C xargs -0 -r readelf -d /dev/null 2>/dev/null || true; } |
        awk '/^File: / { file = substr($0, 7) } /\((RPATH|RUNPATH)\)/ { sub(/.*\[/, ""); sub(/\]$/, ""); print file " " $0 }'
}

found=$(run_paths "$@")
bad=$(grep -vE ' (/|\$ORIGIN)[^:]*(:(/|\$ORIGIN)[^:]*)*$' <<<"$found" || true)
if [ -n "$bad" ]; then
    printf 'FAIL: these look for libraries in the current folder:\n%s\n' "$bad"
    exit 1
fi
count=$(grep -c . <<<"$found" || true)
[ "$count" -ge "$least" ] || { echo "FAIL: only $count files with a run path in $*"; exit 1; }
echo "passed: the run paths of $count files"
