// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/data/dataset.h"
#include "core/history/extraction.h"
#include "core/history/query/mesh_query.h"

#include <cstdint>
#include <optional>

namespace tetra {

/// What a mesh claims of its error and its warping at each sample, for verification.
class MeshBounds {
public:
    /// The same at all samples, in units of the values and of length.
    MeshBounds(double error, double warping);
    /// What the query's fields allow there, at this scale (keptPercent()). The dataset outlives it.
    MeshBounds(const MeshQuery& query, double scale, const Dataset& original);

    bool areUniform() const noexcept { return original_ == nullptr; }
    /// In units of the values. Fields are computed in doubles, so theirs is 1e-12 of the range more.
    double error(std::uint64_t sample) const;
    /// In units of length.
    double warping(std::uint64_t sample) const;

private:
    double asked(const ErrorField& field, std::uint64_t sample) const;

    double error_ = 0;
    double warping_ = 0;
    ErrorField errorField_;
    ErrorField warpingField_;
    double scale_ = 1;
    const Dataset* original_ = nullptr;
    double extent_ = 0;
    double diagonal_ = 0;
};

/// The least accuracy that a mesh of this scale keeps at all samples.
Accuracy keptEverywhere(const MeshQuery& query, double scale);

} // namespace tetra
