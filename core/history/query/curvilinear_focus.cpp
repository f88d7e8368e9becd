// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/query/curvilinear_focus.h"

#include "core/base/guarded.h"
#include "core/history/build_facts.h"
#include "core/history/pair_limits.h"
#include "core/history/query/coarse_mesh.h"
#include "core/history/site_positions.h"
#include "core/refine/greedy.h"
#include "core/refine/insertion/curvilinear_scan.h"
#include "core/refine/lattice/packed_lattice.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace tetra {

namespace {

/// Insertions between two looks at whether the work was cancelled.
constexpr std::size_t curvilinearInsertionsAtOnce = 1024;
/// Likewise points, and tetrahedra.
constexpr std::uint32_t pointsLoadedAtOnce = 1 << 16;
constexpr std::size_t slotsAtOnce = 256;
/// Larger grids would need gigabytes.
constexpr std::uint64_t mostCurvilinearPoints = 1 << 25;

std::vector<Eigen::Vector3d> positionsOf(const Model& model)
{
    std::vector<Eigen::Vector3d> positions(model.doubleSamplePositions().begin(), model.doubleSamplePositions().end());
    for (const Eigen::Vector3f& position : model.floatSamplePositions())
        positions.push_back(position.cast<double>());
    return positions;
}

CurvilinearGrid gridOf(const Model& model, std::span<const Eigen::Vector3d> positions)
{
    return visitSampleType(model.description().sampleType, [&]<class T>() {
        const std::span samples(reinterpret_cast<const T*>(model.samples().data()), model.samples().size() / sizeof(T));
        return CurvilinearGrid(model.description().lattice.size, positions, LatticeSamples(samples));
    });
}

/// The coupled blocks of the build: one block, unless it was told how large they are.
BlockDivision divisionOf(const Model& model)
{
    return {model.description().lattice.size, buildFacts(model.description()).blockCells};
}

/// The pair in the model's ratio whose larger limit is that of the two: a mesh that keeps it has few sites too many.
Accuracy looserOf(const Model& model, const Accuracy& pair)
{
    const UnitLimits limits = unitLimits(model, pair);
    const double weight = model.description().warpingWeight;
    const double key = std::max(limits.error, weight * limits.warping);
    if (!std::isfinite(key))
        return {anyError, anyWarping};
    return {100 * key / model.description().range.extent(), 100 * key / (weight * model.diagonal())};
}

} // namespace

class CurvilinearFocus::Work {
public:
    explicit Work(const Model& model)
        : model_(model), blocks_(divisionOf(model)), positions_(positionsOf(model)), grid_(gridOf(model, positions_))
    {
    }

    Result<ExtractedMesh> extract(const MeshQuery& query, const Progress& progress, ExtractedMesh reuse);
    /// An insertion may have been broken off: the mesh must be loaded again.
    void forget() noexcept { coarseSites_ = 0; }

private:
    Status findLimits(const MeshQuery& query, const Progress& progress);
    Status prepare();
    Status load(std::uint32_t sites, const Progress& progress);
    Status insertSites(const Progress& progress);
    Status look(bool coarseIsKnown, const Progress& progress);
    Status lookAtChanges(const Progress& progress);
    bool scan(std::span<const std::uint32_t> slots, ScannedPart part, const Progress& progress);
    Status repair(const Progress& progress);
    Status add(PackedPoint point, std::uint32_t site);
    void write(ExtractedMesh& mesh) const;
    std::uint32_t siteAt(PackedPoint point);

    const Model& model_;
    BlockDivision blocks_;
    std::vector<Eigen::Vector3d> positions_;
    CurvilinearGrid grid_;
    bool prepared_ = false;
    LocalDelaunay mesh_;
    std::uint32_t coarseSites_ = 0; ///< of the mesh that is loaded
    CoarseMesh coarse_;             ///< without its tetrahedra
    std::vector<std::uint32_t> siteOfPoint_;
    std::vector<std::uint32_t> addedSites_; ///< of mesh_.added()

    CurvilinearLimits limits_;
    std::vector<double> keys_; ///< the limits as keys
    Round<WorstSample> worst_;
    std::vector<std::uint32_t> slots_;
};

Status CurvilinearFocus::Work::findLimits(const MeshQuery& query, const Progress& progress)
{
    const double perError = model_.description().range.extent() / 100;
    const double perWarping = model_.diagonal() / 100;
    const double mostError = query.error.bounds().maximum, mostWarping = query.warping.bounds().maximum;
    const auto& size = grid_.lattice().size();
    const std::size_t count = positions_.size();
    limits_.errors.resize(count);
    limits_.warpings.resize(count);
    keys_.resize(count);
    limits_.first = {static_cast<std::int32_t>(size[0]), static_cast<std::int32_t>(size[1]),
                     static_cast<std::int32_t>(size[2])};
    limits_.last = {-1, -1, -1};
    for (std::uint32_t index = 0; index < count; ++index) {
        if (index % pointsLoadedAtOnce == 0 && progress.cancelled())
            return cancelledError(Message::marked("Extracting the mesh"));
        const double value = grid_[index].components[3];
        const double error = query.error.at(positions_[index], value);
        const double warping = query.warping.at(positions_[index], value);
        limits_.errors[index] = error * perError;
        limits_.warpings[index] = warping * perWarping;
        keys_[index] = std::min(limits_.errors[index], model_.description().warpingWeight * limits_.warpings[index]);
        if (error >= mostError && warping >= mostWarping)
            continue;
        const std::array<std::int32_t, 3> place = {static_cast<std::int32_t>(index % size[0]),
                                                   static_cast<std::int32_t>(index / size[0] % size[1]),
                                                   static_cast<std::int32_t>(index / size[0] / size[1])};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            limits_.first[axis] = std::min(limits_.first[axis], place[axis]);
            limits_.last[axis] = std::max(limits_.last[axis], place[axis]);
        }
    }
    return {};
}

Status CurvilinearFocus::Work::prepare()
{
    if (prepared_)
        return {};
    if (!std::ranges::all_of(positions_, [](const Eigen::Vector3d& position) { return position.allFinite(); }))
        return inconsistentModel(model_, Message::say("a sample lies in no tetrahedron"));
    siteOfPoint_.assign(positions_.size(), ExtractedMesh::noSite);
    for (std::uint32_t site = 0; site < model_.siteCount(); ++site) {
        const std::uint32_t point = model_.points()[site];
        if (point >= positions_.size())
            return inconsistentModel(model_, Message::say("a site is not a point of its grid"));
        siteOfPoint_[point] = site;
    }
    if (const Status prepared = mesh_.prepare(blocks_, {1, 1, 1}); !prepared)
        return prepared;
    prepared_ = true;
    return {};
}

Status CurvilinearFocus::Work::load(std::uint32_t sites, const Progress& progress)
{
    if (const Status prepared = prepare(); !prepared)
        return prepared;
    coarseSites_ = 0;
    if (const Status loaded = loadCoarse(model_, sites, progress, coarse_, mesh_); !loaded)
        return loaded;
    Buffer<std::array<std::uint32_t, 4>>().swap(coarse_.mesh.tetrahedra);
    coarseSites_ = sites;
    return {};
}

std::uint32_t CurvilinearFocus::Work::siteAt(PackedPoint point)
{
    return siteOfPoint_[grid_.lattice().index(point)];
}

Status CurvilinearFocus::Work::add(PackedPoint point, std::uint32_t site)
{
    if (!mesh_.add({&point, 1}))
        return focusTooLarge();
    addedSites_.push_back(site);
    return {};
}

/// Those that a uniform mesh has whose key is the limit where they lie.
Status CurvilinearFocus::Work::insertSites(const Progress& progress)
{
    for (std::uint32_t site = coarseSites_; site < model_.siteCount(); ++site) {
        if (site % curvilinearInsertionsAtOnce == 0) {
            if (progress.cancelled())
                return cancelledError(Message::marked("Extracting the mesh"));
            progress.report(static_cast<double>(site) / model_.siteCount(), Message::marked("Refining the focus"));
        }
        const std::uint32_t point =
            std::min<std::uint32_t>(model_.points()[site], static_cast<std::uint32_t>(keys_.size() - 1));
        if (!(static_cast<double>(model_.runningKeys()[site]) > keys_[point]) ||
            mesh_.isVertex(grid_.lattice().pointAt(point)))
            continue;
        if (const Status added = add(grid_.lattice().pointAt(point), site); !added)
            return added;
    }
    return {};
}

/// Adds the worst samples of these tetrahedra to worst_; false if the work was cancelled.
bool CurvilinearFocus::Work::scan(std::span<const std::uint32_t> slots, ScannedPart part, const Progress& progress)
{
    for (std::size_t first = 0; first < slots.size(); first += slotsAtOnce) {
        if (progress.cancelled())
            return false;
        scanCurvilinearSamples(mesh_, slots.subspan(first, std::min(slotsAtOnce, slots.size() - first)), grid_, blocks_,
                               limits_, part, worst_.found);
    }
    return true;
}

/// Adds the worst samples of what changed.
Status CurvilinearFocus::Work::lookAtChanges(const Progress& progress)
{
    if (!scan(mesh_.changed(), ScannedPart::All, progress))
        return cancelledError(Message::marked("Extracting the mesh"));
    mesh_.acceptChanges();
    return {};
}

/// Looks at what changed, and at what did not but lies where limits are not the largest.
Status CurvilinearFocus::Work::look(bool coarseIsKnown, const Progress& progress)
{
    slots_.clear();
    for (std::uint32_t slot = 0; slot < mesh_.mesh().slotCount(); ++slot)
        if (!mesh_.hasChanged(slot))
            slots_.push_back(slot);
    worst_.found.clear();
    if (!scan(slots_, coarseIsKnown ? ScannedPart::Limited : ScannedPart::All, progress))
        return cancelledError(Message::marked("Extracting the mesh"));
    return lookAtChanges(progress);
}

Status CurvilinearFocus::Work::repair(const Progress& progress)
{
    struct Order {
        Work& focus;
        const Progress& progress;
        const WorstSample* next()
        {
            return focus.worst_.next([this](const WorstSample& sample) { return stands(focus.mesh_, sample); });
        }
        Status insert(const WorstSample& sample) { return focus.add(sample.point, focus.siteAt(sample.point)); }
        std::uint64_t work() const { return Round<WorstSample>::work; }
        Status pause() const
        {
            return progress.cancelled() ? Status(cancelledError(Message::marked("Extracting the mesh"))) : Status();
        }
        Result<bool> look()
        {
            focus.worst_.found.clear();
            const Status looked = focus.lookAtChanges(progress);
            return looked ? Result<bool>(focus.worst_.begin(isWorse)) : looked.error();
        }
    };
    worst_.begin(isWorse);
    Order order{*this, progress};
    return refineGreedily(order);
}

void CurvilinearFocus::Work::write(ExtractedMesh& mesh) const
{
    writeRefined(model_, coarse_.mesh, mesh_, addedSites_, mesh);
    const std::span<const PackedPoint> added = mesh_.added();
    for (std::size_t i = 0; i < added.size(); ++i) {
        const std::uint32_t index = grid_.lattice().index(added[i]);
        mesh.mesh.positions[coarseSites_ + i] = positions_[index];
        mesh.mesh.values[coarseSites_ + i] = static_cast<float>(grid_[index].components[3]);
    }
}

Result<ExtractedMesh> CurvilinearFocus::Work::extract(const MeshQuery& query, const Progress& progress,
                                                      ExtractedMesh reuse)
{
    for (const Status& right :
         {model_.check(model_.samples(), progress), model_.check(model_.floatSamplePositions(), progress),
          model_.check(model_.doubleSamplePositions(), progress), model_.check(model_.points(), progress),
          model_.check(model_.runningKeys(), progress)})
        if (!right)
            return right.error();
    if (const Status found = findLimits(query, progress); !found)
        return found.error();
    const Accuracy outside = {query.error.bounds().maximum, query.warping.bounds().maximum};
    const bool isUniform = query.error.isConstant() && query.warping.isConstant();
    const MeshSize coarse = meshSizeAt(model_, isUniform ? looserOf(model_, outside) : outside);
    if (coarseSites_ == coarse.sites && coarseSites_ > 0)
        mesh_.restore();
    else if (const Status loaded = load(coarse.sites, progress.part(0, 0.2)); !loaded)
        return loaded.error();
    addedSites_.clear();
    if (const Status inserted = isUniform ? Status() : insertSites(progress.part(0.2, 0.9)); !inserted)
        return inserted.error();
    if (const Status looked = look(coarse.error <= outside.error && coarse.warping <= outside.warping, progress);
        !looked)
        return looked.error();
    if (const Status repaired = repair(progress); !repaired)
        return repaired.error();
    write(reuse);
    if (const Status intact = model_.checkIntact(); !intact)
        return intact.error();
    return reuse;
}

bool CurvilinearFocus::fits(const Model& model)
{
    const auto& size = model.description().lattice.size;
    return model.description().domain == DomainClass::Curvilinear && model.description().delaunay &&
           !model.samples().empty() && model.description().lattice.pointCount() <= mostCurvilinearPoints &&
           PackedLattice::fits(size) && exactWithMetric(size, {1, 1, 1}) &&
           !buildFacts(model.description()).isWeighted();
}

CurvilinearFocus::CurvilinearFocus(const Model& model) : work_(std::make_unique<Work>(model)) {}
CurvilinearFocus::~CurvilinearFocus() = default;
CurvilinearFocus::CurvilinearFocus(CurvilinearFocus&&) noexcept = default;
CurvilinearFocus& CurvilinearFocus::operator=(CurvilinearFocus&&) noexcept = default;

Result<ExtractedMesh> CurvilinearFocus::extract(const MeshQuery& query, const Progress& progress, ExtractedMesh reuse)
{
    Result<ExtractedMesh> mesh =
        guarded(noMemoryForFocus, [&] { return work_->extract(query, progress, std::move(reuse)); });
    if (!mesh && mesh.error().kind != ErrorKind::Cancelled)
        work_->forget();
    return mesh;
}

} // namespace tetra
