// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/writers/surface_formats.h"

#include <Eigen/Geometry>

#include <limits>

namespace tetra {

namespace {

constexpr std::size_t headBytes = 80;
constexpr std::size_t triangleBytes = 12 * sizeof(float) + sizeof(std::uint16_t);

/// Eighty bytes that must not begin with "solid": that is how text files begin.
std::string stlHead(const SurfaceContent& content)
{
    std::string head = "binary STL, " + content.title + " by TAn";
    head.resize(headBytes, ' ');
    return head;
}

/// Of length 1, or zero of a triangle without area. In double precision: the sides' squares leave that of floats.
Eigen::Vector3f normalOf(const std::array<Eigen::Vector3f, 3>& corners)
{
    const Eigen::Vector3d origin = corners[0].cast<double>();
    const Eigen::Vector3d normal =
        (corners[1].cast<double>() - origin).cross(corners[2].cast<double>() - origin).stableNormalized();
    return normal.allFinite() ? normal.cast<float>() : Eigen::Vector3f(0, 0, 0);
}

} // namespace

Status writeStl(const std::filesystem::path& path, const SurfaceContent& content, const Progress& progress)
{
    const SurfaceSize size = sizeOf(content);
    if (size.triangles > std::numeric_limits<std::uint32_t>::max())
        return tooLarge(Message::say("'%1' would hold more than the 4294967295 triangles that an STL file can count.",
                                     path.string()));
    auto out = MeshOutput::create(path, headBytes + sizeof(std::uint32_t) + size.triangles * triangleBytes,
                                  writingSurfaces, progress);
    if (!out)
        return out.error();
    if (const Status written = out->text(stlHead(content)); !written)
        return written;
    const auto count = static_cast<std::uint32_t>(size.triangles);
    if (const Status written = out->bytes(std::as_bytes(std::span(&count, 1))); !written)
        return written;
    const auto triangle = [](const SurfacePart& part, std::uint64_t, std::uint64_t index, std::byte* where) {
        const auto& numbers = part.triangles[index];
        const std::array corners = {part.positions[numbers[0]], part.positions[numbers[1]], part.positions[numbers[2]]};
        for (const float coordinate : normalOf(corners))
            putNumber(where, coordinate);
        for (const Eigen::Vector3f& corner : corners)
            for (const float coordinate : corner)
                putNumber(where, coordinate);
        putNumber(where, std::uint16_t(0));
    };
    if (const Status written = partRecords(*out, content, triangleCount, triangleBytes, triangle); !written)
        return written;
    return out->commit();
}

} // namespace tetra
