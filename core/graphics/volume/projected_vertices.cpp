// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/volume/projected_vertices.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

VertexSample sampleOf(const Eigen::Vector3d& image, const VolumeView& view)
{
    if (view.perspective && !(image.z() > view.nearest))
        return {VertexSample::behind, VertexSample::behind};
    const double scale = view.perspective ? 1 / image.z() : 1;
    return {firstSampleFrom(image.x() * scale - view.firstX()), firstSampleFrom(image.y() * scale - view.firstY())};
}

} // namespace

std::int16_t firstSampleFrom(double place) noexcept
{
    // Written so that NaN gives the lower bound.
    const double bounded = place < 32767.0 ? (place > -32767.0 ? place : -32767.0) : 32767.0;
    return static_cast<std::int16_t>(std::ceil(bounded));
}

ProjectedVertices projectVertices(const TetrahedralMesh& mesh, const VolumeView& view, const ScaledSegments& segments)
{
    ProjectedVertices result;
    result.vertices.resize(mesh.positions.size());
    result.samples.resize(mesh.positions.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, mesh.positions.size(), 1 << 12), [&](const auto& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) {
            const Eigen::Vector3d image = view.imageFromWorld * mesh.positions[i].cast<double>().homogeneous();
            const double value = std::clamp((mesh.values[i] - segments.smallest) * segments.perValue, -1e25, 1e25);
            result.vertices[i] = {static_cast<float>(image.x()), static_cast<float>(image.y()),
                                  static_cast<float>(image.z()), static_cast<float>(value)};
            result.samples[i] = sampleOf(image, view);
        }
    });
    return result;
}

} // namespace tetra
