// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/packed/parts.h"

#include "core/base/checksum.h"
#include "core/base/finished_file.h"
#include "core/base/work_folder.h"
#include "core/build/model_build.h"
#include "core/history/derived_sections.h"
#include "core/history/lattice_frame.h"
#include "core/history/section_writer.h"
#include "core/packed/parts_history.h"
#include "core/packed/range_coder.h"
#include "core/packed/replay.h"
#include "core/packed/site_replay.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

namespace tetra {

using format::Fault;
using format::Header;
using format::Section;
using format::SectionId;

namespace {

constexpr MarkedText packingParts = Message::marked("Packing the model");
constexpr MarkedText unpackingParts = Message::marked("Unpacking the model");

/// What a chunk holds. A record that is longer than a chunk may be goes on in the next one.
enum class PartKind : std::uint32_t {
    GoesOn = 1,   ///< the record's end is not in this chunk
    Facts = 2,    ///< PartFacts; the first record
    History = 3,  ///< some groups; of all chunks of the history, in order
    Rest = 4,     ///< what the whole file has besides; the last record, behind all levels
    Sites = 5,    ///< in place of History: the sites alone, from which the history follows
    OwnBounds = 6 ///< then, behind all sites: those of all tetrahedra, as far as they do not follow
};

/// In front of a History or Sites record.
struct PieceHead {
    std::uint32_t sites = 0; ///< of the piece
    float endKey = 0;        ///< the key of the mesh behind it, if that has one
};
static_assert(sizeof(PieceHead) == 8);

/// What the prefixes of a model need besides the history.
struct PartFacts {
    std::uint32_t coordinateBytes = 0;
    bool decimals = false;
    std::array<std::uint32_t, 3> blockCells{};
    std::vector<Fault> faultsOfCells;
};

/// Plain numbers and bytes of sections, by either coder.
template <class Coder> class PlainCoder {
public:
    explicit PlainCoder(Coder& coder) : coder_(coder) {}

    template <class T> T number(T truth)
    {
        return static_cast<T>(numbers_.code(coder_, static_cast<std::uint64_t>(truth)));
    }

    /// Elements of `size` bytes, each as the difference to the one before, the highest byte first.
    void elements(std::span<std::byte> bytes, std::size_t size)
    {
        constexpr std::size_t mostLanes = 32;
        const std::size_t lanes = std::min(std::max<std::size_t>(size, 1), mostLanes);
        std::vector<BitModel> models(lanes * 2 * 256);
        bool quiet = true; // whether the byte before was as in the element before
        for (std::size_t first = 0; first < bytes.size(); first += lanes)
            for (std::size_t lane = std::min(lanes, bytes.size() - first); lane-- > 0;) {
                const std::size_t at = first + lane;
                const unsigned before = at >= lanes ? std::to_integer<unsigned>(bytes[at - lanes]) : 0;
                const unsigned truth = (std::to_integer<unsigned>(bytes[at]) - before) & 255;
                BitModel* const tree = models.data() + (lane * 2 + (quiet ? 1 : 0)) * 256;
                unsigned node = 1;
                for (unsigned bit = 8; bit-- > 0;)
                    node = node << 1 | (codedBit(coder_, tree[node], (truth >> bit & 1) != 0) ? 1u : 0u);
                quiet = (node & 255) == 0;
                bytes[at] = std::byte((node + before) & 255);
            }
    }

private:
    Coder& coder_;
    NumberModel numbers_;
};

/// What is read is checked by whoever asks for it; it is no longer than the bytes that tell it.
template <class Coder> void codeFacts(Coder& coder, PartFacts& facts, std::uint64_t mostFaults)
{
    PlainCoder<Coder> plain(coder);
    facts.coordinateBytes = plain.number(facts.coordinateBytes);
    facts.decimals = plain.template number<std::uint32_t>(facts.decimals ? 1 : 0) != 0;
    for (std::uint32_t& cells : facts.blockCells)
        cells = plain.number(cells);
    const std::uint64_t count = std::min(plain.template number<std::uint64_t>(facts.faultsOfCells.size()), mostFaults);
    std::uint64_t before = 0;
    for (std::uint64_t i = 0; i < count; ++i) {
        if constexpr (std::is_same_v<Coder, RangeDecoder>) {
            if (coder.overrun())
                return;
            facts.faultsOfCells.emplace_back();
        }
        Fault& fault = facts.faultsOfCells[i];
        fault.kind = plain.number(fault.kind);
        // The second kind begins anew.
        const std::uint64_t coded = plain.template number<std::uint64_t>(fault.number - before);
        before = fault.number = before + coded;
    }
}

HistoryFacts factsOf(const Header& header, const ModelDescription& description, const PartFacts& known)
{
    HistoryFacts facts;
    facts.domain = description.domain;
    facts.sampleType = description.sampleType;
    facts.lattice = description.lattice;
    facts.lattice.spacing = description.meshSpacing();
    facts.coordinateBytes = known.coordinateBytes;
    facts.decimals = known.decimals;
    facts.delaunay = description.delaunay;
    facts.extent = description.range.extent();
    facts.diagonal = description.bounds.diagonal().norm();
    facts.warpingWeight = description.warpingWeight;
    facts.siteCount = header.siteCount;
    facts.tetrahedronCount = header.tetrahedronCount;
    return facts;
}

SiteFacts siteFactsOf(const HistoryFacts& history, const ModelDescription& description, const PartFacts& known)
{
    SiteFacts facts;
    facts.history = history;
    const Eigen::AlignedBox3d& bounds = description.bounds;
    facts.grid = tetra::factsOf(description.leftHanded ? -1 : 1,
                                std::max(std::abs(description.range.minimum), std::abs(description.range.maximum)),
                                std::max(bounds.min().cwiseAbs().maxCoeff(), bounds.max().cwiseAbs().maxCoeff()));
    std::uint64_t cells = 1;
    for (const std::uint32_t size : description.lattice.size)
        cells *= std::max(size, 1u) - 1;
    for (const Fault& fault : known.faultsOfCells)
        if (fault.kind == static_cast<std::uint32_t>(format::FaultKind::FoldedCell) && fault.number < cells)
            facts.foldedCells.push_back(fault.number);
    return facts;
}

/// A history as the sections of a file, and what there is besides.
struct WrittenModel {
    const HistoryArrays& arrays;
    const ModelDescription& description;
    const PartFacts& facts;
    float finalKey = 0;
    std::span<const std::byte> samples; ///< empty: none
    std::span<const std::byte> samplePositions;
};

/// The bytes of an array that every model has.
std::span<const std::byte> bytesOfArray(const WrittenModel& model, SectionId id)
{
    const HistoryArrays& arrays = model.arrays;
    static constexpr auto closedSetsOnly = format::HistoryKind::ClosedSetsOnly;
    switch (id) {
    case SectionId::SitePoints: return std::as_bytes(std::span(arrays.points));
    case SectionId::SiteValues: return arrays.values;
    case SectionId::SiteRunningKeys: return std::as_bytes(std::span(arrays.runningKeys));
    case SectionId::StarOffsets: return std::as_bytes(std::span(arrays.starOffsets));
    case SectionId::MeshSizes: return std::as_bytes(std::span(arrays.meshSizes));
    case SectionId::SiteGroups: return std::as_bytes(std::span(arrays.groupGoesOn));
    case SectionId::SitePositions: return arrays.positions;
    case SectionId::Samples: return model.samples;
    case SectionId::SamplePositions: return model.samplePositions;
    case SectionId::OtherSites: return std::as_bytes(std::span(arrays.otherSites));
    case SectionId::Destroyers: return std::as_bytes(std::span(arrays.destroyers));
    case SectionId::OwnErrors: return std::as_bytes(std::span(arrays.ownErrors));
    case SectionId::OwnWarpings: return std::as_bytes(std::span(arrays.ownWarpings));
    case SectionId::HistoryKind:
        return model.description.delaunay ? std::span<const std::byte>() : std::as_bytes(std::span(&closedSetsOnly, 1));
    default: return {};
    }
}

/// The arrays that the model has, in the order in which they lie in the file that was packed.
std::vector<PlannedSection> sectionsOf(const WrittenModel& model, std::span<const std::uint32_t> order)
{
    const std::size_t sample = sampleSize(model.description.sampleType);
    const std::size_t position = 3 * std::size_t(model.facts.coordinateBytes);
    std::vector<PlannedSection> all{
        {SectionId::OtherSites, 12},     {SectionId::SitePoints, 4},  {SectionId::SiteValues, sample},
        {SectionId::SiteRunningKeys, 4}, {SectionId::StarOffsets, 8}, {SectionId::MeshSizes, 4},
        {SectionId::SiteGroups, 1},      {SectionId::Destroyers, 4},  {SectionId::OwnErrors, 2}};
    if (!model.description.delaunay)
        all.push_back({SectionId::HistoryKind, sizeof(format::HistoryKind)});
    if (position > 0)
        all.push_back({SectionId::SitePositions, position});
    if (canWarp(model.description.domain))
        all.push_back({SectionId::OwnWarpings, 2});
    if (!model.samplePositions.empty())
        all.push_back({SectionId::SamplePositions, position, 0, 0});
    if (!model.samples.empty())
        all.push_back({SectionId::Samples, sample, 0, 0});
    for (PlannedSection& section : all)
        section.count = bytesOfArray(model, section.id).size() / section.elementBytes;
    std::ranges::stable_sort(all, {}, [&](const PlannedSection& section) {
        return std::ranges::find(order, static_cast<std::uint32_t>(section.id)) - order.begin();
    });
    return all;
}

Status writeModelFile(const WrittenModel& model, std::span<const std::uint32_t> order,
                      const std::filesystem::path& output)
{
    const Result<std::string> text = textOf(model.description, output);
    if (!text)
        return text.error();
    Result<FileWriter> file = FileWriter::create(output);
    if (!file)
        return file.error();
    SectionWriter sections(*std::move(file));
    std::vector front{PlannedSection{SectionId::LevelIndex, sizeof(format::LevelEntry), format::mostLevels, 0, true}};
    const std::vector<FrameSection> frame = frameSections(model.description);
    for (const FrameSection& section : frame)
        front.push_back({section.id, sizeof(double), section.numbers.size()});
    front.push_back({SectionId::Text, 1, text->size()});
    const std::vector<PlannedSection> planned = sectionsOf(model, order);
    for (const std::span<const PlannedSection> part : {std::span<const PlannedSection>(front), std::span(planned)})
        if (const Status laidOut = sections.plan(part); !laidOut)
            return laidOut;
    for (const FrameSection& section : frame)
        if (const Status written = sections.add(section.id, std::as_bytes(std::span(section.numbers))); !written)
            return written;
    if (const Status written = sections.add(SectionId::Text, std::as_bytes(std::span(*text))); !written)
        return written;
    for (const PlannedSection& section : planned)
        if (const Status written = sections.add(section.id, bytesOfArray(model, section.id)); !written)
            return written;
    KnownFaults faults;
    const HistoryArrays& arrays = model.arrays;
    if (model.description.domain == DomainClass::Curvilinear) {
        faults.ofCells = model.facts.faultsOfCells;
        const auto place = [&]<class T>(T) {
            std::array<T, 3> coordinates{};
            for (std::size_t at = 0; at < arrays.positions.size(); at += sizeof coordinates) {
                std::memcpy(coordinates.data(), arrays.positions.data() + at, sizeof coordinates);
                faults.sitePositions.emplace_back(static_cast<double>(coordinates[0]),
                                                  static_cast<double>(coordinates[1]),
                                                  static_cast<double>(coordinates[2]));
            }
        };
        if (model.facts.coordinateBytes == 4)
            place(float());
        else
            place(double());
    }
    const FixedCounts counts{static_cast<std::uint32_t>(arrays.points.size()), arrays.otherSites.size()};
    const DerivedFrom from{.faults = &faults,
                           .description = model.description,
                           .counts = counts,
                           .finalKey = model.finalKey,
                           .blockCells = model.facts.blockCells};
    if (const Status derived = writeDerivedSections(sections, from); !derived)
        return derived;
    Header header = headerOf(model.description);
    header.siteCount = counts.sites;
    header.tetrahedronCount = counts.tetrahedra;
    header.finalKey = model.finalKey;
    return sections.finish(header);
}

/// The samples of a lattice that are no sites, one after the other; with put() back to where they belong.
class OtherSamples {
public:
    OtherSamples(std::uint64_t points, std::span<const std::uint32_t> sites) : isSite_(points)
    {
        for (const std::uint32_t point : sites)
            if (point < points)
                isSite_[point] = true;
    }

    std::vector<std::byte> take(std::span<const std::byte> samples, std::size_t size) const
    {
        std::vector<std::byte> taken;
        for (std::uint64_t point = 0; point < isSite_.size(); ++point)
            if (!isSite_[point])
                taken.insert(taken.end(), samples.begin() + static_cast<std::ptrdiff_t>(point * size),
                             samples.begin() + static_cast<std::ptrdiff_t>((point + 1) * size));
        return taken;
    }

    std::uint64_t count() const { return static_cast<std::uint64_t>(std::ranges::count(isSite_, false)); }

    std::vector<std::byte> put(std::span<const std::byte> others, std::span<const std::uint32_t> sites,
                               std::span<const std::byte> ofSites, std::size_t size) const
    {
        std::vector<std::byte> samples(isSite_.size() * size);
        const std::byte* next = others.data();
        for (std::uint64_t point = 0; point < isSite_.size(); ++point)
            if (!isSite_[point]) {
                std::memcpy(samples.data() + point * size, next, size);
                next += size;
            }
        for (std::size_t site = 0; site < sites.size(); ++site)
            std::memcpy(samples.data() + sites[site] * size, ofSites.data() + site * size, size);
        return samples;
    }

private:
    std::vector<bool> isSite_;
};

/// Which samples the whole file has (sections 23, 24).
struct KeptSamples {
    std::vector<std::byte> values;
    std::vector<std::byte> positions;
};

/// What the Rest record holds, of sections that are not made again from the history as they were: the header with the
/// table, and their bytes.
struct Differences {
    Header header;
    std::vector<Section> table;
    std::vector<std::uint8_t> isStored; ///< of each section; others are in the model that was made again
};

/// Writes records as chunks.
class RecordWriter {
public:
    explicit RecordWriter(PackedFileWriter& file) : file_(file) {}

    Status add(PartKind kind, std::span<const std::byte> record)
    {
        while (record.size() > format::mostPackedChunkBytes) {
            if (const Status added = file_.addChunk(static_cast<std::uint32_t>(PartKind::GoesOn),
                                                    record.first(format::mostPackedChunkBytes));
                !added)
                return added;
            record = record.subspan(format::mostPackedChunkBytes);
        }
        return file_.addChunk(static_cast<std::uint32_t>(kind), record);
    }

private:
    PackedFileWriter& file_;
};

/// Reads them.
class RecordReader {
public:
    RecordReader(const PackedFile& file, std::uint64_t bytes) : file_(file), chunks_(file, bytes) {}

    /// The next record's kind; nothing at the end of the chunks.
    Result<std::optional<PartKind>> next(const Progress& progress)
    {
        record_.clear();
        for (;;) {
            const Result<bool> more = chunks_.next(progress);
            if (!more.ok())
                return more.error();
            if (!*more && record_.empty())
                return std::optional<PartKind>();
            if (!*more)
                return file_.damaged(Message::say("a chunk is cut short"));
            record_.insert(record_.end(), chunks_.bytes().begin(), chunks_.bytes().end());
            if (chunks_.kind() != static_cast<std::uint32_t>(PartKind::GoesOn))
                return std::optional(static_cast<PartKind>(chunks_.kind()));
        }
    }
    std::span<const std::byte> record() const noexcept { return record_; }
    std::uint64_t place() const noexcept { return chunks_.place(); }

private:
    const PackedFile& file_;
    PackedChunkReader chunks_;
    std::vector<std::byte> record_;
};

// Packing.

/// Whoever packs reads every array as a whole.
Status checkArrays(const Model& model, const Progress& progress)
{
    if (const Status intact =
            model.checkPrefix(model.siteCount(), Model::Batches | Model::Stars | Model::OwnBounds, progress);
        !intact)
        return intact;
    for (const std::span<const std::byte> bytes :
         {std::as_bytes(model.points()), model.values(), std::as_bytes(model.floatPositions()),
          std::as_bytes(model.doublePositions()), model.samples(), std::as_bytes(model.floatSamplePositions()),
          std::as_bytes(model.doubleSamplePositions())})
        if (const Status intact = model.check(bytes, progress); !intact)
            return intact;
    return model.confirm(progress);
}

/// What is followed while packing leads where it should. Whether it is a mesh shows on the way.
bool isHistory(const Model& model)
{
    const std::uint64_t points = model.description().lattice.pointCount();
    if (std::ranges::any_of(model.points(), [&](std::uint32_t point) { return point >= points; }))
        return false;
    const auto offsets = model.starOffsets();
    if (offsets.front() != 0 || offsets.back() != model.tetrahedronCount() || !std::ranges::is_sorted(offsets))
        return false;
    for (std::uint32_t site = 0; site < model.siteCount(); ++site)
        for (std::uint64_t t = offsets[site]; t < offsets[site + std::size_t(1)]; ++t) {
            const std::uint32_t destroyer = model.destroyers()[t];
            if (std::ranges::max(model.otherSites()[t]) >= site || destroyer <= site ||
                (destroyer >= model.siteCount() && destroyer != Model::never))
                return false;
        }
    return true;
}

/// Unpacking puts sections together that have the checksums of the table, and zeros between them.
Status checkSections(const Model& model, const FileLayout& layout)
{
    const std::span<const std::byte> file = model.fileBytes();
    const auto damaged = [&](const Message& what) {
        return Error{
            ErrorKind::BadInput,
            Message::say("'%1' is damaged: %2. Copy the file again, or build it again.", model.path().string(), what),
            model.path()};
    };
    std::uint64_t end = sizeof(Header) + layout.sections.size() * sizeof(Section);
    for (const Section& section : layout.sections) {
        if (std::ranges::any_of(file.subspan(end, section.offset - end),
                                [](std::byte byte) { return byte != std::byte(0); }))
            return damaged(Message::say("something precedes section '%1'", format::sectionName(section.id)));
        if (checksum(file.subspan(section.offset, section.bytes)) != section.checksum)
            return damaged(Message::say("the checksum of section '%1' is wrong", format::sectionName(section.id)));
        end = section.offset + section.bytes;
    }
    return {};
}

/// Whether codeFacts() has a code for each step from one to the next, and reads as many of them.
bool canBeCoded(std::span<const Fault> faults, const ModelDescription& about)
{
    if (about.domain != DomainClass::Curvilinear || faults.size() > 2 * about.lattice.pointCount())
        return false;
    std::uint64_t before = 0;
    return std::ranges::none_of(faults, [&](const Fault& fault) {
        return fault.number + 1 == std::exchange(before, fault.number) || fault.reserved != 0;
    });
}

Error cannotBePacked(const Model& model)
{
    return {ErrorKind::BadInput,
            Message::say("'%1' cannot be packed: its history is not that of a mesh. 'tan verify' gives details.",
                         model.path().string())};
}

PartFacts partFactsOf(const Model& model)
{
    PartFacts facts;
    facts.coordinateBytes = !model.floatPositions().empty() ? 4 : !model.doublePositions().empty() ? 8 : 0;
    facts.decimals = facts.coordinateBytes > 0 && hasDecimals(model);
    const DerivedSections derived = derivedSections(model);
    if (derived.blockCells.size() == 3)
        std::ranges::copy(derived.blockCells, facts.blockCells.begin());
    if (derived.faults)
        for (const Fault& fault : *derived.faults)
            if (fault.kind != static_cast<std::uint32_t>(format::FaultKind::InvertedTetrahedron))
                facts.faultsOfCells.push_back(fault);
    if (!canBeCoded(facts.faultsOfCells, model.description()))
        facts.faultsOfCells.clear(); // then the section comes as it is
    return facts;
}

/// Where a level of the packed model ends.
struct LevelPlan {
    std::uint32_t sites = 0;
    float key = 0; ///< of the mesh there
    float error = 0;
    float warping = 0;
};

/// Levels of some thousand tetrahedra, the first ones of fewer, each to the end of a batch.
std::vector<LevelPlan> planLevels(const Model& model)
{
    constexpr std::uint64_t fewest = 1 << 11, most = 3 << 13, mostLevels = format::mostPackedLevels - 100;
    const std::uint64_t usual = std::max(most, model.tetrahedronCount() / mostLevels);
    const auto keys = model.runningKeys();
    const auto offsets = model.starOffsets();
    const bool warps = model.description().warpingWeight > 0;
    std::vector<LevelPlan> levels;
    std::size_t batch = 0;
    std::uint64_t begin = 0;
    for (std::uint32_t site = 0; site < model.siteCount(); ++site) {
        const bool isLast = site + 1 == model.siteCount();
        const float key = isLast ? model.finalKey() : keys[site + 1];
        if (!isLast && key == keys[site])
            continue;
        const std::size_t number = batch++;
        const std::uint64_t created = offsets[site + std::size_t(1)];
        if (!isLast && (!std::isfinite(key) || created - begin < std::clamp(begin / 4, fewest, usual)))
            continue;
        begin = created;
        const bool isTold = warps && number < model.batchErrors().size() && number < model.batchWarpings().size();
        LevelPlan& level = levels.emplace_back();
        level.sites = site + 1;
        level.key = key;
        level.error = isTold ? model.batchErrors()[number] : key;
        const double byKey = warps ? static_cast<double>(key) / model.description().warpingWeight : 0;
        level.warping = isTold  ? model.batchWarpings()[number]
                        : warps ? std::nextafter(static_cast<float>(byKey), std::numeric_limits<float>::infinity())
                                : 0;
    }
    // What one claims holds for those behind it.
    for (std::size_t i = levels.size() - 1; i-- > 0;) {
        levels[i].error = std::max(levels[i].error, levels[i + 1].error);
        levels[i].warping = std::max(levels[i].warping, levels[i + 1].warping);
    }
    return levels;
}

/// The end of a piece of the history: of a group, behind some thousand tetrahedra.
std::uint32_t pieceEnd(const Model& model, std::uint32_t begin, std::uint32_t levelEnd)
{
    constexpr std::uint64_t most = 1 << 15;
    std::uint32_t end = begin;
    while (end < levelEnd) {
        while (end + 1 < levelEnd && model.groupGoesOn()[end] != 0)
            ++end;
        ++end;
        if (model.starOffsets()[end] - model.starOffsets()[begin] >= most)
            break;
    }
    return end;
}

std::span<const std::byte> sectionBytes(std::span<const std::byte> file, const Section& section)
{
    return file.subspan(section.offset, section.bytes);
}

/// The most bytes that a file can have whose parts make one of `ofMade` bytes. What it holds besides is in memory for a
/// while, so a larger file is refused.
std::uint64_t mostBytes(std::uint64_t ofMade)
{
    return 2 * ofMade + (std::uint64_t(1) << 26);
}

/// Compares the model with what is made of its parts.
Result<std::optional<Differences>> compare(const Model& model, const std::filesystem::path& made)
{
    const auto remade = MappedFile::open(made);
    if (!remade)
        return remade.error();
    const std::span<const std::byte> before = model.fileBytes(), after = (*remade)->bytes();
    if (std::ranges::equal(before, after))
        return std::optional<Differences>();
    if (before.size() > mostBytes(after.size()))
        return Error{ErrorKind::BadInput,
                     Message::say("'%1' cannot be packed: most of it is in sections that this version does not know.",
                                  model.path().string())};
    const auto layout = readLayout(before, model.path());
    if (!layout)
        return layout.error();
    const auto remadeLayout = readLayout(after, made);
    if (!remadeLayout)
        return remadeLayout.error();
    Differences differences{layout->header, layout->sections, {}};
    for (const Section& section : differences.table) {
        const auto id = static_cast<SectionId>(section.id);
        const bool isMade = remadeLayout->has(id) && std::ranges::equal(sectionBytes(before, section),
                                                                        sectionBytes(after, remadeLayout->section(id)));
        differences.isStored.push_back(isMade ? 0 : 1);
    }
    return std::optional(std::move(differences));
}

/// What is read of it is checked when it is put together.
template <class Coder>
void codeRest(PlainCoder<Coder>& plain, std::optional<Differences>& differences, std::uint32_t mostSections)
{
    if (plain.template number<std::uint32_t>(differences ? 1 : 0) == 0) {
        differences.reset();
        return;
    }
    if (!differences)
        differences.emplace();
    plain.elements(std::as_writable_bytes(std::span(&differences->header, 1)), 8);
    const std::uint32_t count =
        std::min(plain.number(static_cast<std::uint32_t>(differences->table.size())), mostSections);
    differences->table.resize(count);
    differences->isStored.resize(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        plain.elements(std::as_writable_bytes(std::span(&differences->table[i], 1)), 8);
        differences->isStored[i] = plain.number(differences->isStored[i]);
    }
}

class PartsPacker {
public:
    PartsPacker(const Model& model, PackedFileWriter& file, const Progress& progress)
        : model_(model), file_(file), records_(file), progress_(progress)
    {
    }

    Result<PackReport> run()
    {
        if (const Status intact = checkArrays(model_, progress_); !intact)
            return intact.error();
        const auto layout = readLayout(model_.fileBytes(), model_.path());
        if (!layout)
            return layout.error();
        if (const Status whole = checkSections(model_, *layout); !whole)
            return whole.error();
        if (!isHistory(model_))
            return cannotBePacked(model_);
        for (const Section& section : layout->sections)
            order_.push_back(section.id);
        facts_ = partFactsOf(model_);
        RangeEncoder coder;
        codeFacts(coder, facts_, std::numeric_limits<std::uint64_t>::max());
        if (const Status added = records_.add(PartKind::Facts, coder.finish()); !added)
            return added.error();
        const HistoryFacts facts = factsOf(layout->header, model_.description(), facts_);
        const auto bySites = historyOfSites(siteFactsOf(facts, model_.description(), facts_));
        if (!bySites)
            return bySites.error();
        if (*bySites)
            return packSites(**bySites, siteFactsOf(facts, model_.description(), facts_));
        HistoryEncoder encoder(model_, facts);
        if (const Status packed = packHistory(encoder); !packed)
            return packed.error();
        if (const Status packed = packRest(encoder.arrays()); !packed)
            return packed.error();
        return reportOf(encoder.cost());
    }

private:
    static PackReport reportOf(const HistoryCost& cost)
    {
        PackReport report;
        report.method = PackMethod::StoredByParts;
        report.positions = cost.positions;
        report.values = cost.values;
        report.accuracy = cost.accuracy;
        report.ownErrors = cost.ownErrors;
        return report;
    }

    /// A history that follows from its sites, and its own bounds, coded.
    struct SiteHistory {
        HistoryArrays history;
        std::vector<std::byte> ownBounds;
    };

    /// Nothing if the model's is not such a one.
    Result<std::optional<SiteHistory>> historyOfSites(const SiteFacts& facts)
    {
        if (!maySitesTell(model_) || facts_.blockCells != std::array<std::uint32_t, 3>{})
            return std::optional<SiteHistory>();
        auto samples = allocateSamples(facts.history.sampleType, facts.history.lattice.pointCount());
        if (!samples)
            return samples.error();
        KnownSites sites(facts, *std::move(samples));
        const std::span<const std::uint32_t> points = model_.points();
        for (const std::uint32_t point : points) {
            if (point >= sites.pointCount() || sites.isKnown(point))
                return std::optional<SiteHistory>();
            sites.setKnown(point);
        }
        const auto scatter = [points](std::span<const std::byte> from, std::size_t size, std::span<std::byte> to) {
            for (std::size_t site = 0; size > 0 && site < points.size(); ++site)
                std::memcpy(to.data() + points[site] * size, from.data() + site * size, size);
        };
        scatter(model_.values(), sites.sampleBytes(), sites.samples());
        scatter(model_.floatPositions().empty() ? std::as_bytes(model_.doublePositions())
                                                : std::as_bytes(model_.floatPositions()),
                3 * sites.coordinateBytes(), sites.positions());
        auto history = sites.history(progress_.part(0, triedAt));
        if (!history && history.error().kind == ErrorKind::Cancelled)
            return history.error();
        if (!history || !sameButForBounds(*history, model_))
            return std::optional<SiteHistory>();
        SiteHistory found{*std::move(history), {}};
        found.ownBounds = encodeOwnBounds(facts, found.history, model_);
        if (!std::ranges::equal(found.history.ownErrors, model_.ownErrors()) ||
            !std::ranges::equal(found.history.ownWarpings, model_.ownWarpings()))
            return std::optional<SiteHistory>();
        return std::optional(std::move(found));
    }

    Result<PackReport> packSites(const SiteHistory& found, const SiteFacts& facts)
    {
        const auto encoder = SiteEncoder::make(model_, facts, progress_);
        if (!encoder)
            return encoder.error();
        std::uint32_t site = 0;
        for (const LevelPlan& level : planLevels(model_)) {
            const auto piece = (*encoder)->encode(level.sites, progress_);
            if (!piece)
                return piece.error();
            if (const Status added = addPiece(PartKind::Sites, {level.sites - site, level.key}, *piece); !added)
                return added.error();
            site = level.sites;
            if (site == model_.siteCount())
                if (const Status added = records_.add(PartKind::OwnBounds, found.ownBounds); !added)
                    return added.error();
            progress_.report(triedAt + (1 - triedAt) * site / model_.siteCount(), packingParts);
            file_.endLevel(level.error, level.warping, level.sites);
        }
        if (const Status packed = packRest(found.history); !packed)
            return packed.error();
        PackReport report = reportOf((*encoder)->cost());
        report.ownErrors = found.ownBounds.size();
        return report;
    }

    Status addPiece(PartKind kind, const PieceHead& head, std::span<const std::byte> piece)
    {
        std::vector<std::byte> record(sizeof head);
        std::memcpy(record.data(), &head, sizeof head);
        record.insert(record.end(), piece.begin(), piece.end());
        return records_.add(kind, record);
    }

    Status packHistory(HistoryEncoder& encoder)
    {
        std::uint32_t site = 0;
        for (const LevelPlan& level : planLevels(model_)) {
            while (site < level.sites) {
                const std::uint32_t end = pieceEnd(model_, site, level.sites);
                const auto piece = encoder.encode(end);
                if (!piece)
                    return piece.error();
                const PieceHead head{end - site,
                                     end < model_.siteCount() ? model_.runningKeys()[end] : model_.finalKey()};
                if (const Status added = addPiece(PartKind::History, head, *piece); !added)
                    return added;
                site = end;
                if (progress_.cancelled())
                    return cancelledError(packingParts);
                progress_.report(0.9 * site / model_.siteCount(), packingParts);
            }
            file_.endLevel(level.error, level.warping, level.sites);
        }
        return {};
    }

    /// The samples that are no sites. Gives all of them, as they come back with the sites'.
    KeptSamples codeSamples(PlainCoder<RangeEncoder>& plain, const HistoryArrays& arrays) const
    {
        const auto positions = !model_.floatSamplePositions().empty() ? std::as_bytes(model_.floatSamplePositions())
                                                                      : std::as_bytes(model_.doubleSamplePositions());
        KeptSamples kept;
        plain.number<std::uint32_t>(model_.samples().empty() ? 0 : positions.empty() ? 1 : 2);
        if (model_.samples().empty())
            return kept;
        const OtherSamples others(model_.description().lattice.pointCount(), arrays.points);
        const auto code = [&](std::span<const std::byte> samples, std::span<const std::byte> ofSites,
                              std::size_t size) {
            std::vector<std::byte> bytes = others.take(samples, size);
            plain.elements(bytes, size);
            return others.put(bytes, arrays.points, ofSites, size);
        };
        kept.values = code(model_.samples(), arrays.values, sampleSize(model_.description().sampleType));
        if (!positions.empty())
            kept.positions = code(positions, arrays.positions, 3 * std::size_t(facts_.coordinateBytes));
        return kept;
    }

    /// Makes the model again as unpacking does, and keeps what is not the same then.
    Status packRest(const HistoryArrays& arrays)
    {
        const Result<WorkFolder> folder = WorkFolder::open(workFolderOf(file_.target()), WorkFolder::Leftovers::Remove);
        if (!folder)
            return folder.error();
        const std::filesystem::path made = folder->path() / "model.tan";
        RangeEncoder coder;
        PlainCoder<RangeEncoder> plain(coder);
        const KeptSamples kept = codeSamples(plain, arrays);
        const WrittenModel written{arrays,      model_.description(), facts_, model_.finalKey(),
                                   kept.values, kept.positions};
        if (const Status wrote = writeModelFile(written, order_, made); !wrote)
            return wrote;
        Result<std::optional<Differences>> differences = compare(model_, made);
        if (!differences)
            return differences.error();
        codeRest(plain, *differences, format::mostSections);
        if (*differences)
            for (std::size_t i = 0; i < (*differences)->table.size(); ++i) {
                const Section& section = (*differences)->table[i];
                if ((*differences)->isStored[i] == 0)
                    continue;
                const std::span<const std::byte> bytes = sectionBytes(model_.fileBytes(), section);
                std::vector<std::byte> copy(bytes.begin(), bytes.end());
                plain.elements(copy, section.elementBytes);
            }
        return records_.add(PartKind::Rest, coder.finish());
    }

    const Model& model_;
    PackedFileWriter& file_;
    RecordWriter records_;
    const Progress& progress_;
    PartFacts facts_;
    std::vector<std::uint32_t> order_;
};

// Unpacking.

/// The file's records up to some chunk, decoded.
class PartsReader {
public:
    PartsReader(const PackedFile& file, std::uint64_t bytes, const Progress& progress)
        : file_(file), records_(file, bytes), progress_(progress)
    {
        for (const format::PackedSum& sum : file.sums())
            order_.push_back(sum.id);
    }

    /// The history of the first `sites` sites.
    Status readHistory(std::uint32_t sites)
    {
        if (const Status facts = readFacts(); !facts)
            return facts;
        std::optional<PartKind> kind;
        std::unique_ptr<SiteDecoder> sitesAlone;
        std::uint32_t site = 0;
        while (site < sites) {
            const auto found = records_.next(progress_);
            if (!found)
                return found.error();
            if (!*found || (kind ? **found != *kind : **found != PartKind::History && **found != PartKind::Sites))
                return damaged();
            if (!kind)
                if (const Status begun = beginDecoding(**found, sitesAlone); !begun)
                    return begun;
            kind = **found;
            PieceHead head;
            const std::span<const std::byte> record = records_.record();
            if (record.size() < sizeof head)
                return damaged();
            std::memcpy(&head, record.data(), sizeof head);
            if (head.sites == 0 || head.sites > sites - site)
                return damaged();
            const std::span<const std::byte> piece = record.subspan(sizeof head);
            const Result<bool> decoded = sitesAlone ? sitesAlone->decode(piece, head.sites, progress_)
                                                    : Result<bool>(decoder_->decode(piece, site + head.sites));
            if (!decoded.ok())
                return decoded.error();
            if (!*decoded)
                return damaged();
            site += head.sites;
            endKey_ = head.endKey;
            progress_.report((sitesAlone ? 0.4 : 0.9) * site / sites, unpackingParts);
        }
        if (!(endKey_ >= 0) || !std::isfinite(endKey_))
            return damaged();
        if (sitesAlone)
            if (const Status made = makeHistory(*sitesAlone, sites); !made)
                return made;
        return arrays().otherSites.empty() ? damaged() : Status();
    }

    WrittenModel model(const KeptSamples& kept) const
    {
        return {arrays(), file_.description(), facts_, endKey_, kept.values, kept.positions};
    }
    /// Whether the history that was made of its sites is the one that was packed: another version of the builder may
    /// make another one.
    bool isReproduced() const noexcept { return isReproduced_; }
    bool followsFromSites() const noexcept { return !decoder_; }
    /// Puts own bounds that hold whatever the other points are in place of those that were told.
    void boundByRunningKeys() { boundByKeys(historyFacts(), endKey_, sitesHistory_); }
    std::span<const std::uint32_t> order() const noexcept { return order_; }

    Status expect(PartKind kind)
    {
        const auto found = records_.next(progress_);
        if (!found)
            return found.error();
        return *found && **found == kind ? Status() : damaged();
    }
    std::span<const std::byte> record() const noexcept { return records_.record(); }
    Status damaged() const { return file_.damaged(Message::say("its content is not a history")); }

private:
    /// Of the history that was read.
    const HistoryArrays& arrays() const noexcept { return decoder_ ? decoder_->arrays() : sitesHistory_; }

    Status readFacts()
    {
        if (const Status read = expect(PartKind::Facts); !read)
            return read;
        const DomainClass domain = file_.description().domain;
        RangeDecoder coder(records_.record());
        codeFacts(coder, facts_, domain == DomainClass::Curvilinear ? 2 * file_.description().lattice.pointCount() : 0);
        const bool right = domain == DomainClass::RegularLattice
                               ? facts_.coordinateBytes == 0
                               : facts_.coordinateBytes == 4 || facts_.coordinateBytes == 8;
        return right && !coder.overrun() ? Status() : damaged();
    }

    /// The decoder that records of this kind take.
    Status beginDecoding(PartKind kind, std::unique_ptr<SiteDecoder>& sitesAlone)
    {
        const HistoryFacts facts = historyFacts();
        if (kind != PartKind::Sites) {
            decoder_.emplace(facts);
            return {};
        }
        if (!isOnLattice(file_.description().domain) || !file_.description().delaunay)
            return damaged();
        auto made = SiteDecoder::make(siteFactsOf(facts, file_.description(), facts_), progress_);
        if (!made)
            return made.error();
        sitesAlone = *std::move(made);
        return {};
    }

    HistoryFacts historyFacts() const { return factsOf(file_.header(), file_.description(), facts_); }

    Status makeHistory(SiteDecoder& decoder, std::uint32_t sites)
    {
        const KnownSites& known = decoder.takeSites();
        auto history = known.history(progress_.part(0.4, 0.9));
        if (!history)
            return history.error().kind == ErrorKind::BadInput ? damaged() : Status(history.error());
        sitesHistory_ = *std::move(history);
        if (sitesHistory_.points.size() != sites)
            return damaged();
        if (sites < file_.header().siteCount) {
            boundByRunningKeys();
            return {};
        }
        if (const Status read = expect(PartKind::OwnBounds); !read)
            return read;
        const auto sum =
            std::ranges::find(file_.sums(), static_cast<std::uint32_t>(SectionId::OtherSites), &format::PackedSum::id);
        isReproduced_ =
            sum != file_.sums().end() && sum->checksum == checksum(std::as_bytes(std::span(sitesHistory_.otherSites)));
        if (!isReproduced_)
            boundByRunningKeys();
        else if (!decodeOwnBounds(known.facts(), records_.record(), sitesHistory_))
            return damaged();
        return {};
    }

    const PackedFile& file_;
    RecordReader records_;
    const Progress& progress_;
    std::vector<std::uint32_t> order_;
    PartFacts facts_;
    std::optional<HistoryDecoder> decoder_;
    HistoryArrays sitesHistory_; ///< of the sites alone
    bool isReproduced_ = true;
    float endKey_ = 0;
};

/// Puts the file together that differs from the one that is made of the parts.
class DifferencesWriter {
public:
    DifferencesWriter(const PackedFile& file, Differences& differences, const std::filesystem::path& made,
                      const std::filesystem::path& output)
        : file_(file), differences_(differences), made_(made), output_(output)
    {
    }

    Status run(PlainCoder<RangeDecoder>& plain)
    {
        const auto remade = MappedFile::open(made_);
        if (!remade)
            return remade.error();
        const auto layout = readLayout((*remade)->bytes(), made_);
        if (!layout)
            return layout.error();
        Result<FileWriter> file = FileWriter::create(output_);
        if (!file)
            return file.error();
        const std::uint64_t size = file_.facts().fileBytes;
        if (size > mostBytes((*remade)->bytes().size()))
            return damaged();
        std::uint64_t end = sizeof(Header) + differences_.table.size() * sizeof(Section);
        if (const Status extended = file->extend(std::max(size, end)); !extended)
            return extended;
        std::vector<std::byte> bytes;
        for (std::size_t i = 0; i < differences_.table.size(); ++i) {
            const Section& section = differences_.table[i];
            if (section.offset < end || section.bytes > size || section.offset > size - section.bytes)
                return damaged();
            end = section.offset + section.bytes;
            if (differences_.isStored[i] != 0) {
                bytes.assign(section.bytes, std::byte(0));
                plain.elements(bytes, section.elementBytes);
            } else {
                const auto id = static_cast<SectionId>(section.id);
                if (!layout->has(id) || layout->section(id).bytes != section.bytes)
                    return damaged();
                const auto from = sectionBytes((*remade)->bytes(), layout->section(id));
                bytes.assign(from.begin(), from.end());
            }
            if (checksum(bytes) != section.checksum)
                return damaged();
            if (const Status written = file->overwrite(section.offset, bytes); !written)
                return written;
        }
        if (end != size)
            return damaged();
        if (const Status written = file->overwrite(0, std::as_bytes(std::span(&differences_.header, 1))); !written)
            return written;
        if (const Status written = file->overwrite(sizeof(Header), std::as_bytes(std::span(differences_.table)));
            !written)
            return written;
        return file->commit();
    }

private:
    Status damaged() const { return file_.damaged(Message::say("its content is not a history")); }

    const PackedFile& file_;
    Differences& differences_;
    const std::filesystem::path& made_;
    const std::filesystem::path& output_;
};

} // namespace

Result<PackReport> packParts(const Model& model, PackedFileWriter& file, const Progress& progress)
{
    return PartsPacker(model, file, progress).run();
}

namespace {

/// The samples that the whole file has, if it has any.
Result<KeptSamples> readKeptSamples(PlainCoder<RangeDecoder>& plain, const PartsReader& reader,
                                    const ModelDescription& about)
{
    KeptSamples kept;
    const auto sampled = plain.number<std::uint32_t>(0);
    if (sampled == 0)
        return kept;
    if (sampled > 2 || !isOnLattice(about.domain) || (sampled == 2) != (about.domain == DomainClass::Curvilinear))
        return reader.damaged().error();
    const HistoryArrays& arrays = reader.model(kept).arrays;
    const OtherSamples others(about.lattice.pointCount(), arrays.points);
    const auto fill = [&](std::vector<std::byte>& samples, std::span<const std::byte> ofSites, std::size_t size) {
        std::vector<std::byte> bytes(others.count() * size);
        plain.elements(bytes, size);
        samples = others.put(bytes, arrays.points, ofSites, size);
    };
    fill(kept.values, arrays.values, sampleSize(about.sampleType));
    if (sampled == 2)
        fill(kept.positions, arrays.positions, arrays.positions.size() / arrays.points.size());
    return kept;
}

} // namespace

Result<UnpackReport> unpackParts(const PackedFile& file, const std::filesystem::path& output, const Progress& progress)
{
    PartsReader reader(file, file.chunks().size, progress);
    if (const Status read = reader.readHistory(file.header().siteCount); !read)
        return read.error();
    if (const Status read = reader.expect(PartKind::Rest); !read)
        return read.error();
    RangeDecoder coder(reader.record());
    PlainCoder<RangeDecoder> plain(coder);
    const Result<KeptSamples> kept = readKeptSamples(plain, reader, file.description());
    if (!kept)
        return kept.error();
    std::optional<Differences> differences;
    codeRest(plain, differences, static_cast<std::uint32_t>(file.sums().size()));
    WrittenModel model = reader.model(*kept);
    model.finalKey = file.header().finalKey;
    if (coder.overrun())
        return reader.damaged().error();
    const Result<WorkFolder> folder = WorkFolder::open(workFolderOf(output), WorkFolder::Leftovers::Remove);
    if (!folder)
        return folder.error();
    const std::filesystem::path made = folder->path() / "model.tan", put = folder->path() / "differences.tan";
    const std::filesystem::path* finished = &made;
    if (const Status written = writeModelFile(model, reader.order(), made); !written)
        return written.error();
    if (differences && reader.isReproduced()) {
        if (const Status written = DifferencesWriter(file, *differences, made, put).run(plain); !written)
            return written.error();
        finished = &put;
    }
    Result<UnpackReport> compared = compareSections(file, *finished);
    if (!compared)
        return compared.error();
    if (!compared->derived.empty() && !reader.followsFromSites())
        return reader.damaged().error();
    if (!compared->derived.empty() && reader.isReproduced()) {
        // What another version of the builder finds at the sites tells nothing of the other points.
        reader.boundByRunningKeys();
        if (const Status written = writeModelFile(model, reader.order(), made); !written)
            return written.error();
        finished = &made;
        compared = compareSections(file, made);
        if (!compared)
            return compared.error();
    }
    if (const Status replaced = replaceFile(*finished, output); !replaced)
        return replaced.error();
    progress.report(1, unpackingParts);
    return compared;
}

Status unpackPrefixOfParts(const PackedFile& file, std::size_t level, const std::filesystem::path& output,
                           const Progress& progress)
{
    const format::PackedLevelEntry& entry = file.levels()[level];
    PartsReader reader(file, entry.chunkBytes, progress);
    if (const Status read = reader.readHistory(entry.sites); !read)
        return read;
    const KeptSamples none;
    return writeModelFile(reader.model(none), reader.order(), output);
}

} // namespace tetra
