# SPDX-License-Identifier: GPL-3.0-or-later
"""What users give as numbers and arrays, checked: nothing that is no number goes on."""
from __future__ import annotations

import math
import operator
import os
import reprlib
from collections.abc import Mapping, Set
from typing import Any, List, Optional, Sequence, Tuple, Union

import numpy as np
import numpy.typing as npt

from ._errors import WrongUsage

Vector = Union[Sequence[float], npt.NDArray[Any]]
_UNORDERED = (str, bytes, bytearray, type, Mapping, Set)  # or ordered, but no lists of anything
_SHORT = reprlib.Repr()
_SHORT.maxstring = _SHORT.maxother = 200


def shown(value: Any) -> str:
    """What was given, as a sentence shows it: in short."""
    return _SHORT.repr(value)


def _is_real(value: Any) -> bool:
    """Whether it is one real number. float() takes more: texts, the bytes of a buffer, and complex numbers of NumPy."""
    if isinstance(value, (np.ndarray, np.generic)):
        return value.ndim == 0 and value.dtype.kind in "uif"
    return not isinstance(value, (bool, type)) and (hasattr(value, "__float__") or hasattr(value, "__index__"))


def number(value: Any, name: str, least: Optional[float] = None) -> float:
    """A finite number."""
    if not _is_real(value):
        raise TypeError(f"{name} is a number, not {shown(value)}")
    try:
        result = float(value)
    except (TypeError, OverflowError) as problem:
        raise TypeError(f"{name} is a number, not {shown(value)}") from problem
    if not math.isfinite(result):
        raise WrongUsage(f"{name} is {result}, which is no finite number.")
    if least is not None and result < least:
        raise WrongUsage(f"{name} is {result}, but must be at least {least:g}.")
    return result


def whole(value: Any, name: str, least: int = 0, largest: int = 2**63 - 1) -> int:
    """A whole number within limits."""
    if isinstance(value, (bool, np.bool_)):
        raise TypeError(f"{name} is a whole number, not {shown(value)}")
    try:
        result = operator.index(value)
    except TypeError as problem:
        raise TypeError(f"{name} is a whole number, not {shown(value)}") from problem
    if not least <= result <= largest:
        raise WrongUsage(f"{name} is {result}, but must be from {least} to {largest}.")
    return result


def truth(value: Any, name: str) -> bool:
    """True or False, also as NumPy or as 1 and 0. A text is neither, whatever it says."""
    if isinstance(value, (bool, np.bool_)) or (_is_real(value) and value in (0, 1)):
        return bool(value)
    raise TypeError(f"{name} is True or False, not {shown(value)}")


def listed(value: Any, what: str) -> List[Any]:
    """The parts of a list, an array or the like, which have an order; `what` says what they are of."""
    if isinstance(value, _UNORDERED):
        raise TypeError(f"{what}, not {shown(value)}")
    try:
        return list(value)
    except TypeError as problem:
        raise TypeError(f"{what}, not {shown(value)}") from problem


def vector(value: Any, name: str, length: int = 3) -> Tuple[float, ...]:
    """Finite numbers, as many as `length`."""
    try:
        found = None if isinstance(value, _UNORDERED) else len(value)
    except TypeError:
        found = None
    if found is None:
        raise TypeError(f"{name} is {length} numbers, not {shown(value)}")
    if found != length:
        raise WrongUsage(f"{name} is {length} numbers, not {found}.")
    return tuple(number(part, name) for part in value)


def text(value: Any, name: str) -> str:
    """A text of whole characters: half of a surrogate pair is none, and cannot be written."""
    if not isinstance(value, str):
        raise TypeError(f"{name} is a text, not {shown(value)}")
    try:
        value.encode()
    except UnicodeEncodeError as problem:
        raise WrongUsage(f"{name} has something at place {problem.start} that is no character: {shown(value)}.") from problem
    return value


def choice(value: Any, name: str, known: Sequence[str]) -> str:
    """One of several words."""
    if text(value, name) not in known:
        raise WrongUsage(f"{name} can be {', '.join(known)}, not {shown(value)}.")
    return str(value)


def real_array(value: Any, name: str, shape: Tuple[Optional[int], ...]) -> npt.NDArray[np.float64]:
    """An array of doubles, C-contiguous, whose shape is `shape`, None being any length."""
    array = np.asarray(value)
    if array.dtype.kind not in "buif":
        raise TypeError(f"{name} is an array of numbers, not of {array.dtype}")
    if isinstance(value, np.ma.MaskedArray) and bool(np.any(value.mask)):
        raise WrongUsage(f"{name} has masked entries, which say nothing. Leave them out.")
    if array.ndim != len(shape) or any(wanted not in (None, found) for wanted, found in zip(shape, array.shape)):
        wanted = ", ".join("n" if length is None else str(length) for length in shape)
        raise WrongUsage(f"{name} is an array of shape ({wanted}), not {array.shape}.")
    made = np.ascontiguousarray(array, dtype=np.float64)
    if array.dtype.kind in "ui" and array.dtype.itemsize == 8 and array.size:
        _check_exact(int(array.min()), int(array.max()), name)
    return made


def samples(values: Any, name: str) -> npt.NDArray[Any]:
    """The array in a type that models have, exactly: integers of 8 to 32 bits, float32 or float64. A copy only if it has another
    type or byte order."""
    array = np.asarray(values)
    kind, size = array.dtype.kind, array.dtype.itemsize
    if kind == "b":
        return array.astype(np.uint8)
    if kind in "ui" and size == 8:
        return _narrowed(array, name)
    if kind == "f" and size == 2:
        return array.astype(np.float32)
    if kind not in "uif" or size > 8:
        raise TypeError(f"{name} is an array of integers or real numbers of at most 64 bits, not of {array.dtype}")
    return array if array.dtype.isnative else array.astype(array.dtype.newbyteorder("="))


def _narrowed(array: npt.NDArray[Any], name: str) -> npt.NDArray[Any]:
    if array.size == 0:
        return array.astype(np.int32)
    least, largest = int(array.min()), int(array.max())
    for narrow in (np.int32, np.uint32):
        if np.iinfo(narrow).min <= least and largest <= np.iinfo(narrow).max:
            return array.astype(narrow)
    _check_exact(least, largest, name)
    return array.astype(np.float64)


def _check_exact(least: int, largest: int, name: str) -> None:
    if max(-least, largest) > 2**53:
        raise WrongUsage(f"{name} has integers up to {max(-least, largest)}, which are more than doubles hold exactly (2^53). "
                         "Scale them, or convert them to float64 yourself.")


_OTHER_FORMATS = (".vtu", ".vtk", ".vtp", ".vti", ".vts", ".stl", ".obj", ".ply", ".glb", ".csv", ".nrrd", ".npy", ".png", ".msh", ".xdmf")


def model_path(path: str, what: str) -> str:
    """A path where a model is written, which no other program would take for something else."""
    if path.lower().endswith(_OTHER_FORMATS):
        raise WrongUsage(f"{what} writes a model of TAn, but '{path}' has the ending of another format. Take .tan; a mesh is written by "
                         "m.mesh(error=1).to_meshio().write(...), or by vtk with to_vtk().")
    return path


def path_text(path: Any, name: str, *, in_utf8: bool = True) -> str:
    """A path as a text; no array, no number. What models are called, `in_utf8`, is a text; the program `tan` takes any name."""
    try:
        found = os.fspath(path)
    except TypeError as problem:
        raise TypeError(f"{name} is a path, not {shown(path)}") from problem
    if not isinstance(found, str):
        raise TypeError(f"{name} is a path as a text, not {shown(path)}")
    if "\0" in found or not found:
        raise WrongUsage(f"{name} is no path.")
    return text(found, name) if in_utf8 else found
