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
#include <utility>

namespace tetra {

namespace {

constexpr MarkedText replaying = Message::marked("Replaying the insertions");

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

/// On all threads if the work is alone on the machine.
template <class Visit> void forEach(bool alone, std::size_t count, const Visit& visit)
{
    if (alone)
        tbb::parallel_for(std::size_t(0), count, visit);
    else
        for (std::size_t i = 0; i < count; ++i)
            visit(i);
}

/// No error is small enough: the largest one of each tetrahedron is to be found.
class NoLimits final : public ErrorLimits {
public:
    NoLimits() { twoValued = true; }
    double at(const std::array<std::uint32_t, 3>&) const override { return 0; }
};

} // namespace

void interpolateIn(const PackedLattice& lattice, SampleType type, const std::byte* samples,
                   std::span<const std::array<PackedPoint, 4>> tetrahedra, std::span<const std::uint32_t> points,
                   std::vector<double>& expected)
{
    constexpr std::size_t atOnce = 2048;
    expected.resize(points.size());
    visitSampleType(type, [&]<class T>() {
        const auto sampleAt = [&](PackedPoint vertex) {
            return reinterpret_cast<const T*>(samples)[lattice.index(vertex)];
        };
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points.size(), atOnce), [&](const auto& range) {
            for (std::size_t i = range.begin(); i < range.end(); ++i)
                expected[i] = interpolatedAt<T>(sampleAt, tetrahedra[i],
                                                volumesAt(lattice, lattice.pointAt(points[i]), tetrahedra[i]));
        });
    });
}

Result<BlockStart> startOfBlocks(const BlockDivision& division, const LatticeMetric& metric, bool firstIsOdd)
{
    LatticeDelaunay first;
    if (const Status prepared =
            first.prepare(division.size(), metric, 64 + std::uint64_t(LatticeDelaunay::startCount) * division.count());
        !prepared)
        return prepared.error();
    for (std::uint32_t block = 0; block < division.count(); ++block)
        first.addBox(division.box(block), division.odd(block) == firstIsOdd);
    std::vector<PackedPoint> vertices;
    for (const DelaunayTetrahedron& tetrahedron : first.tetrahedra())
        vertices.insert(vertices.end(), tetrahedron.vertices.begin(), tetrahedron.vertices.end());
    std::ranges::sort(vertices);
    vertices.erase(std::ranges::unique(vertices).begin(), vertices.end());
    BlockStart start;
    for (const DelaunayTetrahedron& tetrahedron : first.tetrahedra())
        start.tetrahedra.push_back(numbersOf(tetrahedron.vertices, vertices));
    for (const PackedPoint vertex : vertices)
        start.corners.push_back(first.lattice().index(vertex));
    return start;
}

ReplayMesh::ReplayMesh(const Shape& shape, SampleType type, std::shared_ptr<std::byte> samples)
    : type_(type), pointCount_(std::uint64_t(shape.size[0]) * shape.size[1] * shape.size[2]), shared_(shape.shared),
      samples_(std::move(samples))
{
}

bool ReplayMesh::fits(const Lattice& lattice, std::uint32_t blockCells)
{
    constexpr std::uint64_t mostPoints = 1ull << 28, mostBlocks = 1 << 17;
    if (lattice.pointCount() > mostPoints || !PackedLattice::fits(lattice.size))
        return false;
    std::uint64_t blocks = 1;
    for (const std::uint32_t size : lattice.size)
        blocks *= blockCells == 0 ? 1 : (size - 2) / blockCells + 1;
    return blocks <= mostBlocks;
}

Result<std::unique_ptr<ReplayMesh>> ReplayMesh::make(const Shape& shape, SampleType type,
                                                     std::shared_ptr<std::byte> samples, const Progress& progress)
{
    std::unique_ptr<ReplayMesh> mesh(new ReplayMesh(shape, type, std::move(samples)));
    if (const Status prepared = mesh->prepare(shape, progress); !prepared)
        return prepared.error();
    return mesh;
}

Status ReplayMesh::prepare(const Shape& shape, const Progress& progress)
{
    const BlockDivision division(shape.size, shape.blockCells);
    auto start = startOfBlocks(division, shape.metric, shape.firstIsOdd);
    if (!start)
        return start.error();
    if (const Status prepared = delaunay_.prepare(division, shape.metric); !prepared)
        return prepared;
    corners_ = std::move(start->corners);
    std::vector<PackedPoint> vertices;
    for (const std::uint32_t corner : corners_)
        vertices.push_back(lattice().pointAt(corner));
    switch (delaunay_.load(start->tetrahedra, vertices, progress)) {
    case MeshLoading::Done: return {};
    case MeshLoading::Cancelled: return cancelledError(replaying);
    default: return Error{ErrorKind::OutOfResource, Message::say("The lattice is too large to be packed as a whole.")};
    }
}

Status ReplayMesh::expect(std::span<const std::uint32_t> points, Expectations& expected, const Progress& progress) const
{
    constexpr std::size_t atOnce = 512;
    expected.values.resize(points.size());
    expected.slots.resize(points.size());
    std::atomic<bool> lost = false;
    const PackedLattice& packed = lattice();
    const auto expectRun = [&]<class T>(const T* samples, std::size_t begin) {
        if (progress.cancelled() || lost)
            return;
        std::array<PackedPoint, atOnce> there;
        std::array<PlacedPoint, atOnce> placed;
        const std::size_t count = std::min(atOnce, points.size() - begin);
        for (std::size_t i = 0; i < count; ++i)
            there[i] = packed.pointAt(points[begin + i]);
        delaunay_.place(std::span(there).first(count), std::span(placed).first(count));
        const auto sampleAt = [&](PackedPoint vertex) { return samples[packed.index(vertex)]; };
        for (std::size_t i = 0; i < count; ++i) {
            const auto& [slot, volumes] = placed[i];
            if (slot == LatticeDelaunay::none) {
                lost = true;
                return;
            }
            expected.slots[begin + i] = slot;
            expected.values[begin + i] = interpolatedAt<T>(sampleAt, delaunay_.mesh()[slot].vertices, volumes);
        }
    };
    visitSampleType(type_, [&]<class T>() {
        const T* const samples = reinterpret_cast<const T*>(samples_.get());
        // Runs have a fixed length: which of several tetrahedra that share a point is found depends on where a run
        // begins, and must not depend on the number of threads.
        forEach(!shared_, (points.size() + atOnce - 1) / atOnce,
                [&](std::size_t run) { expectRun(samples, run * atOnce); });
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
                       const Progress& progress)
{
    std::vector<PackedPoint> packed;
    for (std::size_t first = 0; first < points.size(); first += addedAtOnce) {
        if (progress.cancelled())
            return cancelledError(replaying);
        const auto some = points.subspan(first, std::min(addedAtOnce, points.size() - first));
        packed.clear();
        for (const std::uint32_t point : some)
            packed.push_back(lattice().pointAt(point));
        if (!delaunay_.add(packed, slots.empty() ? slots : slots.subspan(first, some.size())))
            return meshGrewTooLarge();
    }
    return {};
}

Status ReplayMesh::measure(const Progress& progress)
{
    constexpr std::size_t atOnce = 4096;
    const std::uint32_t slots = delaunay_.mesh().slotCount();
    // At first all, then what changed.
    if (errors_.empty()) {
        lastMeasured_.resize(slots);
        std::iota(lastMeasured_.begin(), lastMeasured_.end(), 0u);
        visitSampleType(type_, [&]<class T>() {
            for (const T sample : samplesAs<T>())
                largestSample_ = std::max(largestSample_, std::abs(static_cast<double>(sample)));
        });
    } else {
        lastMeasured_.assign(delaunay_.changed().begin(), delaunay_.changed().end());
    }
    errors_.resize(slots, 0);
    worst_.resize(slots, 0);
    const NoLimits limits;
    const std::span<const std::uint32_t> measured = lastMeasured_;
    visitSampleType(type_, [&]<class T>() {
        const LatticeSamples samples{std::span<const T>(samplesAs<T>())};
        // Sums of doubles are off by a few of their last bits.
        const double rounding = samples.exact() ? 0 : largestSample_ * 0x1p-42;
        forEach(!shared_, (measured.size() + atOnce - 1) / atOnce, [&](std::size_t run) {
            if (progress.cancelled())
                return;
            const auto part =
                measured.subspan(run * atOnce, std::min<std::size_t>(atOnce, measured.size() - run * atOnce));
            for (const std::uint32_t slot : part)
                errors_[slot] = 0;
            std::vector<WorstSample> worst;
            scanSamples(delaunay_, part, samples, limits, ScannedPart::All, worst);
            for (const WorstSample& found : worst) {
                errors_[found.slot] = roundedUp(found.error + rounding);
                worst_[found.slot] = found.point;
            }
        });
    });
    if (progress.cancelled())
        return cancelledError(replaying);
    delaunay_.acceptChanges();
    return {};
}

float ReplayMesh::error() const
{
    float largest = 0;
    for (const float error : errors_)
        largest = std::max(largest, error);
    return largest;
}

void ReplayMesh::findWorst(float limit, bool everywhere, const std::function<bool(std::uint32_t)>& eligible,
                           std::vector<WorstSample>& found) const
{
    found.clear();
    const auto look = [&](std::uint32_t slot) {
        if (errors_[slot] > limit && delaunay_.isAlive(slot) && eligible(lattice().index(worst_[slot])))
            found.push_back(
                {0, static_cast<double>(errors_[slot]), worst_[slot], slot, delaunay_.mesh()[slot].vertices});
    };
    if (everywhere)
        for (std::uint32_t slot = 0; slot < errors_.size(); ++slot)
            look(slot);
    else
        std::ranges::for_each(lastMeasured_, look);
}

double ReplayMesh::expectedAt(const WorstSample& sample) const
{
    return visitSampleType(type_, [&]<class T>() {
        const T* const samples = reinterpret_cast<const T*>(samples_.get());
        const auto sampleAt = [&](PackedPoint vertex) { return samples[lattice().index(vertex)]; };
        return interpolatedAt<T>(sampleAt, sample.tetrahedron, volumesAt(lattice(), sample.point, sample.tetrahedron));
    });
}

Status ReplayMesh::add(const WorstSample& sample)
{
    return delaunay_.add({&sample.point, 1}, {&sample.slot, 1}) ? Status() : Status(meshGrewTooLarge());
}

} // namespace tetra
