// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimate/vertex_star.h"

#include "core/base/simd.h"
#include "core/base/sort_unique.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>

#if defined(TETRA_SIMD_16)
#include <immintrin.h>
#endif

namespace tetra {

#if defined(TETRA_SIMD_16)

namespace {

constexpr std::size_t most = 64; ///< that registers hold

/// Compares each number with all that were met, sixteen at once. Returns how many distinct ones there are; gives up
/// with 0 where they are more than `most`.
TETRA_SIMD_16 std::size_t findInRegisters(std::span<const std::uint32_t> numbers, std::uint32_t* distinct,
                                          std::uint32_t* places)
{
    alignas(64) std::uint32_t met[most];
    __m512i first = _mm512_set1_epi32(-1);
    for (std::size_t i = 0; i < most; i += 16)
        _mm512_store_si512(met + i, first);
    std::size_t count = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const __m512i number = _mm512_set1_epi32(static_cast<int>(numbers[i]));
        std::uint64_t found = _mm512_cmpeq_epi32_mask(first, number);
        for (std::size_t block = 16; block < count; block += 16)
            found |= std::uint64_t(_mm512_cmpeq_epi32_mask(_mm512_load_si512(met + block), number)) << block;
        if (found != 0) {
            places[i] = static_cast<std::uint32_t>(std::countr_zero(found));
            continue;
        }
        if (count == most)
            return 0;
        if (count < 16)
            first = _mm512_mask_mov_epi32(first, static_cast<__mmask16>(1U << count), number);
        else
            met[count] = numbers[i];
        distinct[count] = numbers[i];
        places[i] = static_cast<std::uint32_t>(count++);
    }
    return count;
}

} // namespace

#endif

void DistinctNumbers::find(std::span<const std::uint32_t> numbers, std::vector<std::uint32_t>& distinct,
                           std::span<std::uint32_t> places)
{
#if defined(TETRA_SIMD_16)
    if (simdLevel() == SimdLevel::Sixteen) {
        distinct.resize(most);
        const std::size_t count = findInRegisters(numbers, distinct.data(), places.data());
        distinct.resize(count);
        if (count > 0)
            return;
    }
#endif
    index_.clear(numbers.size());
    index_.numberAll(numbers, [&](std::size_t i, std::uint32_t number) { places[i] = number; });
    distinct.assign(index_.keys().begin(), index_.keys().end());
}

namespace {

constexpr std::size_t starLanes = VertexStar::lanes;

/// Fills the eight columns of VertexStar's planes. Vectors are named because compilers do not see them in such loops.
TETRA_SIMD_INLINE void computePlanes(const double* corners, double* planes, std::size_t count)
{
    const Double8 zero{};
    for (std::size_t first = 0; first < count; first += starLanes) {
        Double8 corner[3][3], along[2][3];
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t axis = 0; axis < 3; ++axis)
                std::memcpy(&corner[i][axis], corners + (3 * i + axis) * count + first, sizeof zero);
        for (std::size_t i = 0; i < 2; ++i)
            for (std::size_t axis = 0; axis < 3; ++axis)
                along[i][axis] = corner[i + 1][axis] - corner[0][axis];
        Double8 offset = zero, magnitude = zero;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
            const Double8 plus = along[0][j] * along[1][k], minus = along[0][k] * along[1][j];
            const Double8 normal = plus - minus;
            const Double8 size = (plus < zero ? -plus : plus) + (minus < zero ? -minus : minus);
            const Double8 from = corner[0][i];
            offset += normal * from;
            magnitude += size * (from < zero ? -from : from);
            std::memcpy(planes + i * count + first, &normal, sizeof normal);
            std::memcpy(planes + (4 + i) * count + first, &size, sizeof size);
        }
        std::memcpy(planes + 3 * count + first, &offset, sizeof offset);
        std::memcpy(planes + 7 * count + first, &magnitude, sizeof magnitude);
    }
}

/// With how many of `faceCount` faces each of eight apexes has a volume that is positive.
TETRA_SIMD_INLINE void countPositive(const double* planes, std::size_t count, std::size_t faceCount,
                                     const double* apexes, std::size_t apexCount, double* positive)
{
    Double8 x, y, z;
    std::memcpy(&x, apexes, sizeof x);
    std::memcpy(&y, apexes + apexCount, sizeof y);
    std::memcpy(&z, apexes + 2 * apexCount, sizeof z);
    const Double8 zero{};
    Double8 sum = zero;
    for (const double* plane = planes; plane < planes + faceCount; ++plane) {
        const Double8 volume = plane[3 * count] - plane[0] * x - plane[count] * y - plane[2 * count] * z;
        sum += volume > zero ? zero + 1 : zero;
    }
    std::memcpy(positive, &sum, sizeof sum);
}

/// The same, beyond the doubt that rounding leaves.
TETRA_SIMD_INLINE void countSurelyPositive(const double* planes, std::size_t count, std::size_t faceCount,
                                           const double* apexes, std::size_t apexCount, double doubt, double* positive)
{
    Double8 x, y, z;
    std::memcpy(&x, apexes, sizeof x);
    std::memcpy(&y, apexes + apexCount, sizeof y);
    std::memcpy(&z, apexes + 2 * apexCount, sizeof z);
    const Double8 zero{};
    const Double8 absX = doubt * (x < zero ? -x : x), absY = doubt * (y < zero ? -y : y),
                  absZ = doubt * (z < zero ? -z : z);
    Double8 sum = zero;
    for (const double* plane = planes; plane < planes + faceCount; ++plane) {
        const Double8 volume = plane[3 * count] - plane[0] * x - plane[count] * y - plane[2 * count] * z;
        const Double8 least =
            doubt * plane[7 * count] + plane[4 * count] * absX + plane[5 * count] * absY + plane[6 * count] * absZ;
        sum += volume > least ? zero + 1 : zero;
    }
    std::memcpy(positive, &sum, sizeof sum);
}

} // namespace

VertexStar::VertexStar(std::span<const PlacedValue> points, bool exact) : points_(points), doubt_(exact ? 0 : 1e-13) {}

void VertexStar::set(const CollapsibleMesh& mesh, std::uint32_t vertex, bool withRim)
{
    vertex_ = vertex;
    slots_.assign(mesh.star(vertex).begin(), mesh.star(vertex).end());
    for (const std::uint32_t slot : slots_)
        mesh.prefetch(slot);
    cornersOfFaces_.resize(3 * slots_.size());
    std::uint32_t* corner = cornersOfFaces_.data();
    for (const std::uint32_t slot : slots_) {
        const CollapsibleMesh::Four& vertices = mesh.vertices(slot);
        for (const std::uint8_t other : cornersOfFace[indexOf(vertices, vertex)])
            *corner++ = vertices[other];
    }
    faces_.resize(slots_.size());
    distinct_.find(cornersOfFaces_, link_, {faces_.data()->data(), cornersOfFaces_.size()});
    for (const std::uint32_t other : link_)
        __builtin_prefetch(&points_[other]);
    facesOfLink_.assign(link_.size(), 0);
    for (const std::array<std::uint32_t, 3>& face : faces_)
        for (const std::uint32_t place : face)
            ++facesOfLink_[place];
    rim_.clear();
    if (withRim)
        addRim(mesh);
    ofLink_.resize(link_.size());
    const std::array<double, 3> origin = points_[vertex].place;
    for (std::size_t place = 0; place < link_.size(); ++place) {
        const PlacedValue& point = points_[link_[place]];
        for (std::size_t axis = 0; axis < 3; ++axis)
            ofLink_[place].place[axis] = point.place[axis] - origin[axis];
        ofLink_[place].value = point.value;
    }
}

/// The boundary triangles among the faces of the tetrahedra that have the vertex.
void VertexStar::addRim(const CollapsibleMesh& mesh)
{
    for (std::uint32_t i = 0; i < slots_.size(); ++i) {
        const CollapsibleMesh::Four& neighbours = mesh.neighbours(slots_[i]);
        const auto& others = cornersOfFace[indexOf(mesh.vertices(slots_[i]), vertex_)];
        // Of (vertex, a, b, c) the faces (vertex, c, b), (vertex, a, c) and (vertex, b, a) look outwards.
        for (std::size_t opposite = 0; opposite < 3; ++opposite)
            if (const std::uint32_t triangle = neighbours[others[opposite]]; CollapsibleMesh::isTriangle(triangle))
                rim_.push_back({triangle, i, {faces_[i][(opposite + 2) % 3], faces_[i][(opposite + 1) % 3]}});
    }
}

bool VertexStar::rimIsOneCycle() const
{
    if (rim_.empty())
        return false;
    std::vector<std::uint32_t> next(link_.size(), CollapsibleMesh::none);
    for (const RimTriangle& triangle : rim_) {
        if (next[triangle.corners[0]] != CollapsibleMesh::none)
            return false;
        next[triangle.corners[0]] = triangle.corners[1];
    }
    std::size_t length = 1;
    const std::uint32_t first = rim_.front().corners[0];
    std::uint32_t at = next[first];
    for (; at != first && at != CollapsibleMesh::none && length <= rim_.size(); ++length)
        at = next[at];
    return at == first && length == rim_.size();
}

void VertexStar::measure()
{
    const std::size_t padded = paddedFaceCount();
    corners_.resize(9 * padded);
    planes_.resize(8 * padded);
    for (std::size_t column = 0; column < 9; ++column)
        std::fill(corners_.begin() + column * padded + faces_.size(), corners_.begin() + (column + 1) * padded, 0);
    for (std::size_t face = 0; face < faces_.size(); ++face)
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::array<double, 3>& place = ofLink_[faces_[face][corner]].place;
            for (std::size_t axis = 0; axis < 3; ++axis)
                corners_[(3 * corner + axis) * padded + face] = place[axis];
        }
    dispatch<computePlanes>(corners_.data(), planes_.data(), padded);
    countVolumes();
}

void VertexStar::countVolumes()
{
    const std::size_t padded = (link_.size() + starLanes - 1) / starLanes * starLanes, paddedFaces = paddedFaceCount();
    apexes_.resize(3 * padded);
    positive_.resize(padded);
    for (std::size_t place = 0; place < padded; ++place)
        for (std::size_t axis = 0; axis < 3; ++axis)
            apexes_[axis * padded + place] = place < ofLink_.size() ? ofLink_[place].place[axis] : 0;
    for (std::size_t first = 0; first < padded; first += starLanes) {
        const double* apexes = apexes_.data() + first;
        double* positive = positive_.data() + first;
        if (doubt_ == 0)
            dispatch<countPositive>(planes_.data(), paddedFaces, faces_.size(), apexes, padded, positive);
        else
            dispatch<countSurelyPositive>(planes_.data(), paddedFaces, faces_.size(), apexes, padded, doubt_, positive);
    }
}

bool VertexStar::opensOnto(std::uint32_t linkPlace) const
{
    // Faces that have the vertex themselves have no volume with it, so they are not counted.
    const std::size_t wanted = faces_.size() - facesOfLink_[linkPlace];
    return wanted > 0 && positive_[linkPlace] == static_cast<double>(wanted);
}

namespace {

template <class Number> bool has(const std::vector<Number>& sorted, Number number)
{
    return std::ranges::binary_search(sorted, number);
}

} // namespace

void LinkCondition::set(const VertexStar& star)
{
    link_.assign(star.link().begin(), star.link().end());
    edges_.clear();
    rim_.clear();
    const auto link = star.link();
    for (const auto& [a, b, c] : star.faces())
        edges_.insert(edges_.end(), {edgeKey(link[a], link[b]), edgeKey(link[b], link[c]), edgeKey(link[c], link[a])});
    for (const VertexStar::RimTriangle& triangle : star.rim()) {
        const std::uint32_t a = link[triangle.corners[0]], b = link[triangle.corners[1]];
        rim_.insert(rim_.end(), {a, b});
    }
    std::ranges::sort(link_);
    sortUnique(edges_);
    sortUnique(rim_);
}

bool LinkCondition::isOnRim(std::uint32_t vertex) const
{
    return has(rim_, vertex);
}

/// Whether a tetrahedron vanishes that has its face opposite to the target on the boundary. Then the one behind its
/// face opposite to the vertex, which the collapse does not touch, gets onto the boundary, and the history, in which a
/// site depends on what it destroys alone, would not say that the vertex needs it: closed sets would have cracks.
bool LinkCondition::leavesFaceOpen(const VertexStar& star, std::uint32_t linkPlace)
{
    return std::ranges::any_of(star.rim(), [&](const VertexStar::RimTriangle& triangle) {
        return star.holds(triangle.slotPlace, linkPlace) && triangle.corners[0] != linkPlace &&
               triangle.corners[1] != linkPlace;
    });
}

bool LinkCondition::allows(const CollapsibleMesh& mesh, const VertexStar& star, std::uint32_t linkPlace)
{
    const std::uint32_t vertex = star.vertex(), target = star.link()[linkPlace];
    if (!isOnRim(target) || leavesFaceOpen(star, linkPlace))
        return false;
    shared_.clear();
    sharedEdges_.clear();
    sharedLink_.clear();
    for (std::size_t face = 0; face < star.faces().size(); ++face)
        if (star.holds(face, linkPlace)) {
            std::uint32_t others[2];
            std::size_t count = 0;
            for (const std::uint32_t corner : star.faces()[face])
                if (corner != linkPlace)
                    others[count++] = star.link()[corner];
            shared_.insert(shared_.end(), {others[0], others[1]});
            sharedEdges_.push_back(edgeKey(others[0], others[1]));
        }
    for (const VertexStar::RimTriangle& triangle : star.rim())
        for (std::size_t i = 0; i < 2; ++i)
            if (triangle.corners[i] == linkPlace)
                sharedLink_.push_back(star.link()[triangle.corners[1 - i]]);
    sortUnique(shared_);
    sortUnique(sharedEdges_);
    if (sharedLink_.size() != 2)
        return false;

    for (const std::uint32_t slot : mesh.star(target)) {
        const CollapsibleMesh::Four& vertices = mesh.vertices(slot);
        const CollapsibleMesh::Four& neighbours = mesh.neighbours(slot);
        const std::size_t own = indexOf(vertices, target);
        for (std::size_t i = 0; i < 4; ++i) {
            const std::uint32_t corner = vertices[i];
            if (i != own && corner != vertex && has(link_, corner) && !has(shared_, corner))
                return false;
        }
        for (std::size_t i = 0; i < 4; ++i) {
            if (i == own)
                continue;
            // The edge opposite to the target and corner i.
            std::uint32_t ends[2];
            std::size_t count = 0;
            for (std::size_t k = 0; k < 4; ++k)
                if (k != own && k != i)
                    ends[count++] = vertices[k];
            if (ends[0] == vertex || ends[1] == vertex)
                continue;
            const EdgeKey edge = edgeKey(ends[0], ends[1]);
            if (has(edges_, edge) && !has(sharedEdges_, edge))
                return false;
            // An edge that is opposite to both in boundary triangles belongs to a tetrahedron with both of them, which
            // leavesFaceOpen() has seen; corners of such triangles remain.
            if (!CollapsibleMesh::isTriangle(neighbours[i]))
                continue;
            for (const std::uint32_t end : ends)
                if (has(rim_, end) && end != sharedLink_[0] && end != sharedLink_[1])
                    return false;
        }
    }
    return true;
}

} // namespace tetra
