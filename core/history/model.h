// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/data/lattice.h"
#include "core/data/scalar_field.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace tetra {

class SectionChecks;

/// What a model says of itself: its domain, its values, and how it was made.
struct ModelDescription {
    DomainClass domain = DomainClass::RegularLattice;
    Lattice lattice; ///< as Dataset::lattice: of curvilinear data the computational space
    Eigen::AlignedBox3d bounds{Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0, 0, 0)}; ///< of all points of the dataset
    /// Units of the values for a unit of length: running keys are the larger of error and this times warping (S4). 0
    /// where there is no warping.
    double warpingWeight = 0;
    /// Whether what is positive in computational space is negative in physical space: curvilinear data only.
    bool leftHanded = false;
    /// HistoryTraits::delaunay: if not, only closed sets of sites have a mesh.
    bool delaunay = true;
    SampleType sampleType = SampleType::UInt8;
    ValueRange range;                                            ///< of the whole dataset, not of the sites
    std::string sourceName;                                      ///< provenance: the dataset's name ...
    std::uint64_t sourceHash = 0;                                ///< ... and Source::hash
    std::string builder;                                         ///< id of the builder plugin
    std::vector<std::pair<std::string, std::string>> parameters; ///< the builder's parameters, as text
};

/// A multiresolution model in a mapped `.tan` file (FORMAT.md), read-only and shared by everything that looks at it.
/// Opening checks the header, the section table and every section's bounds, and touches nothing else. Sites are in
/// order of importance, batches of equal running error one after the other, groups in them (FORMAT.md); tetrahedra are
/// grouped by creator. Safe to read from any number of threads.
///
/// Nothing of the arrays is to be believed unasked. The file has checksums: whoever reads elements names them to
/// check(), before or after, and reports checkIntact()'s error in place of a result if they are damaged, or if the file
/// was cut or changed meanwhile (then reads may give zeros). Sums of files before format 1.3 are of whole sections, so
/// all of such a file is read by a thread from opening on, and check() believes what it has not found wrong so far:
/// before a result leaves the program confirm() waits for it. Checksums guard against damage, not against intent, so
/// whoever follows an index checks it still (extraction does).
class Model {
public:
    static constexpr std::uint32_t never = 0xffffffff; ///< destroyer of a tetrahedron that never dies (S2)

    static Result<std::shared_ptr<const Model>> open(const std::filesystem::path& path);
    virtual ~Model() = default;

    const std::filesystem::path& path() const noexcept { return path_; }
    const ModelDescription& description() const noexcept { return description_; }
    std::uint64_t fileSize() const noexcept { return fileSize_; }
    float finalError() const noexcept
    {
        return finalError_;
    } ///< bounds the key of the mesh of all sites, in units of the values

    std::uint32_t siteCount() const noexcept { return static_cast<std::uint32_t>(points_.size()); }
    /// All that ever lived in a mesh that a query can give.
    std::uint64_t tetrahedronCount() const noexcept { return destroyers_.size(); }

    std::span<const std::uint32_t> points() const noexcept { return points_; } ///< the dataset's point of each site
    std::span<const std::byte> values() const noexcept { return values_; }     ///< a sample of sampleType for each site
    /// Running minimum of the mesh's key before each site entered, in units of the values: its error, or with a warping
    /// weight the larger of that and the weighted warping. Not increasing; infinity for the initial sites (S1).
    std::span<const float> runningErrors() const noexcept { return runningErrors_; }
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
    /// Bound on each tetrahedron's own error as IEEE half, a fraction of the value range (halfToFloat in
    /// core/base/rounding.h).
    std::span<const std::uint16_t> ownErrors() const noexcept { return ownErrors_; }
    /// Likewise on its own warping, a fraction of the bounding box's diagonal; empty without a warping weight.
    std::span<const std::uint16_t> ownWarpings() const noexcept { return ownWarpings_; }

    /// Where each site lies: nothing for a regular lattice, else one array of the two, that of floats if they hold
    /// every coordinate of the dataset exactly.
    std::span<const Eigen::Vector3f> floatPositions() const noexcept { return floatPositions_; }
    std::span<const Eigen::Vector3d> doublePositions() const noexcept { return doublePositions_; }
    /// Where site `site` lies in physical space, exactly. For a few.
    Eigen::Vector3d position(std::uint32_t site) const;
    /// The length that warpings are a percentage of (R7).
    double diagonal() const noexcept { return description_.bounds.diagonal().norm(); }

    /// All samples of the dataset, of sampleType, in the lattice's order: the file of lattice data, regular or
    /// curvilinear, may hold them. Empty if it does not.
    std::span<const std::byte> samples() const noexcept { return samples_; }
    /// With the samples of curvilinear data where they lie, in floats or doubles as the sites' positions.
    std::span<const Eigen::Vector3f> floatSamplePositions() const noexcept { return floatSamplePositions_; }
    std::span<const Eigen::Vector3d> doubleSamplePositions() const noexcept { return doubleSamplePositions_; }

    /// The whole file as it is mapped, for those who check it.
    virtual std::span<const std::byte> fileBytes() const noexcept = 0;
    /// Whether these elements of one of the arrays are those that were written, as far as is known: false if any damage
    /// was found so far, there or elsewhere. Each chunk of a section is summed up once, at its first check, many of
    /// them on all threads that TBB may use.
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

    /// What is read of a prefix of the sites.
    enum Reading : unsigned {
        Batches = 1,   ///< runningErrors(), meshSizes() and groupGoesOn() of the sites
        Stars = 2,     ///< their starOffsets(), with otherSites() and destroyers() of the tetrahedra that they created
        OwnBounds = 4, ///< ownErrors() and ownWarpings() of these, with the offsets
    };
    /// check() of all that. Errors: checkIntact()'s, cancelled.
    Status checkPrefix(std::uint32_t sites, unsigned reading, const Progress& progress = {}) const;

    /// An Error naming the file if a checksum was found to be wrong so far. No system call: for those who may not wait.
    Status foundDamage() const;
    /// An Error naming the file if it was cut short or changed since it was mapped.
    Status checkUnchanged() const;
    /// The same, and if a checksum was found to be wrong.
    Status checkIntact() const;
    /// The same, but waits until that is known for certain: at once, unless the file is older than format 1.3. Errors:
    /// checkIntact()'s, cancelled.
    Status confirm(const Progress& progress = {}) const;

protected:
    Model() = default;
    virtual bool changed() const noexcept = 0;
    virtual const SectionChecks& checks() const noexcept = 0;
    bool checkBytes(std::span<const std::byte> bytes) const noexcept;
    Status checkBytes(std::span<const std::byte> bytes, const Progress& progress) const;

    std::filesystem::path path_;
    ModelDescription description_;
    std::uint64_t fileSize_ = 0;
    float finalError_ = 0;
    std::span<const std::uint32_t> points_;
    std::span<const std::byte> values_;
    std::span<const float> runningErrors_;
    std::span<const std::uint64_t> starOffsets_;
    std::span<const std::uint32_t> meshSizes_;
    std::span<const std::uint8_t> groupGoesOn_;
    std::span<const std::array<std::uint32_t, 3>> otherSites_;
    std::span<const std::uint32_t> destroyers_;
    std::span<const std::uint16_t> ownErrors_;
    std::span<const std::uint16_t> ownWarpings_;
    std::span<const Eigen::Vector3f> floatPositions_;
    std::span<const Eigen::Vector3d> doublePositions_;
    std::span<const std::byte> samples_;
    std::span<const Eigen::Vector3f> floatSamplePositions_;
    std::span<const Eigen::Vector3d> doubleSamplePositions_;
};

} // namespace tetra
