#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""wrong_use_test.py FOLDER [CALLS [SEED]]: random wrong calls of everything public of the module tan: numbers, texts, arrays, paths and objects
that do not fit. Each is refused by an exception with a sentence, and none crashes, hangs, takes all memory or is taken silently. Calls are
expressions, so that what fails can be tried by hand; they are made in a process of its own, which is started again after a crash. ./dev soak
(TAN_SOAK) makes more calls, each time others."""
import decimal
import faulthandler
import fractions
import json
import os
import pathlib
import random
import resource
import subprocess
import sys
import tempfile
import unittest
import warnings

from module import FOLDER, SANITIZED, lattice, np, placed, tan

SOAK = os.environ.get("TAN_SOAK")
CHILD = sys.argv.pop(1) if len(sys.argv) > 1 and sys.argv[1] == "--child" else None
CALLS = int(sys.argv.pop(1)) if len(sys.argv) > 1 and sys.argv[1].isdigit() else 8000 if SOAK else 500
SEED = int(sys.argv.pop(1)) if len(sys.argv) > 1 and sys.argv[1].isdigit() else int(SOAK or 20261130)
BATCH = 125
SECONDS, BYTES = 200 if SANITIZED else 20, 6 << 30  # for a call, and for the address space of a process
ALLOWED = (tan.Error, TypeError, ValueError, OverflowError, MemoryError, OSError)
# What a sentence never has: C++, and what Python says of a slip in the module itself.
UNSPEAKABLE = ("incompatible function arguments", "std::", "tetra::", "pybind", "unknown exception", "_tan.", "bad_alloc", "terminate", "report this")
LONGEST = 9000  # characters: a path of 5000 may be in it

# Values by what they are: expressions in the names that world() makes.
NOTHING = ["None"]
TEXTS = ["'1'", "''", "'nothing'"]
BYTES_OBJECTS = ["b'1'", "bytearray(b'1')", "memoryview(b'123')"]
OBJECTS = ["object()", "{}", "{'a': 1}", "int", "len", "(part for part in (1, 2, 3))", "Ellipsis", "NotImplemented", "np", "tan"]
OURS = ["m", "mesh", "surface", "view", "data", "tan.sphere((0, 0, 0), 1)", "verdict", "ended", "tan.Error('a')", "tan.Mesh", "size"]
NOT_NUMBERS = ["float('nan')", "float('inf')", "-float('inf')", "np.float32('nan')", "10**400", "Decimal('nan')"]
NO_NUMBERS = ["1j", "np.complex128(1 + 2j)", "np.array(1 + 2j)", "np.array('1')", "np.array(b'1')", "np.array(['1'])", "np.array([1.0, 2.0])",
              "np.array([])", "np.datetime64('2026-01-01')", "np.timedelta64(3)", "np.zeros(1, 'i4,f8')[0]", "[1]", "(1,)", "{1}", "[[]]",
              "np.array([object()])", "range(3)"]
TRUTHS = ["True", "False", "np.bool_(True)"]
FALSE_NUMBERS = TEXTS + BYTES_OBJECTS + OBJECTS + OURS + NOT_NUMBERS + NO_NUMBERS + TRUTHS + NOTHING
STRANGE_NUMBERS = ["-0.0", "1e308", "5e-324", "2**63", "np.float16(1)", "np.array(1.0)", "Fraction(1, 3)", "Decimal('0.5')", "np.longdouble(1)",
                   "np.uint64(2**64 - 1)", "np.int8(1)", "0", "np.ma.masked"]
NEGATIVE = ["-1", "-1e-300", "-1e308", "-2**63", "np.float32(-1)", "np.int8(-1)", "Fraction(-1, 3)"]
NO_VECTORS = (TEXTS + BYTES_OBJECTS[:2] + OBJECTS + OURS + NOTHING +
              ["3", "'xyz'", "b'abc'", "bytearray(b'abc')", "(1, 2)", "(1, 2, 3, 4)", "[]", "(float('nan'), 0, 0)", "(0, float('inf'), 0)",
               "('1', '2', '3')", "(None, None, None)", "((1, 2, 3),) * 3", "np.zeros((3, 3))", "np.zeros((3, 1))", "np.zeros(2)", "np.array(1.0)",
               "np.array([1j, 0, 0])", "np.array(['1', '2', '3'])", "np.zeros(3, 'i4,f8')", "{0: 1, 1: 2, 2: 3}", "{1, 2, 3}", "(True, 0, 0)",
               "np.array([1, 0, 0], bool)", "np.array([1, 0, 0], object) + 1j", "np.zeros(3, 'M8[s]')", "list", "np.ndarray", "'abc'"])
STRANGE_VECTORS = ["(1e308,) * 3", "(-1e308, 1e308, 0)", "(5e-324,) * 3", "(-0.0, 1, 1)", "np.ones(3, 'f2')", "np.ones(3, '>f8')", "np.ones(6)[::2]",
                   "(2**63,) * 3", "[0, 0, 0]", "range(1, 4)", "np.matrix([1, 2, 3]).A1", "(-1, -1, -1)", "np.ones(3, 'i1')"]
NO_TEXTS = BYTES_OBJECTS + OBJECTS + OURS + NO_NUMBERS + TRUTHS + ["3", "1.5", "['x']", "'\\ud800'", "'a\\udce9'"]
NO_PATHS = OBJECTS + BYTES_OBJECTS + NO_NUMBERS + TRUTHS + OURS + NOTHING + ["3", "''", "'a\\0b'", "pathlib.Path", "['ball.tan']", "b'ball.tan'",
                                                                             "Named(3)",
                                                                    "Named(b'x')", "Named('')", "os", "'a\\udce9.tan'"]
NO_FILES = ["'none.tan'", "'folder'", "'.'", "'text.txt'", "'empty.tan'", "'cut.tan'", "'changed.tan'", "'a' * 5000", "'folder/none/a.tan'", "'pipe'",
            "'ball.tan/'", "'text.txt/a'", "'~'", "'*'", "'ball.tan '", "pathlib.Path('none.tan')", "'loop'", "'/proc/self/mem'", "'http://'",
            "'http://127.0.0.1:1/a.tan'", "'tan+http://'", "'ftp://a/b'", "'https://[/a.tan'", "'http://127.0.0.1:99999/a.tan'", "'-'"]
NO_TARGETS = ["'folder'", "'.'", "'nowhere/a.tan'", "'text.txt/a.tan'", "'a' * 5000", "'ball.tan/'", "'loop/a'", "'text.txt'"]
DEEP = ["np.zeros(())", "np.zeros((0,) * 5)", "np.zeros((2,) * 5)", "np.zeros((2,) * 5)[::1, ::1]", "0", "1.5"]
NO_NUMBERS_IN = ["np.zeros({0}, complex)", "np.full({0}, None)", "np.zeros({0}, 'M8[s]')", "np.zeros({0}, 'm8[s]')", "np.zeros({0}, 'i4,f8')",
                 "np.full({0}, 'a')", "np.full({0}, b'1')", "np.zeros({0}, 'V8')"]
NO_ARRAYS = BYTES_OBJECTS[:2] + OBJECTS + [name for name in OURS if name != "size"] + NOTHING + DEEP + ["'abc'", "[[1], [1, 2]]", "{1, 2, 3}", "[]",
    "[[]]", "[None]"]
HUGE = "np.lib.stride_tricks.as_strided(np.zeros(1, 'u1'), {}, (0,) * len({}))"


def arrays(shape, wrong):
    """What is no array of numbers of this shape: of other types, or of the shapes that are wrong."""
    return NO_ARRAYS + [text.format(shape) for text in NO_NUMBERS_IN] + [f"np.zeros({other})" for other in wrong]


NO_VALUES = arrays((4, 4, 4), [(64,), (8, 8), (0, 4, 4), (1, 4, 4), (4, 4, 0), (2, 2, 2, 2)]) + [
    "np.zeros((4, 4, 4), np.longdouble)", "np.full((4, 4, 4), 2**60)", "np.full((4, 4, 4), np.nan)", "np.full((4, 4, 4), -np.inf, 'f2')",
    HUGE.format("(2**20,) * 3", "(2**20,) * 3"), HUGE.format("(2**12,) * 3", "(2**12,) * 3"), "np.ma.masked_all((4, 4, 4))", "'none.nrrd'"]
STRANGE_VALUES = ["ramp.astype('f2')", "ramp > 3", "ramp[::-1, :, ::-1]", "ramp.astype('>f4')", "ramp.astype('>i8')", "locked", "unaligned",
                  "np.array([-1e308, 1e308] * 32).reshape(4, 4, 4)", "np.full((4, 4, 4), 5e-324)", "np.where(ramp > 9, np.inf, ramp)",
                  "ramp.tolist()",
                  "np.zeros((2, 2, 2))", "np.full((4, 4, 4), 1.7e308)", "np.full((4, 4, 4), -0.0)", "np.broadcast_to(3, (4, 4, 4))",
                  "np.matrix(np.eye(4))", "np.full((4, 4, 4), 2**53)", "memoryview(ramp)", "np.where(ramp > 62, ramp, np.nan)"]


class Kind:
    """What a parameter takes: values that are right, some that are certainly wrong, and some that may be either."""

    def __init__(self, right, wrong, strange=()):
        self.right, self.wrong, self.strange = right, wrong, list(strange)

    def optional(self):
        return Kind(self.right, [value for value in self.wrong if value != "None"], self.strange)


def whole(right, wrong):
    numbers = [number for number in FALSE_NUMBERS if number != "range(3)"]
    return Kind(right, numbers + wrong + ["1.0", "1.5", "np.float64(1)", "Decimal(1)", "2**64", "-2**70", "np.array([1, 2])"],
                ["np.int8(1)", "np.array(1)"])


def words(*known):
    return Kind([repr(word) for word in known], NO_TEXTS + ["'magic'", "' '", "'x' * 99", "'a\\nb'"])


NO_TRUTHS = ["'yes'", "''", "b''", "[]", "{}", "object()", "2.5", "float('nan')", "3", "-1", "np.zeros(3)", "np.zeros(0)", "1j", "m", "int",
             "np.array('a')"]
MAPPINGS = [value for value in FALSE_NUMBERS + ["3", "[('a', 1)]"] if not value.startswith("{")]
KINDS = {
    "number": Kind(["0.5", "1", "0"], FALSE_NUMBERS, STRANGE_NUMBERS + NEGATIVE),
    "amount": Kind(["5", "2.5"], FALSE_NUMBERS + NEGATIVE, STRANGE_NUMBERS),
    "warping": Kind(["0"], FALSE_NUMBERS + NEGATIVE, STRANGE_NUMBERS),
    "finest": Kind(["0.5"], FALSE_NUMBERS + NEGATIVE, STRANGE_NUMBERS),
    "address": Kind(["'127.0.0.1'"], NO_TEXTS + NOTHING + ["''", "'a'", "'999.9.9.9'", "'127.0.0.1\\0'", "'x' * 5000"]),
    "zoom": Kind(["2"], FALSE_NUMBERS + NEGATIVE + ["0", "-0.0"], ["1e308", "5e-324"]),
    "budget": whole(["2000"], ["0", "-1"]), "port": whole(["0"], ["-1", "65536"]), "threads": whole(["1"], ["-1", "4097"]),
    "samples": whole(["1"], ["0", "5"]), "frame": whole(["3"], ["-1", "10**6"]),
    "block": whole(["4", "'none'"], ["0", "'some'", "2**32"]),
    "vector": Kind(["(0, 0, 0.5)", "[1, 0.5, 0.25]"], NO_VECTORS, STRANGE_VECTORS),
    "spacing": Kind(["(1, 1, 2)"], NO_VECTORS + ["(0, 1, 1)", "(1, -1, 1)", "(1e308,) * 3", "(5e-324,) * 3"], STRANGE_VECTORS),
    "normal": Kind(["(0, 0, 1)", "(1, 2, 3)"], NO_VECTORS + ["(0, 0, 0)", "(0.0, -0.0, 0)"], STRANGE_VECTORS),
    "at": Kind(["0.5", "(0, 0, 0.5)"], [value for value in NO_VECTORS if value not in ("3", "np.array(1.0)")] + NOT_NUMBERS, STRANGE_VECTORS +
        STRANGE_NUMBERS + NEGATIVE),
    "text": Kind(["'a'", "''", "'\\u00e4'"], NO_TEXTS + NOTHING, ["'x' * 5000", "'a\\0b'", "'a\\nb'"]),
    "axes": words("zyx"), "border": words("clipped", "contained"), "method": words("refinement"), "mesh_method": words("automatic", "closed-set"),
    "ordered_by": words("both", "error"), "order": words("exact"), "backend": words("cpu"), "up": words("x", "-z"), "mode": words("volume"),
    "place": Kind(["'ball.tan'", "pathlib.Path('ball.tan')"], NO_PATHS + NO_FILES),
    "kept": Kind(["'a.tansession'"], NO_PATHS + [name for name in NO_FILES if "changed" not in name] + ["'ball.tan'"]),
    "target": Kind(["'out.tan'"], NO_PATHS + NO_TARGETS, ["'out.tan\\n'", "'-o'"]),
    "written": Kind(["'out.file'"], NO_PATHS + [name for name in NO_TARGETS if name not in ("'text.txt'", "'ball.tan/'")], ["'-o'"]),
    "picture": Kind(["'out.png'"], NO_PATHS + NO_TARGETS + ["'out.jpg'", "'out'", "'png'"], ["'-o.png'", "'OUT.PNG'"]),
    "folder": Kind(["'folder'"], NO_PATHS + ["'text.txt'", "'none'", "'a' * 5000"]),
    "progress": Kind(["told"], ["3", "'x'", "b'x'", "{}", "[]", "object()", "1.5", "m", "mesh", "view", "np.zeros(3)", "True", "np"], ["len",
        "tan.box"]),
    "truth": Kind(["True", "False"], NO_TRUTHS, ["0", "1", "np.bool_(True)", "np.array(True)"]),
    "per_cell": Kind(["False"], NO_TRUTHS),
    "values": Kind(["ramp"], NO_VALUES, STRANGE_VALUES),
    "array": Kind(["ramp"], [value for value in NO_VALUES if value != "data"], STRANGE_VALUES),
    "mask": Kind(["ramp < 1"], arrays((4, 4, 4), [(4, 4), (4, 4, 3), (5, 4, 4), (64,)]) + ["ramp * 1.5", "np.ones((4, 4, 4), bool)"], ["ramp < 0"]),
    "directions": Kind(["np.eye(3)"], arrays((3, 3), [(3, 3), (3,), (2, 3), (4, 4)]) + ["np.full((3, 3), np.nan)", "np.eye(3) * 5",
        "np.ones((3, 3))"], ["-np.eye(3)", "np.eye(3).astype('f2')", "np.matrix(np.eye(3))", "np.eye(3)[::-1]"]),
    "coordinate": Kind(["np.arange(4.0)"], arrays((4,), [(3,), (0,), (4, 4), (4, 4, 3), (2, 2, 2, 2)]) + ["np.array([0, 1, np.nan, 3])", "'abcd'"],
        ["np.arange(4)[::-1]", "np.zeros(4)", "np.full(4, 1e308)", "range(4)", "np.arange(4) > 1", "np.arange(4, dtype='>f4')"]),
    "positions": Kind(["cloud"], arrays((30, 3), [(30, 2), (30,), (3, 30), (0, 3), (29, 3), (30, 3, 1)]) + ["np.full((30, 3), np.nan)",
        "np.full((30, 3), np.inf)", HUGE.format("(2**40, 3)", "(2**40, 3)"), "np.ma.masked_all((30, 3))"], ["np.zeros((30, 3))", "cloud * 1e308",
        "cloud * 1e-310", "cloud.astype('f2')", "cloud * [1, 1, 0]", "cloud[::-1]", "cloud.tolist()", "np.round(cloud)", "np.full((30, 3), -1e308)",
        "np.asfortranarray(cloud)", "cloud.astype('>f8')"]),
    "numbers": Kind(["cloud[:, 0]"], arrays((30,), [(29,), (30, 1), (0,), (1,), (30, 3)]) + ["np.full(30, 2**60 + 1)", "np.full(30, np.nan)"],
        ["np.full(30, 1e308)", "np.full(30, 5e-324)", "np.arange(30) > 3", "np.arange(30, dtype='>i2')", "np.zeros(30)", "np.arange(30).astype('f2')",
        "np.where(cloud[:, 0] > 0.5, np.inf, 1)", "np.resize([-1e308, 1e308], 30)"]),
    "hidden": Kind(["cloud[:, 1] < 0.1"], arrays((30,), [(29,), (30, 1)]) + ["cloud[:, 0]", "np.ones(30, bool)"]),
    "cells": Kind(["corners", "{'tetra': corners}", "[('tetra', corners)]"], arrays((5, 4), [(5, 4), (5, 3)]) + ["corners - 5", "corners + 15",
        "corners.astype(float)", "corners > 3", "corners[:, :3]", "corners[0]", "{'cube': corners}", "{1: corners}", "{'wedge': corners}",
        "{'\\ud800': corners}", "[('tetra',)]", "[('tetra', corners, 3)]", "[(1, corners)]", "{'tetra': None}", "corners * 0",
        "np.full((1, 4), 2**64 - 1, 'u8')", "np.zeros((0, 4), int)", "{'tetra': corners, 'voxel': corners}", "[('tetra', [[0, 1]])]", "'tetra'"],
        ["corners[:, ::-1]", "corners.astype('>i2')", "np.repeat(corners, 2, 0)", "corners.tolist()"]),
    "places": Kind(["[[0, 0, 0.1]]", "(0, 0, 0)"], arrays((2, 3), [(2, 2), (3, 2), (2, 4), (2,), (1, 2, 3), (0, 2)]) + ["'abc'", "[['1', '2', '3']]",
        HUGE.format("(2**40, 3)", "(2**40, 3)"), "[[None, 0, 0]]"], ["[[np.nan] * 3]", "[[1e308] * 3]", "np.zeros((0, 3))",
        "np.zeros((2, 3), '>f4')"]),
    "focus": Kind(["tan.sphere((0, 0, 0), 0.5, error=1)", "[tan.half_space((1, 0, 0), 0, error=1)]"], FALSE_NUMBERS[:6] + NOT_NUMBERS + TRUTHS + ["3",
        "object()", "m", "view", "[3]", "[None]", "tan.box", "tan.sphere((0, 0, 0), 1)", "[m]", "tan.Region(1.0, 0.0)",
        "tan.half_space((0, 0, 0), 1, error=1)", "tan.Sphere(1, 0, (0, 0, 'a'), 1)", "{tan.sphere((0, 0, 0), 1): 3}"],
        ["tan.sphere((1e308,) * 3, 1e308, error=0, falloff=1e308)", "[]", "tan.box((1, 1, 1), (0, 0, 0), error=1)", "()",
        "(tan.sphere((0, 0, 0), 1, error=1) for _ in range(3))", "[tan.sphere((0, 0, 0), 1, error=1)] * 2000"]),
    "looked_into": Kind(["tan.sphere((0, 0, 0), 0.5, error=1)", "[tan.box((-1, -1, -1), (0, 0, 0), error=1), tan.sphere((0, 0, 0), 0.5, error=1)]", "[]"],
        FALSE_NUMBERS[:6] + NOT_NUMBERS + TRUTHS + ["3", "object()", "m", "view", "[3]", "[None]", "tan.box", "tan.sphere((0, 0, 0), 1)", "[m]",
        "tan.Region(1.0, 0.0)", "tan.half_space((1, 0, 0), 0, error=1)", "{tan.sphere((0, 0, 0), 1): 3}", "[tan.sphere((0, 0, 0), 1, error=1)] * 17",
        "tan.box((1, 1, 1), (0, 0, 0), error=1)", "[tan.sphere((0, 0, 0), 1, error=e) for e in (1, 2)]"],
        ["tan.sphere((1e308,) * 3, 1e308, error=0, falloff=1e308)", "tan.sphere((0, 0, 0), 1e308, error=0, falloff=1e308)",
        "(tan.sphere((0, 0, 0), 1, error=1) for _ in range(3))", "tan.box((-1e308,) * 3, (1e308,) * 3, error=0)"]),
    "field": Kind(["'2'", "'sphere(0,0,0,0.5;0,5)'"], NO_TEXTS + TEXTS[1:] + ["'min(' * 10**5", "'-1'", "'nan'", "'1e999'", "'2,'", "'box(0,0,0)'",
        "'1\\0'", "'\\u0663'"]),
    "window": Kind(["tan.box((-1, -1, -1), (0, 0, 0))"], FALSE_NUMBERS[:6] + NO_VECTORS + ["tan.sphere((0, 0, 0), 1)", "((0, 0, 0), (1, 1, 1))",
        "tan.Box", "tan.box((1, 1, 1), (0, 0, 0))"], ["tan.box((-1e308,) * 3, (1e308,) * 3, border='clipped')", "tan.box((9, 9, 9), (10, 10, 10))"]),
    "ranges": Kind(["(0.5, 0.7)", "[(0.1, 0.2), (0.5, 0.6)]"], ["3", "'ab'", "b'ab'", "(1,)", "(1, 2, 3)", "(2, 1)", "(float('nan'), 1)",
        "(0, float('inf'))", "[(1, 2, 3)]", "[(2, 1)]", "{0.1: 1, 0.5: 2}", "{0.5, 0.7}", "object()", "m", "mesh", "('a', 'b')", "(None, 1)", "[[]]",
        "np.zeros((2, 2, 2))", "np.array(['a', 'b'])", "(True, 2)", "np.array([1j, 2])"], ["(-1e308, 1e308)", "[(0, 1)] * 2000", "[]",
        "np.array([[0, 1], [1, 2]])"]),
    "size": Kind(["(24, 18)", "[16, 16]"], NO_VECTORS[:3] + OBJECTS + NOTHING + ["3", "(1, 2, 3)", "(0, 4)", "(10**9, 10**9)", "(2**63, 1)",
        "('24', '18')", "(24.0, 18)", "(-1, 5)", "{24: 1, 18: 2}", "{24, 18}", "b'ab'", "bytearray(b'ab')", "m", "np.zeros((2, 2))",
        "np.array([24.5, 18])", "(True, 5)", "(32768, 32768)", "(None, 5)"], ["np.array([24, 18])", "(1, 1)", "range(20, 22)"]),
    "view": Kind(["view", "tan.View()"], FALSE_NUMBERS[:6] + ["3", "{}", "m", "'volume'", "tan.View", "view.text",
        "tan.View.from_text('{\"camera\": 3}')", "tan.View.from_text('{\"look\": []}')", "tan.View.from_text('[]')"],
        ["tan.View.from_text('{\"a\": [[[[]]]]}')", "tan.View.from_text('{\"isovalues\": [[]]}')"]),
    "view_text": Kind(["view.text", "'{}'"], NO_TEXTS + NOTHING + TEXTS + ["'['", "'[]'", "'3'", "'null'", "'[' * 10**5",
        "'{\"a\":' * 10**5", "'{\"a\": 1'", "view"]),
    "isovalues": Kind(["[0.5, 0.7]", "(0.5,)", "[(0.5, (1, 0, 0))]"], ["'a'", "b'ab'", "bytearray(b'ab')", "[None]", "['1']", "[float('nan')]",
        "[(1, 2)]", "[(1, (2, 0, 0))]", "[(1, (1, 0, 0), 2)]", "[(1, (1, 0, 0), 0)]", "[()]", "[(1, 2, 3, 4)]", "object()", "m", "{0.5: 1}", "1j",
        "[True]", "[m]", "np.array([1j])", "[(1, (-1, 0, 0))]", "[(1, 'red')]", "np.array(['a'])", "[{'value': 1}]", "{0.5, 0.7}"], ["0.5", "[]",
        "[1e308, -1e308]", "[0.5] * 200", "np.linspace(0, 1, 3)", "(part for part in (0.5, 1))", "np.array(0.5)"]),
    "transfer": Kind(["'viridis'"], ["3", "b'viridis'", "['viridis']", "'none'", "{}", "{'a': object()}", "{'points': 3}", "{'a': float('nan')}",
        "{1: 2, 'a': 3}", "m", "{'colours': []}", "object()", "1.5", "'\\ud800'", "{'a': b'x'}", "np.zeros((4, 4))", "{'format': 3}"]),
    "settings": Kind(["{}"], MAPPINGS, ["{'a': 1}", "{'a': float('inf')}", "{'a': None}", "{1: 2}", "{'a': {'b': []}}"]),
    "colour": Kind(["(1, 0.5, 0)"], NO_VECTORS + ["(2, 0, 0)", "(-0.1, 0, 0)", "'red'"]),
    "levels": Kind(["[10]", "(5, 0)"], ["3", "'10'", "b'10'", "[None]", "['1']", "[-1]", "[float('nan')]", "object()", "{10: 1}", "m", "[[1]]",
        "[True]", "[]", "np.array([1j])", "np.array(3)"], ["np.array([10.0])", "[1e308]", "(part for part in (10, 1))"]),
    "weights": Kind(["'point:1,1,1,2'", "['value:1,0.5']"], ["3", "b'x'", "[3]", "'point:1'", "'magic:3'", "['']", "object()", "{'point:1,1,1,2': 1}",
        "m", "0", "False", "'\\ud800'", "[None]", "'point:nan,1,1,1'", "1.5"]),
    "options": Kind(["{}"], MAPPINGS + ["{'a': 1}"]),
    "file_options": Kind(["{'stride': 1}"], MAPPINGS + ["{1: 2}", "{'none': 3}", "{'': 1}", "{'; ls': 1}", "{'stride': 'a\\0b'}", "{'stride': None}",
        "{'stride': object()}", "{None: 1}", "{'stride': -1}", "{'help': True}", "{'stride': [1]}", "{b'stride': 1}"]),
}

QUERY = {"error": "amount?", "budget": "budget?", "focus": "focus?", "window": "window?", "values": "ranges?", "method": "mesh_method",
         "progress": "progress?"}
NAMES = {"name": "text", "value_name": "text", "value_unit": "text", "length_unit": "text", "space": "text"}
LOOK = {"mode": "mode?", "isovalues": "isovalues?", "transfer": "transfer?", "azimuth": "number?", "elevation": "number?", "roll": "number?",
        "up": "up?",
        "perspective": "truth?", "zoom": "zoom?", "target": "vector?", "background": "colour?", "window": "window?", "settings": "settings?",
        "axes": "truth?", "box_axes": "truth?",
        "title": "truth?", "colour_bar": "truth?", "error": "amount?", "budget": "budget?", "focus": "looked_into?"}
DRAWN = {"transparent": "truth", "samples": "samples", "threads": "threads", "frame": "frame?", "backend": "backend", "progress": "progress?", **LOOK}
BUILT = {"error": "amount", "warping": "warping", "method": "method?", "block": "block?", "ordered_by": "ordered_by?", "weights": "weights?",
         "progress": "progress?"}
# Of each function its positional parameters and its keywords, with their kinds; "?" marks those that may be None.
FUNCTIONS = {
    "tan.open({})": (["place"], {"error": "amount?", "token": "text", "progress": "progress?"}),
    "tan.build({})": (["values", "target"], {**BUILT, **NAMES, "spacing": "spacing", "origin": "vector", "mask": "mask?", "axes": "axes",
                                             "options": "options?"}),
    "tan.build('ball.nrrd', {})": (["target"], {**{name: kind for name, kind in BUILT.items() if name not in ("warping", "ordered_by")},
                                                "options": "file_options?"}),
    "tan.build(tan.Points(cloud, cloud[:, 0]), {}, method='decimation')": (["target"], {"order": "order?", "finest": "finest?", "error": "amount"}),
    "tan.serve({}).stop()": (["folder"], {"port": "port", "address": "address"}),
    "tan.Lattice({}).range": (["array"], {"spacing": "spacing", "origin": "vector", "directions": "directions?", "mask": "mask?", "axes": "axes",
                                          **NAMES}),
    "tan.Grid({}).kind": (["coordinate", "coordinate", "coordinate", "array"], {"mask": "mask?", "axes": "axes", **NAMES}),
    "tan.Points({}).remarks": (["positions", "numbers"], {"mask": "hidden?", **NAMES}),
    "tan.Cells({}).range": (["positions", "cells", "numbers"], {"per_cell": "per_cell", **NAMES}),
    "tan.Lattice(ramp).dataset({})": ([], {"progress": "progress?"}),
    "tan.sphere({})": (["vector", "amount"], {"error": "amount?", "falloff": "amount"}),
    "tan.box({})": (["vector", "vector"], {"error": "amount?", "falloff": "amount", "border": "border"}),
    "tan.half_space({})": (["vector", "number"], {"error": "amount?", "falloff": "amount"}),
    "tan.Sphere({})": (["amount?", "amount", "vector", "amount"], {}),
    "tan.Box({})": (["amount?", "amount", "vector", "vector", "border"], {}),
    "tan.HalfSpace({})": (["amount?", "amount", "vector", "number"], {}),
    "tan.View({}).text": ([], {name: kind for name, kind in LOOK.items() if name not in ("mode", "transfer")}),
    "tan.View.from_text({}).text": (["view_text"], {}),
    "view.changed({}).text": ([], {name: kind for name, kind in LOOK.items() if name not in ("mode", "transfer")}),
    "m.size_at({})": ([], {"error": "amount", "warping": "amount?", "budget": "budget?"}),
    "m.mesh({})": ([], QUERY),
    "m.mesh(field={})": (["field"], {}),
    "m.mesh(absolute={})": (["amount?"], {}),
    "m.isosurface({})": (["number"], QUERY),
    "m.slice({})": (["normal", "at"], QUERY),
    "m.sample({})": (["places"], QUERY),
    "explored({})": ([], {name: kind for name, kind in QUERY.items() if name != "progress"}),
    "m.verify({})": (["values"], {"levels": "levels?", "spacing": "spacing", "progress": "progress?"}),
    "m.verify('ball.nrrd', {})": ([], {"levels": "levels?"}),
    "m.pack({})": (["target"], {"progress": "progress?"}),
    "m.save({})": (["target"], {"error": "amount?", "progress": "progress?"}),
    "m.view({})": ([], {"size": "size", **LOOK}),
    "m.kept_view({})": (["kept"], {}),
    "m.render({}, size=(24, 18), samples=1)": ([], {"view": "view?", **LOOK}),
    "m.render({}, size=(24, 18))": ([], DRAWN),
    "m.render({}, samples=1)": ([], {"size": "size"}),
    "m.save_picture({}, size=(24, 18))": (["picture"], {**DRAWN, "view": "view?"}),
    "m.save_session({})": (["written"], {**LOOK, "size": "size", "view": "view?"}),
    "mesh.sample({})": (["places"], {"progress": "progress?"}),
    "mesh.isosurface({})": (["number"], {"progress": "progress?"}),
    "mesh.slice({})": (["normal", "at"], {"progress": "progress?"}),
    "mesh.boundary({})": ([], {"feature_angle": "amount", "progress": "progress?"}),
}
# Calls that are wrong as they are: of what is used up, or of what only the module makes.
WHOLE_CALLS = ["ended.mesh(error=1)", "tan.Mesh(OTHER)", "tan.Surface(OTHER)", "tan.Model(OTHER)", "tan.Verdict(OTHER)", "tan.Explorer(OTHER, {})",
               "tan.Data().kind",
               "tan.Data().range", "tan.build(tan.Data(), 'out.tan')", "tan.Server([])", "hash(view)", "m.verify('ball.nrrd', spacing=(1, 1, 1))",
               "tan.View.from_text('{\"look\": 3}').mode", "tan.View.from_text('{\"look\": {\"transfer\": 3}}').transfer", "tan.View(camera=3)",
               "m.mesh(error=1, absolute=1)", "m.mesh(field='1', focus=tan.sphere((0, 0, 0), 1, error=1))", "m.mesh(warping=1)", "mesh.sample()",
               "tan.build('ball.nrrd', 'out.tan', spacing=(1, 1, 1))", "tan.build(data, 'out.tan', spacing=(1, 1, 1))", "m.verify(data, name='a')",
               "tan.build(ramp, 'out.tan', finest=1, method='refinement')", "tan.Region(1, 0).field(3)", "m.render(view, 3)", "tan.sphere(1)"]


class Named:
    """A path that is none."""

    def __init__(self, path):
        self.path = path

    def __fspath__(self):
        return self.path


def kind_of(name):
    return KINDS[name[:-1]].optional() if name.endswith("?") else KINDS[name]


def written(template, positional, keywords):
    given = ", ".join([*positional, *(f"{name}={value}" for name, value in keywords.items())])
    return template.replace("{}", given) if given else template.replace("{}, ", "").replace("{}", "")


def misshapen(random, template, positional, keywords):
    """Arguments too many, missing, or of no such name."""
    way = random.randrange(3) if "({" in template else 2
    if way == 0 and positional:
        del positional[-1]
    elif way == 1:
        positional += ["None"] * 9
    else:
        keywords[random.choice(["nothing", "eror", "self_", "_held", "Error"])] = "1"


def call_of(random, way=None):
    """A call as an expression, and whether it is certainly wrong; as `way` says, else by chance."""
    way = way or random.choices(["wrong", "strange", "misshapen", "whole"], [78, 12, 6, 4])[0]
    if way == "whole":
        return random.choice(WHOLE_CALLS).replace("OTHER", random.choice(["3", "None", "'ball.tan'", "{}", "view", "object()"])), True
    template, (positions, names) = random.choice(list(FUNCTIONS.items()))
    positional = [random.choice(kind_of(name).right) for name in positions]
    keywords = {name: random.choice(kind_of(names[name]).right) for name in random.sample(list(names), min(len(names), random.choice([0, 0, 1, 2])))}
    if way == "misshapen":
        misshapen(random, template, positional, keywords)
    elif way != "right":
        for _ in range(1 if way == "wrong" else random.randint(1, 3)):
            place = random.choice([*range(len(positions)), *names])
            kind = kind_of(positions[place] if isinstance(place, int) else names[place])
            chosen = kind.wrong if way == "wrong" else kind.strange or kind.right
            (positional if isinstance(place, int) else keywords)[place] = random.choice(chosen)
    return written(template, positional, keywords), way in ("wrong", "misshapen")


def world():
    """What the expressions speak of: a model, what it gives, arrays, and files, in the folder that is the current one."""
    x, y, z = lattice(12)
    m = tan.build(np.sqrt(x * x + y * y + z * z), "ball.tan", name="ball", **placed(12))
    with m.explore() as ended:
        pass

    def explored(**usual):
        with m.explore(**usual) as explorer:
            return explorer.mesh()

    ramp = np.arange(64, dtype="f4").reshape(4, 4, 4)
    locked, unaligned = ramp.copy(), np.frombuffer(bytes(1 + ramp.nbytes), "u1")[1:].view("f4").reshape(4, 4, 4)
    locked.flags.writeable = False
    # Corners of tetrahedra beside each other, not quite regular.
    cloud = np.resize([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], (30, 3)) + 3 * np.arange(30)[:, None] // 4 + np.random.default_rng(1).random((30,
        3)) / 5
    view, mesh = tan.View(mode="slice"), m.mesh(error=5)
    return {"np": np, "tan": tan, "os": os, "pathlib": pathlib, "Decimal": decimal.Decimal, "Fraction": fractions.Fraction, "Named": Named, "m": m,
            "mesh": mesh, "surface": mesh.isosurface(0.7), "view": view, "data": tan.Lattice(ramp), "verdict": m.verify(tan.Lattice(
                np.sqrt(x * x + y * y + z * z), **placed(12)), levels=[10]), "ended": ended, "size": m.size_at(), "ramp": ramp, "locked": locked,
            "unaligned": unaligned, "cloud": cloud, "corners": np.arange(20).reshape(5, 4),
            "explored": explored, "told": lambda fraction, text: None}


def make_files(model):
    """Files that are no models, and those that the right calls read."""
    whole = pathlib.Path("ball.tan").read_bytes()
    for name, content in {"text.txt": b"text", "empty.tan": b"", "cut.tan": whole[:len(whole) // 3], "changed.tan": bytes(64) + whole[64:]}.items():
        pathlib.Path(name).write_bytes(content)
    pathlib.Path("ball.nrrd").write_bytes(b"NRRD0004\ntype: uchar\ndimension: 3\nsizes: 4 4 4\nencoding: raw\n\n" + bytes(range(64)))
    pathlib.Path("folder").mkdir()
    pathlib.Path("loop").symlink_to("loop")
    os.mkfifo("pipe")
    model.save_session("a.tansession")


def judged(call, wrong, names):
    """What is to be said against the outcome of a call; nothing if it is as it must be."""
    try:
        eval(call, names)  # noqa: S307: they are ours
    except ALLOWED as problem:
        said = str(problem)
        if not said.strip() or len(said) > LONGEST or any(words in said for words in UNSPEAKABLE):
            return f"says {type(problem).__name__}: '{said[:300]}' ({len(said)} characters)"
        return None if wrong is not None else f"is refused: {type(problem).__name__}: {said[:300]}"
    except BaseException as problem:  # noqa: BLE001
        return f"raises {type(problem).__name__}: '{str(problem)[:300]}'"
    return "is taken" if wrong else None


def make_calls(first, last, way):
    """The child: tells each call before it is made, and then what is to be said against it."""
    if not SANITIZED:
        resource.setrlimit(resource.RLIMIT_AS, (BYTES, BYTES))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    faulthandler.enable()
    warnings.simplefilter("ignore")
    names = world()
    if not os.path.exists("text.txt"):
        make_files(names["m"])
    for number in range(first, last):
        call, wrong = call_of(random.Random(f"{SEED} {number}"), way)
        print(json.dumps([number, call]), flush=True)
        faulthandler.dump_traceback_later(SECONDS, exit=True)
        fault = judged(call, None if way == "right" else wrong, names)
        faulthandler.cancel_dump_traceback_later()
        print(json.dumps(fault), flush=True)
    print(json.dumps(names["m"].mesh(error=5).volume()), flush=True)


class WrongUse(unittest.TestCase):
    def batch(self, folder, first, last, way):
        """The faults of these calls, and the number of the call to go on with."""
        done = subprocess.run([sys.executable, __file__, str(FOLDER), "--child", str(CALLS), str(SEED), str(first), str(last), way], cwd=folder,
                              check=False,
                              capture_output=True, text=True, errors="replace", timeout=SECONDS * BATCH)
        told = [json.loads(line) for line in done.stdout.splitlines()]
        faults = [f"{call} {fault}" for (_, call), fault in zip(told[::2], told[1::2]) if fault]
        if done.returncode == 0:
            self.assertAlmostEqual(told[-1], 8, msg="the model can be used as before")
            return faults, last
        self.assertEqual(len(told) % 2, 1, done.stderr)
        number, call = told[-1]
        return [*faults, f"{call} ends the process with {done.returncode}:\n{done.stderr[-3000:]}"], number + 1

    def faults(self, count, way=""):
        faults, number = [], 0
        with tempfile.TemporaryDirectory() as folder:
            while number < count:
                found, number = self.batch(folder, number, min(number + BATCH, count), way)
                faults += found
        return faults

    def test_wrong_calls(self):
        faults = self.faults(CALLS)
        self.assertEqual(len(faults), 0, "\n".join([f"{len(faults)} of {CALLS} calls, seed {SEED}:", *faults]))

    def test_right_calls(self):
        """What the wrong calls are made of is right."""
        faults = self.faults(CALLS // 8, "right")
        self.assertEqual(len(faults), 0, "\n".join([f"seed {SEED}:", *faults]))


if __name__ == "__main__":
    if CHILD:
        first, last = int(sys.argv[1]), int(sys.argv[2])
        make_calls(first, last, sys.argv[3] or None)
    else:
        unittest.main()
