// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/queries/sharp_focus.h"

#include "core/base/half.h"
#include "core/mesh/sample_scan.h"
#include "core/mesh/tetrahedron_boxes.h"
#include "core/model/queries/fine_stars.h"
#include "core/model/queries/focus_division.h"
#include "core/model/queries/focus_limits.h"
#include "core/model/queries/site_grid.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <new>
#include <numeric>
#include <optional>
#include <string>

namespace tetra {

namespace {

/// Insertions between two looks at whether the work was cancelled.
constexpr std::size_t insertionsAtOnce = 4096;
constexpr std::size_t repairsAtOnce = 256;
/// Of the sites that were inserted into a kept mesh, at most one in so many is one that the region no longer asks for.
/// A tenth would start afresh at every second step of 2 % of the domain, and take twice the time.
constexpr std::size_t surplusShare = 4;

using Site = SiteGrid::Site;

LatticeSamples samplesOf(const Model& model)
{
    return visitSampleType(model.description().sampleType, [&]<class T>() {
        return LatticeSamples(
            std::span(reinterpret_cast<const T*>(model.samples().data()), model.samples().size() / sizeof(T)));
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
    /// An insertion may have been broken off: the mesh must be loaded again.
    void forget() noexcept
    {
        coarseSites_ = 0;
        present_.reset();
    }

private:
    struct Range {
        std::uint32_t coarse = 0; ///< sites of the mesh outside
        std::uint32_t fine = 0;   ///< and of the mesh within
        bool known = true;        ///< whether the mesh outside keeps its bound without looking
        bool fineKnown = true;    ///< likewise that within
    };

    Range rangeOf(const FocusLimits& limits) const;
    Status makeIndex();
    Status load(std::uint32_t sites, const Progress& progress);
    template <class Visit> void forEachSite(const FocusLimits& limits, const Range& range, Visit&& visit) const;
    void findMissing(const FocusLimits& limits, const Range& range);
    bool canGoOn(const SpaceRamp& error, const FocusLimits& limits, const Range& range);
    Status insertMissing(const Progress& progress);
    Status repair(const FocusLimits& limits, const Progress& progress);
    void scan(const FocusLimits& limits, ScannedPart part, std::vector<WorstSample>& worst) const;
    void lookAtChanges(const FocusLimits& limits, bool mayBeKnown);
    void lookAtOthers(const FocusLimits& limits, bool outsideIsKnown);
    Status knowStars(const Range& range);
    void readBounds(std::uint32_t sites);
    bool isKnown(std::uint32_t slot) const;
    void write(ExtractedMesh& mesh) const;
    Error damaged(const std::string& what) const;
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
    TetrahedronBoxes coarseBoxes_;
    Buffer<float> coarseBounds_;    ///< on the errors of its tetrahedra
    std::optional<FineStars> fine_; ///< of the mesh within
    Buffer<float> bounds_;          ///< on the error in each slot, infinite if not known
    std::vector<std::uint32_t> slots_;

    std::optional<SpaceRamp> present_; ///< what the mesh keeps now
    std::optional<FocusLimits> presentLimits_;
    std::vector<std::uint32_t> addedSites_; ///< of mesh_.added()
    std::vector<Site> missing_;
    std::vector<Site> sortRoom_;
    std::vector<PackedPoint> points_;
    std::vector<WorstSample> worst_;
    std::vector<WorstSample> others_;
};

SharpFocus::Work::Range SharpFocus::Work::rangeOf(const FocusLimits& limits) const
{
    const std::span<const float> errors = model_.runningErrors();
    const auto first = [&](double limit) {
        const auto reached = std::ranges::partition_point(
            errors, [limit](float error) { return std::isinf(error) || !(static_cast<double>(error) <= limit); });
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
    sites_ = SiteGrid::make(lattice_, model_.points());
    if (!sites_)
        return damaged("a site is no point of its lattice");
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
        points[site] =
            lattice_.pack(point % size[0], point / size[0] % size[1], std::min(point / size[0] / size[1], size[2] - 1));
    }
    if (!mesh_.load(coarse_.tetrahedra, points))
        return notDelaunay();
    readBounds(sites);
    coarseBoxes_.assign(lattice_, coarse_.tetrahedra, points);
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
            return tooLarge();
    }
    return {};
}

/// The file's bounds on the errors of the coarse mesh's tetrahedra, in the order in which extraction gives these.
void SharpFocus::Work::readBounds(std::uint32_t sites)
{
    const double extent = model_.description().range.extent();
    coarseBounds_.assign(coarse_.tetrahedra.size(), std::numeric_limits<float>::infinity());
    std::size_t slot = 0;
    const std::uint64_t end = std::min(model_.starOffsets()[sites], model_.tetrahedronCount());
    for (std::uint64_t t = 0; t < end && slot < coarseBounds_.size(); ++t)
        if (model_.destroyers()[t] >= sites)
            coarseBounds_[slot++] =
                static_cast<float>(static_cast<double>(halfToFloat(model_.ownErrors()[t])) * extent * (1 + 1e-6));
}

Status SharpFocus::Work::knowStars(const Range& range)
{
    // Beyond what the model has the bound is not known.
    const std::uint32_t sites = range.fineKnown ? range.fine : 0;
    if (fine_ && fine_->firstCreator() == range.coarse && fine_->siteCount() == sites)
        return {};
    fine_ = FineStars::make(model_, range.coarse, sites);
    if (!fine_)
        return damaged("its star offsets make no sense");
    return {};
}

/// Whether the tetrahedron is one of the uniform fine mesh.
bool SharpFocus::Work::isKnown(std::uint32_t slot) const
{
    std::array<std::uint32_t, 4> sites = mesh_.numbers(slot);
    for (std::uint32_t& site : sites)
        site = site < coarseSites_ ? site : addedSites_[site - coarseSites_];
    return fine_->holds(sites);
}

/// Looks at slots_. In pieces whose findings are put together in order: it does not matter how many threads there are.
void SharpFocus::Work::scan(const FocusLimits& limits, ScannedPart part, std::vector<WorstSample>& worst) const
{
    constexpr std::size_t pieceSlots = 512;
    const std::size_t count = (slots_.size() + pieceSlots - 1) / pieceSlots;
    std::vector<std::vector<WorstSample>> found(count);
    const auto scanPiece = [&](std::size_t piece) {
        const std::size_t first = piece * pieceSlots;
        scanSamples(mesh_, std::span(slots_).subspan(first, std::min(pieceSlots, slots_.size() - first)), samples_,
                    limits, part, found[piece]);
    };
    if (count < 2)
        for (std::size_t piece = 0; piece < count; ++piece)
            scanPiece(piece);
    else
        tbb::parallel_for(std::size_t(0), count, scanPiece);
    for (const std::vector<WorstSample>& some : found)
        worst.insert(worst.end(), some.begin(), some.end());
}

/// Looks at what changed since the last look, unless its error is known to be small enough.
void SharpFocus::Work::lookAtChanges(const FocusLimits& limits, bool mayBeKnown)
{
    worst_.clear();
    slots_.clear();
    bounds_.resize(mesh_.mesh().slotCount());
    for (const std::uint32_t slot : mesh_.changed()) {
        if (mesh_.mesh()[slot].determinant() == 0) {
            bounds_[slot] = 0;
            continue;
        }
        const bool known = mayBeKnown && isKnown(slot);
        bounds_[slot] = known ? static_cast<float>(limits.least) : std::numeric_limits<float>::infinity();
        if (!known)
            slots_.push_back(slot);
    }
    scan(limits, ScannedPart::All, worst_);
    mesh_.acceptChanges();
}

/// Looks at what is inside now and did not change.
void SharpFocus::Work::lookAtOthers(const FocusLimits& limits, bool outsideIsKnown)
{
    slots_.clear();
    const auto least = static_cast<float>(limits.least);
    bounds_.resize(mesh_.mesh().slotCount(), 0);
    for (const std::uint32_t slot : mesh_.changed())
        bounds_[slot] = 0;
    const auto isUnknown = [&](std::uint32_t slot) { return bounds_[slot] > least; };
    if (outsideIsKnown) {
        coarseBoxes_.findMeeting(limits.first, limits.last, slots_);
        std::erase_if(slots_, std::not_fn(isUnknown));
    } else {
        for (std::uint32_t slot = 0; slot < coarseBounds_.size(); ++slot)
            if (isUnknown(slot))
                slots_.push_back(slot);
    }
    // What is in place of a coarse tetrahedron may be elsewhere.
    for (const std::uint32_t slot : mesh_.changedEarlier())
        if (slot < coarseBounds_.size() && isUnknown(slot))
            slots_.push_back(slot);
    for (auto slot = static_cast<std::uint32_t>(coarseBounds_.size()); slot < bounds_.size(); ++slot)
        if (isUnknown(slot))
            slots_.push_back(slot);
    scan(limits, outsideIsKnown ? ScannedPart::Limited : ScannedPart::All, others_);
}

/// In rounds: the worst sample of each tetrahedron that is not good enough, the worst first, unless one before it has
/// changed its tetrahedron; then what changed is looked at.
Status SharpFocus::Work::repair(const FocusLimits& limits, const Progress& progress)
{
    while (!worst_.empty()) {
        std::ranges::sort(worst_, isWorse);
        for (std::size_t i = 0; i < worst_.size(); ++i) {
            if (i % repairsAtOnce == 0 && progress.cancelled())
                return cancelledError("Extracting the mesh");
            const WorstSample& worst = worst_[i];
            const DelaunayTetrahedron& now = mesh_.mesh()[worst.slot];
            // Of blocks, several have the sample if it is on their borders.
            if (!(now.determinant() > 0) || now.vertices != worst.tetrahedron)
                continue;
            if (!mesh_.add({&worst.point, 1}))
                return tooLarge();
            addedSites_.push_back(sites_->siteAt(lattice_, worst.point).value_or(ExtractedMesh::noSite));
        }
        lookAtChanges(limits, false);
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
        bounds_.assign(coarseBounds_.begin(), coarseBounds_.end());
        addedSites_.clear();
        findMissing(limits, range);
    }
    if (const Status known = knowStars(range); !known)
        return known.error();
    if (const Status inserted = insertMissing(progress); !inserted)
        return inserted.error();
    others_.clear();
    lookAtOthers(limits, range.known);
    lookAtChanges(limits, true);
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

Error SharpFocus::Work::damaged(const std::string& what) const
{
    return {ErrorKind::BadInput, "'" + model_.path().string() + "' is damaged: " + what +
                                     ". Copy it again from where it came from, or build it again."};
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
    return {ErrorKind::OutOfResource,
            "The mesh of the focus became too large. Choose a larger error or a smaller focus."};
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
