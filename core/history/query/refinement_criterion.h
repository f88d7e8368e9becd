// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/model.h>
#include <tan/query.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <optional>
#include <utility>

namespace tetra {

/// Where the first sites of a model lie and what values they have, as a mesh holds them.
struct SitePlaces {
    Buffer<Eigen::Vector3d> positions;
    Buffer<float> values;
};

/// Says of tetrahedra of a history whether a query allows them: by their own error and warping (own bounds of the file
/// and, often closer, the running key when they died), against what the fields ask for anywhere in them. Sound: in a
/// closed set every sample that is no site counts for a tetrahedron that contains it or, outside of an irregular mesh,
/// for one with a face on the boundary within its own warping, so a mesh of allowed tetrahedra keeps the field at each
/// sample. Inverted tetrahedra of curvilinear data (S5) need no looking after: each tetrahedron of a history is in the
/// mesh of some level, which has only those that may be inverted anywhere. One thread; the model and the places outlive
/// it.
class RefinementCriterion {
public:
    /// `places` of all sites that are going to be corners.
    RefinementCriterion(const Model& model, const MeshQuery& query, const SitePlaces& places);

    /// Makes tooCoarse() quicker, once the places are there: for a ramp with a fall-off, 8 bytes a site, and by not
    /// asking after the running keys of the first sites, which are checked.
    void lookAtSites(std::uint32_t checkedSites);

    /// False if the tetrahedron is allowed everywhere, which most are: one comparison, for all of a star.
    bool mayBeTooCoarse(std::uint64_t tetrahedron) const
    {
        return warps_ || model_.ownErrors()[tetrahedron] > allowedAnywhere_;
    }
    /// Whether the tetrahedron is coarser than allowed somewhere. Its sites come before its creator.
    bool tooCoarse(std::uint64_t tetrahedron, std::uint32_t creator, std::uint32_t destroyer) const;
    /// The number that errors and warpings asked for must be multiplied by to allow it: 0 if it has no error.
    double scaleFor(std::uint64_t tetrahedron, std::uint32_t creator, std::uint32_t destroyer) const;

    /// The uniform query that the fields are nowhere finer than.
    Accuracy finest() const noexcept { return {leastError_, leastWarping_}; }
    /// The uniform query that the fields are nowhere coarser than.
    Accuracy coarsest() const noexcept { return {largestError_, largestWarping_}; }

private:
    struct Own {
        double error;   ///< % of the value range
        double warping; ///< % of the diagonal
    };
    struct Asked {
        double error;
        double warping;
    };
    std::array<std::uint32_t, 4> sitesOf(std::uint64_t tetrahedron, std::uint32_t creator) const;
    Own ownOf(std::uint64_t tetrahedron, std::uint32_t destroyer) const;
    Asked askedOf(std::uint64_t tetrahedron, std::uint32_t creator, const Own& own) const;
    enum class Quick { TooCoarse, Allowed, Unknown };
    Quick bySites(const std::array<std::uint32_t, 4>& sites, double error) const;
    std::pair<Eigen::Array3d, Eigen::Array3d> boxOf(const std::array<std::uint32_t, 4>& sites) const;
    bool isOutside(const std::array<std::uint32_t, 4>& sites, double margin) const;
    bool isAllowedOutside(std::uint64_t tetrahedron, std::uint32_t creator) const;

    const Model& model_;
    const MeshQuery& query_;
    const SitePlaces& places_;
    bool warps_;
    bool byValue_;
    bool valuesBounded_; ///< own errors bound the samples' values: not if they are weighted
    double leastError_;
    double largestError_;
    double leastWarping_;
    double largestWarping_;
    std::uint32_t checkedSites_ = 0;
    Buffer<double> atSites_;        ///< what the field is at each site, if that says something of the places between
    double slope_ = 0;              ///< by how much it changes with the distance at most
    double rounding_;               ///< of the positions, a length
    double distanceRounding_ = 0;   ///< likewise a fourth of what a distance from what is fine may be wrong by
    std::uint16_t allowedAnywhere_; ///< own errors as in the file, up to this one
    std::optional<Eigen::AlignedBox3d> finer_; ///< where the fields are not at their coarsest, if that is bounded
};

} // namespace tetra
