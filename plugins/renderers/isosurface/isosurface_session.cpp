// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/renderers/isosurface/isosurface_session.h"

#include "core/graphics/isosurface.h"
#include "plugins/renderers/isosurface/isosurface_renderer.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <new>
#include <numeric>
#include <optional>

namespace tetra {
namespace {

constexpr std::string_view activity = "Extracting isosurfaces";
constexpr Colour outlineColour{0.45f, 0.45f, 0.45f};
constexpr float outlineWidth = 1.5f;

/// The defaults where the caller leaves something out: then the range is that of the mesh.
std::vector<Parameter> defaultsFor(const TetrahedralMesh& mesh)
{
    if (mesh.values.empty())
        return isosurfaceParameters({});
    const auto [smallest, largest] = std::ranges::minmax(mesh.values);
    return isosurfaceParameters({smallest, largest});
}

/// The mean of several pieces of work that report from their own threads; never falls.
class JointProgress {
public:
    JointProgress(const Progress& whole, std::size_t pieces) : whole_(whole), fractions_(pieces, 0) {}

    Progress::Callback piece(std::size_t index)
    {
        return [this, index](double fraction, std::string_view) {
            const std::scoped_lock lock(mutex_);
            fractions_[index] = fraction;
            const double sum = std::accumulate(fractions_.begin(), fractions_.end(), 0.0);
            whole_.report(sum / static_cast<double>(fractions_.size()), activity);
        };
    }

private:
    const Progress& whole_;
    std::vector<double> fractions_;
    std::mutex mutex_;
};

bool isShown(const Isovalue& isovalue)
{
    return isovalue.visible && isovalue.opacity > 0;
}

bool contains(std::span<const Isovalue> isovalues, double value)
{
    return std::ranges::any_of(isovalues, [&](const Isovalue& isovalue) { return isovalue.value == value; });
}

} // namespace

IsosurfaceSession::IsosurfaceSession(std::shared_ptr<const TetrahedralMesh> mesh, const Eigen::AlignedBox3d& bounds)
    : mesh_(std::move(mesh)), bounds_(bounds)
{
}

Status IsosurfaceSession::extractMissing(std::span<const Isovalue> isovalues, const Progress& progress)
{
    std::vector<double> missing;
    for (const Isovalue& isovalue : isovalues)
        if (isShown(isovalue) && !surfaces_.contains(isovalue.value))
            missing.push_back(isovalue.value);
    std::ranges::sort(missing);
    missing.erase(std::unique(missing.begin(), missing.end()), missing.end());
    if (missing.empty())
        return {};

    if (gradients_.size() != mesh_->positions.size())
        gradients_ = vertexGradients(*mesh_);
    if (progress.cancelled())
        return cancelledError(activity);
    const Progress extraction = progress.part(0.3, 1);
    JointProgress joint(extraction, missing.size());
    std::vector<std::optional<Result<TriangleMesh>>> extracted(missing.size());
    tbb::parallel_for(std::size_t(0), missing.size(), [&](std::size_t i) {
        extracted[i] = extractIsosurface(*mesh_, gradients_, missing[i], progress.withCallback(joint.piece(i)));
    });
    Status status;
    for (std::size_t i = 0; i < missing.size(); ++i) {
        if (*extracted[i])
            surfaces_[missing[i]] = std::make_shared<const TriangleMesh>(std::move(**extracted[i]));
        else if (status)
            status = extracted[i]->error();
    }
    return status;
}

std::shared_ptr<const Scene> IsosurfaceSession::makeScene(std::span<const Isovalue> isovalues, bool outline) const
{
    auto scene = std::make_shared<Scene>();
    scene->bounds = bounds_;
    for (const Isovalue& isovalue : isovalues)
        if (isShown(isovalue))
            scene->surfaces.push_back(
                {surfaces_.at(isovalue.value), {isovalue.red, isovalue.green, isovalue.blue}, isovalue.opacity});
    if (outline)
        scene->lines.push_back(boxOutline(bounds_, outlineColour, outlineWidth));
    return scene;
}

Result<std::shared_ptr<const Scene>> IsosurfaceSession::prepare(const ParameterValues& values, const Camera&,
                                                                const Progress& progress)
{
    const std::vector<Parameter> defaults = defaultsFor(*mesh_);
    const auto isovalues = parameterValue<std::vector<Isovalue>>(defaults, values, isovaluesId);
    for (const Isovalue& isovalue : isovalues)
        if (!std::isfinite(isovalue.value) || !(isovalue.opacity >= 0 && isovalue.opacity <= 1))
            return Error{ErrorKind::WrongUsage,
                         "An isovalue must be a finite number, and its opacity between 0 and 1."};
    try {
        std::erase_if(surfaces_, [&](const auto& kept) { return !contains(isovalues, kept.first); });
        progress.report(0, activity);
        if (Status status = extractMissing(isovalues, progress); !status)
            return status.error();
        progress.report(1, activity);
        return makeScene(isovalues, parameterValue<bool>(defaults, values, outlineId));
    } catch (const std::bad_alloc&) {
        return Error{ErrorKind::OutOfResource,
                     "Not enough memory for the isosurfaces. Show fewer of them or lower the accuracy of the mesh."};
    }
}

} // namespace tetra
