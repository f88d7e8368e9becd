// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/json.h"

#include <tan/data.h>
#include <tan/model.h>
#include <tan/verify.h>

#include <string>
#include <utility>
#include <vector>

namespace tetra {

/// Adds "error_statistics", "error_in_space", of irregular data "error_at_nearest" and, of data that can warp,
/// "warping_statistics".
void addStatistics(JsonObject& figures, const ErrorStatistics& measured, DomainClass domain);

/// The same for people, one row a measure; each mesh's with its name before it. Of curvilinear data the error in the
/// grid and the error in space are told apart; elsewhere they are one.
struct NamedStatistics {
    std::string name;
    const ErrorStatistics& measured;
};
std::string statisticsText(const std::vector<NamedStatistics>& meshes, DomainClass domain);

/// Adds "error_in_space" alone, where the rest was not measured.
void addErrorInSpace(JsonObject& figures, const ErrorInSpace& measured);

/// Which of the two a model of curvilinear data guarantees, in a paragraph of its own, and how to know the other one
/// where that `isMeasured` not; of other data nothing.
std::string guaranteeText(const ModelDescription& description, bool isMeasured);
/// The same below the figures of a mesh (meshFigures()), if they leave the error in space open.
std::string guaranteeText(const JsonObject& figures);

/// "errors in the grid of up to 1.68 %", and in space, as far as the figures of a mesh tell.
std::string errorsUpTo(double percent, const JsonObject& figures);

/// What an error is where the values are logarithms, in a paragraph of its own; of other models nothing.
std::string logarithmText(const ModelDescription& description);
/// The same of logarithms of this name and range.
std::string logarithmText(const std::string& valueName, const ValueRange& range);

} // namespace tetra
