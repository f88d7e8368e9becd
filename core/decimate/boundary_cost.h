// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/decimate/boundary_distance.h"
#include "core/decimate/collapse_star.h"
#include "core/decimate/collapsible_mesh.h"
#include "core/decimate/decimation.h"
#include "core/decimate/point_grid.h"
#include "core/decimate/vertex_star.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace tetra {

/// Which removed points of an irregular mesh are related to which triangle of its boundary: those outside, by their
/// projection (R5), and those of the original boundary, by their distance (R4), whether they lie in- or outside. The
/// distance of points outside counts as warping, too, so that there is always a place within it that bears the error.
class BoundaryPoints {
public:
    struct Relation {
        IndexPool::List outside;
        IndexPool::List ofBoundary;
        float error = 0;   ///< bound on those of the points outside
        float warping = 0; ///< bound on the distances of both
        /// Two-sided: no place of the triangle is farther from the original boundary; in `warping`, too.
        double distance = 0;
    };

    /// `positions` outlives this. May throw std::bad_alloc.
    BoundaryPoints(std::span<const Eigen::Vector3d> positions, std::uint32_t triangles)
        : relations_(triangles), everOutside_(positions, triangles)
    {
    }

    const Relation& operator[](std::uint32_t triangle) const
    {
        return relations_[triangle - CollapsibleMesh::firstTriangle];
    }
    std::span<const std::uint32_t> outside(std::uint32_t triangle) const { return pool_[(*this)[triangle].outside]; }
    std::span<const std::uint32_t> ofBoundary(std::uint32_t triangle) const
    {
        return pool_[(*this)[triangle].ofBoundary];
    }

    /// Calls visit(point) with each point in the box that is outside or was.
    template <class Visit> void visitEverOutside(const Eigen::AlignedBox3d& box, const Visit& visit) const
    {
        everOutside_.visitIn(box, visit);
    }

    void clear(std::uint32_t triangle);
    void addOutside(std::uint32_t triangle, std::uint32_t point, float error, float warping);
    void addOfBoundary(std::uint32_t triangle, std::uint32_t point, float warping);
    /// Of a new triangle.
    void setDistance(std::uint32_t triangle, double distance, float warping);
    /// Takes a point outside away. The bound stays.
    void takeOutside(std::uint32_t triangle, std::uint32_t point);

    void archive(StateArchive& archive) { archive(relations_, pool_, everOutside_); }

private:
    Relation& at(std::uint32_t triangle) { return relations_[triangle - CollapsibleMesh::firstTriangle]; }

    std::vector<Relation> relations_;
    IndexPool pool_;
    PointGrid everOutside_;
};

/// Judges collapses of boundary vertices of an irregular mesh: there removed points come to lie out- or inside, and the
/// distance of the original boundary changes (R4, R5). Points outside go to the nearest boundary triangle of the
/// tetrahedra that the collapse makes, never to one beyond: what is related to a tetrahedron is known when it is made,
/// and stays until it goes, so that its own error and warping hold in every mesh of the history that has it, whatever
/// else was collapsed there. For the same reason a point outside that a new tetrahedron takes in, but that is related
/// to one which stays, counts for both. Such a point may have belonged to any part of the mesh, as on the other side of
/// a gap, so they are looked for by their places. Coordinates are relative to the star's vertex.
class BoundaryCost {
public:
    static constexpr std::uint32_t none = CollapsibleMesh::none;

    BoundaryCost(const DecimationMesh& input, const CollapseMeasure& measure) : input_(input), measure_(measure) {}
    /// From now on the new boundary triangles' distances from the original boundary count as warpings, too, whatever
    /// the weights (S13). `toBoundary` outlives this.
    void countDistances(BoundaryDistance& toBoundary) { toBoundary_ = &toBoundary; }

    /// For collapses of a boundary vertex; `inside` are the removed points that its tetrahedra have, and itself.
    void set(const CollapsibleMesh& mesh, const VertexStar& star, std::span<const std::uint32_t> inside,
             const BoundaryPoints& relations);

    /// The largest of the errors and weighted warpings that a collapse gives, or, as soon as that exceeds `bound`, what
    /// it is so far. `fan` are the tetrahedra that it makes.
    double evaluate(const VertexStar& star, std::uint32_t linkPlace, const CollapseStar& fan, double bound);

    /// What becomes of a point by the collapse evaluated last.
    struct Error {
        std::uint32_t point = none;
        std::uint32_t keptBy = none;   ///< the triangle of the fan that it is related to until now and leaves
        std::uint32_t inFan = none;    ///< the face of the star whose tetrahedron has it; none: it lies outside
        std::uint32_t triangle = none; ///< then which boundary triangle is nearest
        double error = 0;              ///< weighted
        double warping = 0;            ///< weighted; the distance of a point outside
    };
    struct Warping {
        std::uint32_t point = none;
        std::uint32_t triangle = none; ///< the nearest
        double warping = 0;            ///< weighted
    };
    std::span<const Error> errors() const noexcept { return errors_; }
    std::span<const Warping> warpings() const noexcept { return warpings_; }
    struct Distance {
        std::uint32_t triangle = none; ///< a new one
        double distance = 0;           ///< no place of it is farther from the original boundary
    };
    std::span<const Distance> distances() const noexcept { return distances_; } ///< empty unless they count
    /// Whether a boundary triangle of the vertex becomes one of a tetrahedron that the collapse makes. Else it goes, or
    /// a tetrahedron that is there already gets it.
    static bool comesWithTetrahedron(const VertexStar& star, const VertexStar::RimTriangle& rim,
                                     std::uint32_t linkPlace)
    {
        return rim.corners[0] != linkPlace && rim.corners[1] != linkPlace && !star.holds(rim.slotPlace, linkPlace);
    }

private:
    using Vector = std::array<double, 3>;
    struct Triangle {
        std::uint32_t number = none;
        std::array<std::uint32_t, 3> vertices{};
        std::array<Vector, 3> corners{}; ///< from the star's vertex
        std::array<double, 3> values{};
        Vector least{}, greatest{}; ///< its box
    };

    struct Nearest {
        double squaredDistance = std::numeric_limits<double>::infinity();
        double value = 0;
        std::uint32_t triangle = none;
    };
    /// A removed point that the collapse may relate otherwise.
    struct Point {
        std::uint32_t point = none;
        std::uint32_t keptBy = none; ///< the triangle of the fan that it is related to already
        bool stays = false;          ///< as it is, unless a new tetrahedron has it
        Vector place{};
    };

    void findKept(const CollapsibleMesh& mesh, const VertexStar& star);
    void dropDoubles();
    void addPoint(std::uint32_t point, std::uint32_t keptBy, bool stays, std::vector<Point>& to);
    Vector placeOf(std::uint32_t vertex) const;
    Triangle triangleOf(std::uint32_t number, const std::array<std::uint32_t, 3>& corners) const;
    void approach(const Triangle& triangle, const Vector& place, Nearest& nearest) const;
    Nearest onFan(const Point& point) const;
    bool mayBeInStar(const Vector& place) const;
    double warpingOf(const Point& point, const Nearest& projection) const;
    double errorOf(const Point& point, double interpolated) const;
    double judgeError(const Point& point, const CollapseStar& fan);
    double judgeWarping(const Point& point);
    double stepOf(const VertexStar& star, std::uint32_t linkPlace) const;
    double judgeDistances(const VertexStar& star, std::uint32_t linkPlace, double cost, double bound);
    double weight(std::uint32_t point) const
    {
        return input_.weights.empty() ? 1 : static_cast<double>(input_.weights[point]);
    }

    const DecimationMesh& input_;
    const CollapseMeasure& measure_;
    BoundaryDistance* toBoundary_ = nullptr;
    double distance_ = 0; ///< of the star's boundary triangles the largest
    std::uint32_t vertex_ = none;
    Vector least_{}, greatest_{}; ///< the box of the star
    std::vector<Triangle> kept_;  ///< the boundary triangles opposite to the vertex, which new tetrahedra get
    std::vector<Triangle> fresh_; ///< the new boundary triangles of the collapse at hand
    std::vector<Point> points_;   ///< whose errors change
    std::vector<Point> distinct_;
    std::vector<std::pair<std::uint64_t, std::size_t>> ranks_; ///< of points_, which comes first, and their places
    std::vector<Point> ofBoundary_;
    std::vector<Error> errors_;
    std::vector<Warping> warpings_;
    std::vector<Distance> distances_;
};

} // namespace tetra
