// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/checksum.h"
#include "core/base/rounding.h"
#include "core/history/build_facts.h"
#include "core/history/file_layout.h"
#include "core/history/lattice_frame.h"
#include "core/history/section_checks.h"

#include <tan/base.h>
#include <tan/model.h>

#include <algorithm>

namespace tetra {

namespace {

using format::Section;
using format::SectionId;

std::span<const std::byte> sectionBytes(const MappedFile& file, const Section& section)
{
    return file.bytes().subspan(section.offset, section.bytes);
}

/// A section in place: offsets are multiples of 64 and sizes of the element's, so the cast is aligned and whole.
template <class T> std::span<const T> elementsOf(const MappedFile& file, const FileLayout& layout, SectionId id)
{
    const std::span<const std::byte> bytes = sectionBytes(file, layout.section(id));
    return {reinterpret_cast<const T*>(bytes.data()), bytes.size() / sizeof(T)};
}

/// Whether the meshes are Delaunay ones. A kind that is not known may mean anything.
Result<bool> readHistoryKind(const MappedFile& file, const FileLayout& layout)
{
    if (!layout.has(SectionId::HistoryKind))
        return true;
    const Section& section = layout.section(SectionId::HistoryKind);
    if (checksum(sectionBytes(file, section)) != section.checksum)
        return Error{
            ErrorKind::BadInput,
            Message::say(
                "'%1' is damaged: the checksum of its history kind is wrong. Copy the file again, or build it again.",
                file.path().string())};
    const auto kind = elementsOf<std::uint32_t>(file, layout, SectionId::HistoryKind).front();
    if (kind != static_cast<std::uint32_t>(format::HistoryKind::ClosedSetsOnly))
        return Error{
            ErrorKind::BadInput,
            Message::say(
                "'%1' has a history of kind %2, which this version cannot read. Install a later version of TAn.",
                file.path().string(), kind)};
    return false;
}

} // namespace

struct Model::File {
    std::shared_ptr<const MappedFile> mapped;
    FileLayout layout;
    std::unique_ptr<const SectionChecks> checks;
};

namespace {

Status readFrame(const MappedFile& mapped, const FileLayout& layout, const std::filesystem::path& path,
                 ModelDescription& description)
{
    for (const SectionId id : frameSectionIds) {
        if (!layout.has(id))
            continue;
        const Section& section = layout.section(id);
        const std::span<const std::byte> bytes = sectionBytes(mapped, section);
        if (checksum(bytes) != section.checksum || !takeFrameSection(id, bytes, description))
            return Error{
                ErrorKind::BadInput,
                Message::say("'%1' is damaged: its section '%2' is invalid. Copy the file again, or build it again.",
                             path.string(), format::sectionName(section.id)),
                path};
    }
    return {};
}

} // namespace

Model::Model(File file, ModelDescription description, std::filesystem::path place,
             std::shared_ptr<const WholeElsewhere> whole)
    : file_(std::make_unique<const File>(std::move(file))), whole_(std::move(whole)), path_(std::move(place)),
      description_(std::move(description)), fileSize_(file_->mapped->bytes().size()),
      finalKey_(file_->layout.header.finalKey)
{
    const auto map = [this]<class T>(std::span<const T>& elements, SectionId id) {
        elements = elementsOf<T>(*file_->mapped, file_->layout, id);
    };
    map(points_, SectionId::SitePoints);
    map(values_, SectionId::SiteValues);
    map(runningKeys_, SectionId::SiteRunningKeys);
    map(starOffsets_, SectionId::StarOffsets);
    map(meshSizes_, SectionId::MeshSizes);
    map(groupGoesOn_, SectionId::SiteGroups);
    map(otherSites_, SectionId::OtherSites);
    map(destroyers_, SectionId::Destroyers);
    map(ownErrors_, SectionId::OwnErrors);
    if (description_.warpingWeight > 0)
        map(ownWarpings_, SectionId::OwnWarpings);
    if (file_->layout.has(SectionId::BatchEnds))
        map(batchEnds_, SectionId::BatchEnds);
    if (file_->layout.has(SectionId::BatchErrors) && file_->layout.has(SectionId::BatchWarpings) &&
        !buildFacts(description_).claimsByKeysAlone()) {
        map(batchErrors_, SectionId::BatchErrors);
        map(batchWarpings_, SectionId::BatchWarpings);
    }
    static_assert(sizeof(Eigen::Vector3f) == 12 && sizeof(Eigen::Vector3d) == 24);
    const bool hasPositions = description_.domain != DomainClass::RegularLattice;
    const bool floats =
        hasPositions && file_->layout.section(SectionId::SitePositions).elementBytes == sizeof(Eigen::Vector3f);
    if (hasPositions && floats)
        map(floatPositions_, SectionId::SitePositions);
    else if (hasPositions)
        map(doublePositions_, SectionId::SitePositions);
    if (!isOnLattice(description_.domain) || !file_->layout.has(SectionId::Samples))
        return;
    map(samples_, SectionId::Samples);
    if (hasPositions && floats)
        map(floatSamplePositions_, SectionId::SamplePositions);
    else if (hasPositions)
        map(doubleSamplePositions_, SectionId::SamplePositions);
}

Model::~Model() = default;

Result<std::shared_ptr<const Model>> Model::open(const std::filesystem::path& path)
{
    return open(path, path);
}

Result<std::shared_ptr<const Model>> Model::open(const std::filesystem::path& path, std::filesystem::path place,
                                                 std::shared_ptr<const WholeElsewhere> whole)
{
    const Result<std::shared_ptr<const MappedFile>> file = MappedFile::open(path);
    if (!file)
        return file.error();
    const MappedFile& mapped = **file;
    const Result<FileLayout> layout = readLayout(mapped.bytes(), path);
    if (!layout)
        return layout.error();
    const Section& textSection = layout->section(SectionId::Text);
    const std::span<const std::byte> text = sectionBytes(mapped, textSection);
    if (checksum(text) != textSection.checksum)
        return Error{
            ErrorKind::BadInput,
            Message::say("'%1' is damaged: the checksum of its text is wrong. Copy the file again, or build it again.",
                         path.string()),
            path};
    const Result<bool> delaunay = readHistoryKind(mapped, *layout);
    if (!delaunay.ok())
        return delaunay.error();
    ModelDescription description = descriptionOf(layout->header);
    description.delaunay = *delaunay;
    readText({reinterpret_cast<const char*>(text.data()), text.size()}, description);
    if (const Status framed = readFrame(mapped, *layout, path, description); !framed)
        return framed.error();
    auto checks = SectionChecks::make(file.value(), *layout);
    if (!checks)
        return checks.error();
    const std::shared_ptr<const Model> model(new Model({file.value(), *layout, *std::move(checks)},
                                                       std::move(description), std::move(place), std::move(whole)));
    if (const Status unchanged = model->checkUnchanged(); !unchanged) // of damage checkIntact() tells
        return unchanged.error();
    return model;
}

std::span<const std::byte> Model::fileBytes() const noexcept
{
    return file_->mapped->bytes();
}

double Model::ownError(std::uint64_t tetrahedron) const noexcept
{
    return static_cast<double>(halfToFloat(ownErrors_[tetrahedron])) * description_.range.extent();
}

double Model::ownWarping(std::uint64_t tetrahedron) const noexcept
{
    return ownWarpings_.empty() ? 0 : static_cast<double>(halfToFloat(ownWarpings_[tetrahedron])) * diagonal();
}

Eigen::Vector3d Model::position(std::uint32_t site) const
{
    if (!floatPositions_.empty())
        return floatPositions_[site].cast<double>();
    if (!doublePositions_.empty())
        return doublePositions_[site];
    const auto place = description_.lattice.coordinates(points_[site]);
    return description_.lattice.position(place[0], place[1], place[2]);
}

bool Model::checkBytes(std::span<const std::byte> bytes) const noexcept
{
    return file_->checks->check(bytes);
}

Status Model::checkBytes(std::span<const std::byte> bytes, const Progress& progress) const
{
    constexpr std::size_t atOnce = 64 << 20; // between two looks at whether the work was cancelled
    for (; !bytes.empty(); bytes = bytes.subspan(std::min(atOnce, bytes.size()))) {
        if (progress.cancelled())
            return cancelledError(Message::marked("Checking the model's file"));
        if (!checkBytes(bytes.first(std::min(atOnce, bytes.size()))))
            return checkIntact();
    }
    return {};
}

Status Model::checkPrefix(std::uint32_t sites, unsigned reading, const Progress& progress) const
{
    Status right = check(starOffsets_.first(sites + std::size_t(1)), progress);
    const std::uint64_t tetrahedra = std::min(starOffsets_[sites], tetrahedronCount());
    const auto checkAlso = [&](Reading part, auto elements, std::uint64_t count) {
        if (right && (reading & part) != 0 && !elements.empty())
            right = check(elements.first(count), progress);
    };
    checkAlso(Batches, runningKeys_, sites);
    checkAlso(Batches, meshSizes_, sites);
    checkAlso(Batches, groupGoesOn_, sites);
    checkAlso(Stars, otherSites_, tetrahedra);
    checkAlso(Stars, destroyers_, tetrahedra);
    checkAlso(OwnBounds, ownErrors_, tetrahedra);
    checkAlso(OwnBounds, ownWarpings_, tetrahedra);
    return right;
}

Status Model::confirm(const Progress& progress) const
{
    const Status right = file_->checks->finish(progress);
    const Status unchanged = checkUnchanged();
    return unchanged ? right : unchanged;
}

Status Model::checkIntact() const
{
    const Status unchanged = checkUnchanged();
    return unchanged ? foundDamage() : unchanged;
}

Status Model::foundDamage() const
{
    return file_->checks->damage();
}

Status Model::checkUnchanged() const
{
    if (!file_->mapped->damaged())
        return {};
    return Error{ErrorKind::BadInput, Message::say("'%1' was cut short or changed while it was open. Open it again; if "
                                                   "that fails, copy the file again, or build it again.",
                                                   path_.string())};
}

} // namespace tetra
