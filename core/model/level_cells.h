// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/model/exact_cell.h"
#include "core/model/model.h"
#include "core/model/verification.h"

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace tetra {

/// The cells of one level, picked from the history by its definition: created by one of the first sites, destroyed by
/// none of them. For verification; the arrays of the model are known to be usable.
class LevelCells {
public:
    LevelCells(const Model& model, const std::vector<LatticePoint>& places, std::uint32_t sites) : places_(places)
    {
        for (std::uint32_t creator = 0; creator < sites; ++creator)
            for (std::uint64_t t = model.starOffsets()[creator]; t < model.starOffsets()[creator + 1]; ++t) {
                if (model.destroyers()[t] < sites)
                    continue;
                const std::array<std::uint32_t, 3>& others = model.otherSites()[t];
                sites_.push_back({creator, others[0], others[1], others[2]});
                historyNumbers_.push_back(t);
            }
    }

    std::size_t size() const noexcept { return sites_.size(); }
    const std::array<std::uint32_t, 4>& sites(std::size_t cell) const { return sites_[cell]; }
    std::uint64_t historyNumber(std::size_t cell) const { return historyNumbers_[cell]; }
    const LatticePoint& place(std::uint32_t site) const { return places_[site]; }
    CellCorners corners(std::size_t cell) const
    {
        const std::array<std::uint32_t, 4>& s = sites_[cell];
        return {places_[s[0]], places_[s[1]], places_[s[2]], places_[s[3]]};
    }

private:
    const std::vector<LatticePoint>& places_;
    std::vector<std::array<std::uint32_t, 4>> sites_;
    std::vector<std::uint64_t> historyNumbers_;
};

/// What a domain says of its cells' faces.
struct FaceRule {
    std::function<bool(const std::array<std::uint32_t, 3>& sites)> onBoundary;
    std::function<std::string(std::uint32_t site)> place; ///< for messages
};

/// Every face belongs to two cells, one on each side, or to one and lies on the domain's boundary. Sorts the faces in
/// batches of at most about 8 million. An Error only if cancelled.
Status verifyFaces(const LevelCells& cells, const FaceRule& rule, LevelVerdict& verdict, const Progress& progress);

} // namespace tetra
