// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/lattice_delaunay.h"

#include "core/base/simd.h"

#include <algorithm>
#include <cstring>

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
    if (Status status = prepare(size, metric, slotCapacity(size)); !status)
        return status;
    addBox({{0, 0, 0}, size}, centreAtOrigin);
    return {};
}

Status LatticeDelaunay::prepare(const std::array<std::uint32_t, 3>& size, const LatticeMetric& metric,
                                std::uint64_t slots)
{
    if (!PackedLattice::fits(size))
        return Error{ErrorKind::OutOfResource,
                     "The lattice has too many points to be refined as a whole. Crop or subsample it."};
    lattice_ = PackedLattice(size);
    for (std::size_t axis = 0; axis < 3; ++axis)
        weights_[axis] = metric[axis];
    if (const Status status = tetrahedra_.ensure(slots, "the tetrahedra of the refinement"); !status)
        return status;
    if (Status status = star_.attach(lattice_); !status)
        return status;
    freeSlots_.clear();
    slotCount_ = 0;
    return {};
}

std::uint32_t LatticeDelaunay::addBox(const LatticeBox& box, bool centreAtOrigin)
{
    const std::uint32_t start = slotCount_;
    slotCount_ += startCount;
    std::array<PackedPoint, 8> corners{};
    for (std::uint32_t number = 0; number < 8; ++number) {
        const std::array<std::uint32_t, 3> corner = box.corner(number);
        corners[number] = lattice_.pack(corner[0], corner[1], corner[2]);
    }
    // Four corners are cut off; the other four span the fifth tetrahedron.
    constexpr std::uint8_t cutAtOdd[5][4] = {{1, 0, 3, 5}, {2, 3, 0, 6}, {4, 5, 6, 0}, {7, 3, 6, 5}, {0, 3, 5, 6}};
    for (std::uint32_t number = 0; number < startCount; ++number) {
        std::array<PackedPoint, 4> vertices{};
        for (std::size_t i = 0; i < 4; ++i)
            vertices[i] = corners[cutAtOdd[number][i] ^ (centreAtOrigin ? 0u : 1u)];
        const auto setStar = [&] {
            star_.clear(vertices[0]);
            star_.addFace(vertices[1], vertices[2], vertices[3]);
            star_.finish(weights_);
        };
        setStar();
        if (star_.faces()[0].determinant() < 0) {
            std::swap(vertices[2], vertices[3]);
            setStar();
        }
        tetrahedra_[start + number] = {vertices, {none, none, none, none}, star_.faces()[0].sphere};
    }
    DelaunayTetrahedron& centre = tetrahedra_[start + 4];
    for (std::uint32_t slot = start; slot < start + 4; ++slot) {
        tetrahedra_[slot].neighbours[0] = start + 4;
        for (std::size_t i = 0; i < 4; ++i)
            if (std::ranges::find(tetrahedra_[slot].vertices, centre.vertices[i]) == tetrahedra_[slot].vertices.end())
                centre.neighbours[i] = slot;
    }
    return start;
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

/// conflicts[i] != 0 if the point lies strictly inside the sphere of tetrahedron i, four at a time.
inline void LatticeDelaunay::testSpheres(PackedPoint point, const std::array<std::uint32_t, 4>& slots,
                                         std::array<std::int64_t, 4>& conflicts) const
{
    const DelaunayTetrahedron* t[4] = {&tetrahedra_[slots[0]], &tetrahedra_[slots[1]], &tetrahedra_[slots[2]],
                                       &tetrahedra_[slots[3]]};
    Double4 rows[4];
    for (std::size_t i = 0; i < 4; ++i)
        std::memcpy(&rows[i], &t[i]->sphere, sizeof rows[i]);
    const Int4 apex = {static_cast<int>(t[0]->vertices[0]), static_cast<int>(t[1]->vertices[0]),
                       static_cast<int>(t[2]->vertices[0]), static_cast<int>(t[3]->vertices[0])};
    Int4 apexX, apexY, apexZ;
    lattice_.unpack(apex, apexX, apexY, apexZ);
    const Double4 qx = __builtin_convertvector(lattice_.x(point) - apexX, Double4);
    const Double4 qy = __builtin_convertvector(lattice_.y(point) - apexY, Double4);
    const Double4 qz = __builtin_convertvector(lattice_.z(point) - apexZ, Double4);
    const Double4 low01 = __builtin_shufflevector(rows[0], rows[1], 0, 4, 2, 6);
    const Double4 high01 = __builtin_shufflevector(rows[0], rows[1], 1, 5, 3, 7);
    const Double4 low23 = __builtin_shufflevector(rows[2], rows[3], 0, 4, 2, 6);
    const Double4 high23 = __builtin_shufflevector(rows[2], rows[3], 1, 5, 3, 7);
    const Double4 centreX = __builtin_shufflevector(low01, low23, 0, 1, 4, 5);
    const Double4 centreY = __builtin_shufflevector(high01, high23, 0, 1, 4, 5);
    const Double4 centreZ = __builtin_shufflevector(low01, low23, 2, 3, 6, 7);
    const Double4 determinant = __builtin_shufflevector(high01, high23, 2, 3, 6, 7);
    const Double4 square = weights_[0] * qx * qx + weights_[1] * qy * qy + weights_[2] * qz * qz;
    const auto conflict = determinant * square < centreX * qx + centreY * qy + centreZ * qz;
    std::memcpy(conflicts.data(), &conflict, sizeof conflict);
}

TETRA_SIMD_CLONES void LatticeDelaunay::findCavity(PackedPoint point, std::uint32_t containing)
{
    destroyed_.resize(std::max<std::size_t>(destroyed_.capacity(), 64));
    cavityFaces_.resize(std::max<std::size_t>(cavityFaces_.capacity(), 64));
    DelaunayTetrahedron* const tetrahedra = tetrahedra_.data();
    std::uint32_t* destroyed = destroyed_.data();
    CavityFace* faces = cavityFaces_.data();
    tetrahedra[containing].sphere[3] = 0;
    destroyed[0] = containing;
    std::size_t destroyedCount = 1;
    std::size_t faceCount = 0;
    for (std::size_t next = 0; next < destroyedCount; ++next) {
        if (destroyedCount + 4 > destroyed_.size()) {
            destroyed_.resize(2 * destroyed_.size());
            destroyed = destroyed_.data();
        }
        if (faceCount + 8 > cavityFaces_.size()) {
            cavityFaces_.resize(2 * cavityFaces_.size());
            faces = cavityFaces_.data();
        }
        const std::uint32_t inside = destroyed[next];
        // A missing neighbour is replaced by the tetrahedron itself, which is dead and so neither joins nor bounds.
        std::array<std::uint32_t, 4> outside = tetrahedra[inside].neighbours;
        std::uint32_t missing = 0;
        for (std::uint32_t& neighbour : outside) {
            missing += neighbour == none;
            neighbour = neighbour == none ? inside : neighbour;
        }
        if (next + 1 < destroyedCount)
            for (const std::uint32_t neighbour : tetrahedra[destroyed[next + 1]].neighbours)
                __builtin_prefetch(tetrahedra + (neighbour == none ? inside : neighbour));
        std::array<std::int64_t, 4> conflicts{};
        testSpheres(point, outside, conflicts);
        for (std::uint8_t face = 0; face < 4; ++face) {
            // Without branches on the outcome, which nobody can predict.
            DelaunayTetrahedron& other = tetrahedra[outside[face]];
            const bool alive = other.sphere[3] != 0;
            const bool conflict = alive & (conflicts[face] != 0);
            other.sphere[3] = conflict ? 0 : other.sphere[3];
            destroyed[destroyedCount] = outside[face];
            destroyedCount += conflict;
            const std::uint8_t back =
                static_cast<std::uint8_t>((other.neighbours[1] == inside) + 2 * (other.neighbours[2] == inside) +
                                          3 * (other.neighbours[3] == inside));
            faces[faceCount] = {inside, outside[face], face, back};
            faceCount += alive & !conflict;
        }
        if (missing > 0)
            for (std::uint8_t face = 0; face < 4; ++face)
                if (tetrahedra[inside].neighbours[face] == none && !onHullPlane(point, tetrahedra[inside], face))
                    faces[faceCount++] = {inside, none, face, 0};
    }
    destroyed_.resize(destroyedCount);
    cavityFaces_.resize(faceCount);
}

void LatticeDelaunay::gatherStar(PackedPoint point)
{
    star_.clear(point);
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
    for (std::size_t i = 0; i < created_.size(); ++i) {
        const std::array<std::uint32_t, 3>& corners = star_.corners()[i];
        const CavityFace& cavityFace = cavityFaces_[i];
        const auto neighbour = [&](std::size_t corner) {
            return partners[i][corner] == Star::noPartner ? none : created_[partners[i][corner]];
        };
        tetrahedra_[created_[i]] = {{point, rim[corners[0]], rim[corners[1]], rim[corners[2]]},
                                    {cavityFace.outside, neighbour(0), neighbour(1), neighbour(2)},
                                    star_.faces()[i].sphere};
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
