// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// tan/build.h: models out of datasets: by Delaunay refinement or by edge collapse, into a file; and the history that
/// your own builder hands over.
///
/// ~~~{.cpp}
/// /// Builds a model that keeps every sample, and says how large it became.
/// tetra::Result<std::string> built(const tetra::Dataset& dataset, const std::filesystem::path& output)
/// {
///     const auto report = tetra::buildModel(dataset, output);
///     if (!report)
///         return report.error();
///     return std::to_string(report->sites) + " sites, " + std::to_string(report->tetrahedra) + " tetrahedra";
/// }
///
/// /// About half as many points for the same accuracy, but slower; keeps no mesh finer than half a percent.
/// tetra::Result<tetra::BuildReport> builtSmall(const tetra::Dataset& dataset, const std::filesystem::path& output)
/// {
///     return tetra::buildModel(dataset, output, tetra::Decimation{.finest = 0.5});
/// }
/// ~~~

#include <tan/base.h>
#include <tan/data.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace tetra {

/// What a build made.
struct BuildReport {
    // Counted in the model's file: a builder of your own leaves them out. One that fills a FixedSizeTarget says them.
    std::uint64_t sites = 0;
    std::uint64_t tetrahedra = 0; ///< in the model: all that lived in a mesh that a query can give
    // Said by the builder alone: 0 unless it counts them.
    std::uint64_t inverted = 0;   ///< cells of the finest mesh that are inverted, as the dataset itself is there (S5)
    std::uint64_t degenerate = 0; ///< cells without volume (S6)
    /// Whether it ended before what was asked for was reached, with what was finished by then. Unset: if it was asked
    /// to stop (Progress::cancelled()).
    std::optional<bool> stoppedEarly{};
};

/// What orders the history of data that can warp, and so what its meshes are small for (C1): the larger of error and
/// warping in the ratio of their thresholds, or one of the two, whatever becomes of the other. Each mesh still says
/// both.
enum class OrderedBy { Both, Error, Warping };

/// Delaunay refinement (R8): the points that are farthest off enter one after the other. Of regular lattices,
/// curvilinear grids and scattered points; the mesh of every prefix is the Delaunay mesh of its sites. Rectilinear
/// grids and irregular meshes of convex domain (Dataset::convex) are refined as the points that they have, in physical
/// space: they have no warping.
struct Refinement {
    double error = 0; ///< where to stop, % of the value range; 0 goes on until the error is zero
    /// Of curvilinear grids likewise, % of the diagonal of the data's bounding box. If only one of error and warping is
    /// given, it holds for both.
    double warping = 0;
    /// Cells along an edge of a block of a lattice or grid; 0: no blocks. Blocks are refined independently, with only a
    /// few in memory (R10, C7). Unset: the size and the memory that this process may use decide, so the model may
    /// differ between machines.
    std::optional<std::uint32_t> block{};
    /// Of curvilinear grids: compare error and warping in the units of the data, as the paper did. Not in blocks.
    bool paperSelection = false;
    OrderedBy orderedBy = OrderedBy::Both; ///< of curvilinear grids; a threshold of the other one is refused
    /// Rectilinear grids as other curvilinear ones, in computational space: in less memory and time, but with a
    /// warping.
    bool computational = false;
    /// Of curvilinear grids: keep the error in space as well (C12), whole grids only, ordered by both, with the
    /// normalised selection. A key then bounds it, too, so the meshes of accuracies keep it; those of fields and
    /// focuses, which go by tetrahedra's own errors, do not.
    bool inSpace = false;
    Weighting weighting{}; ///< how much the error at each point counts (R6)
    /// Of lattices: the lengths of the steps by which tetrahedra are chosen, if not the spacing
    /// (ModelDescription::metric).
    std::optional<Eigen::Vector3d> metric{};
};

/// Which vertex an edge collapse takes away next.
enum class DecimationOrder {
    ExactError,     ///< the one whose loss does the least harm: the fewest points for the same accuracy
    PaperEstimates, ///< by estimates from gradients and planes, as the paper did
    /// Rounds of collapses that do not touch each other, the cheapest first: the history is shallow, so that a closed
    /// set with a fine region is small (S9, R25).
    IndependentRounds
};

/// Edge collapse (R11), of irregular data and lattices, of curvilinear grids, as the irregular mesh of their cells, and
/// of scattered points, as the one that they are tetrahedrized(): fewer points for the same accuracy than refinement,
/// more time and memory. Only closed sets of sites have a mesh.
struct Decimation {
    double error = 0;   ///< where to stop, % of the value range; 0 goes on to the coarsest mesh
    double warping = 0; ///< likewise, % of the diagonal; if only one of the two is given, it holds for both
    double finest = 0;  ///< leaves meshes of a smaller error out of the model; 0 keeps all
    DecimationOrder order = DecimationOrder::ExactError;
    OrderedBy orderedBy = OrderedBy::Both; ///< as Refinement::orderedBy, of irregular data, too
    Weighting weighting{};
    /// Curvilinear grids in computational space, as in the paper: then the error is the one in the grid, and every
    /// point of it counts for the warping. Folded grids, too.
    bool computational = false;
    /// Of irregular data, else WrongUsage: the warping also limits how far any place of a mesh's boundary is from that
    /// of the data, weights aside (S13); else only how far the data's boundary points are from the mesh's, as in the
    /// paper.
    bool twoSided = false;
};

using BuildMethod = std::variant<Refinement, Decimation>;

/// The method that suits the dataset: decimation of irregular data, and of curvilinear grids that are a mesh
/// (checkAsMesh()); of other such grids of at most a million points refinement that keeps the error in space; else
/// refinement. So up to there the error is the one in space.
TAN_API BuildMethod suitableMethod(const Dataset& dataset);

/// Builds a model of `dataset` into `output`, atomically: a model that was there is replaced at the end, any other file
/// is not (WrongUsage). Temporary files lie beside it meanwhile, and go with a cancelled or failed build. Errors: what
/// the method does not take and why, no room on the disk, not enough memory, cancelled. Returns when the model is
/// complete, so call it from a worker thread; builds of different outputs may run at once. Blocks are
/// refined on all threads, everything else on one. Takes some 600 bytes a point of memory at most, in blocks some 45;
/// decimation about 1.5 kB a point.
TAN_API Result<BuildReport> buildModel(const Dataset& dataset, const std::filesystem::path& output,
                                       const BuildMethod& method, const Progress& progress = {});
/// The same by the suitableMethod(), without progress.
TAN_API Result<BuildReport> buildModel(const Dataset& dataset, const std::filesystem::path& output);

/// How many of a dataset's points a mesh of some error takes, estimated from a sample of a few thousand: where the
/// field is nearly linear the vertices may lie far apart. A value, immutable.
class TAN_API SiteDensity {
public:
    /// Nothing is known: every point may be needed.
    SiteDensity() = default;
    /// Lattices and grids: reads 4,096 points and their neighbours at distances up to 16, so that a mapped file is not
    /// read as a whole. Other data: a linear fit to the nearest points of 16 to 512, O(points) for each of these: a
    /// second for some fifty million. The same result every time; nothing is known if it was cancelled.
    static SiteDensity of(const Dataset& dataset, const Progress& progress = {});

    bool known() const noexcept { return !deviations_.empty(); }
    /// The share of the points, in (0, 1]. `error`: as a share of the values' extent and, of curvilinear grids, of the
    /// diagonal. Within a factor of two for the datasets that it was calibrated with.
    double share(double error) const;

private:
    static constexpr int levels = 5;
    static constexpr double infinite = std::numeric_limits<double>::infinity();
    /// Of a point: what its neighbours at the distances 1, 2, 4 ... of points tell, less what it is; the largest up to
    /// each distance, as a share of the extent.
    using Deviations = std::array<float, levels>;
    static Deviations onLattice(const Dataset& dataset, std::uint64_t point, double diagonal);
    static Deviations amongPoints(const Dataset& dataset, std::uint64_t point);

    std::vector<Deviations> deviations_;
    /// How far apart sites can be along each axis, in steps of the lattice: no farther than it is long.
    std::array<double, 3> longest_ = {infinite, infinite, infinite};
};

// --- For builders of your own only ---
// What a plugin that builds models hands over, and to whom. Programs that build models by the methods above need
// nothing from here on.

/// A tetrahedron of the history, as its creator (the latest of its four sites) knows it: (creator, sites[0], sites[1],
/// sites[2]) is positive in the space that the mesh was made in (computational space for curvilinear data). Sites are
/// numbered in order of insertion.
struct HistoryTetrahedron {
    std::array<std::uint32_t, 3> sites{};
    float error = 0;   ///< bound on its own error (2.3), in units of the values, never rounded down
    float warping = 0; ///< bound on its own warping (R4), in units of length, never rounded down
};

/// One site entering the mesh, with all that it changes.
struct HistoryStep {
    std::uint64_t point = 0; ///< the dataset's point that becomes the next site
    /// The key of the mesh before this step, in units of the values: its error, or with warping the
    /// larger of the error and HistoryTraits::warpingWeight times the warping (S4). Infinity for the initial sites and
    /// for a mesh that is not consistent (S5).
    float keyBefore = 0;
    std::span<const HistoryTetrahedron> star; ///< the tetrahedra that it creates; history indices go on from the last
    std::span<const std::uint32_t> destroyed; ///< history indices of the tetrahedra that it destroys
};

/// What holds for a history as a whole.
struct HistoryTraits {
    /// Units of the values for a unit of length: makes errors and warpings comparable (S4). 0 where there is no
    /// warping, as in convex domains.
    double warpingWeight = 0;
    /// Whether the mesh of every prefix is the Delaunay mesh of its sites, so that any set of sites has a mesh. False
    /// for decimation: there only closed sets have one. Never true of irregular data. Of a lattice or a grid it claims
    /// more, as queries insert points into these meshes for a focus: that each step inserted one point of the dataset
    /// in the way of buildInto(), which also decides between equally good meshes where many points lie on one sphere,
    /// as in any lattice. So claim it only for steps that come from buildInto() by Refinement, all of them or up to
    /// some step; else false is right, and a focus is then a closed set.
    bool delaunay = true;
    /// If the mesh of a lattice or a grid was made in blocks: how many cells a block has along each axis; the last
    /// along an axis may have fewer. No tetrahedron reaches from one block into another. All 0: no blocks.
    std::array<std::uint32_t, 3> blockCells{};
};

/// Takes a history while a builder makes it, coarse first. Called from one thread.
class TAN_API HistorySink {
public:
    virtual ~HistorySink() = default;
    /// Comes first. Required for data that can warp and for irregular data; else where anything but the defaults holds.
    virtual Status begin(const HistoryTraits& /*traits*/) { return {}; }
    /// An error (a full disk) ends the build.
    virtual Status add(const HistoryStep& step) = 0;
    /// The build is complete; `finalKey` bounds the last mesh's distance from the data, as HistoryStep::keyBefore.
    virtual Status finish(float finalKey) = 0;
};

/// Writes the history that `build` hands to its sink, finish() included, as a model of `dataset` into `output`, which
/// is treated as by buildModel(). `builder` is what the model says that it was built by. Errors: build's own, those of
/// buildModel(). tan/verify.h tells whether the history was sound.
TAN_API Result<BuildReport> writeModel(const Dataset& dataset, const std::filesystem::path& output, std::string builder,
                                       const std::function<Status(HistorySink& history)>& build);

class ModelFileWriter;

/// How much a model holds.
struct FixedCounts {
    std::uint32_t sites = 0;
    std::uint64_t tetrahedra = 0;
};

/// Opens the model for a builder that knows its size beforehand. `parameters` replace or join those that the model
/// keeps as its provenance: what the builder chose by itself. The writer is TAn's own: builders of others use
/// BuildTarget::history.
using FixedSizeTarget = std::function<Result<std::unique_ptr<ModelFileWriter>>(
    const FixedCounts& counts, const std::vector<std::pair<std::string, std::string>>& parameters)>;

/// What is done here of a build in blocks that many processes share (D15). Each refines some of the blocks into the
/// folder, on its own and in any order, and at last one of them merges all.
struct BuildPart {
    /// For the work of all processes and nothing else, on a disk that they all see.
    std::filesystem::path folder{};
    bool merges = false; ///< the parts are there: make the model of them
    // Else:
    std::uint32_t number = 1; ///< of this part, from 1 to `count`
    std::uint32_t count = 1;  ///< of the parts; any number does
    /// Of curvilinear grids, whose blocks agree about their faces in rounds: waits for what other parts find out, which
    /// have to be built at the same time. Else a part that lacks it ends with NotYet, and goes on when it is begun
    /// again.
    bool waits = false;
};

/// Where a build puts what it makes.
struct BuildTarget {
    /// A history step by step. Costs memory for every site and tetrahedron.
    HistorySink& history;
    /// In place of `history`, for builders that know the final size beforehand: takes little memory. Empty if there is
    /// none.
    FixedSizeTarget ofFixedSize{};
    /// A folder on the model's disk for files of the builder's own, for as long as the build lasts. Empty if
    /// `ofFixedSize` is.
    std::filesystem::path workFolder{};
    /// The folder may hold what an interrupted build left: go on with that as far as it fits, and keep there what this
    /// one has done. Without it only builds in blocks leave something.
    bool resume = false;
    /// For builders that hand over nothing before their end, so that they can be watched (B8): if there is one, it is
    /// called now and then, by the building thread, with a function that hands the mesh as it is now to a sink, as a
    /// history of that mesh alone, begin() to finish().
    std::function<void(const std::function<Status(HistorySink& history)>& hand)> preview{};
    /// For the same builders: if it is there and true when the build is cancelled, they hand over the history as far as
    /// it goes, and end well.
    const std::atomic<bool>* keepWhenCancelled = nullptr;
    /// For builders that say so (BuildAbilities::takesParts): what of the build is done here; all of it if there is
    /// none. A part goes on with what an earlier attempt at it has left, and hands nothing over.
    std::optional<BuildPart> part{};
};

/// The dataset as the method takes it, and as the model has it: itself; asPoints() of a rectilinear grid (unless it is
/// refined in computational space) or a convex mesh that is refined; tetrahedrized() scattered points and asMesh() of a
/// curvilinear grid that are decimated. What checkRefinement() or checkDecimation() refuses is returned as it is.
/// Errors: settings that mean nothing there (WrongUsage), not enough memory, cancelled, those of tetrahedrized() and
/// asMesh().
TAN_API Result<Dataset> takenFor(const Refinement& refinement, const Dataset& dataset, const Progress& progress = {});
TAN_API Result<Dataset> takenFor(const Decimation& decimation, const Dataset& dataset, const Progress& progress = {});

/// Why the dataset cannot be refined, for the user; success if it can.
TAN_API Status checkRefinement(const Dataset& dataset);

/// Whether the refinement of a curvilinear grid of so many points as a whole keeps the error in space
/// (Refinement::inSpace) unless something else is asked for: of a million at most, which takes some minutes.
TAN_API bool keepsErrorInSpace(std::uint64_t points);

/// Whether a lattice or grid of so many points is refined in blocks, as far as that can be known of their number.
/// `block`: Refinement::block; `usableBytes`: of memory, 0 if unknown.
TAN_API bool takesBlocks(const std::optional<std::uint32_t>& block, std::uint64_t points, std::uint64_t usableBytes);

/// The cells along an edge of the blocks of a lattice or curvilinear grid, 0 to refine it as a whole. Error:
/// WrongUsage, so small blocks would be too many.
TAN_API Result<std::uint32_t> chooseBlocks(const std::optional<std::uint32_t>& block, const Lattice& lattice,
                                           std::uint64_t usableBytes);

/// Greedy Delaunay refinement of lattices, curvilinear grids and scattered points into a target (R8, R9, R10, R12), of
/// what takenFor() gives. Blocks are refined out of core, which needs BuildTarget::ofFixedSize.
TAN_API Result<BuildReport> buildInto(const Dataset& dataset, const Refinement& refinement, BuildTarget& target,
                                      const Progress& progress);

/// Why the dataset cannot be decimated, for the user; success if it can.
TAN_API Status checkDecimation(const Dataset& dataset);

/// Edge collapse of irregular data, lattices and grids into a target (R11, R12), of what takenFor() gives.
TAN_API Result<BuildReport> buildInto(const Dataset& dataset, const Decimation& decimation, BuildTarget& target,
                                      const Progress& progress);

} // namespace tetra
