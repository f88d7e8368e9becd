// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refine/lattice/lattice_delaunay.h"

#include "core/base/simd.h"
#include "core/mesh/face_adjacency.h"
#include "core/mesh/topology.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace tetra {

namespace {

/// Slots for every tetrahedron that can be alive at once: six to seven a vertex, with room to spare.
std::uint64_t slotCapacity(const std::array<std::uint32_t, 3>& size)
{
    return 10 * (std::uint64_t(size[0]) * size[1] * size[2]) + 4096;
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
                     Message::say("The lattice has too many points to be refined as a whole. Crop or subsample it.")};
    lattice_ = PackedLattice(size);
    for (std::size_t axis = 0; axis < 3; ++axis)
        weights_[axis] = metric[axis];
    slotCapacity_ = std::min<std::uint64_t>(slots, 0x7ffffff0);
    if (const Status status =
            tetrahedra_.ensure(slotCapacity_ + 1, Message::marked("the tetrahedra of the refinement"));
        !status)
        return status;
    if (Status status = star_.attach(lattice_); !status)
        return status;
    freeSlots_.clear();
    slotCount_ = 0;
    records()[-1] = {};
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
        const auto setStar = [&] { star_.set(vertices[0], {{{vertices[1], vertices[2], vertices[3]}}}, weights_); };
        setStar();
        if (star_.faces()[0].determinant() < 0) {
            std::swap(vertices[2], vertices[3]);
            setStar();
        }
        records()[start + number] = {vertices, {none, none, none, none}, star_.faces()[0].sphere};
    }
    DelaunayTetrahedron& centre = records()[start + 4];
    for (std::uint32_t slot = start; slot < start + 4; ++slot) {
        records()[slot].neighbours[0] = start + 4;
        for (std::size_t i = 0; i < 4; ++i)
            if (std::ranges::find(at(slot).vertices, centre.vertices[i]) == at(slot).vertices.end())
                centre.neighbours[i] = slot;
    }
    return start;
}

bool LatticeDelaunay::onHullPlane(PackedPoint point, const DelaunayTetrahedron& tetrahedron, std::uint32_t face) const
{
    const PackedPoint a = tetrahedron.vertices[cornersOfFace[face][0]];
    const PackedPoint b = tetrahedron.vertices[cornersOfFace[face][1]];
    const PackedPoint c = tetrahedron.vertices[cornersOfFace[face][2]];
    const auto inPlane = [&](auto coordinate) {
        const std::int32_t plane = coordinate(point);
        return coordinate(a) == plane && coordinate(b) == plane && coordinate(c) == plane;
    };
    return inPlane([this](PackedPoint p) { return lattice_.x(p); }) ||
           inPlane([this](PackedPoint p) { return lattice_.y(p); }) ||
           inPlane([this](PackedPoint p) { return lattice_.z(p); });
}

namespace {

/// Tests a point against the spheres of four tetrahedra at a time. Values, so that the loop keeps them in registers.
struct SphereTest {
    PackedLattice lattice;
    std::array<double, 3> weights;
    std::int32_t x, y, z; ///< the point

    /// Sets lanes of `conflict` where the point lies strictly inside, and of `alive` where the tetrahedron is alive.
    /// `powers`: the squared distances from the centres less those of the spheres, rounded; infinite for the dead.
    TETRA_SIMD_INLINE void operator()(const DelaunayTetrahedron* t0, const DelaunayTetrahedron* t1,
                                      const DelaunayTetrahedron* t2, const DelaunayTetrahedron* t3, Long4& conflict,
                                      Long4& alive, Double4* powers = nullptr) const
    {
        Double4 row0, row1, row2, row3;
        std::memcpy(&row0, &t0->sphere, sizeof row0);
        std::memcpy(&row1, &t1->sphere, sizeof row1);
        std::memcpy(&row2, &t2->sphere, sizeof row2);
        std::memcpy(&row3, &t3->sphere, sizeof row3);
        const Int4 apex = {static_cast<int>(t0->vertices[0]), static_cast<int>(t1->vertices[0]),
                           static_cast<int>(t2->vertices[0]), static_cast<int>(t3->vertices[0])};
        Int4 apexX, apexY, apexZ;
        lattice.unpack(apex, apexX, apexY, apexZ);
        const Double4 qx = __builtin_convertvector(x - apexX, Double4);
        const Double4 qy = __builtin_convertvector(y - apexY, Double4);
        const Double4 qz = __builtin_convertvector(z - apexZ, Double4);
        const Double4 low01 = __builtin_shufflevector(row0, row1, 0, 4, 2, 6);
        const Double4 high01 = __builtin_shufflevector(row0, row1, 1, 5, 3, 7);
        const Double4 low23 = __builtin_shufflevector(row2, row3, 0, 4, 2, 6);
        const Double4 high23 = __builtin_shufflevector(row2, row3, 1, 5, 3, 7);
        const Double4 centreX = __builtin_shufflevector(low01, low23, 0, 1, 4, 5);
        const Double4 centreY = __builtin_shufflevector(high01, high23, 0, 1, 4, 5);
        const Double4 centreZ = __builtin_shufflevector(low01, low23, 2, 3, 6, 7);
        const Double4 determinant = __builtin_shufflevector(high01, high23, 2, 3, 6, 7);
        const Double4 square = weights[0] * qx * qx + weights[1] * qy * qy + weights[2] * qz * qz;
        const Double4 product = centreX * qx + centreY * qy + centreZ * qz;
        alive = determinant != 0.0;
        conflict = determinant * square < product;
        if (powers != nullptr)
            *powers = alive ? square - product / determinant : Double4{} + std::numeric_limits<double>::infinity();
    }
};

} // namespace

TETRA_SIMD_INLINE void LatticeDelaunay::findCavity(PackedPoint point, std::uint32_t containing)
{
    std::size_t capacity = std::max<std::size_t>(destroyed_.capacity(), 64);
    destroyed_.resize(capacity);
    cavityFaces_.resize(3 * capacity);
    DelaunayTetrahedron* const tetrahedra = records();
    std::uint32_t* destroyed = destroyed_.data();
    CavityFace* faces = cavityFaces_.data();
    const SphereTest test{lattice_, weights_, lattice_.x(point), lattice_.y(point), lattice_.z(point)};
    tetrahedra[containing].sphere[3] = 0;
    destroyed[0] = containing;
    // How many are destroyed, and in the upper half how many faces bound the cavity: one sum for both.
    std::uint64_t counts = 1;
    const auto destroyedCount = [&] { return static_cast<std::uint32_t>(counts); };
    const auto faceCount = [&] { return static_cast<std::uint32_t>(counts >> 32); };
    double unused = 0;
    for (std::uint32_t next = 0; next < destroyedCount(); ++next) {
        // The faces found so far are at most two for each tetrahedron, and two.
        if (destroyedCount() + 4 > capacity) {
            capacity *= 2;
            destroyed_.resize(capacity);
            cavityFaces_.resize(3 * capacity);
            destroyed = destroyed_.data();
            faces = cavityFaces_.data();
        }
        const std::uint32_t inside = destroyed[next];
        // A missing neighbour is dead and so neither joins nor bounds.
        const std::array<std::uint32_t, 4> outside = tetrahedra[inside].neighbours;
        const std::uint32_t following = destroyed[next + 1 < destroyedCount() ? next + 1 : next];
        for (const std::uint32_t neighbour : tetrahedra[following].neighbours)
            __builtin_prefetch(tetrahedra + static_cast<std::int32_t>(neighbour));
        Long4 conflict, alive;
        test(&at(outside[0]), &at(outside[1]), &at(outside[2]), &at(outside[3]), conflict, alive);
        const Long4 joins = conflict & alive & 1;
        const Long4 increments = joins | (alive & ~conflict & std::int64_t(0x100000000));
        for (std::uint32_t face = 0; face < 4; ++face) {
            // Without branches on the outcome, which nobody can predict.
            double* const mark =
                joins[face] != 0 ? &tetrahedra[static_cast<std::int32_t>(outside[face])].sphere[3] : &unused;
            *mark = 0;
            destroyed[destroyedCount()] = outside[face];
            faces[faceCount()] = {inside, outside[face], face, 0};
            counts += static_cast<std::uint64_t>(increments[face]);
        }
        if ((outside[0] == none) | (outside[1] == none) | (outside[2] == none) | (outside[3] == none))
            for (std::uint32_t face = 0; face < 4; ++face)
                if (tetrahedra[inside].neighbours[face] == none && !onHullPlane(point, tetrahedra[inside], face)) {
                    faces[faceCount()] = {inside, none, face, 0};
                    counts += std::uint64_t(1) << 32;
                }
    }
    destroyed_.resize(destroyedCount());
    cavityFaces_.resize(faceCount());
}

TETRA_SIMD_INLINE std::uint32_t LatticeDelaunay::approach(PackedPoint point, std::uint32_t from) const
{
    const SphereTest test{lattice_, weights_, lattice_.x(point), lattice_.y(point), lattice_.z(point)};
    Long4 conflict, alive;
    Double4 powers;
    std::uint32_t slot = from;
    test(&at(slot), &at(slot), &at(slot), &at(slot), conflict, alive, &powers);
    if ((conflict & alive)[0] != 0)
        return slot;
    double power = powers[0];
    // Along a line to the point powers never rise, so that the neighbour of the least power leads on unless it is as
    // far, as well as doubles tell: then exactly across a face that separates the two.
    const double margin = 1e-9 * (std::abs(power) + 1);
    for (std::uint64_t steps = 0; steps <= slotCount_; ++steps) {
        const std::array<std::uint32_t, 4> neighbours = at(slot).neighbours;
        test(&at(neighbours[0]), &at(neighbours[1]), &at(neighbours[2]), &at(neighbours[3]), conflict, alive, &powers);
        const Long4 found = conflict & alive;
        std::uint32_t best = 0;
        for (std::uint32_t i = 0; i < 4; ++i) {
            if (found[i] != 0)
                return neighbours[i];
            best = powers[i] < powers[best] ? i : best;
        }
        if (!(powers[best] < power - margin))
            best = faceTowards(point, slot);
        if (best == 4 || neighbours[best] == none)
            return none;
        power = powers[best];
        slot = neighbours[best];
    }
    return none;
}

std::uint32_t LatticeDelaunay::findConflict(PackedPoint point, std::uint32_t from) const
{
    return dispatch<&LatticeDelaunay::approach>(*this, point, from);
}

/// The first face of a tetrahedron that has the point on its other side, or 4.
std::uint32_t LatticeDelaunay::faceTowards(PackedPoint point, std::uint32_t slot) const
{
    const std::array<PackedPoint, 4>& vertices = at(slot).vertices;
    for (std::uint32_t face = 0; face < 4; ++face) {
        const auto& [a, b, c] = cornersOfFace[face];
        if (!onInnerSide(lattice_, point, {vertices[face], vertices[a], vertices[b], vertices[c]}))
            return face;
    }
    return 4;
}

TETRA_SIMD_INLINE void LatticeDelaunay::gatherStar(PackedPoint point)
{
    starFaces_.resize(cavityFaces_.size());
    for (std::size_t i = 0; i < cavityFaces_.size(); ++i) {
        CavityFace& face = cavityFaces_[i];
        const auto& back = at(face.outside).neighbours;
        // One at most, but for the dead tetrahedron that stands for none: there any face will do.
        face.outsideFace = static_cast<std::uint32_t>((back[1] == face.inside) | 2 * (back[2] == face.inside) |
                                                      3 * (back[3] == face.inside));
        const std::array<PackedPoint, 4>& vertices = at(face.inside).vertices;
        const auto& order = cornersOfFace[face.insideFace];
        starFaces_[i] = {vertices[order[0]], vertices[order[1]], vertices[order[2]]};
    }
    star_.set(point, starFaces_, weights_);
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
        } else if (slotCount_ < slotCapacity_) {
            created_.push_back(slotCount_++);
        } else {
            return false;
        }
    }
    return true;
}

TETRA_SIMD_INLINE void LatticeDelaunay::writeStar(PackedPoint point)
{
    const std::size_t count = created_.size();
    const std::uint32_t* const slots = created_.data();
    const std::array<std::uint32_t, 3>* const corners = star_.corners().data();
    const std::array<std::uint32_t, 3>* const partners = star_.partners(created_, none).data();
    const PackedPoint* const link = star_.link().data();
    const Star::Face* const faces = star_.faces().data();
    const CavityFace* const cavityFaces = cavityFaces_.data();
    DelaunayTetrahedron* const tetrahedra = records();
    for (std::size_t i = 0; i < count; ++i) {
        const auto& [a, b, c] = corners[i];
        const CavityFace& face = cavityFaces[i];
        tetrahedra[slots[i]] = {{point, link[a], link[b], link[c]},
                                {face.outside, partners[i][0], partners[i][1], partners[i][2]},
                                faces[i].sphere};
        tetrahedra[static_cast<std::int32_t>(face.outside)].neighbours[face.outsideFace] = slots[i];
    }
}

void LatticeDelaunay::prefetchSurroundings(std::uint32_t slot) const
{
    for (const PackedPoint vertex : at(slot).vertices)
        star_.prefetch(vertex);
    for (const std::uint32_t neighbour : at(slot).neighbours) {
        prefetchNeighbours(neighbour);
        for (const PackedPoint vertex : at(neighbour).vertices)
            star_.prefetch(vertex);
    }
}

bool LatticeDelaunay::insert(PackedPoint point, std::uint32_t containing)
{
    dispatch<&LatticeDelaunay::findCavity>(*this, point, containing);
    dispatch<&LatticeDelaunay::gatherStar>(*this, point);
    if (!takeSlots())
        return false;
    dispatch<&LatticeDelaunay::writeStar>(*this, point);
    return true;
}

namespace {

using Offset = std::array<double, 3>;

/// Tetrahedra between two looks at whether the work was cancelled.
constexpr std::size_t loadedAtOnce = 1 << 16;

Offset offset(const PackedLattice& lattice, PackedPoint from, PackedPoint to)
{
    return {static_cast<double>(lattice.x(to) - lattice.x(from)), static_cast<double>(lattice.y(to) - lattice.y(from)),
            static_cast<double>(lattice.z(to) - lattice.z(from))};
}

Offset crossOf(const Offset& a, const Offset& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double square(const Offset& a, const std::array<double, 3>& weights)
{
    return weights[0] * a[0] * a[0] + weights[1] * a[1] * a[1] + weights[2] * a[2] * a[2];
}

/// As Star computes it.
std::array<double, 4> sphereOf(const PackedLattice& lattice, const std::array<PackedPoint, 4>& vertices,
                               const std::array<double, 3>& weights)
{
    const Offset a = offset(lattice, vertices[0], vertices[1]);
    const Offset b = offset(lattice, vertices[0], vertices[2]);
    const Offset c = offset(lattice, vertices[0], vertices[3]);
    const Offset bc = crossOf(b, c), ca = crossOf(c, a), ab = crossOf(a, b);
    const double squareA = square(a, weights), squareB = square(b, weights), squareC = square(c, weights);
    std::array<double, 4> sphere{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        sphere[axis] = squareA * bc[axis] + squareB * ca[axis] + squareC * ab[axis];
    sphere[3] = a[0] * bc[0] + a[1] * bc[1] + a[2] * bc[2];
    return sphere;
}

/// Which of the four faces lie in planes that bound blocks, as bits; none for a tetrahedron that is in no single block.
struct BorderFaces {
    std::uint32_t bits = 0;
    bool inOneBlock = true;
};

BorderFaces borderFaces(const PackedLattice& lattice, const BlockDivision& division,
                        const std::array<PackedPoint, 4>& vertices)
{
    BorderFaces faces;
    const auto look = [&](std::size_t axis, auto coordinate) {
        const std::array<std::int32_t, 4> c = {coordinate(vertices[0]), coordinate(vertices[1]),
                                               coordinate(vertices[2]), coordinate(vertices[3])};
        const std::int32_t least = std::min(std::min(c[0], c[1]), std::min(c[2], c[3]));
        const std::int32_t largest = std::max(std::max(c[0], c[1]), std::max(c[2], c[3]));
        if (least == largest)
            return;
        faces.inOneBlock &= division.blockAlong(axis, static_cast<std::uint32_t>(least)) ==
                            division.blockAlong(axis, static_cast<std::uint32_t>(largest - 1));
        for (const std::int32_t plane : {least, largest}) {
            if (!division.isBorder(axis, static_cast<std::uint32_t>(plane)))
                continue;
            const std::uint32_t off = (c[0] != plane) | (c[1] != plane) << 1 | (c[2] != plane) << 2 |
                                      static_cast<std::uint32_t>(c[3] != plane) << 3;
            if ((off & (off - 1)) == 0)
                faces.bits |= off;
        }
    };
    look(0, [&](PackedPoint p) { return lattice.x(p); });
    look(1, [&](PackedPoint p) { return lattice.y(p); });
    look(2, [&](PackedPoint p) { return lattice.z(p); });
    return faces;
}

} // namespace

MeshLoading LatticeDelaunay::load(std::span<const std::array<PackedPoint, 4>> tetrahedra, const BlockDivision& division,
                                  const Progress& progress)
{
    slotCount_ = 0;
    freeSlots_.clear();
    if (tetrahedra.size() > slotCapacity_ || tetrahedra.size() >= (1u << 30))
        return MeshLoading::NoMesh;
    if (const MeshLoading loaded = loadTetrahedra(tetrahedra, division, progress); loaded != MeshLoading::Done)
        return loaded;
    slotCount_ = static_cast<std::uint32_t>(tetrahedra.size());
    return checkDelaunay(progress);
}

MeshLoading LatticeDelaunay::loadTetrahedra(std::span<const std::array<PackedPoint, 4>> tetrahedra,
                                            const BlockDivision& division, const Progress& progress)
{
    constexpr std::size_t atOnce = 16;
    FaceMatching matching(4 * tetrahedra.size());
    std::array<std::array<std::uint64_t, 4>, atOnce> keys{};
    std::array<std::uint32_t, atOnce> borders{};
    std::uint64_t volume = 0;
    for (std::size_t first = 0; first < tetrahedra.size(); first += atOnce) {
        if (first % loadedAtOnce == 0 && progress.cancelled())
            return MeshLoading::Cancelled;
        const std::size_t count = std::min(atOnce, tetrahedra.size() - first);
        for (std::size_t i = 0; i < count; ++i) {
            const std::array<PackedPoint, 4>& vertices = tetrahedra[first + i];
            DelaunayTetrahedron& record = records()[first + i];
            record = {vertices, {none, none, none, none}, sphereOf(lattice_, vertices, weights_)};
            const BorderFaces faces = borderFaces(lattice_, division, vertices);
            if (!(record.determinant() > 0) || !faces.inOneBlock)
                return MeshLoading::NoMesh;
            volume += static_cast<std::uint64_t>(record.determinant());
            borders[i] = faces.bits;
            std::uint64_t sum = 0;
            for (std::size_t k = 0; k < 4; ++k)
                sum += keys[i][k] = FaceMatching::keyOf(vertices[k]);
            for (std::size_t k = 0; k < 4; ++k) {
                keys[i][k] = sum - keys[i][k];
                matching.prefetch(keys[i][k]);
            }
        }
        for (std::size_t i = 0; i < count; ++i)
            for (std::uint32_t face = 0; face < 4; ++face) {
                if ((borders[i] >> face & 1) != 0)
                    continue;
                const auto side = static_cast<std::uint32_t>(4 * (first + i) + face);
                const std::uint32_t other = matching.add(keys[i][face], side);
                if (other == FaceMatching::none)
                    continue;
                if (other / 4 == side / 4)
                    return MeshLoading::NoMesh;
                records()[first + i].neighbours[face] = other / 4;
                records()[other / 4].neighbours[other % 4] = static_cast<std::uint32_t>(first + i);
            }
    }
    const auto& size = lattice_.size();
    const bool covers = volume == 6 * (size[0] - 1ull) * (size[1] - 1ull) * (size[2] - 1ull);
    return matching.singleCount() == 0 && covers ? MeshLoading::Done : MeshLoading::NoMesh;
}

/// Whether no vertex lies strictly inside the circumsphere of a neighbour: then none does anywhere.
MeshLoading LatticeDelaunay::checkDelaunay(const Progress& progress) const
{
    for (std::uint32_t slot = 0; slot < slotCount_; ++slot) {
        if (slot % loadedAtOnce == 0 && progress.cancelled())
            return MeshLoading::Cancelled;
        const DelaunayTetrahedron& one = at(slot);
        for (const std::uint32_t neighbour : one.neighbours) {
            if (neighbour == none || neighbour < slot)
                continue;
            const DelaunayTetrahedron& other = at(neighbour);
            std::uint32_t shared = 0;
            PackedPoint opposite = 0;
            for (const PackedPoint vertex : other.vertices) {
                const bool known = std::ranges::find(one.vertices, vertex) != one.vertices.end();
                shared += known;
                opposite = known ? opposite : vertex;
            }
            const Offset q = offset(lattice_, one.vertices[0], opposite);
            const auto& sphere = one.sphere;
            if (shared != 3)
                return MeshLoading::NoMesh;
            if (sphere[3] * square(q, weights_) < sphere[0] * q[0] + sphere[1] * q[1] + sphere[2] * q[2])
                return MeshLoading::NotDelaunay;
        }
    }
    return MeshLoading::Done;
}

void LatticeDelaunay::restore(std::span<const DelaunayTetrahedron> tetrahedra, std::span<const std::uint32_t> changed)
{
    // What lay beside a changed one may have stayed and got another neighbour.
    for (const std::uint32_t slot : changed) {
        records()[slot] = tetrahedra[slot];
        for (const std::uint32_t neighbour : tetrahedra[slot].neighbours)
            if (neighbour != none)
                records()[neighbour].neighbours = tetrahedra[neighbour].neighbours;
    }
    slotCount_ = static_cast<std::uint32_t>(tetrahedra.size());
    freeSlots_.clear();
}

bool onInnerSide(const PackedLattice& lattice, PackedPoint point, const std::array<PackedPoint, 4>& vertices)
{
    const auto offset = [&](PackedPoint vertex) -> std::array<std::int64_t, 3> {
        return {lattice.x(vertex) - lattice.x(point), lattice.y(vertex) - lattice.y(point),
                lattice.z(vertex) - lattice.z(point)};
    };
    const auto a = offset(vertices[1]), b = offset(vertices[2]), c = offset(vertices[3]);
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
               a[2] * (b[0] * c[1] - b[1] * c[0]) >=
           0;
}

std::array<std::vector<PackedPoint>, LatticeDelaunay::startCount>
pointsOfStart(const LatticeDelaunay& delaunay, const LatticeBox& box, std::uint32_t firstSlot)
{
    std::array<std::vector<PackedPoint>, LatticeDelaunay::startCount> inside;
    const PackedLattice& lattice = delaunay.lattice();
    const auto isEnd = [&](std::size_t axis, std::uint32_t coordinate) {
        return coordinate == box.origin[axis] || coordinate == box.last(axis);
    };
    for (std::uint32_t z = box.origin[2]; z <= box.last(2); ++z)
        for (std::uint32_t y = box.origin[1]; y <= box.last(1); ++y)
            for (std::uint32_t x = box.origin[0]; x <= box.last(0); ++x) {
                if (isEnd(0, x) && isEnd(1, y) && isEnd(2, z))
                    continue;
                const PackedPoint point = lattice.pack(x, y, z);
                std::uint32_t number = 0;
                while (number < LatticeDelaunay::startCount - 1 &&
                       !onInnerSide(lattice, point, delaunay[firstSlot + number].vertices))
                    ++number;
                inside[number].push_back(point);
            }
    return inside;
}

} // namespace tetra
