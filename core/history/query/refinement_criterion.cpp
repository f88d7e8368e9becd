// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/query/refinement_criterion.h"

#include "core/base/rounding.h"
#include "core/history/build_facts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetra {

namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

double percentOf(std::uint16_t half)
{
    return 100 * static_cast<double>(halfToFloat(half));
}

/// The box outside of which the field has its largest number, whatever the value; none if it is not known.
std::optional<Eigen::AlignedBox3d> finerBox(const ErrorField& field)
{
    const SpaceRamp* const ramp = field.asSpaceRamp();
    if (ramp == nullptr || !(ramp->inner <= ramp->outer))
        return field.isConstant() ? std::optional(Eigen::AlignedBox3d()) : std::nullopt;
    const Eigen::Vector3d reach = Eigen::Vector3d::Constant(ramp->falloff);
    if (const auto* const box = std::get_if<Box>(&ramp->region))
        return Eigen::AlignedBox3d(box->least - reach, box->largest + reach);
    if (const auto* const sphere = std::get_if<Sphere>(&ramp->region)) {
        const Eigen::Vector3d radius = reach.array() + sphere->radius;
        return Eigen::AlignedBox3d(sphere->centre - radius, sphere->centre + radius);
    }
    return std::nullopt;
}

/// The largest half that is at most so many percent.
std::uint16_t halfWithin(double percent)
{
    constexpr std::uint16_t largest = 0x7bff;
    std::uint16_t half = halfRoundedUp(static_cast<float>(std::min(percent / 100, 6e4)));
    half = std::min(half, largest);
    while (half > 0 && percentOf(half) > percent)
        --half;
    return half;
}

} // namespace

RefinementCriterion::RefinementCriterion(const Model& model, const MeshQuery& query, const SitePlaces& places)
    : model_(model), query_(query), places_(places), warps_(!model.ownWarpings().empty()),
      byValue_(query.error.dependsOnValue() || (warps_ && query.warping.dependsOnValue())),
      valuesBounded_(!buildFacts(model.description()).isWeighted())
{
    const ValueRange error = query.error.bounds();
    const ValueRange warping = query.warping.bounds();
    leastError_ = error.minimum;
    largestError_ = error.maximum;
    leastWarping_ = warping.minimum;
    largestWarping_ = warping.maximum;
    const Eigen::AlignedBox3d& bounds = model.description().bounds;
    rounding_ = std::max(bounds.min().cwiseAbs().maxCoeff(), bounds.max().cwiseAbs().maxCoeff()) *
                std::numeric_limits<double>::epsilon();
    allowedAnywhere_ = halfWithin(leastError_);
    finer_ = finerBox(query.error);
    if (warps_ && finer_) {
        const std::optional<Eigen::AlignedBox3d> byWarping = finerBox(query.warping);
        finer_ = byWarping ? std::optional(finer_->merged(*byWarping)) : std::nullopt;
    }
    // A distance is rounded as what it is measured from lies far away.
    distanceRounding_ = rounding_;
    if (finer_ && !finer_->isEmpty() && finer_->min().allFinite() && finer_->max().allFinite())
        distanceRounding_ =
            std::max(rounding_, 2 * std::numeric_limits<double>::epsilon() *
                                    std::max(finer_->min().cwiseAbs().maxCoeff(), finer_->max().cwiseAbs().maxCoeff()));
    if (finer_ && finer_->contains(bounds))
        finer_.reset();
}

void RefinementCriterion::lookAtSites(std::uint32_t checkedSites)
{
    checkedSites_ = checkedSites;
    const SpaceRamp* const ramp = query_.error.asSpaceRamp();
    if (warps_ || ramp == nullptr || !(ramp->falloff > 0) || !(ramp->inner <= ramp->outer))
        return;
    slope_ = (ramp->outer - ramp->inner) / ramp->falloff;
    atSites_.resize(places_.positions.size());
    std::ranges::transform(places_.positions, atSites_.begin(),
                           [this](const Eigen::Vector3d& place) { return query_.error.at(place, 0); });
}

/// The corners of the box around a tetrahedron.
std::pair<Eigen::Array3d, Eigen::Array3d> RefinementCriterion::boxOf(const std::array<std::uint32_t, 4>& sites) const
{
    Eigen::Array3d least = places_.positions[sites[0]];
    Eigen::Array3d largest = least;
    for (const std::uint32_t site : std::span(sites).subspan<1>()) {
        const Eigen::Array3d place = places_.positions[site];
        least = least.min(place);
        largest = largest.max(place);
    }
    return {least, largest};
}

/// The field is nowhere less than at the corners less what it can fall within the box around them.
RefinementCriterion::Quick RefinementCriterion::bySites(const std::array<std::uint32_t, 4>& sites, double error) const
{
    if (atSites_.empty())
        return Quick::Unknown;
    const double least =
        std::min(std::min(atSites_[sites[0]], atSites_[sites[1]]), std::min(atSites_[sites[2]], atSites_[sites[3]]));
    if (error > least)
        return Quick::TooCoarse;
    const auto [from, to] = boxOf(sites);
    constexpr double roundedUp = 1 + 1e-12;
    const double size = (to - from).matrix().norm() * roundedUp + 4 * distanceRounding_;
    return error <= least - slope_ * size - 1e-12 * least ? Quick::Allowed : Quick::Unknown;
}

RefinementCriterion::Own RefinementCriterion::ownOf(std::uint64_t tetrahedron, std::uint32_t destroyer) const
{
    const double extent = model_.description().range.extent();
    const double weight = model_.description().warpingWeight;
    double key = model_.finalKey();
    if (destroyer < model_.siteCount()) {
        if (destroyer >= checkedSites_) // beyond what the query was expected to read
            model_.check(model_.runningKeys()[destroyer]);
        key = model_.runningKeys()[destroyer];
    }
    Own own{percentOf(model_.ownErrors()[tetrahedron]), 0};
    own.error = extent > 0 ? std::min(own.error, 100 * key / extent) : 0;
    if (warps_)
        own.warping = std::min(percentOf(model_.ownWarpings()[tetrahedron]), 100 * key / (weight * model_.diagonal()));
    return own;
}

/// A quick look at the boxes around the tetrahedron and around what is fine.
bool RefinementCriterion::isOutside(const std::array<std::uint32_t, 4>& sites, double margin) const
{
    if (!finer_)
        return false;
    const auto [least, largest] = boxOf(sites);
    return (least - margin > finer_->max().array()).any() || (largest + margin < finer_->min().array()).any();
}

/// Bounded, whatever the file says.
std::array<std::uint32_t, 4> RefinementCriterion::sitesOf(std::uint64_t tetrahedron, std::uint32_t creator) const
{
    const std::array<std::uint32_t, 3> others = model_.otherSites()[tetrahedron];
    return {creator, std::min(others[0], creator), std::min(others[1], creator), std::min(others[2], creator)};
}

RefinementCriterion::Asked RefinementCriterion::askedOf(std::uint64_t tetrahedron, std::uint32_t creator,
                                                        const Own& own) const
{
    const std::array<std::uint32_t, 4> sites = sitesOf(tetrahedron, creator);
    const double margin = rounding_ + own.warping / 100 * model_.diagonal();
    if (isOutside(sites, margin))
        return {largestError_, largestWarping_};
    std::array<Eigen::Vector3d, 4> corners;
    std::ranges::transform(sites, corners.begin(), [this](std::uint32_t site) { return places_.positions[site]; });
    ValueRange values = model_.description().range;
    if (byValue_ && valuesBounded_) {
        const double doubt = own.error / 100 * values.extent();
        const auto [least, largest] = std::ranges::minmax(
            {places_.values[sites[0]], places_.values[sites[1]], places_.values[sites[2]], places_.values[sites[3]]});
        values = {static_cast<double>(least) - doubt, static_cast<double>(largest) + doubt};
    }
    return {query_.error.leastIn(corners, margin, values),
            warps_ ? query_.warping.leastIn(corners, margin, values) : unlimited};
}

/// Most of them, without the destroyer's running key, which memory has to be waited for.
bool RefinementCriterion::isAllowedOutside(std::uint64_t tetrahedron, std::uint32_t creator) const
{
    return finer_ && !warps_ && percentOf(model_.ownErrors()[tetrahedron]) <= largestError_ &&
           isOutside(sitesOf(tetrahedron, creator), rounding_);
}

bool RefinementCriterion::tooCoarse(std::uint64_t tetrahedron, std::uint32_t creator, std::uint32_t destroyer) const
{
    if (isAllowedOutside(tetrahedron, creator))
        return false;
    const Own own = ownOf(tetrahedron, destroyer);
    if (own.error > largestError_ || own.warping > largestWarping_)
        return true;
    if (!(own.error > leastError_ || own.warping > leastWarping_))
        return false;
    const Quick quick = bySites(sitesOf(tetrahedron, creator), own.error);
    if (quick != Quick::Unknown)
        return quick == Quick::TooCoarse;
    const Asked asked = askedOf(tetrahedron, creator, own);
    return own.error > asked.error || own.warping > asked.warping;
}

double RefinementCriterion::scaleFor(std::uint64_t tetrahedron, std::uint32_t creator, std::uint32_t destroyer) const
{
    const Own own = ownOf(tetrahedron, destroyer);
    if (own.error == 0 && own.warping == 0)
        return 0;
    const Asked asked = askedOf(tetrahedron, creator, own);
    return std::max(own.error / std::max(asked.error, leastScaledPercent),
                    own.warping / std::max(asked.warping, leastScaledPercent));
}

} // namespace tetra
