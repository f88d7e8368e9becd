// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/guarded.h"
#include "core/base/progress.h"
#include "core/base/sort_unique.h"
#include "core/render/isosurface/isosurface.h"

#include <tan/base.h>
#include <tan/render.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace tetra {
namespace {

constexpr MarkedText extractingIsosurfaces = Message::marked("Extracting isosurfaces");

bool isShown(const Isovalue& isovalue)
{
    return isovalue.visible && isovalue.opacity > 0;
}

bool contains(std::span<const Isovalue> isovalues, double value)
{
    return std::ranges::any_of(isovalues, [&](const Isovalue& isovalue) { return isovalue.value == value; });
}

bool isUsable(const Isovalue& isovalue)
{
    return std::isfinite(isovalue.value) && isovalue.opacity >= 0 && isovalue.opacity <= 1;
}

} // namespace

IsosurfaceCache::IsosurfaceCache(std::shared_ptr<OrderedMesh> mesh) : mesh_(std::move(mesh)) {}

IsosurfaceCache::IsosurfaceCache(std::shared_ptr<const TetrahedralMesh> mesh)
    : mesh_(std::make_shared<OrderedMesh>(std::move(mesh)))
{
}

Status IsosurfaceCache::chooseMesh(const Progress& progress)
{
    if (index_)
        return {};
    if (!chosen_ && !mesh_->isOrdered()) {
        gradients_ = vertexGradients(*mesh_->original());
        chosen_ = mesh_->original();
        return {};
    }
    auto ordered = mesh_->ordered(progress.part(0, 0.4));
    if (!ordered)
        return ordered.error();
    gradients_ = vertexGradients(**ordered);
    chosen_ = *ordered;
    index_ = std::make_shared<const IsosurfaceIndex>(makeIsosurfaceIndex(*chosen_));
    return {};
}

Result<TriangleMesh> IsosurfaceCache::extract(double isovalue, const Progress& progress) const
{
    return index_ ? extractIsosurface(*chosen_, *index_, gradients_, isovalue, progress)
                  : extractIsosurface(*chosen_, gradients_, isovalue, progress);
}

Status IsosurfaceCache::extractMissing(std::span<const Isovalue> isovalues, const Progress& progress)
{
    std::vector<double> missing;
    for (const Isovalue& isovalue : isovalues)
        if (isShown(isovalue) && !surfaces_.contains(isovalue.value))
            missing.push_back(isovalue.value);
    sortUnique(missing);
    if (missing.empty())
        return {};

    if (const Status chosen = chooseMesh(progress.part(0, 0.3)); !chosen)
        return chosen;
    if (progress.cancelled())
        return cancelledError(extractingIsosurfaces);
    const Progress extraction = progress.part(0.3, 1);
    SharedProgress joint(extraction, static_cast<double>(missing.size()), extractingIsosurfaces);
    std::vector<std::optional<Result<TriangleMesh>>> extracted(missing.size());
    FirstFailure failure;
    tbb::parallel_for(std::size_t(0), missing.size(), [&](std::size_t i) {
        failure.run([&]() -> Status {
            extracted[i] = extract(missing[i], failure.watching(progress).withCallback(joint.piece(1)));
            return *extracted[i] ? Status() : extracted[i]->error();
        });
    });
    for (std::size_t i = 0; i < missing.size(); ++i)
        if (*extracted[i])
            surfaces_[missing[i]] = std::make_shared<const TriangleMesh>(std::move(**extracted[i]));
    return failure.status();
}

namespace {

constexpr MarkedText noMemoryForSurfaces =
    Message::marked("Not enough memory for the isosurfaces. Show fewer of them or lower the accuracy of the mesh.");

} // namespace

Result<std::vector<Surface>> IsosurfaceCache::update(std::span<const Isovalue> isovalues, const Progress& progress)
{
    if (!std::ranges::all_of(isovalues, isUsable))
        return Error{ErrorKind::WrongUsage,
                     Message::say("An isovalue must be a finite number, and its opacity between 0 and 1.")};
    const auto shown = [&]() -> Result<std::vector<Surface>> {
        std::erase_if(surfaces_, [&](const auto& kept) { return !contains(isovalues, kept.first); });
        progress.report(0, extractingIsosurfaces);
        if (const Status extracted = extractMissing(isovalues, progress); !extracted)
            return extracted.error();
        progress.report(1, extractingIsosurfaces);
        std::vector<Surface> surfaces;
        for (const Isovalue& isovalue : isovalues)
            if (isShown(isovalue))
                surfaces.push_back(
                    {surfaces_.at(isovalue.value), {isovalue.red, isovalue.green, isovalue.blue}, isovalue.opacity});
        return surfaces;
    };
    return guarded(noMemoryForSurfaces, shown);
}

Result<std::vector<Drawable>> IsosurfaceCache::drawables(std::span<const Isovalue> isovalues, const Progress& progress)
{
    auto surfaces = update(isovalues, progress);
    if (!surfaces)
        return surfaces.error();
    return guarded(noMemoryForSurfaces, [&]() -> Result<std::vector<Drawable>> {
        std::vector<Drawable> drawables;
        for (std::size_t i = 0; i < isovalues.size(); ++i)
            if (isShown(isovalues[i]))
                drawables.push_back({.id = "isosurface-" + std::to_string(i + 1),
                                     .label = "isovalue " + formatNumber(isovalues[i].value),
                                     .shape = std::move((*surfaces)[drawables.size()]),
                                     .value = isovalues[i].value,
                                     .saved = true});
        return drawables;
    });
}

} // namespace tetra
