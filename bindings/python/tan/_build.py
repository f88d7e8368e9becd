# SPDX-License-Identifier: GPL-3.0-or-later
"""Opening and building models; the server."""
from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any, Dict, List, Optional, Union

import numpy as np

from . import _program, _tan
from ._data import Data, Lattice
from ._errors import WrongUsage
from ._model import Model
from ._numbers import listed, model_path, number, path_text, shown, text, whole
from ._progress import Progress, reporting


def open(place: Any, *, error: Optional[float] = None, token: str = "", progress: Progress = None) -> Model:  # noqa: A001
    """Opens a model: a path, or an address (http://, https://, or tan+http:// of one that stays at `tan serve`), packed or not.

    error: of a packed model, or one on a server, read only as much as meshes of this error (%) need.
    token: for a server that requires one.
    progress: a function that is called with a fraction from 0 to 1 and a text, in this thread; or a bar of tqdm, or the class tqdm itself.
        What it raises stops the work and goes on. So does Ctrl-C.

    Errors: BadInput, which is an OSError, with a sentence.

    >>> open("none.tan")
    Traceback (most recent call last):
    ...
    tan.BadInput: Cannot read 'none.tan': No such file or directory. Check its name and folder.
    """
    named = path_text(place, "place")
    needed = None if error is None else number(error, "error", least=0)
    with reporting(progress) as report:
        return Model(_tan.open(named, needed, text(token, "token"), "", report), token)


def data_of(source: Any, lattice: Dict[str, Any]) -> Data:
    """The source as data; an array is a lattice."""
    if isinstance(source, Data):
        if lattice:
            raise WrongUsage(f"{', '.join(lattice)}: of tan.{type(source).__name__}, give it there.")
        return source
    if isinstance(source, (np.ndarray, list, tuple)) or hasattr(source, "__array__"):
        return Lattice(source, **lattice)
    raise TypeError(f"data are a path, an array, tan.Lattice, tan.Grid, tan.Points or tan.Cells, not {shown(source)}")


def build(source: Union[Data, str, Any], output: Any, *, error: float = 0, warping: float = 0, method: Optional[str] = None,
          finest: Optional[float] = None, block: Union[None, int, str] = None, order: Optional[str] = None, ordered_by: Optional[str] = None,
          weights: Union[None, str, List[str]] = None, options: Optional[Dict[str, Any]] = None, progress: Progress = None,
          **lattice: Any) -> Model:
    """Builds a model into the file `output`, which appears when it is complete, and opens it.

    source: an array, with the keywords of tan.Lattice (spacing, origin, mask, name ...); tan.Lattice, tan.Grid, tan.Points or tan.Cells;
        or a file of any format that TAn reads, which the program `tan` reads in a process of its own.
    error: where to stop, in % of the range of values; 0 keeps everything. warping: likewise, in % of the diagonal, of data that can warp.
    method: "refinement" or "decimation"; None: the one that suits the data.
    finest: of decimation, leaves out meshes of smaller errors (%). order: of decimation, "exact", "paper" or "rounds".
    block: of refinement, cells along an edge of a block; "none": no blocks. ordered_by: "both", "error" or "warping".
    weights: how much errors count where: "point:x,y,z,reach", "box:...", "value:q,reach", or a list of these.
    options: of a file, further options of `tan build` without their dashes: {"array": "pressure", "time": 3}.
    progress: see tan.open().

    >>> import numpy as np, tempfile, pathlib
    >>> z, y, x = np.mgrid[0:9, 0:9, 0:9]
    >>> folder = tempfile.TemporaryDirectory()
    >>> m = build(np.hypot(x - 4.0, y - 4.0), pathlib.Path(folder.name) / "pipe.tan", name="pipe", length_unit="mm")
    >>> m.range, m.shape, m.length_unit
    ((0.0, 5.656854249492381), (9, 9, 9), 'mm')
    >>> bool(m.mesh(error=2).error <= 2)
    True
    >>> folder.cleanup()
    """
    target = model_path(path_text(output, "output"), "build()")
    said: Dict[str, Any] = {"error": number(error, "error", least=0), "warping": number(warping, "warping", least=0),
                            "builder": _word(method, "method"), "finest": None if finest is None else number(finest, "finest", least=0),
                            "order": _word(order, "order"), "by": _word(ordered_by, "ordered_by"), "block": _block(block)}
    terms = _terms(weights)
    if options is not None and not isinstance(options, Mapping):
        raise TypeError(f"options is a dictionary, not {shown(options)}")
    with reporting(progress) as report:
        if isinstance(source, str) or hasattr(source, "__fspath__"):
            if lattice:
                first, value = next(iter(lattice.items()))
                raise WrongUsage(f"{', '.join(lattice)}: of arrays. Of a file, options says what its reader takes: options={{{first!r}: {shown_option(value)}}}.")
            told = _told(_program.run(_words(path_text(source, "source"), target, said, terms, options or {}), report))
        else:
            if options:
                raise WrongUsage("options are of files. Arrays have keywords.")
            data = data_of(source, lattice)
            _tan.build(data.dataset(), target, _options(said, terms), report)
            told = data.remarks
    model = open(target)
    model._remarks = tuple(told)
    return model


def shown_option(value: Any) -> str:
    """As an option of a file is written."""
    if isinstance(value, (str, int, float)):
        return repr(value)
    parts = list(value) if hasattr(value, "__iter__") else []
    return repr("x".join(str(part) for part in parts)) if 0 < len(parts) <= 3 else "..."


def _told(answer: Dict[str, Any]) -> List[str]:
    """What the program has taken without being told, has left out, and remarks."""
    guesses = [f"a guess: {answer['taken'][part]}" for part in answer.get("guesses", [])]
    return guesses + [f"not used: {sentence}" for sentence in answer.get("unused", [])] + list(answer.get("remarks", []))


def _word(value: Any, name: str) -> Optional[str]:
    return None if value is None else text(value, name)


def _block(block: Any) -> Union[None, int, str]:
    if block is None or (isinstance(block, str) and block == "none"):
        return block
    return whole(block, "block", 1, 2**32 - 1)


def _terms(weights: Any) -> List[str]:
    given = [] if weights is None else [weights] if isinstance(weights, str) else listed(weights, "weights is a text or a list of texts")
    if not all(text(term, "weights") for term in given):
        raise WrongUsage("weights has an empty text. Leave it out.")
    return given


def _options(said: Dict[str, Any], terms: List[str]) -> _tan.BuildOptions:
    built = _tan.BuildOptions()
    built.method = said["builder"] or ""
    built.error, built.warping, built.finest = said["error"], said["warping"], said["finest"]
    built.block = 0 if said["block"] == "none" else said["block"]
    built.order, built.ordered_by = said["order"], said["by"]
    built.weights = ";".join(terms)
    return built


def _words(source: str, target: str, said: Dict[str, Any], terms: List[str], options: Dict[str, Any]) -> List[str]:
    """The command line. Paths that begin with a dash are none of its options."""
    def path(name: str) -> str:
        return f"./{name}" if name.startswith("-") else name

    words = ["build", path(source), "-o", path(target)]
    for name, value in {**{name: value for name, value in said.items() if value}, **options}.items():
        if not text(name, "the name of an option").replace("-", "").replace("_", "").isalnum():
            raise WrongUsage(f"'{name}' is no option.")
        if value is not True and not isinstance(value, (str, int, float, np.integer, np.floating, os.PathLike)):
            raise TypeError(f"the option '{name}' is a text, a number or True, not {shown(value)}; three numbers are a text, '64x64x32'")
        words += [f"--{name.replace('_', '-')}"] + ([] if value is True else [f"{value:.17g}" if isinstance(value, float) else str(value)])
    for term in terms:
        words += ["--weight", term]
    return words


def serve(folder: Any, *, port: int = 0, address: str = "127.0.0.1", token_file: Any = None) -> _program.Server:
    """Serves the models of a folder over HTTP, by `tan serve`, until the server is stopped.

    port: 0 takes a free one. Other machines are answered only at another address, which needs the file of a token.

        with tan.serve("models") as server:
            m = tan.open(server.address + "engine.tan", error=2)
    """
    words = ["serve", path_text(folder, "folder", in_utf8=False), "--port", str(whole(port, "port", 0, 65535)), "--address", text(address, "address")]
    if token_file is not None:
        words += ["--token-file", path_text(token_file, "token_file", in_utf8=False)]
    return _program.Server(words)
