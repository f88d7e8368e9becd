// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/field_extent.h"

#include "core/graphics/volume/volume_histogram.h"
#include "core/model/queries/mesh_query.h"
#include "core/model/queries/uniform_budget.h"

#include <new>

namespace tetra {
namespace {

constexpr std::uint64_t largestMesh = 100'000; // tetrahedra
constexpr int parts = 256;

} // namespace

FieldExtent roughExtentOf(const Model& model)
{
    return {model.description().range, model.description().bounds};
}

FieldExtent extentOf(const Model& model)
try {
    FieldExtent field = roughExtentOf(model);
    const auto size = meshSizeWithin(model, {}, largestMesh);
    if (!size)
        return field;
    if (const auto mesh = extractPrefix(model, size->sites))
        field.volumes = volumeHistogram(*mesh, field.range.minimum, field.range.maximum, parts);
    return field;
} catch (const std::bad_alloc&) {
    return roughExtentOf(model);
}

} // namespace tetra
