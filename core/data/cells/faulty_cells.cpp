// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/data/cells/faulty_cells.h"

#include "core/base/sort_unique.h"
#include "core/data/cells/irregular_check.h"
#include "core/geometry/orientation.h"
#include "core/mesh/boundary.h"
#include "core/mesh/topology.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace tetra {

std::string shareText(double share)
{
    constexpr double percent = 100;
    return formatNumber(percent * share) + "%";
}

std::string largerShareText(double mostFaulty, std::uint64_t faultyCount, std::uint64_t cellCount)
{
    constexpr double whole = 1;
    for (const double share : {0.05, 0.1, 0.2, 0.5})
        if (share > mostFaulty && static_cast<double>(faultyCount) <= share * static_cast<double>(cellCount))
            return shareText(share);
    return shareText(whole);
}

namespace {

void keepOnly(CutCells& cut, const std::vector<bool>& removed)
{
    std::size_t kept = 0;
    for (std::size_t t = 0; t < cut.tetrahedra.size(); ++t)
        if (!removed[t]) {
            cut.tetrahedra[kept] = cut.tetrahedra[t];
            cut.cells[kept++] = cut.cells[t];
        }
    cut.tetrahedra.resize(kept);
    cut.cells.resize(kept);
}

/// Takes away tetrahedra that are there twice. `faces` are those of `cut`, before and after.
void removeDuplicates(const CleanCells& cells, CutCells& cut, MeshFaces& faces, Repairs& repairs)
{
    std::map<Tetrahedron, std::uint32_t> seen; // few: only those at crowded faces can be there twice, or alone
    std::vector<bool> removed(cut.tetrahedra.size());
    const auto look = [&](std::uint32_t t) {
        Tetrahedron sorted = cut.tetrahedra[t];
        std::ranges::sort(sorted);
        const auto [first, isNew] = seen.emplace(sorted, t);
        removed[t] = !isNew && first->second != t;
    };
    // Of two alike that nothing else touches, the faces match each other, folded.
    for (const std::uint32_t t : faces.crowded)
        look(t);
    for (const std::uint32_t t : faces.folded)
        look(t);
    for (std::uint32_t t = 0; t < removed.size(); ++t)
        if (removed[t]) {
            ++repairs.duplicates;
            repairs.faulty.push_back({cells.origins[cut.cells[t]], CellFault::Duplicate});
        }
    if (repairs.duplicates > 0) {
        keepOnly(cut, removed);
        faces = findMeshFaces(cut.tetrahedra);
    }
}

/// Which cells of the file overlap which, and which of them go.
class Overlapping {
public:
    Overlapping(std::span<const Eigen::Vector3d> positions, const CleanCells& cells, std::uint64_t cellCount,
                double mostFaulty, const CutCells& cut)
        : positions_(positions), cells_(cells), cellCount_(cellCount), mostFaulty_(mostFaulty), cut_(cut)
    {
        for (const Tetrahedron& tetrahedron : cut.tetrahedra)
            volume_ += volumeOf(positions, tetrahedron);
    }

    /// Takes out cells until none overlap. Cancelled: an error.
    Status run(CutCells& cut, MeshFaces& faces, Repairs& repairs, const Progress& progress)
    {
        for (;;) {
            matched_.clear();
            least_ = gone_;
            const MeshOverlaps overlaps = findOverlaps(
                positions_, cut.tetrahedra, faces,
                [this](std::uint32_t one, std::uint32_t other) { return match(one, other); }, progress);
            if (progress.cancelled())
                return cancelledError(Message::marked("Checking the mesh"));
            if (overlaps.pairs.empty())
                return {};
            const std::vector<FaultyCell> chosen = choose(overlaps, faces);
            for (const FaultyCell& faulty : chosen)
                add(gone_, faulty.cell);
            if (!first_)
                first_ = chosen.front();
            if (!overlaps.complete || tooMuch(gone_))
                return refusal(*first_);
            take(chosen, cut);
            repairs.faulty.insert(repairs.faulty.end(), chosen.begin(), chosen.end());
            faces = findMeshFaces(cut.tetrahedra);
        }
    }

private:
    struct Amount {
        std::uint64_t cells = 0;
        double volume = 0;
    };

    std::uint64_t cellOf(std::uint32_t tetrahedron) const { return cells_.origins[cut_.cells[tetrahedron]]; }
    bool tooMuch(const Amount& amount) const
    {
        return static_cast<double>(amount.cells) > mostFaulty_ * static_cast<double>(cellCount_) &&
               amount.volume > mostFaulty_ * volume_;
    }
    double volumeOfCell(std::uint64_t cell)
    {
        if (volumes_.empty()) {
            volumes_.resize(std::ranges::max(cells_.origins) + 1);
            for (std::uint32_t t = 0; t < cut_.tetrahedra.size(); ++t)
                volumes_[cellOf(t)] += volumeOf(positions_, cut_.tetrahedra[t]);
        }
        return volumes_[cell];
    }
    void add(Amount& amount, std::uint64_t cell)
    {
        ++amount.cells;
        amount.volume += volumeOfCell(cell);
    }

    /// Of cells that overlap in pairs, no cell in two pairs, at least one each goes. Whether these are too many
    /// already.
    bool match(std::uint32_t one, std::uint32_t other)
    {
        const std::uint64_t first = cellOf(one), second = cellOf(other);
        if (matched_.contains(first) || matched_.contains(second))
            return false;
        matched_.insert({first, second});
        add(least_, volumeOfCell(first) < volumeOfCell(second) ? first : second);
        return tooMuch(least_);
    }

    /// Always the one that overlaps the most of those that are left, of these the last one in the file.
    std::vector<FaultyCell> choose(const MeshOverlaps& overlaps, const MeshFaces& faces) const
    {
        std::map<std::uint64_t, std::set<std::uint64_t>> others;
        for (const auto& [one, other] : overlaps.pairs) {
            others[cellOf(one)].insert(cellOf(other));
            others[cellOf(other)].insert(cellOf(one));
        }
        std::set<std::pair<std::size_t, std::uint64_t>> queue; // by how many, and the cell
        for (const auto& [cell, overlapped] : others)
            queue.emplace(overlapped.size(), cell);
        const auto cellsOf = [this](const std::vector<std::uint32_t>& tetrahedra) {
            std::vector<std::uint64_t> cells;
            for (const std::uint32_t t : tetrahedra)
                cells.push_back(cellOf(t));
            sortUnique(cells);
            return cells;
        };
        const std::vector<std::uint64_t> crowded = cellsOf(faces.crowded), folded = cellsOf(faces.folded);
        std::vector<FaultyCell> chosen;
        while (!queue.empty()) {
            const auto [count, cell] = *queue.rbegin();
            queue.erase(std::prev(queue.end()));
            if (count == 0)
                continue;
            for (const std::uint64_t other : others[cell]) {
                std::set<std::uint64_t>& left = others[other];
                if (other == cell || left.empty())
                    continue;
                queue.erase({left.size(), other});
                left.erase(cell);
                queue.emplace(left.size(), other);
            }
            others[cell].clear();
            const bool isCrowded = std::ranges::binary_search(crowded, cell),
                       isFolded = std::ranges::binary_search(folded, cell);
            chosen.push_back({cell, isCrowded  ? CellFault::CrowdedFace
                                    : isFolded ? CellFault::Folded
                                               : CellFault::Overlap});
        }
        std::ranges::sort(chosen, {}, &FaultyCell::cell);
        return chosen;
    }

    void take(const std::vector<FaultyCell>& chosen, CutCells& cut) const
    {
        std::vector<bool> removed(cut.tetrahedra.size());
        for (std::uint32_t t = 0; t < removed.size(); ++t)
            removed[t] = std::ranges::binary_search(chosen, cellOf(t), {}, &FaultyCell::cell);
        keepOnly(cut, removed);
    }

    Error refusal(const FaultyCell& first) const
    {
        const auto origin = std::ranges::find(cells_.origins, first.cell);
        const auto nodes = cells_.nodesOf(static_cast<std::size_t>(origin - cells_.origins.begin()));
        const Eigen::Vector3d& place = positions_[nodes.front()];
        const std::uint64_t faulty = std::max(gone_.cells, least_.cells);
        return {ErrorKind::BadInput,
                Message::say("At least %1 of the mesh's %2 cells are faulty, more than %3. The first is cell %4 at "
                             "(%5, %6, %7): %8. Repair the mesh in the program that made it, or allow more cells to be "
                             "left out, as with '--faulty %9'.",
                             faulty, cellCount_, shareText(mostFaulty_), first.cell, formatNumber(place[0]),
                             formatNumber(place[1]), formatNumber(place[2]), cellFaultText(first.fault),
                             largerShareText(mostFaulty_, faulty, cellCount_))};
    }

    std::span<const Eigen::Vector3d> positions_;
    const CleanCells& cells_;
    std::uint64_t cellCount_;
    double mostFaulty_;
    const CutCells& cut_;
    double volume_ = 0;
    std::vector<double> volumes_; ///< of the file's cells
    std::optional<FaultyCell> first_;
    std::set<std::uint64_t> matched_;
    Amount gone_;  ///< taken out
    Amount least_; ///< that have to go in all, so far as known
};

} // namespace

Status takeOutFaulty(std::span<const Eigen::Vector3d> positions, const CleanCells& cells, std::uint64_t cellCount,
                     double mostFaulty, CutCells& cut, Repairs& repairs, const Progress& progress)
{
    MeshFaces faces = findMeshFaces(cut.tetrahedra);
    removeDuplicates(cells, cut, faces, repairs);
    return Overlapping(positions, cells, cellCount, mostFaulty, cut).run(cut, faces, repairs, progress);
}

} // namespace tetra
