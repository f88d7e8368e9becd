// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/queries/sharp_focus.h"

#include "core/model/queries/focus_division.h"
#include "core/model/queries/sharp_focus_work.h"
#include "core/model/site_places.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <numeric>
#include <string>

namespace tetra {

namespace {

/// Insertions between two looks at whether the work was cancelled.
constexpr std::size_t insertionsAtOnce = 4096;
/// Of the sites that were inserted into a kept mesh, at most one in so many is one that the region no longer asks for.
/// A tenth would start afresh at every second step of 2 % of the domain, and take twice the time.
constexpr std::size_t surplusShare = 4;

constexpr double loadingEnd = 0.4; ///< how far it is after each part
constexpr double lookingEnd = 0.5;

using Site = SiteGrid::Site;

LatticeSamples samplesOf(const Model& model)
{
    return visitSampleType(model.description().sampleType, [&]<class T>() {
        return LatticeSamples(
            std::span(reinterpret_cast<const T*>(model.samples().data()), model.samples().size() / sizeof(T)));
    });
}

} // namespace

SharpFocus::Work::Work(const Model& model)
    : model_(model), samples_(samplesOf(model)), lattice_(model.description().lattice.size)
{
}

SharpFocus::Work::Range SharpFocus::Work::rangeOf(const FocusLimits& limits) const
{
    const std::span<const float> errors = model_.runningErrors();
    const auto first = [&](double limit) {
        const auto reached = std::ranges::partition_point(errors, [&](const float& error) {
            return model_.check(error) && (std::isinf(error) || !(static_cast<double>(error) <= limit));
        });
        return static_cast<std::uint32_t>(reached - errors.begin());
    };
    const auto keeps = [&](std::uint32_t sites, double limit) {
        return sites < model_.siteCount() || static_cast<double>(model_.finalError()) <= limit;
    };
    const std::uint32_t coarse = first(limits.most), fine = first(limits.least);
    return {coarse, fine, keeps(coarse, limits.most), keeps(fine, limits.least)};
}

Status SharpFocus::Work::makeIndex()
{
    if (sites_)
        return {};
    if (!model_.check(model_.points()) || !model_.check(model_.runningErrors()))
        return model_.checkIntact();
    sites_ = SiteGrid::make(lattice_, model_.points());
    if (!sites_)
        return inconsistentModel(model_, "a site is no point of its lattice");
    return model_.checkIntact();
}

/// The sites of the fine mesh that the limits ask for.
template <class Visit>
void SharpFocus::Work::forEachSite(const FocusLimits& limits, const Range& range, Visit&& visit) const
{
    const std::span<const float> errors = model_.runningErrors();
    sites_->forEachCell(limits.firstAsked, limits.lastAsked, [&](const auto& cell, std::span<const Site> sites) {
        if (sites.empty() || !limits.mayHoldIn(cell, SiteGrid::edge - 1))
            return;
        const auto begin = std::ranges::lower_bound(sites, range.coarse, {}, &Site::number);
        for (auto site = begin; site != sites.end() && site->number < range.fine; ++site) {
            const PackedPoint point = site->point;
            if (limits.askFor({static_cast<std::uint32_t>(lattice_.x(point)),
                               static_cast<std::uint32_t>(lattice_.y(point)),
                               static_cast<std::uint32_t>(lattice_.z(point))},
                              static_cast<double>(errors[site->number])))
                visit(*site);
        }
    });
}

std::uint64_t SharpFocus::Work::sitesInside(const SpaceRamp& error)
{
    const FocusLimits limits(error, model_.description().lattice, model_.description().range.extent());
    if (!makeIndex())
        return 0;
    std::uint64_t count = 0;
    forEachSite(limits, rangeOf(limits), [&count](const Site&) { ++count; });
    return count;
}

/// Those that are no vertices yet, in the history's order.
void SharpFocus::Work::findMissing(const FocusLimits& limits, const Range& range)
{
    missing_.clear();
    forEachSite(limits, range, [this](const Site& site) {
        if (!mesh_.isVertex(site.point))
            missing_.push_back(site);
    });
    constexpr std::size_t few = 512;
    if (missing_.size() < few) {
        std::ranges::sort(missing_, {}, &Site::number);
        return;
    }
    // By digits, the last first.
    constexpr std::uint32_t digitBits = 11, digits = 1u << digitBits;
    sortRoom_.resize(missing_.size());
    for (std::uint32_t shift = 0; shift < 32 && range.fine >> shift != 0; shift += digitBits) {
        std::array<std::uint32_t, digits + 1> starts{};
        for (const Site& site : missing_)
            ++starts[(site.number >> shift & (digits - 1)) + 1];
        std::partial_sum(starts.begin(), starts.end(), starts.begin());
        for (const Site& site : missing_)
            sortRoom_[starts[site.number >> shift & (digits - 1)]++] = site;
        missing_.swap(sortRoom_);
    }
}

Status SharpFocus::Work::prepare()
{
    if (prepared_)
        return {};
    const auto division = focusDivision(model_);
    const auto metric = division ? latticeMetric(division->box(0).size, model_.description().lattice.spacing)
                                 : Result<LatticeMetric>(focusTooLarge());
    if (!metric)
        return metric.error();
    if (const Status prepared = mesh_.prepare(*division, *metric); !prepared)
        return prepared;
    prepared_ = true;
    return {};
}

Status SharpFocus::Work::load(std::uint32_t sites, const Progress& progress)
{
    if (const Status prepared = prepare(); !prepared)
        return prepared;
    if (const Status right = model_.check(model_.samples(), progress); !right)
        return right;
    coarseSites_ = 0;
    if (const Status loaded = loadCoarse(model_, sites, progress, coarse_, mesh_); !loaded)
        return loaded;
    readBounds(sites);
    coarseBoxes_.assign(lattice_, coarse_.mesh.tetrahedra, coarse_.points);
    Buffer<std::array<std::uint32_t, 4>>().swap(coarse_.mesh.tetrahedra);
    coarseSites_ = sites;
    return {};
}

/// Whether the mesh of the last query is a good start: afterwards missing_ is what it lacks.
bool SharpFocus::Work::canGoOn(const SpaceRamp& error, const FocusLimits& limits, const Range& range)
{
    if (!present_ || present_->inner != error.inner || present_->outer != error.outer ||
        present_->falloff != error.falloff || coarseSites_ != range.coarse)
        return false;
    std::size_t surplus = 0;
    for (const PackedPoint point : mesh_.added()) {
        const std::array<std::uint32_t, 3> place = {static_cast<std::uint32_t>(lattice_.x(point)),
                                                    static_cast<std::uint32_t>(lattice_.y(point)),
                                                    static_cast<std::uint32_t>(lattice_.z(point))};
        surplus += !limits.askFor(place, std::numeric_limits<double>::infinity());
    }
    // As many would be left if nothing new came: that is looked at first, because it is quick.
    const std::size_t stay = mesh_.added().size() - surplus;
    if (stay == 0 || surplus > stay)
        return false;
    findMissing(limits, range);
    return surplus * surplusShare <= mesh_.added().size() + missing_.size();
}

Status SharpFocus::Work::insertMissing(const Progress& progress)
{
    points_.clear();
    for (const Site& site : missing_) {
        points_.push_back(site.point);
        addedSites_.push_back(site.number);
    }
    for (std::size_t first = 0; first < points_.size(); first += insertionsAtOnce) {
        if (progress.cancelled())
            return cancelledError("Extracting the mesh");
        progress.report(static_cast<double>(first) / static_cast<double>(points_.size()), "Refining the focus");
        const std::size_t count = std::min(insertionsAtOnce, points_.size() - first);
        if (!mesh_.add(std::span(points_).subspan(first, count)))
            return focusTooLarge();
    }
    return {};
}

void SharpFocus::Work::write(ExtractedMesh& mesh) const
{
    writeRefined(model_, coarse_.mesh, mesh_, addedSites_, mesh);
    const Lattice& lattice = model_.description().lattice;
    const std::span<const PackedPoint> added = mesh_.added();
    samples_.visit([&](const auto* samples) {
        for (std::size_t i = 0; i < added.size(); ++i) {
            const PackedPoint point = added[i];
            const auto place = lattice.position(static_cast<std::uint32_t>(lattice_.x(point)),
                                                static_cast<std::uint32_t>(lattice_.y(point)),
                                                static_cast<std::uint32_t>(lattice_.z(point)));
            mesh.mesh.positions[coarseSites_ + i] = place.cast<float>();
            mesh.mesh.values[coarseSites_ + i] = static_cast<float>(samples[lattice_.index(point)]);
        }
    });
}

Result<ExtractedMesh> SharpFocus::Work::extract(const SpaceRamp& error, bool fresh, const Progress& progress,
                                                ExtractedMesh reuse)
{
    FocusLimits limits(error, model_.description().lattice, model_.description().range.extent());
    if (!(limits.least <= limits.most))
        return Error{ErrorKind::WrongUsage, "The error in the focus is larger than that outside. Swap them."};
    if (const Status indexed = makeIndex(); !indexed)
        return indexed.error();
    const Range range = rangeOf(limits);
    const bool goesOn = !fresh && canGoOn(error, limits, range);
    if (goesOn && presentLimits_->isBox())
        limits.settle(presentLimits_->first, presentLimits_->last);
    present_.reset();
    presentLimits_.reset();
    if (!goesOn) {
        if (coarseSites_ == range.coarse && coarseSites_ > 0)
            mesh_.restore();
        else if (const Status loaded = load(range.coarse, progress.part(0, loadingEnd)); !loaded)
            return loaded.error();
        bounds_.assign(coarseBounds_.begin(), coarseBounds_.end());
        addedSites_.clear();
        findMissing(limits, range);
    }
    if (const Status known = knowStars(range, progress.part(loadingEnd, lookingEnd)); !known)
        return known.error();
    if (const Status inserted = insertMissing(progress.part(lookingEnd, 1)); !inserted)
        return inserted.error();
    others_.clear();
    lookAtOthers(limits, range.known, progress);
    lookAtChanges(limits, true, progress);
    worst_.insert(worst_.end(), others_.begin(), others_.end());
    if (const Status repaired = repair(limits, progress); !repaired)
        return repaired.error();
    write(reuse);
    if (const Status intact = model_.checkIntact(); !intact)
        return intact.error();
    present_ = error;
    presentLimits_ = std::move(limits);
    return reuse;
}

bool SharpFocus::fits(const Model& model)
{
    return !model.samples().empty() && focusDivision(model).has_value();
}

SharpFocus::SharpFocus(const Model& model) : work_(std::make_unique<Work>(model)) {}
SharpFocus::~SharpFocus() = default;
SharpFocus::SharpFocus(SharpFocus&&) noexcept = default;
SharpFocus& SharpFocus::operator=(SharpFocus&&) noexcept = default;

std::uint64_t SharpFocus::sitesInside(const SpaceRamp& error)
{
    return work_->sitesInside(error);
}

Result<ExtractedMesh> SharpFocus::extract(const SpaceRamp& error, bool fresh, const Progress& progress,
                                          ExtractedMesh reuse)
{
    try {
        Result<ExtractedMesh> mesh = work_->extract(error, fresh, progress, std::move(reuse));
        if (!mesh && mesh.error().kind != ErrorKind::Cancelled)
            work_->forget();
        return mesh;
    } catch (const std::bad_alloc&) {
        work_->forget();
        return Error{ErrorKind::OutOfResource,
                     "Not enough memory for the mesh of the focus. Choose a larger error or a "
                     "smaller focus."};
    }
}

} // namespace tetra
