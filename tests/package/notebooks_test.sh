#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# notebooks_test.sh FOLDER: the notebooks of the manual, each run by nbconvert from its first cell to its last in a Debian with the
# packages of FOLDER and what the notebooks say they need. No part of all.sh: ./dev soak runs the same cells with the build's module. The
# system takes some 2.5 GB.
set -euo pipefail
root=$(cd -- "$(dirname -- "$0")/../.." && pwd)
. "$root/tests/package/clean_debian.sh"
packages=$1

fresh_system notebooks
mkdir -p "$system/packages" "$system/work"
cp "$packages"/*.deb "$system/packages/"
cp "$root"/docs/user/notebooks/*.ipynb "$system/work/"
install /packages/tan-core_*.deb /packages/tan_*.deb /packages/tan-vtk-readers_*.deb /packages/python3-tan_*.deb \
    jupyter-nbconvert python3-ipykernel python3-matplotlib python3-meshio python3-vtk9
# The readers' programs need Qt, and the kernel must not.
cat >"$system/work/add_cell.py" <<'PYTHON'
import json, sys
book = json.load(open(sys.argv[1], encoding="utf-8"))
source = 'used = open("/proc/self/maps").read()\nassert "libtan-core" in used and "libQt" not in used'
book["cells"].append({"cell_type": "code", "execution_count": None, "metadata": {}, "outputs": [], "source": source})
json.dump(book, open(sys.argv[1], "w", encoding="utf-8"))
PYTHON
check 'Qt is there' '[ -n "$(find /usr -name "libQt6Core*")" ]'
for path in "$system"/work/*.ipynb; do
    name=$(basename -- "$path")
    seconds check "$name runs, without Qt in the kernel" "cd /work; python3 add_cell.py $name
        jupyter nbconvert --to notebook --execute --ExecutePreprocessor.timeout=600 --output done-$name $name
        grep -F image/png done-$name"
    echo "$name: $seconds s"
done
