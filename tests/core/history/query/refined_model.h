// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/work_folder.h"
#include "core/history/model_writer.h"
#include "plugins/builders/refinement/refinement_builder.h"

#include <QtGlobal>

#include <filesystem>
#include <memory>
#include <string>

namespace tetra {

/// Builds a model by refinement and opens it; null, with a warning, if that fails.
inline std::shared_ptr<const Model> refinedModel(const std::filesystem::path& path, const Dataset& dataset,
                                                 const std::string& block = "none", double error = 0)
{
    const std::filesystem::path work = path.string() + ".work";
    auto folder = WorkFolder::open(work, WorkFolder::Leftovers::Remove);
    if (!folder)
        return nullptr;
    const auto writer = ModelWriter::create(path, dataset, {}, folder->path());
    BuildTarget target{.history = **writer, .workFolder = folder->path()};
    target.planned = [&](const FixedCounts& counts, const auto&) {
        return FixedSizeModelWriter::create(path, dataset, {}, counts, work);
    };
    ParameterValues values = {{"error", error}};
    if (dataset.domain == DomainClass::RegularLattice)
        values["block"] = block;
    const auto report = RefinementBuilder().build(dataset, values, target, {});
    if (!report)
        qWarning("%s", report.error().text.c_str());
    auto model = report ? Model::open(path) : Result<std::shared_ptr<const Model>>(report.error());
    return model ? *model : nullptr;
}

} // namespace tetra
