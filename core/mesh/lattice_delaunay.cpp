// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/lattice_delaunay.h"

#include <algorithm>

namespace tetra {

namespace {

/// The vertices of the face opposite to each vertex, so that (point beyond the vertex's side, face) is positive.
constexpr std::uint8_t faceVertices[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

/// Slots for every tetrahedron that can be alive at once: six to seven a vertex, with room to spare.
std::uint64_t slotCapacity(const std::array<std::uint32_t, 3>& size)
{
    return std::min<std::uint64_t>(10 * (std::uint64_t(size[0]) * size[1] * size[2]) + 4096, 0xfffffff0);
}

} // namespace

Status LatticeDelaunay::start(const std::array<std::uint32_t, 3>& size, const LatticeMetric& metric,
                              bool centreAtOrigin)
{
    if (!PackedLattice::fits(size))
        return Error{ErrorKind::OutOfResource,
                     "The lattice has too many points to be refined as a whole. Crop or subsample it."};
    lattice_ = PackedLattice(size);
    for (std::size_t axis = 0; axis < 3; ++axis)
        weights_[axis] = metric[axis];
    if (const Status status = tetrahedra_.reserve(slotCapacity(size), "the tetrahedra of the refinement"); !status)
        return status;
    freeSlots_.clear();
    slotCount_ = startCount;

    std::array<PackedPoint, 8> corners{};
    for (std::uint32_t corner = 0; corner < 8; ++corner)
        corners[corner] = lattice_.pack((corner & 1) * (size[0] - 1), (corner >> 1 & 1) * (size[1] - 1),
                                        (corner >> 2 & 1) * (size[2] - 1));
    // Four corners are cut off; the other four span the fifth tetrahedron, slot 4.
    constexpr std::uint8_t cutAtOdd[5][4] = {{1, 0, 3, 5}, {2, 3, 0, 6}, {4, 5, 6, 0}, {7, 3, 6, 5}, {0, 3, 5, 6}};
    for (std::uint32_t slot = 0; slot < startCount; ++slot) {
        std::array<PackedPoint, 4> vertices{};
        for (std::size_t i = 0; i < 4; ++i)
            vertices[i] = corners[cutAtOdd[slot][i] ^ (centreAtOrigin ? 0u : 1u)];
        star_.clear(lattice_, vertices[0]);
        star_.addFace(vertices[1], vertices[2], vertices[3]);
        star_.finish(weights_);
        if (star_.quantity(Star::Determinant)[0] < 0) {
            std::swap(vertices[2], vertices[3]);
            star_.clear(lattice_, vertices[0]);
            star_.addFace(vertices[1], vertices[2], vertices[3]);
            star_.finish(weights_);
        }
        tetrahedra_[slot] = {vertices,
                             {none, none, none, none},
                             star_.quantity(Star::Determinant)[0],
                             {star_.quantity(Star::Centre)[0], star_.quantity(Star::Centre + 1)[0],
                              star_.quantity(Star::Centre + 2)[0]}};
    }
    DelaunayTetrahedron& centre = tetrahedra_[4];
    for (std::uint32_t slot = 0; slot < 4; ++slot) {
        tetrahedra_[slot].neighbours[0] = 4;
        for (std::size_t i = 0; i < 4; ++i)
            if (std::ranges::find(tetrahedra_[slot].vertices, centre.vertices[i]) == tetrahedra_[slot].vertices.end())
                centre.neighbours[i] = slot;
    }
    return {};
}

bool LatticeDelaunay::onHullPlane(PackedPoint point, const DelaunayTetrahedron& tetrahedron, std::uint8_t face) const
{
    const PackedPoint a = tetrahedron.vertices[faceVertices[face][0]];
    const PackedPoint b = tetrahedron.vertices[faceVertices[face][1]];
    const PackedPoint c = tetrahedron.vertices[faceVertices[face][2]];
    const auto inPlane = [&](auto coordinate) {
        const std::int32_t plane = coordinate(point);
        return coordinate(a) == plane && coordinate(b) == plane && coordinate(c) == plane;
    };
    return inPlane([this](PackedPoint p) { return lattice_.x(p); }) ||
           inPlane([this](PackedPoint p) { return lattice_.y(p); }) ||
           inPlane([this](PackedPoint p) { return lattice_.z(p); });
}

void LatticeDelaunay::findCavity(PackedPoint point, std::uint32_t containing)
{
    const std::int32_t x = lattice_.x(point), y = lattice_.y(point), z = lattice_.z(point);
    std::size_t destroyedCount = 1;
    std::size_t faceCount = 0;
    destroyed_.resize(std::max<std::size_t>(destroyed_.capacity(), 64));
    cavityFaces_.resize(std::max<std::size_t>(cavityFaces_.capacity(), 64));
    tetrahedra_[containing].determinant = 0;
    destroyed_[0] = containing;
    for (std::size_t next = 0; next < destroyedCount; ++next) {
        if (destroyedCount + 4 > destroyed_.size())
            destroyed_.resize(2 * destroyed_.size());
        if (faceCount + 8 > cavityFaces_.size())
            cavityFaces_.resize(2 * cavityFaces_.size());
        const std::uint32_t inside = destroyed_[next];
        const std::array<std::uint32_t, 4> neighbours = tetrahedra_[inside].neighbours;
        if (next + 1 < destroyedCount)
            for (const std::uint32_t neighbour : tetrahedra_[destroyed_[next + 1]].neighbours)
                __builtin_prefetch(&tetrahedra_[neighbour == none ? inside : neighbour]);
        for (std::uint8_t face = 0; face < 4; ++face) {
            // Without branches on the outcome, which nobody can predict: the cache misses of all four tests overlap. A
            // missing neighbour is replaced by the tetrahedron itself, which is dead and so neither joins nor bounds.
            const std::uint32_t outside = neighbours[face] == none ? inside : neighbours[face];
            DelaunayTetrahedron& other = tetrahedra_[outside];
            const double qx = x - lattice_.x(other.vertices[0]);
            const double qy = y - lattice_.y(other.vertices[0]);
            const double qz = z - lattice_.z(other.vertices[0]);
            const double square = weights_[0] * qx * qx + weights_[1] * qy * qy + weights_[2] * qz * qz;
            const double sphere = other.centre[0] * qx + other.centre[1] * qy + other.centre[2] * qz;
            const bool alive = other.determinant != 0;
            const bool conflict = alive & (other.determinant * square < sphere);
            other.determinant = conflict ? 0 : other.determinant;
            destroyed_[destroyedCount] = outside;
            destroyedCount += conflict;
            const std::uint8_t back =
                static_cast<std::uint8_t>((other.neighbours[1] == inside) + 2 * (other.neighbours[2] == inside) +
                                          3 * (other.neighbours[3] == inside));
            cavityFaces_[faceCount] = {inside, outside, face, back};
            faceCount += alive & !conflict;
        }
        for (std::uint8_t face = 0; face < 4; ++face)
            if (neighbours[face] == none && !onHullPlane(point, tetrahedra_[inside], face))
                cavityFaces_[faceCount++] = {inside, none, face, 0};
    }
    destroyed_.resize(destroyedCount);
    cavityFaces_.resize(faceCount);
}

void LatticeDelaunay::gatherStar(PackedPoint point)
{
    star_.clear(lattice_, point);
    for (const CavityFace& face : cavityFaces_) {
        const std::array<PackedPoint, 4>& vertices = tetrahedra_[face.inside].vertices;
        star_.addFace(vertices[faceVertices[face.insideFace][0]], vertices[faceVertices[face.insideFace][1]],
                      vertices[faceVertices[face.insideFace][2]]);
    }
    star_.finish(weights_);
}

bool LatticeDelaunay::takeSlots()
{
    const std::size_t wanted = cavityFaces_.size();
    created_.assign(destroyed_.begin(),
                    destroyed_.begin() + static_cast<std::ptrdiff_t>(std::min(wanted, destroyed_.size())));
    for (std::size_t i = wanted; i < destroyed_.size(); ++i)
        freeSlots_.push_back(destroyed_[i]);
    while (created_.size() < wanted) {
        if (!freeSlots_.empty()) {
            created_.push_back(freeSlots_.back());
            freeSlots_.pop_back();
        } else if (slotCount_ < tetrahedra_.capacity()) {
            created_.push_back(slotCount_++);
        } else {
            return false;
        }
    }
    return true;
}

void LatticeDelaunay::writeStar(PackedPoint point)
{
    const std::span<const std::array<std::uint32_t, 3>> partners = star_.partners();
    const std::span<const PackedPoint> rim = star_.rim();
    const double* const determinant = star_.quantity(Star::Determinant);
    const double* const centreX = star_.quantity(Star::Centre);
    const double* const centreY = star_.quantity(Star::Centre + 1);
    const double* const centreZ = star_.quantity(Star::Centre + 2);
    for (std::size_t i = 0; i < created_.size(); ++i) {
        const std::array<std::uint32_t, 3>& face = star_.faces()[i];
        const CavityFace& cavityFace = cavityFaces_[i];
        DelaunayTetrahedron& tetrahedron = tetrahedra_[created_[i]];
        tetrahedron.vertices = {point, rim[face[0]], rim[face[1]], rim[face[2]]};
        tetrahedron.neighbours[0] = cavityFace.outside;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t partner = partners[i][corner];
            tetrahedron.neighbours[corner + 1] = partner == Star::noPartner ? none : created_[partner];
        }
        tetrahedron.determinant = determinant[i];
        tetrahedron.centre = {centreX[i], centreY[i], centreZ[i]};
        if (cavityFace.outside != none)
            tetrahedra_[cavityFace.outside].neighbours[cavityFace.outsideFace] = created_[i];
    }
}

bool LatticeDelaunay::insert(PackedPoint point, std::uint32_t containing)
{
    findCavity(point, containing);
    gatherStar(point);
    if (!takeSlots())
        return false;
    writeStar(point);
    return true;
}

} // namespace tetra
