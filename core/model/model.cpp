// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/model.h"

#include "core/base/checksum.h"
#include "core/base/mapped_file.h"
#include "core/model/description_text.h"
#include "core/model/file_layout.h"

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
    MappedModel(std::shared_ptr<const MappedFile> file, const FileLayout& layout, ModelDescription description)
        : file_(std::move(file))
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
    bool damaged() const noexcept override { return file_->damaged(); }

private:
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
};

/// Whether the meshes are Delaunay ones. A kind that is not known may mean anything.
Result<bool> readHistoryKind(const MappedFile& file, const FileLayout& layout)
{
    if (!layout.has(SectionId::HistoryKind))
        return true;
    const Section& section = layout.section(SectionId::HistoryKind);
    if (checksum(sectionBytes(file, section)) != section.checksum)
        return Error{ErrorKind::BadInput, "'" + file.path().string() +
                                              "' is damaged: the checksum of its history kind is wrong. Copy it again "
                                              "from where it came from, or build it again."};
    const auto kind = elementsOf<std::uint32_t>(file, layout, SectionId::HistoryKind).front();
    if (kind != static_cast<std::uint32_t>(format::HistoryKind::ClosedSetsOnly))
        return Error{ErrorKind::BadInput, "'" + file.path().string() + "' has a history of kind " +
                                              std::to_string(kind) +
                                              ", which this version cannot read. Install a later version of TAn."};
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
        return Error{ErrorKind::BadInput, "'" + path.string() +
                                              "' is damaged: the checksum of its text is wrong. Copy it again from "
                                              "where it came from, or build it again."};
    const Result<bool> delaunay = readHistoryKind(mapped, *layout);
    if (!delaunay)
        return delaunay.error();
    ModelDescription description = descriptionOf(layout->header);
    description.delaunay = *delaunay;
    readText({reinterpret_cast<const char*>(text.data()), text.size()}, description);
    std::shared_ptr<const Model> model =
        std::make_shared<const MappedModel>(file.value(), layout.value(), std::move(description));
    if (const Status intact = model->checkIntact(); !intact)
        return intact.error();
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

Status Model::checkIntact() const
{
    if (!damaged())
        return {};
    return Error{ErrorKind::BadInput, "'" + path_.string() +
                                          "' was cut short or changed while it was open. Open it again; if that fails, "
                                          "copy it again from where it came from, or build it again."};
}

} // namespace tetra
