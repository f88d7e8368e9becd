// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/mesh.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace tetra {

/// What is said of a mesh as a whole: field data of VTK files, comments of PLY files. Names are not empty.
using MeshFacts = std::vector<std::pair<std::string, std::variant<double, std::string>>>;

/// A number with its shortest digits, a text as it is.
inline std::string factText(const MeshFacts::value_type::second_type& fact)
{
    const auto* number = std::get_if<double>(&fact);
    if (number == nullptr)
        return std::get<std::string>(fact);
    std::array<char, 32> text{}; // -1.7976931348623157e+308 has 24 characters
    const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), *number);
    return {text.data(), end};
}

/// Whether floats hold all coordinates exactly. If not, formats that have doubles are written with them.
inline bool fitFloats(std::span<const Eigen::Vector3d> positions)
{
    return std::ranges::all_of(
        positions, [](const Eigen::Vector3d& position) { return position.cast<float>().cast<double>() == position; });
}

/// A number for each vertex, or for each tetrahedron, with a name.
struct NamedArray {
    using Values = std::variant<std::span<const float>, std::span<const double>, std::span<const std::uint8_t>,
                                std::span<const std::uint16_t>, std::span<const std::uint32_t>>;
    std::string name;
    Values values;

    std::size_t size() const
    {
        return std::visit([](const auto& all) { return all.size(); }, values);
    }
    std::size_t bytesOfValue() const
    {
        return std::visit([](const auto& all) { return sizeof(all[0]); }, values);
    }
};

/// What a file calls the array of a mesh's values: as their dataset calls them (ModelDescription::valueName), "value"
/// where it does not say. At most 80 bytes, none of which is a control character; a name that files have for other
/// arrays gets "value_" in front.
inline std::string valueArrayName(std::string_view ofDataset)
{
    constexpr std::array<std::string_view, 6> others = {"site",     "birth_error", "death_error",
                                                        "isovalue", "colour",      "Normals"};
    if (ofDataset.empty())
        return "value";
    const bool isTaken = std::ranges::find(others, ofDataset) != others.end();
    return (isTaken ? "value_" : "") + printable(ofDataset);
}

/// A mesh of tetrahedra to be written. Points into arrays that outlive the writing.
struct MeshContent {
    std::span<const Eigen::Vector3d> positions;
    std::span<const std::array<std::uint32_t, 4>> tetrahedra; ///< numbers of positions
    std::vector<NamedArray> pointArrays;                      ///< as many values as there are positions ...
    std::vector<NamedArray> cellArrays;                       ///< ... or tetrahedra
    MeshFacts facts;
};

/// One surface of several: an isosurface, or the boundary of a mesh. Points into arrays that outlive the writing.
struct SurfacePart {
    std::string name; ///< of the group or object, in the formats that have such
    std::span<const Eigen::Vector3d> positions;
    std::span<const Eigen::Vector3f> normals; ///< of length 1, one for each position; of all parts or of none
    std::span<const std::array<std::uint32_t, 3>> triangles; ///< numbers of the part's positions; counterclockwise
    /// One for each position, or one for all.
    std::variant<float, std::span<const float>> values = 0.0F;
    std::array<float, 4> colour = {0.8F, 0.8F, 0.8F, 1.0F}; ///< sRGB and opacity, for the formats that have colours
    /// Instead of that colour, but with its opacity: one for each position, sRGB, each channel in [0, 1]. Empty: none.
    std::span<const Colour> colours{};

    Colour colourAt(std::uint64_t vertex) const
    {
        return colours.empty() ? Colour{colour[0], colour[1], colour[2]} : colours[vertex];
    }

    float value(std::uint64_t vertex) const
    {
        const auto* each = std::get_if<std::span<const float>>(&values);
        return each != nullptr ? (*each)[vertex] : std::get<float>(values);
    }
};

/// A colour in the bytes that files have: sRGB, each channel from 0 to 255.
inline std::array<std::uint8_t, 3> colourBytes(const Colour& colour)
{
    const auto byte = [](float channel) {
        const float within = channel > 0 ? std::min(channel, 1.0F) : 0.0F;
        return static_cast<std::uint8_t>(within * 255 + 0.5F);
    };
    return {byte(colour.red), byte(colour.green), byte(colour.blue)};
}

/// Triangles to be written. In formats without parts, the parts' vertices and triangles come one part after the other.
struct SurfaceContent {
    std::string title;     ///< "isosurfaces", in the file's first line
    std::string valueName; ///< of the array of the parts' values
    std::vector<SurfacePart> parts;
    MeshFacts facts;
    /// As many values as all parts have triangles, part after part; for the formats that have such arrays.
    std::vector<NamedArray> cellArrays{};

    bool positionsFitFloats() const
    {
        return std::ranges::all_of(parts, [](const SurfacePart& part) { return fitFloats(part.positions); });
    }

    /// Of all parts together.
    std::uint64_t vertexCount() const
    {
        std::uint64_t count = 0;
        for (const SurfacePart& part : parts)
            count += part.positions.size();
        return count;
    }
    std::uint64_t triangleCount() const
    {
        std::uint64_t count = 0;
        for (const SurfacePart& part : parts)
            count += part.triangles.size();
        return count;
    }
    /// Whether a part has colours of its vertices. The formats without parts then give all vertices colours.
    bool hasColours() const
    {
        return std::ranges::any_of(parts, [](const SurfacePart& part) { return !part.colours.empty(); });
    }
    bool hasNormals() const
    {
        return std::ranges::any_of(parts, [](const SurfacePart& part) { return !part.normals.empty(); });
    }
};

inline Eigen::AlignedBox3d boundsOf(const SurfaceContent& content)
{
    Eigen::AlignedBox3d box;
    for (const SurfacePart& part : content.parts)
        for (const Eigen::Vector3d& position : part.positions)
            box.extend(position);
    return box;
}

/// Whether corners of a triangle that lie apart are one in floats, less a shift. Of such a triangle two edges are the
/// same, so that a closed surface is closed without it; with it, it would have a triangle without area.
inline bool mergesInFloats(const SurfacePart& part, const std::array<std::uint32_t, 3>& triangle,
                           const Eigen::Vector3d& shift)
{
    const auto merge = [&](std::uint32_t a, std::uint32_t b) {
        const Eigen::Vector3d& one = part.positions[a];
        const Eigen::Vector3d& other = part.positions[b];
        return one != other && (one - shift).cast<float>() == (other - shift).cast<float>();
    };
    const auto& [a, b, c] = triangle;
    return merge(a, b) || merge(b, c) || merge(c, a);
}

/// The triangles of a part but for those that mergesInFloats(). Keeps no list: there may be very many.
class TrianglesInFloats {
public:
    /// O(triangles). The part has to outlive this.
    TrianglesInFloats(const SurfacePart& part, const Eigen::Vector3d& shift) : part_(&part), shift_(shift)
    {
        leftOut_ = static_cast<std::uint64_t>(std::ranges::count_if(
            part.triangles, [&](const auto& triangle) { return mergesInFloats(part, triangle, shift); }));
    }
    std::uint64_t count() const { return part_->triangles.size() - leftOut_; }
    std::uint64_t leftOut() const { return leftOut_; }
    /// One after the other: to be called count() times.
    const std::array<std::uint32_t, 3>& next()
    {
        while (leftOut_ > 0 && mergesInFloats(*part_, part_->triangles[next_], shift_))
            ++next_;
        return part_->triangles[next_++];
    }

private:
    const SurfacePart* part_;
    Eigen::Vector3d shift_;
    std::uint64_t leftOut_ = 0;
    std::uint64_t next_ = 0;
};

/// What a writer remarks if it leaves out triangles of which mergesInFloats() is true.
inline Message leftOutInFloats(std::uint64_t triangles, const std::string& file)
{
    if (triangles == 1)
        return Message::say(
            "In '%1' one triangle is left out, because two of its corners coincide in single precision.", file);
    return Message::say("In '%1' %2 triangles are left out, because two corners of each coincide in single precision.",
                        file, triangles);
}

/// What formats that have floats alone subtract from all positions: nothing, unless the floats near the largest
/// coordinate lie farther apart than a thousandth of the mean edge, or a thousandth of the triangles would have corners
/// that are one; then about the least corner of the surface, in few binary digits: it is less by no more than the
/// surface is large. A writer says so by OutputFile::remark(), and in the file where it can. O(vertices + triangles).
inline Eigen::Vector3d floatShift(const SurfaceContent& content)
{
    const Eigen::AlignedBox3d box = boundsOf(content);
    double edges = 0;
    std::uint64_t triangles = 0;
    std::uint64_t collapsed = 0;
    for (const SurfacePart& part : content.parts) {
        for (const auto& triangle : part.triangles) {
            const auto& [a, b, c] = triangle;
            edges += (part.positions[b] - part.positions[a]).norm();
            collapsed += mergesInFloats(part, triangle, {0, 0, 0}) ? 1 : 0;
        }
        triangles += part.triangles.size();
    }
    if (triangles == 0)
        return {0, 0, 0};
    constexpr double share = 1000;
    const auto count = static_cast<double>(triangles);
    const double largest = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
    const double step = largest * static_cast<double>(std::numeric_limits<float>::epsilon());
    const bool isCoarse = step * share > edges / count || static_cast<double>(collapsed) * share > count;
    const double size = box.sizes().maxCoeff();
    // Of what is about as large as it is far away, a corner makes nothing finer.
    if (!isCoarse || !(size > 0) || !std::isfinite(size) || largest <= 2 * size)
        return {0, 0, 0};
    const double unit = std::exp2(std::floor(std::log2(size)));
    return (box.min().array() / unit).floor() * unit;
}

/// Such a format refuses a surface that is too large, or too small, for the exponents of floats, less the shift.
inline Status checkFloatsReach(const SurfaceContent& content, const Eigen::Vector3d& shift, const std::string& file)
{
    const Eigen::AlignedBox3d box = boundsOf(content);
    if (box.isEmpty())
        return {};
    constexpr double largest = std::numeric_limits<float>::max(), smallest = 1e-35;
    const double farthest =
        std::max((box.min() - shift).cwiseAbs().maxCoeff(), (box.max() - shift).cwiseAbs().maxCoeff());
    const double size = box.sizes().maxCoeff();
    if (farthest <= largest && (size == 0 || size >= smallest))
        return {};
    return Error{
        ErrorKind::WrongUsage,
        Message::say("'%1' has coordinates in single precision, which cannot hold this surface: it is too large "
                     "or too small. Write a .vtp or .ply file.",
                     file)};
}

} // namespace tetra
