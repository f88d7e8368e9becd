// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/view/json_fields.h"

#include <tan/base.h>
#include <tan/view.h>

#include <cstdint>
#include <string_view>
#include <vector>

namespace tetra {

/// The view in a text that has more members than those of viewToText(): what is missing stays as it is in `view`.
TAN_INTERNAL void readView(const JsonFields& fields, ViewValue& view);

// Its parts, each where its source tells.

JsonValue toJson(const QueryState& query);
void readQuery(const JsonFields& fields, QueryState& query);
void readBudget(const JsonFields& fields, std::uint64_t& budget);

JsonValue toJson(const Appearance& appearance);
void readAppearance(const JsonFields& fields, Appearance& appearance);
JsonValue toJson(const TransferFunction& transfer);
/// The member "transfer".
void readTransfer(const JsonFields& fields, TransferFunction& transfer);
JsonValue toJson(const std::vector<Isovalue>& isovalues);
/// The member "isovalues".
void readIsovalues(const JsonFields& fields, std::vector<Isovalue>& isovalues);
JsonValue toJson(const Colour& colour);
Colour readColour(const JsonFields& fields, std::string_view key, const Colour& usual);

} // namespace tetra
