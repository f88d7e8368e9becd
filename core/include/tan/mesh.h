// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// tan/mesh.h: meshes as plain arrays, and regions of space.
///
/// A query gives a TetrahedralMesh, an isosurface is a TriangleMesh. Both are structures of arrays that one may read,
/// change, draw or write with any other library; they know nothing of each other or of the model.
///
/// ~~~{.cpp}
/// /// The volume of a mesh, in the cube of its unit of length.
/// double volumeOf(const tetra::TetrahedralMesh& mesh)
/// {
///     double volume = 0;
///     for (const auto& [a, b, c, d] : mesh.tetrahedra) {
///         const auto edge = [&](std::uint32_t to) -> Eigen::Vector3d {
///             return mesh.positions[to] - mesh.positions[a];
///         };
///         volume += edge(b).dot(edge(c).cross(edge(d))) / 6;
///     }
///     return volume;
/// }
/// ~~~

#include <tan/base.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <memory>
#include <utility>
#include <variant>

namespace tetra {

/// A conforming tetrahedral mesh with a value at each vertex (2.2), as plain arrays. What extraction gives and what
/// graphics draws. Tetrahedra (a, b, c, d) are positive: (b-a) . ((c-a) x (d-a)) > 0.
struct TetrahedralMesh {
    Buffer<Eigen::Vector3d> positions;               ///< those of the dataset, to the last bit
    Buffer<float> values;                            ///< as many as positions; rounded to floats
    Buffer<std::array<std::uint32_t, 4>> tetrahedra; ///< numbers of positions
};

/// The mesh reordered for spatial locality: vertices along a Hilbert curve (corners are renumbered, vertices without
/// tetrahedra stay), tetrahedra by their smallest vertex. Drawing, sorting and contouring are several times quicker
/// than in order of construction, and chunks of tetrahedra have narrow ranges of values. Worth it for a mesh that
/// is drawn or contoured often. O(vertices + tetrahedra), on all threads of the current TBB arena, the same result with
/// any number of them; 16 bytes a tetrahedron besides the result while it runs. Errors: arrays that do not belong
/// together, corners that do not exist, cancelled, not enough memory.
TAN_API Result<TetrahedralMesh> inSpatialOrder(const TetrahedralMesh& mesh, const Progress& progress = {});

/// A mesh with a copy in spatial order, which is made when it is first asked for. Share it between all that use the
/// mesh. Used from one thread at a time.
class TAN_API OrderedMesh {
public:
    explicit OrderedMesh(std::shared_ptr<const TetrahedralMesh> mesh) : original_(std::move(mesh)) {}

    const std::shared_ptr<const TetrahedralMesh>& original() const noexcept { return original_; }
    bool isOrdered() const noexcept { return ordered_ != nullptr; }
    /// Errors: those of inSpatialOrder().
    Result<std::shared_ptr<const TetrahedralMesh>> ordered(const Progress& progress = {});

private:
    std::shared_ptr<const TetrahedralMesh> original_;
    std::shared_ptr<const TetrahedralMesh> ordered_;
};

/// A colour in sRGB, each channel in [0, 1].
struct Colour {
    float red = 0;
    float green = 0;
    float blue = 0;
    bool operator==(const Colour&) const = default;
};

/// Triangles with shared vertices and a unit normal at each; colours and values are linear between vertices.
struct TriangleMesh {
    Buffer<Eigen::Vector3d> positions;
    Buffer<Eigen::Vector3f> normals;
    Buffer<std::array<std::uint32_t, 3>> triangles;
    Buffer<float> values{};   ///< of the field at each vertex; empty if unknown
    Buffer<Colour> colours{}; ///< of each vertex; empty where the surface's colour holds
};

// Regions of space, closed and convex; lengths are those of the dataset.

struct Sphere {
    Eigen::Vector3d centre{0, 0, 0};
    double radius = 0; ///< 0: a point, such as the position of a camera
    bool operator==(const Sphere&) const = default;
};
/// The points with normal . x <= offset; `normal`, a unit vector, points out of it. (Of a ClipPlane the other side is
/// shown.)
struct HalfSpace {
    Eigen::Vector3d normal{0, 0, 1};
    double offset = 0;
    bool operator==(const HalfSpace&) const = default;
};
struct Box {
    Eigen::Vector3d least{0, 0, 0};
    Eigen::Vector3d largest{0, 0, 0};
    bool operator==(const Box&) const = default;
};
using Region = std::variant<Box, Sphere, HalfSpace>;

/// Where something finer is shown than elsewhere, and how far it fades into what is shown there: its weight is 1 in the
/// shape and falls with the distance from it, to 0 at `border`. Of several regions the largest weight counts.
struct FocusRegion {
    std::variant<Box, Sphere> shape{};
    double border = 0; ///< in the units of the dataset; 0 is a sharp one
    bool operator==(const FocusRegion&) const = default;
};

} // namespace tetra
