// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/packed/replay_mesh.h"

#include "core/base/progress.h"
#include "core/base/rounding.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <numeric>
#include <type_traits>
#include <utility>

namespace tetra {

namespace {

constexpr MarkedText replaying = Message::marked("Replaying the insertions");

/// The linear interpolation at a point of a tetrahedron, whose weights the point's volumes are. Of integers of up to 16
/// bits it is one division of exact integers; of others the weights are reduced fractions, and only vertices of a
/// weight count, in the lattice's order: so a point on a face gets the same from both sides.
template <class T, class SampleAt> double interpolatedAt(const SampleAt& sampleAt,
                                                         const std::array<PackedPoint, 4>& vertices,
                                                         const std::array<std::int64_t, 4>& volumes)
{
    const std::int64_t whole = volumes[0] + volumes[1] + volumes[2] + volumes[3];
    if (whole == 0) // no mesh has it
        return 0;
    if constexpr (std::is_integral_v<T> && sizeof(T) <= 2) {
        std::int64_t sum = 0;
        for (std::size_t i = 0; i < 4; ++i)
            sum += volumes[i] * static_cast<std::int64_t>(sampleAt(vertices[i]));
        return static_cast<double>(sum) / static_cast<double>(whole);
    } else {
        std::array<std::pair<PackedPoint, std::int64_t>, 4> weights;
        std::int64_t divisor = whole;
        for (std::size_t i = 0; i < 4; ++i) {
            weights[i] = {vertices[i], volumes[i]};
            divisor = std::gcd(divisor, volumes[i]);
        }
        std::ranges::sort(weights);
        double sum = 0, first = 0;
        bool begun = false;
        for (const auto& [vertex, weight] : weights) {
            if (weight == 0)
                continue;
            const auto value = static_cast<double>(sampleAt(vertex));
            if (!begun)
                first = value;
            begun = true;
            sum += static_cast<double>(weight / divisor) * (value - first);
        }
        const double result = first + sum / static_cast<double>(whole / divisor);
        return std::isfinite(result) ? result : first;
    }
}

/// The numbers of a tetrahedron's vertices among sorted ones.
std::array<std::uint32_t, 4> numbersOf(const std::array<PackedPoint, 4>& tetrahedron,
                                       const std::vector<PackedPoint>& vertices)
{
    std::array<std::uint32_t, 4> numbers{};
    for (std::size_t i = 0; i < 4; ++i)
        numbers[i] = static_cast<std::uint32_t>(std::ranges::lower_bound(vertices, tetrahedron[i]) - vertices.begin());
    return numbers;
}

/// How many points are added between two looks at whether the work was cancelled.
constexpr std::size_t addedAtOnce = 4096;

/// No error is small enough: the largest one of each tetrahedron is to be found.
class NoLimits final : public ErrorLimits {
public:
    NoLimits() { twoValued = true; }
    double at(const std::array<std::uint32_t, 3>&) const override { return 0; }
};

} // namespace

Result<std::unique_ptr<ReplayMesh>> ReplayMesh::make(const Lattice& lattice, SampleType type, std::uint32_t blockCells,
                                                     Kept kept, const Progress& progress)
{
    std::unique_ptr<ReplayMesh> mesh(new ReplayMesh(lattice, type, blockCells));
    if (const Status prepared = mesh->prepare(lattice, kept, progress); !prepared)
        return prepared.error();
    return mesh;
}

Status ReplayMesh::prepare(const Lattice& lattice, Kept kept, const Progress& progress)
{
    const auto metric = latticeMetric(division_.box(0).size, lattice.spacing);
    if (!metric)
        return metric.error();
    LatticeDelaunay first;
    if (const Status prepared =
            first.prepare(lattice.size, *metric, 64 + std::uint64_t(LatticeDelaunay::startCount) * division_.count());
        !prepared)
        return prepared;
    for (std::uint32_t block = 0; block < division_.count(); ++block)
        first.addBox(division_.box(block), !division_.odd(block));
    std::vector<std::array<PackedPoint, 4>> start;
    std::vector<PackedPoint> vertices;
    for (const DelaunayTetrahedron& tetrahedron : first.tetrahedra()) {
        start.push_back(tetrahedron.vertices);
        vertices.insert(vertices.end(), tetrahedron.vertices.begin(), tetrahedron.vertices.end());
    }
    std::ranges::sort(vertices);
    vertices.erase(std::ranges::unique(vertices).begin(), vertices.end());
    for (const std::array<PackedPoint, 4>& tetrahedron : start)
        start_.push_back(numbersOf(tetrahedron, vertices));
    for (const PackedPoint vertex : vertices)
        corners_.push_back(lattice_.index(vertex));
    divide(kept);
    if (const Status loaded = load(start, *metric, progress); !loaded)
        return loaded;
    auto samples = allocateSamples(type_, pointCount_);
    if (!samples)
        return samples.error();
    samples_ = *std::move(samples);
    std::memset(samples_.get(), 0, pointCount_ * sampleSize(type_));
    return {};
}

/// Makes the parts: boxes of blocks, of which rows along x are not cut, as points come in rows. There are more than
/// most machines have use for, as some have many sites and others none; but each takes some megabytes of its own.
void ReplayMesh::divide(Kept kept)
{
    constexpr std::array<std::uint32_t, 3> most = {1, 4, 8};
    const auto& size = lattice_.size();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::uint32_t blocks = kept == Kept::AsOne ? 1 : division_.countAlong(axis);
        const std::uint32_t together = (blocks + most[axis] - 1) / most[axis];
        partEdges_[axis] = blocks > together ? together * division_.blockCells()[axis] : size[axis] - 1;
        partCounts_[axis] = (blocks + together - 1) / together;
    }
    for (std::uint32_t z = 0; z < partCounts_[2]; ++z)
        for (std::uint32_t y = 0; y < partCounts_[1]; ++y) {
            auto part = std::make_unique<Part>();
            part->box.origin = {0, y * partEdges_[1], z * partEdges_[2]};
            for (std::size_t axis = 0; axis < 3; ++axis)
                part->box.size[axis] = std::min(partEdges_[axis], size[axis] - 1 - part->box.origin[axis]) + 1;
            const auto& origin = part->box.origin;
            part->first = lattice_.index(lattice_.pack(origin[0], origin[1], origin[2]));
            parts_.push_back(std::move(part));
        }
    entering_.resize(parts_.size());
}

/// The mesh of the blocks' corners into the parts.
Status ReplayMesh::load(const std::vector<std::array<PackedPoint, 4>>& start, const LatticeMetric& metric,
                        const Progress& progress)
{
    for (const auto& part : parts_) {
        const BlockDivision division(part->box.size, division_.blockCells()[0]);
        if (const Status prepared = part->delaunay.prepare(division, metric); !prepared)
            return prepared;
        const auto& origin = part->box.origin;
        std::vector<std::array<PackedPoint, 4>> inside;
        std::vector<PackedPoint> vertices;
        for (const std::array<PackedPoint, 4>& tetrahedron : start) {
            std::array<PackedPoint, 4> there{};
            bool isInside = true;
            for (std::size_t i = 0; i < 4; ++i) {
                const auto y = static_cast<std::uint32_t>(lattice_.y(tetrahedron[i])),
                           z = static_cast<std::uint32_t>(lattice_.z(tetrahedron[i]));
                isInside &= y >= origin[1] && y <= part->box.last(1) && z >= origin[2] && z <= part->box.last(2);
                there[i] = part->delaunay.lattice().pack(static_cast<std::uint32_t>(lattice_.x(tetrahedron[i])),
                                                         y - origin[1], z - origin[2]);
            }
            if (!isInside)
                continue;
            inside.push_back(there);
            vertices.insert(vertices.end(), there.begin(), there.end());
        }
        std::ranges::sort(vertices);
        vertices.erase(std::ranges::unique(vertices).begin(), vertices.end());
        std::vector<std::array<std::uint32_t, 4>> numbers;
        for (const std::array<PackedPoint, 4>& tetrahedron : inside)
            numbers.push_back(numbersOf(tetrahedron, vertices));
        const MeshLoading loaded = part->delaunay.load(numbers, vertices, progress);
        if (loaded == MeshLoading::Cancelled)
            return cancelledError(replaying);
        if (loaded != MeshLoading::Done)
            return Error{ErrorKind::OutOfResource, Message::say("The lattice is too large to be packed as a whole.")};
    }
    return {};
}

Status ReplayMesh::expect(std::span<const std::uint32_t> points, Expectations& expected, const Progress& progress) const
{
    constexpr std::size_t atOnce = 512;
    expected.values.resize(points.size());
    expected.slots.resize(points.size());
    std::atomic<bool> lost = false;
    const std::uint32_t rowPoints = lattice_.size()[0], planePoints = rowPoints * lattice_.size()[1];
    const auto partOf = [&](std::uint32_t point) {
        return partAlong(2, point / planePoints) * partCounts_[1] + partAlong(1, point % planePoints / rowPoints);
    };
    const auto expectIn = [&]<class T>(const T* samples, std::size_t begin, std::size_t end) {
        const Part& part = *parts_[partOf(points[begin])];
        const PackedLattice& lattice = part.delaunay.lattice();
        std::array<PackedPoint, atOnce> there;
        std::array<PlacedPoint, atOnce> placed;
        const std::size_t count = end - begin;
        for (std::size_t i = 0; i < count; ++i) {
            const std::uint32_t point = points[begin + i];
            there[i] = lattice.pack(point % rowPoints, point % planePoints / rowPoints - part.box.origin[1],
                                    point / planePoints - part.box.origin[2]);
        }
        part.delaunay.place(std::span(there).first(count), std::span(placed).first(count));
        const auto sampleAt = [&](PackedPoint vertex) {
            return samples[part.first + static_cast<std::uint32_t>(lattice.z(vertex)) * planePoints +
                           static_cast<std::uint32_t>(lattice.y(vertex)) * rowPoints +
                           static_cast<std::uint32_t>(lattice.x(vertex))];
        };
        for (std::size_t i = 0; i < count; ++i) {
            const auto& [slot, volumes] = placed[i];
            if (slot == LatticeDelaunay::none) {
                lost = true;
                return;
            }
            expected.slots[begin + i] = slot;
            expected.values[begin + i] = interpolatedAt<T>(sampleAt, part.delaunay.mesh()[slot].vertices, volumes);
        }
    };
    visitSampleType(type_, [&]<class T>() {
        const T* const samples = reinterpret_cast<const T*>(samples_.get());
        // Where one run ends must not depend on the threads: which of several tetrahedra is found does.
        tbb::parallel_for(std::size_t(0), (points.size() + atOnce - 1) / atOnce, [&](std::size_t run) {
            const std::size_t last = std::min(points.size(), (run + 1) * atOnce);
            for (std::size_t begin = run * atOnce, end = begin; begin < last; begin = end) {
                if (progress.cancelled() || lost)
                    return;
                const std::uint32_t part = partOf(points[begin]);
                while (end < last && partOf(points[end]) == part)
                    ++end;
                expectIn(samples, begin, end);
            }
        });
    });
    if (progress.cancelled())
        return cancelledError(replaying);
    if (lost)
        return Error{ErrorKind::BadInput, Message::say("A point lies in no tetrahedron of the mesh.")};
    return {};
}

namespace {

Error meshGrewTooLarge()
{
    return {ErrorKind::OutOfResource, Message::say("The mesh grew beyond what was reserved for it.")};
}

} // namespace

Status ReplayMesh::add(std::span<const std::uint32_t> points, std::span<const std::uint32_t> slots,
                       const Progress& progress, InsertionWatch* watch)
{
    if (parts_.size() > 1)
        return addToParts(points, slots, progress);
    std::vector<PackedPoint> packed;
    for (std::size_t first = 0; first < points.size(); first += addedAtOnce) {
        if (progress.cancelled())
            return cancelledError(replaying);
        const auto some = points.subspan(first, std::min(addedAtOnce, points.size() - first));
        packed.clear();
        for (const std::uint32_t point : some)
            packed.push_back(lattice_.pointAt(point));
        if (!parts_.front()->delaunay.add(packed, slots.empty() ? slots : slots.subspan(first, some.size()), watch))
            return meshGrewTooLarge();
    }
    return {};
}

/// Each part gets its points in their order, so that its mesh does not depend on the threads.
Status ReplayMesh::addToParts(std::span<const std::uint32_t> points, std::span<const std::uint32_t> slots,
                              const Progress& progress)
{
    for (std::vector<PartPoint>& entering : entering_)
        entering.clear();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const PackedPoint point = lattice_.pointAt(points[i]);
        const auto x = static_cast<std::uint32_t>(lattice_.x(point)), y = static_cast<std::uint32_t>(lattice_.y(point)),
                   z = static_cast<std::uint32_t>(lattice_.z(point));
        const std::uint32_t partY = partAlong(1, y), partZ = partAlong(2, z);
        const std::uint32_t fromY = partY > 0 && y == partY * partEdges_[1] ? partY - 1 : partY,
                            fromZ = partZ > 0 && z == partZ * partEdges_[2] ? partZ - 1 : partZ;
        for (std::uint32_t k = fromZ; k <= partZ; ++k)
            for (std::uint32_t j = fromY; j <= partY; ++j) {
                const std::uint32_t number = k * partCounts_[1] + j;
                const Part& part = *parts_[number];
                const bool placed = !slots.empty() && k == partZ && j == partY; // expect() looked there
                entering_[number].push_back(
                    {part.delaunay.lattice().pack(x, y - part.box.origin[1], z - part.box.origin[2]),
                     placed ? slots[i] : LatticeDelaunay::none});
            }
    }
    std::atomic<bool> failed = false;
    tbb::parallel_for(std::size_t(0), parts_.size(), [&](std::size_t number) {
        std::vector<PackedPoint> packed;
        std::vector<std::uint32_t> starts;
        const std::span<const PartPoint> entering = entering_[number];
        for (std::size_t first = 0; first < entering.size() && !progress.cancelled() && !failed; first += addedAtOnce) {
            packed.clear();
            starts.clear();
            for (const PartPoint& one : entering.subspan(first, std::min(addedAtOnce, entering.size() - first))) {
                packed.push_back(one.point);
                starts.push_back(one.slot);
            }
            if (!parts_[number]->delaunay.add(packed, starts))
                failed = true;
        }
    });
    if (progress.cancelled())
        return cancelledError(replaying);
    return failed ? Status(meshGrewTooLarge()) : Status();
}

Status ReplayMesh::measure(const Progress& progress)
{
    constexpr std::size_t atOnce = 4096;
    LocalDelaunay& delaunay = parts_.front()->delaunay;
    const std::uint32_t slots = delaunay.mesh().slotCount();
    // At first all, then what changed.
    if (errors_.empty()) {
        lastMeasured_.resize(slots);
        std::iota(lastMeasured_.begin(), lastMeasured_.end(), 0u);
        visitSampleType(type_, [&]<class T>() {
            for (const T sample : samplesAs<T>())
                largestSample_ = std::max(largestSample_, std::abs(static_cast<double>(sample)));
        });
    } else {
        lastMeasured_.assign(delaunay.changed().begin(), delaunay.changed().end());
    }
    errors_.resize(slots, 0);
    worst_.resize(slots, 0);
    const NoLimits limits;
    const std::span<const std::uint32_t> measured = lastMeasured_;
    visitSampleType(type_, [&]<class T>() {
        const LatticeSamples samples{std::span<const T>(samplesAs<T>())};
        // Sums of doubles are off by a few of their last bits.
        const double rounding = samples.exact() ? 0 : largestSample_ * 0x1p-42;
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, measured.size(), atOnce), [&](const auto& range) {
            if (progress.cancelled())
                return;
            const auto part = measured.subspan(range.begin(), range.size());
            for (const std::uint32_t slot : part)
                errors_[slot] = 0;
            std::vector<WorstSample> worst;
            scanSamples(delaunay, part, samples, limits, ScannedPart::All, worst);
            for (const WorstSample& found : worst) {
                errors_[found.slot] = roundedUp(found.error + rounding);
                worst_[found.slot] = found.point;
            }
        });
    });
    if (progress.cancelled())
        return cancelledError(replaying);
    delaunay.acceptChanges();
    return {};
}

float ReplayMesh::error() const
{
    float largest = 0;
    for (const float error : errors_)
        largest = std::max(largest, error);
    return largest;
}

Status ReplayMesh::addWorst(float limit, bool everywhere, Round& round, const Progress& progress)
{
    struct Candidate {
        PackedPoint point;
        std::uint32_t slot;
        std::array<PackedPoint, 4> vertices;
        double expected;
    };
    LocalDelaunay& delaunay = parts_.front()->delaunay;
    std::vector<Candidate> candidates;
    const auto look = [&](std::uint32_t slot) {
        if (errors_[slot] > limit && delaunay.isAlive(slot))
            candidates.push_back({worst_[slot], slot, delaunay.mesh()[slot].vertices, 0});
    };
    if (everywhere)
        for (std::uint32_t slot = 0; slot < errors_.size(); ++slot)
            look(slot);
    else
        std::ranges::for_each(lastMeasured_, look);
    std::ranges::sort(candidates, {}, [](const Candidate& one) { return std::pair(one.point, one.slot); });
    visitSampleType(type_, [&]<class T>() {
        const T* const samples = reinterpret_cast<const T*>(samples_.get());
        const auto sampleAt = [&](PackedPoint vertex) { return samples[lattice_.index(vertex)]; };
        for (Candidate& one : candidates)
            one.expected =
                interpolatedAt<T>(sampleAt, one.vertices, placeIn(delaunay.mesh(), one.point, one.slot).volumes);
    });
    round.points.clear();
    round.expected.clear();
    constexpr std::size_t between = 4096;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        if (i % between == 0 && progress.cancelled())
            return cancelledError(replaying);
        const Candidate& one = candidates[i];
        const DelaunayTetrahedron& now = delaunay.mesh()[one.slot];
        if (!(now.determinant() > 0) || now.vertices != one.vertices || delaunay.isVertex(one.point))
            continue;
        if (!delaunay.add({&one.point, 1}, {&one.slot, 1}))
            return meshGrewTooLarge();
        round.points.push_back(lattice_.index(one.point));
        round.expected.push_back(one.expected);
    }
    return {};
}

} // namespace tetra
