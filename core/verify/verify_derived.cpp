// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rounding.h"
#include "core/history/derived_sections.h"
#include "core/history/file_layout.h"
#include "core/verify/exact_cell.h"
#include "core/verify/findings.h"
#include "core/verify/verify_parts.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

namespace tetra {

namespace {

using format::FaultKind;
using format::LevelEntry;

constexpr std::uint32_t starsAtOnce = 4096;

/// The batches of a model as its running errors tell them.
struct Batches {
    std::vector<std::uint32_t> ends; ///< the last site of each
    std::vector<double> keys;        ///< of the mesh at its end

    explicit Batches(const Model& model)
    {
        const std::span<const float> errors = model.runningKeys();
        for (std::uint32_t site = 0; site < model.siteCount(); ++site) {
            const bool isLast = site + 1 == model.siteCount();
            if (!isLast && errors[site + 1] == errors[site])
                continue;
            ends.push_back(site);
            keys.push_back(static_cast<double>(isLast ? model.finalKey() : errors[site + 1]));
        }
    }
    /// The batch that a site belongs to; behind all, that of no site.
    std::size_t of(std::uint32_t site) const
    {
        return site == Model::never ? ends.size()
                                    : static_cast<std::size_t>(std::ranges::lower_bound(ends, site) - ends.begin());
    }
};

/// The largest own bound of the tetrahedra in the mesh at the end of each batch. The largest come first, and each
/// counts where none before it did.
std::vector<std::uint16_t> largestOwn(const Model& model, const Batches& batches, std::span<const std::uint16_t> own)
{
    std::vector<std::uint64_t> places(1 << 16); // of each bound: where the next tetrahedron that has it goes
    for (const std::uint16_t bound : own)
        ++places[bound];
    std::exclusive_scan(places.rbegin(), places.rend(), places.rbegin(), std::uint64_t(0));
    std::vector<std::uint64_t> falling(own.size());
    for (std::uint64_t number = 0; number < own.size(); ++number)
        falling[places[own[number]]++] = number;
    std::vector<std::uint16_t> largest(batches.ends.size());
    std::vector<std::uint32_t> open(batches.ends.size() + 1); // towards the next batch that has none yet
    std::iota(open.begin(), open.end(), 0u);
    const auto nextOpen = [&open](std::size_t batch) {
        while (open[batch] != batch)
            batch = open[batch] = open[open[batch]];
        return batch;
    };
    for (const std::uint64_t number : falling) {
        if (own[number] == 0 || nextOpen(0) == batches.ends.size())
            break;
        const auto star = std::ranges::upper_bound(model.starOffsets(), number);
        const auto creator = static_cast<std::uint32_t>(star - model.starOffsets().begin() - 1);
        const std::size_t end = batches.of(model.destroyers()[number]);
        for (std::size_t batch = nextOpen(batches.of(creator)); batch < end; batch = nextOpen(batch)) {
            largest[batch] = own[number];
            open[batch] = static_cast<std::uint32_t>(batch + 1);
        }
    }
    return largest;
}

/// Whether a float of the file is what a number is rounded up to, as far as doubles can tell.
bool isRoundedUp(float stored, double expected)
{
    const auto number = static_cast<double>(stored);
    return number >= expected * (1 - 0x1p-50) && number <= expected * (1 + 0x1p-21) + 1e-44;
}

class DerivedCheck {
public:
    DerivedCheck(const Model& model, const Original& original, const std::vector<LatticePoint>& places)
        : model_(model), original_(original), places_(places), derived_(derivedSections(model)), batches_(model)
    {
    }

    Status run(const Progress& progress);
    void moveTo(std::vector<std::string>& failures)
    {
        for (Findings* findings : {&ends_, &bounds_, &levels_, &blocks_, &faults_, &faultyCells_})
            findings->moveTo(failures);
    }

private:
    void checkBatchEnds();
    void checkBatchBounds();
    void checkBounds(std::span<const float> stored, std::span<const std::uint16_t> own, double whole, double keyUnit,
                     std::string_view name);
    void checkLevels();
    std::vector<std::size_t> batchesOfLevels() const;
    LevelEntry levelAt(std::size_t batch) const;
    Status checkBlocks(const Progress& progress);
    void checkStarInBlocks(std::uint32_t creator);
    Status checkFaults(const Progress& progress);
    void checkFaultyCells();
    double weight() const { return model_.description().warpingWeight; }

    const Model& model_;
    const Original& original_;
    const std::vector<LatticePoint>& places_;
    const DerivedSections derived_;
    const Batches batches_;
    Findings ends_;
    Findings bounds_;
    Findings levels_;
    Findings blocks_;
    Findings faults_;
    Findings faultyCells_;
};

Status DerivedCheck::run(const Progress& progress)
{
    checkBatchEnds();
    checkBatchBounds();
    if (progress.cancelled())
        return cancelledError(Message::marked("Verifying the model"));
    checkLevels();
    checkFaultyCells();
    if (const Status checked = checkBlocks(progress.part(0, 0.5)); !checked)
        return checked;
    return checkFaults(progress.part(0.5, 1));
}

void DerivedCheck::checkBatchEnds()
{
    const std::span<const std::uint32_t> stored = derived_.batchEnds;
    if (stored.empty())
        return;
    if (stored.size() != batches_.ends.size())
        ends_.add(0, [&] {
            return "The file has the ends of " + std::to_string(stored.size()) + " batches, and there are " +
                   std::to_string(batches_.ends.size()) + ".";
        });
    for (std::size_t batch = 0; batch < std::min(stored.size(), batches_.ends.size()); ++batch)
        if (stored[batch] != batches_.ends[batch])
            ends_.add(batch + 1, [&] {
                return "Batch " + std::to_string(batch) + " ends with site " + std::to_string(batches_.ends[batch]) +
                       ", and the file says " + std::to_string(stored[batch]) + ".";
            });
}

void DerivedCheck::checkBatchBounds()
{
    const double extent = model_.description().range.extent();
    if (derived_.batchErrors.empty() && derived_.batchWarpings.empty())
        return;
    if (!(weight() > 0))
        return bounds_.add(
            0, [] { return std::string("The file has errors or warpings of batches, and the data cannot warp."); });
    if (!derived_.batchErrors.empty())
        checkBounds(derived_.batchErrors, model_.ownErrors(), extent, 1, "error");
    if (!derived_.batchWarpings.empty())
        checkBounds(derived_.batchWarpings, model_.ownWarpings(), model_.diagonal(), weight(), "warping");
}

void DerivedCheck::checkBounds(std::span<const float> stored, std::span<const std::uint16_t> own, double whole,
                               double keyUnit, std::string_view name)
{
    const std::vector<std::uint16_t> largest = largestOwn(model_, batches_, own);
    for (std::size_t batch = 0; batch < std::min(stored.size(), largest.size()); ++batch) {
        const double ofOwn = static_cast<double>(halfToFloat(largest[batch])) * whole;
        const double expected = std::min(batches_.keys[batch] / keyUnit, ofOwn);
        if (!isRoundedUp(stored[batch], expected))
            bounds_.add(batch, [&] {
                return "The " + std::string(name) + " at the end of batch " + std::to_string(batch) + " is " +
                       textOf(expected) + ", and the file says " + textOf(static_cast<double>(stored[batch])) + ".";
            });
    }
}

bool hasRoomForLevels(std::span<const format::Section> sections)
{
    const format::Section& index = sections.front();
    const std::uint64_t end = index.offset + format::mostLevels * sizeof(LevelEntry);
    return index.id == std::uint32_t(format::SectionId::LevelIndex) && end <= 16384 &&
           (sections.size() == 1 || sections[1].offset >= end);
}

/// The first mesh, the last, and between them the first of each key that is an eighth of an octave smaller.
std::vector<std::size_t> DerivedCheck::batchesOfLevels() const
{
    const std::size_t last = batches_.ends.size() - 1;
    std::vector<std::size_t> chosen{0};
    for (std::uint64_t step = 1; step + 1 < format::mostLevels; ++step) {
        const double most = batches_.keys[0] * std::exp2(static_cast<double>(step) / -8);
        std::size_t batch = chosen.back();
        while (batch < last && !(batches_.keys[batch] <= most))
            ++batch;
        chosen.push_back(batch);
    }
    chosen.push_back(last);
    chosen.erase(std::ranges::unique(chosen).begin(), chosen.end());
    return chosen;
}

LevelEntry DerivedCheck::levelAt(std::size_t batch) const
{
    const double key = batches_.keys[batch];
    const auto of = [batch](std::span<const float> bounds, float otherwise) {
        return batch < bounds.size() ? bounds[batch] : otherwise;
    };
    LevelEntry level;
    level.key = static_cast<float>(key);
    level.error = of(derived_.batchErrors, level.key);
    level.warping = weight() > 0 ? of(derived_.batchWarpings, roundedUp(key / weight())) : 0;
    level.sites = batches_.ends[batch] + 1;
    level.tetrahedra = model_.meshSizes()[level.sites - 1];
    level.created = model_.starOffsets()[level.sites];
    return level;
}

void DerivedCheck::checkLevels()
{
    if (derived_.levels.empty())
        return;
    const Result<FileLayout> layout = readLayout(model_.fileBytes(), model_.path());
    if (!layout || !hasRoomForLevels(layout->sections))
        levels_.add(0, [] {
            return std::string("The level index is not the first section, within 16 KiB, with room for 256 entries.");
        });
    const std::vector<std::size_t> expected = batchesOfLevels();
    if (derived_.levels.size() != expected.size())
        levels_.add(1, [&] {
            return "The level index has " + std::to_string(derived_.levels.size()) + " entries instead of " +
                   std::to_string(expected.size()) + ".";
        });
    for (std::size_t number = 0; number < std::min(derived_.levels.size(), expected.size()); ++number) {
        const LevelEntry &stored = derived_.levels[number], right = levelAt(expected[number]);
        if (std::ranges::equal(std::as_bytes(std::span(&stored, 1)), std::as_bytes(std::span(&right, 1))))
            continue;
        levels_.add(number + 2, [&] {
            return "Entry " + std::to_string(number) + " of the level index describes " + std::to_string(stored.sites) +
                   " sites, " + std::to_string(stored.tetrahedra) + " tetrahedra of " + std::to_string(stored.created) +
                   ", key " + textOf(static_cast<double>(stored.key)) + ", error " +
                   textOf(static_cast<double>(stored.error)) + " and warping " +
                   textOf(static_cast<double>(stored.warping)) + "; it should be " + std::to_string(right.sites) +
                   ", " + std::to_string(right.tetrahedra) + " of " + std::to_string(right.created) + ", " +
                   textOf(static_cast<double>(right.key)) + ", " + textOf(static_cast<double>(right.error)) + " and " +
                   textOf(static_cast<double>(right.warping)) + ".";
        });
    }
}

/// More than one, each of cells that the lattice has.
bool canBeBlocks(std::span<const std::uint32_t> cells, const Dataset& dataset)
{
    if (!isOnLattice(dataset.domain))
        return false;
    bool isDivided = false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::uint32_t all = dataset.lattice.size[axis] - 1;
        if (cells[axis] == 0 || cells[axis] > all)
            return false;
        isDivided |= cells[axis] < all;
    }
    return isDivided;
}

Status DerivedCheck::checkBlocks(const Progress& progress)
{
    const std::span<const std::uint32_t> cells = derived_.blockCells;
    if (cells.empty())
        return {};
    if (!canBeBlocks(cells, original_.dataset)) {
        blocks_.add(0, [&] {
            return "Blocks of " + std::to_string(cells[0]) + " x " + std::to_string(cells[1]) + " x " +
                   std::to_string(cells[2]) + " cells are impossible.";
        });
        return {};
    }
    return verifyEach(model_.siteCount(), starsAtOnce, "Verifying the blocks", progress,
                      [this](std::size_t creator) { checkStarInBlocks(static_cast<std::uint32_t>(creator)); });
}

void DerivedCheck::checkStarInBlocks(std::uint32_t creator)
{
    for (std::uint64_t number = model_.starOffsets()[creator]; number < model_.starOffsets()[creator + 1]; ++number) {
        LatticePoint least = places_[creator], most = least;
        for (const std::uint32_t site : model_.otherSites()[number])
            for (std::size_t axis = 0; axis < 3; ++axis) {
                least[axis] = std::min(least[axis], places_[site][axis]);
                most[axis] = std::max(most[axis], places_[site][axis]);
            }
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (const std::int64_t cells = derived_.blockCells[axis]; most[axis] > (least[axis] / cells + 1) * cells) {
                blocks_.add(number, [&] {
                    return "Tetrahedron " + std::to_string(number) + " from " + textOf(least) + " to " + textOf(most) +
                           " lies in more than one block.";
                });
                break;
            }
    }
}

/// The cells that were left out (C10); files of earlier versions do not list them.
void DerivedCheck::checkFaultyCells()
{
    const std::span<const format::FaultyCell> stored = derived_.faultyCells;
    if (stored.empty())
        return;
    const std::vector<format::FaultyCell> expected = faultyCellsOf(original_.dataset);
    const auto textOf = [](const format::FaultyCell& cell) {
        return "cell " + std::to_string(cell.number) + " was left out, with " + std::to_string(cell.corners) +
               " corners, for fault " + std::to_string(cell.fault);
    };
    if (stored.size() != expected.size())
        faultyCells_.add(0, [&] {
            return "The file lists " + std::to_string(stored.size()) + " faulty cells, and there are " +
                   std::to_string(expected.size()) + ".";
        });
    for (std::size_t i = 0; i < std::min(stored.size(), expected.size()); ++i)
        if (std::memcmp(&stored[i], &expected[i], sizeof expected[i]) != 0)
            faultyCells_.add(i + 1, [&] {
                return "The file says that " + textOf(stored[i]) + "; the data, that " + textOf(expected[i]) +
                       " or lies elsewhere.";
            });
}

std::string nameOf(const std::pair<std::uint32_t, std::uint64_t>& fault)
{
    const std::string number = std::to_string(fault.second);
    switch (static_cast<FaultKind>(fault.first)) {
    case FaultKind::FoldedCell: return "cell " + number + " is folded";
    case FaultKind::CellWithoutVolume: return "cell " + number + " has no volume";
    case FaultKind::InvertedTetrahedron: return "tetrahedron " + number + " is inverted";
    }
    return "there is a fault of kind " + std::to_string(fault.first) + ", number " + number;
}

Status DerivedCheck::checkFaults(const Progress& progress)
{
    if (!derived_.faults)
        return {};
    using Fault = std::pair<std::uint32_t, std::uint64_t>;
    std::vector<Fault> stored, expected;
    for (const format::Fault& fault : *derived_.faults) {
        stored.emplace_back(fault.kind, fault.number);
        if (fault.reserved != 0)
            faults_.add(0, [] { return std::string("Reserved fields of the list of faults are not zero."); });
    }
    if (const auto& grid = original_.curvilinear) {
        for (const std::uint64_t cell : grid->foldedCellNumbers())
            expected.emplace_back(std::uint32_t(FaultKind::FoldedCell), cell);
        for (const std::uint64_t cell : grid->cellsWithoutVolume())
            expected.emplace_back(std::uint32_t(FaultKind::CellWithoutVolume), cell);
        const auto at = [&](std::uint32_t site) { return original_.dataset.position(model_.points()[site]); };
        std::vector<std::uint8_t> inverted(model_.tetrahedronCount());
        const Status looked =
            verifyEach(model_.siteCount(), starsAtOnce, "Verifying the faults", progress, [&](std::size_t creator) {
                const auto& offsets = model_.starOffsets();
                for (std::uint64_t number = offsets[creator]; number < offsets[creator + 1]; ++number) {
                    const auto& [a, b, c] = model_.otherSites()[number];
                    if (model_.destroyers()[number] == Model::never)
                        inverted[number] =
                            volumeSign(at(static_cast<std::uint32_t>(creator)), at(a), at(b), at(c)) == -grid->hand();
                }
            });
        if (!looked)
            return looked;
        for (std::uint64_t number = 0; number < inverted.size(); ++number)
            if (inverted[number] != 0)
                expected.emplace_back(std::uint32_t(FaultKind::InvertedTetrahedron), number);
    }
    if (!std::ranges::is_sorted(stored))
        faults_.add(1, [] { return std::string("The faults are not in the order of their kinds and numbers."); });
    std::ranges::sort(stored);
    std::vector<Fault> more, missing;
    std::ranges::set_difference(stored, expected, std::back_inserter(more));
    std::ranges::set_difference(expected, stored, std::back_inserter(missing));
    for (const Fault& fault : more)
        faults_.add(2 + fault.second, [&] { return "The file says that " + nameOf(fault) + ", which is not so."; });
    for (const Fault& fault : missing)
        faults_.add(2 + fault.second, [&] { return "The file does not say that " + nameOf(fault) + "."; });
    return {};
}

} // namespace

Status verifyDerived(const Model& model, const Original& original, const std::vector<LatticePoint>& places,
                     std::vector<std::string>& failures, const Progress& progress)
{
    DerivedCheck check(model, original, places);
    const Status done = check.run(progress);
    check.moveTo(failures);
    return done;
}

} // namespace tetra
