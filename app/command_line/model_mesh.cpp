// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/model_mesh.h"

#include "app/command_line/queried_mesh.h"

namespace tetra {

Result<ModelMesh> openModelMesh(const std::filesystem::path& path, const Accuracy& accuracy, const Progress& progress)
{
    const auto model = Model::open(path);
    if (!model)
        return model.error();
    const MeshSize size = meshSizeAt(**model, accuracy);
    auto mesh = confirmed(**model, extractPrefix(**model, size.sites, progress), progress);
    if (!mesh)
        return mesh.error();
    return ModelMesh{*model, size, std::make_shared<const TetrahedralMesh>(*std::move(mesh))};
}

} // namespace tetra
