# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes and surfaces for meshio, and models as a format that meshio reads: after `import tan.meshio`, meshio.read("engine.tan") gives the
mesh that is quick to work with."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

import meshio

if TYPE_CHECKING:
    from ._mesh import Mesh, Surface


def tetrahedral_mesh(mesh: Mesh) -> Any:
    """A meshio.Mesh with the field and the sites as data of the points."""
    return meshio.Mesh(mesh.points, [("tetra", mesh.tetrahedra)],
                       point_data={mesh.value_name or "value": mesh.values, "site": mesh.sites.astype("int64")})


def surface_mesh(surface: Surface) -> Any:
    """A meshio.Mesh with the field and the normals as data of the points."""
    return meshio.Mesh(surface.points, [("triangle", surface.triangles)],
                       point_data={surface.value_name or "value": surface.values, "normals": surface.normals})


def read(path: Any, **query: Any) -> Any:
    """A model's mesh as a meshio.Mesh; further arguments are those of Model.mesh()."""
    from ._build import open as open_model
    return open_model(path).mesh(**query).to_meshio()


meshio.register_format("tan", [".tan"], read, {})
