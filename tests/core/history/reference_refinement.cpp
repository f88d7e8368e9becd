// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/history/reference_refinement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

namespace tetra {

namespace {

using Integer = __int128;
using Point = std::array<Integer, 3>;
using Sites = std::array<std::uint32_t, 4>;

Point minus(const Point& a, const Point& b)
{
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Integer determinant(const Point& a, const Point& b, const Point& c)
{
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

Integer orientation(const Point& a, const Point& b, const Point& c, const Point& d)
{
    return determinant(minus(b, a), minus(c, a), minus(d, a));
}

/// Positive if e is strictly inside the sphere through the positive tetrahedron a, b, c, d.
Integer inSphere(const std::array<Point, 4>& t, const Point& e)
{
    Integer sum = 0;
    for (int row = 0; row < 4; ++row) {
        std::array<Point, 3> others;
        for (int i = 0, other = 0; i < 4; ++i)
            if (i != row)
                others[other++] = minus(t[i], e);
        const Point r = minus(t[row], e);
        const Integer square = r[0] * r[0] + r[1] * r[1] + r[2] * r[2];
        sum += (row % 2 == 0 ? 1 : -1) * square * determinant(others[0], others[1], others[2]);
    }
    return sum;
}

struct Cell {
    Sites sites{};
    bool alive = true;
    double error = 0;
    double warping = 0;
    double key = 0; ///< the larger of the error and the weighted warping
    std::uint64_t worst = 0;
};

class SlowRefinement {
public:
    SlowRefinement(const Dataset& dataset, HistorySink& sink) : dataset_(dataset), sink_(sink) {}

    Status run(double stopKey);

private:
    Status start();
    Status insert(std::uint64_t point, double keyBefore);
    Status hand(std::uint64_t point, double keyBefore, const std::vector<Sites>& star,
                const std::vector<std::uint32_t>& destroyed);
    void measure(Cell& cell) const;
    Point coordinates(std::uint64_t point) const;
    Point place(std::uint32_t site) const { return coordinates(points_[site]); }
    const Cell* worst() const;

    const Dataset& dataset_;
    HistorySink& sink_;
    double warpingWeight_ = 0;
    std::vector<std::uint64_t> points_;
    std::vector<Cell> cells_;
};

Point SlowRefinement::coordinates(std::uint64_t point) const
{
    const auto c = dataset_.lattice.coordinates(point);
    return {Integer(c[0]), Integer(c[1]), Integer(c[2])};
}

/// The largest error of all points in the closed cell, and where.
void SlowRefinement::measure(Cell& cell) const
{
    std::array<Point, 4> p;
    for (int i = 0; i < 4; ++i)
        p[i] = place(cell.sites[i]);
    const double volume = static_cast<double>(orientation(p[0], p[1], p[2], p[3]));
    for (std::uint64_t point = 0; point < dataset_.lattice.pointCount(); ++point) {
        const Point q = coordinates(point);
        const std::array<Integer, 4> weights = {orientation(q, p[1], p[2], p[3]), orientation(p[0], q, p[2], p[3]),
                                                orientation(p[0], p[1], q, p[3]), orientation(p[0], p[1], p[2], q)};
        if (std::ranges::any_of(weights, [](Integer weight) { return weight < 0; }))
            continue;
        double difference = 0;
        for (int i = 0; i < 4; ++i)
            difference += static_cast<double>(weights[i]) *
                          (dataset_.values.at(points_[cell.sites[i]]) - dataset_.values.at(point));
        const double error = std::abs(difference) / volume;
        Eigen::Vector3d offset(0, 0, 0);
        if (dataset_.positions)
            for (int i = 0; i < 4; ++i)
                offset += static_cast<double>(weights[i]) / volume *
                          (dataset_.position(points_[cell.sites[i]]) - dataset_.position(point));
        const double key = std::max(error, warpingWeight_ * offset.norm());
        cell.error = std::max(cell.error, error);
        cell.warping = std::max(cell.warping, offset.norm());
        if (key > cell.key) {
            cell.key = key;
            cell.worst = point;
        }
    }
}

const Cell* SlowRefinement::worst() const
{
    const Cell* worst = nullptr;
    for (const Cell& cell : cells_)
        if (cell.alive && (worst == nullptr || cell.key > worst->key))
            worst = &cell;
    return worst;
}

/// The eight corners, and six tetrahedra around the diagonal, all made by the last corner.
Status SlowRefinement::start()
{
    const auto& size = dataset_.lattice.size;
    for (std::uint32_t corner = 0; corner < 8; ++corner) {
        const std::uint64_t point = dataset_.lattice.index(
            (corner & 1) * (size[0] - 1), (corner >> 1 & 1) * (size[1] - 1), (corner >> 2 & 1) * (size[2] - 1));
        std::vector<Sites> star;
        points_.push_back(point);
        if (corner == 7)
            star = {{7, 0, 3, 1}, {7, 0, 2, 3}, {7, 0, 6, 2}, {7, 0, 4, 6}, {7, 0, 5, 4}, {7, 0, 1, 5}};
        if (const Status added = hand(point, std::numeric_limits<double>::infinity(), star, {}); !added)
            return added;
    }
    return {};
}

Status SlowRefinement::insert(std::uint64_t point, double keyBefore)
{
    const Point p = coordinates(point);
    std::vector<std::uint32_t> destroyed;
    std::map<std::array<std::uint32_t, 3>, std::array<std::uint32_t, 3>> rim; // faces by their sorted sites
    for (std::uint32_t number = 0; number < cells_.size(); ++number) {
        Cell& cell = cells_[number];
        const Sites s = cell.sites;
        if (!cell.alive || inSphere({place(s[0]), place(s[1]), place(s[2]), place(s[3])}, p) <= 0)
            continue;
        cell.alive = false;
        destroyed.push_back(number);
        for (const std::array<std::uint32_t, 3>& face : {std::array{s[1], s[2], s[3]}, std::array{s[0], s[3], s[2]},
                                                         std::array{s[0], s[1], s[3]}, std::array{s[0], s[2], s[1]}}) {
            std::array<std::uint32_t, 3> key = face;
            std::ranges::sort(key);
            if (!rim.erase(key))
                rim.emplace(key, face);
        }
    }
    std::vector<Sites> star;
    const auto site = static_cast<std::uint32_t>(points_.size());
    points_.push_back(point);
    for (const auto& [key, face] : rim) // a face of the hull that the point lies in makes no tetrahedron
        if (orientation(p, place(face[0]), place(face[1]), place(face[2])) != 0)
            star.push_back({site, face[0], face[1], face[2]});
    return hand(point, keyBefore, star, destroyed);
}

Status SlowRefinement::hand(std::uint64_t point, double keyBefore, const std::vector<Sites>& star,
                            const std::vector<std::uint32_t>& destroyed)
{
    const auto roundedUp = [](double value) {
        const auto rounded = static_cast<float>(value);
        return rounded < value ? std::nextafter(rounded, std::numeric_limits<float>::infinity()) : rounded;
    };
    std::vector<HistoryTetrahedron> history;
    for (const Sites& sites : star) {
        Cell cell{sites};
        measure(cell);
        cells_.push_back(cell);
        history.push_back({{sites[1], sites[2], sites[3]}, roundedUp(cell.error), roundedUp(cell.warping)});
    }
    return sink_.add({point, roundedUp(keyBefore), history, destroyed});
}

Status SlowRefinement::run(double stopKey)
{
    if (dataset_.positions)
        warpingWeight_ = dataset_.values.range().extent() / dataset_.bounds().diagonal().norm();
    if (const Status begun = sink_.begin({warpingWeight_}); !begun)
        return begun;
    if (const Status started = start(); !started)
        return started;
    const Cell* next = worst();
    for (; next->key > stopKey; next = worst())
        if (const Status inserted = insert(next->worst, next->key); !inserted)
            return inserted;
    const auto finalKey = static_cast<float>(next->key);
    return sink_.finish(std::nextafter(finalKey, finalKey > 0 ? std::numeric_limits<float>::infinity() : 0));
}

} // namespace

Status refineSlowly(const Dataset& dataset, HistorySink& sink, double stopKey)
{
    return SlowRefinement(dataset, sink).run(stopKey);
}

} // namespace tetra
