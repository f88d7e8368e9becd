#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""picture_files.py BUILD: pictures of `tan render` as PNG, TIFF, JPEG and PDF, judged by Pillow and by Poppler's programs: all hold the same
pixels, are as large in centimetres as they were asked to be; in a PDF file what is written over the picture is
text, in any script, and lies where the other formats have it. Exit code 77: something is missing."""
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

try:
    import numpy
    from PIL import Image
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)
for program in ("pdfinfo", "pdfimages", "pdftotext", "pdffonts", "pdftoppm"):
    if shutil.which(program) is None:
        print(f"skipped: no {program} of poppler-utils")
        sys.exit(77)

BUILD = pathlib.Path(sys.argv.pop(1)).resolve()
TAN = BUILD / "bin/tan"
TEXTS = ("--mode", "volume", "--colour-bar", "--axes", "--scale-bar", "--title", "Schädel – the head", "--bar-quantity", "Density",
         "--bar-unit", "HU", "--bar-numbers", "plain:2")


def output(*words, folder=None):
    return subprocess.run([*map(str, words)], cwd=folder, capture_output=True, text=True, check=True).stdout


class PictureFiles(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.kept = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.kept.name)
        cls.tan("sample", "c60", "--size", "16", "-o", "c60.nrrd")
        cls.tan("build", "c60.nrrd", "-o", "c60.tan")

    @classmethod
    def tearDownClass(cls):
        cls.kept.cleanup()

    @classmethod
    def tan(cls, *words, code=0):
        done = subprocess.run([str(TAN), *map(str, words)], cwd=cls.folder, capture_output=True, text=True, check=False)
        assert done.returncode == code, f"{words}: {done.returncode} {done.stdout}{done.stderr}"
        return done.stdout + done.stderr if code else done.stdout

    def drawn(self, name, *options, size="320x240"):
        self.tan("render", "c60.tan", "--size", size, *options, "-o", name)
        return self.folder / name

    def pixels(self, path, mode="RGB"):
        with Image.open(path) as picture:
            self.assertEqual(picture.mode, mode)
            return numpy.asarray(picture).astype(int)

    def pdf(self, program, path, *options):
        return output(program, *options, path, *(["-"] if program == "pdftotext" else []), folder=self.folder)

    def test_all_formats_hold_the_same_pixels(self):
        png = self.pixels(self.drawn("a.png", *TEXTS))
        for ending in ("tif", "TIFF"):
            self.assertTrue((self.pixels(self.drawn(f"a.{ending}", *TEXTS)) == png).all())
        for ending in ("jpg", "jpeg"):
            away = numpy.abs(self.pixels(self.drawn(f"a.{ending}", *TEXTS)) - png)
            self.assertLess(away.mean(), 1.5)
            self.assertLess(away.max(), 60)
        with Image.open(self.folder / "a.jpg") as jpeg:
            self.assertEqual([layer[1:3] for layer in jpeg.layer], [(1, 1)] * 3)  # colours as fine as brightness
            self.assertLess(max(jpeg.quantization[0]), 13)  # quality 95

    def test_axes_with_numbers(self):
        """The sample goes from -8 to 8: what a reader of PDF finds are its coordinates, and larger letters are larger."""
        bounds = json.loads(self.tan("info", "c60.tan", "--json"))["bounds"]
        options = ("--box-axes", "--length-numbers", "plain:1", "--camera", "iso")
        words = {}
        for name, more in (("usual.pdf", ()), ("large.pdf", ("--text-size", "24", "--bold-text"))):
            box = self.pdf("pdftotext", self.drawn(name, *options, *more, size="1024x768"), "-bbox")
            found = re.findall(r'<word xMin="([0-9.]+)" yMin="([0-9.]+)" xMax="([0-9.]+)" yMax="([0-9.]+)">([^<]*)</word>', box)
            words[name] = [(text, float(bottom) - float(top)) for _, top, _, bottom, text in found]
            texts = [text for text, _ in words[name]]
            self.assertEqual(sorted(text for text in texts if text in "xyz"), ["x", "y", "z"])
            numbers = [text for text in texts if text not in "xyz"]
            self.assertGreaterEqual(len(numbers), 6, numbers)
            self.assertTrue(all(re.fullmatch(r"-?[0-9]+\.[0-9]", text) for text in numbers), numbers)
            least, most = min(map(float, numbers)), max(map(float, numbers))
            self.assertTrue(min(bounds[0]) <= least < most <= max(bounds[1]), (numbers, bounds))
        usual, large = (numpy.median([height for _, height in words[name]]) for name in ("usual.pdf", "large.pdf"))
        self.assertAlmostEqual(large / usual, 2, delta=0.1)
        self.assertIn("Bold", self.pdf("pdffonts", self.folder / "large.pdf"))
        self.assertNotIn("Bold", self.pdf("pdffonts", self.folder / "usual.pdf"))

    def test_transparency(self):
        options = ("--mode", "isosurface", "--background", "transparent", "--axes")
        png = self.pixels(self.drawn("t.png", *options), "RGBA")
        self.assertEqual(png[0, 0, 3], 0)
        self.assertTrue((self.pixels(self.drawn("t.tif", *options), "RGBA") == png).all())
        told = self.tan("render", "c60.tan", *options, "-o", "t.jpg", code=2)
        self.assertIn("JPEG pictures have no transparency", told)
        self.assertFalse((self.folder / "t.jpg").exists())
        pdf = self.drawn("t.pdf", *options)
        self.assertIn("smask", self.pdf("pdfimages", pdf, "-list"))

    def test_sizes_in_centimetres(self):
        for name in ("c.png", "c.tif", "c.jpg"):
            with Image.open(self.drawn(name, "--dpi", "254", size="4x3cm")) as picture:
                self.assertEqual(picture.size, (400, 300))
                for dpi in picture.info["dpi"]:
                    self.assertAlmostEqual(float(dpi), 254, delta=0.05)
        page = re.search(r"Page size: +([0-9.]+) x ([0-9.]+) pts", self.pdf("pdfinfo", self.drawn("c.pdf", size="4x3cm")))
        self.assertAlmostEqual(float(page[1]) / 72 * 2.54, 4, delta=0.02)
        self.assertAlmostEqual(float(page[2]) / 72 * 2.54, 3, delta=0.02)
        with Image.open(self.drawn("w.png", size="2.54cm")) as picture:  # the height keeps the usual ratio, at 300 dpi
            self.assertEqual(picture.size, (300, 225))
        with Image.open(self.drawn("n.png", size="640")) as picture:
            self.assertEqual(picture.size, (640, 480))
            self.assertNotIn("dpi", picture.info)
        for size in ("4x3in", "cm", "4x", "0cm", "1000cm", "4x3 cm", "1.5x3"):
            self.assertIn("does not fit '--size'", self.tan("render", "c60.tan", "--size", size, "-o", "no.png", code=2))
        self.assertIn("--dpi", self.tan("render", "c60.tan", "--dpi", "0", "-o", "no.png", code=2))

    def test_a_session_gives_its_ratio(self):
        session = {"format": "tan-session", "version": 1, "model": {"path": "c60.tan"}, "viewSize": [800, 400]}
        (self.folder / "wide.tansession").write_text(json.dumps(session))
        self.tan("render", "wide.tansession", "--size", "5.08cm", "--dpi", "100", "-o", "wide.png")
        with Image.open(self.folder / "wide.png") as picture:
            self.assertEqual(picture.size, (200, 100))

    def test_texts_of_a_pdf_are_text(self):
        pdf = self.drawn("x.pdf", *TEXTS)
        text = self.pdf("pdftotext", pdf, "-layout")
        for word in ("Schädel – the head", "Density (HU)", "units at the target", "x", "y", "z", ".00"):
            self.assertIn(word, text)
        fonts = self.pdf("pdffonts", pdf).splitlines()[2:]
        self.assertGreaterEqual(len(fonts), 2)  # one of them is the title's bold
        for font in fonts:
            self.assertRegex(font, r"yes +yes +yes")  # in the file, a part of it, with its characters
        images = self.pdf("pdfimages", pdf, "-list").splitlines()[2:]
        self.assertEqual([line.split()[3:5] for line in images if line.split()[2] == "image"], [["320", "240"]])

    def test_texts_of_any_script(self):
        for title in ("κεφαλή", "голова", "שלום עולם", "office AVATAR fi"):
            pdf = self.drawn("s.pdf", "--title", title)
            text = self.pdf("pdftotext", pdf).translate({0x202a: None, 0x202b: None, 0x202c: None, 0x200e: None, 0x200f: None})
            self.assertIn(title, text)

    def test_a_pdf_looks_like_the_picture(self):
        png = self.pixels(self.drawn("l.png", *TEXTS, size="640x480"))
        bare = self.pixels(self.drawn("b.png", "--mode", "volume", size="640x480"))
        self.drawn("l.pdf", *TEXTS, "--dpi", "150", size="640x480")
        output("pdftoppm", "-r", "150", "-png", "-singlefile", "l.pdf", "seen", folder=self.folder)
        seen = self.pixels(self.folder / "seen.png")[:480, :640]
        away = numpy.abs(seen - png)
        written = numpy.abs(bare - png).max(axis=2) > 30
        self.assertGreater(written.sum(), 3000)
        self.assertLess(away.mean(), 2)
        self.assertLess(away[written].mean(), 25)  # letters are there, at the same places, if not with the same grey at their edges
        self.assertLess(away[written].mean(), numpy.abs(bare - png)[written].mean() / 3)
        # Without what is written over it the image is that of the other formats, bit for bit.
        output("pdfimages", "-png", "l.pdf", "kept", folder=self.folder)
        self.assertTrue((self.pixels(self.folder / "kept-000.png") == bare).all())

    def test_wrong_use(self):
        for name in ("x.bmp", "x", "x.png.gz"):
            told = self.tan("render", "c60.tan", "-o", name, code=2)
            self.assertIn("does not end in .png, .tif, .tiff, .jpg, .jpeg or .pdf", told)
        self.assertIn(".png", self.tan("render", "c60.tan", "--depth", "d.tif", "-o", "x.tif", code=2))
        self.tan("render", "c60.tan", "-o", "no/such/x.pdf", code=4)


unittest.main()
