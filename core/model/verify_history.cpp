// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/findings.h"
#include "core/model/verify_each.h"
#include "core/model/verify_parts.h"

#include <algorithm>
#include <atomic>
#include <vector>

namespace tetra {

namespace {

constexpr std::uint32_t historySitesAtOnce = 4096;

/// What the sites make and destroy, gathered from the tetrahedra alone.
struct Balance {
    explicit Balance(std::uint32_t sites) : destroyed(sites), destroyedVolume(sites), createdVolume(sites) {}

    std::vector<std::atomic<std::uint32_t>> destroyed;
    std::vector<std::atomic<std::int64_t>> destroyedVolume; ///< six times the volume
    std::vector<std::int64_t> createdVolume;
};

class HistoryCheck {
public:
    HistoryCheck(const Model& model, const std::vector<LatticePoint>& places)
        : model_(model), places_(places), balance_(model.siteCount())
    {
    }

    Status run(const Progress& progress);
    bool usable() const { return offsets_.none() && sites_.none(); }
    void moveTo(std::vector<std::string>& failures)
    {
        for (Findings* findings : {&offsets_, &sites_, &destroyers_, &errors_, &volumes_, &sizes_, &balances_})
            findings->moveTo(failures);
    }

private:
    void checkOffsets();
    void checkStar(std::uint32_t creator);
    void checkTetrahedron(std::uint32_t creator, std::uint64_t number);
    /// Calls function(first, end) for the sites of each group.
    template <class Function> void forEachGroup(Function&& function)
    {
        std::uint32_t first = 0;
        for (std::uint32_t site = 0; site < model_.siteCount(); ++site)
            if (model_.groupGoesOn()[site] == 0 || site + 1 == model_.siteCount()) {
                function(first, site + 1);
                first = site + 1;
            }
    }
    void checkSizes();
    void checkBalance();

    const Model& model_;
    const std::vector<LatticePoint>& places_;
    Balance balance_;
    Findings offsets_;
    Findings sites_;
    Findings destroyers_;
    Findings errors_;
    Findings volumes_;
    Findings sizes_;
    Findings balances_;
};

Status HistoryCheck::run(const Progress& progress)
{
    checkOffsets();
    if (!offsets_.none())
        return {};
    const Status checked = verifyEach(model_.siteCount(), historySitesAtOnce, "Verifying the history", progress,
                                      [this](std::size_t creator) { checkStar(static_cast<std::uint32_t>(creator)); });
    if (!checked)
        return checked;
    checkSizes();
    if (usable() && !places_.empty())
        checkBalance();
    return {};
}

void HistoryCheck::checkOffsets()
{
    const std::span<const std::uint64_t> offsets = model_.starOffsets();
    if (offsets.front() != 0 || offsets.back() != model_.tetrahedronCount())
        offsets_.add(0, [&] {
            return "The star offsets go from " + std::to_string(offsets.front()) + " to " +
                   std::to_string(offsets.back()) + " instead of from 0 to " +
                   std::to_string(model_.tetrahedronCount()) + ".";
        });
    for (std::uint32_t site = 0; site < model_.siteCount(); ++site)
        if (offsets[site] > offsets[site + 1] || offsets[site + 1] > model_.tetrahedronCount())
            offsets_.add(site, [&] {
                return "The star of site " + std::to_string(site) + " goes from tetrahedron " +
                       std::to_string(offsets[site]) + " to " + std::to_string(offsets[site + 1]) + " of " +
                       std::to_string(model_.tetrahedronCount()) + ".";
            });
}

void HistoryCheck::checkStar(std::uint32_t creator)
{
    for (std::uint64_t number = model_.starOffsets()[creator]; number < model_.starOffsets()[creator + 1]; ++number)
        checkTetrahedron(creator, number);
}

void HistoryCheck::checkTetrahedron(std::uint32_t creator, std::uint64_t number)
{
    const std::array<std::uint32_t, 3> others = model_.otherSites()[number];
    const std::uint32_t destroyer = model_.destroyers()[number];
    const std::string name = "Tetrahedron ";
    if (model_.ownErrors()[number] > 0x7c00)
        errors_.add(number, [&] { return name + std::to_string(number) + " has an own error that is no number."; });
    const bool destroyerKnown = destroyer == Model::never || (destroyer > creator && destroyer < model_.siteCount());
    if (!destroyerKnown)
        destroyers_.add(number, [&] {
            return name + std::to_string(number) + ", made by site " + std::to_string(creator) +
                   ", is destroyed by site " + std::to_string(destroyer) + " of " + std::to_string(model_.siteCount()) +
                   ".";
        });
    if (std::ranges::any_of(others, [creator](std::uint32_t site) { return site >= creator; })) {
        sites_.add(number, [&] {
            return name + std::to_string(number) + " has a site that is not earlier than its creator, site " +
                   std::to_string(creator) + ".";
        });
        return;
    }
    if (destroyerKnown && destroyer != Model::never)
        balance_.destroyed[destroyer].fetch_add(1, std::memory_order_relaxed);
    if (places_.empty())
        return;
    const CellCorners corners = {places_[creator], places_[others[0]], places_[others[1]], places_[others[2]]};
    const std::int64_t volume = sixVolumes(corners);
    if (volume <= 0)
        volumes_.add(number, [&] {
            return name + std::to_string(number) + " with corners " + textOf(corners) + " is " +
                   (volume == 0 ? "flat." : "inverted.");
        });
    balance_.createdVolume[creator] += volume;
    if (destroyerKnown && destroyer != Model::never)
        balance_.destroyedVolume[destroyer].fetch_add(volume, std::memory_order_relaxed);
}

void HistoryCheck::checkSizes()
{
    std::int64_t alive = 0;
    forEachGroup([&](std::uint32_t first, std::uint32_t end) {
        alive += static_cast<std::int64_t>(model_.starOffsets()[end] - model_.starOffsets()[first]);
        for (std::uint32_t site = first; site < end; ++site)
            alive -= balance_.destroyed[site].load();
        for (std::uint32_t site = first; site < end; ++site)
            if (const std::int64_t claimed = model_.meshSizes()[site]; alive != claimed)
                sizes_.add(site, [&] {
                    return "The mesh of sites 0 to " + std::to_string(end - 1) + " has " + std::to_string(alive) +
                           " tetrahedra, and the file says " + std::to_string(claimed) + ".";
                });
    });
}

/// After the first mesh a group only divides anew what it empties, so every mesh fills the domain if the first one
/// does.
void HistoryCheck::checkBalance()
{
    const auto domain = 6 * static_cast<std::int64_t>(model_.description().lattice.cellCount());
    const std::uint32_t initialSites = initialSiteCount(model_);
    std::int64_t initial = 0;
    forEachGroup([&](std::uint32_t first, std::uint32_t end) {
        std::int64_t created = 0;
        std::int64_t destroyed = 0;
        for (std::uint32_t site = first; site < end; ++site) {
            created += balance_.createdVolume[site];
            destroyed += balance_.destroyedVolume[site].load();
        }
        if (first < initialSites)
            initial += created - destroyed;
        else if (created != destroyed)
            balances_.add(first, [&] {
                return "The group of " + std::to_string(end - first) + " sites from site " + std::to_string(first) +
                       " at " + textOf(places_[first]) + " on empties " + std::to_string(destroyed) +
                       " sixths of a cell and fills " + std::to_string(created) + ".";
            });
    });
    if (initial != domain)
        balances_.add(0, [&] {
            return "The first mesh fills " + std::to_string(initial) + " sixths of a cell; the domain has " +
                   std::to_string(domain) + ".";
        });
}

} // namespace

Status verifyHistory(const Model& model, const std::vector<LatticePoint>& places, std::vector<std::string>& failures,
                     bool& usable, const Progress& progress)
{
    HistoryCheck check(model, places);
    const Status done = check.run(progress);
    usable = check.usable();
    check.moveTo(failures);
    return done;
}

} // namespace tetra
