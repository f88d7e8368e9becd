// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/reproduction/experiment.h"
#include "app/reproduction/paper_pictures.h"
#include "app/reproduction/paper_tables.h"
#include "app/reproduction/surface_comparison.h"

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
    std::uint64_t bytes = 0; ///< of memory, besides what was occupied before; 0 if the system does not tell
    std::uint64_t inverted = 0;
    std::uint64_t degenerate = 0;
    std::vector<ReproducedLevel> levels;
};

/// How long the CPU back end takes for a picture, in seconds (drawPicture()).
struct DrawingTimes {
    double surface = 0; ///< of one isovalue
    double volume = 0;  ///< through the default transfer function
    double hybrid = 0;  ///< both
};

/// A row of Table 4, made again, with its pictures of Fig. 14.
struct ReproducedSurface {
    PaperSurface paper;
    std::string variant;
    std::uint64_t sites = 0;
    std::uint64_t tetrahedra = 0;
    std::uint64_t triangles = 0;
    double extractionSeconds = 0; ///< of the surface, with its normals
    DrawingTimes times;
    Picture surfacePicture;
    Picture volumePicture;
    Degradation surfaceDegradation; ///< beside the picture of the finest mesh
    Degradation volumeDegradation;
    SurfaceComparison comparison; ///< with the finest mesh's surface, simplified
};

/// Another picture of the paper, made again.
struct ReproducedPicture {
    int figure = 0;
    std::string caption;
    Picture picture;
};

struct Reproduction {
    std::set<int> tables; ///< asked for: 1 to 4
    std::vector<ReproducedModel> models;
    std::vector<ReproducedSurface> surfaces;
    std::vector<ReproducedPicture> pictures; ///< Fig. 13 and 15, where Tables 2 and 3 are made
};

/// Makes the models of the paper's tables again (R30), from the datasets in `data` into `folder`/models, and measures
/// them at the accuracies that the tables print. What has no data is left out and marked so. Errors: the paper's
/// figures are missing, a dataset that cannot be used, a build that fails, cancelled.
Result<Reproduction> reproduce(PluginHost& host, const std::filesystem::path& data, const std::filesystem::path& folder,
                               const std::set<int>& tables, const Progress& progress);

} // namespace tetra
