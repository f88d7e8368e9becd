# SPDX-License-Identifier: GPL-3.0-or-later
"""Small files of the names that the documentation uses."""
import array
import pathlib
import random
import shutil
import subprocess


def nrrd_header(name, size, kind, spacings, data=""):
    text = f"NRRD0004\n# {name}\ntype: {kind}\ndimension: 3\nsizes: {size}\nencoding: raw\nspacings: {spacings}\n"
    return (text + (f"data file: {data}\n" if data else "\n")).encode()


def c60_bytes(folder, tan, edge):
    file = folder / "made.nrrd"
    subprocess.run([tan, "sample", "c60", "--size", str(edge), "--type", "uint8", "-o", file], check=True, capture_output=True)
    content = file.read_bytes()
    file.unlink()
    return content[content.index(b"\n\n") + 2:]


def write_engine(folder, tan):
    """The extent of the engine (256 x 256 x 112) with few points: 33 along each axis."""
    samples = c60_bytes(folder, tan, 33)
    (folder / "engine.nrrd").write_bytes(nrrd_header("engine", "33 33 33", "uint8", "8 8 3.5") + samples)
    (folder / "volume.nhdr").write_bytes(nrrd_header("volume", "33 33 33", "uint8", "8 8 3.5", "volume.raw"))
    (folder / "volume.raw").write_bytes(samples)
    (folder / "large.nhdr").write_bytes(nrrd_header("large", "48 48 48", "uint8", "1 1 1", "large.raw"))
    large = c60_bytes(folder, tan, 48)
    (folder / "large.raw").write_bytes(large)
    (folder / "large.nrrd").write_bytes(nrrd_header("large", "48 48 48", "uint8", "1 1 1") + large)


def write_engine_of_full_size(folder):
    """256 x 256 x 128 points, a ramp, so that its model is small: for commands that count points."""
    samples = bytes(range(256)) * (256 * 128)
    (folder / "engine.nrrd").write_bytes(nrrd_header("engine", "256 256 128", "uint8", "1 1 1") + samples)


def write_grids(folder, tan):
    """A grid with the names of the paper's datasets; its solution has a density from 1 to 2 and a pressure."""
    subprocess.run([tan, "sample", "blunt-body", "--size", "12", "-o", folder / "fin.xyz"], check=True, capture_output=True)
    solution = (folder / "fin.q").read_bytes()
    head, rest = solution[:28], solution[28:]
    values = array.array("f", rest) if len(rest) % 20 == 0 else None
    points = len(values) // 5
    assert array.array("i", head[:12]).tolist()[0] > 1, "the layout of the sample's solution has changed"
    for point in range(points):
        values[point] += 1
        values[4 * points + point] = 2.5 * values[point] ** 2
    for grid, q in (("bluntfinxyz.bin", "bluntfinq.bin"), ("postxyz.bin", "postq.bin"), ("fin.xyz", "run7.q")):
        if grid != "fin.xyz":
            shutil.copyfile(folder / "fin.xyz", folder / grid)
        (folder / q).write_bytes(head + values.tobytes())


def write_head(folder):
    """A ramp of 16-bit samples whose bytes are equal: the same in both byte orders."""
    row = b"".join(bytes([i, i]) for i in range(64))
    (folder / "head.raw").write_bytes(row * (64 * 93))


def write_quakes(folder):
    chance = random.Random(1)
    rows = ["longitude_deg,latitude_deg,minus_depth_km,magnitude"]
    rows += [f"{chance.random():.6f},{chance.random():.6f},{-chance.random():.6f},{chance.random() * 9:.3f}" for _ in range(200)]
    (folder / "quakes.csv").write_text("\n".join(rows) + "\n")


def write_recipe_inputs(folder):
    """Whether there are the libraries that write them, which Debian's Python has."""
    script = pathlib.Path(__file__).with_name("recipe_inputs.py")
    return subprocess.run(["/usr/bin/python3", script, folder], check=False, capture_output=True).returncode == 0


def write_all(folder: pathlib.Path, tan, source: pathlib.Path):
    write_engine(folder, tan)
    write_grids(folder, tan)
    write_head(folder)
    write_quakes(folder)
    for name in ("bones.json", "stress.json"):
        shutil.copyfile(source / "docs/user/pictures/bluntfin-transfer.json", folder / name)
    (folder / "step1.tansession").write_text(
        '{"format": "tan-session", "version": 1, "model": {"path": "step1.tan"},'
        ' "isovalues": [{"value": 120, "colour": [1, 0.75, 0], "opacity": 1, "visible": true}]}')
    (folder / "view.json").write_text('{"azimuth": 30, "elevation": 20}')
    for name, words in (("c60.nrrd", ["sample", "c60", "--size", "24"]), ("c60.tan", ["build", "c60.nrrd"]),
                        ("step2.tan", ["build", "c60.nrrd"]),
                        ("engine.tan", ["build", "engine.nrrd"]), ("fin.tan", ["build", "bluntfinxyz.bin"]),
                        ("part.vtu", ["sample", "part", "--size", "12"]), ("part.tan", ["build", "part.vtu"])):
        subprocess.run([tan, *words, "-o", name], check=True, capture_output=True, cwd=folder)
