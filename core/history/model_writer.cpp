// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/model_writer.h"

#include "core/base/guarded.h"
#include "core/base/rounding.h"
#include "core/base/scratch_file.h"
#include "core/data/dataset_checks.h"
#include "core/history/batch_builder.h"
#include "core/history/derived_sections.h"
#include "core/history/file_layout.h"
#include "core/history/lattice_frame.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <string>
#include <utility>

namespace tetra {

using format::SectionId;

// What a model file holds.

namespace {

constexpr std::uint64_t siteBytes = 4 + 4 + 8 + 4 + 1; // all but the value
constexpr std::uint64_t tetrahedronBytes = 12 + 4 + 2;

/// The bytes of the arrays that every model of a regular lattice has.
std::uint64_t arrayBytes(const FixedCounts& counts, SampleType type) noexcept
{
    return counts.sites * (siteBytes + sampleSize(type)) + counts.tetrahedra * tetrahedronBytes;
}

/// Whether a model keeps all samples of its dataset of `points` points, with their positions of `positionBytes` each
/// (0: a regular lattice): if they take at most an eighth of the other arrays. A model of a few sites of a huge dataset
/// does not, nor one of scattered points (FORMAT.md).
bool keepsSamplesOf(DomainClass domain, SampleType type, std::size_t positionBytes, std::uint64_t points,
                    const FixedCounts& counts) noexcept
{
    constexpr std::uint64_t shareOfArrays = 8;
    return isOnLattice(domain) &&
           points * (sampleSize(type) + positionBytes) <= arrayBytes(counts, type) / shareOfArrays;
}

/// Calls write(piece) for all elements in order, a piece at a time: they may lie in a file larger than memory.
template <class Element, class Write> Status inPieces(std::span<const Element> elements, const Write& write)
{
    constexpr std::size_t atOnce = (1 << 20) / sizeof(Element);
    for (std::size_t first = 0; first < elements.size(); first += atOnce)
        if (const Status written = write(elements.subspan(first, std::min(atOnce, elements.size() - first))); !written)
            return written;
    return {};
}

/// The bytes of elementOf(each of `keys`), in `scratch`.
template <class Element, class Key, class Function>
std::span<const std::byte> bytesOfEach(std::span<const Key> keys, Buffer<std::byte>& scratch, const Function& elementOf)
{
    scratch.resize(keys.size() * sizeof(Element));
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const Element element = elementOf(keys[i]);
        std::memcpy(scratch.data() + i * sizeof(Element), static_cast<const void*>(&element), sizeof(Element));
    }
    return scratch;
}

} // namespace

ModelFileWriter::ModelFileWriter(FileWriter file, const Dataset& dataset, ModelDescription description,
                                 KnownSamples known)
    : target_(file.target()), sections_(std::move(file)), dataset_(dataset), description_(std::move(description)),
      positionsFitFloats_(hasPositions() && fitFloats(*dataset.positions)), known_(known)
{
}

Result<std::unique_ptr<ModelFileWriter>> ModelFileWriter::create(const std::filesystem::path& path,
                                                                 const Dataset& dataset, ModelDescription description,
                                                                 const std::filesystem::path& workFolder,
                                                                 KnownSamples known)
{
    if (known == KnownSamples::All)
        describeSource(description, dataset);
    Result<FileWriter> file = FileWriter::create(path, 1 << 20, workFolder);
    if (!file)
        return file.error();
    std::unique_ptr<ModelFileWriter> writer(
        new ModelFileWriter(std::move(*file), dataset, std::move(description), known));
    if (const Status begun = writer->begin(); !begun)
        return begun.error();
    return writer;
}

Result<std::unique_ptr<ModelFileWriter>> ModelFileWriter::create(const std::filesystem::path& path,
                                                                 const Dataset& dataset, ModelDescription description,
                                                                 const FixedCounts& counts,
                                                                 const std::filesystem::path& workFolder)
{
    const auto createAnnounced = [&]() -> Result<std::unique_ptr<ModelFileWriter>> {
        auto writer = create(path, dataset, std::move(description), workFolder);
        if (!writer)
            return writer.error();
        if (const Status announced = (*writer)->announce(counts); !announced)
            return announced.error();
        return writer;
    };
    return guarded(Message::marked("Not enough memory to write '%1'. Close other programs."), createAnnounced,
                   path.native());
}

Status ModelFileWriter::begin()
{
    const Result<std::string> text = textOf(description_, target_);
    if (!text)
        return text.error();
    // The index takes its place while nobody knows how long it will be.
    std::vector sections{
        PlannedSection{SectionId::LevelIndex, sizeof(format::LevelEntry), format::mostLevels, 0, true}};
    const std::vector<FrameSection> frame = frameSections(description_);
    for (const FrameSection& section : frame)
        sections.push_back({section.id, sizeof(double), section.numbers.size()});
    sections.push_back({SectionId::Text, 1, text->size()});
    if (const Status planned = sections_.plan(sections); !planned)
        return planned;
    for (const FrameSection& section : frame)
        if (const Status written = sections_.add(section.id, std::as_bytes(std::span(section.numbers))); !written)
            return written;
    return sections_.add(SectionId::Text, std::as_bytes(std::span(*text)));
}

void ModelFileWriter::setTraits(const HistoryTraits& traits)
{
    description_.warpingWeight = traits.warpingWeight;
    description_.delaunay = traits.delaunay;
    blockCells_ = traits.blockCells;
}

Status ModelFileWriter::addOtherSites(std::span<const std::array<std::uint32_t, 3>> otherSites)
{
    if (!std::exchange(otherSitesBegun_, true))
        if (const Status begun = sections_.grow(SectionId::OtherSites, sizeof otherSites[0]); !begun)
            return begun;
    return sections_.add(SectionId::OtherSites, std::as_bytes(otherSites));
}

bool ModelFileWriter::keepsSamples() const noexcept
{
    const std::size_t positionBytes = !hasPositions()       ? 0
                                      : positionsFitFloats_ ? sizeof(Eigen::Vector3f)
                                                            : sizeof(Eigen::Vector3d);
    return known_ == KnownSamples::All &&
           keepsSamplesOf(dataset_.domain, dataset_.values.type(), positionBytes, dataset_.pointCount(), counts_);
}

Status ModelFileWriter::announce(const FixedCounts& counts)
{
    counts_ = counts;
    const std::uint64_t sites = counts.sites, tetrahedra = counts.tetrahedra;
    const std::size_t sampleBytes = sampleSize(dataset_.values.type());
    const std::size_t positionBytes = positionsFitFloats_ ? sizeof(Eigen::Vector3f) : sizeof(Eigen::Vector3d);
    std::vector<PlannedSection> sections;
    if (!std::exchange(otherSitesBegun_, true))
        sections.push_back({SectionId::OtherSites, 12, tetrahedra});
    sections.insert(sections.end(), {{SectionId::SitePoints, 4, sites},
                                     {SectionId::SiteValues, sampleBytes, sites},
                                     {SectionId::SiteRunningKeys, 4, sites},
                                     {SectionId::StarOffsets, 8, sites + 1},
                                     {SectionId::MeshSizes, 4, sites},
                                     {SectionId::SiteGroups, 1, sites},
                                     {SectionId::Destroyers, 4, tetrahedra},
                                     {SectionId::OwnErrors, 2, tetrahedra}});
    // A section that readers must know: one that does not would insert points where it cannot be done.
    if (!description_.delaunay)
        sections.push_back({SectionId::HistoryKind, sizeof(format::HistoryKind), 1});
    if (hasPositions())
        sections.push_back({SectionId::SitePositions, positionBytes, sites});
    if (canWarp(description_.domain))
        sections.push_back({SectionId::OwnWarpings, 2, tetrahedra});
    if (keepsSamples() && hasPositions())
        sections.push_back({SectionId::SamplePositions, positionBytes, dataset_.pointCount(), 0});
    if (keepsSamples())
        sections.push_back({SectionId::Samples, sampleBytes, dataset_.pointCount(), 0});
    return sections_.plan(sections);
}

Status ModelFileWriter::addPoints(std::span<const std::uint32_t> points)
{
    if (points.size() > counts_.sites - added_.sites)
        return notAsAnnounced();
    added_.sites += static_cast<std::uint32_t>(points.size());
    if (const Status written = add(SectionId::SitePoints, points); !written)
        return written;
    const Status written = visitSampleType(dataset_.values.type(), [&]<class T>() {
        const std::span<const T> samples = dataset_.values.as<T>();
        return sections_.add(SectionId::SiteValues, bytesOfEach<T>(points, elements_, [samples](std::uint32_t point) {
                                 return samples[point];
                             }));
    });
    if (!written || !hasPositions())
        return written;
    const std::span<const Eigen::Vector3d> positions = *dataset_.positions;
    const auto place = [&]<class Position>(Position) {
        return bytesOfEach<Position>(points, elements_, [positions](std::uint32_t point) -> Position {
            return positions[point].cast<typename Position::Scalar>();
        });
    };
    return sections_.add(SectionId::SitePositions,
                         positionsFitFloats_ ? place(Eigen::Vector3f()) : place(Eigen::Vector3d()));
}

Status ModelFileWriter::addStarSizes(std::span<const std::uint32_t> starSizes)
{
    offsets_.clear();
    for (const std::uint32_t size : starSizes) {
        if (size > counts_.tetrahedra - added_.tetrahedra)
            return notAsAnnounced();
        offsets_.push_back(added_.tetrahedra);
        added_.tetrahedra += size;
    }
    return sections_.add(SectionId::StarOffsets, std::as_bytes(std::span(offsets_)));
}

/// In the numbers that the sites' positions are written in.
Status ModelFileWriter::addSamplePositions()
{
    return inPieces(std::span<const Eigen::Vector3d>(*dataset_.positions), [this](auto piece) {
        if (!positionsFitFloats_)
            return add(SectionId::SamplePositions, piece);
        return sections_.add(SectionId::SamplePositions,
                             bytesOfEach<Eigen::Vector3f>(piece, elements_, [](const Eigen::Vector3d& position) {
                                 return Eigen::Vector3f(position.cast<float>());
                             }));
    });
}

Status ModelFileWriter::finish(float finalKey)
{
    if (added_.sites != counts_.sites || added_.tetrahedra != counts_.tetrahedra || !(finalKey >= 0) ||
        !std::isfinite(finalKey))
        return notAsAnnounced();
    const std::uint64_t end = added_.tetrahedra;
    if (const Status written = add(SectionId::StarOffsets, std::span(&end, 1)); !written)
        return written;
    constexpr auto kind = format::HistoryKind::ClosedSetsOnly;
    if (!description_.delaunay)
        if (const Status written = add(SectionId::HistoryKind, std::span(&kind, 1)); !written)
            return written;
    if (keepsSamples()) {
        const Status placed = hasPositions() ? addSamplePositions() : Status();
        const Status written =
            !placed ? placed
                    : inPieces(dataset_.values.bytes(), [this](auto piece) { return add(SectionId::Samples, piece); });
        if (!written)
            return written;
    }
    if (const Status derived =
            writeDerivedSections(sections_, {&dataset_, nullptr, description_, counts_, finalKey, blockCells_});
        !derived)
        return derived;
    format::Header header = headerOf(description_);
    header.siteCount = counts_.sites;
    header.tetrahedronCount = counts_.tetrahedra;
    header.finalKey = finalKey;
    if (const Status intact = dataset_.checkIntact(); !intact)
        return intact;
    return sections_.finish(header);
}

std::uint64_t ModelFileWriter::expectedBytes(const FixedCounts& counts, SampleType type, DomainClass domain,
                                             std::uint64_t points) noexcept
{
    constexpr std::uint64_t frontAndText = 4096 + format::mostLevels * sizeof(format::LevelEntry);
    const bool warps = canWarp(domain);
    const std::size_t positionBytes = warps ? sizeof(Eigen::Vector3d) : 0; // at most, as the following
    const std::uint64_t batches = counts.sites * (sizeof(std::uint32_t) + (warps ? 2 * sizeof(float) : 0));
    const std::uint64_t ownWarpings = warps ? counts.tetrahedra * sizeof(std::uint16_t) : 0;
    const bool samples = keepsSamplesOf(domain, type, positionBytes, points, counts);
    const std::uint64_t content = arrayBytes(counts, type) + counts.sites * positionBytes + ownWarpings + batches +
                                  (samples ? points * (sampleSize(type) + positionBytes) : 0);
    return content + format::chunkCount(content) * sizeof(std::uint64_t) + frontAndText;
}

Error ModelFileWriter::notAsAnnounced() const
{
    return {ErrorKind::BadInput, Message::say("The builder '%1' made a history that differs from the one it announced. "
                                              "Nothing was written; report this to its author.",
                                              description_.builder)};
}

// A history that is written while it is made.

namespace {

class HistoryFileWriter final : public ModelWriter, private BatchSink {
public:
    HistoryFileWriter(std::unique_ptr<ModelFileWriter> file, std::uint64_t pointCount,
                      std::filesystem::path spoolFolder)
        : file_(std::move(file)), spool_(std::move(spoolFolder)), builder_(pointCount, *this)
    {
    }

    Status begin(const HistoryTraits& traits) override;
    Status add(const HistoryStep& step) override;
    Status finish(float finalKey) override;
    Status finishEarly() override;
    std::uint32_t siteCount() const noexcept override { return builder_.siteCount(); }
    std::uint64_t tetrahedronCount() const noexcept override { return builder_.storedCount(); }

private:
    Status add(const Batch& batch) override;
    Status writeArrays(float finalKey);
    void storeMeshSizes(const Batch& batch);
    const ModelDescription& description() const { return file_->description(); }
    Error inconsistent(const Message& what) const;
    template <class Work> Status guardedWriting(const Work& work) const
    {
        return guarded(
            Message::marked(
                "Not enough memory to write '%1' after %2 sites. Choose a larger error, or close other programs."),
            work, file_->target().native(), siteCount());
    }

    std::unique_ptr<ModelFileWriter> file_;
    SpoolFile spool_; ///< of the arrays that are only read at the end
    SpooledArray<std::uint32_t> points_{spool_};
    SpooledArray<float> runningKeys_{spool_};
    SpooledArray<std::uint32_t> starSizes_{spool_};
    SpooledArray<std::uint32_t> meshSizes_{spool_};
    SpooledArray<std::uint8_t> groupGoesOn_{spool_};
    ChunkedArray<std::uint32_t> destroyers_;
    SpooledArray<std::uint16_t> ownErrors_{spool_};
    SpooledArray<std::uint16_t> ownWarpings_{spool_};

    BatchBuilder builder_;
    std::vector<std::array<std::uint32_t, 3>> otherSites_; ///< of a batch, on their way to the file
    std::vector<std::int64_t> growth_;                     ///< of the mesh by each of a batch's sites
    std::int64_t meshSize_ = 0;
};

namespace {

/// Whether blocks of so many cells lie in the lattice.
bool fit(const std::array<std::uint32_t, 3>& cells, const Lattice& lattice)
{
    return std::ranges::equal(cells, lattice.size, [](auto edge, auto points) { return 0 < edge && edge < points; });
}

} // namespace

Status HistoryFileWriter::begin(const HistoryTraits& traits)
{
    if (siteCount() > 0 || !(traits.warpingWeight >= 0) || !std::isfinite(traits.warpingWeight) ||
        canWarp(description().domain) != (traits.warpingWeight > 0))
        return inconsistent(Message::say("its warping weight is %1", formatNumber(traits.warpingWeight)));
    if (description().domain == DomainClass::Irregular && traits.delaunay)
        return inconsistent(Message::say("meshes of irregular data are not Delaunay meshes"));
    if (const auto& cells = traits.blockCells;
        cells != std::array<std::uint32_t, 3>{} &&
        (!isOnLattice(description().domain) || !fit(cells, description().lattice)))
        return inconsistent(Message::say("its blocks have %1 x %2 x %3 cells", cells[0], cells[1], cells[2]));
    file_->setTraits(traits);
    return {};
}

Status HistoryFileWriter::add(const HistoryStep& step)
{
    if (canWarp(description().domain) && !(description().warpingWeight > 0))
        return inconsistent(Message::say("%1 data need a warping weight", domainClassText(description().domain)));
    return guardedWriting([&] {
        const Status added = builder_.add(step);
        return added || added.error().kind != ErrorKind::BadInput ? added : inconsistent(added.error().message);
    });
}

Status HistoryFileWriter::add(const Batch& batch)
{
    for (std::size_t place = 0; place < batch.points.size(); ++place) {
        points_.push_back(static_cast<std::uint32_t>(batch.points[place]));
        runningKeys_.push_back(batch.runningKey);
        groupGoesOn_.push_back(batch.groupGoesOn[place]);
        starSizes_.push_back(batch.starEnds[place] - (place == 0 ? 0 : batch.starEnds[place - 1]));
    }
    storeMeshSizes(batch);
    for (const Batch::Destruction& destruction : batch.destructions)
        destroyers_[destruction.tetrahedron] = destruction.destroyer;
    const double extent = description().range.extent();
    const double diagonal = description().bounds.diagonal().norm();
    otherSites_.clear();
    for (const Batch::Tetrahedron& tetrahedron : batch.tetrahedra) {
        otherSites_.push_back({tetrahedron.sites[1], tetrahedron.sites[2], tetrahedron.sites[3]});
        destroyers_.push_back(Model::never);
        ownErrors_.push_back(halfBound(tetrahedron.error, extent));
        if (description().warpingWeight > 0)
            ownWarpings_.push_back(halfBound(tetrahedron.warping, diagonal));
    }
    if (!spool_.status())
        return spool_.status();
    return file_->addOtherSites(otherSites_);
}

/// The mesh has a size where a group ends; its other sites get the same one.
void HistoryFileWriter::storeMeshSizes(const Batch& batch)
{
    growth_.assign(batch.points.size(), 0);
    for (const Batch::Destruction& destruction : batch.destructions)
        --growth_[destruction.destroyer - batch.firstSite];
    std::size_t first = 0;
    for (std::size_t place = 0; place < batch.points.size(); ++place) {
        meshSize_ += growth_[place] + batch.starEnds[place] - (place == 0 ? 0 : batch.starEnds[place - 1]);
        if (batch.groupGoesOn[place] != 0)
            continue;
        for (; first <= place; ++first)
            meshSizes_.push_back(static_cast<std::uint32_t>(meshSize_));
    }
}

Status HistoryFileWriter::finish(float finalKey)
{
    if (siteCount() < fewestSites(description().domain) || builder_.aliveCount() == 0)
        return inconsistent(Message::say("a model needs at least the sites of its first mesh"));
    if (!(finalKey >= 0) || !std::isfinite(finalKey))
        return inconsistent(Message::say("the final error is not a number of at least 0"));
    return guardedWriting([&] {
        if (const Status closed = builder_.finish(); !closed)
            return closed;
        return writeArrays(finalKey);
    });
}

Status HistoryFileWriter::finishEarly()
{
    // The open batch began with a mesh of the running key.
    if (std::isinf(builder_.runningKey()))
        return Error{
            ErrorKind::Cancelled,
            Message::say("The build was stopped before there was a mesh of known error, so there is nothing to keep.")};
    builder_.abandonBatch();
    return guardedWriting([&] { return writeArrays(builder_.runningKey()); });
}

/// All but what went to the file on the way; may throw std::bad_alloc.
Status HistoryFileWriter::writeArrays(float finalKey)
{
    if (const Status announced = file_->announce({siteCount(), tetrahedronCount()}); !announced)
        return announced;
    const auto asItIs = [this](SectionId id) { return [this, id](auto chunk) { return file_->add(id, chunk); }; };
    for (const Status& written :
         {points_.forEachChunk([this](auto chunk) { return file_->addPoints(chunk); }),
          starSizes_.forEachChunk([this](auto chunk) { return file_->addStarSizes(chunk); }),
          runningKeys_.forEachChunk(asItIs(SectionId::SiteRunningKeys)),
          meshSizes_.forEachChunk(asItIs(SectionId::MeshSizes)),
          groupGoesOn_.forEachChunk(asItIs(SectionId::SiteGroups)),
          destroyers_.forEachChunk(asItIs(SectionId::Destroyers)),
          ownErrors_.forEachChunk(asItIs(SectionId::OwnErrors)),
          ownWarpings_.size() == 0 ? Status() : ownWarpings_.forEachChunk(asItIs(SectionId::OwnWarpings))})
        if (!written)
            return written;
    destroyers_ = {}; // what follows needs memory, too
    return file_->finish(finalKey);
}

Error HistoryFileWriter::inconsistent(const Message& what) const
{
    return {ErrorKind::BadInput, Message::say("The builder '%1' made a history that is wrong at site %2: %3. Nothing "
                                              "was written; report this to its author.",
                                              description().builder, siteCount(), what)};
}

} // namespace

Result<std::unique_ptr<ModelWriter>> ModelWriter::create(const std::filesystem::path& path, const Dataset& dataset,
                                                         ModelDescription description,
                                                         const std::filesystem::path& workFolder, KnownSamples known)
{
    if (dataset.pointCount() > (1ull << 32))
        return Error{ErrorKind::OutOfResource,
                     Message::say("A model holds at most 4294967296 points, and '%1' has %2. Take a part of it.",
                                  dataset.source.name, dataset.pointCount())};
    auto file = ModelFileWriter::create(path, dataset, std::move(description), workFolder, known);
    if (!file)
        return file.error();
    auto spoolFolder = workFolder.empty() ? (*file)->target().parent_path() : workFolder;
    return std::unique_ptr<ModelWriter>(std::make_unique<HistoryFileWriter>(
        *std::move(file), dataset.pointCount(), spoolFolder.empty() ? "." : std::move(spoolFolder)));
}

} // namespace tetra
