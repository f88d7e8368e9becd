// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/model_writer.h"

#include "core/base/half.h"
#include "core/data/grid_handedness.h"
#include "core/model/chunked_array.h"
#include "core/model/description_text.h"
#include "core/model/file_layout.h"
#include "core/model/history_batch.h"
#include "core/model/section_writer.h"
#include "core/model/site_sections.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

namespace tetra {

namespace {

using format::SectionId;

/// Sections of every model; domains with positions of their own and with warping have more.
constexpr std::uint32_t commonSections = 10;

std::uint32_t sectionCount(DomainClass domain)
{
    return commonSections + (domain != DomainClass::RegularLattice ? 1 : 0) +
           (domain == DomainClass::Curvilinear ? 1 : 0);
}

/// A first mesh needs as many sites: the corners of a lattice, or those of one tetrahedron.
std::uint32_t fewestSites(DomainClass domain)
{
    return domain == DomainClass::Scattered ? 4 : 8;
}

/// The number in the file of a tetrahedron that is dead.
constexpr std::uint32_t gone = 0xffffffff;

class HistoryFileWriter final : public ModelWriter {
public:
    HistoryFileWriter(FileWriter file, const Dataset& dataset, ModelDescription description)
        : target_(file.target()), sections_(std::move(file), sectionCount(dataset.domain)), dataset_(dataset),
          description_(std::move(description))
    {
    }

    Status writeFront();
    Status begin(const HistoryTraits& traits) override;
    Status add(const HistoryStep& step) override;
    Status finish(float finalError) override;
    Status finishEarly() override;
    std::uint32_t siteCount() const noexcept override { return batch_.firstSite() + batch_.siteCount(); }
    std::uint64_t tetrahedronCount() const noexcept override { return destroyers_.size(); }

private:
    /// A destroyed tetrahedron, by its number in the file, and the site that did it, by the builder's number.
    struct Destruction {
        std::uint32_t tetrahedron;
        std::uint32_t destroyer;
    };

    /// A tetrahedron that outlives its batch: its sites in the file, the creator first, and its number in the batch.
    struct Staying {
        std::array<std::uint32_t, 4> sites;
        std::uint32_t number;
    };

    Status check(const HistoryStep& step) const;
    void record(const HistoryStep& step);
    Status closeBatch();
    Status writeArrays(float finalError);
    void storeSites();
    void storeTetrahedra();
    void storeMeshSizes();
    std::uint32_t madeCount() const noexcept { return static_cast<std::uint32_t>(storedNumbers_.size()); }
    Status writeOtherSites();
    Status writeGeometry();
    template <class T> Status writeArray(SectionId id, const ChunkedArray<T>& array);
    Error inconsistent(const std::string& what) const;
    Error outOfMemory() const;

    std::filesystem::path target_;
    SectionWriter sections_;
    Dataset dataset_;
    ModelDescription description_;

    ChunkedArray<std::uint32_t> points_;
    ChunkedArray<float> runningErrors_;
    ChunkedArray<std::uint64_t> starOffsets_;
    ChunkedArray<std::uint32_t> meshSizes_;
    ChunkedArray<std::uint8_t> groupGoesOn_;
    ChunkedArray<std::uint32_t> destroyers_;
    ChunkedArray<std::uint16_t> ownErrors_;
    ChunkedArray<std::uint16_t> ownWarpings_;

    ChunkedArray<std::uint32_t> finalNumbers_;  ///< in the file, of each of the builder's sites
    ChunkedArray<std::uint32_t> storedNumbers_; ///< in the file, of each of the builder's tetrahedra; gone when dead
    HistoryBatch batch_;
    std::vector<Destruction> destructions_;                ///< of the batch, among the tetrahedra before it
    std::vector<std::uint32_t> starEnds_;                  ///< of the batch's sites by their place
    std::vector<Staying> staying_;                         ///< the batch's tetrahedra that outlive it
    std::vector<std::uint32_t> starOrder_;                 ///< the same, star by star
    std::vector<std::array<std::uint32_t, 3>> otherSites_; ///< of the batch, on their way to the file
    float runningError_ = std::numeric_limits<float>::infinity();
    std::vector<std::int64_t> growth_; ///< of the mesh by each of the batch's sites
    std::uint64_t alive_ = 0;          ///< tetrahedra in the mesh after the last step
    std::int64_t meshSize_ = 0;        ///< and after the last batch in the file
};

Status HistoryFileWriter::writeFront()
{
    if (const Status reserved = sections_.reserveFront(); !reserved)
        return reserved;
    const std::string text = textOf(description_);
    if (text.size() > format::longestText)
        return Error{ErrorKind::OutOfResource, "Cannot write '" + target_.string() +
                                                   "': the names and parameters of the model are longer than 1 MiB. "
                                                   "Shorten them."};
    if (const Status begun = sections_.begin(SectionId::Text, 1); !begun)
        return begun;
    if (const Status written = sections_.add(std::as_bytes(std::span(text))); !written)
        return written;
    sections_.end();
    return sections_.begin(SectionId::OtherSites, sizeof(otherSites_[0]));
}

Status HistoryFileWriter::begin(const HistoryTraits& traits)
{
    const bool lifted = description_.domain == DomainClass::Curvilinear;
    if (siteCount() > 0 || !(traits.warpingWeight >= 0) || !std::isfinite(traits.warpingWeight) ||
        lifted != (traits.warpingWeight > 0))
        return inconsistent("its warping weight is " + std::to_string(traits.warpingWeight));
    description_.warpingWeight = traits.warpingWeight;
    return {};
}

Status HistoryFileWriter::add(const HistoryStep& step)
{
    if (const Status right = check(step); !right)
        return right;
    try {
        if (step.keyBefore < runningError_) {
            if (const Status closed = closeBatch(); !closed)
                return closed;
            runningError_ = step.keyBefore;
        }
        record(step);
    } catch (const std::bad_alloc&) {
        return outOfMemory();
    }
    return {};
}

/// Plugins are written by others: a history that does not hold together must not become a file.
Status HistoryFileWriter::check(const HistoryStep& step) const
{
    const std::uint32_t creator = siteCount();
    if (step.point >= dataset_.pointCount() || creator == Model::never - 1)
        return inconsistent("point " + std::to_string(step.point) + " is not in the dataset");
    if (description_.domain == DomainClass::Curvilinear && !(description_.warpingWeight > 0))
        return inconsistent("curvilinear data need a warping weight");
    if (std::isnan(step.keyBefore) || step.keyBefore < 0)
        return inconsistent("the error before it is not a number of at least 0");
    if (step.star.size() > gone - storedNumbers_.size())
        return Error{ErrorKind::OutOfResource,
                     "The history has more than 4294967295 tetrahedra. Ask for a larger error, or build in blocks."};
    for (const HistoryTetrahedron& tetrahedron : step.star) {
        if (std::ranges::any_of(tetrahedron.sites, [creator](std::uint32_t site) { return site >= creator; }))
            return inconsistent("a tetrahedron of its star has a site that comes after it");
        if (!(tetrahedron.error >= 0) || !(tetrahedron.warping >= 0))
            return inconsistent(
                "a tetrahedron of its star has an error or a warping that is not a number of at least 0");
    }
    for (const std::uint32_t destroyed : step.destroyed)
        if (destroyed >= madeCount() || storedNumbers_[destroyed] == gone)
            return inconsistent("it destroys tetrahedron " + std::to_string(destroyed) + ", which is not in the mesh");
    const std::uint64_t alive = alive_ + step.star.size() - step.destroyed.size();
    if (step.destroyed.size() > alive_ || alive > std::numeric_limits<std::uint32_t>::max())
        return inconsistent("it destroys more tetrahedra than there are");
    return {};
}

void HistoryFileWriter::record(const HistoryStep& step)
{
    const std::uint32_t site = siteCount();
    alive_ += step.star.size() - step.destroyed.size();
    batch_.add(step);
    for (const std::uint32_t destroyed : step.destroyed) {
        if (destroyed < batch_.firstTetrahedron())
            destructions_.push_back({storedNumbers_[destroyed], site});
        storedNumbers_[destroyed] = gone;
    }
    for (std::size_t made = 0; made < step.star.size(); ++made)
        storedNumbers_.push_back(0); // until it is known whether it outlives the batch
}

/// Gives the sites and the tetrahedra of the batch their numbers in the file; may throw std::bad_alloc.
Status HistoryFileWriter::closeBatch()
{
    if (std::isinf(runningError_))
        batch_.uniteAll();
    batch_.arrange();
    storeSites();
    storeTetrahedra();
    storeMeshSizes();
    destructions_.clear();
    batch_.start(siteCount(), madeCount());
    return writeOtherSites();
}

void HistoryFileWriter::storeSites()
{
    for (std::uint32_t place = 0; place < batch_.siteCount(); ++place) {
        points_.push_back(static_cast<std::uint32_t>(batch_.pointAt(place)));
        runningErrors_.push_back(runningError_);
        groupGoesOn_.push_back(batch_.groupGoesOn(place) ? 1 : 0);
        finalNumbers_.push_back(batch_.firstSite() + batch_.placeOf(batch_.firstSite() + place));
    }
    for (const Destruction& destruction : destructions_)
        destroyers_[destruction.tetrahedron] = finalNumbers_[destruction.destroyer];
}

/// Sorts the tetrahedra that stay by their creators and appends them.
void HistoryFileWriter::storeTetrahedra()
{
    const std::span<const HistoryBatch::Tetrahedron> made = batch_.tetrahedra();
    staying_.clear();
    starEnds_.assign(batch_.siteCount() + 1, 0);
    for (std::uint32_t number = 0; number < made.size(); ++number) {
        if (made[number].dropped)
            continue;
        std::array<std::uint32_t, 4> sites = made[number].sites;
        for (std::uint32_t& site : sites)
            site = finalNumbers_[site];
        staying_.push_back({latestFirst(sites), number});
        ++starEnds_[staying_.back().sites[0] - batch_.firstSite() + 1];
    }
    for (std::uint32_t place = 0; place < batch_.siteCount(); ++place) {
        starOffsets_.push_back(tetrahedronCount() + starEnds_[place]);
        starEnds_[place + 1] += starEnds_[place];
    }
    starOrder_.resize(staying_.size());
    for (std::uint32_t i = 0; i < staying_.size(); ++i)
        starOrder_[starEnds_[staying_[i].sites[0] - batch_.firstSite()]++] = i;
    const double extent = description_.range.extent();
    const double diagonal = description_.bounds.diagonal().norm();
    otherSites_.clear();
    for (const std::uint32_t i : starOrder_) {
        const auto& [sites, number] = staying_[i];
        otherSites_.push_back({sites[1], sites[2], sites[3]});
        storedNumbers_[batch_.firstTetrahedron() + number] = static_cast<std::uint32_t>(destroyers_.size());
        destroyers_.push_back(Model::never);
        ownErrors_.push_back(halfBound(made[number].error, extent));
        if (description_.warpingWeight > 0)
            ownWarpings_.push_back(halfBound(made[number].warping, diagonal));
    }
}

/// The mesh has a size where a group ends; its other sites get the same one.
void HistoryFileWriter::storeMeshSizes()
{
    growth_.assign(batch_.siteCount(), 0);
    for (const Destruction& destruction : destructions_)
        --growth_[batch_.placeOf(destruction.destroyer)];
    std::uint32_t first = 0;
    for (std::uint32_t place = 0; place < batch_.siteCount(); ++place) {
        meshSize_ += growth_[place] + starEnds_[place] - (place > 0 ? starEnds_[place - 1] : 0);
        if (batch_.groupGoesOn(place))
            continue;
        for (; first <= place; ++first)
            meshSizes_.push_back(static_cast<std::uint32_t>(meshSize_));
    }
}

Status HistoryFileWriter::writeOtherSites()
{
    return sections_.add(std::as_bytes(std::span(otherSites_)));
}

Status HistoryFileWriter::finish(float finalError)
{
    if (siteCount() < fewestSites(description_.domain) || alive_ == 0)
        return inconsistent("a model needs at least the sites of a first mesh");
    if (!(finalError >= 0) || !std::isfinite(finalError))
        return inconsistent("the final error is not a number of at least 0");
    try {
        if (const Status closed = closeBatch(); !closed)
            return closed;
        return writeArrays(finalError);
    } catch (const std::bad_alloc&) {
        return outOfMemory();
    }
}

Status HistoryFileWriter::finishEarly()
{
    // The open batch began with a mesh of the running error.
    if (std::isinf(runningError_))
        return Error{ErrorKind::Cancelled,
                     "The build was stopped before there was a mesh of known error, so there is nothing to keep."};
    batch_.start(batch_.firstSite(), batch_.firstTetrahedron());
    try {
        return writeArrays(runningError_);
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
          writeArray(SectionId::Destroyers, destroyers_), writeArray(SectionId::OwnErrors, ownErrors_),
          writeGeometry()})
        if (!written)
            return written;
    format::Header header = headerOf(description_);
    header.siteCount = siteCount();
    header.tetrahedronCount = tetrahedronCount();
    header.finalError = finalError;
    return sections_.finish(header);
}

template <class T> Status HistoryFileWriter::writeArray(SectionId id, const ChunkedArray<T>& array)
{
    if (const Status begun = sections_.begin(id, sizeof(T)); !begun)
        return begun;
    for (std::size_t number = 0; number < array.chunkCount(); ++number)
        if (const Status written = sections_.add(std::as_bytes(array.chunk(number))); !written)
            return written;
    sections_.end();
    return {};
}

/// What only domains that are no regular lattices have.
Status HistoryFileWriter::writeGeometry()
{
    if (description_.domain == DomainClass::RegularLattice)
        return {};
    const Status positions = writeSitePositions(sections_, dataset_, points_);
    if (!positions || description_.domain != DomainClass::Curvilinear)
        return positions;
    return writeArray(SectionId::OwnWarpings, ownWarpings_);
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
                                                         ModelDescription description)
{
    if (dataset.pointCount() > (1ull << 32))
        return Error{ErrorKind::OutOfResource, "A model holds at most 4294967296 points, and '" + dataset.source.name +
                                                   "' has " + std::to_string(dataset.pointCount()) +
                                                   ". Take a part of it."};
    description.domain = dataset.domain;
    description.lattice = dataset.lattice;
    description.bounds = dataset.bounds();
    description.leftHanded = dataset.domain == DomainClass::Curvilinear && isLeftHanded(dataset);
    description.sampleType = dataset.values.type();
    description.range = dataset.values.range();
    description.sourceName = dataset.source.name;
    description.sourceHash = dataset.source.hash;
    Result<FileWriter> file = FileWriter::create(path);
    if (!file)
        return file.error();
    auto writer = std::make_unique<HistoryFileWriter>(std::move(*file), dataset, std::move(description));
    if (const Status begun = writer->writeFront(); !begun)
        return begun.error();
    return std::unique_ptr<ModelWriter>(std::move(writer));
}

} // namespace tetra
