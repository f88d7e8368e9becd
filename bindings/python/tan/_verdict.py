# SPDX-License-Identifier: GPL-3.0-or-later
"""What the checker found of a model."""
from __future__ import annotations

from typing import Any, Dict, List


class Verdict:
    """What the checker found. `ok` says whether the model is proved; `text` says it in sentences; `failures` are those of the file as a
    whole; `levels` has a dictionary for each level: error, warping (as asked, in %), sites, tetrahedra, conforming, covers, inverted,
    degenerate, error_statistics, warping_statistics and error_in_space (each with largest, mean, percentile_99 and root_mean_square, in %),
    error_at_nearest (of irregular data: of points outside of the mesh at the nearest place of it), and failures. True if it is ok."""

    def __init__(self, facts: Dict[str, Any]) -> None:
        if not isinstance(facts, dict) or not {"ok", "failures", "levels"} <= set(facts):
            raise TypeError("verdicts are made by Model.verify()")
        self.ok = bool(facts["ok"])
        self.failures: List[str] = list(facts["failures"])
        self.levels: List[Dict[str, Any]] = list(facts["levels"])

    @property
    def text(self) -> str:
        """What was found, a line for each level."""
        lines = list(self.failures)
        for level in self.levels:
            largest = level["error_statistics"]["largest"]
            lines.append(f"{level['error']:g} %: " + (f"proved; the largest error is {largest:.4g} %" if not level["failures"]
                                                      else "; ".join(level["failures"])))
        return "\n".join(lines)

    def __bool__(self) -> bool:
        return self.ok

    def __repr__(self) -> str:
        return f"<tan.Verdict {'proved' if self.ok else 'refuted'}, {len(self.levels)} levels>"
