// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/packed/replay.h"

#include "core/base/work_folder.h"
#include "core/build/model_build.h"
#include "core/history/model_writer.h"
#include "core/packed/free_points.h"
#include "core/packed/replay_coders.h"
#include "core/packed/replay_mesh.h"
#include "core/refine/greedy.h"

#include <tan/build.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <string>
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
    std::uint32_t points = 0;
    std::uint32_t positionBytes = 0;
};

/// The coders of a chunk.
template <class Coder> struct ChunkCoders {
    Coder positions;
    Coder values;
    NumberModel sizes; ///< of steps
    GapCoder gaps;
};

/// Codes the values of points against what is expected of them, whatever their type is.
class AnyValueCoder {
public:
    virtual ~AnyValueCoder() = default;
    virtual void encode(RangeEncoder& coder, std::span<const std::uint32_t> points, const double* expected) = 0;
    /// Into the mesh's samples.
    virtual void decode(RangeDecoder& coder, std::span<const std::uint32_t> points, const double* expected) = 0;

    static std::unique_ptr<AnyValueCoder> make(ReplayMesh& mesh);
};

template <class T> class TypedValueCoder final : public AnyValueCoder {
public:
    explicit TypedValueCoder(std::span<T> samples) : samples_(samples) {}
    void encode(RangeEncoder& coder, std::span<const std::uint32_t> points, const double* expected) override
    {
        for (std::size_t i = 0; i < points.size(); ++i)
            values_.code(coder, expected[i], samples_[points[i]]);
    }
    void decode(RangeDecoder& coder, std::span<const std::uint32_t> points, const double* expected) override
    {
        for (std::size_t i = 0; i < points.size(); ++i)
            samples_[points[i]] = values_.code(coder, expected[i], T());
    }

private:
    std::span<T> samples_;
    ValueCoder<T> values_;
};

std::unique_ptr<AnyValueCoder> AnyValueCoder::make(ReplayMesh& mesh)
{
    return visitSampleType(mesh.type(), [&]<class T>() -> std::unique_ptr<AnyValueCoder> {
        return std::make_unique<TypedValueCoder<T>>(mesh.samplesAs<T>());
    });
}

/// Sets the samples of `points` to what the mesh says of them, rounded.
void takeExpected(ReplayMesh& mesh, std::span<const std::uint32_t> points, std::span<const double> expected)
{
    visitSampleType(mesh.type(), [&]<class T>() {
        const std::span<T> samples = mesh.samplesAs<T>();
        for (std::size_t i = 0; i < points.size(); ++i) {
            if constexpr (std::is_integral_v<T>)
                samples[points[i]] = static_cast<T>(std::clamp(std::floor(expected[i] + 0.5),
                                                               static_cast<double>(std::numeric_limits<T>::min()),
                                                               static_cast<double>(std::numeric_limits<T>::max())));
            else
                samples[points[i]] = static_cast<T>(expected[i]);
        }
    });
}

/// Whether that is what they are.
bool agreesWith(ReplayMesh& mesh, std::span<const std::uint32_t> points, std::span<const double> expected)
{
    return visitSampleType(mesh.type(), [&]<class T>() {
        const std::span<const T> samples = mesh.samplesAs<T>();
        for (std::size_t i = 0; i < points.size(); ++i) {
            const T told = static_cast<T>(std::is_integral_v<T> ? std::floor(expected[i] + 0.5) : expected[i]);
            if (std::memcmp(&told, &samples[points[i]], sizeof told) != 0)
                return false;
        }
        return true;
    });
}

/// Chunks end only where so many points do.
constexpr std::size_t codedAtOnce = 256;

/// How many points are dealt with at a time, where there is no reason for another number.
constexpr std::size_t replayedAtOnce = 1 << 16;

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

constexpr MarkedText unpackingSites = Message::marked("Unpacking");

/// Whether a mesh of all points can be kept: in address space, and in the numbers of its tetrahedra.
bool isReplayableSize(const Lattice& lattice, std::uint32_t blockCells)
{
    constexpr std::uint64_t mostPoints = 1ull << 28, mostBlocks = 1 << 17;
    if (lattice.pointCount() > mostPoints || !PackedLattice::fits(lattice.size))
        return false;
    std::uint64_t blocks = 1;
    for (const std::uint32_t size : lattice.size)
        blocks *= blockCells == 0 ? 1 : (size - 2) / blockCells + 1;
    return blocks <= mostBlocks;
}

// The recipe.

/// How the model is built from its samples, or nothing if its text does not tell.
std::optional<Refinement> replayRecipe(const ModelDescription& description, std::uint32_t blockCells)
{
    Refinement recipe;
    recipe.block = blockCells;
    for (const auto& [name, text] : description.parameters) {
        if (name == "error") {
            const auto error = parseNumber<double>(text);
            if (!error || !(*error >= 0 && *error <= 100))
                return std::nullopt;
            recipe.error = *error;
        } else if (name == "weights") {
            const auto weighting = parseWeighting(text);
            if (!weighting)
                return std::nullopt;
            recipe.weighting = *weighting;
        }
    }
    return recipe;
}

/// The dataset that the model was built from, of all its samples; without them if they are not those.
std::optional<Dataset> replayedDataset(const ModelDescription& description, const std::shared_ptr<std::byte>& samples)
{
    Dataset dataset;
    dataset.domain = description.domain;
    dataset.lattice = description.lattice;
    dataset.values = ScalarField(description.sampleType, description.lattice.pointCount(), samples);
    dataset.source.name = description.sourceName;
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
    const auto file = ModelFileTarget::open(output, dataset, provenance, false);
    if (!file)
        return file.error();
    BuildTarget target = (*file)->target((*file)->writer());
    const auto report = buildInto(dataset, recipe, target, progress);
    return report ? Status() : report.error();
}

// Packing.

/// Each level has at most so much of the error of the one before: eight an octave.
constexpr double levelFall = 0.917;

/// Where levels end: fine enough that little is left to say of the other samples.
double finestOf(const ReplayMesh& mesh, const ModelDescription& about, const Refinement& recipe)
{
    constexpr double unit = 0.4999, share = 1e-4;
    const double least = isInteger(mesh.type()) ? unit : share * about.range.extent();
    return std::max(least, recipe.error / 100 * about.range.extent());
}

/// Chunks are closed when they are so large: the first ones earlier, so that something can be seen soon.
std::size_t chunkBytesWanted(std::uint64_t written)
{
    return static_cast<std::size_t>(std::clamp<std::uint64_t>(written / 4, 4 << 10, 64 << 10));
}

class ReplayPacker {
public:
    ReplayPacker(ReplayMesh& mesh, PackedFileWriter& file) : mesh_(mesh), file_(file), free_(mesh.pointCount()) {}

    /// Levels down to an error.
    Result<PackReport> pack(double finest, const Progress& progress);

private:
    Status packCorners();
    Status packLevel(float limit, const Progress& progress);
    Status packSites(std::span<const std::uint32_t> points, std::span<const double> expected);
    Status packOthers(const Progress& progress);
    Status closeChunk(ReplayChunk kind);
    void writeLevels();

    ReplayMesh& mesh_;
    PackedFileWriter& file_;
    FreePoints free_;
    ChunkCoders<RangeEncoder> coders_;
    std::unique_ptr<AnyValueCoder> values_ = AnyValueCoder::make(mesh_);
    std::uint32_t pointsInChunk_ = 0;
    std::uint64_t writtenSites_ = 0; ///< bytes of chunks
    std::uint32_t sites_ = 0;
    /// Errors and sites; those after the first so many wait for their chunk's end.
    std::vector<std::pair<float, std::uint32_t>> levels_;
    std::size_t levelsWritten_ = 0;
    PackReport report_;
};

Result<PackReport> ReplayPacker::pack(double finest, const Progress& progress)
{
    constexpr MarkedText packing = Message::marked("Packing");
    if (const Status packed = packCorners(); !packed)
        return packed.error();
    if (const Status measured = mesh_.measure(progress); !measured)
        return measured.error();
    float error = mesh_.error();
    levels_.emplace_back(error, sites_);
    const double first = std::max(static_cast<double>(error), 2 * finest);
    while (static_cast<double>(error) > finest) {
        const double limit = std::max(finest, levelFall * static_cast<double>(error));
        if (const Status packed = packLevel(static_cast<float>(limit), progress); !packed)
            return packed.error();
        error = mesh_.error();
        // Small levels are not worth an entry.
        constexpr std::uint32_t share = 12;
        if (sites_ - levels_.back().second > levels_.back().second / share || !(static_cast<double>(error) > finest))
            levels_.emplace_back(error, sites_);
        progress.report(
            0.9 * std::min(1.0, std::log(first / std::max<double>(error, finest)) / std::log(first / finest)), packing);
    }
    if (pointsInChunk_ > 0)
        if (const Status closed = closeChunk(ReplayChunk::Sites); !closed)
            return closed.error();
    writeLevels();
    if (const Status packed = packOthers(progress); !packed)
        return packed.error();
    report_.accuracy = file_.levelCount() * sizeof(format::PackedLevelEntry);
    return report_;
}

Status ReplayPacker::packCorners()
{
    const std::vector<double> unknown(mesh_.corners().size(), 0.0);
    coders_.sizes.code(coders_.positions, unknown.size());
    values_->encode(coders_.values, mesh_.corners(), unknown.data());
    for (const std::uint32_t corner : mesh_.corners())
        free_.remove(corner);
    pointsInChunk_ = sites_ = static_cast<std::uint32_t>(unknown.size());
    return {};
}

/// Steps until no error is larger than the limit.
Status ReplayPacker::packLevel(float limit, const Progress& progress)
{
    ReplayMesh::Round round;
    for (bool everywhere = true;; everywhere = false) {
        if (const Status added = mesh_.addWorst(limit, everywhere, round, progress); !added)
            return added;
        if (round.points.empty())
            return {};
        if (const Status packed = packSites(round.points, round.expected); !packed)
            return packed;
        if (const Status measured = mesh_.measure(progress); !measured)
            return measured;
    }
}

Status ReplayPacker::packSites(std::span<const std::uint32_t> points, std::span<const double> expected)
{
    const std::uint64_t mean = free_.count() / points.size();
    coders_.sizes.code(coders_.positions, points.size());
    std::uint64_t place = 0;
    for (std::size_t begin = 0; begin < points.size(); begin += codedAtOnce) {
        const auto part = points.subspan(begin, std::min(codedAtOnce, points.size() - begin));
        for (const std::uint32_t point : part) {
            coders_.gaps.code(coders_.positions, mean, free_.countBetween(place, point));
            free_.remove(point);
            place = point + 1ull;
        }
        values_->encode(coders_.values, part, expected.data() + begin);
        pointsInChunk_ += static_cast<std::uint32_t>(part.size());
        sites_ += static_cast<std::uint32_t>(part.size());
        if (coders_.positions.size() + coders_.values.size() >= chunkBytesWanted(writtenSites_))
            if (const Status closed = closeChunk(ReplayChunk::Sites); !closed)
                return closed;
    }
    return {};
}

/// Those that the chunks so far make.
void ReplayPacker::writeLevels()
{
    for (; levelsWritten_ < levels_.size(); ++levelsWritten_)
        file_.endLevel(levels_[levelsWritten_].first, 0, levels_[levelsWritten_].second);
}

Status ReplayPacker::closeChunk(ReplayChunk kind)
{
    const std::vector<std::byte> positions = coders_.positions.finish(), values = coders_.values.finish();
    const SiteChunkHead head{pointsInChunk_, static_cast<std::uint32_t>(positions.size())};
    std::vector<std::byte> bytes(sizeof head);
    std::memcpy(bytes.data(), &head, sizeof head);
    bytes.insert(bytes.end(), positions.begin(), positions.end());
    bytes.insert(bytes.end(), values.begin(), values.end());
    if (kind == ReplayChunk::Sites) {
        report_.positions += positions.size();
        report_.values += values.size();
        writtenSites_ += bytes.size();
    }
    coders_ = {};
    values_ = AnyValueCoder::make(mesh_);
    pointsInChunk_ = 0;
    if (const Status added = file_.addChunk(static_cast<std::uint32_t>(kind), bytes); !added)
        return added;
    if (kind == ReplayChunk::Sites)
        writeLevels();
    return {};
}

/// The samples of the points that are no sites, if the last mesh does not tell them.
Status ReplayPacker::packOthers(const Progress& progress)
{
    ReplayMesh::Expectations expected;
    bool told = true;
    const Status compared = forEachFree(free_, [&](std::span<const std::uint32_t> points) {
        const Status known = told ? mesh_.expect(points, expected, progress) : Status();
        told = told && known && agreesWith(mesh_, points, expected.values);
        return known;
    });
    if (!compared || told)
        return compared;
    const Status packed = forEachFree(free_, [&](std::span<const std::uint32_t> points) -> Status {
        if (const Status known = mesh_.expect(points, expected, progress); !known)
            return known;
        for (std::size_t begin = 0; begin < points.size(); begin += codedAtOnce) {
            const auto part = points.subspan(begin, std::min(codedAtOnce, points.size() - begin));
            values_->encode(coders_.values, part, expected.values.data() + begin);
            pointsInChunk_ += static_cast<std::uint32_t>(part.size());
            if (coders_.values.size() >= chunkBytesWanted(writtenSites_))
                if (const Status closed = closeChunk(ReplayChunk::Others); !closed)
                    return closed;
        }
        return {};
    });
    return packed && pointsInChunk_ > 0 ? closeChunk(ReplayChunk::Others) : packed;
}

Status checkReplayed(const Model& model)
{
    for (const bool intact : {model.check(model.points()), model.check(model.runningKeys()),
                              model.check(model.values()), model.check(model.samples())})
        if (!intact)
            return model.checkIntact();
    return {};
}

/// Fills the mesh with the samples that the model was built from, as far as it tells them; the mesh is that of the
/// start then. False if its sites are no sites.
Result<bool> fillSamples(const Model& model, ReplayMesh& mesh, const Progress& progress)
{
    const std::span<const std::uint32_t> points = model.points();
    FreePoints free(mesh.pointCount());
    for (const std::uint32_t point : points) {
        if (point >= free.size() || !free.has(point))
            return false;
        free.remove(point);
    }
    const auto firstSites = static_cast<std::ptrdiff_t>(mesh.corners().size());
    std::vector<std::uint32_t> corners(points.begin(), points.begin() + firstSites);
    std::ranges::sort(corners);
    if (!std::ranges::equal(corners, mesh.corners()))
        return false;
    if (!model.samples().empty()) {
        std::ranges::copy(model.samples(), mesh.samples().begin());
        return true;
    }
    const std::size_t size = sampleSize(mesh.type());
    for (std::size_t site = 0; site < points.size(); ++site)
        std::memcpy(mesh.samples().data() + points[site] * size, model.values().data() + site * size, size);
    if (const Status added = mesh.add(points.subspan(mesh.corners().size()), {}, progress); !added)
        return added.error();
    ReplayMesh::Expectations expected;
    const Status filled = forEachFree(free, [&](std::span<const std::uint32_t> others) {
        const Status known = mesh.expect(others, expected, progress);
        if (known)
            takeExpected(mesh, others, expected.values);
        return known;
    });
    if (!filled)
        return filled.error();
    mesh.restart();
    return true;
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
    const auto theirs = readLayout(model.fileBytes(), model.path()), ours = readLayout((*mapped)->bytes(), again);
    if (!theirs || !ours)
        return theirs ? ours.error() : theirs.error();
    return ours->header.checksum == theirs->header.checksum;
}

// Unpacking.

/// Reads the sites of a packed model in their steps, and adds them to the mesh.
class ReplayReader {
public:
    /// All chunks up to the level, or all there are.
    ReplayReader(const PackedFile& file, ReplayMesh& mesh, std::uint64_t bytes)
        : file_(file), mesh_(mesh), chunks_(file, bytes), free_(mesh.pointCount())
    {
    }

    /// Up to so many, where a step ends.
    Status readSites(std::uint32_t count, const Progress& progress, InsertionWatch* watch = nullptr);
    /// Then the samples of all other points.
    Status readOthers(const Progress& progress);
    /// In their order, without the corners.
    std::span<const std::uint32_t> sites() const noexcept { return sites_; }
    /// Where they were found, for who adds them again: so the same tetrahedra come in the same order.
    std::span<const std::uint32_t> slots() const noexcept { return slots_; }

private:
    Status readChunk(std::uint32_t count, const Progress& progress, InsertionWatch* watch);
    Status readPart(RangeDecoder& positions, RangeDecoder& values, std::uint32_t count, const Progress& progress);
    Status beginStep(std::uint32_t count, RangeDecoder& positions);
    std::uint32_t siteCount() const
    {
        return static_cast<std::uint32_t>(sites_.size()) +
               (begun_ ? static_cast<std::uint32_t>(mesh_.corners().size()) : 0);
    }
    Result<SiteChunkHead> headOf(std::span<const std::byte> bytes) const;
    Error damaged() const { return file_.damaged(Message::say("its sites make no sense")); }

    const PackedFile& file_;
    ReplayMesh& mesh_;
    PackedChunkReader chunks_;
    FreePoints free_;
    NumberModel sizes_;
    GapCoder gaps_;
    std::unique_ptr<AnyValueCoder> valueCoder_;
    std::vector<std::uint32_t> sites_;
    std::vector<std::uint32_t> slots_; ///< of each site
    ReplayMesh::Expectations expected_;
    bool begun_ = false;        ///< the corners are known
    std::size_t stepBegin_ = 0; ///< in sites_
    std::uint32_t leftInStep_ = 0;
    std::uint64_t mean_ = 0;
    std::uint64_t place_ = 0;
};

Result<SiteChunkHead> ReplayReader::headOf(std::span<const std::byte> bytes) const
{
    SiteChunkHead head;
    if (bytes.size() < sizeof head)
        return damaged();
    std::memcpy(&head, bytes.data(), sizeof head);
    if (head.positionBytes > bytes.size() - sizeof head || head.points == 0)
        return damaged();
    return head;
}

Status ReplayReader::readSites(std::uint32_t count, const Progress& progress, InsertionWatch* watch)
{
    while (!begun_ || siteCount() < count) {
        const Result<bool> more = chunks_.next(progress);
        if (!more)
            return more.error();
        if (!*more || chunks_.kind() != static_cast<std::uint32_t>(ReplayChunk::Sites))
            return damaged();
        if (const Status read = readChunk(count, progress, watch); !read)
            return read;
        progress.report(static_cast<double>(siteCount()) / static_cast<double>(count), unpackingSites);
    }
    return leftInStep_ == 0 && siteCount() == count ? Status() : damaged();
}

Status ReplayReader::readChunk(std::uint32_t count, const Progress& progress, InsertionWatch* watch)
{
    const std::span<const std::byte> bytes = chunks_.bytes();
    const Result<SiteChunkHead> head = headOf(bytes);
    if (!head)
        return head.error();
    RangeDecoder positions(bytes.subspan(sizeof *head, head->positionBytes));
    RangeDecoder values(bytes.subspan(sizeof *head + head->positionBytes));
    sizes_ = {};
    gaps_ = {};
    valueCoder_ = AnyValueCoder::make(mesh_);
    for (std::uint32_t left = head->points; left > 0;) {
        if (leftInStep_ == 0) {
            if (begun_ && siteCount() == count) // what follows belongs to the next level
                return {};
            if (const Status begins = beginStep(count, positions); !begins)
                return begins;
        }
        const bool corners = !begun_;
        const auto part = static_cast<std::uint32_t>(std::min<std::size_t>({left, leftInStep_, replayedAtOnce}));
        if (corners) {
            if (part != leftInStep_)
                return damaged();
            expected_.values.assign(part, 0.0);
            valueCoder_->decode(values, mesh_.corners(), expected_.values.data());
            for (const std::uint32_t corner : mesh_.corners())
                free_.remove(corner);
            begun_ = true;
        } else if (const Status read = readPart(positions, values, part, progress); !read) {
            return read;
        }
        if (positions.overrun() || values.overrun())
            return damaged();
        left -= part;
        leftInStep_ -= part;
        if (leftInStep_ > 0 || corners)
            continue;
        const auto step = std::span<const std::uint32_t>(sites_).subspan(stepBegin_);
        if (const Status added = mesh_.add(step, std::span(slots_).subspan(stepBegin_), progress, watch); !added)
            return added;
        stepBegin_ = sites_.size();
    }
    return {};
}

/// A level ends with a step: no step leads beyond the sites that are asked for.
Status ReplayReader::beginStep(std::uint32_t count, RangeDecoder& positions)
{
    const std::uint64_t sites = sizes_.code(positions, 0);
    if (sites == 0 || sites > free_.count() || positions.overrun() || (!begun_ && sites != mesh_.corners().size()))
        return damaged();
    if (begun_ && sites > count - siteCount())
        return damaged();
    leftInStep_ = static_cast<std::uint32_t>(sites);
    mean_ = free_.count() / sites;
    place_ = 0;
    return {};
}

Status ReplayReader::readPart(RangeDecoder& positions, RangeDecoder& values, std::uint32_t count,
                              const Progress& progress)
{
    const std::size_t begin = sites_.size();
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint64_t point = free_.next(place_, gaps_.code(positions, mean_, 0));
        if (point >= free_.size() || positions.overrun())
            return damaged();
        free_.remove(point);
        sites_.push_back(static_cast<std::uint32_t>(point));
        place_ = point + 1;
    }
    const auto points = std::span<const std::uint32_t>(sites_).subspan(begin);
    if (const Status known = mesh_.expect(points, expected_, progress); !known)
        return known;
    slots_.insert(slots_.end(), expected_.slots.begin(), expected_.slots.end());
    valueCoder_->decode(values, points, expected_.values.data());
    return {};
}

Status ReplayReader::readOthers(const Progress& progress)
{
    const Result<bool> any = chunks_.next(progress);
    if (!any)
        return any.error();
    if (!*any)
        return forEachFree(free_, [&](std::span<const std::uint32_t> points) {
            const Status known = mesh_.expect(points, expected_, progress);
            if (known)
                takeExpected(mesh_, points, expected_.values);
            return known;
        });
    std::optional<RangeDecoder> values;
    std::uint32_t left = 0;
    return forEachFree(free_, [&](std::span<const std::uint32_t> points) -> Status {
        if (const Status known = mesh_.expect(points, expected_, progress); !known)
            return known;
        for (std::size_t begin = 0; begin < points.size();) {
            if (left == 0) {
                if (values) {
                    const Result<bool> more = chunks_.next(progress);
                    if (!more)
                        return more.error();
                    if (!*more)
                        return damaged();
                }
                const Result<SiteChunkHead> head = headOf(chunks_.bytes());
                if (!head || chunks_.kind() != static_cast<std::uint32_t>(ReplayChunk::Others))
                    return damaged();
                values.emplace(chunks_.bytes().subspan(sizeof *head + head->positionBytes));
                valueCoder_ = AnyValueCoder::make(mesh_);
                left = head->points;
            }
            const std::size_t part = std::min<std::size_t>(left, points.size() - begin);
            valueCoder_->decode(*values, points.subspan(begin, part), expected_.values.data() + begin);
            if (values->overrun())
                return damaged();
            begin += part;
            left -= static_cast<std::uint32_t>(part);
        }
        return {};
    });
}

Result<std::unique_ptr<ReplayMesh>> replayMeshOf(const PackedFile& file, ReplayMesh::Kept kept,
                                                 const Progress& progress)
{
    const ModelDescription& about = file.description();
    const std::uint64_t points = about.lattice.pointCount();
    if (about.domain != DomainClass::RegularLattice || !isReplayableSize(about.lattice, file.facts().blockCells))
        return file.damaged(Message::say("a lattice of %1 points cannot be replayed", points));
    auto mesh = ReplayMesh::make(about.lattice, about.sampleType, file.facts().blockCells, kept, progress);
    if (mesh && (*mesh)->corners().size() > file.header().siteCount)
        return file.damaged(Message::say("its blocks make no sense"));
    return mesh;
}

/// The sections of a model that was built again which are not what they were.
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

// A prefix: a history of its own, in two passes: in the first one shows how long each tetrahedron lives.

class UnheardSink final : public HistorySink {
public:
    Status add(const HistoryStep&) override { return {}; }
    Status finish(float) override { return {}; }
};

/// The tetrahedra in the slots of a mesh by their numbers in the history.
class NumberedSlots {
public:
    explicit NumberedSlots(std::span<const std::uint32_t> start)
        : numbers_(start.begin(), start.end()), count_(static_cast<std::uint32_t>(start.size()))
    {
    }

    std::uint32_t operator[](std::uint32_t slot) const { return numbers_[slot]; }
    std::uint32_t take(std::uint32_t slot)
    {
        if (slot >= numbers_.size())
            numbers_.resize(slot + 1 + slot / 2);
        numbers_[slot] = count_;
        return count_++;
    }
    std::uint32_t count() const noexcept { return count_; }

private:
    std::vector<std::uint32_t> numbers_;
    std::uint32_t count_;
};

/// The level that each site of a prefix belongs to.
class LevelsOfSites {
public:
    explicit LevelsOfSites(std::span<const format::PackedLevelEntry> levels) : levels_(levels) {}

    /// Of sites that are asked for in rising order.
    std::uint16_t of(std::uint32_t site) noexcept
    {
        while (levels_[level_].sites <= site)
            ++level_;
        return level_;
    }

private:
    std::span<const format::PackedLevelEntry> levels_;
    std::uint16_t level_ = 0;
};

/// The first pass: in which level each tetrahedron is destroyed.
class LifeWatch final : public InsertionWatch {
public:
    static constexpr std::uint16_t never = 0xffff;

    LifeWatch(std::span<const std::uint32_t> start, std::span<const format::PackedLevelEntry> levels,
              std::uint32_t firstSites)
        : slots_(start), levels_(levels), firstSites_(firstSites), deaths_(start.size(), never)
    {
    }

    void inserted(const LocalDelaunay& mesh, std::span<const std::uint32_t> destroyed,
                  std::span<const std::uint32_t> created) override
    {
        const std::uint16_t level = levels_.of(firstSites_ + static_cast<std::uint32_t>(mesh.added().size()) - 1);
        for (const std::uint32_t slot : destroyed)
            deaths_[slots_[slot]] = level;
        for (const std::uint32_t slot : created)
            slots_.take(slot);
        deaths_.resize(slots_.count(), never);
    }

    const std::vector<std::uint16_t>& deaths() const noexcept { return deaths_; }

private:
    NumberedSlots slots_;
    LevelsOfSites levels_;
    std::uint32_t firstSites_;
    std::vector<std::uint16_t> deaths_;
};

/// The second one: hands the history over.
class HistoryWatch final : public InsertionWatch {
public:
    HistoryWatch(std::span<const std::uint32_t> start, std::span<const format::PackedLevelEntry> levels,
                 std::uint32_t firstSites, const std::vector<std::uint16_t>& deaths,
                 std::span<const std::uint32_t> sites, HistorySink& sink)
        : slots_(start), table_(levels), levels_(levels), firstSites_(firstSites), deaths_(deaths), sites_(sites),
          sink_(sink)
    {
    }

    /// How far a tetrahedron may be off: what the last mesh that has it is.
    float errorOf(std::uint32_t number) const
    {
        const std::uint16_t death = deaths_[number];
        return death == LifeWatch::never ? table_.back().error : table_[death > 0 ? death - 1 : 0].error;
    }

    void inserted(const LocalDelaunay& mesh, std::span<const std::uint32_t> destroyed,
                  std::span<const std::uint32_t> created) override
    {
        // A point on a border of blocks is inserted several times.
        const auto site = static_cast<std::uint32_t>(mesh.added().size()) - 1;
        if (site != site_)
            handOver();
        site_ = site;
        for (const std::uint32_t slot : destroyed)
            destroyed_.push_back(slots_[slot]);
        for (const std::uint32_t slot : created) {
            const auto& [creator, a, b, c] = mesh.numbers(slot);
            star_.push_back({{a, b, c}, errorOf(slots_.take(slot)), 0});
        }
    }

    /// The last one, when all are inserted.
    Status finish()
    {
        handOver();
        return status_;
    }
    const Status& status() const noexcept { return status_; }

private:
    void handOver()
    {
        if (status_ && !star_.empty()) {
            const std::uint16_t level = levels_.of(firstSites_ + site_);
            status_ = sink_.add({sites_[site_], table_[level - 1u].error, star_, destroyed_});
        }
        star_.clear();
        destroyed_.clear();
    }

    NumberedSlots slots_;
    std::span<const format::PackedLevelEntry> table_;
    LevelsOfSites levels_;
    std::uint32_t firstSites_;
    const std::vector<std::uint16_t>& deaths_;
    std::span<const std::uint32_t> sites_;
    HistorySink& sink_;
    std::uint32_t site_ = 0;
    std::vector<HistoryTetrahedron> star_;
    std::vector<std::uint32_t> destroyed_;
    Status status_;
};

} // namespace

bool mayBeReplayed(const Model& model)
{
    const ModelDescription& about = model.description();
    return about.domain == DomainClass::RegularLattice && about.delaunay && about.builder == "refinement" &&
           isReplayableSize(about.lattice, 0);
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
    if (!cells || !isReplayableSize(about.lattice, *cells) ||
        !std::ranges::is_sorted(model.runningKeys(), std::ranges::greater()))
        return cannot;
    if (!latticeMetric(BlockDivision(about.lattice.size, *cells).box(0).size, about.lattice.spacing))
        return cannot;
    auto mesh = ReplayMesh::make(about.lattice, about.sampleType, *cells, ReplayMesh::Kept::AsOne, progress);
    if (!mesh)
        return mesh.error();
    const Result<bool> filled = fillSamples(model, **mesh, progress);
    if (!filled)
        return filled.error();
    const auto recipe = replayRecipe(about, *cells);
    if (!*filled || !recipe)
        return cannot;
    const auto dataset = replayedDataset(about, (*mesh)->sharedSamples());
    if (!dataset)
        return cannot;
    const Result<bool> same = isReproducible(model, *dataset, *recipe, file.target(), progress.part(0, triedAt));
    if (!same)
        return same.error();
    if (!*same)
        return cannot;
    file.setBlockCells(*cells);
    const Result<PackReport> report =
        ReplayPacker(**mesh, file).pack(finestOf(**mesh, about, *recipe), progress.part(triedAt, 1));
    if (!report)
        return report.error();
    return std::optional(*report);
}

Result<UnpackReport> unpackReplayed(const PackedFile& file, const std::filesystem::path& output,
                                    const Progress& progress)
{
    constexpr double readAt = 0.4;
    auto mesh = replayMeshOf(file, ReplayMesh::Kept::InParts, progress);
    if (!mesh)
        return mesh.error();
    const ModelDescription& about = file.description();
    const auto recipe = replayRecipe(about, file.facts().blockCells);
    if (!recipe)
        return file.damaged(Message::say("its text does not tell how it is built"));
    {
        ReplayReader reader(file, **mesh, file.chunks().size);
        if (const Status read = reader.readSites(file.levels().back().sites, progress.part(0, readAt)); !read)
            return read.error();
        if (const Status read = reader.readOthers(progress); !read)
            return read.error();
    }
    const auto dataset = replayedDataset(about, (*mesh)->sharedSamples());
    if (!dataset)
        return file.damaged(Message::say("its samples are not those that it was packed with"));
    mesh->reset();
    if (const Status built = buildAgain(*dataset, about, *recipe, output, progress.part(readAt, 1)); !built)
        return built.error();
    return compareSections(file, output);
}

Status unpackPrefixOfReplayed(const PackedFile& file, std::size_t level, const std::filesystem::path& output,
                              const Progress& progress)
{
    constexpr double readAt = 0.5;
    const auto mesh = replayMeshOf(file, ReplayMesh::Kept::AsOne, progress);
    if (!mesh)
        return mesh.error();
    ReplayMesh& replayed = **mesh;
    const auto levels = file.levels().first(level + 1);
    const auto firstSites = static_cast<std::uint32_t>(replayed.corners().size());
    if (levels.front().sites != firstSites)
        return file.damaged(Message::say("its levels make no sense"));
    const std::vector<std::uint64_t> corners(replayed.corners().begin(), replayed.corners().end());
    std::vector<StartTetrahedron> start;
    for (const std::array<std::uint32_t, 4>& sites : replayed.start())
        start.push_back({sites, 0, 0});
    UnheardSink none;
    const auto numbers = addStart(corners, start, none);
    if (!numbers)
        return numbers.error();
    ReplayReader reader(file, replayed, levels.back().chunkBytes);
    LifeWatch lives(*numbers, levels, firstSites);
    if (const Status read = reader.readSites(levels.back().sites, progress.part(0, readAt), &lives); !read)
        return read;
    replayed.restart();

    Dataset dataset;
    dataset.lattice = file.description().lattice;
    dataset.values = ScalarField(replayed.type(), replayed.pointCount(), replayed.sharedSamples());
    const auto writer = ModelWriter::create(output, dataset, file.description(), {}, KnownSamples::OfSites);
    if (!writer)
        return writer.error();
    HistoryTraits traits;
    traits.blockCells = replayed.division().blockCells();
    if (const Status begun = (*writer)->begin(traits); !begun)
        return begun;
    HistoryWatch history(*numbers, levels, firstSites, lives.deaths(), reader.sites(), **writer);
    for (std::size_t i = 0; i < start.size(); ++i)
        start[i].error = history.errorOf((*numbers)[i]);
    if (const auto added = addStart(corners, start, **writer); !added)
        return added.error();
    const std::span<const std::uint32_t> sites = reader.sites();
    for (std::size_t first = 0; first < sites.size(); first += replayedAtOnce) {
        const auto part = sites.subspan(first, std::min(replayedAtOnce, sites.size() - first));
        if (const Status added = replayed.add(part, reader.slots().subspan(first, part.size()), progress, &history);
            !added)
            return added;
        if (!history.status())
            return history.status();
        progress.part(readAt, 1).report(static_cast<double>(first) / static_cast<double>(sites.size()),
                                        Message::marked("Writing the model"));
    }
    if (const Status handed = history.finish(); !handed)
        return handed;
    return (*writer)->finish(levels.back().error);
}

} // namespace tetra
