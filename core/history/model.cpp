// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/checksum.h"
#include "core/base/mapped_file.h"
#include "core/history/file_layout.h"
#include "core/history/section_checks.h"

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

class MappedModel final : public Model {
public:
    MappedModel(std::shared_ptr<const MappedFile> file, const FileLayout& layout, ModelDescription description,
                std::unique_ptr<const SectionChecks> checks)
        : file_(std::move(file)), checks_(std::move(checks))
    {
        path_ = file_->path();
        description_ = std::move(description);
        fileSize_ = file_->bytes().size();
        finalError_ = layout.header.finalError;
        points_ = elementsOf<std::uint32_t>(*file_, layout, SectionId::SitePoints);
        values_ = elementsOf<std::byte>(*file_, layout, SectionId::SiteValues);
        runningErrors_ = elementsOf<float>(*file_, layout, SectionId::SiteRunningErrors);
        starOffsets_ = elementsOf<std::uint64_t>(*file_, layout, SectionId::StarOffsets);
        meshSizes_ = elementsOf<std::uint32_t>(*file_, layout, SectionId::MeshSizes);
        groupGoesOn_ = elementsOf<std::uint8_t>(*file_, layout, SectionId::SiteGroups);
        otherSites_ = elementsOf<std::array<std::uint32_t, 3>>(*file_, layout, SectionId::OtherSites);
        destroyers_ = elementsOf<std::uint32_t>(*file_, layout, SectionId::Destroyers);
        ownErrors_ = elementsOf<std::uint16_t>(*file_, layout, SectionId::OwnErrors);
        if (description_.warpingWeight > 0)
            ownWarpings_ = elementsOf<std::uint16_t>(*file_, layout, SectionId::OwnWarpings);
        if (description_.domain != DomainClass::RegularLattice)
            mapPositions(layout);
        if (isOnLattice(description_.domain) && layout.has(SectionId::Samples))
            mapSamples(layout);
    }

    std::span<const std::byte> fileBytes() const noexcept override { return file_->bytes(); }

private:
    bool changed() const noexcept override { return file_->damaged(); }
    const SectionChecks& checks() const noexcept override { return *checks_; }

    void mapPositions(const FileLayout& layout)
    {
        static_assert(sizeof(Eigen::Vector3f) == 12 && sizeof(Eigen::Vector3d) == 24);
        if (layout.section(SectionId::SitePositions).elementBytes == sizeof(Eigen::Vector3f))
            floatPositions_ = elementsOf<Eigen::Vector3f>(*file_, layout, SectionId::SitePositions);
        else
            doublePositions_ = elementsOf<Eigen::Vector3d>(*file_, layout, SectionId::SitePositions);
    }

    void mapSamples(const FileLayout& layout)
    {
        samples_ = elementsOf<std::byte>(*file_, layout, SectionId::Samples);
        if (!floatPositions_.empty())
            floatSamplePositions_ = elementsOf<Eigen::Vector3f>(*file_, layout, SectionId::SamplePositions);
        else if (!doublePositions_.empty())
            doubleSamplePositions_ = elementsOf<Eigen::Vector3d>(*file_, layout, SectionId::SamplePositions);
    }

    std::shared_ptr<const MappedFile> file_;
    std::unique_ptr<const SectionChecks> checks_;
};

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

Result<std::shared_ptr<const Model>> Model::open(const std::filesystem::path& path)
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
                         path.string())};
    const Result<bool> delaunay = readHistoryKind(mapped, *layout);
    if (!delaunay)
        return delaunay.error();
    ModelDescription description = descriptionOf(layout->header);
    description.delaunay = *delaunay;
    readText({reinterpret_cast<const char*>(text.data()), text.size()}, description);
    auto checks = SectionChecks::make(file.value(), *layout);
    if (!checks)
        return checks.error();
    std::shared_ptr<const Model> model =
        std::make_shared<const MappedModel>(file.value(), *layout, std::move(description), *std::move(checks));
    if (const Status unchanged = model->checkUnchanged(); !unchanged) // of damage checkIntact() tells
        return unchanged.error();
    return model;
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
    return checks().check(bytes);
}

Status Model::checkBytes(std::span<const std::byte> bytes, const Progress& progress) const
{
    constexpr std::size_t atOnce = 64 << 20; // between two looks at whether the work was cancelled
    for (; !bytes.empty(); bytes = bytes.subspan(std::min(atOnce, bytes.size()))) {
        if (progress.cancelled())
            return cancelledError("Checking the model's file");
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
    checkAlso(Batches, runningErrors_, sites);
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
    const Status right = checks().finish(progress);
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
    return checks().damage();
}

Status Model::checkUnchanged() const
{
    if (!changed())
        return {};
    return Error{ErrorKind::BadInput, Message::say("'%1' was cut short or changed while it was open. Open it again; if "
                                                   "that fails, copy the file again, or build it again.",
                                                   path_.string())};
}

} // namespace tetra
