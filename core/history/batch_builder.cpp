// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/batch_builder.h"

#include "core/mesh/topology.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace tetra {

void HistoryBatch::start(std::uint32_t firstSite, std::uint32_t firstTetrahedron)
{
    firstSite_ = firstSite;
    firstTetrahedron_ = firstTetrahedron;
    points_.clear();
    groups_.reset(0);
    tetrahedra_.clear();
}

void HistoryBatch::add(const HistoryStep& step)
{
    const std::uint32_t local = siteCount();
    points_.push_back(step.point);
    groups_.add();
    for (const HistoryTetrahedron& made : step.star) {
        tetrahedra_.push_back(
            {{firstSite_ + local, made.sites[0], made.sites[1], made.sites[2]}, made.error, made.warping});
        for (const std::uint32_t site : made.sites)
            if (site >= firstSite_)
                groups_.join(local, site - firstSite_);
    }
    for (const std::uint32_t destroyed : step.destroyed)
        if (destroyed >= firstTetrahedron_) {
            Tetrahedron& tetrahedron = tetrahedra_[destroyed - firstTetrahedron_];
            tetrahedron.dropped = true;
            groups_.join(local, tetrahedron.sites[0] - firstSite_);
        }
}

void HistoryBatch::uniteAll()
{
    for (std::uint32_t local = 1; local < siteCount(); ++local)
        groups_.join(0, local);
}

void HistoryBatch::arrange()
{
    const std::uint32_t count = siteCount();
    firsts_.resize(count);
    std::iota(firsts_.begin(), firsts_.end(), 0u);
    for (std::uint32_t local = 0; local < count; ++local) {
        std::uint32_t& first = firsts_[groups_.root(local)];
        if (points_[local] < points_[first])
            first = local;
    }
    for (std::uint32_t local = 0; local < count; ++local)
        firsts_[local] = firsts_[groups_.root(local)];
    order_.resize(count);
    std::iota(order_.begin(), order_.end(), 0u);
    if (count > 1)
        std::ranges::sort(order_, {},
                          [this](std::uint32_t local) { return std::pair(points_[firsts_[local]], points_[local]); });
    places_.resize(count);
    for (std::uint32_t place = 0; place < count; ++place)
        places_[order_[place]] = place;
}

std::array<std::uint32_t, 4> latestFirst(const std::array<std::uint32_t, 4>& sites)
{
    return withCornerFirst(sites, static_cast<std::size_t>(std::ranges::max_element(sites) - sites.begin()));
}

namespace {

Error inconsistent(const Message& what)
{
    return {ErrorKind::BadInput, what};
}

} // namespace

Status BatchBuilder::add(const HistoryStep& step)
{
    if (failure_)
        failure_ = take(step);
    return failure_;
}

Status BatchBuilder::take(const HistoryStep& step)
{
    if (const Status right = check(step); !right)
        return right;
    if (step.keyBefore < runningKey_) {
        if (const Status closed = closeBatch(); !closed)
            return closed;
        runningKey_ = step.keyBefore;
    }
    return record(step);
}

Status BatchBuilder::finish()
{
    return failure_ ? closeBatch() : failure_;
}

void BatchBuilder::abandonBatch()
{
    batch_.start(batch_.firstSite(), batch_.firstTetrahedron());
}

Status BatchBuilder::check(const HistoryStep& step) const
{
    const std::uint32_t creator = siteCount();
    if (creator == gone - 1)
        return Error{
            ErrorKind::OutOfResource,
            Message::say("The history has more than %1 sites. Choose a larger error, or build in blocks.", gone - 1)};
    if (step.point >= pointCount_)
        return inconsistent(Message::say("point %1 is not in the dataset", step.point));
    if (std::isnan(step.keyBefore) || step.keyBefore < 0)
        return inconsistent(Message::say("the error before it is not a number of at least 0"));
    if (step.star.size() > gone - storedNumbers_.size())
        return Error{
            ErrorKind::OutOfResource,
            Message::say(
                "The history has more than 4294967295 tetrahedra. Choose a larger error, or build in blocks.")};
    for (const HistoryTetrahedron& tetrahedron : step.star) {
        if (std::ranges::any_of(tetrahedron.sites, [creator](std::uint32_t site) { return site >= creator; }))
            return inconsistent(Message::say("a tetrahedron of its star has a site that comes after it"));
        const auto& [a, b, c] = tetrahedron.sites;
        if (a == b || a == c || b == c)
            return inconsistent(Message::say("a tetrahedron of its star has a site twice"));
        if (!(tetrahedron.error >= 0) || !(tetrahedron.warping >= 0))
            return inconsistent(
                Message::say("a tetrahedron of its star has an error or a warping that is not a number of at least 0"));
    }
    for (const std::uint32_t destroyed : step.destroyed)
        if (destroyed >= madeCount() || storedNumbers_[destroyed] == gone)
            return inconsistent(Message::say("it destroys tetrahedron %1, which is not in the mesh", destroyed));
    return {};
}

Status BatchBuilder::record(const HistoryStep& step)
{
    const std::uint32_t site = siteCount();
    for (const std::uint32_t destroyed : step.destroyed) {
        if (storedNumbers_[destroyed] == gone)
            return inconsistent(Message::say("it destroys tetrahedron %1 twice", destroyed));
        if (destroyed < batch_.firstTetrahedron())
            destructions_.push_back({storedNumbers_[destroyed], site});
        storedNumbers_[destroyed] = gone;
    }
    alive_ += step.star.size() - step.destroyed.size();
    batch_.add(step);
    for (std::size_t made = 0; made < step.star.size(); ++made)
        storedNumbers_.push_back(0); // until it is known whether it outlives the batch
    return {};
}

Status BatchBuilder::closeBatch()
{
    if (batch_.siteCount() == 0)
        return {};
    if (std::isinf(runningKey_))
        batch_.uniteAll();
    batch_.arrange();
    numberSites();
    sortTetrahedra();
    Batch arranged;
    arranged.runningKey = runningKey_;
    arranged.firstSite = batch_.firstSite();
    arranged.firstTetrahedron = storedCount_;
    arranged.points = points_;
    arranged.groupGoesOn = groupGoesOn_;
    arranged.starEnds = starEnds_;
    arranged.tetrahedra = sorted_;
    arranged.destructions = destructions_;
    storedCount_ += static_cast<std::uint32_t>(sorted_.size());
    const Status added = sink_.add(arranged);
    destructions_.clear();
    batch_.start(siteCount(), madeCount());
    return added;
}

void BatchBuilder::numberSites()
{
    const std::uint32_t count = batch_.siteCount();
    points_.resize(count);
    groupGoesOn_.resize(count);
    for (std::uint32_t place = 0; place < count; ++place) {
        points_[place] = batch_.pointAt(place);
        groupGoesOn_[place] = batch_.groupGoesOn(place) ? 1 : 0;
        finalNumbers_.push_back(batch_.firstSite() + batch_.placeOf(batch_.firstSite() + place));
    }
    for (Batch::Destruction& destruction : destructions_)
        destruction.destroyer = finalNumbers_[destruction.destroyer];
}

void BatchBuilder::sortTetrahedra()
{
    const std::span<const HistoryBatch::Tetrahedron> made = batch_.tetrahedra();
    staying_.clear();
    stayingNumbers_.clear();
    starEnds_.assign(batch_.siteCount() + 1, 0);
    for (std::uint32_t number = 0; number < made.size(); ++number) {
        if (made[number].dropped)
            continue;
        std::array<std::uint32_t, 4> sites = made[number].sites;
        for (std::uint32_t& site : sites)
            site = finalNumbers_[site];
        staying_.push_back({latestFirst(sites), made[number].error, made[number].warping});
        stayingNumbers_.push_back(number);
        ++starEnds_[staying_.back().sites[0] - batch_.firstSite() + 1];
    }
    for (std::uint32_t place = 0; place < batch_.siteCount(); ++place)
        starEnds_[place + 1] += starEnds_[place];
    sorted_.resize(staying_.size());
    for (std::size_t i = 0; i < staying_.size(); ++i) {
        const std::uint32_t position = starEnds_[staying_[i].sites[0] - batch_.firstSite()]++;
        sorted_[position] = staying_[i];
        storedNumbers_[batch_.firstTetrahedron() + stayingNumbers_[i]] = storedCount_ + position;
    }
    starEnds_.pop_back(); // the starts have moved to the ends
}

} // namespace tetra
