#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""pictures_test.py FOLDER: pictures as arrays, judged by the outlines of a ball and a box in closed form; views as values."""
import json
import struct
import unittest
import warnings
import zlib

from module import ModuleTest, lattice, np, placed, tan

BARE = {"colour_bar": False, "axes": False}


def seen(pixels):
    """Where the surface is, which is of bone; lines are grey."""
    return pixels[..., 0].astype(int) > pixels[..., 2] + 10


def png_pixels(data):
    """The pixels of a PNG of 8 bits with four channels, and its texts: by the format's own description."""
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    at, packed, texts, size = 8, b"", [], None
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            size = struct.unpack(">II", body[:8])
        packed += body if kind == b"IDAT" else b""
        texts += [body.split(b"\0")[0]] if kind in (b"tEXt", b"iTXt", b"zTXt") else []
        at += length + 12
    width, height = size
    rows = np.frombuffer(zlib.decompress(packed), "u1").reshape(height, -1)
    channels = (rows.shape[1] - 1) // width
    pixels, above = np.zeros((height, width, channels), "u1"), np.zeros((width, channels), int)
    for y, row in enumerate(rows):
        line, filtered = np.zeros((width, channels), int), row[1:].reshape(width, channels).astype(int)
        for x in range(width):
            left, corner = (line[x - 1], above[x - 1]) if x else (0, 0)
            guess = left + above[x] - corner
            away = [np.abs(guess - part) for part in (left, above[x], corner)]
            paeth = np.where((away[0] <= away[1]) & (away[0] <= away[2]), left, np.where(away[1] <= away[2], above[x], corner))
            line[x] = (filtered[x] + (0, left, above[x], (left + above[x]) // 2, paeth)[row[0]]) % 256
        pixels[y], above = line, line
    return pixels, texts


class Pictures(ModuleTest):
    def bare(self, **look):
        return self.ball.render(**{"size": (240, 180), "samples": 1, "error": 1, "transparent": True, **BARE, **look})

    def test_axes_with_numbers(self):
        """They lie around the ball; twice as large letters cover more."""
        view = tan.View.from_text('{"camera": {"target": [0, 0, 0], "distance": 9.5}}')  # from afar: there is room
        still = {"size": (960, 720), "samples": 1, "error": 1, "transparent": True, **BARE}
        plain = self.ball.render(view, **still)
        covered = []
        for look in ({}, {"text_size": 20}):
            pixels = self.ball.render(view, **still, box_axes=True, **look)
            changed = (pixels != plain).any(axis=-1)
            self.assertFalse(changed[seen(plain)].any())
            covered.append(changed.sum())
        self.assertGreater(covered[0], 300)
        self.assertGreater(covered[1], 1.3 * covered[0])
        for wrong in (5.9, 48.1, float("nan")):
            with self.assertRaises(tan.WrongUsage):
                tan.View(text_size=wrong)

    def test_all_modes(self):
        modes = [mode for mode, _ in self.ball.modes()]
        self.assertEqual(set(modes) >= {"isosurface", "volume", "hybrid", "slice", "projection"}, True, modes)
        for mode in modes:
            pixels = self.bare(mode=mode, size=(64, 48))
            self.assertEqual((pixels.shape, pixels.dtype), ((48, 64, 4), np.dtype("u1")))
            self.assertGreater(pixels[..., 3].max(), 0, mode)
            self.assertEqual(pixels[0, 0, 3], 0, mode)

    def test_the_outline_of_a_ball(self):
        large, small = (self.bare(isovalues=[radius], perspective=False, elevation=0) for radius in (0.9, 0.45))
        self.assertAlmostEqual(seen(large).sum() / seen(small).sum(), 4, delta=0.25)
        rows, columns = np.nonzero(seen(large))
        self.assertAlmostEqual(seen(large).sum() / (np.pi / 4 * np.ptp(rows) * np.ptp(columns)), 1, delta=0.05)
        self.assertAlmostEqual(rows.mean(), 89.5, delta=1)
        self.assertAlmostEqual(columns.mean(), 119.5, delta=1)
        nearer = self.bare(isovalues=[0.45], perspective=False, elevation=0, zoom=2)
        self.assertAlmostEqual(seen(nearer).sum() / seen(small).sum(), 4, delta=0.25)

    def test_what_is_framed(self):
        """A small object in a corner of an empty room fills the picture; with axes at the room's box the room does."""
        places = np.indices((48, 40, 32)).T  # (z, y, x, the three coordinates)
        object = np.clip(3 * (1.25 - np.sqrt((((places - (34, 26, 12)) / (9, 4, 6)) ** 2).sum(axis=-1))), 0, 1)
        model = tan.build(object.astype("f4"), self.folder / "room.tan", error=2)
        for look in ({}, {"azimuth": 130, "elevation": 40}, {"mode": "volume"}):
            pixels = model.render(size=(240, 180), samples=1, transparent=True, settings={"outline": False}, **BARE, **look)
            rows, columns = np.nonzero(pixels[..., 3] > 24)  # the thin haze at its end may go on
            self.assertGreater(max(np.ptp(rows) / 180, np.ptp(columns) / 240), 0.75, look)
            self.assertTrue(0 < rows.min() and rows.max() < 179 and 0 < columns.min() and columns.max() < 239, look)
        far = model.render(size=(240, 180), samples=1, transparent=True, settings={"outline": False}, box_axes=True, **BARE)
        self.assertLess(seen(far).sum(), 0.2 * seen(model.render(size=(240, 180), samples=1, settings={"outline": False}, **BARE)).sum())

    def test_where_the_camera_is(self):
        # A quarter of the ball, seen along +y (azimuth 0): x grows to the right, and z upwards.
        window = tan.box((0, -1, 0), (1, 1, 1), border="clipped")
        rows, columns = np.nonzero(seen(self.bare(isovalues=[0.9], azimuth=0, elevation=0, window=window, perspective=False)))
        self.assertGreaterEqual(columns.min(), 119)
        self.assertLessEqual(rows.max(), 90)
        rows, columns = np.nonzero(seen(self.bare(isovalues=[0.9], azimuth=180, elevation=0, window=window, perspective=False)))
        self.assertLessEqual(columns.max(), 120)
        moved = self.bare(isovalues=[0.5], azimuth=0, elevation=0, perspective=False, target=(0.5, 0, 0))
        self.assertLess(np.nonzero(seen(moved))[1].mean(), 105)

    def test_colours(self):
        red = self.bare(isovalues=[(0.8, (1, 0, 0))])[90, 120]
        self.assertGreater(int(red[0]), 2 * int(red[2]) + 50)
        half = self.bare(isovalues=[(0.8, (1, 0, 0), 0.3)])[90, 120, 3]
        self.assertTrue(100 < half < 200, half)  # two walls: 1 - 0.7 * 0.7
        pixels = self.ball.render(size=(40, 30), background=(0, 0, 1), mode="isosurface", **BARE)
        self.assertEqual(pixels[0, 0].tolist(), [0, 0, 255, 255])
        one, other = (self.bare(mode="volume", transfer=name).astype(int) for name in ("viridis", "inferno"))
        np.testing.assert_array_equal(one[..., 3], other[..., 3])
        self.assertGreater(np.abs(one - other).max(), 50)
        blue = {"colours": [{"value": 0, "colour": [0, 0, 1]}], "opacities": [{"value": 0, "opacity": 0.5}], "unitDistance": 0.2}
        middle = self.bare(mode="volume", transfer=blue, size=(60, 60), settings={"shaded": False})[30, 30]
        self.assertGreater(int(middle[2]), int(middle[0]) + 100)

    def test_settings(self):
        usual = self.ball.settings("volume")
        self.assertIs(usual["shaded"], True)
        self.assertNotIn("shaded", self.ball.settings("isosurface"))
        view = tan.View(mode="volume", transfer="viridis")
        lit, unlit = (self.ball.render(view, size=(40, 30), settings={"shaded": shaded}, **BARE) for shaded in (True, False))
        self.assertTrue((lit != unlit).any())
        for wrong, says in (({"shaddded": True}, "has no setting 'shaddded'. It has: "), ({"shaded": 1}, "is True or False"),
                            ({"shaded": "no"}, "is True or False")):
            with self.assertRaisesRegex(tan.WrongUsage, says):
                self.ball.render(view, size=(40, 30), settings=wrong)
        with self.assertRaisesRegex(tan.WrongUsage, "The mode 'isosurface' has no setting 'shaded'"):
            self.ball.render(mode="isosurface", size=(40, 30), settings={"shaded": True})
        # What was said of another mode stays in the view and is no mistake.
        both = tan.View(mode="volume", settings={"shaded": False})
        self.ball.render(both.changed(mode="isosurface"), size=(40, 30), **BARE)
        np.testing.assert_array_equal(self.ball.render(both.changed(mode="isosurface").changed(mode="volume"), size=(40, 30), **BARE),
                                      self.ball.render(both, size=(40, 30), **BARE))
        # A whole number is a number, too, and as wrong as another where it is too large.
        numbers = [(mode, name) for mode, _ in self.ball.modes() for name, value in self.ball.settings(mode).items()
                   if type(value) is float and value == int(value)]
        self.assertTrue(numbers)
        mode, name = numbers[0]
        self.ball.render(mode=mode, size=(20, 15), settings={name: int(self.ball.settings(mode)[name])})
        with self.assertRaisesRegex(tan.WrongUsage, f"The setting '{name}' is from .* to .*, not 1e.300"):
            self.ball.render(mode=mode, size=(20, 15), settings={name: 1e300})

    def test_surfaces_that_are_not_there(self):
        with self.assertWarnsRegex(UserWarning, "The surface of 99 is empty: the data lie between 0 and "):
            pixels = self.bare(isovalues=[99], mode="isosurface")
        self.assertFalse(seen(pixels).any())
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self.bare(isovalues=[0.5], mode="isosurface")
            self.bare(isovalues=[99], mode="volume")  # which has no surfaces

    def test_views_are_values(self):
        view = tan.View(mode="volume", azimuth=60)
        other = view.changed(azimuth=70, error=2)
        self.assertEqual((view.mode, json.loads(view.text)["camera"]["azimuth"], json.loads(other.text)["camera"]["azimuth"]), ("volume", 60, 70))
        self.assertEqual(view, tan.View(mode="volume", azimuth=60))
        self.assertNotEqual(view, other)
        first = self.ball.view(size=(120, 90), **BARE)
        self.assertEqual(tan.View.from_text(first.text), first)
        self.assertEqual(set(json.loads(first.text)) >= {"mesh", "look", "camera", "isovalues", "annotations"}, True)
        np.testing.assert_array_equal(self.ball.render(first, size=(120, 90)), self.ball.render(size=(120, 90), **BARE))

    def test_kept_views(self):
        look = {"mode": "volume", "azimuth": 75, "transfer": "cividis", "error": 3, **BARE}
        pixels = self.ball.render(size=(80, 60), samples=1, **look)
        self.ball.save_session(self.folder / "a.tansession", size=(80, 60), **look)
        self.ball.save_picture(self.folder / "a.png", size=(80, 60), samples=1, **look)
        for name in ("a.tansession", "a.png"):
            view, differences = self.ball.kept_view(self.folder / name)
            self.assertEqual((view.mode, differences), ("volume", []))
            np.testing.assert_array_equal(self.ball.render(view, size=(80, 60), samples=1), pixels)
        text = json.loads((self.folder / "a.tansession").read_text())
        text["views"] = [{"name": "above", "look": {"mode": "isosurface"}, "camera": {"elevation": 80}}]
        (self.folder / "c.tansession").write_text(json.dumps(text))
        bookmarks = self.ball.kept_view(self.folder / "c.tansession")[0].bookmarks
        self.assertEqual([(name, view.mode, json.loads(view.text)["camera"]["elevation"]) for name, view in bookmarks.items()], [("above", "isosurface", 80)])
        self.assertEqual(tan.View().bookmarks, {})
        self.assertRaises(tan.WrongUsage, lambda: tan.View.from_text('{"views": [3]}').bookmarks)
        self.ball.save_picture(self.folder / "b.png", size=(80, 60), samples=1, transparent=True, **look)
        stored, texts = png_pixels((self.folder / "b.png").read_bytes())
        np.testing.assert_array_equal(stored, self.ball.render(size=(80, 60), samples=1, transparent=True, **look))
        self.assertIn(b"Software", texts)

    def test_a_focus(self):
        x, y, z = lattice(25)
        model = tan.build(np.sin(9 * x) * np.cos(7 * y) * np.sin(8 * z + x), self.folder / "waves.tan", **placed(25))
        ball, box = tan.sphere((0.4, 0, 0), 0.4, error=0.2, falloff=0.1), tan.box((-1, -1, -1), (-0.5, 1, 0), error=0.2, falloff=0.1)

        def drawn(**look):
            return model.render(size=(160, 120), samples=1, isovalues=[0.3], **BARE, **look).astype(int)

        def far(one, other):
            return np.abs(one - other).mean()

        coarse, fine = drawn(error=30), drawn(error=0.2)
        for focus in (ball, box, [ball, box], [box, ball], [tan.sphere((0, 0, 0), 1, error=0.2)]):
            pixels = drawn(error=30, focus=focus)
            self.assertGreater(far(pixels, coarse), 0.3)
            self.assertLess(far(pixels, fine), far(coarse, fine))
            model.save_picture(self.folder / "focus.png", size=(160, 120), samples=1, error=30, focus=focus, isovalues=[0.3], **BARE)
            view, differences = model.kept_view(self.folder / "focus.png")
            self.assertEqual(differences, [])
            np.testing.assert_array_equal(model.render(view, size=(160, 120), samples=1), pixels)
        # A ball that has all of the domain in it is no focus but the error.
        np.testing.assert_array_equal(drawn(error=30, focus=tan.sphere((0, 0, 0), 3, error=0.2)), fine)
        np.testing.assert_array_equal(drawn(view=tan.View(error=30, focus=ball).changed(focus=[])), coarse)
        away = tan.sphere((2, 0, 0), 1.5, error=0.2)
        for draw in (model.render, model.view, lambda **look: model.save_session(self.folder / "away.tansession", **look),
                     lambda **look: model.save_picture(self.folder / "away.png", **look)):
            self.refused(ValueError, "bounds", draw, focus=away)
        for focus in (tan.sphere((0, 0, 0), 1), tan.box((1, 0, 0), (0, 1, 1), error=1), [ball, tan.sphere((0, 0, 0), 1, error=1)], [ball] * 17):
            self.refused(ValueError, ".", tan.View, focus=focus)
        for focus in (3, "ball", [ball, 3], tan.half_space((1, 0, 0), 0, error=1), {"sphere": 1}):
            self.refused(TypeError, "sphere", tan.View, focus=focus)

    def test_a_film(self):
        first, half = (self.bare(frame=frame, isovalues=[0.8], azimuth=0) for frame in (0, 60))
        turned = self.bare(isovalues=[0.8], azimuth=180)
        np.testing.assert_array_equal(first, self.bare(isovalues=[0.8], azimuth=0))
        self.assertLess(np.abs(half.astype(int) - turned).mean(), np.abs(half.astype(int) - first).mean() + 1)
        self.refused(ValueError, "frame", self.bare, frame=-1)

    def test_the_notebook(self):
        page = self.ball._repr_html_()
        self.assertIn("data:image/png;base64,", page)
        self.assertIn("<polyline", page)
        self.assertIn("distance", page)
        named = tan.build(self.distances, self.folder / "named.tan", name="<b>&", **{"spacing": (1, 1, 1)})
        self.assertIn("&lt;b&gt;&amp;", named._repr_html_())

    def test_wrong_looks(self):
        nan = float("nan")
        for keywords in ({"mode": "none"}, {"size": (0, 4)}, {"size": (10**6, 10**6)}, {"samples": 9}, {"samples": 0}, {"threads": -1},
                         {"backend": "none"}, {"azimuth": nan}, {"isovalues": [nan]}, {"isovalues": [(1, (2, 0, 0))]}, {"zoom": 0},
                         {"isovalues": [(1, (1, 0, 0), 2)]}, {"transfer": "none"}, {"transfer": {}}, {"transfer": {"colours": 3}},
                         {"background": (1, 1)}, {"up": "w"}, {"error": -1}, {"error": nan}, {"budget": 0}, {"frame": 10**6}):
            self.refused(ValueError, ".", self.bare, **keywords)
        for keywords in ({"mode": 3}, {"size": 3}, {"size": ("a", "b")}, {"nothing": 1}, {"isovalues": "a"}, {"transfer": 3}, {"view": 3},
                         {"settings": 3}, {"window": 3}, {"azimuth": "a"}):
            self.refused(TypeError, ".", self.bare, **keywords)
        self.refused(ValueError, "JSON", tan.View.from_text, "[")
        self.refused(ValueError, ".", self.ball.render, tan.View.from_text('{"camera": 3}'))
        self.refused(OSError, "nowhere", self.ball.save_picture, self.folder / "nowhere" / "a.png", size=(20, 20))
        self.refused(ValueError, r"\.png", self.ball.save_picture, self.folder / "a.jpg", size=(20, 20))
        self.refused(OSError, "none", self.ball.kept_view, self.folder / "none.png")


if __name__ == "__main__":
    unittest.main()
