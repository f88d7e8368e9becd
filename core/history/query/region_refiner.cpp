// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/query/region_refiner.h"

#include "core/base/guarded.h"
#include "core/base/simd.h"
#include "core/history/build_facts.h"
#include "core/history/query/coarse_mesh.h"
#include "core/history/site_positions.h"
#include "core/history/walk.h"
#include "core/refine/greedy.h"
#include "core/refine/insertion/sample_scan.h"
#include "core/refine/lattice/packed_lattice.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

namespace tetra {

namespace {

/// Coordinates that do not fit count as the largest that do, everywhere: then boxes are only larger.
std::uint16_t shortened(std::int32_t coordinate)
{
    return static_cast<std::uint16_t>(std::clamp(coordinate, 0, 0xffff));
}

constexpr std::size_t boxesAtOnce = 4096;

TETRA_SIMD_INLINE void keepMeeting(const std::uint16_t* first, const std::uint16_t* last, std::size_t count,
                                   std::uint16_t from, std::uint16_t to, std::uint16_t* meets)
{
    for (std::size_t i = 0; i < count; ++i)
        meets[i] = static_cast<std::uint16_t>(meets[i] & (first[i] <= to ? 1 : 0) & (last[i] >= from ? 1 : 0));
}

} // namespace

// What RegionRefiner::Work is made of lies in no anonymous namespace, because Work itself has external linkage.

/// The bounding boxes of many tetrahedra, side by side so that all are compared with a box at a glance: 12 bytes each.
class TetrahedronBoxes {
public:
    /// May throw std::bad_alloc, as the others.
    void assign(const PackedLattice& lattice, std::span<const std::array<std::uint32_t, 4>> tetrahedra,
                std::span<const PackedPoint> vertices);

    /// Appends the numbers of those that may have a point in common with the box; never too few. O(tetrahedra), some
    /// thousand million a second.
    void findMeeting(const std::array<std::int32_t, 3>& first, const std::array<std::int32_t, 3>& last,
                     std::vector<std::uint32_t>& found) const;

private:
    std::array<Buffer<std::uint16_t>, 3> first_;
    std::array<Buffer<std::uint16_t>, 3> last_;
};

void TetrahedronBoxes::assign(const PackedLattice& lattice, std::span<const std::array<std::uint32_t, 4>> tetrahedra,
                              std::span<const PackedPoint> vertices)
{
    for (std::size_t axis = 0; axis < 3; ++axis) {
        first_[axis].resize(tetrahedra.size());
        last_[axis].resize(tetrahedra.size());
    }
    for (std::size_t i = 0; i < tetrahedra.size(); ++i) {
        const auto keep = [&](std::size_t axis, auto coordinate) {
            const auto& [a, b, c, d] = tetrahedra[i];
            const auto [least, largest] = std::minmax(
                {coordinate(vertices[a]), coordinate(vertices[b]), coordinate(vertices[c]), coordinate(vertices[d])});
            first_[axis][i] = shortened(least);
            last_[axis][i] = shortened(largest);
        };
        keep(0, [&](PackedPoint point) { return lattice.x(point); });
        keep(1, [&](PackedPoint point) { return lattice.y(point); });
        keep(2, [&](PackedPoint point) { return lattice.z(point); });
    }
}

void TetrahedronBoxes::findMeeting(const std::array<std::int32_t, 3>& first, const std::array<std::int32_t, 3>& last,
                                   std::vector<std::uint32_t>& found) const
{
    const std::size_t count = first_[0].size();
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (first[axis] > last[axis])
            return;
    std::array<std::uint16_t, boxesAtOnce> meets{};
    for (std::size_t start = 0; start < count; start += boxesAtOnce) {
        const std::size_t piece = std::min(boxesAtOnce, count - start);
        meets.fill(1);
        for (std::size_t axis = 0; axis < 3; ++axis)
            dispatch<keepMeeting>(first_[axis].data() + start, last_[axis].data() + start, piece,
                                  shortened(first[axis]), shortened(last[axis]), meets.data());
        for (std::size_t i = 0; i < piece; ++i)
            if (meets[i] != 0)
                found.push_back(static_cast<std::uint32_t>(start + i));
    }
}

namespace {

/// The box around a region; infinite if the region is.
Box boundsOf(const Region& region)
{
    if (const Box* const box = std::get_if<Box>(&region))
        return *box;
    if (const Sphere* const sphere = std::get_if<Sphere>(&region))
        return {sphere->centre.array() - sphere->radius, sphere->centre.array() + sphere->radius};
    const Eigen::Vector3d infinite = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
    return {-infinite, infinite};
}

} // namespace

/// A ramp in space at the points of a lattice, in units of the values: exactly what ErrorField::at() says there.
class FocusLimits final : public ErrorLimits {
public:
    FocusLimits(const SpaceRamp& ramp, const Lattice& lattice, double valueExtent);

    double at(const std::array<std::uint32_t, 3>& point) const override
    {
        if (!quick_)
            return fieldAt(point);
        return inside_[0][point[0]] && inside_[1][point[1]] && inside_[2][point[2]] ? least : most;
    }
    /// Whether a site should be a vertex before any sample is examined: the mesh before it was not accurate enough here
    /// or, for a box, one step away. Leaving out the sites next to a border would mean more repairs, which take longer.
    bool wants(const std::array<std::uint32_t, 3>& point, double runningError) const
    {
        if (!quick_) {
            const double limit = fieldAt(point);
            return limit < most && runningError > limit;
        }
        bool near = true;
        for (std::size_t axis = 0; axis < 3; ++axis)
            near &= static_cast<std::int32_t>(point[axis]) >= firstAsked[axis] &&
                    static_cast<std::int32_t>(point[axis]) <= lastAsked[axis];
        return near && runningError > least;
    }
    /// All such sites lie between these two.
    std::array<std::int32_t, 3> firstAsked{0, 0, 0};
    std::array<std::int32_t, 3> lastAsked{-1, -1, -1};
    /// Whether a limit below the largest can hold in a cube of points: false only if not.
    bool mayHoldIn(const std::array<std::uint32_t, 3>& first, std::uint32_t edge) const;
    /// Whether the limits are the least in a box of points and the largest in all others.
    bool isBox() const noexcept { return quick_; }

private:
    double fieldAt(const std::array<std::uint32_t, 3>& point) const;
    Eigen::AlignedBox3d indicesIn(const Box& bounds, double margin) const;
    void findRange();

    ErrorField field_;
    Lattice lattice_;
    double extent_ = 0;
    bool quick_ = false;
    std::array<std::vector<char>, 3> inside_; ///< along each axis, if quick
};

FocusLimits::FocusLimits(const SpaceRamp& ramp, const Lattice& lattice, double valueExtent)
    : field_(ramp), lattice_(lattice), extent_(valueExtent)
{
    const SpaceRamp& clean = *field_.asSpaceRamp();
    least = clean.inner / 100 * extent_;
    most = clean.outer / 100 * extent_;
    quick_ = std::holds_alternative<Box>(clean.region) && clean.falloff == 0 && lattice.isAlongAxes();
    twoValued = quick_;
    findRange();
}

/// In a frame that is not along the axes, where a box of the world is in indices: what its corners span.
Eigen::AlignedBox3d FocusLimits::indicesIn(const Box& bounds, double margin) const
{
    // A region without an end reaches over all of the lattice.
    const Eigen::AlignedBox3d domain = lattice_.bounds();
    const Eigen::Vector3d least = (bounds.least.array() - margin).max(domain.min().array() - margin).matrix();
    const Eigen::Vector3d largest = (bounds.largest.array() + margin).min(domain.max().array() + margin).matrix();
    Eigen::AlignedBox3d indices;
    if ((least.array() > largest.array()).any())
        return indices;
    for (unsigned corner = 0; corner < 8; ++corner)
        indices.extend(
            lattice_.indicesAt({(corner & 1) != 0 ? least[0] : largest[0], (corner & 2) != 0 ? least[1] : largest[1],
                                (corner & 4) != 0 ? least[2] : largest[2]}));
    return indices;
}

void FocusLimits::findRange()
{
    const SpaceRamp& ramp = *field_.asSpaceRamp();
    const Box bounds = boundsOf(ramp.region);
    // Rounding may make a distance a little less than it is.
    const double reach = ramp.falloff * (1 + 1e-9);
    const bool alongAxes = lattice_.isAlongAxes();
    const double farthest = lattice_.bounds().min().cwiseAbs().cwiseMax(lattice_.bounds().max().cwiseAbs()).maxCoeff();
    const Eigen::AlignedBox3d indices = alongAxes ? Eigen::AlignedBox3d() : indicesIn(bounds, reach + 1e-9 * farthest);
    for (int axis = 0; axis < 3; ++axis) {
        const auto count = lattice_.size[static_cast<std::size_t>(axis)];
        std::vector<char> inside(count);
        const double margin =
            quick_ ? 0 : reach + 1e-9 * (std::abs(lattice_.origin[axis]) + lattice_.spacing[axis] * count);
        std::array<std::uint32_t, 3> point{0, 0, 0};
        for (std::uint32_t i = 0; i < count; ++i) {
            if (!alongAxes) {
                inside[i] = i >= indices.min()[axis] - 1e-6 && i <= indices.max()[axis] + 1e-6;
                continue;
            }
            point[static_cast<std::size_t>(axis)] = i;
            const double place = lattice_.position(point[0], point[1], point[2])[axis];
            inside[i] = !(place < bounds.least[axis] - margin) && !(place > bounds.largest[axis] + margin);
        }
        const auto from = std::ranges::find(inside, 1);
        const auto to = std::find(inside.rbegin(), inside.rend(), 1).base();
        first[static_cast<std::size_t>(axis)] = static_cast<std::int32_t>(from - inside.begin());
        last[static_cast<std::size_t>(axis)] = static_cast<std::int32_t>(to - inside.begin()) - 1;
        inside_[static_cast<std::size_t>(axis)] = std::move(inside);
    }
    firstAsked = first;
    lastAsked = last;
    for (std::size_t axis = 0; axis < 3 && quick_; ++axis) {
        firstAsked[axis] = std::max(first[axis] - 1, 0);
        lastAsked[axis] = std::min(lastAsked[axis] + 1, static_cast<std::int32_t>(lattice_.size[axis]) - 1);
    }
    if (quick_ && (first[0] > last[0] || first[1] > last[1] || first[2] > last[2]))
        lastAsked = {-1, -1, -1};
}

double FocusLimits::fieldAt(const std::array<std::uint32_t, 3>& point) const
{
    return field_.at(lattice_.position(point[0], point[1], point[2]), 0) / 100 * extent_;
}

bool FocusLimits::mayHoldIn(const std::array<std::uint32_t, 3>& cube, std::uint32_t edge) const
{
    if (quick_)
        return true;
    const SpaceRamp& ramp = *field_.asSpaceRamp();
    const Eigen::Vector3d size = lattice_.step(Eigen::Vector3d::Constant(edge));
    const Eigen::Vector3d middle = lattice_.position(cube[0], cube[1], cube[2]) + size / 2;
    double diagonal = 0; // the longest of four: of a sheared cube they differ
    for (const Eigen::Vector3d& signs :
         {Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(-1, 1, 1), Eigen::Vector3d(1, -1, 1), Eigen::Vector3d(1, 1, -1)})
        diagonal = std::max(diagonal, lattice_.step(signs * edge).norm());
    const double reach =
        diagonal / 2 + ramp.falloff + 1e-9 * (middle.cwiseAbs().maxCoeff() + size.cwiseAbs().maxCoeff());
    return !(distanceTo(ramp.region, middle) > reach);
}

namespace {

/// What is kept for a point takes memory only where it is touched, but address space everywhere.
constexpr std::uint64_t mostPoints = 1ull << 30;

} // namespace

std::optional<BlockDivision> focusDivision(const Model& model)
{
    const Lattice& lattice = model.description().lattice;
    if (model.description().domain != DomainClass::RegularLattice || !model.description().delaunay ||
        buildFacts(model.description()).isWeighted() || lattice.pointCount() > mostPoints ||
        !PackedLattice::fits(lattice.size))
        return std::nullopt;
    const std::span<const float> errors = model.runningKeys();
    const auto end = std::ranges::partition_point(
        errors, [&](const float& error) { return model.check(error) && std::isinf(error); });
    const auto points = model.points().first(static_cast<std::size_t>(end - errors.begin()));
    if (!model.check(points))
        return std::nullopt;
    const auto edge = edgeOfBlocks(lattice.size, points);
    if (!edge)
        return std::nullopt;
    const BlockDivision division(lattice.size, *edge);
    if (!latticeMetric(division.box(0).size, model.description().meshSpacing()))
        return std::nullopt;
    return division;
}

/// The sites of a lattice model by where they lie: cells of 8^3 points, each with its sites in rising order. 8 bytes a
/// site. Making it takes two passes over the sites.
class SiteGrid {
public:
    static constexpr std::uint32_t edge = 8;
    struct Site {
        std::uint32_t number;
        PackedPoint point;
    };

    SiteGrid() = default;
    /// Of points given by their indices in the lattice. None if an index is too large.
    static std::optional<SiteGrid> make(const PackedLattice& lattice, std::span<const std::uint32_t> points);

    /// Calls visit(first point, sites) for each cell that has points between the two, ends included.
    template <class Visit> void forEachCell(const std::array<std::int32_t, 3>& first,
                                            const std::array<std::int32_t, 3>& last, Visit&& visit) const
    {
        for (std::int32_t z = first[2] / step; z <= floorOf(last[2]); ++z)
            for (std::int32_t y = first[1] / step; y <= floorOf(last[1]); ++y)
                for (std::int32_t x = first[0] / step; x <= floorOf(last[0]); ++x)
                    visit(std::array<std::uint32_t, 3>{std::uint32_t(x) * edge, std::uint32_t(y) * edge,
                                                       std::uint32_t(z) * edge},
                          cell((std::uint64_t(z) * counts_[1] + std::uint64_t(y)) * counts_[0] + std::uint64_t(x)));
    }
    /// The site at a point, or none.
    std::optional<std::uint32_t> siteAt(const PackedLattice& lattice, PackedPoint point) const;

private:
    static constexpr std::int32_t step = edge;
    static std::int32_t floorOf(std::int32_t coordinate) { return coordinate < 0 ? -1 : coordinate / step; }
    std::span<const Site> cell(std::uint64_t number) const
    {
        return std::span(sites_).subspan(starts_[number], starts_[number + 1] - starts_[number]);
    }

    std::array<std::uint32_t, 3> counts_{};
    std::vector<std::uint32_t> starts_{0};
    Buffer<Site> sites_;
};

std::optional<SiteGrid> SiteGrid::make(const PackedLattice& lattice, std::span<const std::uint32_t> points)
{
    SiteGrid grid;
    const auto& size = lattice.size();
    for (std::size_t axis = 0; axis < 3; ++axis)
        grid.counts_[axis] = (size[axis] + edge - 1) / edge;
    const std::uint64_t pointCount = std::uint64_t(size[0]) * size[1] * size[2];
    Buffer<PackedPoint> packed(points.size());
    for (std::size_t site = 0; site < points.size(); ++site) {
        const std::uint32_t point = points[site];
        if (point >= pointCount)
            return std::nullopt;
        const std::uint32_t row = point / size[0];
        packed[site] = lattice.pack(point - row * size[0], row % size[1], row / size[1]);
    }
    const auto cellOf = [&](PackedPoint point) {
        const auto part = [](std::int32_t coordinate) { return std::uint64_t(coordinate) / edge; };
        return (part(lattice.z(point)) * grid.counts_[1] + part(lattice.y(point))) * grid.counts_[0] +
               part(lattice.x(point));
    };
    grid.starts_.assign(std::uint64_t(grid.counts_[0]) * grid.counts_[1] * grid.counts_[2] + 2, 0);
    for (const PackedPoint point : packed)
        ++grid.starts_[cellOf(point) + 2];
    for (std::size_t cell = 2; cell < grid.starts_.size(); ++cell)
        grid.starts_[cell] += grid.starts_[cell - 1];
    grid.sites_.resize(points.size());
    for (std::uint32_t site = 0; site < packed.size(); ++site)
        grid.sites_[grid.starts_[cellOf(packed[site]) + 1]++] = {site, packed[site]};
    return grid;
}

std::optional<std::uint32_t> SiteGrid::siteAt(const PackedLattice& lattice, PackedPoint point) const
{
    const std::array<std::int32_t, 3> place = {lattice.x(point), lattice.y(point), lattice.z(point)};
    std::optional<std::uint32_t> found;
    forEachCell(place, place, [&](const auto&, std::span<const Site> sites) {
        const auto site = std::ranges::find(sites, point, &Site::point);
        if (site != sites.end())
            found = site->number;
    });
    return found;
}

/// The tetrahedra of a prefix of the history, to ask for one by its sites: what a mesh has in common with the prefix's
/// keeps the prefix's error. 8 bytes for each tetrahedron that is alive, made in one pass.
class TetrahedronSet {
public:
    TetrahedronSet() = default;
    /// Of the first `sites` sites, but only what those from `firstCreator` on created. Errors: a damaged file,
    /// cancelled.
    static Result<TetrahedronSet> make(const Model& model, std::uint32_t firstCreator, std::uint32_t sites,
                                       const Progress& progress);

    std::uint32_t firstCreator() const noexcept { return firstCreator_; }
    std::uint32_t siteCount() const noexcept { return siteCount_; }

    /// Whether the tetrahedron is in the prefix's mesh; any order of sites, some of which may be no sites. Tetrahedra
    /// that are not are taken for others with a probability of 2^-60.
    bool holds(const std::array<std::uint32_t, 4>& sites) const;

    /// Fetches what holds() will look at.
    void prefetch(const std::array<std::uint32_t, 4>& sites) const
    {
        if (const std::uint32_t creator = std::ranges::max(sites); creator >= firstCreator_ && creator < siteCount_)
            __builtin_prefetch(keys_.data() + starts_[creator - firstCreator_]);
    }

private:
    static std::uint64_t keyOf(std::uint64_t a, std::uint64_t b, std::uint64_t c)
    {
        // Symmetric, and what is equal in all three is the same set.
        return (a + b + c) * 0x9e3779b97f4a7c15 + (a * b + b * c + c * a) * 0xbf58476d1ce4e5b9 +
               a * b * c * 0x94d049bb133111eb;
    }

    std::uint32_t firstCreator_ = 0;
    std::uint32_t siteCount_ = 0;
    std::vector<std::uint32_t> starts_; ///< of each creator's keys
    std::vector<std::uint64_t> keys_;
};

Result<TetrahedronSet> TetrahedronSet::make(const Model& model, std::uint32_t firstCreator, std::uint32_t sites,
                                            const Progress& progress)
{
    TetrahedronSet stars;
    stars.firstCreator_ = firstCreator;
    stars.siteCount_ = sites;
    if (firstCreator >= sites)
        return stars;
    model.check(model.meshSizes()[sites - 1]); // what it finds is known to checkIntact()
    stars.starts_.reserve(sites - firstCreator + 1);
    stars.keys_.reserve(std::min<std::uint64_t>(model.meshSizes()[sites - 1], model.tetrahedronCount()));
    const auto visit = [&](const Stars& piece) -> Status {
        for (std::size_t star = 0; star + 1 < piece.offsets.size(); ++star) {
            stars.starts_.push_back(static_cast<std::uint32_t>(stars.keys_.size()));
            for (std::uint64_t t = piece.offsets[star]; t < piece.offsets[star + 1]; ++t)
                if (piece.destroyers[t] >= sites) {
                    const auto& [a, b, c] = piece.otherSites[t];
                    stars.keys_.push_back(keyOf(a, b, c));
                }
        }
        return {};
    };
    if (const Status walked =
            walkHistory(model, firstCreator, sites, progress, Message::marked("Reading the history"), visit);
        !walked)
        return walked.error();
    stars.starts_.push_back(static_cast<std::uint32_t>(stars.keys_.size()));
    return stars;
}

bool TetrahedronSet::holds(const std::array<std::uint32_t, 4>& sites) const
{
    const std::size_t latest = static_cast<std::size_t>(std::ranges::max_element(sites) - sites.begin());
    const std::uint32_t creator = sites[latest];
    if (creator < firstCreator_ || creator >= siteCount_)
        return false;
    const std::uint64_t key = keyOf(sites[(latest + 1) % 4], sites[(latest + 2) % 4], sites[(latest + 3) % 4]);
    const std::uint64_t* const begin = keys_.data() + starts_[creator - firstCreator_];
    const std::uint64_t* const end = keys_.data() + starts_[creator - firstCreator_ + 1];
    bool found = false;
    for (const std::uint64_t* at = begin; at != end; ++at)
        found |= *at == key;
    return found;
}

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

/// What is kept from query to query: the coarse mesh, refined for the last of them, and what is known of its errors.
class RegionRefiner::Work {
public:
    explicit Work(const Model& model);

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
    Status prepare();
    Status load(std::uint32_t sites, const Progress& progress);
    template <class Visit> void forEachSite(const FocusLimits& limits, const Range& range, Visit&& visit) const;
    void findMissing(const FocusLimits& limits, const Range& range);
    bool canGoOn(const SpaceRamp& error, const FocusLimits& limits, const Range& range);
    Status insertMissing(const Progress& progress);
    Status repair(const FocusLimits& limits, const Progress& progress);
    void scan(const FocusLimits& limits, ScannedPart part, const Progress& progress, std::vector<WorstSample>& worst);
    void lookAtChanges(const FocusLimits& limits, bool mayBeKnown, const Progress& progress);
    void lookAtOthers(const FocusLimits& limits, bool outsideIsKnown, const Progress& progress);
    Status knowStars(const Range& range, const Progress& progress);
    Status readBounds(std::uint32_t sites);
    std::array<std::uint32_t, 4> sitesOf(std::uint32_t slot) const;
    void write(ExtractedMesh& mesh) const;

    const Model& model_;
    LatticeSamples samples_;
    PackedLattice lattice_;
    bool prepared_ = false;
    std::optional<SiteGrid> sites_;
    LocalDelaunay mesh_;
    std::uint32_t coarseSites_ = 0; ///< of the mesh that is loaded
    CoarseMesh coarse_;             ///< without its tetrahedra
    TetrahedronBoxes coarseBoxes_;
    Buffer<float> coarseBounds_;         ///< on the errors of its tetrahedra
    std::optional<TetrahedronSet> fine_; ///< of the mesh within
    Buffer<float> bounds_;               ///< on the error in each slot, infinite if not known
    std::vector<std::uint32_t> slots_;

    std::optional<SpaceRamp> present_; ///< what the mesh keeps now
    std::optional<FocusLimits> presentLimits_;
    std::vector<std::uint32_t> addedSites_; ///< of mesh_.added()
    std::vector<SiteGrid::Site> missing_;
    std::vector<SiteGrid::Site> sortScratch_;
    std::vector<PackedPoint> points_;
    Round<WorstSample> worst_;
    std::vector<WorstSample> others_;
};

RegionRefiner::Work::Work(const Model& model)
    : model_(model), samples_(samplesOf(model)), lattice_(model.description().lattice.size)
{
}

RegionRefiner::Work::Range RegionRefiner::Work::rangeOf(const FocusLimits& limits) const
{
    const std::span<const float> errors = model_.runningKeys();
    const auto first = [&](double limit) {
        const auto reached = std::ranges::partition_point(errors, [&](const float& error) {
            return model_.check(error) && (std::isinf(error) || !(static_cast<double>(error) <= limit));
        });
        return static_cast<std::uint32_t>(reached - errors.begin());
    };
    const auto keeps = [&](std::uint32_t sites, double limit) {
        return sites < model_.siteCount() || static_cast<double>(model_.finalKey()) <= limit;
    };
    const std::uint32_t coarse = first(limits.most), fine = first(limits.least);
    return {coarse, fine, keeps(coarse, limits.most), keeps(fine, limits.least)};
}

Status RegionRefiner::Work::makeIndex()
{
    if (sites_)
        return {};
    if (!model_.check(model_.points()) || !model_.check(model_.runningKeys()))
        return model_.checkIntact();
    sites_ = SiteGrid::make(lattice_, model_.points());
    if (!sites_)
        return inconsistentModel(model_, Message::say("a site is not a point of its lattice"));
    return model_.checkIntact();
}

/// The sites of the fine mesh that the limits ask for.
template <class Visit>
void RegionRefiner::Work::forEachSite(const FocusLimits& limits, const Range& range, Visit&& visit) const
{
    const std::span<const float> errors = model_.runningKeys();
    sites_->forEachCell(limits.firstAsked, limits.lastAsked, [&](const auto& cell, std::span<const Site> sites) {
        if (sites.empty() || !limits.mayHoldIn(cell, SiteGrid::edge - 1))
            return;
        const auto begin = std::ranges::lower_bound(sites, range.coarse, {}, &Site::number);
        for (auto site = begin; site != sites.end() && site->number < range.fine; ++site) {
            const PackedPoint point = site->point;
            if (limits.wants({static_cast<std::uint32_t>(lattice_.x(point)),
                              static_cast<std::uint32_t>(lattice_.y(point)),
                              static_cast<std::uint32_t>(lattice_.z(point))},
                             static_cast<double>(errors[site->number])))
                visit(*site);
        }
    });
}

std::uint64_t RegionRefiner::Work::sitesInside(const SpaceRamp& error)
{
    const FocusLimits limits(error, model_.description().lattice, model_.description().range.extent());
    if (!makeIndex())
        return 0;
    std::uint64_t count = 0;
    forEachSite(limits, rangeOf(limits), [&count](const Site&) { ++count; });
    return count;
}

/// Those that are no vertices yet, in the history's order.
void RegionRefiner::Work::findMissing(const FocusLimits& limits, const Range& range)
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
    sortScratch_.resize(missing_.size());
    for (std::uint32_t shift = 0; shift < 32 && range.fine >> shift != 0; shift += digitBits) {
        std::array<std::uint32_t, digits + 1> starts{};
        for (const Site& site : missing_)
            ++starts[(site.number >> shift & (digits - 1)) + 1];
        std::partial_sum(starts.begin(), starts.end(), starts.begin());
        for (const Site& site : missing_)
            sortScratch_[starts[site.number >> shift & (digits - 1)]++] = site;
        missing_.swap(sortScratch_);
    }
}

Status RegionRefiner::Work::prepare()
{
    if (prepared_)
        return {};
    const auto division = focusDivision(model_);
    const auto metric = division ? latticeMetric(division->box(0).size, model_.description().meshSpacing())
                                 : Result<LatticeMetric>(focusTooLarge());
    if (!metric)
        return metric.error();
    if (const Status prepared = mesh_.prepare(*division, *metric); !prepared)
        return prepared;
    prepared_ = true;
    return {};
}

Status RegionRefiner::Work::load(std::uint32_t sites, const Progress& progress)
{
    if (const Status prepared = prepare(); !prepared)
        return prepared;
    if (const Status right = model_.check(model_.samples(), progress); !right)
        return right;
    coarseSites_ = 0;
    if (const Status loaded = loadCoarse(model_, sites, progress, coarse_, mesh_); !loaded)
        return loaded;
    if (const Status bounded = readBounds(sites); !bounded)
        return bounded;
    coarseBoxes_.assign(lattice_, coarse_.mesh.tetrahedra, coarse_.points);
    Buffer<std::array<std::uint32_t, 4>>().swap(coarse_.mesh.tetrahedra);
    coarseSites_ = sites;
    return {};
}

/// Whether the mesh of the last query is a good start: afterwards missing_ is what it lacks.
bool RegionRefiner::Work::canGoOn(const SpaceRamp& error, const FocusLimits& limits, const Range& range)
{
    if (!present_ || present_->inner != error.inner || present_->outer != error.outer ||
        present_->falloff != error.falloff || coarseSites_ != range.coarse)
        return false;
    std::size_t surplus = 0;
    for (const PackedPoint point : mesh_.added()) {
        const std::array<std::uint32_t, 3> place = {static_cast<std::uint32_t>(lattice_.x(point)),
                                                    static_cast<std::uint32_t>(lattice_.y(point)),
                                                    static_cast<std::uint32_t>(lattice_.z(point))};
        surplus += !limits.wants(place, std::numeric_limits<double>::infinity());
    }
    // As many would be left if nothing new came: that is looked at first, because it is quick.
    const std::size_t stay = mesh_.added().size() - surplus;
    if (stay == 0 || surplus > stay)
        return false;
    findMissing(limits, range);
    return surplus * surplusShare <= mesh_.added().size() + missing_.size();
}

Status RegionRefiner::Work::insertMissing(const Progress& progress)
{
    points_.clear();
    for (const Site& site : missing_) {
        points_.push_back(site.point);
        addedSites_.push_back(site.number);
    }
    for (std::size_t first = 0; first < points_.size(); first += insertionsAtOnce) {
        if (progress.cancelled())
            return cancelledError(Message::marked("Extracting the mesh"));
        progress.report(static_cast<double>(first) / static_cast<double>(points_.size()),
                        Message::marked("Refining the focus"));
        const std::size_t count = std::min(insertionsAtOnce, points_.size() - first);
        if (!mesh_.add(std::span(points_).subspan(first, count)))
            return focusTooLarge();
    }
    return {};
}

void RegionRefiner::Work::write(ExtractedMesh& mesh) const
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
            mesh.mesh.positions[coarseSites_ + i] = place;
            mesh.mesh.values[coarseSites_ + i] = static_cast<float>(samples[lattice_.index(point)]);
        }
    });
}

Result<ExtractedMesh> RegionRefiner::Work::extract(const SpaceRamp& error, bool fresh, const Progress& progress,
                                                   ExtractedMesh reuse)
{
    FocusLimits limits(error, model_.description().lattice, model_.description().range.extent());
    if (!(limits.least <= limits.most))
        return Error{ErrorKind::WrongUsage,
                     Message::say("The error in the focus is larger than that outside. Swap them.")};
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
    worst_.found.insert(worst_.found.end(), others_.begin(), others_.end());
    if (const Status repaired = repair(limits, progress); !repaired)
        return repaired.error();
    write(reuse);
    if (const Status intact = model_.checkIntact(); !intact)
        return intact.error();
    present_ = error;
    presentLimits_ = std::move(limits);
    return reuse;
}

bool RegionRefiner::fits(const Model& model)
{
    return !model.samples().empty() && focusDivision(model).has_value();
}

RegionRefiner::RegionRefiner(const Model& model) : work_(std::make_unique<Work>(model)) {}
RegionRefiner::~RegionRefiner() = default;
RegionRefiner::RegionRefiner(RegionRefiner&&) noexcept = default;
RegionRefiner& RegionRefiner::operator=(RegionRefiner&&) noexcept = default;

std::uint64_t RegionRefiner::sitesInside(const SpaceRamp& error)
{
    return work_->sitesInside(error);
}

Result<ExtractedMesh> RegionRefiner::extract(const SpaceRamp& error, bool fresh, const Progress& progress,
                                             ExtractedMesh reuse)
{
    Result<ExtractedMesh> mesh =
        guarded(noMemoryForFocus, [&] { return work_->extract(error, fresh, progress, std::move(reuse)); });
    if (!mesh && mesh.error().kind != ErrorKind::Cancelled)
        work_->forget();
    return mesh;
}

/// The file's bounds on the errors of the coarse mesh's tetrahedra, in the order in which extraction gives these.
Status RegionRefiner::Work::readBounds(std::uint32_t sites)
{
    coarseBounds_.assign(coarse_.mesh.tetrahedra.size(), std::numeric_limits<float>::infinity());
    std::size_t slot = 0;
    const auto visit = [&](const Stars& stars) -> Status {
        if (!model_.check(model_.ownErrors().subspan(stars.first(), stars.count())))
            return model_.checkIntact();
        forEachAlive(stars, sites, [&](std::uint32_t, std::uint64_t t, std::uint32_t) {
            const double bound = model_.ownError(t) * (1 + 1e-6);
            if (slot < coarseBounds_.size())
                coarseBounds_[slot++] = static_cast<float>(bound);
        });
        return {};
    };
    return walkHistory(model_, 0, sites, {}, Message::marked("Reading the history"), visit);
}

Status RegionRefiner::Work::knowStars(const Range& range, const Progress& progress)
{
    // Beyond what the model has the bound is not known.
    const std::uint32_t sites = range.fineKnown ? range.fine : 0;
    if (fine_ && fine_->firstCreator() == range.coarse && fine_->siteCount() == sites)
        return {};
    fine_.reset();
    Result<TetrahedronSet> stars = TetrahedronSet::make(model_, range.coarse, sites, progress);
    if (!stars)
        return stars.error();
    fine_ = *std::move(stars);
    return {};
}

std::array<std::uint32_t, 4> RegionRefiner::Work::sitesOf(std::uint32_t slot) const
{
    std::array<std::uint32_t, 4> sites = mesh_.numbers(slot);
    for (std::uint32_t& site : sites)
        site = site < coarseSites_ ? site : addedSites_[site - coarseSites_];
    return sites;
}

/// Looks at slots_. In pieces whose findings are put together in order: it does not matter how many threads there are.
/// Some are missing once the work was cancelled.
void RegionRefiner::Work::scan(const FocusLimits& limits, ScannedPart part, const Progress& progress,
                               std::vector<WorstSample>& worst)
{
    constexpr std::size_t pieceSlots = 512;
    const std::size_t count = (slots_.size() + pieceSlots - 1) / pieceSlots;
    const ValueRange& range = model_.description().range;
    const double reach = std::max(std::abs(range.minimum), std::abs(range.maximum));
    std::vector<FilteredTetrahedra> filtered(count);
    std::vector<std::vector<WorstSample>> found(count);
    const auto scanPiece = [&](std::size_t piece) {
        if (progress.cancelled())
            return;
        const std::size_t first = piece * pieceSlots;
        filterTetrahedra(mesh_, std::span(slots_).subspan(first, std::min(pieceSlots, slots_.size() - first)), samples_,
                         reach, limits, part, filtered[piece]);
        scanSamples(mesh_, filtered[piece].suspects, samples_, limits, part, found[piece]);
    };
    if (count < 2)
        for (std::size_t piece = 0; piece < count; ++piece)
            scanPiece(piece);
    else
        tbb::parallel_for(std::size_t(0), count, scanPiece);
    for (const FilteredTetrahedra& some : filtered)
        for (const std::uint32_t slot : some.fine)
            bounds_[slot] = static_cast<float>(limits.least);
    for (const std::vector<WorstSample>& some : found)
        worst.insert(worst.end(), some.begin(), some.end());
}

/// Looks at what changed since the last look, unless its error is known to be small enough.
void RegionRefiner::Work::lookAtChanges(const FocusLimits& limits, bool mayBeKnown, const Progress& progress)
{
    worst_.found.clear();
    slots_.clear();
    bounds_.resize(mesh_.mesh().slotCount());
    constexpr std::size_t ahead = 12;
    const std::span<const std::uint32_t> changed = mesh_.changed();
    for (std::size_t i = 0; i < changed.size(); ++i) {
        if (i + 2 * ahead < changed.size()) {
            mesh_.prefetchNumbers(changed[i + 2 * ahead]);
            __builtin_prefetch(&bounds_[changed[i + 2 * ahead]], 1);
        }
        if (mayBeKnown && i + ahead < changed.size() && mesh_.isAlive(changed[i + ahead]))
            fine_->prefetch(sitesOf(changed[i + ahead]));
        const std::uint32_t slot = changed[i];
        if (!mesh_.isAlive(slot)) {
            bounds_[slot] = 0;
            continue;
        }
        // What the uniform fine mesh has is good enough.
        const bool known = mayBeKnown && fine_->holds(sitesOf(slot));
        bounds_[slot] = known ? static_cast<float>(limits.least) : std::numeric_limits<float>::infinity();
        if (!known)
            slots_.push_back(slot);
    }
    scan(limits, ScannedPart::All, progress, worst_.found);
    mesh_.acceptChanges();
}

/// Looks at what is inside now and did not change.
void RegionRefiner::Work::lookAtOthers(const FocusLimits& limits, bool outsideIsKnown, const Progress& progress)
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
    scan(limits, outsideIsKnown ? ScannedPart::Limited : ScannedPart::All, progress, others_);
}

Status RegionRefiner::Work::repair(const FocusLimits& limits, const Progress& progress)
{
    struct Order {
        Work& focus;
        const FocusLimits& limits;
        const Progress& progress;
        const WorstSample* next()
        {
            return focus.worst_.next([this](const WorstSample& sample) { return stands(focus.mesh_, sample); });
        }
        Status insert(const WorstSample& sample)
        {
            if (!focus.mesh_.add({&sample.point, 1}))
                return focusTooLarge();
            focus.addedSites_.push_back(
                focus.sites_->siteAt(focus.lattice_, sample.point).value_or(ExtractedMesh::noSite));
            return {};
        }
        std::uint64_t work() const { return Round<WorstSample>::work; }
        Status pause() const
        {
            return progress.cancelled() ? Status(cancelledError(Message::marked("Extracting the mesh"))) : Status();
        }
        Result<bool> look()
        {
            focus.lookAtChanges(limits, false, progress);
            // Once cancelled, nothing may have been found because nothing was looked at.
            const Status looked = pause();
            return looked ? Result<bool>(focus.worst_.begin(isWorse)) : looked.error();
        }
    };
    worst_.begin(isWorse);
    Order order{*this, limits, progress};
    return refineGreedily(order);
}

} // namespace tetra
