# SPDX-License-Identifier: GPL-3.0-or-later
"""What can go wrong, as exceptions: each says in one sentence, the program's own, what happened and what to do."""
from __future__ import annotations

from typing import Optional


class Error(Exception):
    """Base of all errors that TAn reports. str(error) is a sentence; `file` is the file it is about, or None."""

    file: Optional[str] = None


class WrongUsage(Error, ValueError):
    """Something was asked for that does not exist or does not fit; a ValueError."""


class BadInput(Error, OSError, ValueError):
    """A file that is missing or damaged, or arrays that cannot be used as they are; an OSError, and a ValueError."""


class CannotWrite(Error, OSError):
    """A file cannot be written, as on a full disk; an OSError."""


class OutOfResource(Error, MemoryError):
    """Not enough memory, or a limit of the format or of the machine; a MemoryError."""


class NotYet(Error):
    """Others are still to make what this waits for, such as the parts of a build."""


class Cancelled(Error):
    """Work was stopped for no reason that Python knows of. (Ctrl-C is a KeyboardInterrupt.)"""


KINDS = {"wrong-usage": WrongUsage, "bad-input": BadInput, "cannot-write": CannotWrite, "out-of-resource": OutOfResource,
         "not-yet": NotYet, "cancelled": Cancelled}
