// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/model.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace tetra {

struct SomeModel {
    std::string name;
    std::shared_ptr<const Model> model;
};

/// A small model of each kind of data: lattices, grids that are bent and left-handed, scattered points. Their files go
/// to `folder`. What fails here fails the test.
std::vector<SomeModel> someModels(const std::filesystem::path& folder);

/// Random points in a cube, all of them sites.
std::shared_ptr<const Model> scatteredModel(const std::filesystem::path& path, std::size_t points, unsigned seed);

} // namespace tetra
