// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/json.h"

#include <string>
#include <string_view>

// JSON texts of values (json.h). Members stand in the order of their object; byName() gives another.

namespace tetra {

/// In one line, without blanks. O(bytes).
TAN_INTERNAL std::string compactJson(const JsonValue& value);

/// An element or member to the line, four blanks in for each level, and a line feed at the end. O(bytes).
TAN_INTERNAL std::string indentedJson(const JsonValue& value);

/// The same with the members of all objects in it in the order of their names' bytes.
TAN_INTERNAL JsonValue byName(JsonValue value);

/// The same JSON text, but no terminal obeys it: characters of its strings that control one, change the order of
/// letters or are of Unicode's category "format" are JSON's own escapes (\u202e). O(bytes).
TAN_INTERNAL std::string visibleJson(std::string_view json);

/// `text` as a JSON string, with its quotes; what is no UTF-8 in it, such as an old file name, as U+FFFD.
TAN_INTERNAL std::string jsonString(std::string_view text);

} // namespace tetra
