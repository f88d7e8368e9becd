// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/value_colours.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace tetra {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

Colour mixedColour(const Colour& one, const Colour& other, float part)
{
    return {std::lerp(one.red, other.red, part), std::lerp(one.green, other.green, part),
            std::lerp(one.blue, other.blue, part)};
}

/// Values in whose range the colour is linear.
struct ColourSpan {
    double least = -unbounded;
    double largest = unbounded;
    Colour atLeast;
    Colour atLargest;

    Colour at(double value) const
    {
        if (!(largest - least < unbounded))
            return atLeast; // beyond the first and the last point
        return mixedColour(atLeast, atLargest, static_cast<float>((value - least) / (largest - least)));
    }
};

Colour colourOf(const TransferPoint& point)
{
    return {point.colour[0], point.colour[1], point.colour[2]};
}

/// From below the first point to above the last; none is empty.
std::vector<ColourSpan> spansOf(const TransferFunction& function)
{
    const auto& points = function.points;
    std::vector<ColourSpan> spans{{-unbounded, points.front().value, colourOf(points.front()), {}}};
    for (std::size_t i = 1; i < points.size(); ++i)
        if (points[i - 1].value < points[i].value)
            spans.push_back({points[i - 1].value, points[i].value, colourOf(points[i - 1]), colourOf(points[i])});
    spans.push_back({points.back().value, unbounded, colourOf(points.back()), {}});
    return spans;
}

/// The span of a value: the upper one at a point, as of the transfer function itself.
std::size_t spanOf(std::span<const ColourSpan> spans, double value)
{
    const auto above = std::ranges::upper_bound(spans, value, {}, &ColourSpan::least);
    return above == spans.begin() ? 0 : static_cast<std::size_t>(above - spans.begin()) - 1;
}

/// A corner of a piece of a triangle.
struct ColouredCorner {
    Eigen::Vector3d position;
    Eigen::Vector3f normal;
    double value;
    std::uint32_t vertex; ///< of the surface, or `cut`
};
constexpr std::uint32_t isNewVertex = 0xffffffff;

/// On the edge from one to the other, reckoned from the smaller value, so that both its triangles get the same place.
ColouredCorner cornerAt(double value, const ColouredCorner* one, const ColouredCorner* other)
{
    if (one->value > other->value)
        std::swap(one, other);
    const double part = (value - one->value) / (other->value - one->value);
    const auto single = static_cast<float>(part);
    return {one->position + part * (other->position - one->position),
            one->normal + single * (other->normal - one->normal), value, isNewVertex};
}

/// What of a convex polygon has values on one side of `value`.
std::vector<ColouredCorner> sideOf(const std::vector<ColouredCorner>& polygon, double value, bool above)
{
    const auto isInside = [&](const ColouredCorner& corner) {
        return above ? corner.value >= value : corner.value <= value;
    };
    std::vector<ColouredCorner> result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const ColouredCorner& current = polygon[i];
        const ColouredCorner& next = polygon[(i + 1) % polygon.size()];
        if (isInside(current))
            result.push_back(current);
        if (isInside(current) != isInside(next) && current.value != value && next.value != value)
            result.push_back(cornerAt(value, &current, &next));
    }
    return result;
}

class Colouring {
public:
    Colouring(const TriangleMesh& surface, std::vector<ColourSpan> spans) : surface_(surface), spans_(std::move(spans))
    {
        coloured_.positions = surface.positions;
        coloured_.normals = surface.normals;
        coloured_.values = surface.values;
        coloured_.triangles.reserve(surface.triangles.size());
        coloured_.colours.reserve(surface.positions.size());
        for (const float value : surface.values)
            coloured_.colours.push_back(spans_[spanOf(spans_, value)].at(value));
    }

    void add(const std::array<std::uint32_t, 3>& triangle);
    TriangleMesh take() { return std::move(coloured_); }

private:
    ColouredCorner cornerOf(std::uint32_t vertex) const
    {
        return {surface_.positions[vertex].cast<double>(), surface_.normals[vertex], surface_.values[vertex], vertex};
    }
    std::uint32_t numberOf(const ColouredCorner& corner, const ColourSpan& span);
    void addPiece(const std::vector<ColouredCorner>& polygon, const ColourSpan& span);

    const TriangleMesh& surface_;
    std::vector<ColourSpan> spans_;
    TriangleMesh coloured_;
};

/// A vertex of the surface itself where that has the span's colour, else a new one: at a cut, and on a step's lower
/// side.
std::uint32_t Colouring::numberOf(const ColouredCorner& corner, const ColourSpan& span)
{
    const Colour colour = span.at(corner.value);
    if (corner.vertex != isNewVertex && coloured_.colours[corner.vertex] == colour)
        return corner.vertex;
    const auto number = static_cast<std::uint32_t>(coloured_.positions.size());
    coloured_.positions.push_back(corner.position.cast<float>());
    coloured_.normals.push_back(corner.normal.normalized());
    coloured_.values.push_back(static_cast<float>(corner.value));
    coloured_.colours.push_back(colour);
    return number;
}

void Colouring::addPiece(const std::vector<ColouredCorner>& polygon, const ColourSpan& span)
{
    if (polygon.size() < 3)
        return;
    std::vector<std::uint32_t> numbers;
    for (const ColouredCorner& corner : polygon)
        numbers.push_back(numberOf(corner, span));
    for (std::size_t i = 2; i < numbers.size(); ++i)
        coloured_.triangles.push_back({numbers[0], numbers[i - 1], numbers[i]});
}

void Colouring::add(const std::array<std::uint32_t, 3>& triangle)
{
    const std::vector<ColouredCorner> corners = {cornerOf(triangle[0]), cornerOf(triangle[1]), cornerOf(triangle[2])};
    const auto [least, largest] = std::ranges::minmax(corners, {}, &ColouredCorner::value);
    // Cut upwards from the span of the smallest value; of a triangle of one value only that is there.
    std::size_t span = spanOf(spans_, least.value);
    std::vector<ColouredCorner> rest = corners;
    for (; spans_[span].largest < largest.value; ++span) {
        addPiece(sideOf(rest, spans_[span].largest, false), spans_[span]);
        rest = sideOf(rest, spans_[span].largest, true);
    }
    addPiece(rest, spans_[span]);
}

} // namespace

TriangleMesh colouredByValue(const TriangleMesh& surface, const TransferFunction& function)
{
    if (function.points.empty() || surface.values.empty())
        return surface;
    Colouring colouring(surface, spansOf(function));
    for (const auto& triangle : surface.triangles)
        colouring.add(triangle);
    return colouring.take();
}

} // namespace tetra
