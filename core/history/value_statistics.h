// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/data.h>
#include <tan/model.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tetra {

/// Mean and standard deviation of values, and of which: isovalues of density maps are told by how many deviations they
/// lie above the mean.
struct ValueStatistics {
    enum class Of {
        Samples,   ///< all samples of the data, each as much as any other
        FinestMesh ///< the linear interpolation in the finest mesh of the model, integrated over its volume
    };
    double mean = 0;
    double deviation = 0; ///< root of the mean squared distance from the mean, of all of them: no estimate from some
    Of of = Of::Samples;
    bool operator==(const ValueStatistics&) const = default;

    double valueAt(double deviations) const noexcept { return mean + deviations * deviation; }
    /// Of a positive deviation.
    double deviationsAt(double value) const noexcept { return (value - mean) / deviation; }
};

/// Whether a dataset of this name is a density map by what it is called: *.mrc, *.ccp4, *.map, also packed (.gz),
/// and parts of such.
TAN_INTERNAL bool isDensityMap(std::string_view sourceName);

/// Of all samples of the data. The same bits on every machine, whatever the number of threads. O(points), on all
/// threads.
TAN_INTERNAL ValueStatistics statisticsOf(const ScalarField& values);

/// What a model of a density map keeps among its parameters ("values.mean", "values.deviation"), so that nobody needs
/// the samples for it. Nothing for other datasets.
TAN_INTERNAL std::vector<std::pair<std::string, std::string>> statisticsTexts(const Dataset& dataset);
inline constexpr std::string_view statisticsPrefix = "values.";
/// What statisticsTexts() wrote; nothing without it, and where all values are the same.
TAN_INTERNAL std::optional<ValueStatistics>
keptStatistics(std::span<const std::pair<std::string, std::string>> parameters);

/// Those that the model keeps, else of its finest mesh, which is visited for it: O(tetrahedra). Errors (WrongUsage): a
/// model of which only the beginning is here, and values that are all the same; damaged, cancelled, not enough memory.
TAN_INTERNAL Result<ValueStatistics> statisticsOf(const Model& model, const Progress& progress = {});

/// "2.5sd", a number of standard deviations above the mean; nothing if the text is none.
TAN_INTERNAL std::optional<double> parseDeviations(std::string_view text);

} // namespace tetra
