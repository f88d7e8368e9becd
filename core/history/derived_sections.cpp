// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/derived_sections.h"

#include "core/base/rounding.h"
#include "core/geometry/orientation.h"
#include "core/history/file_layout.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace tetra {

using format::Fault;
using format::FaultKind;
using format::LevelEntry;
using format::SectionId;

// Reading.

DerivedSections derivedSections(const Model& model)
{
    DerivedSections derived;
    const std::span<const std::byte> file = model.fileBytes();
    const Result<FileLayout> layout = readLayout(file, model.path());
    if (!layout) // changed since it was opened, which Model::checkUnchanged() tells
        return derived;
    const auto map = [&]<class T>(std::span<const T>& elements, SectionId id) {
        if (!layout->has(id))
            return;
        const format::Section& section = layout->section(id);
        elements = {reinterpret_cast<const T*>(file.data() + section.offset), section.bytes / sizeof(T)};
    };
    map(derived.levels, SectionId::LevelIndex);
    map(derived.batchEnds, SectionId::BatchEnds);
    map(derived.batchErrors, SectionId::BatchErrors);
    map(derived.batchWarpings, SectionId::BatchWarpings);
    map(derived.blockCells, SectionId::Blocks);
    if (layout->has(SectionId::Faults))
        map(derived.faults.emplace(), SectionId::Faults);
    map(derived.faultyCells, SectionId::FaultyCells);
    return derived;
}

// Writing.

std::vector<format::FaultyCell> faultyCellsOf(const Dataset& dataset)
{
    std::vector<format::FaultyCell> cells;
    if (dataset.faultyCells)
        for (const FaultyCell& one : *dataset.faultyCells) {
            if (one.corners.empty())
                continue;
            format::FaultyCell& cell = cells.emplace_back();
            cell.number = one.cell;
            cell.fault = static_cast<std::uint32_t>(one.fault);
            cell.corners = static_cast<std::uint32_t>(one.corners.size());
            for (std::size_t corner = 0; corner < one.corners.size(); ++corner)
                Eigen::Map<Eigen::Vector3d>(cell.places[corner].data()) = one.corners[corner];
        }
    return cells;
}

namespace {

/// The elements of a section that has been written, one after the other from its beginning on.
template <class Element> class WrittenElements {
public:
    WrittenElements(SectionWriter& sections, SectionId id, std::uint64_t count)
        : sections_(sections), id_(id), left_(count)
    {
    }

    /// 0 beyond the last one, and once something cannot be read, which status() tells.
    Element next()
    {
        if (at_ == buffer_.size())
            fill();
        return at_ < buffer_.size() ? buffer_[at_++] : Element{};
    }
    const Status& status() const noexcept { return status_; }

private:
    void fill()
    {
        constexpr std::uint64_t atOnce = (1 << 16) / sizeof(Element);
        at_ = 0;
        buffer_.resize(status_ ? std::min(atOnce, left_) : 0);
        if (buffer_.empty())
            return;
        status_ = sections_.read(id_, read_ * sizeof(Element), std::as_writable_bytes(std::span(buffer_)));
        read_ += buffer_.size();
        left_ -= buffer_.size();
        if (!status_)
            buffer_.clear();
    }

    SectionWriter& sections_;
    SectionId id_;
    std::uint64_t left_;
    std::uint64_t read_ = 0;
    std::vector<Element> buffer_;
    std::size_t at_ = 0;
    Status status_;
};

template <class Element> Status add(SectionWriter& sections, SectionId id, const std::vector<Element>& elements)
{
    return sections.add(id, std::as_bytes(std::span(elements)));
}

/// Chooses the meshes of the level index while the batches come: the first, the last, and between them the first whose
/// key is an eighth of an octave smaller, and so on.
class LevelChooser {
public:
    struct Chosen {
        std::uint32_t batch = 0;
        std::uint32_t sites = 0;
        float key = 0;
    };

    /// The mesh at the end of a batch, of so many sites.
    void add(std::uint32_t batch, std::uint32_t sites, float key, bool isLast)
    {
        const bool isFirst = chosen_.empty();
        if (isFirst)
            firstKey_ = static_cast<double>(key);
        const int before = step_;
        while (step_ < steps && static_cast<double>(key) <= firstKey_ * std::exp2(-step_ / 8.0))
            ++step_;
        if (isFirst || isLast || step_ > before)
            chosen_.push_back({batch, sites, key});
    }
    const std::vector<Chosen>& chosen() const noexcept { return chosen_; }

private:
    /// Of the two entries more one is the first mesh, one the last.
    static constexpr int steps = static_cast<int>(format::mostLevels) - 1;

    double firstKey_ = 0;
    int step_ = 1;
    std::vector<Chosen> chosen_;
};

/// The largest own bounds of the tetrahedra in the mesh at the end of a batch, while these are born batch by batch: a
/// Fenwick tree of maxima over the batches in which they die, the last ones first.
class LargestLiving {
public:
    struct Own {
        std::uint16_t error = 0;
        std::uint16_t warping = 0;
    };

    explicit LargestLiving(std::size_t batches) : nodes_(batches + 1) {}

    /// A tetrahedron that dies in batch `death`, or behind all.
    void add(std::size_t death, const Own& own)
    {
        for (std::size_t node = nodes_.size() - death; node < nodes_.size(); node += node & (~node + 1)) {
            Own& largest = nodes_[node];
            if (largest.error >= own.error && largest.warping >= own.warping)
                return; // as are all that follow
            raise(largest, own);
        }
    }
    /// Of those that outlive the batch.
    Own aliveAfter(std::size_t batch) const
    {
        Own largest;
        for (std::size_t node = nodes_.size() - 1 - batch; node > 0; node &= node - 1)
            raise(largest, nodes_[node]);
        return largest;
    }

private:
    static void raise(Own& largest, const Own& own)
    {
        largest = {std::max(largest.error, own.error), std::max(largest.warping, own.warping)};
    }

    std::vector<Own> nodes_;
};

class DerivedWriter {
public:
    DerivedWriter(SectionWriter& sections, const DerivedFrom& from)
        : sections_(sections), from_(from), weight_(from.description.warpingWeight)
    {
    }

    Status run()
    {
        if (const Status written = writeBatchEnds(); !written)
            return written;
        if (const Status planned = planSmallSections(); !planned)
            return planned;
        if (weight_ > 0)
            if (const Status written = writeBatchBounds(); !written)
                return written;
        if (const Status written = writeLevels(); !written)
            return written;
        if (from_.dataset != nullptr)
            if (const Status written = writeCellsLeftOut(); !written)
                return written;
        const bool knowsFaults = from_.dataset != nullptr || from_.faults != nullptr;
        return from_.description.domain == DomainClass::Curvilinear && knowsFaults ? writeFaults() : Status();
    }

private:
    Status writeBatchEnds();
    Status planSmallSections();
    Status writeBatchBounds();
    Status writeLevels();
    Status writeCellsLeftOut();
    Status writeFaults();
    Status addKnownCells();
    Status addFaultyCells();
    Status addInvertedTetrahedra();
    Status addFault(FaultKind kind, std::uint64_t number);
    template <class Element> WrittenElements<Element> perSite(SectionId id) const
    {
        return {sections_, id, from_.counts.sites + (id == SectionId::StarOffsets ? 1u : 0u)};
    }
    template <class Element> WrittenElements<Element> perTetrahedron(SectionId id) const
    {
        return {sections_, id, from_.counts.tetrahedra};
    }

    SectionWriter& sections_;
    const DerivedFrom& from_;
    const double weight_;
    LevelChooser levels_;
    // Of data that warp:
    std::vector<std::uint32_t> batches_; ///< of each site; the next are of each batch
    std::vector<float> keys_;
    std::vector<float> errors_;
    std::vector<float> warpings_;
};

/// A batch ends where the running key falls; the mesh there has the key to which it falls.
Status DerivedWriter::writeBatchEnds()
{
    if (const Status begun = sections_.grow(SectionId::BatchEnds, sizeof(std::uint32_t), 0); !begun)
        return begun;
    auto errors = perSite<float>(SectionId::SiteRunningKeys);
    constexpr std::size_t atOnce = 1 << 14;
    std::vector<std::uint32_t> ends;
    if (weight_ > 0)
        batches_.reserve(from_.counts.sites);
    std::uint32_t batch = 0;
    float error = errors.next();
    for (std::uint32_t site = 0; site < from_.counts.sites; ++site) {
        const bool isLast = site + 1 == from_.counts.sites;
        const float key = isLast ? from_.finalKey : errors.next();
        if (weight_ > 0)
            batches_.push_back(batch);
        if (!isLast && key == error)
            continue;
        error = key;
        levels_.add(batch++, site + 1, key, isLast);
        ends.push_back(site);
        if (weight_ > 0)
            keys_.push_back(key);
        if (ends.size() < atOnce && !isLast)
            continue;
        if (const Status written = add(sections_, SectionId::BatchEnds, ends); !written)
            return written;
        ends.clear();
    }
    return errors.status();
}

Status DerivedWriter::planSmallSections()
{
    std::vector<PlannedSection> sections;
    if (weight_ > 0)
        sections.insert(sections.end(), {{SectionId::BatchErrors, sizeof(float), keys_.size(), 0},
                                         {SectionId::BatchWarpings, sizeof(float), keys_.size(), 0}});
    if (from_.blockCells[0] > 0)
        sections.push_back({SectionId::Blocks, sizeof(std::uint32_t), from_.blockCells.size(), 0});
    if (const Status planned = sections_.plan(sections); !planned || from_.blockCells[0] == 0)
        return planned;
    return sections_.add(SectionId::Blocks, std::as_bytes(std::span(from_.blockCells)));
}

/// Bounds on a mesh's error and warping: what its tetrahedra say of themselves, and what its key says.
Status DerivedWriter::writeBatchBounds()
{
    LargestLiving living(keys_.size());
    const double extent = from_.description.range.extent();
    const double diagonal = from_.description.bounds.diagonal().norm();
    const auto bound = [](double byKey, std::uint16_t own, double whole) {
        return roundedUp(std::min(byKey, static_cast<double>(halfToFloat(own)) * whole));
    };
    auto offsets = perSite<std::uint64_t>(SectionId::StarOffsets);
    auto destroyers = perTetrahedron<std::uint32_t>(SectionId::Destroyers);
    auto ownErrors = perTetrahedron<std::uint16_t>(SectionId::OwnErrors);
    auto ownWarpings = perTetrahedron<std::uint16_t>(SectionId::OwnWarpings);
    std::uint64_t number = offsets.next();
    for (std::size_t site = 0; site < batches_.size(); ++site) {
        for (const std::uint64_t end = offsets.next(); number < end; ++number) {
            const std::uint32_t destroyer = destroyers.next();
            living.add(destroyer == Model::never ? keys_.size() : batches_[destroyer],
                       {ownErrors.next(), ownWarpings.next()});
        }
        const std::uint32_t batch = batches_[site];
        if (site + 1 < batches_.size() && batches_[site + 1] == batch)
            continue;
        const LargestLiving::Own largest = living.aliveAfter(batch);
        const auto key = static_cast<double>(keys_[batch]);
        errors_.push_back(bound(key, largest.error, extent));
        warpings_.push_back(bound(key / weight_, largest.warping, diagonal));
    }
    for (const Status& status : {offsets.status(), destroyers.status(), ownErrors.status(), ownWarpings.status()})
        if (!status)
            return status;
    batches_ = {}; // what follows needs memory, too
    const Status written = add(sections_, SectionId::BatchErrors, errors_);
    return written ? add(sections_, SectionId::BatchWarpings, warpings_) : written;
}

Status DerivedWriter::writeLevels()
{
    std::vector<LevelEntry> levels;
    for (const auto& [batch, sites, key] : levels_.chosen()) {
        LevelEntry& level = levels.emplace_back();
        level.key = key;
        level.error = weight_ > 0 ? errors_[batch] : key;
        level.warping = weight_ > 0 ? warpings_[batch] : 0;
        level.sites = sites;
        const auto read = [&](SectionId id, std::uint64_t number, auto& element) {
            return sections_.read(id, number * sizeof element, std::as_writable_bytes(std::span(&element, 1)));
        };
        if (const Status got = read(SectionId::MeshSizes, sites - 1, level.tetrahedra); !got)
            return got;
        if (const Status got = read(SectionId::StarOffsets, sites, level.created); !got)
            return got;
    }
    return add(sections_, SectionId::LevelIndex, levels);
}

/// Those of an irregular mesh, if there are any.
Status DerivedWriter::writeCellsLeftOut()
{
    const std::vector<format::FaultyCell> cells = faultyCellsOf(*from_.dataset);
    if (cells.empty())
        return {};
    const PlannedSection section{SectionId::FaultyCells, sizeof(format::FaultyCell), cells.size(), 0};
    const Status planned = sections_.plan(std::span(&section, 1));
    return planned ? add(sections_, SectionId::FaultyCells, cells) : planned;
}

Status DerivedWriter::writeFaults()
{
    if (const Status begun = sections_.grow(SectionId::Faults, sizeof(Fault), 0); !begun)
        return begun;
    const Status cells = from_.dataset != nullptr ? addFaultyCells() : addKnownCells();
    return cells ? addInvertedTetrahedra() : cells;
}

Status DerivedWriter::addFault(FaultKind kind, std::uint64_t number)
{
    const Fault fault{static_cast<std::uint32_t>(kind), 0, number};
    return sections_.add(SectionId::Faults, std::as_bytes(std::span(&fault, 1)));
}

Status DerivedWriter::addKnownCells()
{
    return add(sections_, SectionId::Faults, from_.faults->ofCells);
}

/// Those that are folded, and behind them those without volume.
Status DerivedWriter::addFaultyCells()
{
    const Lattice& lattice = from_.dataset->lattice;
    const auto& size = lattice.size;
    const std::span<const Eigen::Vector3d> positions = *from_.dataset->positions;
    const int inverted = from_.description.leftHanded ? 1 : -1;
    std::vector<std::uint64_t> withoutVolume;
    std::uint64_t number = 0;
    for (std::uint32_t z = 0; z + 1 < size[2]; ++z)
        for (std::uint32_t y = 0; y + 1 < size[1]; ++y)
            for (std::uint32_t x = 0; x + 1 < size[0]; ++x, ++number) {
                // The bits of a corner's number choose the later point along x, y and z.
                const auto at = [&](unsigned corner) -> const Eigen::Vector3d& {
                    return positions[lattice.index(x + (corner & 1), y + (corner >> 1 & 1), z + (corner >> 2))];
                };
                bool isFolded = false, hasVolume = false;
                for (unsigned corner = 0; corner < 8; ++corner) {
                    // Each edge that runs backwards turns the sign.
                    const int turn = std::popcount(corner) % 2 == 0 ? 1 : -1;
                    const int sign = turn * orientation(at(corner), at(corner ^ 1), at(corner ^ 2), at(corner ^ 4));
                    isFolded |= sign == inverted;
                    hasVolume |= sign != 0;
                }
                if (isFolded)
                    if (const Status added = addFault(FaultKind::FoldedCell, number); !added)
                        return added;
                if (!hasVolume)
                    withoutVolume.push_back(number);
            }
    for (const std::uint64_t cell : withoutVolume)
        if (const Status added = addFault(FaultKind::CellWithoutVolume, cell); !added)
            return added;
    return {};
}

Status DerivedWriter::addInvertedTetrahedra()
{
    const int inverted = from_.description.leftHanded ? 1 : -1;
    std::vector<std::uint32_t> points(from_.dataset != nullptr ? from_.counts.sites : 0);
    if (const Status read = sections_.read(SectionId::SitePoints, 0, std::as_writable_bytes(std::span(points))); !read)
        return read;
    const auto at = [&](std::uint32_t site) -> const Eigen::Vector3d& {
        return from_.dataset != nullptr ? (*from_.dataset->positions)[points[site]] : from_.faults->sitePositions[site];
    };
    auto offsets = perSite<std::uint64_t>(SectionId::StarOffsets);
    auto destroyers = perTetrahedron<std::uint32_t>(SectionId::Destroyers);
    auto otherSites = perTetrahedron<std::array<std::uint32_t, 3>>(SectionId::OtherSites);
    std::uint64_t number = offsets.next();
    for (std::uint32_t creator = 0; creator < from_.counts.sites; ++creator)
        for (const std::uint64_t end = offsets.next(); number < end; ++number) {
            const auto [a, b, c] = otherSites.next();
            if (destroyers.next() != Model::never || orientation(at(creator), at(a), at(b), at(c)) != inverted)
                continue;
            if (const Status added = addFault(FaultKind::InvertedTetrahedron, number); !added)
                return added;
        }
    for (const Status& status : {offsets.status(), destroyers.status(), otherSites.status()})
        if (!status)
            return status;
    return {};
}

} // namespace

Status writeDerivedSections(SectionWriter& sections, const DerivedFrom& from)
{
    return DerivedWriter(sections, from).run();
}

} // namespace tetra
