// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/findings.h"
#include "core/model/verify_each.h"
#include "core/model/verify_parts.h"

#include <vector>

namespace tetra {

namespace {

constexpr std::uint32_t groupSitesAtOnce = 4096;

class GroupCheck {
public:
    explicit GroupCheck(const Model& model) : model_(model), groupOf_(model.siteCount()) {}

    Status run(const Progress& progress);
    void moveTo(std::vector<std::string>& failures)
    {
        for (Findings* findings : {&flags_, &order_, &links_, &lives_})
            findings->moveTo(failures);
    }

private:
    void readGroups();
    void checkOrder();
    void checkStar(std::uint32_t creator);
    bool sameBatch(std::uint32_t first, std::uint32_t second) const
    {
        return model_.runningErrors()[first] == model_.runningErrors()[second];
    }

    const Model& model_;
    std::vector<std::uint32_t> groupOf_; ///< the first site of each site's group
    Findings flags_;
    Findings order_;
    Findings links_;
    Findings lives_;
};

void GroupCheck::readGroups()
{
    const std::span<const std::uint8_t> goesOn = model_.groupGoesOn();
    std::uint32_t first = 0;
    for (std::uint32_t site = 0; site < model_.siteCount(); ++site) {
        groupOf_[site] = first;
        const bool last = site + 1 == model_.siteCount();
        if (goesOn[site] > 1 || (goesOn[site] == 1 && (last || !sameBatch(site, site + 1))))
            flags_.add(site, [&] {
                return "The group of site " + std::to_string(site) + " goes on with a site of another running error.";
            });
        if (goesOn[site] == 0)
            first = site + 1;
    }
    const std::uint32_t initial = initialSiteCount(model_);
    if (initial > 0 && groupOf_[initial - 1] != 0)
        flags_.add(0, [] { return std::string("The initial sites are not one group."); });
}

/// In a batch, groups come in the order of their first points, sites in a group in that of theirs.
void GroupCheck::checkOrder()
{
    for (std::uint32_t site = 1; site < model_.siteCount(); ++site) {
        if (!sameBatch(site - 1, site))
            continue;
        const std::uint32_t before = groupOf_[site] == site ? groupOf_[site - 1] : site - 1;
        if (model_.points()[before] >= model_.points()[site])
            order_.add(site, [&] {
                return "Sites " + std::to_string(before) + " and " + std::to_string(site) +
                       " have the same running error and are not in the order of their points.";
            });
    }
}

void GroupCheck::checkStar(std::uint32_t creator)
{
    for (std::uint64_t number = model_.starOffsets()[creator]; number < model_.starOffsets()[creator + 1]; ++number) {
        for (const std::uint32_t site : model_.otherSites()[number])
            if (sameBatch(site, creator) && groupOf_[site] != groupOf_[creator])
                links_.add(number, [&] {
                    return "Tetrahedron " + std::to_string(number) + " joins sites " + std::to_string(site) + " and " +
                           std::to_string(creator) + " of two groups with the same running error.";
                });
        const std::uint32_t destroyer = model_.destroyers()[number];
        if (destroyer < model_.siteCount() && sameBatch(creator, destroyer))
            lives_.add(number, [&] {
                return "Tetrahedron " + std::to_string(number) +
                       " is made and destroyed at the same running error: no mesh holds it.";
            });
    }
}

Status GroupCheck::run(const Progress& progress)
{
    readGroups();
    checkOrder();
    return verifyEach(model_.siteCount(), groupSitesAtOnce, "Verifying the groups", progress,
                      [this](std::size_t creator) { checkStar(static_cast<std::uint32_t>(creator)); });
}

} // namespace

Status verifyGroups(const Model& model, std::vector<std::string>& failures, const Progress& progress)
{
    GroupCheck check(model);
    const Status done = check.run(progress);
    check.moveTo(failures);
    return done;
}

} // namespace tetra
