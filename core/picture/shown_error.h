// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/renderer.h"

#include <tan/model.h>
#include <tan/query.h>
#include <tan/transfer.h>
#include <tan/view.h>

namespace tetra {

// How far what is seen may be off, in units of the values: what a transfer function to begin with goes by, and what is
// said of isovalues and opacities that are within it.

/// The largest error that the mesh of a query keeps where the data have this value. `scale`: ExtractedMesh::scale.
double shownErrorAt(const MeshQuery& query, double scale, const ValueRange& range, double value);

/// That scale without extracting the mesh: of one error everywhere it is exact; of a field within a budget that of a
/// mesh as coarse as the field anywhere is, and so the least it can be. O(log sites).
double plannedScale(const MeshQuery& query, const Model& model);

/// What is known of a field that is seen in the mesh of this query: the error in its background, too.
FieldExtent seenWith(FieldExtent field, const MeshQuery& query, const Model& model);
/// The same of a query whose mesh depends on what else is seen: outside of the focus.
FieldExtent seenWith(FieldExtent field, const QueryState& query, const Model& model);

/// What of these isovalues and this transfer function is within the error of a mesh. Null: no volume is shown.
std::vector<ErrorRemark> shownErrorRemarks(const FieldExtent& field, const MeshQuery& query, double scale,
                                           std::span<const double> isovalues, const TransferFunction* transfer);

} // namespace tetra
