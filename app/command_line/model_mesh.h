// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/query.h>

#include <filesystem>
#include <memory>

namespace tetra {

/// A model and one mesh of it.
struct ModelMesh {
    std::shared_ptr<const Model> model;
    MeshSize size;
    std::shared_ptr<const TetrahedralMesh> mesh;
};

/// Opens a model and extracts its mesh at this accuracy.
Result<ModelMesh> openModelMesh(const std::filesystem::path& path, const Accuracy& accuracy, const Progress& progress);

} // namespace tetra
