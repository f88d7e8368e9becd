#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# bench_trial_test.sh SOURCE BUILD PYTHON: the benchmarks in tiny sizes, and the page of what they found. That of the
# window is left out: its edits take as long as the window takes to draw, which is minutes on a loaded machine.
set -euo pipefail
source=$1 build=$2 python=$3
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
export XDG_RUNTIME_DIR=$scratch/runtime XDG_CONFIG_HOME=$scratch/config XDG_CACHE_HOME=$scratch/cache XDG_DATA_HOME=$scratch/share
mkdir -m 700 "$XDG_RUNTIME_DIR"
"$python" "$source/tests/bench/run_all.py" --source "$source" --build "$build" --folder "$scratch/results" --trial \
    --only refinement,refinement-large,threads,extraction,volume,surfaces,hybrid,decimation,growth,packed,remote,paper
"$python" "$source/tests/bench/page/make_page.py" "$scratch/results" "$scratch/measured.md" "$scratch/pictures" --without interaction \
    --drawer "$build/bin/tan-bench-plots"
grep -q 'trial of tiny sizes' "$scratch/measured.md"
test -s "$scratch/pictures/refinement.svg"
