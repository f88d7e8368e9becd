#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""gallery_test.py BUILD [--data FOLDER] [--only WORD] [--update]: makes every picture of docs/user/gallery.md by the commands that stand
there, in one folder, where each dataset and model is made once. Each picture shows something, and is that in docs/user/pictures within
LARGEST_DIFFERENCE and MOST_FAR; --update writes what was made there instead. Pictures of datasets that are not in FOLDER (../shared/data
beside the repository) are skipped, and told; exit code 77: all were. --only: those whose heading holds this word."""
import argparse
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import time
import zlib

from page_commands import commands_of

SOURCE = pathlib.Path(__file__).resolve().parents[2]
PAGE = SOURCE / "docs/user/gallery.md"
PICTURES = SOURCE / "docs/user/pictures"
SIZE = (480, 360)
LARGEST_DIFFERENCE = 3  # of 255: the mean over all pixels, in each channel
FAR = 40  # of 255: a pixel that is off by more in some channel is another one ...
MOST_FAR = 0.012  # ... of which there may be this share, for other fonts and roundings
MOST_BYTES = 1_500_000  # of all pictures together
SMALLEST_SHARE = 0.05  # of the pixels that are not of the background's colour, which is that in the corner
DATASET = re.compile(r"(?<![\w./-])([\w-]+\.(?:nrrd|nhdr|vti|vts|vtu|vtk|vtp|inp|csv|bin|xyz|ex2))\b")


# --- What the page shows -----------------------------------------------------------------------------------------------------------

class Section:
    def __init__(self, text):
        self.title = text.split("\n", 1)[0].strip()
        self.commands = commands_of(text)
        self.pictures = re.findall(r"\]\(pictures/(gallery-[\w-]+\.png)\)", text)

    def datasets(self):
        """The files that its commands read and none of them writes."""
        words = " ".join(self.commands)
        made = set(re.findall(r"-o (\S+)", words))
        return {name for name in DATASET.findall(words) if name not in made}


def sections_of(text):
    return [section for section in map(Section, text.split("\n## ")[1:]) if section.pictures]


# --- Pictures ----------------------------------------------------------------------------------------------------------------------

def unfiltered(rows, stride, step):
    """The bytes of each row, which PNG keeps as differences from those to the left and above (its specification, 9.2)."""
    above = bytes(stride + step)
    for at in range(0, len(rows), stride + 1):
        kind, row = rows[at], bytearray(step) + rows[at + 1:at + 1 + stride]
        if kind == 1:
            for i in range(step, len(row)):
                row[i] = (row[i] + row[i - step]) & 255
        elif kind == 2:
            for i in range(step, len(row)):
                row[i] = (row[i] + above[i]) & 255
        elif kind == 3:
            for i in range(step, len(row)):
                row[i] = (row[i] + (row[i - step] + above[i] >> 1)) & 255
        elif kind == 4:
            for i in range(step, len(row)):
                left, up, corner = row[i - step], above[i], above[i - step]
                far_left, far_up, far_corner = abs(up - corner), abs(left - corner), abs(left + up - 2 * corner)
                guess = left if far_left <= far_up and far_left <= far_corner else up if far_up <= far_corner else corner
                row[i] = (row[i] + guess) & 255
        above = row
        yield row[step:]


def read_png(path):
    """(width, height), and the pixels as one row of bytes for each of the three channels."""
    data, at, packed, header = path.read_bytes(), 8, b"", None
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body, at = data[at + 8:at + 8 + length], at + 12 + length
        header = body if kind == b"IHDR" else header
        packed += body if kind == b"IDAT" else b""
    width, height, bits, colours = struct.unpack(">IIBB", header[:10])
    assert bits == 8 and colours in (2, 6), f"{path.name}: {bits} bits, colour type {colours}"
    step = 3 if colours == 2 else 4
    pixels = b"".join(unfiltered(zlib.decompress(packed), step * width, step))
    return (width, height), [pixels[channel::step] for channel in range(3)]


def differences(ones, others):
    """The mean absolute difference of each channel."""
    return [sum(abs(a - b) for a, b in zip(one, other)) / len(one) for one, other in zip(ones, others)]


def share_far(ones, others):
    """Of the pixels, those that are off by more than FAR in some channel."""
    return sum(max(map(abs, map(int.__sub__, one, other))) > FAR for one, other in zip(zip(*ones), zip(*others))) / len(ones[0])


def share_shown(channels):
    background = tuple(channel[0] for channel in channels)
    return sum(pixel != background for pixel in zip(*channels)) / len(channels[0])


def faults_of(made, kept):
    if not made.exists():
        return ["no command makes it"]
    size, channels = read_png(made)
    faults = [] if size == SIZE else [f"it has {size[0]} x {size[1]} pixels"]
    if share_shown(channels) < SMALLEST_SHARE:
        faults.append("it shows next to nothing")
    if not kept.exists():
        return faults + [f"{kept.relative_to(SOURCE)} is not there"]
    if made.read_bytes() != kept.read_bytes():
        kept_size, kept_channels = read_png(kept)
        if kept_size != size:
            return faults + [f"{kept.relative_to(SOURCE)} has {kept_size[0]} x {kept_size[1]} pixels"]
        means, far = differences(channels, kept_channels), share_far(channels, kept_channels)
        if max(means) > LARGEST_DIFFERENCE or far > MOST_FAR:
            faults.append(f"it is off {kept.relative_to(SOURCE)} by " + ", ".join(f"{mean:.2f}" for mean in means)
                          + f" in red, green, blue, and by more than {FAR} in {100 * far:.2f} % of the pixels")
    return faults


def check_own_reading():
    """Of rows of every filter, told by hand: a pixel of three bytes in each of five rows of two."""
    rows = (bytes([0, 1, 2, 3, 4, 5, 6]) + bytes([1, 1, 2, 3, 1, 1, 1]) + bytes([2, 1, 1, 1, 255, 0, 1]) + bytes([3, 1, 1, 1, 1, 1, 1])
            + bytes([4, 1, 1, 1, 1, 1, 1]))
    assert [list(row) for row in unfiltered(rows, 6, 3)] == [
        [1, 2, 3, 4, 5, 6], [1, 2, 3, 2, 3, 4], [2, 3, 4, 1, 3, 5], [2, 2, 3, 2, 3, 5], [3, 3, 4, 4, 4, 6]]
    assert differences([b"\0\4", b"\0\0"], [b"\2\0", b"\0\0"]) == [3, 0]
    assert share_far([b"\0\4", b"\x30\0"], [b"\2\0", b"\0\0"]) == 0.5


# --- Making them -------------------------------------------------------------------------------------------------------------------

class Maker:
    def __init__(self, build, data, folder):
        self.build, self.folder, self.done = build, folder, set()
        for file in [*data.glob("*/*"), *PICTURES.glob("*.json")]:
            if file.is_file() and file.parent.name != "corpus":
                (folder / file.name).symlink_to(file)

    def missing(self, section):
        return sorted(name for name in section.datasets() if not (self.folder / name).exists())

    def run(self, section):
        """What went wrong. Datasets and models that a section before has made are not made again."""
        for command in section.commands:
            if command in self.done:
                continue
            environment = {"PATH": f"{self.build}/bin:/usr/bin:/bin", "HOME": str(self.folder), "LANG": "C.UTF-8"}
            run = subprocess.run(["bash", "-c", command], cwd=self.folder, env=environment, capture_output=True, text=True,
                                 errors="replace", timeout=300, check=False, stdin=subprocess.DEVNULL)
            if run.returncode != 0:
                return [f"{command}\n  exit code {run.returncode}: {run.stderr[-600:]}"]
            if re.match(r"tan (sample|build) ", command):
                self.done.add(command)
        return []


def faults_of_page(sections):
    named = [picture for section in sections for picture in section.pictures]
    kept = sorted(PICTURES.glob("gallery-*.png"))
    faults = [f"{path.name} is not on the page" for path in kept if path.name not in named]
    faults += [f"{name} is on the page twice" for name in set(named) if named.count(name) > 1]
    if (size := sum(path.stat().st_size for path in kept)) > MOST_BYTES:
        faults.append(f"the pictures have {size} bytes, more than {MOST_BYTES}")
    return faults


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--data", type=pathlib.Path, default=SOURCE.parent / "shared/data")
    parser.add_argument("--only", default="")
    parser.add_argument("--update", action="store_true")
    options = parser.parse_args()
    sections = sections_of(PAGE.read_text(encoding="utf-8"))
    failures, made, begun = [], 0, time.monotonic()
    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place)
        maker = Maker(options.build.resolve(), options.data.resolve(), folder)
        for section in sections:
            if options.only.lower() not in section.title.lower():
                continue
            if missing := maker.missing(section):
                print(f"skipped: {section.title}: without {', '.join(missing)}")
                continue
            section_begun = time.monotonic()
            faults = maker.run(section)
            for picture in [] if faults else section.pictures:
                if options.update and (folder / picture).exists():
                    shutil.copyfile(folder / picture, PICTURES / picture)
                faults += [f"{picture}: {fault}" for fault in faults_of(folder / picture, PICTURES / picture)]
                made += 1
            print(f"{section.title}: {time.monotonic() - section_begun:.1f} s")
            failures += [f"{section.title}: {fault}" for fault in faults]
    failures += faults_of_page(sections)
    print(f"{made} pictures made in {time.monotonic() - begun:.0f} s, {len(failures)} failures")
    print("\n".join(failures))
    return 1 if failures else 0 if made else 77


check_own_reading()
if __name__ == "__main__":
    sys.exit(main())
