# SPDX-License-Identifier: GPL-3.0-or-later
"""Models for PyVista: its entry point for readers, so that pyvista.read("engine.tan", error=1) works without an import of this."""
from __future__ import annotations

from typing import Any


def wrapped(data: Any) -> Any:
    """A VTK object as PyVista's."""
    import pyvista
    return pyvista.wrap(data)


def read(path: Any, **query: Any) -> Any:
    """A model's mesh as a pyvista.UnstructuredGrid; further arguments are those of Model.mesh()."""
    from ._build import open as open_model
    return open_model(path).mesh(**query).to_pyvista()
