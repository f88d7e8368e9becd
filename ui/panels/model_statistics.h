// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/scenes/scene_builder.h"

#include <tan/model.h>
#include <tan/view.h>

#include <QString>

#include <optional>
#include <vector>

namespace tetra {

/// What a mesh of one accuracy of the paper's tables costs (R26).
struct LevelStatistics {
    double error = 0;   ///< % of the value range
    double inUnits = 0; ///< the same in units of the data
    QString factor{};   ///< of logarithms, the factor that it is
    std::uint32_t sites = 0;
    std::uint64_t tetrahedra = 0;
    double share = 0;              ///< of the finest mesh's tetrahedra, %
    std::optional<double> seconds; ///< that extracting it is expected to take; nothing before anything was measured
    std::uint64_t bytes = 0;       ///< that the extracted mesh occupies
};

/// One for each of `accuracyPresets`. `secondsPerTetrahedron` as measured here. O(levels * log sites).
std::vector<LevelStatistics> levelStatistics(const Model& model, std::optional<double> secondsPerTetrahedron,
                                             const WarpingChoice& warping = {});

/// How quickly the mesh of a scene was extracted; nothing if it was there already.
std::optional<double> secondsPerTetrahedron(const BuiltScene& scene);

/// The names of the columns, by which error it is that a model guarantees and whether that is a factor, and what stands
/// in them for a level, as the user reads it.
QStringList levelColumns(ErrorMeaning meaning, bool ofLogarithms);
QStringList levelTexts(const LevelStatistics& level);

/// A fact for people: what it is and what it amounts to.
struct StatisticsFact {
    QString name;
    QString value;
};

/// Of the model, and of what is shown of it.
std::vector<StatisticsFact> modelFacts(const Model& model);
/// What a visibility order needed (RenderStatistics).
struct OrderFaults {
    std::size_t cutCells = 0;
    std::size_t brokenCycles = 0;
    bool operator==(const OrderFaults&) const = default;
};

/// `faults`: of the order of the last picture; none if it has no volume.
std::vector<StatisticsFact> sceneFacts(const BuiltScene& scene, double frameSeconds,
                                       const std::optional<OrderFaults>& faults);

/// All of it as lines of text with tabs between the columns, for a clipboard.
QString statisticsText(const std::vector<StatisticsFact>& facts, const std::vector<LevelStatistics>& levels,
                       ErrorMeaning meaning);

} // namespace tetra
