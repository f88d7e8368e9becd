// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/queries/lifted_focus.h"

#include "core/mesh/lattice_metric.h"
#include "core/mesh/lifted_scan.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <new>
#include <numeric>
#include <optional>

namespace tetra {

namespace {

/// Insertions between two looks at whether the work was cancelled.
constexpr std::size_t insertionsAtOnce = 1024;
/// Larger grids would need gigabytes.
constexpr std::uint64_t mostPoints = 1 << 25;

Error damaged(const Model& model, const std::string& what)
{
    return {ErrorKind::BadInput, "'" + model.path().string() + "' is damaged: " + what +
                                     ". Copy it again from where it came from, or build it again."};
}

Error tooLarge()
{
    return {ErrorKind::OutOfResource,
            "The mesh of the focus became too large. Choose a larger error or a smaller focus."};
}

std::vector<Eigen::Vector3d> positionsOf(const Model& model)
{
    std::vector<Eigen::Vector3d> positions(model.doubleSamplePositions().begin(), model.doubleSamplePositions().end());
    for (const Eigen::Vector3f& position : model.floatSamplePositions())
        positions.push_back(position.cast<double>());
    return positions;
}

LiftedGrid gridOf(const Model& model, std::span<const Eigen::Vector3d> positions)
{
    return visitSampleType(model.description().sampleType, [&]<class T>() {
        const std::span samples(reinterpret_cast<const T*>(model.samples().data()), model.samples().size() / sizeof(T));
        return LiftedGrid(model.description().lattice.size, positions, LatticeSamples(samples));
    });
}

std::string parameterOf(const Model& model, std::string_view name)
{
    for (const auto& [key, value] : model.description().parameters)
        if (key == name)
            return value;
    return {};
}

/// The coupled blocks of the build: their edge in cells, where the build was told one, else one block.
BlockDivision divisionOf(const Model& model)
{
    const std::string text = parameterOf(model, "block");
    std::uint32_t edge = 0;
    std::from_chars(text.data(), text.data() + text.size(), edge);
    return {model.description().lattice.size, edge};
}

} // namespace

class LiftedFocus::Work {
public:
    explicit Work(const Model& model)
        : model_(model), blocks_(divisionOf(model)), positions_(positionsOf(model)), grid_(gridOf(model, positions_))
    {
    }

    Result<ExtractedMesh> extract(const MeshQuery& query, const Progress& progress, ExtractedMesh reuse);

private:
    void findLimits(const MeshQuery& query);
    Status load(std::uint32_t sites, const Progress& progress);
    Status insertSites(const Progress& progress);
    void look(bool coarseIsKnown);
    Status repair(const Progress& progress);
    Status add(PackedPoint point, std::uint32_t site);
    void write(ExtractedMesh& mesh) const;
    std::uint32_t siteAt(PackedPoint point);
    PackedPoint pointOf(std::uint32_t index) const;

    const Model& model_;
    BlockDivision blocks_;
    std::vector<Eigen::Vector3d> positions_;
    LiftedGrid grid_;
    bool prepared_ = false;
    LocalDelaunay mesh_;
    std::uint32_t coarseSites_ = 0; ///< of the mesh that is loaded
    TetrahedralMesh coarse_;        ///< its positions and values
    std::vector<std::uint32_t> siteOfPoint_;
    std::vector<std::uint32_t> addedSites_; ///< of mesh_.added()

    LiftedLimits limits_;
    std::vector<double> keys_; ///< the limits as keys
    std::vector<WorstSample> worst_;
    std::vector<std::uint32_t> slots_;
};

PackedPoint LiftedFocus::Work::pointOf(std::uint32_t index) const
{
    const auto& size = grid_.lattice().size();
    return grid_.lattice().pack(index % size[0], index / size[0] % size[1],
                                std::min(index / size[0] / size[1], size[2] - 1));
}

void LiftedFocus::Work::findLimits(const MeshQuery& query)
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
}

Status LiftedFocus::Work::load(std::uint32_t sites, const Progress& progress)
{
    if (!prepared_) {
        if (const Status prepared = mesh_.prepare(blocks_, {1, 1, 1}); !prepared)
            return prepared;
        siteOfPoint_.assign(positions_.size(), ExtractedMesh::noSite);
        for (std::uint32_t site = 0; site < model_.siteCount(); ++site) {
            const std::uint32_t point = model_.points()[site];
            if (point >= positions_.size())
                return damaged(model_, "a site is no point of its grid");
            siteOfPoint_[point] = site;
        }
        prepared_ = true;
    }
    coarseSites_ = 0;
    Result<TetrahedralMesh> coarse = extractPrefix(model_, sites, progress, std::move(coarse_));
    if (!coarse)
        return coarse.error();
    coarse_ = *std::move(coarse);
    if (model_.description().leftHanded) // back to what is positive in computational space
        for (std::array<std::uint32_t, 4>& tetrahedron : coarse_.tetrahedra)
            std::swap(tetrahedron[2], tetrahedron[3]);
    Buffer<PackedPoint> points(sites);
    std::ranges::transform(model_.points().first(sites), points.begin(),
                           [this](std::uint32_t point) { return pointOf(point); });
    if (!mesh_.load(coarse_.tetrahedra, points))
        return damaged(model_, "or of another kind than the focus needs: its coarse mesh is no Delaunay mesh");
    Buffer<std::array<std::uint32_t, 4>>().swap(coarse_.tetrahedra);
    coarseSites_ = sites;
    return {};
}

std::uint32_t LiftedFocus::Work::siteAt(PackedPoint point)
{
    return siteOfPoint_[grid_.lattice().index(point)];
}

Status LiftedFocus::Work::add(PackedPoint point, std::uint32_t site)
{
    if (!mesh_.add({&point, 1}))
        return tooLarge();
    addedSites_.push_back(site);
    return {};
}

/// Those that a uniform mesh has whose key is the limit where they lie.
Status LiftedFocus::Work::insertSites(const Progress& progress)
{
    for (std::uint32_t site = coarseSites_; site < model_.siteCount(); ++site) {
        if (site % insertionsAtOnce == 0) {
            if (progress.cancelled())
                return cancelledError("Extracting the mesh");
            progress.report(static_cast<double>(site) / model_.siteCount(), "Refining the focus");
        }
        const std::uint32_t point =
            std::min<std::uint32_t>(model_.points()[site], static_cast<std::uint32_t>(keys_.size() - 1));
        if (!(static_cast<double>(model_.runningErrors()[site]) > keys_[point]) || mesh_.isVertex(pointOf(point)))
            continue;
        if (const Status added = add(pointOf(point), site); !added)
            return added;
    }
    return {};
}

/// Looks at what changed, and at what did not but lies where limits are not the largest.
void LiftedFocus::Work::look(bool coarseIsKnown)
{
    slots_.clear();
    for (std::uint32_t slot = 0; slot < mesh_.mesh().slotCount(); ++slot)
        if (!mesh_.hasChanged(slot))
            slots_.push_back(slot);
    worst_.clear();
    scanLiftedSamples(mesh_, slots_, grid_, blocks_, limits_, coarseIsKnown ? ScannedPart::Limited : ScannedPart::All,
                      worst_);
    scanLiftedSamples(mesh_, mesh_.changed(), grid_, blocks_, limits_, ScannedPart::All, worst_);
    mesh_.acceptChanges();
}

/// In rounds: the worst first, unless one before it has changed its tetrahedron; then what changed is looked at.
Status LiftedFocus::Work::repair(const Progress& progress)
{
    while (!worst_.empty()) {
        std::ranges::sort(worst_, isWorse);
        for (std::size_t i = 0; i < worst_.size(); ++i) {
            if (i % insertionsAtOnce == 0 && progress.cancelled())
                return cancelledError("Extracting the mesh");
            const DelaunayTetrahedron& now = mesh_.mesh()[worst_[i].slot];
            if (!(now.determinant() > 0) || now.vertices != worst_[i].tetrahedron || mesh_.isVertex(worst_[i].point))
                continue;
            if (const Status added = add(worst_[i].point, siteAt(worst_[i].point)); !added)
                return added;
        }
        worst_.clear();
        scanLiftedSamples(mesh_, mesh_.changed(), grid_, blocks_, limits_, ScannedPart::All, worst_);
        mesh_.acceptChanges();
    }
    return {};
}

void LiftedFocus::Work::write(ExtractedMesh& mesh) const
{
    mesh_.copyTetrahedra(mesh.mesh.tetrahedra);
    if (model_.description().leftHanded)
        for (std::array<std::uint32_t, 4>& tetrahedron : mesh.mesh.tetrahedra)
            std::swap(tetrahedron[2], tetrahedron[3]);
    const std::span<const PackedPoint> added = mesh_.added();
    const std::size_t count = coarseSites_ + added.size();
    mesh.mesh.positions.resize(count);
    mesh.mesh.values.resize(count);
    mesh.sites.resize(count);
    std::ranges::copy(coarse_.positions, mesh.mesh.positions.begin());
    std::ranges::copy(coarse_.values, mesh.mesh.values.begin());
    std::iota(mesh.sites.begin(), mesh.sites.begin() + coarseSites_, 0u);
    std::ranges::copy(addedSites_, mesh.sites.begin() + coarseSites_);
    mesh.points.clear();
    if (std::ranges::find(addedSites_, ExtractedMesh::noSite) != addedSites_.end()) {
        mesh.points.assign(count, ExtractedMesh::noSite);
        for (std::size_t i = 0; i < added.size(); ++i)
            if (addedSites_[i] == ExtractedMesh::noSite)
                mesh.points[coarseSites_ + i] = grid_.lattice().index(added[i]);
    }
    for (std::size_t i = 0; i < added.size(); ++i) {
        const std::uint32_t index = grid_.lattice().index(added[i]);
        mesh.mesh.positions[coarseSites_ + i] = positions_[index].cast<float>();
        mesh.mesh.values[coarseSites_ + i] = static_cast<float>(grid_[index].components[3]);
    }
    mesh.wholeSites = static_cast<std::uint32_t>(count);
    mesh.wholeTetrahedra = mesh.mesh.tetrahedra.size();
    mesh.scale = 1;
    mesh.method = VariableMethod::Insertion;
}

Result<ExtractedMesh> LiftedFocus::Work::extract(const MeshQuery& query, const Progress& progress, ExtractedMesh reuse)
{
    findLimits(query);
    const Accuracy outside = {query.error.bounds().maximum, query.warping.bounds().maximum};
    const MeshSize coarse = meshSizeAt(model_, outside);
    if (coarseSites_ == coarse.sites && coarseSites_ > 0)
        mesh_.restore();
    else if (const Status loaded = load(coarse.sites, progress.part(0, 0.2)); !loaded)
        return loaded.error();
    addedSites_.clear();
    if (const Status inserted = insertSites(progress.part(0.2, 0.9)); !inserted)
        return inserted.error();
    look(coarse.error <= outside.error && coarse.warping <= outside.warping);
    if (const Status repaired = repair(progress); !repaired)
        return repaired.error();
    write(reuse);
    if (const Status intact = model_.checkIntact(); !intact)
        return intact.error();
    return reuse;
}

bool LiftedFocus::fits(const Model& model)
{
    const auto& size = model.description().lattice.size;
    return model.description().domain == DomainClass::Curvilinear && !model.samples().empty() &&
           model.description().lattice.pointCount() <= mostPoints && PackedLattice::fits(size) &&
           exactWithMetric(size, {1, 1, 1}) && parameterOf(model, "weights").empty() &&
           parameterOf(model, "selection") != "paper";
}

LiftedFocus::LiftedFocus(const Model& model) : work_(std::make_unique<Work>(model)) {}
LiftedFocus::~LiftedFocus() = default;
LiftedFocus::LiftedFocus(LiftedFocus&&) noexcept = default;
LiftedFocus& LiftedFocus::operator=(LiftedFocus&&) noexcept = default;

Result<ExtractedMesh> LiftedFocus::extract(const MeshQuery& query, const Progress& progress, ExtractedMesh reuse)
try {
    return work_->extract(query, progress, std::move(reuse));
} catch (const std::bad_alloc&) {
    return Error{ErrorKind::OutOfResource,
                 "Not enough memory for the mesh of the focus. Choose a larger error or a smaller focus."};
}

} // namespace tetra
