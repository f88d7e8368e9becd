// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/reproduction/drawing_times.h"
#include "app/reproduction/experiment.h"
#include "app/reproduction/paper_tables.h"

#include <tan/base.h>
#include <tan/model.h>

#include <memory>
#include <optional>
#include <set>

namespace tetra {

/// A level of the paper and what ours is at the same accuracy.
struct ReproducedLevel {
    PaperLevel paper;
    std::uint64_t sites = 0;
    std::uint64_t tetrahedra = 0;
};

/// A model of the paper, made again.
struct ReproducedModel {
    int table = 0;
    PaperModel paper;
    Experiment experiment;
    std::optional<Dataset> dataset;     ///< none: its file is missing, the rest is empty
    std::shared_ptr<const Model> model; ///< null as above
    double seconds = 0;
    std::uint64_t inverted = 0;
    std::uint64_t degenerate = 0;
    std::vector<ReproducedLevel> levels;
};

/// A row of Table 4, made again.
struct ReproducedSurface {
    PaperSurface paper;
    std::string variant;
    std::uint64_t sites = 0;
    std::uint64_t tetrahedra = 0;
    std::uint64_t triangles = 0;
    double extractionSeconds = 0; ///< of the surface, with its normals
    DrawingTimes times;
};

struct Reproduction {
    std::set<int> tables; ///< asked for: 1 to 4
    std::vector<ReproducedModel> models;
    std::vector<ReproducedSurface> surfaces;
};

/// Makes the models of the paper's tables again (R30), from the datasets in `data` into `folder`/models, and measures
/// them at the accuracies that the tables print. What has no data is left out and marked so. Errors: the paper's
/// figures are missing, a dataset that cannot be used, a build that fails, cancelled.
Result<Reproduction> reproduce(PluginHost& host, const std::filesystem::path& data, const std::filesystem::path& folder,
                               const std::set<int>& tables, const Progress& progress);

} // namespace tetra
