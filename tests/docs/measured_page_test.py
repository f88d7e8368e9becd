#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""measured_page_test.py SOURCE DRAWER: the page of what was measured, from results of a trial that are kept beside this test
(`./dev bench all --trial` makes them; those of the window are written here): its plots are sound, its numbers are those of the results, and what is missing or broken is said."""
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from xml.etree import ElementTree

SOURCE = pathlib.Path(sys.argv.pop(1)).resolve()
DRAWER = sys.argv.pop(1)
RESULTS = SOURCE / "tests/docs/trial_results"
SVG = "{http://www.w3.org/2000/svg}"


class Making(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.folder = pathlib.Path(place.name)
        self.results, self.page = self.folder / "results", self.folder / "measured.md"
        shutil.copytree(RESULTS, self.results)
        self.write_interaction()

    def write_interaction(self):
        result = json.loads((self.results / "threads.json").read_text(encoding="utf-8"))
        edit = {"seconds": 0.04, "worst_seconds": 0.09}
        result.update(step="interaction", report={"cases": [
            {"case": "c60 18^3, 1 %, 2 threads, median frame", "seconds": 0.02, "frames_per_second": 45.5, "share_in_budget": 0.99,
             "full_picture_seconds": 0.3},
            {"case": "c60 18^3, edit to picture while dragging", **edit},
            {"case": "c60 18^3, edit to first picture, one at a time", **edit}]})
        (self.results / "interaction.json").write_text(json.dumps(result), encoding="utf-8")

    def make(self, *words):
        return subprocess.run([sys.executable, SOURCE / "tests/bench/page/make_page.py", self.results, self.page, self.folder / "plots",
                               "--drawer", DRAWER, *words],
                              capture_output=True, text=True, check=False)

    def text(self, *words):
        run = self.make(*words)
        self.assertEqual(run.returncode, 0, run.stderr)
        return self.page.read_text(encoding="utf-8")

    def change(self, step, change):
        path = self.results / f"{step}.json"
        result = json.loads(path.read_text(encoding="utf-8"))
        change(result)
        path.write_text(json.dumps(result), encoding="utf-8")

    def change_case(self, step, name, **values):
        def change(result):
            cases = [case for case in result["report"]["cases"] if case["case"] == name]
            self.assertEqual(len(cases), 1, name)
            cases[0].update(values)
        self.change(step, change)

    def change_all(self, change):
        for path in self.results.glob("*.json"):
            self.change(path.stem, change)

    def refused(self, *words):
        """The script says these words, ends with 1 and leaves an older page alone."""
        self.page.write_text("older", encoding="utf-8")
        run = self.make()
        self.assertEqual(run.returncode, 1)
        for word in words:
            self.assertIn(word, run.stderr)
        self.assertNotIn("Traceback", run.stderr)
        self.assertEqual(self.page.read_text(encoding="utf-8"), "older")
        self.assertFalse((self.folder / "plots").exists())


class Page(Making):
    def test_plots_are_sound_and_told_in_words(self):
        text = self.text()
        plots = sorted((self.folder / "plots").glob("*.svg"))
        self.assertGreater(len(plots), 15)
        self.assertEqual(sorted(re.findall(r"\]\((plots/[^)]+)\)", text)), [f"plots/{plot.name}" for plot in plots])
        for plot in plots:
            root = ElementTree.parse(plot).getroot()
            self.assertEqual(root.tag, SVG + "svg")
            self.assertEqual(root.get("role"), "img")
            self.assertTrue(root.find(SVG + "title").text, plot)
            self.assertRegex(root.find(SVG + "desc").text, r": .*\d.*Units?: \S", plot)
            self.assertIn("prefers-color-scheme: dark", root.find(SVG + "style").text)
            width, height = map(float, root.get("viewBox").split()[2:])
            for shape in [*root.iter(SVG + "polygon"), *root.iter(SVG + "polyline")]:
                for point in shape.get("points").split():
                    x, y = map(float, point.split(","))
                    self.assertTrue(0 <= x <= width and 0 <= y <= height, f"{plot}: {point}")
            self.assertNotRegex(plot.read_text(encoding="utf-8"), r"\b(nan|inf|None)\b")

    def bars(self, name):
        """Lengths and colours of a plot's bars, by the numbers behind them."""
        shapes = list(ElementTree.parse(self.folder / f"plots/{name}.svg").getroot())
        found = {}
        for bar, number in zip(shapes, shapes[1:]):
            if bar.tag == SVG + "polygon" and number.tag == SVG + "text":
                across = [float(point.split(",")[0]) for point in bar.get("points").split()]
                found[number.text] = (max(across) - min(across), bar.get("class"))
        return found

    def test_numbers_are_those_of_the_results(self):
        self.change_case("refinement", "c60 9^3 uint16 to error 0, one thread", ratio=0.12345)
        self.change_case("refinement-large", "c60 18^3 uint16 to error 0, one thread", ratio=7.7777)
        self.change_case("extraction", "c60 18^3 uint8, extraction at 1 %", share_of_copy_bandwidth=0.654321)
        text = self.text()
        self.assertIn("| 9^3, whole | 0.123 | at most 0.4 | yes |", text)
        self.assertIn("| 18^3, whole | 7.78 | at most 0.78 | **no** |", text)
        self.assertIn("| uint8, mesh of 1 % | 65.4 | at least 50 | yes |", text)
        missed = next(line for line in text.splitlines() if line.startswith("| [Refinement over CGAL's"))
        self.assertIn("18^3, whole: 7.78", missed)
        self.assertNotIn(" 9^3, whole", missed)
        plot = (self.folder / "plots/refinement.svg").read_text(encoding="utf-8")
        for words in ("9^3, whole: 0.123, asked for at most 0.4, reached", "18^3, whole: 7.78, asked for at most 0.78, missed",
                      ">≤ 0.78, missed<", ">0.123<"):
            self.assertIn(words, plot)
        bars = self.bars("refinement")
        self.assertAlmostEqual(bars["7.78"][0] / bars["0.123"][0], 7.7777 / 0.12345, delta=2)
        self.assertNotEqual(bars["7.78"][1], bars["0.123"][1])  # the colour of what misses

    def test_how_many_are_reached_is_counted(self):
        text = self.text()
        found = re.search(r"Of (\d+) figures that were asked for (\d+) are reached, (\d+) are not, and (\d+) were not measured", text)
        asked, reached, missed, unknown = map(int, found.groups())
        tables = text.partition("## The machine")[2]
        self.assertEqual(reached, tables.count("| yes |"))
        self.assertEqual(missed, tables.count("| **no** |"))
        self.assertEqual(asked, reached + missed + unknown)

    def test_the_run_names_machine_and_revision(self):
        def rename(result):
            result["run"].update(processor="A processor of 1997", cores=3, memory_bytes=5 * 2**30, compiler="a compiler", revision="abc123",
                                 changed=False, others_share=0.01, date="2001-02-03 04:05 UTC")
        self.change_all(rename)
        text = self.text()
        for words in ("A processor of 1997, 3 cores, 5 GiB", "a compiler", "abc123 |", "2001-02-03 04:05 UTC", "The machine was quiet"):
            self.assertIn(words, text)
        self.change("volume", lambda result: result["run"].update(others_share=0.4))
        self.assertIn("**The machine was not quiet** while these ran: volume.", self.text())

    def test_a_trial_says_that_it_means_nothing(self):
        self.assertIn("trial of tiny sizes", self.text())
        self.change_all(lambda result: result["run"].update(trial=False))
        self.assertNotIn("trial", self.text())

    def test_without_data_or_vtk_it_says_so(self):
        def take_away(result):
            result["available"].update({"Bucky": False, "VTK": False})
            if result["step"] == "decimation":
                result["report"]["cases"] = []
        self.change_all(take_away)
        self.change("decimation", lambda result: result["report"]["cases"].append({"case": "something else"}))
        text = self.text()
        self.assertIn("| Bucky 32^3 | not measured: no data (Bucky) | at most 1.5 |  |", text)
        self.assertIn("not measured: no VTK", text)
        self.assertNotIn("plots/projected.svg", text)

    def test_beside_vtk(self):
        def add_vtk(result):
            result["available"]["VTK"] = True
            cases = result["report"]["cases"]
            names = {"volume": ("vtkProjectedTetrahedraMapper", "vtkUnstructuredGridVolumeRayCastMapper"),
                     "surfaces": ("vtkContour3DLinearGrid", "vtkContour3DLinearGrid with scalar tree")}[result["step"]]
            result["report"]["cases"] = [{**case, "yardstick": name, "yardstick_seconds": 6.25 * case["seconds"], "times_faster": 6.25}
                                         if not case["case"].startswith("order") else case
                                         for case in cases for name in (names if not case["case"].startswith("order") else names[:1])]
        self.change("volume", add_vtk)
        self.change("surfaces", add_vtk)
        self.assertIn("| Marschner-Lobb 6^3, 32, 1 thread | 6.25 | at least 6.5 | **no** |", self.text())
        self.assertIn("VTK, projected", (self.folder / "plots/frames.svg").read_text(encoding="utf-8"))
        self.assertIn("6.25, asked for at least 9, missed", (self.folder / "plots/contour.svg").read_text(encoding="utf-8"))

    def test_without_the_papers_data_the_step_may_be_left_out(self):
        self.change("paper", lambda result: result.update(report=None))
        self.change_all(lambda result: result["available"].update(paper=False))
        self.assertIn("no data (paper)", self.text())


    def test_steps_that_are_left_out_are_said(self):
        (self.results / "interaction.json").unlink()
        text = self.text("--without", "interaction")
        self.assertIn("not measured: step interaction was left out", text)
        self.assertIn("| left out |", text)
        run = self.make("--without", "interactions")
        self.assertEqual(run.returncode, 2)
        self.assertIn("there is no step 'interactions'", run.stderr)


class Broken(Making):
    def test_a_missing_result(self):
        (self.results / "volume.json").unlink()
        (self.results / "extraction.json").unlink()
        self.refused("volume.json is missing", "./dev bench all --only volume", "extraction.json is missing")

    def test_half_a_result(self):
        path = self.results / "refinement.json"
        path.write_text(path.read_text(encoding="utf-8")[:300], encoding="utf-8")
        self.refused("refinement.json cannot be read", "./dev bench all --only refinement")

    def test_another_file(self):
        for content in ("[]", "3", "{}", '{"report": {"cases": [1]}}', '{"report": {"tables": [{}]}}'):
            (self.results / "threads.json").write_text(content, encoding="utf-8")
            self.refused("threads.json is not a result")

    def test_no_case_at_all(self):
        self.change("growth", lambda result: result["report"].update(cases=[]))
        self.refused("growth.json has no case")

    def test_a_case_that_is_gone_though_its_data_are_there(self):
        self.change_case("interaction", "c60 18^3, edit to picture while dragging", case="something else")
        self.refused("interaction.json has 0 cases 'c60 18^3, edit to picture while dragging'", "--only interaction")

    def test_a_number_that_is_none(self):
        for value in ("fast", None, True):
            self.change_case("threads", "c60 18^3 uint16 in blocks of 4 into a file, 2 threads", times_faster=value)
            self.refused("threads.json: the case", "has no number 'times_faster'")

    def test_two_machines_on_one_page(self):
        self.change("growth", lambda result: result["run"].update(processor="another one"))
        self.refused("not all measured alike", "another one")


unittest.main()
