// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/build.h>
#include <tan/model.h>

#include <QtGlobal>

#include <cstdint>
#include <filesystem>
#include <memory>

namespace tetra {

/// Builds a model by refinement, in blocks of so many cells or as a whole, and opens it; null, with a warning, if that
/// fails.
inline std::shared_ptr<const Model> refinedModel(const std::filesystem::path& path, const Dataset& dataset,
                                                 std::uint32_t block = 0, double error = 0)
{
    if (const auto report = buildModel(dataset, path, Refinement{.error = error, .block = block}); !report) {
        qWarning("%s", report.error().text().c_str());
        return nullptr;
    }
    const auto model = Model::open(path);
    return model ? *model : nullptr;
}

} // namespace tetra
