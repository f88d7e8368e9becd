#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# wheel_test.sh FOLDER: the wheel of FOLDER in a virtual environment, in a Debian that has Python and NumPy and nothing of TAn.
set -euo pipefail
root=$(cd -- "$(dirname -- "$0")/../.." && pwd)
. "$root/tests/package/clean_debian.sh"
packages=$1

fresh_system wheel
install python3-venv python3-numpy
mkdir -p "$system/work"
cp "$packages"/tan-*.whl "$system/work/"
check 'no wheel is above 8 MB' '[ -z "$(find /work -name "tan-*.whl" -size +8000000c)" ]'
seconds check 'it installs' 'cd /work; python3 -m venv --system-site-packages env; env/bin/pip install --no-index tan-*.whl'
echo "install time: tan-*.whl $seconds s"
cat >"$system/work/try.py" <<'PYTHON'
import pickle, re, subprocess, sys
import numpy, tan

def refused(kind, words, function, *arguments, **named):
    try:
        function(*arguments, **named)
    except kind as problem:
        assert re.search(words, str(problem)), problem
        return
    raise AssertionError(f"not refused: {words}")

z, y, x = numpy.mgrid[0:17, 0:17, 0:17]
values = numpy.hypot(x - 8.0, y - 8.0)
model = tan.build(values, "pipe.tan", name="pipe")
mesh = model.mesh(error=1)
assert abs(mesh.volume() - 16**3) < 1e-6 and len(mesh.tetrahedra) > 100, mesh
assert model.verify(values)
surface = mesh.isosurface(6)
radii = numpy.hypot(*(surface.points[:, :2] - 8).T)
assert len(radii) > 100 and abs(radii - 6).max() < 0.3, abs(radii - 6).max()
bare = {"size": (64, 48), "colour_bar": False, "axes": False}
for mode, _ in model.modes():
    picture = model.render(mode=mode, **bare)
    assert picture.shape == (48, 64, 4) and len(numpy.unique(picture.reshape(-1, 4), axis=0)) > 20, mode
assert len(model.modes()) == 6, model.modes()
model.pack("packed.tan")
assert len(tan.open("packed.tan").mesh(error=1).tetrahedra) == len(mesh.tetrahedra)
points = tan.build(tan.Points(numpy.random.default_rng(1).random((200, 3)), numpy.arange(200.0)), "points.tan")
assert points.mesh(error=5).error <= 5
other = "import pickle, sys; print(len(pickle.load(sys.stdin.buffer).mesh(error=1).points))"
answer = subprocess.run([sys.executable, "-c", other], input=pickle.dumps(model), stdout=subprocess.PIPE, check=True)
assert int(answer.stdout) == len(mesh.points), answer
refused(tan.Error, "built without the network", tan.open, "http://example.org/a.tan")
refused(tan.Error, "program 'tan', which reads data files, is not found. Install it", tan.build, "a.nrrd", "a.tan")
refused(tan.Error, "built without OpenGL|OpenGL", model.render, backend="gl", **bare)
used = {line.split()[-1] for line in open("/proc/self/maps") if ".so" in line}
assert not [path for path in used if "libQt" in path]
brought = [path for path in used if re.search("tbb|freetype|png|harfbuzz|gmp|pugixml|xxhash", path) and "numpy" not in path]
assert len(brought) >= 6 and all("/tan/lib/" in path for path in brought), brought
PYTHON
check 'it builds, extracts, draws in all modes, packs and verifies with what it brings along, and says what it cannot do' 'cd /work; env/bin/python try.py'
check 'texts need a font, which it says' "cd /work; ! env/bin/python -c 'import tan; tan.open(\"pipe.tan\").render(title=True)' 2>message; grep -i font message"
install fonts-dejavu-core fontconfig
check 'and are drawn with one' "cd /work; env/bin/python -c 'import tan; tan.open(\"pipe.tan\").save_picture(\"a.png\", title=True)'; test -s a.png"
check 'the licences of what it brings are there' 'cd /work/env/lib/python3*/site-packages; set -- tan/lib/*-*.so*; test $# -ge 8; ls tan-*.dist-info/licenses | grep -E "libtbb|libharfbuzz|TAn" | wc -l | grep -x 3'
check 'nothing is left of it' 'cd /work; env/bin/pip uninstall -y tan; ! ls -d env/lib/python3*/site-packages/tan*'
