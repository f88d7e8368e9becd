// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/api/writer.h"

#include <Eigen/Geometry>

#include <QObject>

#include <limits>

namespace tetra {
namespace {

constexpr std::size_t headBytes = 80;
constexpr std::size_t triangleBytes = 12 * sizeof(float) + sizeof(std::uint16_t);

/// Eighty bytes that must not begin with "solid": that is how text files begin. If coordinates are less than the data's
/// by a shift, that comes first, as there may be no room for all.
std::string stlHead(const SurfaceContent& content, const Eigen::Vector3d& shift)
{
    std::string head = "binary STL, ";
    if (!shift.isZero(0))
        head += "add " + formatNumber(shift[0]) + " " + formatNumber(shift[1]) + " " + formatNumber(shift[2]) + ", ";
    head += content.title + " by TAn";
    head.resize(headBytes, ' ');
    return head;
}

/// Of length 1, or zero of a triangle without area. In double precision: the sides' squares leave that of floats.
Eigen::Vector3f normalOf(const std::array<Eigen::Vector3d, 3>& corners)
{
    const Eigen::Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).stableNormalized();
    return normal.allFinite() ? normal.cast<float>() : Eigen::Vector3f(0, 0, 0);
}

Status writeTriangles(const SurfacePart& part, const Eigen::Vector3d& shift, OutputFile& file)
{
    const auto triangle = [&part, &shift](std::uint64_t index, std::byte* where) {
        const auto& [a, b, c] = part.triangles[index];
        const std::array corners = {part.positions[a], part.positions[b], part.positions[c]};
        for (const float coordinate : normalOf(corners))
            putNumber(where, coordinate);
        for (const Eigen::Vector3d& corner : corners)
            for (const double coordinate : (corner - shift).eval())
                putNumber(where, static_cast<float>(coordinate));
        putNumber(where, std::uint16_t(0));
    };
    return file.records(part.triangles.size(), triangleBytes, triangle);
}

} // namespace

/// `.stl`, binary: triangles without shared vertices. The format has no colours.
class StlWriter : public QObject, public Writer {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID TAN_WRITER_INTERFACE FILE "stl_writer.json")
    Q_INTERFACES(tetra::Writer)

public:
    std::vector<FileFormat> formats() const override
    {
        return {{WrittenContent::Surface, Message::marked("STL files"), {".stl"}}};
    }

    Status writeSurface(const SurfaceContent& content, OutputFile& file,
                        const ParameterValues& /*values*/) const override
    {
        const std::uint64_t triangles = content.triangleCount();
        if (triangles > std::numeric_limits<std::uint32_t>::max())
            return Error{ErrorKind::OutOfResource,
                         Message::say("'%1' would hold more than the 4294967295 triangles that an STL file can count. "
                                      "Write a .vtp file, or a surface of a larger error.",
                                      file.target().string())};
        file.expect(headBytes + sizeof(std::uint32_t) + triangles * triangleBytes);
        const Eigen::Vector3d shift = floatShift(content);
        if (const Status written = file.text(stlHead(content, shift)); !written)
            return written;
        const auto count = static_cast<std::uint32_t>(triangles);
        if (const Status written = file.bytes(std::as_bytes(std::span(&count, 1))); !written)
            return written;
        for (const SurfacePart& part : content.parts)
            if (const Status written = writeTriangles(part, shift, file); !written)
                return written;
        return {};
    }
};

} // namespace tetra

#include "stl_writer.moc"
