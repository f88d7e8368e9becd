// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/json_fields.h"
#include "ui/session/look.h"
#include "ui/session/query_state.h"

#include <tan/render.h>

namespace tetra {

/// The values of a session as JSON, and back: what the text leaves open stays as it is in the value that is read into.

QJsonObject toJson(const QueryState& query);
void readQuery(const JsonFields& fields, QueryState& query);

/// Settings keep their type: {"integer": 3}, {"number": 0.5}, true, "text".
QJsonObject toJson(const Look& look);
void readLook(const JsonFields& fields, Look& look, std::optional<Error>& error);

QJsonObject toJson(const TransferFunction& transfer);
void readTransfer(const QJsonValue& value, TransferFunction& transfer, std::optional<Error>& error);

/// In the form that files of cameras have; what is left open fits a box of side 1.
QJsonObject toJson(const Camera& camera);
void readCamera(const QJsonValue& value, Camera& camera, std::optional<Error>& error);

QJsonArray toJson(const std::vector<Isovalue>& isovalues);
std::vector<Isovalue> isovaluesOf(const QJsonArray& list, std::optional<Error>& error);

} // namespace tetra
