// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/cpu/draw_list.h"

#include "core/render/cpu/tile_bins.h"
#include "core/render/scene_checks.h"
#include "core/render/view_transform.h"

#include <tan/render.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <variant>

namespace tetra {

namespace {

/// A corner before the division by w.
struct ClipVertex {
    Eigen::Vector4d position{0, 0, 0, 1};
    Eigen::Vector3f normal{0, 0, 1};
    Eigen::Vector3f colour{0, 0, 0}; ///< red, green, blue; where vertices have colours
};

/// How far beyond the picture's edge a corner may lie, in units of half the picture, before its triangle is cut: far
/// enough that few are, near enough for 32-bit coordinates.
constexpr double guardBand = 3;

/// On which sides of the view a corner lies outside, as bits.
namespace outside_view {
constexpr std::uint8_t left = 1;
constexpr std::uint8_t right = 2;
constexpr std::uint8_t below = 4;
constexpr std::uint8_t above = 8;
constexpr std::uint8_t near = 16;
constexpr std::uint8_t guard = 32;
constexpr std::uint8_t notFinite = 64;
/// Sides such that a triangle wholly beyond one of them is invisible.
constexpr std::uint8_t view = left | right | below | above | near;
/// What calls for cutting.
constexpr std::uint8_t cut = near | guard;
} // namespace outside_view

/// A convex polygon with as many corners as a triangle can get from five cuts.
struct ClippedPolygon {
    std::array<ClipVertex, 8> corners;
    std::size_t count = 0;
};

/// The signed distance from a cutting plane; inside is not negative.
double distanceFrom(std::size_t plane, const Eigen::Vector4d& p)
{
    switch (plane) {
    case 0: return p.z() + p.w();
    case 1: return guardBand * p.w() - p.x();
    case 2: return guardBand * p.w() + p.x();
    case 3: return guardBand * p.w() - p.y();
    default: return guardBand * p.w() + p.y();
    }
}

/// Always from the inner end, so that both triangles at an edge compute the same.
ClipVertex cutPoint(const ClipVertex& inner, double innerDistance, const ClipVertex& outer, double outerDistance)
{
    const double fraction = innerDistance / (innerDistance - outerDistance);
    const auto part = static_cast<float>(fraction);
    return {inner.position + fraction * (outer.position - inner.position),
            inner.normal + part * (outer.normal - inner.normal), inner.colour + part * (outer.colour - inner.colour)};
}

ClippedPolygon cutBy(std::size_t plane, const ClippedPolygon& polygon)
{
    ClippedPolygon result;
    for (std::size_t i = 0; i < polygon.count; ++i) {
        const ClipVertex& current = polygon.corners[i];
        const ClipVertex& next = polygon.corners[(i + 1) % polygon.count];
        const double here = distanceFrom(plane, current.position);
        const double there = distanceFrom(plane, next.position);
        if (here >= 0)
            result.corners[result.count++] = current;
        if (here >= 0 && there < 0)
            result.corners[result.count++] = cutPoint(current, here, next, there);
        else if (here < 0 && there >= 0)
            result.corners[result.count++] = cutPoint(next, there, current, here);
    }
    return result;
}

std::uint8_t outsideBits(const Eigen::Vector4d& p) noexcept
{
    if (!p.allFinite())
        return outside_view::notFinite;
    const double w = p.w();
    unsigned bits = 0;
    bits |= p.x() < -w ? outside_view::left : 0u;
    bits |= p.x() > w ? outside_view::right : 0u;
    bits |= p.y() < -w ? outside_view::below : 0u;
    bits |= p.y() > w ? outside_view::above : 0u;
    bits |= p.z() < -w || w <= 0 ? outside_view::near : 0u;
    bits |= std::abs(p.x()) > guardBand * w || std::abs(p.y()) > guardBand * w ? outside_view::guard : 0u;
    return static_cast<std::uint8_t>(bits);
}

/// The part of a triangle behind the near plane and inside the guard band. Triangles that share an edge get the same
/// new corners on it, bit for bit.
ClippedPolygon clipTriangle(const std::array<ClipVertex, 3>& triangle)
{
    ClippedPolygon polygon;
    for (const ClipVertex& corner : triangle)
        polygon.corners[polygon.count++] = corner;
    for (std::size_t plane = 0; plane < 5 && polygon.count > 0; ++plane)
        polygon = cutBy(plane, polygon);
    return polygon;
}

constexpr std::size_t trianglesInChunk = 1 << 14;

/// Puts corners to their places among the samples.
class Projector {
public:
    Projector(const ViewTransform& transform, const SampleRectangle& part, SamplePlaces places)
        : transform_(transform), part_(part), left_(places == SamplePlaces::Rays ? sampleX - 0.5 : 0),
          up_(places == SamplePlaces::Rays ? sampleY - 0.5 : 0),
          steps_(places == SamplePlaces::Rays ? subsampleSteps : 256)
    {
    }

    Eigen::Vector4d toClip(const Eigen::Vector3d& position) const
    {
        return transform_.clipFromWorld * position.homogeneous();
    }

    ScreenVertex toScreen(const ClipVertex& vertex) const
    {
        const double inverse = 1 / vertex.position.w();
        ScreenVertex result;
        result.x = fixed((vertex.position.x() * inverse + 1) / 2 * transform_.width - left_, part_.left);
        result.y = fixed((1 - vertex.position.y() * inverse) / 2 * transform_.height - up_, part_.top);
        result.nearness = static_cast<float>(nearnessOf(transform_, vertex.position));
        result.weight = static_cast<float>(inverse);
        result.normal = vertex.normal;
        return result;
    }

    const ViewTransform& transform() const noexcept { return transform_; }
    /// The samples of the part, from its own corner.
    SampleRectangle samples() const noexcept { return {0, 0, part_.width(), part_.height()}; }
    bool isWhole() const noexcept { return part_.width() >= transform_.width && part_.height() >= transform_.height; }

private:
    std::int32_t fixed(double samples, int first) const
    {
        const auto place = static_cast<std::int32_t>(std::floor(samples * steps_ + 0.5));
        return (place - first * steps_) * (subsampleSteps / steps_);
    }

    const ViewTransform& transform_;
    SampleRectangle part_;
    double left_, up_; ///< by how much the picture is moved, so that the samples come to the middles
    std::int32_t steps_;
};

/// The triangles of one run, and the corners that cutting made. Corner numbers with the top bit set count these.
struct DrawnPiece {
    static constexpr std::uint32_t own = 0x80000000;
    std::vector<ScreenVertex> vertices;
    std::vector<Colour> colours; ///< of the vertices
    std::vector<ScreenTriangle> triangles;

    void addPolygon(const ClippedPolygon& polygon, const Projector& projector, std::uint32_t look)
    {
        const std::uint32_t first = own | static_cast<std::uint32_t>(vertices.size());
        for (std::size_t i = 0; i < polygon.count; ++i) {
            const ClipVertex& corner = polygon.corners[i];
            vertices.push_back(projector.toScreen(corner));
            colours.push_back({corner.colour.x(), corner.colour.y(), corner.colour.z()});
        }
        for (std::uint32_t i = 2; i < polygon.count; ++i)
            triangles.push_back({{first, first + i - 1, first + i}, look});
    }
};

/// Whether the eye sees a triangle counterclockwise, wherever its corners lie: the side of its plane that the eye is on
/// (M. Olano and T. Greer, "Triangle Scan Conversion using 2D Homogeneous Coordinates", 1997).
bool facesEye(const std::array<Eigen::Vector4d, 3>& corners)
{
    Eigen::Matrix3d places;
    for (int i = 0; i < 3; ++i)
        places.col(i) << corners[static_cast<std::size_t>(i)].x(), corners[static_cast<std::size_t>(i)].y(),
            corners[static_cast<std::size_t>(i)].w();
    return places.determinant() > 0;
}

class Builder {
public:
    Builder(const Projector& projector, DrawList& list, const Progress& progress)
        : projector_(projector), list_(list), progress_(progress)
    {
    }

    Status addSurface(const Surface& surface, bool overlay);
    void addLines(const LineSet& lines, double samplesPerPixelAxis);

private:
    ClipVertex toClip(const TriangleMesh& mesh, std::uint32_t vertex) const
    {
        ClipVertex corner{projector_.toClip(mesh.positions[vertex]), mesh.normals[vertex]};
        if (!mesh.colours.empty()) {
            const Colour& colour = mesh.colours[vertex];
            corner.colour = {colour.red, colour.green, colour.blue};
        }
        return corner;
    }
    std::uint32_t addLook(const SurfaceLook& look)
    {
        list_.looks.push_back(look);
        return static_cast<std::uint32_t>(list_.looks.size() - 1);
    }
    Buffer<std::uint8_t> projectVertices(const TriangleMesh& mesh);
    DrawnPiece projectTriangles(const Surface& surface, std::size_t first, std::size_t last,
                                const Buffer<std::uint8_t>& bits, std::uint32_t firstVertex, std::uint32_t look) const;
    bool isDrawn(const Surface& surface, const std::array<std::uint32_t, 3>& triangle) const;
    void append(std::span<const DrawnPiece> pieces, bool coloured);

    const Projector& projector_;
    DrawList& list_;
    const Progress& progress_;
};

/// Adds the projected vertices; returns on which sides of the view they lie.
Buffer<std::uint8_t> Builder::projectVertices(const TriangleMesh& mesh)
{
    const std::size_t before = list_.vertices.size();
    list_.vertices.resize(before + mesh.positions.size());
    Buffer<std::uint8_t> bits(mesh.positions.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, bits.size(), trianglesInChunk), [&](const auto& range) {
        if (progress_.cancelled())
            return;
        for (std::size_t v = range.begin(); v != range.end(); ++v) {
            const ClipVertex vertex = toClip(mesh, static_cast<std::uint32_t>(v));
            bits[v] = outsideBits(vertex.position);
            if ((bits[v] & (outside_view::cut | outside_view::notFinite)) == 0)
                list_.vertices[before + v] = projector_.toScreen(vertex);
        }
    });
    return bits;
}

bool Builder::isDrawn(const Surface& surface, const std::array<std::uint32_t, 3>& triangle) const
{
    const auto corner = [&](std::size_t i) { return projector_.toClip(surface.mesh->positions[triangle[i]]); };
    return !surface.backFacesOnly || !facesEye({corner(0), corner(1), corner(2)});
}

DrawnPiece Builder::projectTriangles(const Surface& surface, std::size_t first, std::size_t last,
                                     const Buffer<std::uint8_t>& bits, std::uint32_t firstVertex,
                                     std::uint32_t look) const
{
    DrawnPiece piece;
    const TriangleMesh& mesh = *surface.mesh;
    for (std::size_t t = first; t != last; ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        const unsigned all = bits[a] & bits[b] & bits[c];
        const unsigned any = bits[a] | bits[b] | bits[c];
        if ((all & outside_view::view) != 0 || (any & outside_view::notFinite) != 0 ||
            !isDrawn(surface, mesh.triangles[t]))
            continue;
        if ((any & outside_view::cut) == 0) {
            const ScreenTriangle triangle{{firstVertex + a, firstVertex + b, firstVertex + c}, look};
            if (projector_.isWhole() || !isEmpty(samplesUnder(list_, triangle, projector_.samples())))
                piece.triangles.push_back(triangle);
        } else
            piece.addPolygon(clipTriangle({toClip(mesh, a), toClip(mesh, b), toClip(mesh, c)}), projector_, look);
    }
    return piece;
}

void Builder::append(std::span<const DrawnPiece> pieces, bool coloured)
{
    for (const DrawnPiece& piece : pieces) {
        const auto firstOwn = static_cast<std::uint32_t>(list_.vertices.size());
        list_.vertices.insert(list_.vertices.end(), piece.vertices.begin(), piece.vertices.end());
        if (coloured)
            list_.colours.insert(list_.colours.end(), piece.colours.begin(), piece.colours.end());
        for (ScreenTriangle triangle : piece.triangles) {
            for (std::uint32_t& vertex : triangle.vertices)
                if ((vertex & DrawnPiece::own) != 0)
                    vertex = firstOwn + (vertex & ~DrawnPiece::own);
            list_.triangles.push_back(triangle);
        }
    }
}

Status Builder::addSurface(const Surface& surface, bool overlay)
{
    if (!surface.mesh || !(surface.opacity > 0))
        return {};
    const TriangleMesh& mesh = *surface.mesh;
    if (Status status = checkMesh(mesh); !status)
        return status;
    if (mesh.positions.size() + list_.vertices.size() >= DrawnPiece::own)
        return Error{ErrorKind::OutOfResource, Message::say("The scene has more than two billion vertices.")};
    const bool coloured = !mesh.colours.empty();
    const float opacity = overlay ? 1 : std::min(surface.opacity, 1.0f);
    const std::uint32_t look =
        addLook({surface.colour, opacity, isLit(surface), !overlay, coloured, overlay ? nullptr : surface.share.get()});
    const auto firstVertex = static_cast<std::uint32_t>(list_.vertices.size());
    const Buffer<std::uint8_t> bits = projectVertices(mesh);
    if (coloured) {
        list_.colours.resize(firstVertex); // of what has no colours
        list_.colours.insert(list_.colours.end(), mesh.colours.begin(), mesh.colours.end());
    }
    std::vector<DrawnPiece> pieces((mesh.triangles.size() + trianglesInChunk - 1) / trianglesInChunk);
    tbb::parallel_for(std::size_t(0), pieces.size(), [&](std::size_t p) {
        if (progress_.cancelled())
            return;
        const std::size_t first = p * trianglesInChunk;
        const std::size_t last = std::min(first + trianglesInChunk, mesh.triangles.size());
        pieces[p] = projectTriangles(surface, first, last, bits, firstVertex, look);
    });
    if (!progress_.cancelled())
        append(pieces, coloured);
    return {};
}

void Builder::addLines(const LineSet& lines, double samplesPerPixelAxis)
{
    const std::uint32_t look = addLook({lines.colour, 1, false, false});
    DrawnPiece piece;
    for (const LineQuad& quad : thickLines(lines, projector_.transform(), lines.width * samplesPerPixelAxis))
        for (const auto& [b, c] : {std::array{1, 2}, std::array{2, 3}})
            piece.addPolygon(clipTriangle({ClipVertex{quad[0]}, ClipVertex{quad[static_cast<std::size_t>(b)]},
                                           ClipVertex{quad[static_cast<std::size_t>(c)]}}),
                             projector_, look);
    append({&piece, 1}, false);
}

} // namespace

Result<DrawList> makeDrawList(const Scene& scene, const ViewTransform& transform, const SampleRectangle& part,
                              double samplesPerPixelAxis, SamplePlaces places, const Progress& progress)
{
    DrawList list;
    const Projector projector(transform, part, places);
    Builder builder(projector, list, progress);
    const auto add = [&](const Drawable& drawable) -> Status {
        if (const auto* surface = std::get_if<Surface>(&drawable.shape))
            return builder.addSurface(*surface, drawable.overlay);
        if (const auto* lines = std::get_if<LineSet>(&drawable.shape)) {
            if (Status status = checkLines(*lines); !status)
                return status;
            builder.addLines(*lines, samplesPerPixelAxis);
        }
        return {};
    };
    // Surfaces before lines: of opaque things at the same place the first is seen.
    for (const bool areLines : {false, true})
        for (const Drawable& drawable : scene.drawables)
            if (!drawable.overlay && std::holds_alternative<LineSet>(drawable.shape) == areLines)
                if (Status status = add(drawable); !status)
                    return status.error();
    float nearness = overlayNearness;
    for (const Drawable& drawable : scene.drawables) {
        if (!drawable.overlay)
            continue;
        const std::size_t first = list.vertices.size();
        if (Status status = add(drawable); !status)
            return status.error();
        for (std::size_t vertex = first; vertex < list.vertices.size(); ++vertex)
            list.vertices[vertex].nearness = nearness;
        nearness = std::nextafter(nearness, 2 * overlayNearness);
    }
    return list;
}

} // namespace tetra
