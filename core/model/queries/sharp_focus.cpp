// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/queries/sharp_focus.h"

#include "core/mesh/sample_scan.h"
#include "core/model/queries/focus_limits.h"
#include "core/model/queries/focus_division.h"
#include "core/model/queries/site_grid.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <numeric>
#include <optional>
#include <string>

namespace tetra {

namespace {

/// Insertions between two looks at whether the work was cancelled.
constexpr std::size_t insertionsAtOnce = 4096;
constexpr std::size_t repairsAtOnce = 256;
/// A kept mesh may have so many sites, as a share of those inserted, that the region no longer asks for.
constexpr std::size_t surplusShare = 10;

using Site = SiteGrid::Site;

/// Whether the second is to be repaired first: for heaps.
bool comesLater(const WorstSample& one, const WorstSample& other)
{
    return isWorse(other, one);
}

LatticeSamples samplesOf(const Model& model)
{
    return visitSampleType(model.description().sampleType, [&]<class T>() {
        return LatticeSamples(std::span(reinterpret_cast<const T*>(model.samples().data()),
                                        model.samples().size() / sizeof(T)));
    });
}

} // namespace

class SharpFocus::Work {
public:
    explicit Work(const Model& model)
        : model_(model), samples_(samplesOf(model)), lattice_(model.description().lattice.size)
    {
    }

    std::uint64_t sitesInside(const SpaceRamp& error);
    Result<ExtractedMesh> extract(const SpaceRamp& error, bool fresh, const Progress& progress, ExtractedMesh reuse);

private:
    struct Range {
        std::uint32_t coarse = 0; ///< sites of the mesh outside
        std::uint32_t fine = 0;   ///< and of the mesh within
        bool known = true;        ///< whether the mesh outside keeps its bound without looking
    };

    Range rangeOf(const FocusLimits& limits) const;
    Status makeIndex();
    Status load(std::uint32_t sites, const Progress& progress);
    template <class Visit> void forEachSite(const FocusLimits& limits, const Range& range, Visit&& visit) const;
    void findMissing(const FocusLimits& limits, const Range& range);
    bool canGoOn(const SpaceRamp& error, const FocusLimits& limits, const Range& range);
    Status insertMissing(const Progress& progress);
    Status repair(const FocusLimits& limits, const Progress& progress);
    void look(const FocusLimits& limits, bool known);
    void write(ExtractedMesh& mesh) const;
    Error notDelaunay() const;
    Error tooLarge() const;

    const Model& model_;
    LatticeSamples samples_;
    PackedLattice lattice_;
    bool prepared_ = false;
    std::optional<SiteGrid> sites_;
    LocalDelaunay mesh_;
    std::uint32_t coarseSites_ = 0; ///< of the mesh that is loaded
    TetrahedralMesh coarse_;        ///< its positions and values

    std::optional<SpaceRamp> present_; ///< what the mesh keeps now
    std::optional<FocusLimits> presentLimits_;
    std::vector<std::uint32_t> addedSites_; ///< of mesh_.added()
    std::vector<Site> missing_;
    std::vector<Site> sortRoom_;
    std::vector<PackedPoint> points_;
    std::vector<WorstSample> worst_;
};

SharpFocus::Work::Range SharpFocus::Work::rangeOf(const FocusLimits& limits) const
{
    const std::span<const float> errors = model_.runningErrors();
    const auto first = [&](double limit) {
        const auto reached = std::ranges::partition_point(
            errors, [limit](float error) { return std::isinf(error) || !(static_cast<double>(error) <= limit); });
        return static_cast<std::uint32_t>(reached - errors.begin());
    };
    const std::uint32_t coarse = first(limits.most);
    return {coarse, first(limits.least),
            coarse < model_.siteCount() || static_cast<double>(model_.finalError()) <= limits.most};
}

Status SharpFocus::Work::makeIndex()
{
    if (sites_)
        return {};
    sites_ = SiteGrid::make(lattice_, model_.points());
    if (!sites_)
        return Error{ErrorKind::BadInput, "'" + model_.path().string() +
                                              "' is damaged: a site is no point of its lattice. Copy it again from "
                                              "where it came from, or build it again."};
    return model_.checkIntact();
}

/// The sites of the fine mesh that the limits ask for.
template <class Visit>
void SharpFocus::Work::forEachSite(const FocusLimits& limits, const Range& range, Visit&& visit) const
{
    const std::span<const float> errors = model_.runningErrors();
    sites_->forEachCell(limits.first, limits.last, [&](const auto& cell, std::span<const Site> sites) {
        if (sites.empty() || !limits.mayHoldIn(cell, SiteGrid::edge - 1))
            return;
        const auto begin = std::ranges::lower_bound(sites, range.coarse, {}, &Site::number);
        for (auto site = begin; site != sites.end() && site->number < range.fine; ++site) {
            const PackedPoint point = site->point;
            const double limit =
                limits.at({static_cast<std::uint32_t>(lattice_.x(point)), static_cast<std::uint32_t>(lattice_.y(point)),
                           static_cast<std::uint32_t>(lattice_.z(point))});
            if (limit == limits.least || (limit < limits.most && static_cast<double>(errors[site->number]) > limit))
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

Status SharpFocus::Work::load(std::uint32_t sites, const Progress& progress)
{
    if (!prepared_) {
        const auto division = focusDivision(model_);
        const auto metric = division ? latticeMetric(division->box(0).size, model_.description().lattice.spacing)
                                     : Result<LatticeMetric>(tooLarge());
        if (!metric)
            return metric.error();
        if (const Status prepared = mesh_.prepare(*division, *metric); !prepared)
            return prepared;
        prepared_ = true;
    }
    coarseSites_ = 0;
    Result<TetrahedralMesh> coarse = extractPrefix(model_, sites, progress, std::move(coarse_));
    if (!coarse)
        return coarse.error();
    coarse_ = *std::move(coarse);
    Buffer<PackedPoint> points(sites);
    const auto& size = lattice_.size();
    for (std::uint32_t site = 0; site < sites; ++site) {
        const std::uint32_t point = model_.points()[site];
        points[site] = lattice_.pack(point % size[0], point / size[0] % size[1],
                                     std::min(point / size[0] / size[1], size[2] - 1));
    }
    if (!mesh_.load(coarse_.tetrahedra, points))
        return notDelaunay();
    Buffer<std::array<std::uint32_t, 4>>().swap(coarse_.tetrahedra);
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
        surplus += !(limits.at(place) < limits.most);
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
            return tooLarge();
    }
    return {};
}

/// Looks at what changed since the last look.
void SharpFocus::Work::look(const FocusLimits& limits, bool known)
{
    worst_.clear();
    scanSamples(mesh_, mesh_.changed(), samples_, limits, ScannedPart::All, worst_);
    scanUnchanged(mesh_, samples_, limits, known ? ScannedPart::Limited : ScannedPart::All, worst_);
    mesh_.acceptChanges();
}

Status SharpFocus::Work::repair(const FocusLimits& limits, const Progress& progress)
{
    std::make_heap(worst_.begin(), worst_.end(), comesLater);
    std::vector<WorstSample> found;
    for (std::size_t done = 0; !worst_.empty();) {
        std::pop_heap(worst_.begin(), worst_.end(), comesLater);
        const WorstSample worst = worst_.back();
        worst_.pop_back();
        const DelaunayTetrahedron& now = mesh_.mesh()[worst.slot];
        if (!(now.determinant() > 0) || now.vertices != worst.tetrahedron)
            continue;
        if (done++ % repairsAtOnce == 0 && progress.cancelled())
            return cancelledError("Extracting the mesh");
        if (!mesh_.add({&worst.point, 1}))
            return tooLarge();
        addedSites_.push_back(sites_->siteAt(lattice_, worst.point).value_or(ExtractedMesh::noSite));
        found.clear();
        scanSamples(mesh_, mesh_.changed(), samples_, limits, ScannedPart::All, found);
        mesh_.acceptChanges();
        for (const WorstSample& one : found) {
            worst_.push_back(one);
            std::push_heap(worst_.begin(), worst_.end(), comesLater);
        }
    }
    return {};
}

void SharpFocus::Work::write(ExtractedMesh& mesh) const
{
    mesh_.copyTetrahedra(mesh.mesh.tetrahedra);
    const std::span<const PackedPoint> added = mesh_.added();
    const std::size_t count = coarseSites_ + added.size();
    mesh.mesh.positions.resize(count);
    mesh.mesh.values.resize(count);
    mesh.sites.resize(count);
    std::ranges::copy(coarse_.positions, mesh.mesh.positions.begin());
    std::ranges::copy(coarse_.values, mesh.mesh.values.begin());
    std::iota(mesh.sites.begin(), mesh.sites.begin() + coarseSites_, 0u);
    std::ranges::copy(addedSites_, mesh.sites.begin() + coarseSites_);
    const Lattice& lattice = model_.description().lattice;
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
    mesh.wholeSites = static_cast<std::uint32_t>(count);
    mesh.wholeTetrahedra = mesh.mesh.tetrahedra.size();
    mesh.scale = 1;
    mesh.method = VariableMethod::Insertion;
}

Result<ExtractedMesh> SharpFocus::Work::extract(const SpaceRamp& error, bool fresh, const Progress& progress,
                                                ExtractedMesh reuse)
{
    FocusLimits limits(error, model_.description().lattice, model_.description().range.extent());
    if (!(limits.least <= limits.most))
        return Error{ErrorKind::WrongUsage, "The error in the focus is larger than that outside. Exchange the two."};
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
        else if (const Status loaded = load(range.coarse, progress); !loaded)
            return loaded.error();
        addedSites_.clear();
        findMissing(limits, range);
    }
    if (const Status inserted = insertMissing(progress); !inserted)
        return inserted.error();
    look(limits, range.known);
    if (const Status repaired = repair(limits, progress); !repaired)
        return repaired.error();
    write(reuse);
    if (const Status intact = model_.checkIntact(); !intact)
        return intact.error();
    present_ = error;
    presentLimits_ = std::move(limits);
    return reuse;
}

Error SharpFocus::Work::notDelaunay() const
{
    return {ErrorKind::BadInput, "'" + model_.path().string() +
                                     "' is damaged, or of another kind than the focus needs: its coarse mesh is no "
                                     "Delaunay mesh of its points. Copy it again from where it came from, or ask for "
                                     "closed sets."};
}

Error SharpFocus::Work::tooLarge() const
{
    return {ErrorKind::OutOfResource, "The mesh of the focus became too large. Choose a larger error or a smaller focus."};
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
        return work_->extract(error, fresh, progress, std::move(reuse));
    } catch (const std::bad_alloc&) {
        return Error{ErrorKind::OutOfResource, "Not enough memory for the mesh of the focus. Choose a larger error or a "
                                               "smaller focus."};
    }
}

} // namespace tetra
