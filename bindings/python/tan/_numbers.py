# SPDX-License-Identifier: GPL-3.0-or-later
"""What users give as numbers and arrays, checked: nothing that is no number goes on."""
from __future__ import annotations

import math
import pathlib
from typing import Any, Optional, Sequence, Tuple, Union

import numpy as np
import numpy.typing as npt

from ._errors import WrongUsage

Vector = Union[Sequence[float], npt.NDArray[Any]]


def number(value: Any, name: str, least: Optional[float] = None) -> float:
    """A finite number."""
    if isinstance(value, (str, bytes, bool, np.bool_)):
        raise TypeError(f"{name} is a number, not {value!r}")
    try:
        result = float(value)
    except (TypeError, OverflowError) as problem:
        raise TypeError(f"{name} is a number, not {value!r}") from problem
    if not math.isfinite(result):
        raise WrongUsage(f"{name} is {result}, which is no finite number.")
    if least is not None and result < least:
        raise WrongUsage(f"{name} is {result}, but must be at least {least:g}.")
    return result


def whole(value: Any, name: str, least: int = 0, largest: int = 2**63 - 1) -> int:
    """A whole number within limits."""
    if isinstance(value, (bool, np.bool_)) or not hasattr(value, "__index__"):
        raise TypeError(f"{name} is a whole number, not {value!r}")
    result = int(value.__index__())
    if not least <= result <= largest:
        raise WrongUsage(f"{name} is {result}, but must be from {least} to {largest}.")
    return result


def vector(value: Any, name: str, length: int = 3) -> Tuple[float, ...]:
    """Finite numbers, as many as `length`."""
    if isinstance(value, (str, bytes)) or not hasattr(value, "__len__"):
        raise TypeError(f"{name} is {length} numbers, not {value!r}")
    if len(value) != length:
        raise WrongUsage(f"{name} is {length} numbers, not {len(value)}.")
    return tuple(number(part, name) for part in value)


def text(value: Any, name: str) -> str:
    if not isinstance(value, str):
        raise TypeError(f"{name} is a text, not {value!r}")
    return value


def real_array(value: Any, name: str, shape: Tuple[Optional[int], ...]) -> npt.NDArray[np.float64]:
    """An array of doubles, C-contiguous, whose shape is `shape`, None being any length."""
    array = np.asarray(value)
    if array.dtype.kind not in "buif":
        raise TypeError(f"{name} is an array of numbers, not of {array.dtype}")
    if array.ndim != len(shape) or any(wanted not in (None, found) for wanted, found in zip(shape, array.shape)):
        wanted = ", ".join("n" if length is None else str(length) for length in shape)
        raise WrongUsage(f"{name} is an array of shape ({wanted}), not {array.shape}.")
    return np.ascontiguousarray(array, dtype=np.float64)


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
    if max(-least, largest) > 2**53:
        raise WrongUsage(f"{name} has integers up to {max(-least, largest)}, which are more than doubles hold exactly (2^53). "
                         "Scale them, or convert them to float64 yourself.")
    return array.astype(np.float64)


def path_text(path: Any, name: str) -> str:
    """A path as a text; no array, no number."""
    if isinstance(path, (str, pathlib.PurePath)) or hasattr(path, "__fspath__"):
        found = str(path.__fspath__() if hasattr(path, "__fspath__") else path)
        if "\0" in found or not found:
            raise WrongUsage(f"{name} is no path.")
        return found
    raise TypeError(f"{name} is a path, not {path!r}")
