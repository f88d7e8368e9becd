#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the pictures of the manual with the programs that were built (./dev pictures builds them): the paper's Figures 14 and 15
# drawn again, those of the tutorials and of the gallery, and the window.
#   docs/make_pictures.sh [DATA [MODELS [SCREENSHOTS]]]
# DATA: the folder with bluntfin, buckyball and regular (default: ../shared/data beside the repository). MODELS: where the models
# are built, once (default: build/pictures). SCREENSHOTS: what ./dev screenshots has made (default: build/screenshots).
set -euo pipefail

cd -- "$(dirname -- "$0")/.."
data=${1:-../shared/data}
models=${2:-build/pictures}
screenshots=${3:-build/screenshots}
tan=build/release/bin/tan
pictures=docs/user/pictures
mkdir -p "$models"

# A model of DATASET with all accuracies from ERROR on, unless it is there already.
build()
{
    local model=$models/$1.tan dataset=$data/$2 error=$3
    [ -f "$model" ] || "$tan" build "$dataset" --error "$error" -o "$model"
}

draw() { "$tan" render "$@" --samples 3; }

# Figure 14: BluntFin as isosurface and as volume, exact, at 1 % and at 4 % of error and warping.
[ -f "$models/bluntfin.tan" ] || "$tan" build "$data/bluntfin/bluntfinxyz.bin" --builder refinement --error-in grid -o "$models/bluntfin.tan"
for error in 0 1 4; do
    view=("$models/bluntfin.tan" --error "$error" --camera "$pictures/bluntfin-camera.json" --size 400x200)
    draw "${view[@]}" --isovalue 1.244:silver -o "$pictures/bluntfin-surface-$error.png"
    draw "${view[@]}" --mode volume --no-shaded --transfer "$pictures/bluntfin-transfer.json" -o "$pictures/bluntfin-volume-$error.png"
done

# What is seen first of real data, by the defaults, in two modes.
first()
{
    local mode
    build "first-$1" "$2" "$3"
    for mode in isosurface volume; do
        draw "$models/first-$1.tan" --mode "$mode" --error 1 --size 480x360 --backend cpu -o "$pictures/first-$1-$mode.png"
    done
}
first headsq regular/headsq_64x64x93_int16.nrrd 0
first engine regular/engine_256x256x128_uint8.nrrd 0.5
first neghip regular/neghip_64x64x64_uint8.nhdr 0
first c60 buckyball/c60large_128x128x128_uint8.nhdr 0.1
first bluntfin bluntfin/bluntfin.vts 0
first spx irregular/spx.vtu 0
first bracket irregular/bracket_57k.vtu 0

# Figure 15: the buckyball at 0.6 %, surfaces in a volume, in the exact order and in that of the paper; and cut open.
build buckyball buckyball/c60large_128x128x128_uint8.nhdr 0.6
view=("$models/buckyball.tan" --error 0.6 --mode hybrid --no-shaded --camera "$pictures/buckyball-camera.json" --size 260x260
      --transfer "$pictures/buckyball-transfer.json" --no-outline)
draw "${view[@]}" --isovalue 170:gold -o "$pictures/buckyball-exact.png"
draw "${view[@]}" --isovalue 170:gold --order with-cell -o "$pictures/buckyball-with-cell.png"
draw "${view[@]}" --isovalue 170:gold --clip 0,1,0,63.5 -o "$pictures/buckyball-cut.png"

# What the tutorials end with, by the commands that they show; of the large volume a small one. The commands of their last sections, on data
# of one's own, are left out.
tutorial()
{
    local page=docs/user/tutorial-$1.md picture=$2 changes=$3 folder
    folder=$(mktemp -d)
    sed -E '/^## .*[Yy]our own/,$d' "$page" | sed -nE 's/^    ((echo|tan (sample|build|render)) .*)/\1/p' | grep -v http | sed -E "$changes" >"$folder/commands"
    (PATH=$PWD/build/release/bin:$PATH && cd "$folder" && sh -e commands)
    cp "$folder/$picture.png" "$pictures/tutorial-$1.png"
    rm -rf "$folder"
}
tutorial ct solid ''
tutorial cfd shock ''
tutorial large large 's/--size 1700/--size 160/; s/--block 64 //'

# The gallery, by the commands that its page shows.
python3 tests/docs/gallery_test.py build/release --data "$data" --update

# The window with the sample, in both colours and three languages.
take() { cp "$screenshots/$1.png" "docs/user/images/$2.png"; }
take en-1x/light-start start
take en-1x/light-window window
take en-1x/light-panel-statistics-whole statistics
take en-1x/light-panel-animation animation
take en-1x/light-palette palette
take en-1x/light-pictureOptions picture
take en-1x/light-importDialog-2 import
take en-1x/light-panel-build-dataset build
take en-1x/light-leaving.build leaving
take de-1x/dark-window-volume german-dark
take it-1x/light-window-volume italian

# The window with datasets, in a home of its own and without a display.
build engine regular/engine_256x256x128_uint8.nrrd 0.5
home=$(mktemp -d)
trap 'rm -rf "$home"' EXIT
env HOME="$home" XDG_CONFIG_HOME="$home/config" XDG_CACHE_HOME="$home/cache" XDG_DATA_HOME="$home/data" XDG_RUNTIME_DIR="$home" \
    QT_QPA_PLATFORM=offscreen QT_SCALE_FACTOR=1 LC_ALL=C.UTF-8 build/release/bin/window-pictures docs/user/images "$models"
