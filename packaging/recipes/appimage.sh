#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# UNTESTED. packaging/recipes/appimage.sh: an AppImage out of the archive that `./dev package` built. Needs appimagetool
# (https://github.com/AppImage/appimagetool) in the path.
set -euo pipefail
root=$(cd -- "$(dirname -- "$0")/../.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/TAn.AppDir"
tar -C "$folder/TAn.AppDir" --strip-components=1 -xf "$root"/build/packages/tan-*.tar.gz
cd "$folder/TAn.AppDir"
cp share/applications/org.tan.tan.desktop share/icons/hicolor/scalable/apps/org.tan.tan.svg .
# `tan` without a subcommand, or with a file alone, opens the window.
printf '#!/bin/sh\nexec "${0%%/*}/bin/tan" "$@"\n' >AppRun
chmod +x AppRun
appimagetool . "$root/build/packages/TAn-x86_64.AppImage"
