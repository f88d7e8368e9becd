# SPDX-License-Identifier: GPL-3.0-or-later
"""TAn, the Tetrahedra Analyzer, from Python: volume data at the accuracy you choose, and the accuracy is known.

    import tan
    m = tan.build(volume, "volume.tan", spacing=(1, 1, 2.5), name="CT")   # volume[z, y, x]; or tan.build("engine.nrrd", "engine.tan")
    mesh = m.mesh(error=1)                                                # at most 1 % of the range of values off, anywhere
    mesh.points, mesh.values, mesh.tetrahedra                             # arrays of NumPy, without copies
    picture = m.render(mode="volume", transfer="inferno")                 # (height, width, 4), no display needed

Arrays of values have the axes z, y and x (tan.Lattice says more); positions, spacings and places are x, y and z. Errors are in % of the
range of values. What goes wrong is a tan.Error with a sentence that says what to do, and a ValueError, OSError or MemoryError as well.
"""
from ._build import build, open, serve  # noqa: A004
from ._data import Cells, Data, Grid, Lattice, Points
from ._errors import BadInput, Cancelled, CannotWrite, Error, NotYet, OutOfResource, WrongUsage
from ._mesh import Mesh, Surface
from ._model import Explorer, Model, Size
from ._program import Server
from ._regions import Box, HalfSpace, Region, Sphere, box, half_space, sphere
from ._tan import version as _version
from ._verdict import Verdict
from ._view import View

__version__ = _version()
for _kind in (Error, WrongUsage, BadInput, CannotWrite, OutOfResource, NotYet, Cancelled):
    _kind.__module__ = "tan"
__all__ = ["BadInput", "Box", "Cancelled", "CannotWrite", "Cells", "Data", "Error", "Explorer", "Grid", "HalfSpace", "Lattice", "Mesh", "Model",
           "NotYet", "OutOfResource", "Points", "Region", "Server", "Size", "Sphere", "Surface", "Verdict", "View", "WrongUsage", "box", "build",
           "half_space", "open", "serve", "sphere"]
