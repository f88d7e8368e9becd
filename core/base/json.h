// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace tetra {

/// Where something stands in a text, from 1.
struct TextPlace {
    std::size_t line = 1;
    std::size_t column = 1; ///< in bytes
};

/// "line 3, column 14"
Message describePlace(const TextPlace& place);

struct JsonValue;
using JsonArray = std::vector<JsonValue>;
using JsonMember = std::pair<std::string, JsonValue>;
using JsonObject = std::vector<JsonMember>; ///< in the order of the text

/// A value of a JSON text (RFC 8259) and where it begins there. Numbers keep their text, so that the reader chooses the
/// type and loses nothing.
struct TAN_INTERNAL JsonValue {
    struct Number {
        std::string text;
    };
    std::variant<std::nullptr_t, bool, Number, std::string, JsonArray, JsonObject> content = nullptr;
    TextPlace place{};

    const JsonArray* array() const noexcept { return std::get_if<JsonArray>(&content); }
    const JsonObject* object() const noexcept { return std::get_if<JsonObject>(&content); }
    const std::string* string() const noexcept { return std::get_if<std::string>(&content); }
    const Number* number() const noexcept { return std::get_if<Number>(&content); }
    /// The member of an object; null if there is none, or this is no object.
    const JsonValue* find(std::string_view name) const noexcept;
};

/// Reads one JSON text strictly: UTF-8, no comments, no trailing commas, no member twice, nothing after the value, at
/// most 64 levels. O(bytes). The error says where.
TAN_INTERNAL Result<JsonValue> parseJson(std::string_view text);

/// The text of a value for people to read: a line for each element and each member, four blanks for each level, the
/// members of an object in the order of their names, a line feed at the end. Numbers have the text that they came with,
/// but whole ones of 64 bits no exponent. What parseJson() reads again, if its numbers are numbers. O(bytes).
std::string formatJson(const JsonValue& value);

/// `text` as a JSON string, with its quotes; what is no UTF-8 in it, such as an old file name, as U+FFFD.
TAN_INTERNAL std::string jsonString(std::string_view text);

} // namespace tetra
