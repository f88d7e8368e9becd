// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/packed/site_replay.h"

#include "core/base/rounding.h"
#include "core/history/batch_builder.h"
#include "core/history/build_facts.h"
#include "core/mesh/topology.h"
#include "core/packed/free_points.h"
#include "core/packed/number_order.h"
#include "core/packed/range_coder.h"
#include "core/packed/replay_coders.h"
#include "core/packed/replay_mesh.h"
#include "core/refine/curvilinear/curvilinear_refinement.h"
#include "core/refine/lattice/lattice_refinement.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>
#include <variant>

namespace tetra {

namespace {

/// Of the lattice in whose space the points of a lattice or grid are meshed.
Eigen::Vector3d spacingOfMesh(const HistoryFacts& facts)
{
    return facts.domain == DomainClass::Curvilinear ? Eigen::Vector3d(1, 1, 1) : facts.lattice.spacing;
}

/// Keeps a history as the arrays of its file.
class ArraysSink final : public HistorySink, private BatchSink {
public:
    explicit ArraysSink(const HistoryFacts& facts) : facts_(facts), builder_(facts.lattice.pointCount(), *this) {}

    Status add(const HistoryStep& step) override { return builder_.add(step); }
    Status finish(float) override { return builder_.finish(); }
    HistoryArrays& arrays() noexcept { return arrays_; }

private:
    Status add(const Batch& batch) override
    {
        if (arrays_.points.size() + batch.points.size() > facts_.siteCount ||
            arrays_.otherSites.size() + batch.tetrahedra.size() > facts_.tetrahedronCount)
            return Error{ErrorKind::BadInput, Message::say("The sites yield more than they should.")};
        growth_.assign(batch.points.size(), 0);
        for (const Batch::Destruction& destruction : batch.destructions) {
            arrays_.destroyers[destruction.tetrahedron] = destruction.destroyer;
            --growth_[destruction.destroyer - batch.firstSite];
        }
        const std::uint64_t first = arrays_.otherSites.size();
        for (std::size_t place = 0; place < batch.points.size(); ++place) {
            arrays_.points.push_back(static_cast<std::uint32_t>(batch.points[place]));
            arrays_.runningKeys.push_back(batch.runningKey);
            arrays_.groupGoesOn.push_back(batch.groupGoesOn[place]);
            arrays_.starOffsets.push_back(first + batch.starEnds[place]);
            meshSize_ += growth_[place] + batch.starEnds[place] - (place == 0 ? 0 : batch.starEnds[place - 1]);
            if (batch.groupGoesOn[place] == 0) // the size is that where the group ends
                arrays_.meshSizes.resize(arrays_.points.size(), static_cast<std::uint32_t>(meshSize_));
        }
        for (const Batch::Tetrahedron& tetrahedron : batch.tetrahedra) {
            arrays_.otherSites.push_back({tetrahedron.sites[1], tetrahedron.sites[2], tetrahedron.sites[3]});
            arrays_.destroyers.push_back(Model::never);
            arrays_.ownErrors.push_back(halfBound(tetrahedron.error, facts_.extent));
            if (canWarp(facts_.domain))
                arrays_.ownWarpings.push_back(halfBound(tetrahedron.warping, facts_.diagonal));
        }
        return {};
    }

    const HistoryFacts& facts_;
    HistoryArrays arrays_;
    BatchBuilder builder_;
    std::vector<std::int64_t> growth_;
    std::int64_t meshSize_ = 0;
};

} // namespace

bool maySitesTell(const Model& model)
{
    const ModelDescription& about = model.description();
    const BuildFacts facts = buildFacts(about);
    if (!isOnLattice(about.domain) || !about.delaunay || !facts.isRefined || facts.isWeighted() ||
        facts.hasPaperSelection || facts.claimsInSpace || model.siteCount() < 8 || !ReplayMesh::fits(about.lattice, 0))
        return false;
    // Blocks have more corners.
    const auto keys = model.runningKeys();
    return std::isinf(keys[7]) &&
           (model.siteCount() == 8 || !std::isinf(keys[8]) || about.domain == DomainClass::Curvilinear);
}

KnownSites::KnownSites(const SiteFacts& facts, std::shared_ptr<std::byte> samples)
    : facts_(facts), samples_(std::move(samples)),
      positions_(3 * facts.history.coordinateBytes * facts.history.lattice.pointCount()),
      isKnown_(facts.history.lattice.pointCount())
{
}

double KnownSites::coordinate(std::uint64_t point, std::size_t axis) const noexcept
{
    const std::byte* const bytes = positions_.data() + (3 * point + axis) * coordinateBytes();
    if (coordinateBytes() == sizeof(float)) {
        float number = 0;
        std::memcpy(&number, bytes, sizeof number);
        return static_cast<double>(number);
    }
    double number = 0;
    std::memcpy(&number, bytes, sizeof number);
    return number;
}

Result<HistoryArrays> KnownSites::history(const Progress& progress) const
{
    const HistoryFacts& facts = facts_.history;
    const std::uint64_t count = pointCount();
    std::vector<float> weights(count);
    for (std::uint64_t point = 0; point < count; ++point)
        weights[point] = isKnown_[point] ? 1 : 0;
    ArraysSink sink(facts);
    const Status refined = visitSampleType(facts.sampleType, [&]<class T>() -> Status {
        const LatticeSamples samples(std::span(reinterpret_cast<const T*>(samples_.get()), count), weights);
        if (facts.domain == DomainClass::RegularLattice) {
            LatticeRefinementOptions options;
            options.size = facts.lattice.size;
            options.spacing = facts.lattice.spacing;
            options.valueExtent = facts.extent;
            const auto result = refineLattice(options, samples, sink, progress);
            return result ? Status() : Status(result.error());
        }
        std::vector<Eigen::Vector3d> positions(count);
        for (std::uint64_t point = 0; point < count; ++point)
            positions[point] = {coordinate(point, 0), coordinate(point, 1), coordinate(point, 2)};
        const auto& size = facts.lattice.size;
        std::vector<FoldedCells::Place> folded;
        for (const std::uint64_t cell : facts_.foldedCells) {
            const std::uint64_t row = cell / (size[0] - 1);
            folded.push_back({static_cast<std::int32_t>(cell % (size[0] - 1)),
                              static_cast<std::int32_t>(row % (size[1] - 1)),
                              static_cast<std::int32_t>(row / (size[1] - 1))});
        }
        const KnownOfGrid known{facts_.grid, FoldedCells(std::move(folded))};
        CurvilinearRefinementOptions options;
        options.warpingWeight = facts.warpingWeight;
        options.valueExtent = facts.extent > 0 ? facts.extent : 1;
        options.positionExtent = facts.diagonal > 0 ? facts.diagonal : 1;
        options.known = &known;
        const auto result = refineCurvilinear(size, positions, samples, options, sink, progress);
        return result ? Status() : Status(result.error());
    });
    if (!refined)
        return refined.error();
    HistoryArrays arrays = std::move(sink.arrays());
    const auto gather = [&](std::span<const std::byte> from, std::size_t size, std::vector<std::byte>& to) {
        to.reserve(arrays.points.size() * size);
        for (const std::uint32_t point : arrays.points)
            to.insert(to.end(), from.begin() + static_cast<std::ptrdiff_t>(point * size),
                      from.begin() + static_cast<std::ptrdiff_t>((point + std::size_t(1)) * size));
    };
    gather(samples(), sampleBytes(), arrays.values);
    gather(positions(), 3 * coordinateBytes(), arrays.positions);
    return arrays;
}

bool sameButForBounds(const HistoryArrays& history, const Model& model)
{
    return std::ranges::equal(history.points, model.points()) && std::ranges::equal(history.values, model.values()) &&
           std::ranges::equal(std::as_bytes(std::span(history.runningKeys)), std::as_bytes(model.runningKeys())) &&
           std::ranges::equal(history.starOffsets, model.starOffsets()) &&
           std::ranges::equal(history.meshSizes, model.meshSizes()) &&
           std::ranges::equal(history.groupGoesOn, model.groupGoesOn()) &&
           std::ranges::equal(history.otherSites, model.otherSites()) &&
           std::ranges::equal(history.destroyers, model.destroyers());
}

void boundByKeys(const HistoryFacts& facts, float endKey, HistoryArrays& history)
{
    // Whatever lives where a batch ends is no worse than the mesh there.
    std::size_t end = history.points.size();
    float key = endKey;
    for (std::size_t site = end; site-- > 0;) {
        const float own = history.runningKeys[site];
        for (std::uint64_t t = history.starOffsets[site]; t < history.starOffsets[site + 1]; ++t) {
            history.ownErrors[t] = halfBound(key, facts.extent);
            if (!history.ownWarpings.empty())
                history.ownWarpings[t] =
                    halfBound(std::nextafter(static_cast<float>(static_cast<double>(key) / facts.warpingWeight),
                                             std::numeric_limits<float>::infinity()),
                              facts.diagonal);
        }
        if (site > 0 && history.runningKeys[site - 1] != own)
            key = own;
    }
}

// The sites.

/// The coordinates of a grid's points: what is expected comes from the mesh, or from known points on one of the grid's
/// lines through the point, whichever was closest lately.
class GridPositionCoder {
public:
    static constexpr std::size_t guesses = 4;
    /// Of one axis; NaN where there is none.
    using Guesses = std::array<double, guesses>;

    template <class T, class Coder> T code(Coder& coder, std::size_t axis, const Guesses& guess, T exact)
    {
        std::array<double, guesses>& cost = costs_[axis];
        std::size_t best = 0;
        for (std::size_t i = 1; i < guesses; ++i)
            if (!std::isnan(guess[i]) && (std::isnan(guess[best]) || cost[i] < cost[best]))
                best = i;
        constexpr unsigned bits = 8 * sizeof(T);
        const auto orderOfGuess = [&guess](std::size_t i) { return orderOf(nearestNumber<T>(guess[i])); };
        const auto context = static_cast<std::size_t>(std::clamp(cost[best] / 2, 0.0, double(contexts - 1)));
        const std::uint64_t from = orderOfGuess(best);
        std::uint64_t coded = zigzag(orderOf(exact), from, bits);
        // A number model has no 2^64 - 1, so of doubles the last bit is coded apart.
        if constexpr (sizeof(T) == 8) {
            const std::uint64_t upper = models_[axis][context].code(coder, coded >> 1);
            coded = upper << 1 | (codedBit(coder, lowest_[axis], (coded & 1) != 0) ? 1u : 0u);
        } else {
            coded = models_[axis][context].code(coder, coded);
        }
        const T number = numberOfOrder<T>(unzigzag(coded, from, bits));
        for (std::size_t i = 0; i < guesses; ++i)
            if (!std::isnan(guess[i])) {
                const auto taken = std::bit_width(zigzag(orderOf(number), orderOfGuess(i), bits));
                cost[i] += (static_cast<double>(taken) - cost[i]) / 8;
            }
        return number;
    }

private:
    static constexpr std::size_t contexts = 32;

    std::array<std::array<double, guesses>, 3> costs_{};
    std::array<std::array<NumberModel, contexts>, 3> models_;
    std::array<BitModel, 3> lowest_;
};

namespace {

/// Known points on a line of the grid through a point: two on each side at most.
struct LineNeighbours {
    std::array<std::uint64_t, 4> points{};
    std::array<double, 4> steps{};
    std::size_t count = 0;
};

} // namespace

struct SiteCoding {
    SiteCoding(const SiteFacts& facts, std::unique_ptr<ReplayMesh> made, std::shared_ptr<std::byte> samples)
        : mesh(std::move(made)), sites(facts, std::move(samples)), free(mesh->pointCount()),
          values(facts.history.sampleType)
    {
    }

    std::unique_ptr<ReplayMesh> mesh;
    KnownSites sites;
    FreePoints free;
    bool begun = false; ///< the corners are known
    // What is learnt, from the first set to the last:
    NumberModel sizes;
    GapCoder gaps;
    SampleCoder values;
    GridPositionCoder positions;

    static Result<std::unique_ptr<SiteCoding>> make(const SiteFacts& facts, const Progress& progress)
    {
        if (!ReplayMesh::fits(facts.history.lattice, 0))
            return Error{ErrorKind::OutOfResource, Message::say("The lattice is too large to be packed as a whole.")};
        const HistoryFacts& history = facts.history;
        const auto metric = latticeMetric(history.lattice.size, spacingOfMesh(history));
        if (!metric)
            return metric.error();
        auto samples = allocateSamples(history.sampleType, history.lattice.pointCount());
        if (!samples)
            return samples.error();
        auto mesh =
            ReplayMesh::make({.size = history.lattice.size, .metric = *metric}, history.sampleType, *samples, progress);
        if (!mesh)
            return mesh.error();
        return std::make_unique<SiteCoding>(facts, *std::move(mesh), *std::move(samples));
    }
};

namespace {

/// Codes a set with either coder: with the encoder what it is told, with the decoder what comes.
template <class Coder> class SetCoder {
    static constexpr bool encodes = std::is_same_v<Coder, RangeEncoder>;

public:
    SetCoder(SiteCoding& coding, Coder& coder, HistoryCost& cost) : coding_(coding), coder_(coder), cost_(cost) {}

    /// `points`, rising, are those of the set, without the corners; the decoder finds them. False if it does not.
    Result<bool> run(std::vector<std::uint32_t>& points, std::uint32_t count, const Progress& progress)
    {
        ReplayMesh& mesh = *coding_.mesh;
        if (!coding_.begun) {
            const std::vector<double> unknown(mesh.corners().size(), 0.0);
            for (const std::uint32_t corner : mesh.corners()) {
                coding_.free.remove(corner);
                codePoint(corner, LatticeDelaunay::none);
            }
            charge(&HistoryCost::positions);
            codeValues(mesh.corners(), unknown);
            coding_.begun = true;
        }
        if (count == 0 || !finite_)
            return finite_;
        if (count > coding_.free.count())
            return false;
        const std::uint64_t mean = coding_.free.count() / count;
        std::uint64_t place = 0;
        if constexpr (encodes) {
            for (const std::uint32_t point : points) {
                coding_.gaps.code(coder_, mean, coding_.free.countBetween(place, point));
                coding_.free.remove(point);
                place = point + 1ull;
            }
        } else {
            points.resize(count);
            if (!dispatch<takePoints>(coder_, coding_.gaps, mean, coding_.free, place, std::span(points)))
                return false;
        }
        // What the mesh says of samples does not take their positions.
        ReplayMesh::Expectations expected;
        if (const Status known = mesh.expect(points, expected, progress); !known)
            return known.error();
        for (std::size_t i = 0; i < points.size(); ++i)
            codePoint(points[i], expected.slots[i]);
        charge(&HistoryCost::positions);
        codeValues(points, expected.values);
        if (!finite_)
            return false;
        if (const Status added = mesh.add(points, expected.slots, progress); !added)
            return added.error();
        return true;
    }

private:
    void charge(std::uint64_t HistoryCost::*part)
    {
        if constexpr (encodes) {
            cost_.*part += coder_.size() - charged_;
            charged_ = coder_.size();
        }
    }

    void codeValues(std::span<const std::uint32_t> points, std::span<const double> expected)
    {
        coding_.values.code(coder_, coding_.mesh->samples().data(), points, expected.data());
        visitSampleType(coding_.mesh->type(), [&]<class T>() {
            const std::span<const T> samples = coding_.mesh->samplesAs<T>();
            if constexpr (std::is_floating_point_v<T>)
                for (const std::uint32_t point : points)
                    finite_ &= std::isfinite(samples[point]);
        });
        charge(&HistoryCost::values);
    }

    /// Where a point of a grid lies. `slot`: of the tetrahedron that has it, if there is one.
    void codePoint(std::uint32_t point, std::uint32_t slot)
    {
        KnownSites& sites = coding_.sites;
        if (sites.coordinateBytes() == sizeof(float))
            codeCoordinates<float>(point, slot);
        else if (sites.coordinateBytes() == sizeof(double))
            codeCoordinates<double>(point, slot);
        sites.setKnown(point);
    }

    template <class T> void codeCoordinates(std::uint32_t point, std::uint32_t slot)
    {
        KnownSites& sites = coding_.sites;
        std::array<GridPositionCoder::Guesses, 3> guesses;
        for (GridPositionCoder::Guesses& guess : guesses)
            guess.fill(std::numeric_limits<double>::quiet_NaN());
        if (slot != LatticeDelaunay::none)
            guessByMesh(point, slot, guesses);
        for (std::size_t line = 0; line < 3; ++line)
            guessByLine(neighboursOn(point, line), line, guesses);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            std::byte* const place = sites.positions().data() + (std::size_t(3) * point + axis) * sizeof(T);
            T number{};
            if constexpr (encodes)
                std::memcpy(&number, place, sizeof number);
            number = coding_.positions.code<T>(coder_, axis, guesses[axis], number);
            std::memcpy(place, &number, sizeof number);
            finite_ &= std::isfinite(number);
        }
    }

    /// The position interpolated by the mesh, in the way used for values that are not small integers: the result is the
    /// same for each of several tetrahedra that share the point.
    void guessByMesh(std::uint32_t point, std::uint32_t slot, std::array<GridPositionCoder::Guesses, 3>& guesses) const
    {
        const LatticeDelaunay& delaunay = coding_.mesh->delaunay();
        const PackedLattice& lattice = delaunay.lattice();
        const auto& vertices = delaunay[slot].vertices;
        const auto volumes = volumesAt(lattice, lattice.pointAt(point), vertices);
        for (std::size_t axis = 0; axis < 3; ++axis)
            guesses[axis][0] = interpolatedAt<double>(
                [&](PackedPoint vertex) { return coding_.sites.coordinate(lattice.index(vertex), axis); }, vertices,
                volumes);
    }

    LineNeighbours neighboursOn(std::uint32_t point, std::size_t line) const
    {
        constexpr std::uint32_t farthest = 12;
        const auto& size = coding_.sites.facts().history.lattice.size;
        const std::uint64_t stride = line == 0 ? 1 : line == 1 ? size[0] : std::uint64_t(size[0]) * size[1];
        const auto at = static_cast<std::uint32_t>(point / stride % size[line]);
        LineNeighbours found;
        for (const bool behind : {false, true}) {
            const std::uint32_t room = behind ? size[line] - 1 - at : at;
            std::uint32_t left = 2;
            for (std::uint32_t step = 1; step <= std::min(room, farthest) && left > 0; ++step) {
                const std::uint64_t other = behind ? point + step * stride : point - step * stride;
                if (!coding_.sites.isKnown(other))
                    continue;
                found.points[found.count] = other;
                found.steps[found.count++] = behind ? double(step) : -double(step);
                --left;
            }
        }
        return found;
    }

    /// The polynomial through these, as differences to the first.
    void guessByLine(const LineNeighbours& near, std::size_t line,
                     std::array<GridPositionCoder::Guesses, 3>& guesses) const
    {
        if (near.count == 0)
            return;
        std::array<double, 4> weights{};
        for (std::size_t i = 1; i < near.count; ++i) {
            double above = 1, below = 1;
            for (std::size_t k = 0; k < near.count; ++k)
                if (k != i) {
                    above *= 0 - near.steps[k];
                    below *= near.steps[i] - near.steps[k];
                }
            weights[i] = above / below;
        }
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double first = coding_.sites.coordinate(near.points[0], axis);
            double sum = 0;
            for (std::size_t i = 1; i < near.count; ++i)
                sum += weights[i] * (coding_.sites.coordinate(near.points[i], axis) - first);
            guesses[axis][1 + line] = first + sum;
        }
    }

    SiteCoding& coding_;
    Coder& coder_;
    HistoryCost& cost_;
    std::size_t charged_ = 0;
    bool finite_ = true; ///< all that was coded
};

} // namespace

SiteEncoder::SiteEncoder(const Model& model, std::unique_ptr<SiteCoding> coding)
    : model_(model), coding_(std::move(coding))
{
}

SiteEncoder::~SiteEncoder() = default;

Result<std::unique_ptr<SiteEncoder>> SiteEncoder::make(const Model& model, const SiteFacts& facts,
                                                       const Progress& progress)
{
    auto coding = SiteCoding::make(facts, progress);
    if (!coding)
        return coding.error();
    return std::unique_ptr<SiteEncoder>(new SiteEncoder(model, *std::move(coding)));
}

Result<std::vector<std::byte>> SiteEncoder::encode(std::uint32_t end, const Progress& progress)
{
    RangeEncoder coder;
    const auto corners = coding_->mesh->corners();
    // Values and positions enter the lattice's arrays where the coder finds them.
    KnownSites& sites = coding_->sites;
    const std::size_t sample = sites.sampleBytes(), position = 3 * sites.coordinateBytes();
    const std::span<const std::byte> positions = model_.floatPositions().empty()
                                                     ? std::as_bytes(model_.doublePositions())
                                                     : std::as_bytes(model_.floatPositions());
    std::vector<std::uint32_t> points;
    for (; coded_ < end; ++coded_) {
        const std::uint32_t point = model_.points()[coded_];
        std::memcpy(sites.samples().data() + point * sample, model_.values().data() + coded_ * sample, sample);
        if (position > 0)
            std::memcpy(sites.positions().data() + point * position, positions.data() + coded_ * position, position);
        if (std::ranges::find(corners, point) == corners.end())
            points.push_back(point);
    }
    std::ranges::sort(points);
    SetCoder<RangeEncoder> set(*coding_, coder, cost_);
    const Result<bool> coded = set.run(points, static_cast<std::uint32_t>(points.size()), progress);
    if (!coded.ok())
        return coded.error();
    if (!*coded)
        return Error{ErrorKind::BadInput,
                     Message::say("'%1' has positions or values that are not finite.", model_.path().string())};
    return coder.finish();
}

const KnownSites& SiteEncoder::sites() const noexcept
{
    return coding_->sites;
}

SiteDecoder::SiteDecoder(std::unique_ptr<SiteCoding> coding) : coding_(std::move(coding)) {}

SiteDecoder::~SiteDecoder() = default;

Result<std::unique_ptr<SiteDecoder>> SiteDecoder::make(const SiteFacts& facts, const Progress& progress)
{
    auto coding = SiteCoding::make(facts, progress);
    if (!coding)
        return coding.error();
    return std::unique_ptr<SiteDecoder>(new SiteDecoder(*std::move(coding)));
}

Result<bool> SiteDecoder::decode(std::span<const std::byte> bytes, std::uint32_t count, const Progress& progress)
{
    RangeDecoder coder(bytes);
    const auto first = static_cast<std::uint32_t>(coding_->begun ? 0 : coding_->mesh->corners().size());
    if (count < first)
        return false;
    HistoryCost unused;
    std::vector<std::uint32_t> points;
    const Result<bool> coded = SetCoder<RangeDecoder>(*coding_, coder, unused).run(points, count - first, progress);
    return coded.ok() ? *coded && !coder.overrun() : coded;
}

const KnownSites& SiteDecoder::takeSites()
{
    coding_->mesh.reset();
    return coding_->sites;
}

} // namespace tetra
