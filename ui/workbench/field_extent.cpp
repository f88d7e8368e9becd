// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workbench/field_extent.h"

#include <tan/query.h>
#include <tan/render.h>

#include <new>

namespace tetra {
namespace {

constexpr std::uint64_t largestMesh = 100'000; // tetrahedra
constexpr int volumeParts = 256;
constexpr double anyError = 1e9; ///< %

/// The finest that is small, or the coarsest if that is not.
std::uint32_t sitesOfCoarseMesh(const Model& model)
{
    const auto size = meshSizeWithin(model, {}, largestMesh);
    return size ? size->sites : meshSizeAt(model, {.error = anyError}).sites;
}

} // namespace

FieldExtent roughExtentOf(const Model& model)
{
    return {model.description().range, model.description().bounds};
}

FieldExtent extentOf(const Model& model)
try {
    FieldExtent field = roughExtentOf(model);
    if (const auto mesh = extractPrefix(model, sitesOfCoarseMesh(model))) {
        field.volumes = volumeHistogram(*mesh, field.range.minimum, field.range.maximum, volumeParts);
        field.surface = surfaceValue(*mesh, field.range.minimum, field.range.maximum);
    }
    return field;
} catch (const std::bad_alloc&) {
    return roughExtentOf(model);
}

} // namespace tetra
