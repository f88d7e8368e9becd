// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/data.h>
#include <tan/model.h>
#include <tan/verify.h>

#include <QJsonObject>

#include <string>
#include <utility>
#include <vector>

namespace tetra {

/// Adds "error_statistics", "error_in_space" and, of data that can warp, "warping_statistics".
void addStatistics(QJsonObject& figures, const ErrorStatistics& measured, DomainClass domain);

/// The same for people, one row a measure; each mesh's with its name before it. Of curvilinear data the error in the
/// grid and the error in space are told apart; elsewhere they are one.
struct NamedStatistics {
    std::string name;
    const ErrorStatistics& measured;
};
std::string statisticsText(const std::vector<NamedStatistics>& meshes, DomainClass domain);

/// Which of the two a model of curvilinear data guarantees, in a paragraph of its own; of other data nothing.
std::string guaranteeText(const ModelDescription& description);

} // namespace tetra
