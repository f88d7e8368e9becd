// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verify/two_sided_distance.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <vector>

namespace tetra {

namespace {

constexpr double relativeTolerance = 0.05;
constexpr double leastOfDiagonal = 1e-3;
constexpr int mostCuts = 8; ///< a triangle becomes at most 4^8 pieces

/// A piece of a triangle, to be looked at.
struct TrianglePiece {
    TriangleCorners corners;
    std::uint32_t hint = 0; ///< a triangle that may be near
    int cuts = 0;
};

Eigen::Vector3d middleOf(const TriangleCorners& t)
{
    return (t[0] + t[1] + t[2]) / 3;
}

class Search {
public:
    Search(const IrregularOriginal& original, double found)
        : tree_(original.tree), least_(leastOfDiagonal * original.diagonal), result_{found, found}
    {
    }

    BoundaryDistances run(const TriangleCorners& triangle)
    {
        waiting_ = {{triangle, tree_.nearest(middleOf(triangle)).triangle, 0}};
        while (!waiting_.empty()) {
            const TrianglePiece piece = waiting_.back();
            waiting_.pop_back();
            look(piece);
        }
        return result_;
    }

private:
    void look(const TrianglePiece& piece)
    {
        const Eigen::Vector3d middle = middleOf(piece.corners);
        const TriangleTree::Nearest nearest = tree_.nearest(middle, piece.hint);
        result_.found = std::max(result_.found, nearest.place.distance);
        // Distances change no faster than places; that to one triangle, which is convex, is largest at a corner.
        const TriangleCorners next = tree_.corners(nearest.triangle);
        double size = 0;
        double atCorners = 0;
        for (const Eigen::Vector3d& corner : piece.corners) {
            size = std::max(size, (corner - middle).norm());
            atCorners = std::max(atCorners, nearestPlace(next, corner).distance);
        }
        const double bound = std::min(nearest.place.distance + size, atCorners);
        if (bound > std::max((1 + relativeTolerance) * result_.found, least_) && piece.cuts < mostCuts)
            cut(piece, nearest.triangle);
        else
            result_.bound = std::max(result_.bound, bound);
    }

    void cut(const TrianglePiece& piece, std::uint32_t hint)
    {
        const TriangleCorners& c = piece.corners;
        const Eigen::Vector3d ab = (c[0] + c[1]) / 2, bc = (c[1] + c[2]) / 2, ca = (c[2] + c[0]) / 2;
        for (const TriangleCorners& part : {TriangleCorners{c[0], ab, ca}, TriangleCorners{ab, c[1], bc},
                                            TriangleCorners{ca, bc, c[2]}, TriangleCorners{ab, bc, ca}})
            waiting_.push_back({part, hint, piece.cuts + 1});
    }

    const TriangleTree& tree_;
    double least_;
    BoundaryDistances result_;
    std::vector<TrianglePiece> waiting_;
};

/// Points in increasing order, to compare triangles by.
PointTriangle inOrder(PointTriangle triangle)
{
    std::ranges::sort(triangle);
    return triangle;
}

} // namespace

BoundaryDistances distancesToOriginal(const IrregularOriginal& original, std::span<const PointTriangle> triangles)
{
    // What is a face of the original is nowhere far from it.
    std::vector<PointTriangle> known(original.boundary.size());
    std::ranges::transform(original.boundary, known.begin(), inOrder);
    std::ranges::sort(known);
    std::vector<TriangleCorners> others;
    for (const PointTriangle& t : triangles)
        if (!std::ranges::binary_search(known, inOrder(t)))
            others.push_back(
                {original.points.positions[t[0]], original.points.positions[t[1]], original.points.positions[t[2]]});
    std::vector<BoundaryDistances> found(others.size());
    tbb::parallel_for(std::size_t(0), others.size(), [&](std::size_t number) {
        found[number].found = original.tree.nearest(middleOf(others[number])).place.distance;
    });
    const auto largest = [&](double BoundaryDistances::*which) {
        double most = 0;
        for (const BoundaryDistances& one : found)
            most = std::max(most, one.*which);
        return most;
    };
    const double atMiddles = largest(&BoundaryDistances::found);
    tbb::parallel_for(std::size_t(0), others.size(),
                      [&](std::size_t number) { found[number] = Search(original, atMiddles).run(others[number]); });
    return {largest(&BoundaryDistances::found), largest(&BoundaryDistances::bound)};
}

} // namespace tetra
