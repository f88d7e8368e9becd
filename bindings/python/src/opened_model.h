// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "point_location.h"

#include <tan/model.h>
#include <tan/open.h>
#include <tan/picture.h>
#include <tan/query.h>

#include <memory>
#include <mutex>
#include <optional>

namespace tetra::python {

/// A model with what answers questions to it, from any thread: each of the two is used by one at a time.
struct OpenedModel {
    explicit OpenedModel(FoundModel found) : found(std::move(found)), extractor(this->found.model) {}

    const std::shared_ptr<const Model>& model() const noexcept { return found.model; }

    FoundModel found;
    std::timed_mutex extracting; ///< guards the next one
    MeshExtractor extractor;
    std::timed_mutex drawing; ///< guards the next one
    std::optional<PictureMaker> maker{};
};

/// A mesh that a model has given, and what is made of it once.
struct MeshOfModel {
    std::shared_ptr<const ExtractedMesh> extracted;
    std::timed_mutex making; ///< guards the next two
    std::shared_ptr<const Buffer<Eigen::Vector3f>> gradients{};
    std::shared_ptr<const PointLocation> location{};

    const TetrahedralMesh& mesh() const noexcept { return extracted->mesh; }
};

} // namespace tetra::python
