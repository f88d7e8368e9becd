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
template <class T> double interpolatedAt(const PackedLattice& lattice, const T* samples,
                                         const std::array<PackedPoint, 4>& vertices,
                                         const std::array<std::int64_t, 4>& volumes)
{
    const std::int64_t whole = volumes[0] + volumes[1] + volumes[2] + volumes[3];
    if (whole == 0) // no mesh has it
        return 0;
    if constexpr (std::is_integral_v<T> && sizeof(T) <= 2) {
        std::int64_t sum = 0;
        for (std::size_t i = 0; i < 4; ++i)
            sum += volumes[i] * static_cast<std::int64_t>(samples[lattice.index(vertices[i])]);
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
            const auto value = static_cast<double>(samples[lattice.index(vertex)]);
            if (!begun)
                first = value;
            begun = true;
            sum += static_cast<double>(weight / divisor) * (value - first);
        }
        const double result = first + sum / static_cast<double>(whole / divisor);
        return std::isfinite(result) ? result : first;
    }
}

/// No error is small enough: the largest one of each tetrahedron is to be found.
class NoLimits final : public ErrorLimits {
public:
    NoLimits() { twoValued = true; }
    double at(const std::array<std::uint32_t, 3>&) const override { return 0; }
};

} // namespace

Result<std::unique_ptr<ReplayMesh>> ReplayMesh::make(const Lattice& lattice, SampleType type, std::uint32_t blockCells,
                                                     const Progress& progress)
{
    std::unique_ptr<ReplayMesh> mesh(new ReplayMesh(lattice, type, blockCells));
    if (const Status prepared = mesh->prepare(lattice, progress); !prepared)
        return prepared.error();
    return mesh;
}

Status ReplayMesh::prepare(const Lattice& lattice, const Progress& progress)
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
    std::vector<PackedPoint> vertices;
    for (const DelaunayTetrahedron& tetrahedron : first.tetrahedra())
        vertices.insert(vertices.end(), tetrahedron.vertices.begin(), tetrahedron.vertices.end());
    std::ranges::sort(vertices);
    vertices.erase(std::ranges::unique(vertices).begin(), vertices.end());
    for (const DelaunayTetrahedron& tetrahedron : first.tetrahedra()) {
        std::array<std::uint32_t, 4> numbers{};
        for (std::size_t i = 0; i < 4; ++i)
            numbers[i] = static_cast<std::uint32_t>(std::ranges::lower_bound(vertices, tetrahedron.vertices[i]) -
                                                    vertices.begin());
        start_.push_back(numbers);
    }
    for (const PackedPoint vertex : vertices)
        corners_.push_back(first.lattice().index(vertex));
    if (const Status prepared = delaunay_.prepare(division_, *metric); !prepared)
        return prepared;
    const MeshLoading loaded = delaunay_.load(start_, vertices, progress);
    if (loaded == MeshLoading::Cancelled)
        return cancelledError(replaying);
    if (loaded != MeshLoading::Done)
        return Error{ErrorKind::OutOfResource, Message::say("The lattice is too large to be packed as a whole.")};
    auto samples = allocateSamples(type_, pointCount_);
    if (!samples)
        return samples.error();
    samples_ = *std::move(samples);
    std::memset(samples_.get(), 0, pointCount_ * sampleSize(type_));
    return {};
}

Status ReplayMesh::expect(std::span<const std::uint32_t> points, Expectations& expected, const Progress& progress) const
{
    constexpr std::size_t atOnce = 1024;
    expected.values.resize(points.size());
    expected.slots.resize(points.size());
    const PackedLattice lattice = delaunay_.lattice();
    std::atomic<bool> lost = false;
    visitSampleType(type_, [&]<class T>() {
        const T* const samples = reinterpret_cast<const T*>(samples_.get());
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points.size(), atOnce), [&](const auto& range) {
            if (progress.cancelled() || lost)
                return;
            for (std::size_t i = range.begin(); i < range.end(); ++i) {
                const PlacedPoint placed = delaunay_.place(lattice.pointAt(points[i]));
                if (placed.slot == LatticeDelaunay::none) {
                    lost = true;
                    return;
                }
                expected.slots[i] = placed.slot;
                expected.values[i] =
                    interpolatedAt(lattice, samples, delaunay_.mesh()[placed.slot].vertices, placed.volumes);
            }
        });
    });
    if (progress.cancelled())
        return cancelledError(replaying);
    if (lost)
        return Error{ErrorKind::BadInput, Message::say("A point lies in no tetrahedron of the mesh.")};
    return {};
}

Status ReplayMesh::add(std::span<const std::uint32_t> points, std::span<const std::uint32_t> slots,
                       const Progress& progress, InsertionWatch* watch)
{
    constexpr std::size_t atOnce = 4096;
    std::vector<PackedPoint> packed;
    for (std::size_t first = 0; first < points.size(); first += atOnce) {
        if (progress.cancelled())
            return cancelledError(replaying);
        const auto part = points.subspan(first, std::min(atOnce, points.size() - first));
        packed.clear();
        for (const std::uint32_t point : part)
            packed.push_back(delaunay_.lattice().pointAt(point));
        if (!delaunay_.add(packed, slots.empty() ? slots : slots.subspan(first, part.size()), watch))
            return Error{ErrorKind::OutOfResource, Message::say("The mesh grew beyond what was reserved for it.")};
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
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, measured.size(), atOnce), [&](const auto& range) {
            if (progress.cancelled())
                return;
            const auto part = measured.subspan(range.begin(), range.size());
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

Status ReplayMesh::addWorst(float limit, bool everywhere, Round& round, const Progress& progress)
{
    struct Candidate {
        PackedPoint point;
        std::uint32_t slot;
        std::array<PackedPoint, 4> vertices;
        double expected;
    };
    std::vector<Candidate> candidates;
    const auto look = [&](std::uint32_t slot) {
        if (errors_[slot] > limit && delaunay_.isAlive(slot))
            candidates.push_back({worst_[slot], slot, delaunay_.mesh()[slot].vertices, 0});
    };
    if (everywhere)
        for (std::uint32_t slot = 0; slot < errors_.size(); ++slot)
            look(slot);
    else
        std::ranges::for_each(lastMeasured_, look);
    std::ranges::sort(candidates, {}, [](const Candidate& one) { return std::pair(one.point, one.slot); });
    const PackedLattice lattice = delaunay_.lattice();
    visitSampleType(type_, [&]<class T>() {
        const T* const samples = reinterpret_cast<const T*>(samples_.get());
        for (Candidate& one : candidates)
            one.expected =
                interpolatedAt(lattice, samples, one.vertices, placeIn(delaunay_.mesh(), one.point, one.slot).volumes);
    });
    round.points.clear();
    round.expected.clear();
    constexpr std::size_t between = 4096;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        if (i % between == 0 && progress.cancelled())
            return cancelledError(replaying);
        const Candidate& one = candidates[i];
        const DelaunayTetrahedron& now = delaunay_.mesh()[one.slot];
        if (!(now.determinant() > 0) || now.vertices != one.vertices || delaunay_.isVertex(one.point))
            continue;
        if (!delaunay_.add({&one.point, 1}, {&one.slot, 1}))
            return Error{ErrorKind::OutOfResource, Message::say("The mesh grew beyond what was reserved for it.")};
        round.points.push_back(lattice.index(one.point));
        round.expected.push_back(one.expected);
    }
    return {};
}

} // namespace tetra
