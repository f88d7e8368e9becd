// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/model_writer.h"

#include "core/base/file_writer.h"
#include "core/base/rounding.h"
#include "core/base/text.h"
#include "core/data/dataset_checks.h"
#include "core/history/batch_builder.h"
#include "core/history/file_layout.h"
#include "core/history/section_checks.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <new>
#include <span>
#include <utility>
#include <vector>

namespace tetra {

using format::Header;
using format::Section;

namespace {

/// Writes the sections of a `.tan` file one after the other, then the checksums of their chunks, then the header and
/// the table in the place that was left free for them. May throw std::bad_alloc.
class SectionWriter {
public:
    /// `mostSections`: the table gets room for so many, and for the chunks' checksums.
    SectionWriter(FileWriter file, std::uint32_t mostSections) : file_(std::move(file)), mostSections_(mostSections + 1)
    {
    }

    /// Leaves the place for header and table; comes first.
    Status reserveFront();
    /// `flags`: format::required, or 0 for a section that a reader may do without.
    Status begin(format::SectionId id, std::size_t elementBytes, std::uint32_t flags = format::required);
    Status add(std::span<const std::byte> bytes);
    void end();
    /// Completes `header` with sizes and checksums, writes it with the table and commits the file.
    Status finish(format::Header header);

private:
    Status padTo(std::uint64_t offset);
    Status writeChunkSums();

    FileWriter file_;
    std::uint32_t mostSections_;
    std::vector<format::Section> sections_;
    SectionSums sums_; ///< of the section that is being written
    ChunkSums chunkSums_;
};

Status SectionWriter::reserveFront()
{
    return padTo(sizeof(Header) + mostSections_ * sizeof(Section));
}

Status SectionWriter::begin(format::SectionId id, std::size_t elementBytes, std::uint32_t flags)
{
    if (const Status padded = padTo(format::aligned(file_.size())); !padded)
        return padded;
    Section section;
    section.id = static_cast<std::uint32_t>(id);
    section.flags = flags;
    section.elementBytes = static_cast<std::uint32_t>(elementBytes);
    section.offset = file_.size();
    sections_.push_back(section);
    sums_ = {};
    return {};
}

Status SectionWriter::add(std::span<const std::byte> bytes)
{
    sums_.add(bytes);
    return file_.write(bytes);
}

void SectionWriter::end()
{
    sections_.back().bytes = file_.size() - sections_.back().offset;
    sections_.back().checksum = sums_.ofWhole();
    chunkSums_.append(sums_);
}

Status SectionWriter::writeChunkSums()
{
    if (const Status begun = begin(format::SectionId::ChunkSums, sizeof(std::uint64_t), 0); !begun)
        return begun;
    const Status written = add(chunkSums_.bytes());
    sections_.back().bytes = chunkSums_.bytes().size();
    sections_.back().checksum = sums_.ofWhole();
    return written;
}

Status SectionWriter::finish(Header header)
{
    if (const Status written = writeChunkSums(); !written)
        return written;
    assert(sections_.size() <= mostSections_);
    const std::span<const std::byte> table = std::as_bytes(std::span(sections_));
    header.sectionCount = static_cast<std::uint32_t>(sections_.size());
    header.fileBytes = file_.size();
    header.checksum = headerChecksum(header, table);
    if (const Status written = file_.overwrite(0, std::as_bytes(std::span(&header, 1))); !written)
        return written;
    if (const Status written = file_.overwrite(sizeof(Header), table); !written)
        return written;
    return file_.commit();
}

Status SectionWriter::padTo(std::uint64_t offset)
{
    static constexpr std::array<std::byte, 4096> zeros{};
    while (file_.size() < offset)
        if (const Status written =
                file_.write(std::span(zeros).first(std::min<std::uint64_t>(zeros.size(), offset - file_.size())));
            !written)
            return written;
    return {};
}

constexpr std::uint64_t siteBytes = 4 + 4 + 8 + 4 + 1; // all but the value
constexpr std::uint64_t tetrahedronBytes = 12 + 4 + 2;
constexpr std::uint64_t shareOfArrays = 8;
constexpr std::size_t pieceBytes = 1 << 20;

} // namespace

std::uint64_t arrayBytes(const ModelCounts& counts, SampleType type) noexcept
{
    return counts.sites * (siteBytes + sampleSize(type)) + counts.tetrahedra * tetrahedronBytes;
}

bool keepsSamples(DomainClass domain, SampleType type, std::size_t positionBytes, std::uint64_t points,
                  const ModelCounts& counts) noexcept
{
    return isOnLattice(domain) &&
           points * (sampleSize(type) + positionBytes) <= arrayBytes(counts, type) / shareOfArrays;
}

Status writeSamples(const ScalarField& samples, const std::function<Status(std::span<const std::byte>)>& write)
{
    const std::span<const std::byte> bytes = samples.bytes();
    for (std::size_t at = 0; at < bytes.size(); at += pieceBytes)
        if (const Status written = write(bytes.subspan(at, std::min(pieceBytes, bytes.size() - at))); !written)
            return written;
    return {};
}

namespace {

/// Writes elementOf(point) for every site's point, a chunk at a time.
template <class Element, class Function> Status writeForEach(SectionWriter& sections, format::SectionId id,
                                                             const SpooledArray<std::uint32_t>& points,
                                                             Function&& elementOf)
{
    if (const Status begun = sections.begin(id, sizeof(Element)); !begun)
        return begun;
    std::vector<Element> elements;
    const Status written = points.forEachChunk([&](std::span<const std::uint32_t> chunk) {
        elements.clear();
        for (const std::uint32_t point : chunk)
            elements.push_back(elementOf(point));
        return sections.add(std::as_bytes(std::span(elements)));
    });
    sections.end();
    return written;
}

/// Writes the section of the sites' values; `points` are the sites' points in `dataset`.
Status writeSiteValues(SectionWriter& sections, const Dataset& dataset, const SpooledArray<std::uint32_t>& points)
{
    return visitSampleType(dataset.values.type(), [&]<class T>() {
        const std::span<const T> samples = dataset.values.as<T>();
        return writeForEach<T>(sections, format::SectionId::SiteValues, points,
                               [samples](std::uint32_t point) { return samples[point]; });
    });
}

} // namespace

std::size_t positionBytes(const Dataset& dataset)
{
    if (dataset.domain == DomainClass::RegularLattice)
        return 0;
    return fitFloats(*dataset.positions) ? sizeof(Eigen::Vector3f) : sizeof(Eigen::Vector3d);
}

namespace {

/// Writes the section of the sites' positions for a dataset that has positions: in floats if they hold each of its
/// coordinates exactly, else in doubles.
Status writeSitePositions(SectionWriter& sections, const Dataset& dataset, const SpooledArray<std::uint32_t>& points)
{
    const std::vector<Eigen::Vector3d>& positions = *dataset.positions;
    constexpr auto id = format::SectionId::SitePositions;
    if (fitFloats(positions))
        return writeForEach<Eigen::Vector3f>(sections, id, points, [&](std::uint32_t point) -> Eigen::Vector3f {
            return positions[point].cast<float>();
        });
    return writeForEach<Eigen::Vector3d>(sections, id, points, [&](std::uint32_t point) { return positions[point]; });
}

/// Writes the section of all points' positions, in the same numbers.
Status writeSamplePositions(SectionWriter& sections, const Dataset& dataset)
{
    constexpr std::size_t atOnce = 1 << 15;
    const std::span<const Eigen::Vector3d> positions = *dataset.positions;
    const bool floats = positionBytes(dataset) == sizeof(Eigen::Vector3f);
    if (const Status begun = sections.begin(format::SectionId::SamplePositions, positionBytes(dataset), 0); !begun)
        return begun;
    std::vector<Eigen::Vector3f> rounded;
    for (std::size_t first = 0; first < positions.size(); first += atOnce) {
        const auto piece = positions.subspan(first, std::min(atOnce, positions.size() - first));
        rounded.clear();
        if (floats)
            for (const Eigen::Vector3d& position : piece)
                rounded.push_back(position.cast<float>());
        const Status written =
            sections.add(floats ? std::as_bytes(std::span<const Eigen::Vector3f>(rounded)) : std::as_bytes(piece));
        if (!written)
            return written;
    }
    sections.end();
    return {};
}

using format::SectionId;

/// Sections of every model; domains with positions of their own and with warping have more, as have histories that are
/// not Delaunay.
constexpr std::uint32_t commonSections = 10;

/// Room in the table: also for the samples, which a model of few sites leaves out.
std::uint32_t sectionLimit(DomainClass domain)
{
    return commonSections + 2 + (canWarp(domain) ? 3 : 0);
}

/// A first mesh needs as many sites: the corners of a lattice, or those of one tetrahedron.
std::uint32_t fewestSites(DomainClass domain)
{
    return isOnLattice(domain) ? 8 : 4;
}

constexpr std::size_t fileBufferBytes = 1 << 20;

class HistoryFileWriter final : public ModelWriter, private BatchSink {
public:
    HistoryFileWriter(FileWriter file, const Dataset& dataset, ModelDescription description,
                      std::filesystem::path spoolFolder)
        : target_(file.target()), sections_(std::move(file), sectionLimit(dataset.domain)), dataset_(dataset),
          description_(std::move(description)), spool_(std::move(spoolFolder)), builder_(dataset.pointCount(), *this)
    {
    }

    Status writeFront();
    Status begin(const HistoryTraits& traits) override;
    Status add(const HistoryStep& step) override;
    Status finish(float finalError) override;
    Status finishEarly() override;
    std::uint32_t siteCount() const noexcept override { return builder_.siteCount(); }
    std::uint64_t tetrahedronCount() const noexcept override { return destroyers_.size(); }

private:
    Status add(const Batch& batch) override;
    Status writeArrays(float finalError);
    void storeMeshSizes(const Batch& batch);
    Status writeHistoryKind();
    Status writeGeometry();
    Status writeAllSamples();
    template <class T> Status writeArray(SectionId id, const SpooledArray<T>& array);
    Status writeDestroyers();
    Error inconsistent(const std::string& what) const;
    Error outOfMemory() const;

    std::filesystem::path target_;
    SectionWriter sections_;
    Dataset dataset_;
    ModelDescription description_;

    SpoolFile spool_; ///< of the arrays that are only read at the end
    SpooledArray<std::uint32_t> points_{spool_};
    SpooledArray<float> runningErrors_{spool_};
    SpooledArray<std::uint64_t> starOffsets_{spool_};
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

Status HistoryFileWriter::writeFront()
{
    if (const Status reserved = sections_.reserveFront(); !reserved)
        return reserved;
    const Result<std::string> text = textOf(description_, target_);
    if (!text)
        return text.error();
    if (const Status begun = sections_.begin(SectionId::Text, 1); !begun)
        return begun;
    if (const Status written = sections_.add(std::as_bytes(std::span(*text))); !written)
        return written;
    sections_.end();
    return sections_.begin(SectionId::OtherSites, sizeof(otherSites_[0]));
}

Status HistoryFileWriter::begin(const HistoryTraits& traits)
{
    if (siteCount() > 0 || !(traits.warpingWeight >= 0) || !std::isfinite(traits.warpingWeight) ||
        canWarp(description_.domain) != (traits.warpingWeight > 0))
        return inconsistent("its warping weight is " + formatNumber(traits.warpingWeight));
    if (description_.domain == DomainClass::Irregular && traits.delaunay)
        return inconsistent("meshes of irregular data are not Delaunay ones");
    description_.warpingWeight = traits.warpingWeight;
    description_.delaunay = traits.delaunay;
    return {};
}

Status HistoryFileWriter::add(const HistoryStep& step)
{
    if (canWarp(description_.domain) && !(description_.warpingWeight > 0))
        return inconsistent(std::string(domainClassName(description_.domain)) + " data need a warping weight");
    try {
        const Status added = builder_.add(step);
        return added || added.error().kind != ErrorKind::BadInput ? added : inconsistent(added.error().text);
    } catch (const std::bad_alloc&) {
        return outOfMemory();
    }
}

Status HistoryFileWriter::add(const Batch& batch)
{
    for (std::size_t place = 0; place < batch.points.size(); ++place) {
        points_.push_back(static_cast<std::uint32_t>(batch.points[place]));
        runningErrors_.push_back(batch.runningKey);
        groupGoesOn_.push_back(batch.groupGoesOn[place]);
        starOffsets_.push_back(batch.firstTetrahedron + (place == 0 ? 0 : batch.starEnds[place - 1]));
    }
    storeMeshSizes(batch);
    for (const Batch::Destruction& destruction : batch.destructions)
        destroyers_[destruction.tetrahedron] = destruction.destroyer;
    const double extent = description_.range.extent();
    const double diagonal = description_.bounds.diagonal().norm();
    otherSites_.clear();
    for (const Batch::Tetrahedron& tetrahedron : batch.tetrahedra) {
        otherSites_.push_back({tetrahedron.sites[1], tetrahedron.sites[2], tetrahedron.sites[3]});
        destroyers_.push_back(Model::never);
        ownErrors_.push_back(halfBound(tetrahedron.error, extent));
        if (description_.warpingWeight > 0)
            ownWarpings_.push_back(halfBound(tetrahedron.warping, diagonal));
    }
    if (!spool_.status())
        return spool_.status();
    return sections_.add(std::as_bytes(std::span(otherSites_)));
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

Status HistoryFileWriter::finish(float finalError)
{
    if (siteCount() < fewestSites(description_.domain) || builder_.aliveCount() == 0)
        return inconsistent("a model needs at least the sites of a first mesh");
    if (!(finalError >= 0) || !std::isfinite(finalError))
        return inconsistent("the final error is not a number of at least 0");
    try {
        if (const Status closed = builder_.finish(); !closed)
            return closed;
        return writeArrays(finalError);
    } catch (const std::bad_alloc&) {
        return outOfMemory();
    }
}

Status HistoryFileWriter::finishEarly()
{
    // The open batch began with a mesh of the running error.
    if (std::isinf(builder_.runningKey()))
        return Error{ErrorKind::Cancelled,
                     "The build was stopped before there was a mesh of known error, so there is nothing to keep."};
    builder_.abandonBatch();
    try {
        return writeArrays(builder_.runningKey());
    } catch (const std::bad_alloc&) {
        return outOfMemory();
    }
}

/// All but what went to the file on the way, then the header; may throw std::bad_alloc.
Status HistoryFileWriter::writeArrays(float finalError)
{
    starOffsets_.push_back(tetrahedronCount());
    sections_.end();
    for (const Status& written :
         {writeArray(SectionId::SitePoints, points_), writeSiteValues(sections_, dataset_, points_),
          writeArray(SectionId::SiteRunningErrors, runningErrors_), writeArray(SectionId::StarOffsets, starOffsets_),
          writeArray(SectionId::MeshSizes, meshSizes_), writeArray(SectionId::SiteGroups, groupGoesOn_),
          writeDestroyers(), writeArray(SectionId::OwnErrors, ownErrors_), writeHistoryKind(), writeGeometry(),
          writeAllSamples()})
        if (!written)
            return written;
    format::Header header = headerOf(description_);
    header.siteCount = siteCount();
    header.tetrahedronCount = tetrahedronCount();
    header.finalError = finalError;
    if (const Status intact = dataset_.checkIntact(); !intact)
        return intact;
    return sections_.finish(header);
}

template <class T> Status HistoryFileWriter::writeArray(SectionId id, const SpooledArray<T>& array)
{
    if (const Status begun = sections_.begin(id, sizeof(T)); !begun)
        return begun;
    const Status written =
        array.forEachChunk([this](std::span<const T> chunk) { return sections_.add(std::as_bytes(chunk)); });
    sections_.end();
    return written;
}

Status HistoryFileWriter::writeDestroyers()
{
    if (const Status begun = sections_.begin(SectionId::Destroyers, sizeof(std::uint32_t)); !begun)
        return begun;
    for (std::size_t number = 0; number < destroyers_.chunkCount(); ++number)
        if (const Status written = sections_.add(std::as_bytes(destroyers_.chunk(number))); !written)
            return written;
    sections_.end();
    return {};
}

/// A section that readers must know: one that does not would insert points where it cannot be done.
Status HistoryFileWriter::writeHistoryKind()
{
    if (description_.delaunay)
        return {};
    constexpr auto kind = format::HistoryKind::ClosedSetsOnly;
    if (const Status begun = sections_.begin(SectionId::HistoryKind, sizeof kind); !begun)
        return begun;
    const Status written = sections_.add(std::as_bytes(std::span(&kind, 1)));
    sections_.end();
    return written;
}

/// What only domains that are no regular lattices have.
Status HistoryFileWriter::writeGeometry()
{
    if (description_.domain == DomainClass::RegularLattice)
        return {};
    const Status positions = writeSitePositions(sections_, dataset_, points_);
    if (!positions || !canWarp(description_.domain))
        return positions;
    return writeArray(SectionId::OwnWarpings, ownWarpings_);
}

Status HistoryFileWriter::writeAllSamples()
{
    const SampleType type = dataset_.values.type();
    if (!keepsSamples(dataset_.domain, type, positionBytes(dataset_), dataset_.pointCount(),
                      {siteCount(), tetrahedronCount()}))
        return {};
    if (dataset_.positions)
        if (const Status written = writeSamplePositions(sections_, dataset_); !written)
            return written;
    if (const Status begun = sections_.begin(SectionId::Samples, sampleSize(type), 0); !begun)
        return begun;
    const Status written =
        writeSamples(dataset_.values, [this](std::span<const std::byte> piece) { return sections_.add(piece); });
    sections_.end();
    return written;
}

Error HistoryFileWriter::inconsistent(const std::string& what) const
{
    return {ErrorKind::BadInput, "The builder '" + description_.builder + "' made a history that is wrong at site " +
                                     std::to_string(siteCount()) + ": " + what +
                                     ". Nothing was written; report this to its author."};
}

Error HistoryFileWriter::outOfMemory() const
{
    return {ErrorKind::OutOfResource, "Not enough memory to write '" + target_.string() + "' after " +
                                          std::to_string(siteCount()) +
                                          " sites. Ask for a larger error, or close other programs."};
}

} // namespace

Result<std::unique_ptr<ModelWriter>> ModelWriter::create(const std::filesystem::path& path, const Dataset& dataset,
                                                         ModelDescription description,
                                                         const std::filesystem::path& workFolder)
{
    if (dataset.pointCount() > (1ull << 32))
        return Error{ErrorKind::OutOfResource, "A model holds at most 4294967296 points, and '" + dataset.source.name +
                                                   "' has " + std::to_string(dataset.pointCount()) +
                                                   ". Take a part of it."};
    describeSource(description, dataset);
    Result<FileWriter> file = FileWriter::create(path, fileBufferBytes, workFolder);
    if (!file)
        return file.error();
    auto spoolFolder = workFolder.empty() ? file->target().parent_path() : workFolder;
    auto writer = std::make_unique<HistoryFileWriter>(std::move(*file), dataset, std::move(description),
                                                      spoolFolder.empty() ? "." : std::move(spoolFolder));
    if (const Status begun = writer->writeFront(); !begun)
        return begun.error();
    return std::unique_ptr<ModelWriter>(std::move(writer));
}

} // namespace tetra
