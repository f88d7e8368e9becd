# SPDX-License-Identifier: GPL-3.0-or-later
"""Progress as users give it: a function of a fraction and an activity, or a bar as tqdm has them."""
from __future__ import annotations

import contextlib
from typing import Any, Callable, Iterator, Optional, Union

from ._errors import OutOfResource
from ._numbers import shown

Report = Callable[[float, str], Any]
#: None; a function that is called with a fraction from 0 to 1 and a text; a bar of tqdm, or its class.
Progress = Union[None, Report, Any]


@contextlib.contextmanager
def reporting(progress: Progress) -> Iterator[Optional[Report]]:
    """The function that is called in the end, or None. A bar is made for its class, goes to 100, and is closed."""
    try:
        with _told(progress) as report:
            yield report
    except MemoryError as problem:
        if str(problem) != "std::bad_alloc":
            raise
        raise OutOfResource("There is not enough memory for this. Close other programs, or ask for less.") from problem


@contextlib.contextmanager
def _told(progress: Progress) -> Iterator[Optional[Report]]:
    if progress is None:
        yield None
        return
    if not hasattr(progress, "update") or not hasattr(progress, "close"):
        if not callable(progress):
            raise TypeError(f"progress is a function of a fraction and a text, or a bar as of tqdm, not {shown(progress)}")
        yield progress
        return
    bar = progress(total=100) if isinstance(progress, type) else progress
    reached = 0.0

    def report(fraction: float, activity: str) -> None:
        nonlocal reached
        if hasattr(bar, "set_description_str"):
            bar.set_description_str(activity, refresh=False)
        total = bar.total if getattr(bar, "total", None) else 100
        bar.update(max(0.0, fraction - reached) * total)
        reached = max(reached, fraction)

    try:
        yield report
        report(1.0, "Done")
    finally:
        if isinstance(progress, type):
            bar.close()
