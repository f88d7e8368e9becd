// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/api/plugin.h"
#include "plugins/api/writer.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace tetra {
namespace {

constexpr std::size_t headBytes = 80;
constexpr std::size_t triangleBytes = 12 * sizeof(float) + sizeof(std::uint16_t);

/// With three decimals.
std::string decimalText(double number, std::chars_format format)
{
    std::array<char, 400> text{}; // any number fits
    const auto written = std::to_chars(text.data(), text.data() + text.size(), number, format, 3);
    return {text.data(), written.ptr};
}

/// The least number of four digits that is not less: how far a surface is away at most stays true.
std::string roundedUp(double number)
{
    const std::string nearest = decimalText(number, std::chars_format::scientific);
    const double rounded = parseNumber<double>(nearest).value_or(number);
    if (rounded >= number)
        return formatNumber(rounded);
    const std::size_t exponent = nearest.find('e');
    const double next = parseNumber<double>(nearest.substr(0, exponent)).value_or(0) + 1e-3;
    const std::string text = decimalText(next, std::chars_format::fixed) + nearest.substr(exponent);
    return formatNumber(parseNumber<double>(text).value_or(number));
}

/// "deviation 0.12, ", or nothing where none was measured.
std::string deviationText(const MeshFacts& facts)
{
    const auto deviation = std::ranges::find(facts, "deviation", &MeshFacts::value_type::first);
    const auto* number = deviation != facts.end() ? std::get_if<double>(&deviation->second) : nullptr;
    return number != nullptr && std::isfinite(*number) ? "deviation " + roundedUp(*number) + ", " : "";
}

/// "in mm, ", or nothing where no unit of length is known.
std::string unitText(const MeshFacts& facts)
{
    const auto unit = std::ranges::find(facts, "unit", &MeshFacts::value_type::first);
    const auto* name = unit != facts.end() ? std::get_if<std::string>(&unit->second) : nullptr;
    return name != nullptr && !name->empty() ? "in " + printable(*name) + ", " : "";
}

/// Eighty bytes that must not begin with "solid": that is how text files begin. If coordinates are less than the data's
/// by a shift, that comes first: there is room for three numbers, whatever they are, but perhaps not for the rest. Then
/// how far the surface is from that of the data, if there is room for the whole number: a part of one would be another.
/// The unit of length, if there is room for all.
std::string stlHead(const SurfaceContent& content, const Eigen::Vector3d& shift)
{
    std::string head = shift.isZero(0) ? std::string("binary STL, ")
                                       : "add " + formatNumber(shift[0]) + " " + formatNumber(shift[1]) + " " +
                                             formatNumber(shift[2]) + ", "; // at most 78 bytes
    if (const std::string deviation = deviationText(content.facts); head.size() + deviation.size() <= headBytes)
        head += deviation;
    if (const std::string unit = unitText(content.facts);
        head.size() + unit.size() + content.title.size() + std::string_view(" by TAn").size() <= headBytes)
        head += unit;
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

Status writeTriangles(const SurfacePart& part, TrianglesInFloats triangles, const Eigen::Vector3d& shift,
                      OutputFile& file)
{
    const auto triangle = [&](std::uint64_t, std::byte* where) {
        const auto& [a, b, c] = triangles.next();
        const std::array corners = {part.positions[a], part.positions[b], part.positions[c]};
        for (const float coordinate : normalOf(corners))
            putNumber(where, coordinate);
        for (const Eigen::Vector3d& corner : corners)
            for (const double coordinate : (corner - shift).eval())
                putNumber(where, static_cast<float>(coordinate));
        putNumber(where, std::uint16_t(0));
    };
    return file.records(triangles.count(), triangleBytes, triangle);
}

} // namespace

/// `.stl`, binary: triangles without shared vertices. The format has no colours.
class StlWriter : public Writer {
public:
    std::vector<FileFormat> formats() const override
    {
        return {{WrittenContent::Surface, Message::marked("STL files"), {".stl"}}};
    }

    Status writeSurface(const SurfaceContent& content, OutputFile& file,
                        const ParameterValues& /*values*/) const override
    {
        const Eigen::Vector3d shift = floatShift(content);
        if (const Status reached = checkFloatsReach(content, shift, file.target().string()); !reached)
            return reached;
        std::vector<TrianglesInFloats> kept;
        std::uint64_t triangles = 0;
        for (const SurfacePart& part : content.parts)
            triangles += kept.emplace_back(part, shift).count();
        if (triangles > std::numeric_limits<std::uint32_t>::max())
            return Error{ErrorKind::OutOfResource,
                         Message::say("'%1' would hold more than the 4294967295 triangles that an STL file can count. "
                                      "Write a .vtp file, or a surface of a larger error.",
                                      file.target().string())};
        file.expect(headBytes + sizeof(std::uint32_t) + triangles * triangleBytes);
        if (const Status written = file.text(stlHead(content, shift)); !written)
            return written;
        const auto count = static_cast<std::uint32_t>(triangles);
        if (const Status written = file.bytes(std::as_bytes(std::span(&count, 1))); !written)
            return written;
        for (std::size_t part = 0; part < kept.size(); ++part)
            if (const Status written = writeTriangles(content.parts[part], kept[part], shift, file); !written)
                return written;
        if (!shift.isZero(0))
            file.remark(Message::say(
                "In '%1' x, y and z are smaller than in the data by %2, %3 and %4, because single precision is too "
                "coarse so far from the origin: add these numbers to get places of the data.",
                file.target().string(), formatNumber(shift[0]), formatNumber(shift[1]), formatNumber(shift[2])));
        if (const std::uint64_t leftOut = content.triangleCount() - triangles; leftOut > 0)
            file.remark(leftOutInFloats(leftOut, file.target().string()));
        return {};
    }
};

} // namespace tetra

TAN_PLUGIN(tetra::StlWriter, tetra::Writer)
