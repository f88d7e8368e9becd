// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// tan/model.h: a multiresolution model, opened from its `.tan` file.
///
/// A model holds every tetrahedron that ever lived while it was built, coarse first; any set of its sites that is
/// closed has a mesh. Most programs open one, ask its description, and go on to tan/query.h; those that study histories
/// read the arrays (docs: core/history/FORMAT.md in the sources explains each of them).
///
/// Words that all headers use:
/// - A *site* is a point of the dataset that became a vertex; sites are numbered in order of importance.
/// - The *history* is every tetrahedron that ever lived, with the site that created and the one that destroyed it.
/// - The *error* of a mesh is the largest difference between a sample and the mesh's linear interpolation there.
/// - Its *warping* is the largest distance between a point of the data and its position in the mesh, in units of
///   length; for irregular data, between a vertex of the data's boundary and the mesh's boundary. Lattices and
///   scattered points have none. Queries and reports give both in percent of the value range and of the bounding
///   box's diagonal.
/// - The *key* of a mesh is its error or, where there is warping, the larger of that and the weighted warping. The
///   *running* key is the smallest one so far.
/// - A *batch* is the sites of one running key; a query gives the mesh at the end of a batch. A *group* is the sites
///   of a batch that depend on each other.
/// - A set of sites is *closed* if with a site it holds its group and the creators of all that the group destroys. It
///   has a *conforming* mesh: tetrahedra meet in common faces, edges and vertices only.
/// - *Lattice* means a regular one, *grid* a curvilinear one, which is a lattice in its *computational space*.
///
/// Marks such as R14, S5 and B3 are the numbers under which tests and commits name a requirement, and need not be
/// looked up; 2.3 is a section of the paper (README.md names it).
///
/// ~~~{.cpp}
/// /// What a model says of itself, as "bucky.nrrd: 32768 sites, 594821 tetrahedra, built by refinement".
/// tetra::Result<std::string> describe(const std::filesystem::path& path)
/// {
///     const auto model = tetra::Model::open(path);
///     if (!model)
///         return model.error();
///     const tetra::ModelDescription& about = (*model)->description();
///     return about.sourceName + ": " + std::to_string((*model)->siteCount()) + " sites, " +
///            std::to_string((*model)->tetrahedronCount()) + " tetrahedra, built by " + about.builder;
/// }
/// ~~~

#include <tan/base.h>
#include <tan/data.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace tetra {

class WholeElsewhere;

/// What a model says of itself: its domain, its values, and how it was made.
struct ModelDescription {
    DomainClass domain = DomainClass::RegularLattice;
    Lattice lattice; ///< as Dataset::lattice: of curvilinear data the computational space
    /// The lengths of the lattice's steps by which tetrahedra were chosen, where they are not its spacing: that may
    /// have been corrected since, and the mesh stays what it is.
    std::optional<Eigen::Vector3d> metric{};
    Eigen::AlignedBox3d bounds{Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0, 0, 0)}; ///< of all points of the dataset
    /// Units of the values for a unit of length: running keys are the larger of error and this times warping (S4). 0
    /// where there is no warping.
    double warpingWeight = 0;
    /// Whether what is positive in computational space is negative in physical space: of lattices, for which the
    /// indices are that space, and curvilinear data.
    bool leftHanded = false;
    /// HistoryTraits::delaunay: if not, only closed sets of sites have a mesh.
    bool delaunay = true;
    SampleType sampleType = SampleType::UInt8;
    ValueRange range;                                            ///< of the whole dataset, not of the sites
    std::string space;                                           ///< as Dataset::space
    std::string lengthUnit;                                      ///< as Dataset::lengthUnit
    std::string sourceName;                                      ///< provenance: the dataset's name ...
    std::uint64_t sourceHash = 0;                                ///< ... and Source::hash
    std::string valueName;                                       ///< Source::valueName; empty: unknown
    std::vector<Taken> taken;                                    ///< Source::taken ...
    std::vector<Message> leftOut;                                ///< ... and Source::leftOut, in English
    std::string builder;                                         ///< id of the builder plugin
    std::vector<std::pair<std::string, std::string>> parameters; ///< the builder's parameters, as text

    Eigen::Vector3d meshSpacing() const { return metric.value_or(lattice.spacing); }
};

/// A multiresolution model in a mapped `.tan` file (FORMAT.md), read-only and shared by everything that looks at it.
/// Opening validates the header, the section table and the bounds of the sections; it reads none of the arrays. Sites
/// are in order of importance, batches of equal running key one after the other, groups in them (FORMAT.md);
/// tetrahedra are grouped by creator. Safe to read from any number of threads.
///
/// The contents of the arrays are not validated by opening. The file has checksums: whoever reads elements calls
/// check() on them, before or after, and on failure discards the result and returns checkIntact()'s error; likewise if
/// the file was truncated or modified meanwhile (reads may then give zeros). MeshExtractor and verify() do so. Files
/// older than format 1.3 have checksums of whole sections only: a background thread verifies them from opening on, and
/// until it has finished check() says that data are intact unless damage was found already. So before a result leaves
/// the program, confirm() waits for it. Checksums guard against damage, not against intent, so whoever follows an index
/// checks it still (extraction does).
class TAN_API Model {
public:
    static constexpr std::uint32_t never = 0xffffffff; ///< destroyer of a tetrahedron that never dies (S2)

    /// Errors: no file, no model, damaged, made by a later version, too many files. From any thread; the model keeps
    /// the file open. A file that is truncated while it is mapped would end the program with SIGBUS: the first model
    /// opened installs a handler of that signal, which gives zeros in its place (then checkIntact() tells) and hands on
    /// what is not its own to the handler that was there before. At most 1024 files are mapped at a time.
    static Result<std::shared_ptr<const Model>> open(const std::filesystem::path& path);
    /// The same of a file that stands for another one, which was unpacked or fetched to there: `place` is where that
    /// lies, a path or an address. With `whole` it stays there, and the file is its beginning.
    TAN_INTERNAL static Result<std::shared_ptr<const Model>> open(const std::filesystem::path& path,
                                                                  std::filesystem::path place,
                                                                  std::shared_ptr<const WholeElsewhere> whole = {});
    ~Model();
    Model(const Model&) = delete;
    Model& operator=(const Model&) = delete;

    /// Where it lies for the user: the path it was opened by, or the address (tan/open.h).
    const std::filesystem::path& path() const noexcept { return path_; }
    const ModelDescription& description() const noexcept { return description_; }
    std::uint64_t fileSize() const noexcept { return fileSize_; }
    /// Of a model that was left at a server (tan/open.h) who answers for it; else null. Then the arrays are those of
    /// its beginning only, while meshes and their sizes (tan/query.h) are those of the whole, but for extractPrefix().
    TAN_INTERNAL const WholeElsewhere* elsewhere() const noexcept { return whole_.get(); }
    /// A bound on the key of the mesh of all sites, in units of the values.
    float finalKey() const noexcept { return finalKey_; }

    std::uint32_t siteCount() const noexcept { return static_cast<std::uint32_t>(points_.size()); }
    /// All that ever lived in a mesh that a query can give.
    std::uint64_t tetrahedronCount() const noexcept { return destroyers_.size(); }

    std::span<const std::uint32_t> points() const noexcept { return points_; } ///< the dataset's point of each site
    /// A sample of sampleType for each site; visitSampleType() gives its C++ type.
    std::span<const std::byte> values() const noexcept { return values_; }
    /// Running minimum of the mesh's key before each site entered, in units of the values: its error, or with a warping
    /// weight the larger of that and the weighted warping. Not increasing; infinity for the initial sites (S1).
    std::span<const float> runningKeys() const noexcept { return runningKeys_; }
    /// Site s created the tetrahedra starOffsets()[s] up to starOffsets()[s + 1]; siteCount() + 1 entries.
    std::span<const std::uint64_t> starOffsets() const noexcept { return starOffsets_; }
    /// The number of tetrahedra in the mesh of all sites up to the end of s's group, for each s.
    std::span<const std::uint32_t> meshSizes() const noexcept { return meshSizes_; }
    /// 1 for a site whose successor belongs to the same group, else 0. The first N sites have a mesh if N - 1 ends its
    /// group.
    std::span<const std::uint8_t> groupGoesOn() const noexcept { return groupGoesOn_; }
    /// The three sites of a tetrahedron that are not its creator; (creator, a, b, c) is positive in the space that the
    /// mesh was made in: computational space for curvilinear data.
    std::span<const std::array<std::uint32_t, 3>> otherSites() const noexcept { return otherSites_; }
    std::span<const std::uint32_t> destroyers() const noexcept { return destroyers_; }
    /// Bound on each tetrahedron's own error as IEEE half, a fraction of the value range.
    std::span<const std::uint16_t> ownErrors() const noexcept { return ownErrors_; }
    /// Likewise on its own warping, a fraction of the bounding box's diagonal; empty without a warping weight.
    std::span<const std::uint16_t> ownWarpings() const noexcept { return ownWarpings_; }
    /// The last site of each batch. Empty in files that do not tell (FORMAT.md, section 48), as are the next two.
    std::span<const std::uint32_t> batchEnds() const noexcept { return batchEnds_; }
    /// Bounds on error and warping, apart, of the mesh at the end of each batch (C1), in units of the values and of
    /// length. Empty without a warping weight, where the key is the error; and in models whose warping is claimed from
    /// both sides of the boundary, of which these would tell one.
    std::span<const float> batchErrors() const noexcept { return batchErrors_; }
    std::span<const float> batchWarpings() const noexcept { return batchWarpings_; }
    /// ownErrors() and ownWarpings() of one tetrahedron below tetrahedronCount(), in units of the values and of length
    /// (0 without a warping weight).
    double ownError(std::uint64_t tetrahedron) const noexcept;
    double ownWarping(std::uint64_t tetrahedron) const noexcept;

    /// Where each site lies: nothing for a regular lattice, else one array of the two, that of floats if they hold
    /// every coordinate of the dataset exactly.
    std::span<const Eigen::Vector3f> floatPositions() const noexcept { return floatPositions_; }
    std::span<const Eigen::Vector3d> doublePositions() const noexcept { return doublePositions_; }
    /// Where a site below siteCount() lies in physical space, exactly. For a few.
    Eigen::Vector3d position(std::uint32_t site) const;
    /// The length that warpings are a percentage of (R7).
    double diagonal() const noexcept { return description_.bounds.diagonal().norm(); }

    /// All samples of the dataset, of sampleType, in the lattice's order: some files of regular and curvilinear data
    /// hold them. Else empty.
    std::span<const std::byte> samples() const noexcept { return samples_; }
    /// With the samples of curvilinear data where they lie, in floats or doubles as the sites' positions.
    std::span<const Eigen::Vector3f> floatSamplePositions() const noexcept { return floatSamplePositions_; }
    std::span<const Eigen::Vector3d> doubleSamplePositions() const noexcept { return doubleSamplePositions_; }

    /// The whole file as it is mapped, for those who check it.
    std::span<const std::byte> fileBytes() const noexcept;
    /// Whether these elements of one of the arrays are those that were written, as far as is known: false if any damage
    /// has been found, anywhere in the file. The checksum of each chunk is computed once, at its first check; of many
    /// chunks on all threads of the current TBB arena.
    template <class T> bool check(std::span<const T> elements) const noexcept
    {
        return checkBytes(std::as_bytes(elements));
    }
    template <class T> bool check(const T& element) const noexcept { return check(std::span(&element, 1)); }
    /// The same for many elements, in parts. Errors: checkIntact()'s, cancelled.
    template <class T> Status check(std::span<const T> elements, const Progress& progress) const
    {
        return checkBytes(std::as_bytes(elements), progress);
    }

    /// Which arrays checkPrefix() checks.
    enum Reading : unsigned {
        Batches = 1,   ///< runningKeys(), meshSizes() and groupGoesOn() of the sites
        Stars = 2,     ///< their starOffsets(), with otherSites() and destroyers() of the tetrahedra that they created
        OwnBounds = 4, ///< ownErrors() and ownWarpings() of these, with the offsets
    };
    /// check() of all that. Errors: checkIntact()'s, cancelled.
    Status checkPrefix(std::uint32_t sites, unsigned reading, const Progress& progress = {}) const;

    /// An Error naming the file if a checksum was found to be wrong so far. Makes no system call, so it never blocks.
    Status foundDamage() const;
    /// An Error naming the file if it was cut short or changed since it was mapped.
    Status checkUnchanged() const;
    /// The same, and if a checksum was found to be wrong.
    Status checkIntact() const;
    /// The same, but waits until that is known for certain: at once, unless the file is older than format 1.3. Errors:
    /// checkIntact()'s, cancelled.
    Status confirm(const Progress& progress = {}) const;

private:
    struct File;
    Model(File file, ModelDescription description, std::filesystem::path place,
          std::shared_ptr<const WholeElsewhere> whole);
    bool checkBytes(std::span<const std::byte> bytes) const noexcept;
    Status checkBytes(std::span<const std::byte> bytes, const Progress& progress) const;

    std::unique_ptr<const File> file_;
    std::shared_ptr<const WholeElsewhere> whole_;
    std::filesystem::path path_;
    ModelDescription description_;
    std::uint64_t fileSize_ = 0;
    float finalKey_ = 0;
    std::span<const std::uint32_t> points_;
    std::span<const std::byte> values_;
    std::span<const float> runningKeys_;
    std::span<const std::uint64_t> starOffsets_;
    std::span<const std::uint32_t> meshSizes_;
    std::span<const std::uint8_t> groupGoesOn_;
    std::span<const std::array<std::uint32_t, 3>> otherSites_;
    std::span<const std::uint32_t> destroyers_;
    std::span<const std::uint16_t> ownErrors_;
    std::span<const std::uint16_t> ownWarpings_;
    std::span<const std::uint32_t> batchEnds_;
    std::span<const float> batchErrors_;
    std::span<const float> batchWarpings_;
    std::span<const Eigen::Vector3f> floatPositions_;
    std::span<const Eigen::Vector3d> doublePositions_;
    std::span<const std::byte> samples_;
    std::span<const Eigen::Vector3f> floatSamplePositions_;
    std::span<const Eigen::Vector3d> doubleSamplePositions_;
};

/// Where a lattice lies, as far as that is corrected.
struct Placement {
    std::optional<Eigen::Vector3d> spacing{};
    std::optional<Eigen::Vector3d> origin{};
    std::optional<std::string> lengthUnit{};
};

/// Writes a copy of a lattice's model that lies elsewhere, for data whose file did not say where: sites, tetrahedra and
/// errors are the same, and so is what was chosen by the spacing that the model was built with
/// (ModelDescription::metric). O(file). Errors: a model of other data, or with weights at places; a spacing that is not
/// positive; damage; those of writing; cancelled.
TAN_API Status writePlaced(const Model& model, const Placement& placement, const std::filesystem::path& output,
                           const Progress& progress = {});

/// How many cells its file lists as faulty (C10): of irregular data those that were left out, but for holes by their
/// value; of a grid those that are folded or have no volume. 0 as well for files that do not tell. O(log cells).
TAN_API std::uint64_t faultyCellCount(const Model& model);
/// These cells, ascending; a grid's are Folded or NoVolume, numbered x fastest, those without volume behind the others,
/// and have corners where the model knows all eight: it has the positions of all samples, or each corner is a site.
/// Errors: a damaged file. O(sites log cells). May throw std::bad_alloc.
TAN_API Result<std::vector<FaultyCell>> faultyCells(const Model& model);

} // namespace tetra
