#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# without_qt_test.sh BUILD: the program tan, the libraries that it and others stand on, and all plugins but editors are loaded without Qt.
set -euo pipefail
program=$1/bin/tan libraries=$1/lib
export LC_ALL=C

# What the system's loader would load for a file, and what it does not find.
needed() { ldd "$1" || { echo "FAIL: ldd cannot read $1" >&2; exit 1; }; }

count=0
for file in "$program" "$libraries"/libtan-{core,picture,plugin-host}.so "$libraries"/tan/plugins/*.so; do
    all=$(needed "$file")
    grep -q 'libstdc++\|libc++' <<<"$all" || { echo "FAIL: nothing is told of $file"; exit 1; }
    case $file in
    */libtan-editor-*)
        grep -q libQt <<<"$all" || { echo "FAIL: an editor without Qt, $file: Qt is not found by this test"; exit 1; }
        ;;
    *)
        if grep libQt <<<"$all"; then
            echo "FAIL: $file needs Qt"
            exit 1
        fi
        count=$((count + 1))
        ;;
    esac
done
[ "$count" -ge 20 ] || { echo "FAIL: only $count libraries in $libraries"; exit 1; }
echo "passed: $count libraries without Qt"
