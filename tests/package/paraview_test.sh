#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# paraview_test.sh FOLDER: the plugin of ParaView (bindings/paraview), built in a Debian with ParaView against the packages of FOLDER,
# gives what `tan extract` writes, in one process and in two. Leaves the package paraview-tan in FOLDER. The system takes some 3 GB and ten
# minutes.
set -euo pipefail
root=$(cd -- "$(dirname -- "$0")/../.." && pwd)
. "$root/tests/package/clean_debian.sh"
packages=$1

# What find_package(ParaView) wants and paraview-dev does not ask for.
needed=(cmake make g++ git libeigen3-dev paraview paraview-dev python3-paraview qtbase5-dev qttools5-dev libqt5svg5-dev libqt5opengl5-dev
    libutfcpp-dev libopenmpi-dev openmpi-bin python3-dev libglew-dev libfreetype-dev libexpat1-dev libxml2-dev libjpeg-dev libpng-dev
    libtiff-dev libdouble-conversion-dev liblz4-dev liblzma-dev libgl2ps-dev libhdf5-openmpi-dev libnetcdf-dev libtheora-dev libogg-dev
    libsqlite3-dev libavcodec-dev libavformat-dev libavutil-dev libswscale-dev libgdal-dev xvfb xauth)

fresh_system paraview
mkdir -p "$system/packages" "$system/work"
cp "$packages"/*.deb "$system/packages/"
install "${needed[@]}" dpkg-dev file /packages/tan-core_*.deb /packages/tan_*.deb /packages/tan-dev_*.deb
mkdir -p "$system/work/bindings" "$system/work/packaging"
cp -r "$root/bindings/paraview" "$system/work/bindings/"
cp -r "$root/packaging/debian" "$system/work/packaging/"
cp "$root/tests/package/paraview_try.py" "$system/work/"
check 'the plugin is built' 'cd /work; cmake -S bindings/paraview -B build -DCMAKE_INSTALL_PREFIX=/usr; cmake --build build -j 2'
check 'and packed' 'cd /work/build; cpack -G DEB; dpkg-deb --info paraview-tan_*.deb | grep "Depends:.*tan-core"'
cp "$system"/work/build/paraview-tan_*.deb "$packages/"
check 'and installed' 'apt-get -q -y install /work/build/paraview-tan_*.deb; find /usr/lib -name TAnReader.so | grep paraview-5.11/plugins'
check 'models' "cd /work; tan sample c60 --size 40 -o c60.nrrd
    sed -i 's/^space directions:.*/space directions: (0.6,0.8,0) (-0.8,0.6,0) (0,0,1)/' c60.nrrd
    tan sample blunt-body --size 24 -o body.xyz; tan sample part --size 60 -o part.vtu
    for name in c60.nrrd body.xyz part.vtu; do tan build \$name -o \${name%.*}.tan; done
    for name in c60 body part; do for error in 4 1 0; do tan extract \$name.tan --error \$error -o \$name-\$error.vtk; done; done"
run='export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1; cd /work; plugin=$(find /usr/lib -name TAnReader.so)'
check 'points, cells and arrays are those of tan extract; pictures of a contour and of a volume' \
    "$run; xvfb-run -n 4711 pvbatch paraview_try.py \$plugin one"
check 'two processes have the same mesh, each a part' "$run; mpirun --oversubscribe -np 2 pvbatch paraview_try.py \$plugin two"
mkdir -p "$clean/paraview"
cp "$system"/work/*.png "$clean/paraview/"
echo "Pictures to look at: $clean/paraview"
