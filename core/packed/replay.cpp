// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/packed/replay.h"

#include "core/base/work_folder.h"
#include "core/build/model_build.h"
#include "core/history/build_facts.h"
#include "core/history/model_writer.h"
#include "core/packed/free_points.h"
#include "core/packed/number_order.h"
#include "core/packed/replay_coders.h"
#include "core/packed/replay_mesh.h"
#include "core/packed/replay_places.h"
#include "core/packed/replay_regions.h"
#include "core/refine/greedy.h"

#include <tan/build.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

namespace tetra {

namespace {

/// What a chunk holds.
enum class ReplayChunk : std::uint32_t {
    Sites = 1,  ///< sites with their values, in steps
    Others = 2, ///< the values of points that are no sites, in the lattice's order
};

/// Stands before a chunk's two streams, of positions and of values.
struct SiteChunkHead {
    std::uint32_t region = 0;
    std::uint32_t steps = 0; ///< of which the number of points is in this chunk
    std::uint32_t points = 0;
    std::uint32_t positionBytes = 0;
};

/// What has been learnt of where a region's sites are, from its first chunk to its last.
struct PositionModels {
    NumberModel steps;
    GapCoder gaps;
};

/// Sets the samples of `points` to what the mesh says of them, rounded.
void takeExpected(SampleType type, std::byte* samples, std::span<const std::uint32_t> points,
                  std::span<const double> expected)
{
    visitSampleType(type, [&]<class T>() {
        T* const of = reinterpret_cast<T*>(samples);
        for (std::size_t i = 0; i < points.size(); ++i)
            of[points[i]] = nearestNumber<T>(expected[i]);
    });
}

/// Whether that is what they are, bit by bit: 0 is not -0.
bool agreesWith(ReplayMesh& mesh, std::span<const std::uint32_t> points, std::span<const double> expected)
{
    return visitSampleType(mesh.type(), [&]<class T>() {
        const std::span<const T> samples = mesh.samplesAs<T>();
        for (std::size_t i = 0; i < points.size(); ++i)
            if (orderOf(nearestNumber<T>(expected[i])) != orderOf(samples[points[i]]))
                return false;
        return true;
    });
}

/// Chunks end only where so many points do.
constexpr std::size_t codedAtOnce = 256;

/// How many points are dealt with at a time, where there is no reason for another number.
constexpr std::size_t replayedAtOnce = 1 << 16;

/// A region's points that no region before it has, in its box: corners of blocks by rising numbers, and all others.
struct OwnPoints {
    OwnPoints() = default;
    OwnPoints(const ReplayRegion& region, const BlockDivision& division);

    std::vector<std::uint32_t> corners;
    FreePoints others{0};
};

OwnPoints::OwnPoints(const ReplayRegion& region, const BlockDivision& division) : others(region.box.pointCount())
{
    const LatticeBox& box = region.box;
    std::vector<std::uint32_t> bordersAlongX;
    for (std::uint32_t x = 0; x < box.size[0]; ++x)
        if (division.isBorder(0, x + box.origin[0]))
            bordersAlongX.push_back(x);
    std::uint64_t row = 0;
    for (std::uint32_t z = 0; z < box.size[2]; ++z)
        for (std::uint32_t y = 0; y < box.size[1]; ++y, row += box.size[0]) {
            const auto point = [row](std::uint32_t x) { return static_cast<std::uint32_t>(row + x); };
            const std::uint32_t firstOwn = region.firstOwn(y, z);
            for (std::uint32_t x = 0; x < firstOwn; ++x)
                others.remove(point(x));
            if (division.isBorder(2, z + box.origin[2]) && division.isBorder(1, y + box.origin[1]))
                for (const std::uint32_t x : bordersAlongX)
                    if (x >= firstOwn) {
                        corners.push_back(point(x));
                        others.remove(point(x));
                    }
        }
}

/// Calls visit(points) for the free points, in their order, so many at a time.
template <class Visit> Status forEachFree(const FreePoints& free, const Visit& visit)
{
    std::vector<std::uint32_t> points;
    std::uint64_t place = free.next(0, 0);
    while (place < free.size()) {
        points.clear();
        for (; place < free.size() && points.size() < replayedAtOnce; place = free.next(place + 1, 0))
            points.push_back(static_cast<std::uint32_t>(place));
        if (const Status visited = visit(std::span<const std::uint32_t>(points)); !visited)
            return visited;
    }
    return {};
}

constexpr MarkedText packing = Message::marked("Packing"), unpackingSites = Message::marked("Unpacking");

// The recipe.

/// How the model is built from its samples, or nothing if its text does not tell.
std::optional<Refinement> replayRecipe(const ModelDescription& description, std::uint32_t blockCells)
{
    Refinement recipe;
    recipe.block = blockCells;
    recipe.metric = description.metric;
    const BuildFacts facts = buildFacts(description);
    recipe.error = facts.error.value_or(recipe.error);
    auto weighting = parseWeighting(facts.weights);
    if (!weighting || !(recipe.error >= 0 && recipe.error <= 100))
        return std::nullopt;
    recipe.weighting = *std::move(weighting);
    return recipe;
}

/// The dataset that the model was built from, of all its samples; without them if they are not those.
std::optional<Dataset> replayedDataset(const ModelDescription& description, const std::shared_ptr<std::byte>& samples)
{
    Dataset dataset;
    dataset.domain = description.domain;
    dataset.lattice = description.lattice;
    dataset.values = ScalarField(description.sampleType, description.lattice.pointCount(), samples);
    dataset.space = description.space;
    dataset.lengthUnit = description.lengthUnit;
    dataset.source.name = description.sourceName;
    dataset.source.valueName = description.valueName;
    dataset.source.taken = description.taken;
    dataset.source.leftOut = description.leftOut;
    dataset.source.hash = contentHash(dataset.values, nullptr);
    if (dataset.source.hash != description.sourceHash || dataset.values.notFiniteCount() > 0)
        return std::nullopt;
    return dataset;
}

/// Builds the model into a file.
Status buildAgain(const Dataset& dataset, const ModelDescription& description, const Refinement& recipe,
                  const std::filesystem::path& output, const Progress& progress)
{
    ModelDescription provenance;
    provenance.builder = description.builder;
    provenance.parameters = description.parameters;
    provenance.metric = description.metric;
    const auto file = ModelFileTarget::open(output, dataset, provenance, false);
    if (!file)
        return file.error();
    BuildTarget target = (*file)->target((*file)->writer());
    const auto report = buildInto(dataset, recipe, target, progress);
    return report ? Status() : report.error();
}

// The lattice and its regions.

/// A lattice in regions, and all samples of it that are known.
struct ReplayedLattice {
    /// Errors: too large a lattice, memory.
    static Result<std::unique_ptr<ReplayedLattice>> make(const ModelDescription& about, std::uint32_t blockCells);

    std::array<std::uint32_t, 3> size;
    SampleType type;
    std::uint32_t blockCells;
    BlockDivision division;
    LatticeMetric metric{1, 1, 1};
    ReplayRegions regions;
    std::shared_ptr<std::byte> samples{}; ///< at first all 0

    std::uint64_t pointCount() const { return std::uint64_t(size[0]) * size[1] * size[2]; }
    std::byte* sample(std::uint32_t point) const { return samples.get() + std::size_t(point) * sampleSize(type); }
    /// The mesh of a region, with the lattice's samples if it is the only one, else with samples of its own.
    Result<std::unique_ptr<ReplayMesh>> mesh(const ReplayRegion& region, const Progress& progress) const;
    /// The mesh of the whole lattice.
    Result<std::unique_ptr<ReplayMesh>> wholeMesh(const Progress& progress) const
    {
        return ReplayMesh::make({size, blockCells, metric, false, false}, type, samples, progress);
    }
    void loadSamples(const ReplayRegion& region, ReplayMesh& mesh) const;  ///< the samples of a region's points
    void storeSamples(const ReplayRegion& region, ReplayMesh& mesh) const; ///< those of its own points
};

Result<std::unique_ptr<ReplayedLattice>> ReplayedLattice::make(const ModelDescription& about, std::uint32_t blockCells)
{
    const auto& size = about.lattice.size;
    const auto metric = latticeMetric(BlockDivision(size, blockCells).box(0).size, about.meshSpacing());
    if (!metric)
        return metric.error();
    std::unique_ptr<ReplayedLattice> result(new ReplayedLattice{.size = size,
                                                                .type = about.sampleType,
                                                                .blockCells = blockCells,
                                                                .division = BlockDivision(size, blockCells),
                                                                .metric = *metric,
                                                                .regions = ReplayRegions(size, blockCells)});
    auto samples = allocateSamples(about.sampleType, about.lattice.pointCount());
    if (!samples)
        return samples.error();
    result->samples = *std::move(samples);
    return result;
}

Result<std::unique_ptr<ReplayMesh>> ReplayedLattice::mesh(const ReplayRegion& region, const Progress& progress) const
{
    if (region.isWhole())
        return wholeMesh(progress);
    auto own = allocateSamples(type, region.box.pointCount());
    if (!own)
        return own.error();
    return ReplayMesh::make({region.box.size, blockCells, metric, region.firstBlockIsOdd, true}, type, *std::move(own),
                            progress);
}

void ReplayedLattice::loadSamples(const ReplayRegion& region, ReplayMesh& mesh) const
{
    if (region.isWhole())
        return;
    const std::size_t bytes = sampleSize(type), rowBytes = region.box.size[0] * bytes;
    for (std::size_t row = 0; row < mesh.pointCount(); row += region.box.size[0])
        std::memcpy(mesh.samples().data() + row * bytes, sample(region.inLattice(static_cast<std::uint32_t>(row))),
                    rowBytes);
}

void ReplayedLattice::storeSamples(const ReplayRegion& region, ReplayMesh& mesh) const
{
    if (region.isWhole())
        return;
    const std::size_t bytes = sampleSize(type);
    region.forEachOwnRow([&](std::uint32_t inBox, std::uint32_t inLattice, std::uint32_t count) {
        std::memcpy(sample(inLattice), mesh.samples().data() + inBox * bytes, count * bytes);
    });
}

// Packing.

/// What the errors of levels are at most, from the second one on: eight an octave, down to the finest.
std::vector<float> levelLimits(double range, double finest)
{
    constexpr double fall = 0.917;
    std::vector<float> limits;
    for (double limit = range; limit > finest && limits.size() + 2 < format::mostPackedLevels;) {
        limit = std::max(finest, fall * limit);
        limits.push_back(static_cast<float>(limit));
    }
    return limits;
}

/// Where levels end: fine enough that little is left to say of the other samples.
double finestOf(const ModelDescription& about, const Refinement& recipe)
{
    constexpr double unit = 0.4999, share = 1e-4;
    const double least = isInteger(about.sampleType) ? unit : share * about.range.extent();
    return std::max(least, recipe.error / 100 * about.range.extent());
}

/// A region's chunks and levels.
struct PackedRegion {
    struct Chunk {
        std::uint32_t level = 0; ///< in which it begins
        ReplayChunk kind = ReplayChunk::Sites;
        std::vector<std::byte> bytes;
    };
    struct Level {
        float error = 0;
        std::uint32_t sites = 0; ///< its own, so far
    };
    std::vector<Chunk> chunks;
    std::vector<Level> levels;
    std::uint64_t positions = 0; ///< bytes of sites
    std::uint64_t values = 0;
};

class RegionPacker {
public:
    RegionPacker(const ReplayRegion& region, const BlockDivision& division, ReplayMesh& mesh, SharedSites& shared,
                 std::uint32_t regionCount)
        : region_(region), mesh_(mesh), shared_(shared), own_(region, division), valueCoder_(mesh.type()),
          leastChunk_(std::max<std::size_t>(256, (4 << 10) / regionCount))
    {
    }

    Result<PackedRegion> pack(std::span<const float> limits, const Progress& progress);

private:
    class Level;

    Status packCorners(const Progress& progress);
    Status packLevel(float limit, const Progress& progress);
    Status addShared(const Progress& progress);
    void packSites(std::span<const std::uint32_t> points, std::span<const double> expected);
    void packValues(std::span<const std::uint32_t> points, const double* expected, ReplayChunk kind);
    Status packOthers(const Progress& progress);
    void endLevel();
    bool isFull() const;
    void closeChunk(ReplayChunk kind);

    const ReplayRegion& region_;
    ReplayMesh& mesh_;
    SharedSites& shared_;
    OwnPoints own_;
    PositionModels models_;
    SampleCoder valueCoder_;
    RangeEncoder positions_, values_;
    std::size_t leastChunk_;
    SiteChunkHead chunk_;
    std::uint32_t level_ = 0, chunkLevel_ = 0;
    std::uint32_t sites_ = 0;
    std::vector<std::uint32_t> arrived_, told_;
    PackedRegion result_;
};

Result<PackedRegion> RegionPacker::pack(std::span<const float> limits, const Progress& progress)
{
    if (const Status packed = packCorners(progress); !packed)
        return packed.error();
    for (const float limit : limits) {
        if (const Status packed = packLevel(limit, progress); !packed)
            return packed.error();
        progress.report(0.9 * level_ / static_cast<double>(limits.size() + 1), {});
    }
    if (chunk_.steps + chunk_.points > 0)
        closeChunk(ReplayChunk::Sites);
    if (const Status packed = packOthers(progress); !packed)
        return packed.error();
    return std::move(result_);
}

Status RegionPacker::packCorners(const Progress& progress)
{
    const std::vector<double> unknown(own_.corners.size(), 0.0);
    packValues(own_.corners, unknown.data(), ReplayChunk::Sites);
    if (const Status measured = mesh_.measure(progress); !measured)
        return measured;
    endLevel();
    return {};
}

/// What comes when in a level (core/refine/greedy.h): in the lattice's order the worst points of all tetrahedra that
/// are not good enough, which are a step, and then of those that it has changed. The level's last step has no points.
class RegionPacker::Level {
public:
    Level(RegionPacker& packer, float limit, const Progress& progress)
        : packer_(packer), mesh_(packer.mesh_), limit_(limit), progress_(progress)
    {
        find(true);
    }

    const WorstSample* next()
    {
        return worst_.next([this](const WorstSample& sample) { return mesh_.stands(sample); });
    }
    Status insert(const WorstSample& sample)
    {
        points_.push_back(mesh_.lattice().index(sample.point));
        expected_.push_back(mesh_.expectedAt(sample));
        return mesh_.add(sample);
    }
    std::uint64_t work() const { return Round<WorstSample>::work; }
    Status pause() const { return progress_.cancelled() ? Status(cancelledError(packing)) : Status(); }
    Result<bool> look()
    {
        packer_.models_.steps.code(packer_.positions_, points_.size());
        ++packer_.chunk_.steps;
        if (points_.empty())
            return false;
        packer_.packSites(points_, expected_);
        points_.clear();
        expected_.clear();
        if (const Status measured = mesh_.measure(progress_); !measured)
            return measured.error();
        find(false);
        return true;
    }

private:
    void find(bool everywhere)
    {
        const auto isOwn = [this](std::uint32_t point) { return packer_.region_.owns(point); };
        mesh_.findWorst(limit_, everywhere, isOwn, worst_.found);
        worst_.begin([](const WorstSample& one, const WorstSample& other) {
            return std::pair(one.point, one.slot) < std::pair(other.point, other.slot);
        });
    }

    RegionPacker& packer_;
    ReplayMesh& mesh_;
    float limit_;
    const Progress& progress_;
    Round<WorstSample> worst_;
    std::vector<std::uint32_t> points_; ///< of the step so far, by rising numbers ...
    std::vector<double> expected_;      ///< ... and what the mesh before it said of their samples
};

/// Steps until no error is larger than the limit, after the sites that come from other regions.
Status RegionPacker::packLevel(float limit, const Progress& progress)
{
    if (const Status added = addShared(progress); !added)
        return added;
    Level level(*this, limit, progress);
    if (const Status refined = refineGreedily(level); !refined)
        return refined;
    endLevel();
    return {};
}

Status RegionPacker::addShared(const Progress& progress)
{
    if (const Status awaited = shared_.await(region_, level_, arrived_, progress); !awaited)
        return awaited;
    if (arrived_.empty())
        return {};
    std::vector<std::uint32_t> points;
    for (const std::uint32_t site : arrived_)
        points.push_back(region_.inBox(site));
    if (const Status added = mesh_.add(points, {}, progress); !added)
        return added;
    return mesh_.measure(progress);
}

void RegionPacker::packSites(std::span<const std::uint32_t> points, std::span<const double> expected)
{
    const std::uint64_t mean = own_.others.count() / points.size();
    std::uint64_t place = 0;
    for (std::size_t begin = 0; begin < points.size(); begin += codedAtOnce) {
        const auto part = points.subspan(begin, std::min(codedAtOnce, points.size() - begin));
        for (const std::uint32_t point : part) {
            models_.gaps.code(positions_, mean, own_.others.countBetween(place, point));
            own_.others.remove(point);
            place = point + 1ull;
        }
        packValues(part, expected.data() + begin, ReplayChunk::Sites);
    }
}

/// Chunks end only where one of these calls does, or a level.
void RegionPacker::packValues(std::span<const std::uint32_t> points, const double* expected, ReplayChunk kind)
{
    for (std::size_t begin = 0; begin < points.size(); begin += codedAtOnce) {
        const auto part = points.subspan(begin, std::min(codedAtOnce, points.size() - begin));
        valueCoder_.code(values_, mesh_.samples().data(), part, expected + begin);
        chunk_.points += static_cast<std::uint32_t>(part.size());
        if (kind == ReplayChunk::Sites) {
            sites_ += static_cast<std::uint32_t>(part.size());
            for (const std::uint32_t point : part)
                if (region_.shares(point))
                    told_.push_back(region_.inLattice(point));
        }
        if (isFull())
            closeChunk(kind);
    }
}

void RegionPacker::endLevel()
{
    shared_.tell(region_, told_);
    told_.clear();
    result_.levels.push_back({mesh_.error(), sites_});
    ++level_;
    if (isFull())
        closeChunk(ReplayChunk::Sites);
    if (chunk_.steps + chunk_.points == 0)
        chunkLevel_ = level_;
}

/// The first chunks are smaller, so that something can be seen soon.
bool RegionPacker::isFull() const
{
    constexpr std::size_t most = 64 << 10;
    return positions_.size() + values_.size() >=
           std::clamp<std::size_t>((result_.positions + result_.values) / 4, leastChunk_, most);
}

void RegionPacker::closeChunk(ReplayChunk kind)
{
    const std::vector<std::byte> positions = positions_.finish(), values = values_.finish();
    chunk_.region = region_.number;
    chunk_.positionBytes = static_cast<std::uint32_t>(positions.size());
    PackedRegion::Chunk& chunk = result_.chunks.emplace_back(chunkLevel_, kind, std::vector<std::byte>(sizeof chunk_));
    std::memcpy(chunk.bytes.data(), &chunk_, sizeof chunk_);
    chunk.bytes.insert(chunk.bytes.end(), positions.begin(), positions.end());
    chunk.bytes.insert(chunk.bytes.end(), values.begin(), values.end());
    if (kind == ReplayChunk::Sites) {
        result_.positions += positions.size();
        result_.values += values.size();
    }
    positions_ = {};
    values_ = {};
    chunk_ = {};
    chunkLevel_ = level_;
}

/// The samples of the points that are no sites, if the last mesh does not tell them.
Status RegionPacker::packOthers(const Progress& progress)
{
    ReplayMesh::Expectations expected;
    bool told = true;
    const Status compared = forEachFree(own_.others, [&](std::span<const std::uint32_t> points) {
        const Status known = told ? mesh_.expect(points, expected, progress) : Status();
        told = told && known && agreesWith(mesh_, points, expected.values);
        return known;
    });
    if (!compared || told)
        return compared;
    const Status packed = forEachFree(own_.others, [&](std::span<const std::uint32_t> points) {
        const Status known = mesh_.expect(points, expected, progress);
        if (known)
            packValues(points, expected.values.data(), ReplayChunk::Others);
        return known;
    });
    if (packed && chunk_.points > 0)
        closeChunk(ReplayChunk::Others);
    return packed;
}

/// On all threads.
Result<std::vector<PackedRegion>> packRegions(const ReplayedLattice& lattice, const std::vector<float>& limits,
                                              const Progress& progress)
{
    std::vector<PackedRegion> packed(lattice.regions.count());
    SharedSites shared(lattice.regions);
    const Status done =
        lattice.regions.forEach(progress, packing, [&](const ReplayRegion& region, const Progress& own) -> Status {
            const auto mesh = lattice.mesh(region, own);
            if (!mesh)
                return mesh.error();
            lattice.loadSamples(region, **mesh);
            Result<PackedRegion> result =
                RegionPacker(region, lattice.division, **mesh, shared, lattice.regions.count()).pack(limits, own);
            if (!result)
                return result.error();
            packed[region.number] = *std::move(result);
            return {};
        });
    return done ? Result<std::vector<PackedRegion>>(std::move(packed)) : done.error();
}

/// Puts the regions' chunks into the file in the order of their levels, and says where levels end.
Result<PackReport> writeRegions(std::span<const PackedRegion> regions, PackedFileWriter& file)
{
    std::vector<std::size_t> next(regions.size(), 0);
    const auto write = [&](ReplayChunk kind, std::uint32_t level) -> Status {
        for (std::size_t region = 0; region < regions.size(); ++region)
            for (const auto& chunks = regions[region].chunks; next[region] < chunks.size(); ++next[region]) {
                const PackedRegion::Chunk& chunk = chunks[next[region]];
                if (chunk.kind != kind || chunk.level > level)
                    break;
                if (const Status added = file.addChunk(static_cast<std::uint32_t>(kind), chunk.bytes); !added)
                    return added;
            }
        return {};
    };
    const std::size_t levels = regions.front().levels.size();
    std::vector<PackedRegion::Level> of(levels);
    for (std::size_t level = levels; level-- > 0;) {
        for (const PackedRegion& region : regions) {
            of[level].error = std::max(of[level].error, region.levels[level].error);
            of[level].sites += region.levels[level].sites;
        }
        if (level + 1 < levels) // a bound never rises
            of[level].error = std::max(of[level].error, of[level + 1].error);
    }
    std::uint32_t sites = 0;
    for (std::uint32_t level = 0; level < levels; ++level) {
        if (const Status written = write(ReplayChunk::Sites, level); !written)
            return written.error();
        // Small levels are not worth an entry; the last one is, and stands for one before it that has all of its sites.
        constexpr std::uint32_t share = 12;
        const bool last = level + 1 == levels;
        if (last && of[level].sites == sites)
            file.dropLevel();
        if (last || of[level].sites - sites > sites / share) {
            file.endLevel(of[level].error, 0, of[level].sites, level);
            sites = of[level].sites;
        }
    }
    if (const Status written = write(ReplayChunk::Others, static_cast<std::uint32_t>(levels)); !written)
        return written.error();
    PackReport report;
    for (const PackedRegion& region : regions) {
        report.positions += region.positions;
        report.values += region.values;
    }
    report.accuracy = file.levelCount() * sizeof(format::PackedLevelEntry);
    return report;
}

Status checkReplayed(const Model& model)
{
    for (const bool intact : {model.check(model.points()), model.check(model.runningKeys()),
                              model.check(model.values()), model.check(model.samples())})
        if (!intact)
            return model.checkIntact();
    return {};
}

/// Finds the samples that the model was built from, as far as it tells them. False if its sites are no sites.
Result<bool> fillSamples(const Model& model, const ReplayedLattice& lattice, const Progress& progress)
{
    const std::span<const std::uint32_t> points = model.points();
    FreePoints free(lattice.pointCount());
    for (const std::uint32_t point : points) {
        if (point >= free.size() || !free.has(point))
            return false;
        free.remove(point);
    }
    if (!model.samples().empty()) {
        std::memcpy(lattice.samples.get(), model.samples().data(), model.samples().size());
        return true;
    }
    const std::size_t size = sampleSize(lattice.type);
    std::vector<std::vector<std::uint32_t>> sites(lattice.regions.count());
    std::vector<std::uint32_t> withSite;
    for (std::size_t site = 0; site < points.size(); ++site) {
        std::memcpy(lattice.sample(points[site]), model.values().data() + site * size, size);
        lattice.regions.withPoint(points[site], withSite);
        for (const std::uint32_t region : withSite)
            sites[region].push_back(points[site]);
    }
    const Status filled =
        lattice.regions.forEach(progress, packing, [&](const ReplayRegion& region, const Progress& own) -> Status {
            auto mesh = lattice.mesh(region, own);
            if (!mesh)
                return mesh.error();
            lattice.loadSamples(region, **mesh);
            const std::span<const std::uint32_t> corners = (*mesh)->corners();
            FreePoints others = OwnPoints(region, lattice.division).others;
            std::vector<std::uint32_t> inside;
            for (const std::uint32_t site : sites[region.number]) {
                const std::uint32_t point = region.inBox(site);
                if (std::ranges::binary_search(corners, point))
                    continue;
                inside.push_back(point);
                if (others.has(point))
                    others.remove(point);
            }
            if (const Status added = (*mesh)->add(inside, {}, own); !added)
                return added;
            ReplayMesh::Expectations expected;
            const Status known = forEachFree(others, [&](std::span<const std::uint32_t> some) {
                const Status told = (*mesh)->expect(some, expected, own);
                if (told)
                    takeExpected(lattice.type, (*mesh)->samples().data(), some, expected.values);
                return told;
            });
            if (known)
                lattice.storeSamples(region, **mesh);
            return known;
        });
    return filled ? Result<bool>(true) : filled.error();
}

/// Whether building the model again gives the same bytes.
Result<bool> isReproducible(const Model& model, const Dataset& dataset, const Refinement& recipe,
                            const std::filesystem::path& output, const Progress& progress)
{
    const auto folder = WorkFolder::open(workFolderOf(output), WorkFolder::Leftovers::Remove);
    if (!folder)
        return folder.error();
    const std::filesystem::path again = folder->path() / "again.tan";
    if (const Status built = buildAgain(dataset, model.description(), recipe, again, progress); !built)
        return built.error();
    const auto mapped = MappedFile::open(again);
    if (!mapped)
        return mapped.error();
    return std::ranges::equal(model.fileBytes(), (*mapped)->bytes());
}

// Unpacking.

/// The chunks of a region, as the file has them.
struct RegionChunks {
    std::vector<std::vector<std::byte>> sites;
    std::vector<std::vector<std::byte>> others;
};

/// All chunks up to so many bytes, or all there are: a model's chunks take less than a hundredth of its memory.
Result<std::vector<RegionChunks>> readChunks(const PackedFile& file, std::uint32_t regionCount, std::uint64_t bytes,
                                             const Progress& progress)
{
    std::vector<RegionChunks> regions(regionCount);
    PackedChunkReader chunks(file, bytes);
    for (;;) {
        const Result<bool> more = chunks.next(progress);
        if (!more.ok())
            return more.error();
        if (!*more)
            return regions;
        SiteChunkHead head;
        const auto kind = static_cast<ReplayChunk>(chunks.kind());
        if ((kind != ReplayChunk::Sites && kind != ReplayChunk::Others) || chunks.bytes().size() < sizeof head)
            return file.damaged(Message::say("its sites are invalid"));
        std::memcpy(&head, chunks.bytes().data(), sizeof head);
        if (head.region >= regionCount || head.positionBytes > chunks.bytes().size() - sizeof head)
            return file.damaged(Message::say("its sites are invalid"));
        RegionChunks& region = regions[head.region];
        (kind == ReplayChunk::Sites ? region.sites : region.others)
            .emplace_back(chunks.bytes().begin(), chunks.bytes().end());
    }
}

/// Where a region's sites are.
struct RegionSites {
    OwnPoints own;                        ///< `others`: those that are no sites
    std::vector<std::uint32_t> points{};  ///< of the lattice, in the order in which they were added, without corners
    std::vector<std::size_t> stepEnds{};  ///< by places in `points`
    std::vector<std::size_t> levelEnds{}; ///< by places in `stepEnds`
};

/// Reads the positions of a region's chunks.
class PositionReader {
public:
    PositionReader(const PackedFile& file, const std::vector<std::vector<std::byte>>& chunks)
        : file_(file), chunks_(chunks)
    {
    }

    /// So many levels. Errors: the chunks hold something else, or too little.
    Status read(const ReplayRegion& region, std::uint32_t levels, RegionSites& sites);
    /// Whether there is nothing behind these levels.
    bool atEnd() const { return left_.steps + left_.points == 0 && next_ == chunks_.size(); }

private:
    Status openChunk();
    Status readStep(const ReplayRegion& region, std::uint64_t points, RegionSites& sites);
    Error damaged() const { return file_.damaged(Message::say("its sites are invalid")); }

    const PackedFile& file_;
    const std::vector<std::vector<std::byte>>& chunks_;
    std::size_t next_ = 0;
    SiteChunkHead left_; ///< in the chunk
    std::optional<RangeDecoder> coder_;
    PositionModels models_;
};

Status PositionReader::read(const ReplayRegion& region, std::uint32_t levels, RegionSites& sites)
{
    for (std::size_t corners = sites.own.corners.size(); corners > 0;) {
        if (left_.points == 0)
            if (const Status opened = openChunk(); !opened)
                return opened;
        const auto some = static_cast<std::uint32_t>(std::min<std::size_t>(corners, left_.points));
        left_.points -= some;
        corners -= some;
        if (some == 0)
            return damaged();
    }
    sites.levelEnds.push_back(0);
    while (sites.levelEnds.size() < levels) {
        if (left_.steps == 0)
            if (const Status opened = openChunk(); !opened)
                return opened;
        if (left_.steps-- == 0)
            return damaged();
        const std::uint64_t points = models_.steps.code(*coder_, 0);
        if (points > sites.own.others.count() || coder_->overrun())
            return damaged();
        if (points == 0)
            sites.levelEnds.push_back(sites.stepEnds.size());
        else if (const Status read = readStep(region, points, sites); !read)
            return read;
    }
    return {};
}

Status PositionReader::readStep(const ReplayRegion& region, std::uint64_t points, RegionSites& sites)
{
    FreePoints& free = sites.own.others;
    const std::uint64_t mean = free.count() / points;
    std::uint64_t place = 0;
    while (points > 0) {
        if (left_.points == 0)
            if (const Status opened = openChunk(); !opened)
                return opened;
        const auto count = static_cast<std::uint32_t>(std::min<std::uint64_t>(points, left_.points));
        sites.points.resize(sites.points.size() + count);
        const std::span<std::uint32_t> taken = std::span(sites.points).last(count);
        if (count == 0 || !dispatch<takePoints>(*coder_, models_.gaps, mean, free, place, taken))
            return damaged();
        for (std::uint32_t& point : taken)
            point = region.inLattice(point);
        left_.points -= count;
        points -= count;
    }
    sites.stepEnds.push_back(sites.points.size());
    return {};
}

/// The next one, when all that the last one had is read.
Status PositionReader::openChunk()
{
    if (left_.steps + left_.points > 0 || next_ == chunks_.size())
        return damaged();
    const std::span<const std::byte> bytes = chunks_[next_++];
    std::memcpy(&left_, bytes.data(), sizeof left_);
    coder_.emplace(bytes.subspan(sizeof left_, left_.positionBytes));
    return {};
}

/// Reads the samples of a region's chunks, of which something is expected, in the order in which they were packed.
class SampleReader {
public:
    SampleReader(const PackedFile& file, const RegionChunks& chunks) : file_(file), chunks_(chunks) {}

    /// Whether there are samples of points that are no sites.
    bool hasOthers() const { return !chunks_.others.empty(); }
    /// Into the lattice's samples. Others come after all sites.
    Status read(ReplayChunk kind, std::span<const std::uint32_t> points, const double* expected,
                const ReplayedLattice& lattice);

private:
    Error damaged() const { return file_.damaged(Message::say("its sites are invalid")); }

    const PackedFile& file_;
    const RegionChunks& chunks_;
    std::size_t next_ = 0;   ///< of the sites' chunks, then of the others'
    std::uint32_t left_ = 0; ///< points in the chunk
    std::optional<RangeDecoder> coder_;
    std::optional<SampleCoder> values_;
};

Status SampleReader::read(ReplayChunk kind, std::span<const std::uint32_t> points, const double* expected,
                          const ReplayedLattice& lattice)
{
    if (!values_)
        values_.emplace(lattice.type);
    for (std::size_t begin = 0; begin < points.size();) {
        while (left_ == 0) {
            const std::size_t before = kind == ReplayChunk::Sites ? 0 : chunks_.sites.size();
            const auto& chunks = kind == ReplayChunk::Sites ? chunks_.sites : chunks_.others;
            next_ = std::max(next_, before);
            if (next_ - before >= chunks.size())
                return damaged();
            const std::span<const std::byte> bytes = chunks[next_++ - before];
            SiteChunkHead head;
            std::memcpy(&head, bytes.data(), sizeof head);
            coder_.emplace(bytes.subspan(sizeof head + head.positionBytes));
            left_ = head.points;
        }
        const std::size_t count = std::min<std::size_t>(left_, points.size() - begin);
        values_->code(*coder_, lattice.samples.get(), points.subspan(begin, count), expected + begin);
        if (coder_->overrun())
            return damaged();
        left_ -= static_cast<std::uint32_t>(count);
        begin += count;
    }
    return {};
}

/// What the chunks of a packed lattice hold, up to the end of a level of packing: first all positions, then, with the
/// places of these, the samples.
class ReplayReader {
public:
    /// Up to a level, or all there is. Errors: damage, the source's, cancelled.
    static Result<ReplayReader> open(const PackedFile& file, const ReplayedLattice& lattice,
                                     std::optional<std::size_t> level, const Progress& progress);

    /// Points of the lattice, without corners, by levels, then regions, then in the order in which they were added.
    std::span<const std::uint32_t> sites() const noexcept { return sites_; }
    /// Behind the last site of each step, by places in sites().
    std::span<const std::uint32_t> stepEnds() const noexcept { return stepEnds_; }
    /// Of the whole lattice, the points that are neither sites nor corners.
    FreePoints others() const;

    /// The samples of the corners, then those of each step, of which something is expected; others when all steps are
    /// read.
    Status readCorners();
    Status readStep(std::size_t step, const double* expected);
    /// `expect(points, expected)` tells what is expected of points.
    Status readOthers(const std::function<void(std::span<const std::uint32_t>, std::vector<double>&)>& expect,
                      const Progress& progress);

private:
    ReplayReader(const PackedFile& file, const ReplayedLattice& lattice) : file_(file), lattice_(lattice) {}
    void mergeSteps(std::uint32_t levels);
    Error damaged() const { return file_.damaged(Message::say("its sites are invalid")); }

    const PackedFile& file_;
    const ReplayedLattice& lattice_;
    std::vector<RegionChunks> chunks_;
    std::vector<RegionSites> regions_;
    std::vector<SampleReader> samples_; ///< of each region
    std::vector<std::uint32_t> sites_, stepEnds_;
    std::vector<std::uint32_t> stepRegions_;
};

Result<ReplayReader> ReplayReader::open(const PackedFile& file, const ReplayedLattice& lattice,
                                        std::optional<std::size_t> level, const Progress& progress)
{
    const format::PackedLevelEntry& last = level ? file.levels()[*level] : file.levels().back();
    ReplayReader reader(file, lattice);
    auto chunks = readChunks(file, lattice.regions.count(), level ? last.chunkBytes : file.chunks().size, progress);
    if (!chunks)
        return chunks.error();
    reader.chunks_ = *std::move(chunks);
    reader.regions_.resize(lattice.regions.count());
    const std::uint32_t levels = last.replayLevel + 1;
    const Status read = lattice.regions.forEach(
        progress, unpackingSites, [&](const ReplayRegion& region, const Progress& own) -> Status {
            RegionSites& sites = reader.regions_[region.number];
            sites.own = OwnPoints(region, lattice.division);
            PositionReader positions(file, reader.chunks_[region.number].sites);
            const Status done =
                own.cancelled() ? Status(cancelledError(unpackingSites)) : positions.read(region, levels, sites);
            return done && !level && !positions.atEnd() ? Status(reader.damaged()) : done;
        });
    if (!read)
        return read.error();
    reader.mergeSteps(levels);
    std::size_t corners = 0;
    for (const RegionSites& region : reader.regions_)
        corners += region.own.corners.size();
    if (corners + reader.sites_.size() != last.sites)
        return file.damaged(Message::say("its levels are invalid"));
    for (const RegionChunks& region : reader.chunks_)
        reader.samples_.emplace_back(file, region);
    return reader;
}

void ReplayReader::mergeSteps(std::uint32_t levels)
{
    for (std::uint32_t level = 1; level < levels; ++level)
        for (std::uint32_t number = 0; number < regions_.size(); ++number) {
            const RegionSites& region = regions_[number];
            for (std::size_t step = region.levelEnds[level - 1]; step < region.levelEnds[level]; ++step) {
                const auto place = [&](std::size_t end) {
                    return region.points.begin() + static_cast<std::ptrdiff_t>(end);
                };
                sites_.insert(sites_.end(), place(step == 0 ? 0 : region.stepEnds[step - 1]),
                              place(region.stepEnds[step]));
                stepEnds_.push_back(static_cast<std::uint32_t>(sites_.size()));
                stepRegions_.push_back(number);
            }
        }
    for (RegionSites& region : regions_)
        region.points = {};
}

FreePoints ReplayReader::others() const
{
    FreePoints free(lattice_.pointCount());
    for (std::uint32_t number = 0; number < regions_.size(); ++number)
        for (const std::uint32_t corner : regions_[number].own.corners)
            free.remove(lattice_.regions[number].inLattice(corner));
    for (const std::uint32_t site : sites_)
        free.remove(site);
    return free;
}

Status ReplayReader::readCorners()
{
    for (std::uint32_t number = 0; number < regions_.size(); ++number) {
        const ReplayRegion region = lattice_.regions[number];
        std::vector<std::uint32_t> corners;
        for (const std::uint32_t corner : regions_[number].own.corners)
            corners.push_back(region.inLattice(corner));
        const std::vector<double> unknown(corners.size(), 0.0);
        if (const Status read = samples_[number].read(ReplayChunk::Sites, corners, unknown.data(), lattice_); !read)
            return read;
    }
    return {};
}

Status ReplayReader::readStep(std::size_t step, const double* expected)
{
    const std::size_t begin = step == 0 ? 0 : stepEnds_[step - 1];
    return samples_[stepRegions_[step]].read(ReplayChunk::Sites, sites().subspan(begin, stepEnds_[step] - begin),
                                             expected, lattice_);
}

Status ReplayReader::readOthers(const std::function<void(std::span<const std::uint32_t>, std::vector<double>&)>& expect,
                                const Progress& progress)
{
    std::vector<double> expected;
    std::vector<std::uint32_t> points;
    for (std::uint32_t number = 0; number < regions_.size(); ++number) {
        const ReplayRegion region = lattice_.regions[number];
        SampleReader& samples = samples_[number];
        const Status read =
            forEachFree(regions_[number].own.others, [&](std::span<const std::uint32_t> some) -> Status {
                if (progress.cancelled())
                    return cancelledError(unpackingSites);
                points.clear();
                for (const std::uint32_t point : some)
                    points.push_back(region.inLattice(point));
                expect(points, expected);
                if (samples.hasOthers())
                    return samples.read(ReplayChunk::Others, points, expected.data(), lattice_);
                takeExpected(lattice_.type, lattice_.samples.get(), points, expected);
                return {};
            });
        if (!read)
            return read;
    }
    return {};
}

/// The samples of the sites, in their order.
Status readSites(ReplayReader& reader, const ReplayPlaces& places, const ReplayedLattice& lattice,
                 const Progress& progress)
{
    if (const Status read = reader.readCorners(); !read)
        return read;
    const PackedLattice points(lattice.size);
    std::vector<double> expected;
    std::size_t first = 0;
    for (std::size_t step = 0; step < reader.stepEnds().size(); ++step) {
        if (progress.cancelled())
            return cancelledError(unpackingSites);
        const std::size_t count = reader.stepEnds()[step] - first;
        interpolateIn(points, lattice.type, lattice.samples.get(), places.ofSites().subspan(first, count),
                      reader.sites().subspan(first, count), expected);
        if (const Status read = reader.readStep(step, expected.data()); !read)
            return read;
        first += count;
    }
    return {};
}

/// All samples of a packed lattice.
Status readSamples(const PackedFile& file, const ReplayedLattice& lattice, const Progress& progress)
{
    constexpr double sitesAt = 0.05, placesAt = 0.9;
    auto reader = ReplayReader::open(file, lattice, std::nullopt, progress.part(0, sitesAt));
    if (!reader)
        return reader.error();
    ReplayPlaces places;
    if (const Status found = places.find(lattice.division, lattice.metric, reader->sites(), reader->stepEnds(),
                                         reader->others(), nullptr, progress.part(sitesAt, placesAt));
        !found)
        return found;
    if (const Status read = readSites(*reader, places, lattice, progress); !read)
        return read;
    const PackedLattice points(lattice.size);
    std::vector<ReplayPlaces::Vertices> tetrahedra;
    return reader->readOthers(
        [&](std::span<const std::uint32_t> some, std::vector<double>& told) {
            tetrahedra.clear();
            for (const std::uint32_t point : some)
                tetrahedra.push_back(places.ofOther(point));
            interpolateIn(points, lattice.type, lattice.samples.get(), tetrahedra, some, told);
        },
        progress);
}

Result<std::unique_ptr<ReplayedLattice>> replayedLatticeOf(const PackedFile& file)
{
    const ModelDescription& about = file.description();
    if (about.domain != DomainClass::RegularLattice || !ReplayMesh::fits(about.lattice, file.facts().blockCells))
        return file.damaged(Message::say("a lattice of %1 points cannot be replayed", about.lattice.pointCount()));
    return ReplayedLattice::make(about, file.facts().blockCells);
}

} // namespace

Result<UnpackReport> compareSections(const PackedFile& file, const std::filesystem::path& model)
{
    const auto mapped = MappedFile::open(model);
    if (!mapped)
        return mapped.error();
    const auto layout = readLayout((*mapped)->bytes(), model);
    if (!layout)
        return layout.error();
    UnpackReport report;
    if (layout->header.checksum == file.facts().headerChecksum)
        return report;
    for (const format::PackedSum& sum : file.sums()) {
        const auto section = std::ranges::find(layout->sections, sum.id, &format::Section::id);
        if (section == layout->sections.end() || section->checksum != sum.checksum)
            report.derived.emplace_back(format::sectionName(sum.id));
    }
    for (const format::Section& section : layout->sections)
        if (std::ranges::find(file.sums(), section.id, &format::PackedSum::id) == file.sums().end())
            report.derived.emplace_back(format::sectionName(section.id));
    if (report.derived.empty())
        report.derived.emplace_back("header");
    return report;
}

namespace {

// A prefix: a history of its own.

/// Puts the histories of a prefix's blocks together.
class HistoryOfBlocks {
public:
    /// `sites`: behind the corners.
    HistoryOfBlocks(const BlockDivision& division, const BlockHistories& histories,
                    std::span<const std::uint32_t> sites, std::span<const format::PackedLevelEntry> levels);

    Status writeTo(std::span<const std::array<std::uint32_t, 4>> start, HistorySink& sink, const Progress& progress);

private:
    /// How far a tetrahedron may be off: what the last mesh that has it is.
    float errorOf(const BlockHistory& block, std::uint32_t tetrahedron) const
    {
        const std::uint32_t destroyer = block.destroyers[tetrahedron];
        return destroyer == BlockHistory::never ? finalError_ : errorsBefore_[destroyer];
    }
    Status addStartOf(std::span<const std::array<std::uint32_t, 4>> start, HistorySink& sink);
    void takeStep(std::uint32_t block);

    const BlockDivision& division_;
    PackedLattice lattice_;
    const BlockHistories& histories_;
    std::span<const std::uint32_t> sites_;
    float finalError_;
    std::vector<float> errorsBefore_;                 ///< of each site: the error of the level before its own
    std::uint32_t count_ = 0;                         ///< of tetrahedra that were handed over
    std::vector<std::vector<std::uint32_t>> numbers_; ///< theirs, of those of each block
    std::vector<std::uint32_t> next_;                 ///< of each block, of its sites
    std::vector<HistoryTetrahedron> star_;
    std::vector<std::uint32_t> destroyed_;
};

HistoryOfBlocks::HistoryOfBlocks(const BlockDivision& division, const BlockHistories& histories,
                                 std::span<const std::uint32_t> sites, std::span<const format::PackedLevelEntry> levels)
    : division_(division), lattice_(division.size()), histories_(histories), sites_(sites),
      finalError_(levels.back().error), next_(histories.blocks.size(), 0)
{
    for (std::size_t level = 1; level < levels.size(); ++level)
        errorsBefore_.resize(levels[level].sites - histories.corners.size(), levels[level - 1].error);
    for (const BlockHistory& block : histories.blocks)
        numbers_.emplace_back(block.destroyers.size());
}

Status HistoryOfBlocks::addStartOf(std::span<const std::array<std::uint32_t, 4>> start, HistorySink& sink)
{
    constexpr std::uint32_t ofBlock = LatticeDelaunay::startCount;
    std::vector<StartTetrahedron> tetrahedra;
    for (std::uint32_t i = 0; i < start.size(); ++i)
        tetrahedra.push_back({start[i], errorOf(histories_.blocks[i / ofBlock], i % ofBlock), 0});
    const std::vector<std::uint64_t> corners(histories_.corners.begin(), histories_.corners.end());
    const auto numbers = addStart(corners, tetrahedra, sink);
    if (!numbers)
        return numbers.error();
    for (std::uint32_t i = 0; i < start.size(); ++i)
        numbers_[i / ofBlock][i % ofBlock] = (*numbers)[i];
    count_ = static_cast<std::uint32_t>(start.size());
    return {};
}

/// What the next site of a block does there.
void HistoryOfBlocks::takeStep(std::uint32_t block)
{
    const BlockHistory& history = histories_.blocks[block];
    const std::uint32_t number = next_[block]++;
    const BlockHistory::Site before = number == 0 ? BlockHistory::Site() : history.sites[number - 1];
    const BlockHistory::Site& site = history.sites[number];
    for (std::uint32_t i = before.destroyedEnd; i < site.destroyedEnd; ++i)
        destroyed_.push_back(numbers_[block][history.destroyed[i]]);
    for (std::uint32_t i = before.madeEnd; i < site.madeEnd; ++i) {
        const std::uint32_t tetrahedron = LatticeDelaunay::startCount + i;
        numbers_[block][tetrahedron] = count_++;
        star_.push_back({history.otherSites[i], errorOf(history, tetrahedron), 0});
    }
}

Status HistoryOfBlocks::writeTo(std::span<const std::array<std::uint32_t, 4>> start, HistorySink& sink,
                                const Progress& progress)
{
    constexpr MarkedText writing = Message::marked("Writing the model");
    constexpr std::uint32_t toldAtOnce = 1 << 14;
    if (const Status added = addStartOf(start, sink); !added)
        return added;
    std::vector<std::uint32_t> blocks;
    for (std::uint32_t place = 0; place < sites_.size(); ++place) {
        if (place % toldAtOnce == 0) {
            if (progress.cancelled())
                return cancelledError(writing);
            progress.report(static_cast<double>(place) / static_cast<double>(sites_.size()), writing);
        }
        star_.clear();
        destroyed_.clear();
        const PackedPoint point = lattice_.pointAt(sites_[place]);
        // A point on a border of blocks enters several.
        division_.blocksOf({static_cast<std::uint32_t>(lattice_.x(point)),
                            static_cast<std::uint32_t>(lattice_.y(point)),
                            static_cast<std::uint32_t>(lattice_.z(point))},
                           blocks);
        for (const std::uint32_t block : blocks)
            takeStep(block);
        if (const Status added = sink.add({sites_[place], errorsBefore_[place], star_, destroyed_}); !added)
            return added;
    }
    return {};
}

} // namespace

bool mayBeReplayed(const Model& model)
{
    const ModelDescription& about = model.description();
    return about.domain == DomainClass::RegularLattice && about.delaunay && buildFacts(about).isRefined &&
           ReplayMesh::fits(about.lattice, 0);
}

Result<std::optional<PackReport>> packReplayed(const Model& model, PackedFileWriter& file, const Progress& progress)
{
    const std::optional<PackReport> cannot;
    if (const Status intact = checkReplayed(model); !intact)
        return intact.error();
    const ModelDescription& about = model.description();
    const auto notFirst = std::ranges::find_if(model.runningKeys(), [](float key) { return !std::isinf(key); });
    const auto cells = edgeOfBlocks(
        about.lattice.size, model.points().first(static_cast<std::size_t>(notFirst - model.runningKeys().begin())));
    if (!cells || !ReplayMesh::fits(about.lattice, *cells) ||
        !std::ranges::is_sorted(model.runningKeys(), std::ranges::greater()))
        return cannot;
    const auto recipe = replayRecipe(about, *cells);
    if (!recipe || !latticeMetric(BlockDivision(about.lattice.size, *cells).box(0).size, about.meshSpacing()))
        return cannot;
    const auto lattice = ReplayedLattice::make(about, *cells);
    if (!lattice)
        return lattice.error();
    constexpr double filledAt = 0.1;
    const Result<bool> filled = fillSamples(model, **lattice, progress.part(0, filledAt));
    if (!filled.ok())
        return filled.error();
    if (!*filled)
        return cannot;
    const auto dataset = replayedDataset(about, (*lattice)->samples);
    if (!dataset)
        return cannot;
    const Result<bool> same = isReproducible(model, *dataset, *recipe, file.target(), progress.part(filledAt, triedAt));
    if (!same.ok())
        return same.error();
    if (!*same)
        return cannot;
    file.setBlockCells(*cells);
    const auto regions =
        packRegions(**lattice, levelLimits(about.range.extent(), finestOf(about, *recipe)), progress.part(triedAt, 1));
    if (!regions)
        return regions.error();
    const Result<PackReport> report = writeRegions(*regions, file);
    if (!report)
        return report.error();
    return std::optional(*report);
}

Result<UnpackReport> unpackReplayed(const PackedFile& file, const std::filesystem::path& output,
                                    const Progress& progress)
{
    constexpr double readAt = 0.4;
    auto lattice = replayedLatticeOf(file);
    if (!lattice)
        return lattice.error();
    const ModelDescription& about = file.description();
    const auto recipe = replayRecipe(about, file.facts().blockCells);
    if (!recipe)
        return file.damaged(Message::say("its text does not tell how it was built"));
    if (const Status read = readSamples(file, **lattice, progress.part(0, readAt)); !read)
        return read.error();
    const auto dataset = replayedDataset(about, (*lattice)->samples);
    if (!dataset)
        return file.damaged(Message::say("its samples are not those that it was packed with"));
    lattice->reset();
    if (const Status built = buildAgain(*dataset, about, *recipe, output, progress.part(readAt, 1)); !built)
        return built.error();
    return compareSections(file, output);
}

Status unpackPrefixOfReplayed(const PackedFile& file, std::size_t level, const std::filesystem::path& output,
                              const Progress& progress)
{
    constexpr double sitesAt = 0.05, placesAt = 0.4, readAt = 0.5;
    const auto made = replayedLatticeOf(file);
    if (!made)
        return made.error();
    const ReplayedLattice& lattice = **made;
    auto start = startOfBlocks(lattice.division, lattice.metric, false);
    if (!start)
        return start.error();
    const auto levels = file.levels().first(level + 1);
    if (levels.front().sites != start->corners.size())
        return file.damaged(Message::say("its levels are invalid"));
    auto reader = ReplayReader::open(file, lattice, level, progress.part(0, sitesAt));
    if (!reader)
        return reader.error();
    BlockHistories histories{std::move(start->corners), {}};
    {
        ReplayPlaces places;
        if (const Status found = places.find(lattice.division, lattice.metric, reader->sites(), reader->stepEnds(),
                                             FreePoints(0), &histories, progress.part(sitesAt, placesAt));
            !found)
            return found;
        if (const Status read = readSites(*reader, places, lattice, progress.part(placesAt, readAt)); !read)
            return read;
    }
    Dataset dataset;
    dataset.lattice = file.description().lattice;
    dataset.values = ScalarField(lattice.type, lattice.pointCount(), lattice.samples);
    const auto writer = ModelWriter::create(output, dataset, file.description(), {}, KnownSamples::OfSites);
    if (!writer)
        return writer.error();
    HistoryTraits traits;
    traits.blockCells = lattice.division.blockCells();
    if (const Status begun = (*writer)->begin(traits); !begun)
        return begun;
    HistoryOfBlocks history(lattice.division, histories, reader->sites(), levels);
    if (const Status handed = history.writeTo(start->tetrahedra, **writer, progress.part(readAt, 1)); !handed)
        return handed;
    return (*writer)->finish(levels.back().error);
}

} // namespace tetra
