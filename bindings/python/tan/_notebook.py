# SPDX-License-Identifier: GPL-3.0-or-later
"""A model as a notebook shows it: a picture, the curve of its sizes, and what it says of itself."""
from __future__ import annotations

import base64
import html
import math
from typing import TYPE_CHECKING, List, Tuple

from . import _tan
from ._errors import Error

if TYPE_CHECKING:
    from ._model import Model

_WIDTH, _HEIGHT = 360, 270


def _picture(model: Model) -> str:
    try:
        pixels = model.render(size=(_WIDTH, _HEIGHT), samples=2)
    except Error as problem:  # a machine without fonts, say: the rest is shown all the same
        return f"<p>{html.escape(str(problem))}</p>"
    return f'<img width="{_WIDTH}" height="{_HEIGHT}" alt="" src="data:image/png;base64,{base64.b64encode(_tan.png(pixels)).decode()}"/>'


def _curve(model: Model) -> str:
    """Tetrahedra against error, both logarithmic, as an SVG."""
    levels = model.levels
    points: List[Tuple[float, float]] = [(math.log10(error), math.log10(count)) for error, count in
                                         zip(levels["error"].tolist(), levels["tetrahedra"].tolist()) if error > 0 and count > 0]
    points = points[::max(1, len(points) // 300)]
    if len(points) < 2:
        return ""
    (left, right), (low, high) = ((min(values), max(values)) for values in zip(*points))
    placed = " ".join(f"{40 + 250 * (right - x) / ((right - left) or 1):.1f},{170 - 150 * (y - low) / ((high - low) or 1):.1f}" for x, y in points)
    return ('<svg width="300" height="200" font-size="11" fill="currentColor">'
            f'<polyline fill="none" stroke="currentColor" points="{placed}"/>'
            f'<text x="40" y="190">{10**right:.3g} %</text><text x="290" y="190" text-anchor="end">{10**left:.2g} % error</text>'
            f'<text x="40" y="12">{10**high:,.0f} tetrahedra</text></svg>')


def page(model: Model) -> str:
    (least, largest), (lower, upper) = model.range, model.bounds.tolist()
    unit, length = (f" {text}" if text else "" for text in (model.value_unit, model.length_unit))
    rows = [("data", f"{model.provenance['source']} ({model.kind})"), (model.value_name or "values", f"{least:g} to {largest:g}{unit}"),
            ("bounds", " × ".join(f"{first:g} to {last:g}" for first, last in zip(lower, upper)) + length),
            ("sites", f"{model.sites:,}"), ("built by", model.provenance["builder"]), ("file", f"{model.path}, {model.file_size / 1e6:,.1f} MB")]
    table = "".join(f"<tr><th>{html.escape(name)}</th><td>{html.escape(value)}</td></tr>" for name, value in rows)
    return f'<div style="display: flex; gap: 1em; align-items: center">{_picture(model)}<div><table>{table}</table>{_curve(model)}</div></div>'
