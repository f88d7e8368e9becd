// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/file_layout.h"

#include "core/base/checksum.h"
#include "core/data/dataset_checks.h"
#include "core/history/format.h"
#include "core/history/lattice_frame.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>
#include <string>

namespace tetra {

namespace {

using format::Header;
using format::Section;
using format::SectionId;

/// The bytes of one element of each section that every model needs; 0 for the type of the samples.
struct Expected {
    SectionId id;
    std::uint32_t elementBytes;
};
constexpr Expected perSite[] = {{SectionId::SitePoints, 4},      {SectionId::SiteValues, 0},
                                {SectionId::SiteRunningKeys, 4}, {SectionId::StarOffsets, 8},
                                {SectionId::MeshSizes, 4},       {SectionId::SiteGroups, 1}};
constexpr Expected perTetrahedron[] = {
    {SectionId::OtherSites, 12}, {SectionId::Destroyers, 4}, {SectionId::OwnErrors, 2}};
constexpr std::uint32_t positionBytesInFloats = 12;
constexpr std::uint32_t positionBytesInDoubles = 24;

bool isDomain(const Header& header, DomainClass domain)
{
    return header.domainClass == static_cast<std::uint32_t>(domain);
}

/// Reads the layout of one file; every member gives the first thing that is wrong.
class LayoutReader {
public:
    LayoutReader(std::span<const std::byte> front, std::uint64_t fileBytes, const std::filesystem::path& path)
        : front_(front), fileBytes_(fileBytes), name_(path.string())
    {
    }

    Result<FileLayout> read();
    Result<FileLayout> readPacked();

private:
    Status readHeader();
    Status readTable();
    Status checkWhatItHolds() const;
    Status checkLattice() const;
    Status checkValues() const;
    Status checkPlace() const;
    Status checkFrame() const;
    Status checkBounds() const;
    Status checkCodecs() const;
    Status checkPackedCodecs() const;
    Status checkPackedCounts() const;
    Status checkCounts() const;
    Status checkText() const;
    Status checkPositions() const;
    Status checkSamples() const;
    Status checkDerived() const;
    std::uint32_t positionBytes() const;
    Status checkCount(Expected expected, std::uint64_t count) const;

    Error bad(Message text) const { return {ErrorKind::BadInput, std::move(text), name_}; }
    Error damaged(const Message& what) const
    {
        return bad(Message::say("'%1' is damaged: %2. Copy the file again, or build it again.", name_, what));
    }
    Error cutShort(std::uint64_t expectedBytes) const
    {
        return bad(Message::say("'%1' is cut short: it has %2 bytes and should have %3. Copy the file again, or build "
                                "it again.",
                                name_, fileBytes_, expectedBytes));
    }

    std::span<const std::byte> front_;
    std::uint64_t fileBytes_;
    std::string name_;
    FileLayout layout_;
};

Result<FileLayout> LayoutReader::read()
{
    for (const auto step : {&LayoutReader::readHeader, &LayoutReader::readTable})
        if (const Status status = (this->*step)(); !status)
            return status.error();
    for (const auto check : {&LayoutReader::checkWhatItHolds, &LayoutReader::checkLattice, &LayoutReader::checkValues,
                             &LayoutReader::checkPlace, &LayoutReader::checkBounds, &LayoutReader::checkCodecs,
                             &LayoutReader::checkCounts, &LayoutReader::checkFrame, &LayoutReader::checkPositions,
                             &LayoutReader::checkSamples, &LayoutReader::checkDerived})
        if (const Status status = (this->*check)(); !status)
            return status.error();
    return std::move(layout_);
}

Result<FileLayout> LayoutReader::readPacked()
{
    for (const auto step : {&LayoutReader::readHeader, &LayoutReader::readTable})
        if (const Status status = (this->*step)(); !status)
            return status.error();
    for (const auto check : {&LayoutReader::checkWhatItHolds, &LayoutReader::checkLattice, &LayoutReader::checkValues,
                             &LayoutReader::checkPlace, &LayoutReader::checkBounds, &LayoutReader::checkPackedCodecs,
                             &LayoutReader::checkPackedCounts, &LayoutReader::checkFrame})
        if (const Status status = (this->*check)(); !status)
            return status.error();
    return std::move(layout_);
}

Status LayoutReader::readHeader()
{
    Header& header = layout_.header;
    const std::size_t available = std::min(front_.size(), sizeof(Header));
    if (available == 0)
        return bad(Message::say("'%1' is empty. Models are made by 'tan build'.", name_));
    std::memcpy(static_cast<void*>(&header), front_.data(), available);
    if (available < sizeof header.magic || header.magic != format::magic)
        return bad(Message::say("'%1' is not a TAn model: it does not begin like one. Models are made by 'tan build'.",
                                name_));
    if (available < sizeof(Header))
        return cutShort(sizeof(Header));
    if (header.byteOrderMark == format::byteOrderMarkReversed)
        return bad(Message::say("'%1' was written with the other byte order. Build it again on this machine.", name_));
    if (header.majorVersion > format::majorVersion)
        return bad(Message::say(
            "'%1' has format version %2.%3; this program reads up to version %4. Install a later version of TAn.",
            name_, header.majorVersion, header.minorVersion, format::majorVersion));
    if (header.majorVersion == 0 || header.byteOrderMark != format::byteOrderMark ||
        header.headerBytes != sizeof(Header) || header.sectionCount > format::mostSections)
        return damaged(Message::say("its header is invalid"));
    return {};
}

Status LayoutReader::readTable()
{
    const Header& header = layout_.header;
    const std::uint64_t tableBytes = std::uint64_t(header.sectionCount) * sizeof(Section);
    if (std::min<std::uint64_t>(front_.size(), fileBytes_) < sizeof(Header) + tableBytes)
        return cutShort(std::max(header.fileBytes, sizeof(Header) + tableBytes));
    const std::span<const std::byte> table = front_.subspan(sizeof(Header), tableBytes);
    if (headerChecksum(header, table) != header.checksum)
        return damaged(Message::say("the checksum of its header is wrong"));
    if (fileBytes_ < header.fileBytes)
        return cutShort(header.fileBytes);
    if (fileBytes_ > header.fileBytes)
        return damaged(Message::say("it has %1 bytes and should have %2", fileBytes_, header.fileBytes));
    layout_.sections.resize(header.sectionCount);
    if (!table.empty())
        std::memcpy(static_cast<void*>(layout_.sections.data()), table.data(), table.size());
    return {};
}

Status LayoutReader::checkWhatItHolds() const
{
    const Header& header = layout_.header;
    if (header.domainClass > static_cast<std::uint32_t>(DomainClass::Scattered))
        return bad(Message::say(
            "'%1' is a model of domain class %2, which this version cannot read. Install a later version of TAn.",
            name_, header.domainClass));
    if (header.sampleType > static_cast<std::uint32_t>(SampleType::Float64))
        return bad(
            Message::say("'%1' has samples of type %2, which this version cannot read. Install a later version of TAn.",
                         name_, header.sampleType));
    return {};
}

Status LayoutReader::checkLattice() const
{
    const Header& header = layout_.header;
    const bool onLattice = isOnLattice(DomainClass(header.domainClass));
    std::uint64_t points = 1;
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (const std::uint32_t size = header.latticeSize[axis];
            size < (onLattice ? 2u : 1u) || (!onLattice && axis > 0 && size > 1) ||
            __builtin_mul_overflow(points, std::uint64_t(size), &points) || points > (1ull << 32))
            return damaged(Message::say("a lattice of %1 x %2 x %3 points is impossible", header.latticeSize[0],
                                        header.latticeSize[1], header.latticeSize[2]));
    for (int axis = 0; axis < 3; ++axis)
        if (!(header.spacing[axis] > 0) || !std::isfinite(header.spacing[axis]) || !std::isfinite(header.origin[axis]))
            return damaged(Message::say("the spacing or the origin of its lattice is invalid"));
    if (header.siteCount < fewestSites(DomainClass(header.domainClass)) || header.siteCount > points ||
        header.siteCount == Model::never || header.tetrahedronCount == 0)
        return damaged(Message::say("%1 points cannot have %2 sites and %3 tetrahedra", points, header.siteCount,
                                    header.tetrahedronCount));
    return {};
}

Status LayoutReader::checkValues() const
{
    const Header& header = layout_.header;
    if (!std::isfinite(header.valueRange[0]) || !std::isfinite(header.valueRange[1]) ||
        header.valueRange[0] > header.valueRange[1] || !(header.finalKey >= 0) || !std::isfinite(header.finalKey))
        return damaged(Message::say("its value range or its final error is invalid"));
    return {};
}

Status LayoutReader::checkPlace() const
{
    const Header& header = layout_.header;
    for (int axis = 0; axis < 3; ++axis)
        if (!std::isfinite(header.boundingBox[axis]) || !std::isfinite(header.boundingBox[axis + 3]) ||
            header.boundingBox[axis] > header.boundingBox[axis + 3])
            return damaged(Message::say("its bounding box is invalid"));
    // With a frame takeFrameSection() looks at it.
    const ModelDescription about = descriptionOf(header);
    if (isDomain(header, DomainClass::RegularLattice) && !layout_.has(SectionId::Frame) &&
        !isBoxOfLattice(about.lattice, about.bounds))
        return damaged(Message::say("its bounding box is invalid"));
    const bool warps = canWarp(DomainClass(header.domainClass));
    if (!(header.warpingWeight >= 0) || !std::isfinite(header.warpingWeight) || warps != (header.warpingWeight > 0) ||
        header.leftHanded > (isDomain(header, DomainClass::Curvilinear) ? 1u : 0u))
        return damaged(Message::say("its warping weight or its handedness is invalid"));
    return {};
}

Status LayoutReader::checkFrame() const
{
    const std::pair<Expected, std::uint64_t> all[] = {{{SectionId::Frame, sizeof(double)}, 9},
                                                      {{SectionId::Metric, sizeof(double)}, 3}};
    for (const auto& [expected, count] : all) {
        if (!layout_.has(expected.id))
            continue;
        if (!isDomain(layout_.header, DomainClass::RegularLattice))
            return damaged(Message::say("it has a section '%1', which only a regular lattice has",
                                        format::sectionName(static_cast<std::uint32_t>(expected.id))));
        if (const Status counted = checkCount(expected, count); !counted)
            return counted;
    }
    return {};
}

Status LayoutReader::checkBounds() const
{
    std::uint64_t end = sizeof(Header) + layout_.sections.size() * sizeof(Section);
    std::set<std::uint32_t> ids;
    for (const Section& section : layout_.sections) {
        const std::string name(format::sectionName(section.id));
        if (!ids.insert(section.id).second)
            return damaged(Message::say("section '%1' appears twice", name));
        if (section.offset % format::alignment != 0 || section.offset < end)
            return damaged(Message::say("section '%1' cannot begin at byte %2", name, section.offset));
        if (__builtin_add_overflow(section.offset, section.bytes, &end) || end > fileBytes_)
            return damaged(Message::say("section '%1' reaches beyond the end of the file", name));
    }
    if (end != fileBytes_)
        return damaged(Message::say("its last section ends at byte %1 of %2", end, fileBytes_));
    return {};
}

Status LayoutReader::checkCodecs() const
{
    if (layout_.has(SectionId::PackedFacts))
        return bad(Message::say("'%1' is a packed model. Unpack it first, with 'tan unpack'.", name_));
    return checkPackedCodecs();
}

Status LayoutReader::checkPackedCodecs() const
{
    for (const Section& section : layout_.sections) {
        const bool known = format::sectionName(section.id) != "unknown";
        if (!known && (section.flags & format::required))
            return bad(
                Message::say("'%1' needs section %2, which this version does not know. Install a later version of TAn.",
                             name_, section.id));
        if (known && section.codec != static_cast<std::uint32_t>(format::Codec::None))
            return bad(Message::say(
                "'%1' packs its section '%2' with codec %3, which this version does not know. Install a later version "
                "of TAn.",
                name_, format::sectionName(section.id), section.codec));
    }
    return {};
}

Status LayoutReader::checkCounts() const
{
    const Header& header = layout_.header;
    for (const Expected& expected : perSite) {
        const bool oneMore = expected.id == SectionId::StarOffsets;
        if (const Status status = checkCount(expected, std::uint64_t(header.siteCount) + (oneMore ? 1 : 0)); !status)
            return status;
    }
    for (const Expected& expected : perTetrahedron)
        if (const Status status = checkCount(expected, header.tetrahedronCount); !status)
            return status;
    if (canWarp(DomainClass(header.domainClass)))
        if (const Status status = checkCount({SectionId::OwnWarpings, 2}, header.tetrahedronCount); !status)
            return status;
    // Irregular meshes are nowhere Delaunay ones.
    if (layout_.has(SectionId::HistoryKind) || isDomain(header, DomainClass::Irregular))
        if (const Status status = checkCount({SectionId::HistoryKind, 4}, 1); !status)
            return status;
    return checkText();
}

Status LayoutReader::checkText() const
{
    const auto text = std::ranges::find(layout_.sections, std::uint32_t(SectionId::Text), &Section::id);
    if (text == layout_.sections.end() || text->bytes > format::longestText)
        return damaged(Message::say("its text section is missing or too long"));
    return {};
}

Status LayoutReader::checkPackedCounts() const
{
    const auto countOf = [this](SectionId id, std::uint64_t elementBytes) {
        return layout_.has(id) ? layout_.section(id).bytes / elementBytes : 0;
    };
    const std::uint64_t levels = countOf(SectionId::PackedLevels, sizeof(format::PackedLevelEntry));
    const std::uint64_t sums = countOf(SectionId::PackedSums, sizeof(format::PackedSum));
    const std::pair<Expected, std::uint64_t> all[] = {
        {{SectionId::PackedFacts, sizeof(format::PackedFacts)}, 1},
        {{SectionId::PackedLevels, sizeof(format::PackedLevelEntry)},
         std::clamp<std::uint64_t>(levels, 1, format::mostPackedLevels)},
        {{SectionId::PackedSums, sizeof(format::PackedSum)}, std::clamp<std::uint64_t>(sums, 1, format::mostSections)},
        {{SectionId::PackedChunks, 1}, countOf(SectionId::PackedChunks, 1)}};
    for (const auto& [expected, count] : all)
        if (const Status counted = checkCount(expected, count); !counted)
            return counted;
    return checkText();
}

/// Floats where they hold every coordinate exactly, else doubles; none for a lattice that says where its points are.
Status LayoutReader::checkPositions() const
{
    if (isDomain(layout_.header, DomainClass::RegularLattice))
        return {};
    return checkCount({SectionId::SitePositions, positionBytes()}, layout_.header.siteCount);
}

std::uint32_t LayoutReader::positionBytes() const
{
    const auto section = std::ranges::find(layout_.sections, std::uint32_t(SectionId::SitePositions), &Section::id);
    const bool doubles = section != layout_.sections.end() && section->elementBytes == positionBytesInDoubles;
    return doubles ? positionBytesInDoubles : positionBytesInFloats;
}

Status LayoutReader::checkSamples() const
{
    const auto& size = layout_.header.latticeSize;
    const std::uint64_t points = std::uint64_t(size[0]) * size[1] * size[2];
    const bool curvilinear = isDomain(layout_.header, DomainClass::Curvilinear);
    if (!layout_.has(SectionId::Samples) || !isOnLattice(DomainClass(layout_.header.domainClass)))
        return {};
    if (curvilinear)
        if (const Status counted = checkCount({SectionId::SamplePositions, positionBytes()}, points); !counted)
            return counted;
    return checkCount({SectionId::Samples, 0}, points);
}

/// The sections that follow from the others: each is there or not.
Status LayoutReader::checkDerived() const
{
    const Header& header = layout_.header;
    const auto countOf = [this](SectionId id, std::uint32_t elementBytes, std::uint64_t most) {
        return layout_.has(id) ? std::min(layout_.section(id).bytes / elementBytes, most) : 0;
    };
    const std::uint64_t batches = countOf(SectionId::BatchEnds, 4, header.siteCount);
    const std::uint64_t levels = countOf(SectionId::LevelIndex, sizeof(format::LevelEntry), format::mostLevels);
    constexpr auto any = ~std::uint64_t(0);
    const std::uint64_t faults = countOf(SectionId::Faults, sizeof(format::Fault), any);
    const std::uint64_t faultyCells = countOf(SectionId::FaultyCells, sizeof(format::FaultyCell), any);
    const std::pair<Expected, std::uint64_t> all[] = {
        {{SectionId::LevelIndex, sizeof(format::LevelEntry)}, std::max<std::uint64_t>(levels, 1)},
        {{SectionId::BatchEnds, 4}, std::max<std::uint64_t>(batches, 1)},
        {{SectionId::BatchErrors, 4}, batches},
        {{SectionId::BatchWarpings, 4}, batches},
        {{SectionId::Blocks, 4}, 3},
        {{SectionId::Faults, sizeof(format::Fault)}, faults},
        {{SectionId::FaultyCells, sizeof(format::FaultyCell)}, faultyCells}};
    for (const auto& [expected, count] : all)
        if (layout_.has(expected.id))
            if (const Status counted = checkCount(expected, count); !counted)
                return counted;
    return {};
}

Status LayoutReader::checkCount(Expected expected, std::uint64_t count) const
{
    const std::string name(format::sectionName(static_cast<std::uint32_t>(expected.id)));
    const auto section = std::ranges::find(layout_.sections, static_cast<std::uint32_t>(expected.id), &Section::id);
    if (section == layout_.sections.end())
        return damaged(Message::say("section '%1' is missing", name));
    const std::uint64_t elementBytes =
        expected.elementBytes != 0 ? expected.elementBytes : sampleSize(SampleType(layout_.header.sampleType));
    std::uint64_t bytes = 0;
    if (section->elementBytes != elementBytes || __builtin_mul_overflow(elementBytes, count, &bytes) ||
        section->bytes != bytes)
        return damaged(Message::say("section '%1' has %2 bytes in elements of %3 instead of %4 elements of %5", name,
                                    section->bytes, section->elementBytes, count, elementBytes));
    return {};
}

} // namespace

const format::Section& FileLayout::section(SectionId id) const
{
    return *std::ranges::find(sections, static_cast<std::uint32_t>(id), &Section::id);
}

bool FileLayout::has(SectionId id) const
{
    return std::ranges::find(sections, static_cast<std::uint32_t>(id), &Section::id) != sections.end();
}

Result<FileLayout> readLayout(std::span<const std::byte> file, const std::filesystem::path& path)
{
    return readLayout(file, file.size(), path);
}

Result<FileLayout> readLayout(std::span<const std::byte> front, std::uint64_t fileBytes,
                              const std::filesystem::path& path)
{
    return LayoutReader(front, fileBytes, path).read();
}

Result<FileLayout> readPackedLayout(std::span<const std::byte> front, std::uint64_t fileBytes,
                                    const std::filesystem::path& path)
{
    return LayoutReader(front, fileBytes, path).readPacked();
}

std::uint64_t frontBytes(std::span<const std::byte> front) noexcept
{
    Header header;
    if (front.size() < sizeof header)
        return sizeof header;
    std::memcpy(static_cast<void*>(&header), front.data(), sizeof header);
    return sizeof header + std::uint64_t(std::min(header.sectionCount, format::mostSections)) * sizeof(Section);
}

bool isFrontOfPacked(std::span<const std::byte> front) noexcept
{
    const std::uint64_t end = std::min<std::uint64_t>(frontBytes(front), front.size());
    for (std::uint64_t at = sizeof(Header); at + sizeof(Section) <= end; at += sizeof(Section)) {
        Section section;
        std::memcpy(static_cast<void*>(&section), front.data() + at, sizeof section);
        if (section.id == static_cast<std::uint32_t>(SectionId::PackedFacts))
            return true;
    }
    return false;
}

std::uint64_t headerChecksum(const Header& header, std::span<const std::byte> table)
{
    Checksum checksum;
    checksum.add(std::as_bytes(std::span(&header, 1)).first(offsetof(Header, checksum)));
    checksum.add(table);
    return checksum.value();
}

ModelDescription descriptionOf(const Header& header)
{
    ModelDescription description;
    description.domain = static_cast<DomainClass>(header.domainClass);
    description.lattice.size = header.latticeSize;
    description.lattice.spacing = Eigen::Vector3d(header.spacing.data());
    description.lattice.origin = Eigen::Vector3d(header.origin.data());
    description.sampleType = static_cast<SampleType>(header.sampleType);
    description.range = {header.valueRange[0], header.valueRange[1]};
    description.bounds = {Eigen::Vector3d(header.boundingBox.data()), Eigen::Vector3d(header.boundingBox.data() + 3)};
    description.warpingWeight = header.warpingWeight;
    description.leftHanded = header.leftHanded != 0;
    description.sourceHash = header.sourceHash;
    return description;
}

Header headerOf(const ModelDescription& description)
{
    const Lattice& lattice = description.lattice;
    const Eigen::AlignedBox3d& box = description.bounds;
    Header header;
    header.domainClass = static_cast<std::uint32_t>(description.domain);
    header.sampleType = static_cast<std::uint32_t>(description.sampleType);
    header.latticeSize = lattice.size;
    std::copy_n(lattice.spacing.data(), 3, header.spacing.begin());
    std::copy_n(lattice.origin.data(), 3, header.origin.begin());
    header.valueRange = {description.range.minimum, description.range.maximum};
    std::copy_n(box.min().data(), 3, header.boundingBox.begin());
    std::copy_n(box.max().data(), 3, header.boundingBox.begin() + 3);
    header.warpingWeight = description.warpingWeight;
    // Of a lattice the frame says it.
    header.leftHanded = description.domain == DomainClass::Curvilinear && description.leftHanded ? 1 : 0;
    if (!frameSections(description).empty())
        header.minorVersion = format::minorVersionWithFrame;
    header.sourceHash = description.sourceHash;
    return header;
}

namespace {

constexpr std::string_view parameterPrefix = "parameter.";
constexpr std::string_view takenPrefix = "taken.", guessPrefix = "guess.", leftOutPrefix = "left.";

std::string escaped(std::string_view text, bool isKey)
{
    std::string result;
    for (const char character : text) {
        if (character == '\\')
            result += "\\\\";
        else if (character == '\n')
            result += "\\n";
        else if (character == '=' && isKey)
            result += "\\e";
        else
            result += character;
    }
    return result;
}

std::string unescaped(std::string_view text)
{
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '\\' || i + 1 == text.size()) {
            result += text[i];
            continue;
        }
        ++i;
        result += text[i] == 'n' ? '\n' : text[i] == 'e' ? '=' : text[i];
    }
    return result;
}

void appendLine(std::string& text, std::string_view key, std::string_view value)
{
    text += escaped(key, true) + "=" + escaped(value, false) + "\n";
}

/// Of a part that a later version knows nothing is told.
void readTaken(std::string_view key, std::string value, ModelDescription& description)
{
    const bool guessed = key.starts_with(guessPrefix);
    const std::string_view name = key.substr((guessed ? guessPrefix : takenPrefix).size());
    for (auto number = 0U; number <= static_cast<unsigned>(TakenPart::Fill); ++number)
        if (const auto part = static_cast<TakenPart>(number); takenPartName(part) == name)
            description.taken.push_back({part, std::move(value), guessed});
}

void appendProvenance(std::string& text, const ModelDescription& description)
{
    for (const Taken& taken : description.taken)
        appendLine(text,
                   std::string(taken.guessed ? guessPrefix : takenPrefix) + std::string(takenPartName(taken.part)),
                   taken.what.text());
    for (std::size_t number = 0; number < description.leftOut.size(); ++number)
        appendLine(text, std::string(leftOutPrefix) + std::to_string(number + 1), description.leftOut[number].text());
}

void readLine(std::string_view line, ModelDescription& description)
{
    const std::size_t separator = line.find('=');
    if (separator == std::string_view::npos)
        return;
    const std::string key = unescaped(line.substr(0, separator));
    std::string value = unescaped(line.substr(separator + 1));
    if (key == "source")
        description.sourceName = std::move(value);
    else if (key == "value.name")
        description.valueName = std::move(value);
    else if (key == "length.unit")
        description.lengthUnit = std::move(value);
    else if (key == "space")
        description.space = std::move(value);
    else if (key == "builder")
        description.builder = std::move(value);
    else if (key.starts_with(leftOutPrefix))
        description.leftOut.emplace_back(std::move(value));
    else if (key.starts_with(takenPrefix) || key.starts_with(guessPrefix))
        readTaken(key, std::move(value), description);
    else if (key.starts_with(parameterPrefix))
        description.parameters.emplace_back(key.substr(parameterPrefix.size()), std::move(value));
}

} // namespace

void describeSource(ModelDescription& description, const Dataset& dataset)
{
    description.domain = dataset.domain;
    description.lattice = dataset.lattice;
    description.bounds = dataset.bounds();
    description.leftHanded =
        dataset.domain == DomainClass::Curvilinear ? isLeftHanded(dataset) : dataset.lattice.isLeftHanded();
    description.sampleType = dataset.values.type();
    description.range = dataset.values.range();
    description.space = dataset.space;
    description.lengthUnit = dataset.lengthUnit;
    description.sourceName = dataset.source.name;
    description.sourceHash = dataset.source.hash;
    description.valueName = dataset.source.valueName;
    description.taken = dataset.source.taken;
    description.leftOut = dataset.source.leftOut;
}

Result<std::string> textOf(const ModelDescription& description, const std::filesystem::path& target)
{
    std::string text;
    appendLine(text, "source", description.sourceName);
    if (!description.valueName.empty())
        appendLine(text, "value.name", description.valueName);
    appendProvenance(text, description);
    appendLine(text, "builder", description.builder);
    if (!description.space.empty())
        appendLine(text, "space", description.space);
    if (!description.lengthUnit.empty())
        appendLine(text, "length.unit", description.lengthUnit);
    for (const auto& [name, value] : description.parameters)
        appendLine(text, std::string(parameterPrefix) + name, value);
    if (text.size() > format::longestText)
        return Error{
            ErrorKind::OutOfResource,
            Message::say(
                "Cannot write '%1': the names and parameters of the model are longer than 1 MiB. Shorten them.",
                target.string())};
    return text;
}

void readText(std::string_view text, ModelDescription& description)
{
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        readLine(text.substr(0, end), description);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
}

} // namespace tetra
