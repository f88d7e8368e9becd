// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/history/query/slow_focus.h"

#include "core/refine/lattice/packed_lattice.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace tetra {

namespace {

using BigInteger = __int128;
using Vector = std::array<std::int64_t, 3>;

template <class Place> Vector difference(const Place& a, const Place& b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

BigInteger determinant(const Vector& a, const Vector& b, const Vector& c)
{
    return BigInteger(a[0]) * (b[1] * c[2] - b[2] * c[1]) + BigInteger(a[1]) * (b[2] * c[0] - b[0] * c[2]) +
           BigInteger(a[2]) * (b[0] * c[1] - b[1] * c[0]);
}

template <class Place> BigInteger sixVolumes(const Place& a, const Place& b, const Place& c, const Place& d)
{
    return determinant(difference(b, a), difference(c, a), difference(d, a));
}

/// The faces opposite to each vertex, seen from it as the tetrahedron is positive.
constexpr std::uint8_t faces[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

} // namespace

SlowFocus::Place SlowFocus::placeOf(std::uint32_t point) const
{
    const auto c = model_.description().lattice.coordinates(point);
    return {c[0], c[1], c[2]};
}

double SlowFocus::sampleAt(std::uint32_t point) const
{
    return visitSampleType(model_.description().sampleType, [&]<class T>() {
        return static_cast<double>(reinterpret_cast<const T*>(model_.samples().data())[point]);
    });
}

double SlowFocus::limitAt(const ErrorField& field, std::uint32_t point) const
{
    const auto c = model_.description().lattice.coordinates(point);
    return field.at(model_.description().lattice.position(c[0], c[1], c[2]), 0) / 100 *
           model_.description().range.extent();
}

bool SlowFocus::liesIn(const Tetrahedron& tetrahedron, const LatticeBox& box) const
{
    return std::ranges::all_of(tetrahedron, [&](std::uint32_t point) {
        const auto c = model_.description().lattice.coordinates(point);
        bool inside = true;
        for (std::size_t axis = 0; axis < 3; ++axis)
            inside = inside && c[axis] >= box.origin[axis] && c[axis] <= box.last(axis);
        return inside;
    });
}

void SlowFocus::insert(std::uint32_t point)
{
    const auto c = model_.description().lattice.coordinates(point);
    std::vector<std::uint32_t> blocks;
    division_.blocksOf(c, blocks);
    for (const std::uint32_t block : blocks)
        insertInto(division_.box(block), point);
    vertices_[point] = true;
}

void SlowFocus::insertInto(const LatticeBox& box, std::uint32_t point)
{
    const LatticeMetric metric = latticeMetric(division_.box(0).size, model_.description().lattice.spacing).value();
    const Place p = placeOf(point);
    const auto square = [&](const Vector& v) {
        return BigInteger(metric[0]) * v[0] * v[0] + BigInteger(metric[1]) * v[1] * v[1] +
               BigInteger(metric[2]) * v[2] * v[2];
    };
    const auto isStrictlyInside = [&](const Tetrahedron& t) {
        std::array<Vector, 4> v{};
        for (std::size_t i = 0; i < 4; ++i)
            v[i] = difference(placeOf(t[i]), p);
        return square(v[0]) * determinant(v[1], v[2], v[3]) - square(v[1]) * determinant(v[0], v[2], v[3]) +
                   square(v[2]) * determinant(v[0], v[1], v[3]) - square(v[3]) * determinant(v[0], v[1], v[2]) >
               0;
    };
    std::map<std::array<std::uint32_t, 3>, std::vector<std::array<std::uint32_t, 3>>> cavity;
    std::erase_if(mesh_, [&](const Tetrahedron& t) {
        if (!liesIn(t, box) || !isStrictlyInside(t))
            return false;
        for (const auto& face : faces) {
            const std::array<std::uint32_t, 3> corners = {t[face[0]], t[face[1]], t[face[2]]};
            std::array<std::uint32_t, 3> sorted = corners;
            std::ranges::sort(sorted);
            cavity[sorted].push_back(corners);
        }
        return true;
    });
    for (const auto& [sorted, sides] : cavity)
        if (sides.size() == 1 && sixVolumes(p, placeOf(sides[0][0]), placeOf(sides[0][1]), placeOf(sides[0][2])) != 0)
            mesh_.push_back({point, sides[0][0], sides[0][1], sides[0][2]});
}

/// The worst sample of each tetrahedron, the worst first.
std::vector<SlowFocus::Violation> SlowFocus::worstOf(const std::vector<Tetrahedron>& mesh, const ErrorField& field,
                                                     double room) const
{
    const Lattice& lattice = model_.description().lattice;
    const auto isWorse = [](const Violation& a, const Violation& b) {
        return std::tuple(-a.excess, -a.error, a.point) < std::tuple(-b.excess, -b.error, b.point);
    };
    std::vector<Violation> all;
    for (const Tetrahedron& t : mesh) {
        std::array<Place, 4> v{};
        for (std::size_t i = 0; i < 4; ++i)
            v[i] = placeOf(t[i]);
        const BigInteger volume = sixVolumes(v[0], v[1], v[2], v[3]);
        const auto range = [&](auto coordinate) {
            const auto [least, most] =
                std::minmax({v[0].*coordinate, v[1].*coordinate, v[2].*coordinate, v[3].*coordinate});
            return std::pair(least, most);
        };
        const auto [x0, x1] = range(&Place::x);
        const auto [y0, y1] = range(&Place::y);
        const auto [z0, z1] = range(&Place::z);
        std::vector<Violation> found;
        for (std::int64_t z = z0; z <= z1; ++z)
            for (std::int64_t y = y0; y <= y1; ++y)
                for (std::int64_t x = x0; x <= x1; ++x) {
                    const Place p{x, y, z};
                    const std::array<BigInteger, 4> weights = {
                        sixVolumes(p, v[1], v[2], v[3]), sixVolumes(p, v[0], v[3], v[2]),
                        sixVolumes(p, v[0], v[1], v[3]), sixVolumes(p, v[0], v[2], v[1])};
                    if (std::ranges::any_of(weights, [](BigInteger weight) { return weight < 0; }))
                        continue;
                    const auto point =
                        static_cast<std::uint32_t>(lattice.index(std::uint32_t(x), std::uint32_t(y), std::uint32_t(z)));
                    double sum = 0; // exact for integer samples
                    for (std::size_t i = 0; i < 4; ++i)
                        sum += static_cast<double>(weights[i]) * (sampleAt(point) - sampleAt(t[i]));
                    const double error = std::abs(sum) / static_cast<double>(volume);
                    const double limit = limitAt(field, point);
                    if (error > limit + room)
                        found.push_back({error / limit, error, point, t});
                }
        if (!found.empty())
            all.push_back(*std::ranges::min_element(found, isWorse));
    }
    std::ranges::sort(all, isWorse);
    return all;
}

/// Whether the mesh before the site was not good enough where the site lies or, of a box, at any point next to it.
bool SlowFocus::asksFor(const SpaceRamp& ramp, std::uint32_t site) const
{
    const ErrorField field(ramp);
    const Lattice& lattice = model_.description().lattice;
    const Place place = placeOf(model_.points()[site]);
    const std::int64_t reach = std::holds_alternative<Box>(ramp.region) && ramp.falloff == 0 ? 1 : 0;
    const double most = ramp.outer / 100 * model_.description().range.extent();
    const auto asks = [&](std::int64_t x, std::int64_t y, std::int64_t z) {
        if (x < 0 || y < 0 || z < 0 || x >= lattice.size[0] || y >= lattice.size[1] || z >= lattice.size[2])
            return false;
        const auto point = lattice.index(std::uint32_t(x), std::uint32_t(y), std::uint32_t(z));
        const double limit = limitAt(field, static_cast<std::uint32_t>(point));
        return limit<most&& static_cast<double>(model_.runningKeys()[site])> limit;
    };
    for (std::int64_t z = -reach; z <= reach; ++z)
        for (std::int64_t y = -reach; y <= reach; ++y)
            for (std::int64_t x = -reach; x <= reach; ++x)
                if (asks(place.x + x, place.y + y, place.z + z))
                    return true;
    return false;
}

std::vector<Tetrahedron> SlowFocus::meshOf(const SpaceRamp& ramp)
{
    const ErrorField field(ramp);
    const std::uint32_t coarse = meshSizeAt(model_, {ramp.outer}).sites;
    const TetrahedralMesh mesh = extractPrefix(model_, coarse).value();
    mesh_.clear();
    for (const auto& t : mesh.tetrahedra)
        mesh_.push_back({model_.points()[t[0]], model_.points()[t[1]], model_.points()[t[2]], model_.points()[t[3]]});
    vertices_.assign(model_.description().lattice.pointCount(), false);
    for (std::uint32_t site = 0; site < coarse; ++site)
        vertices_[model_.points()[site]] = true;
    for (std::uint32_t site = coarse; site < model_.siteCount(); ++site)
        if (!vertices_[model_.points()[site]] && asksFor(ramp, site))
            insert(model_.points()[site]);
    for (;;) {
        const std::vector<Violation> worst = worstOf(mesh_, field, 0);
        if (worst.empty())
            return mesh_;
        for (const Violation& one : worst)
            if (std::ranges::find(mesh_, one.tetrahedron) != mesh_.end())
                insert(one.point);
    }
}

std::string SlowFocus::faultOf(const std::vector<Tetrahedron>& mesh, const SpaceRamp& ramp, double room) const
{
    const auto& size = model_.description().lattice.size;
    std::map<std::array<std::uint32_t, 3>, int> sides;
    BigInteger volume = 0;
    for (const Tetrahedron& t : mesh) {
        const BigInteger own = sixVolumes(placeOf(t[0]), placeOf(t[1]), placeOf(t[2]), placeOf(t[3]));
        if (own <= 0)
            return "a tetrahedron is flat or inverted";
        volume += own;
        for (const auto& face : faces) {
            std::array<std::uint32_t, 3> corners = {t[face[0]], t[face[1]], t[face[2]]};
            std::ranges::sort(corners);
            ++sides[corners];
        }
    }
    if (volume != BigInteger(6) * (size[0] - 1) * (size[1] - 1) * (size[2] - 1))
        return "the tetrahedra do not fill the domain";
    for (const auto& [corners, count] : sides) {
        const Place a = placeOf(corners[0]), b = placeOf(corners[1]), c = placeOf(corners[2]);
        const auto onPlane = [&](auto coordinate, std::int64_t plane) {
            return a.*coordinate == plane && b.*coordinate == plane && c.*coordinate == plane;
        };
        const bool outside = onPlane(&Place::x, 0) || onPlane(&Place::x, size[0] - 1) || onPlane(&Place::y, 0) ||
                             onPlane(&Place::y, size[1] - 1) || onPlane(&Place::z, 0) ||
                             onPlane(&Place::z, size[2] - 1);
        if (count != (outside ? 1 : 2))
            return "a face is in " + std::to_string(count) + " tetrahedra";
    }
    const std::vector<Violation> worst = worstOf(mesh, ramp, room);
    if (!worst.empty())
        return "point " + std::to_string(worst[0].point) + " has error " + std::to_string(worst[0].error) + ", " +
               std::to_string(worst[0].excess) + " times its limit";
    return {};
}

} // namespace tetra
