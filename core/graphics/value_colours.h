// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/scene.h"
#include "core/transfer/transfer_function.h"

namespace tetra {

/// The surface with the colours that a transfer function gives its values, whatever their opacity; the surface must
/// have values. Between two points of the function, colours are linear in the value, and so they are on a triangle:
/// each triangle is cut where its value is that of a point (R22), so that the colours are exact at any place, steps
/// included, however large the triangles are. Triangles that share an edge are cut at the same places, bit for bit. A
/// function without points, and a surface without values, leave the surface as it is. O(triangles + pieces). May throw
/// std::bad_alloc.
TriangleMesh colouredByValue(const TriangleMesh& surface, const TransferFunction& function);

} // namespace tetra
