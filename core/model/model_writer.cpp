// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/model_writer.h"

#include "core/base/half.h"
#include "core/base/number_text.h"
#include "core/model/chunked_array.h"
#include "core/model/description_text.h"
#include "core/model/file_layout.h"
#include "core/model/history_arranger.h"
#include "core/model/sample_section.h"
#include "core/model/section_writer.h"
#include "core/model/site_sections.h"
#include "core/model/spooled_array.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

namespace tetra {

namespace {

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

class HistoryFileWriter final : public ModelWriter, private ArrangedBatchSink {
public:
    HistoryFileWriter(FileWriter file, const Dataset& dataset, ModelDescription description,
                      std::filesystem::path spoolFolder)
        : target_(file.target()), sections_(std::move(file), sectionLimit(dataset.domain)), dataset_(dataset),
          description_(std::move(description)), spool_(std::move(spoolFolder)), arranger_(dataset.pointCount(), *this)
    {
    }

    Status writeFront();
    Status begin(const HistoryTraits& traits) override;
    Status add(const HistoryStep& step) override;
    Status finish(float finalError) override;
    Status finishEarly() override;
    std::uint32_t siteCount() const noexcept override { return arranger_.siteCount(); }
    std::uint64_t tetrahedronCount() const noexcept override { return destroyers_.size(); }

private:
    Status add(const ArrangedBatch& batch) override;
    Status writeArrays(float finalError);
    void storeMeshSizes(const ArrangedBatch& batch);
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

    HistoryArranger arranger_;
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
        const Status added = arranger_.add(step);
        return added || added.error().kind != ErrorKind::BadInput ? added : inconsistent(added.error().text);
    } catch (const std::bad_alloc&) {
        return outOfMemory();
    }
}

Status HistoryFileWriter::add(const ArrangedBatch& batch)
{
    for (std::size_t place = 0; place < batch.points.size(); ++place) {
        points_.push_back(static_cast<std::uint32_t>(batch.points[place]));
        runningErrors_.push_back(batch.runningKey);
        groupGoesOn_.push_back(batch.groupGoesOn[place]);
        starOffsets_.push_back(batch.firstTetrahedron + (place == 0 ? 0 : batch.starEnds[place - 1]));
    }
    storeMeshSizes(batch);
    for (const ArrangedBatch::Destruction& destruction : batch.destructions)
        destroyers_[destruction.tetrahedron] = destruction.destroyer;
    const double extent = description_.range.extent();
    const double diagonal = description_.bounds.diagonal().norm();
    otherSites_.clear();
    for (const ArrangedBatch::Tetrahedron& tetrahedron : batch.tetrahedra) {
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
void HistoryFileWriter::storeMeshSizes(const ArrangedBatch& batch)
{
    growth_.assign(batch.points.size(), 0);
    for (const ArrangedBatch::Destruction& destruction : batch.destructions)
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
    if (siteCount() < fewestSites(description_.domain) || arranger_.aliveCount() == 0)
        return inconsistent("a model needs at least the sites of a first mesh");
    if (!(finalError >= 0) || !std::isfinite(finalError))
        return inconsistent("the final error is not a number of at least 0");
    try {
        if (const Status closed = arranger_.finish(); !closed)
            return closed;
        return writeArrays(finalError);
    } catch (const std::bad_alloc&) {
        return outOfMemory();
    }
}

Status HistoryFileWriter::finishEarly()
{
    // The open batch began with a mesh of the running error.
    if (std::isinf(arranger_.runningKey()))
        return Error{ErrorKind::Cancelled,
                     "The build was stopped before there was a mesh of known error, so there is nothing to keep."};
    arranger_.abandonBatch();
    try {
        return writeArrays(arranger_.runningKey());
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
