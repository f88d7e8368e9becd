#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# desktop_files_test.sh SOURCE BUILD VERSION: what desktops read of an installation is as their own tools want it, and tells
# of this version. Tools that are not there are named; without any, 77: skipped.
set -euo pipefail
source=$1 build=$2 version=$3
desktop=$source/packaging/desktop
metainfo=$build/packaging/org.tan.tan.metainfo.xml
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
used=0

# with TOOL COMMAND...: runs the command if the tool is there.
with()
{
    local tool=$1
    shift
    if ! command -v "$tool" >/dev/null; then
        echo "skipped: no $tool here"
        return 0
    fi
    used=$((used + 1))
    "$@" || { echo "FAIL: $*"; exit 1; }
    echo "passed: $*"
}

# Not even a remark.
appstream_is_silent()
{
    local said
    said=$(appstreamcli validate --no-net --no-color --pedantic "$1" 2>&1) && [ "$(wc -l <<<"$said")" = 1 ] ||
        { printf '%s\n' "$said"; return 1; }
}

no_warnings_of_man() { [ -z "$(man --warnings -l -Tutf8 "$1" 2>&1 >/dev/null | tee /dev/stderr)" ]; }

# kind FILE TYPE: the desktop takes FILE for TYPE.
kind() { [ "$(XDG_DATA_HOME=$scratch XDG_DATA_DIRS=/usr/share gio info -a standard::content-type "$1" |
    sed -n 's/.*content-type: //p')" = "$2" ]; }

kinds_are_recognised()
{
    mkdir -p "$scratch/mime/packages"
    cp "$desktop/org.tan.tan.mime.xml" "$scratch/mime/packages/"
    update-mime-database "$scratch/mime" 2>/dev/null
    printf '\x89TAN\r\n\x1a\nrest' >"$scratch/no ending"
    printf '{\n    "background": [0, 0, 0],\n    "format": "tan-session"\n}' >"$scratch/session"
    printf 'plain' >"$scratch/a.tan"
    printf 'plain' >"$scratch/plain"
    kind "$scratch/no ending" application/x-tan-model && kind "$scratch/session" application/x-tan-session &&
        kind "$scratch/a.tan" application/x-tan-model && ! kind "$scratch/plain" application/x-tan-model
}

with desktop-file-validate desktop-file-validate "$desktop/org.tan.tan.desktop"
with appstreamcli appstream_is_silent "$metainfo"
with appstreamcli appstream_is_silent "$build/packaging/with_links/org.tan.tan.metainfo.xml"
with xmllint xmllint --noout "$metainfo" "$desktop/org.tan.tan.mime.xml" "$desktop/org.tan.tan.svg"
with man no_warnings_of_man "$build/share/tan-documents/tan.1"
with man no_warnings_of_man "$source/packaging/man/tan-desktop.1"
if command -v update-mime-database >/dev/null; then
    with gio kinds_are_recognised
fi

# Each language of the window is one of the desktop, too.
for translation in "$source"/translations/tan_*.ts; do
    language=$(basename -- "$translation" .ts) language=${language#tan_}
    for key in GenericName Comment Keywords; do
        grep -q "^$key\[$language\]=." "$desktop/org.tan.tan.desktop" || { echo "FAIL: no $key in $language"; exit 1; }
    done
    for file in "$metainfo" "$desktop/org.tan.tan.mime.xml"; do
        grep -q "xml:lang=\"$language\"" "$file" || { echo "FAIL: $file does not speak $language"; exit 1; }
    done
done

# The newest entry of each is this version.
grep -m1 '<release ' "$metainfo" | grep -qF "version=\"$version\"" || { echo "FAIL: $metainfo is not of $version"; exit 1; }
head -n1 "$source/packaging/debian/changelog" | grep -qF "($version)" || { echo "FAIL: changelog is not of $version"; exit 1; }
[ "$used" -gt 0 ] || exit 77
