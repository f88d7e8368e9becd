#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs a test program on a display of its own with a window manager; exits with 77 (skipped) where that is impossible,
# or fails where nothing may be skipped (tests/lacks.h).
if ! command -v xvfb-run >/dev/null || ! command -v openbox >/dev/null; then
    echo "skipped: xvfb-run or openbox is missing"
    here=$(dirname -- "$0")
    [ "${TAN_MAY_SKIP:-$([ -d "$here/../../../shared/data" ] && echo 0)}" != 0 ] && exit 77
    exit 1
fi
QT_QPA_PLATFORM=xcb exec xvfb-run -a -s "-screen 0 1280x1024x24" sh -c 'openbox & manager=$!; "$@"; result=$?; kill $manager; exit $result' sh "$@"
