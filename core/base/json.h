// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <concepts>
#include <cstddef>
#include <initializer_list>
#include <optional>
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

/// The members of an object in the order in which they were read or made, each name once. A look at one of them takes
/// O(members).
class TAN_INTERNAL JsonObject {
    using Members = std::vector<JsonMember>;

public:
    JsonObject() = default;
    JsonObject(std::initializer_list<JsonMember> members);

    /// The member of that name; where there is none, one is made at the end, null.
    JsonValue& operator[](std::string_view name);
    /// Null if there is none.
    const JsonValue* find(std::string_view name) const noexcept;
    bool contains(std::string_view name) const noexcept { return find(name) != nullptr; }
    /// The number of that name, as one of C++; none if there is no such number, or one that does not fit.
    template <class Type> std::optional<Type> numberAs(std::string_view name) const;
    /// Adds a member whose name no other has.
    void append(std::string name, JsonValue value);

    std::size_t size() const noexcept;
    bool empty() const noexcept { return size() == 0; }
    Members::const_iterator begin() const noexcept;
    Members::const_iterator end() const noexcept;
    Members::iterator begin() noexcept;
    Members::iterator end() noexcept;

private:
    Members members_;
};

/// A value of a JSON text (RFC 8259) that is read or made. Numbers keep their text, so that the reader chooses the type
/// and loses nothing.
struct TAN_INTERNAL JsonValue {
    struct Number {
        std::string text;
    };

    JsonValue() = default;
    JsonValue(std::nullptr_t) {}
    template <std::same_as<bool> Truth> JsonValue(Truth truth) : content(truth) {}
    template <WholeNumber Type> JsonValue(Type number) : content(Number{std::to_string(number)}) {}
    /// The shortest text that reads back as the same number, without an exponent unless that is shorter; whole numbers
    /// up to 2^53, which no reader rounds, never have one. Null if it is not finite, as JSON has no word for that.
    template <std::floating_point Type> JsonValue(Type number) : JsonValue(ofFloating(static_cast<double>(number))) {}
    JsonValue(Number number) : content(std::move(number)) {}
    JsonValue(std::string text) : content(std::move(text)) {}
    JsonValue(std::string_view text) : content(std::string(text)) {}
    JsonValue(const char* text) : content(std::string(text)) {}
    JsonValue(JsonArray elements) : content(std::move(elements)) {}
    JsonValue(JsonObject members) : content(std::move(members)) {}

    const JsonArray* array() const noexcept { return std::get_if<JsonArray>(&content); }
    JsonArray* array() noexcept { return std::get_if<JsonArray>(&content); }
    const JsonObject* object() const noexcept { return std::get_if<JsonObject>(&content); }
    JsonObject* object() noexcept { return std::get_if<JsonObject>(&content); }
    const std::string* string() const noexcept { return std::get_if<std::string>(&content); }
    const Number* number() const noexcept { return std::get_if<Number>(&content); }
    /// A number as one of C++; none if this is no number, or one that does not fit.
    template <class Type> std::optional<Type> numberAs() const
    {
        return number() != nullptr ? parseNumber<Type>(number()->text) : std::nullopt;
    }
    /// The member of an object; null if there is none, or this is no object.
    const JsonValue* find(std::string_view name) const noexcept;

    std::variant<std::nullptr_t, bool, Number, std::string, JsonArray, JsonObject> content = nullptr;
    TextPlace place; ///< where it begins in the text that was read

private:
    static JsonValue ofFloating(double number);
};

template <class Type> std::optional<Type> JsonObject::numberAs(std::string_view name) const
{
    const JsonValue* const found = find(name);
    return found != nullptr ? found->numberAs<Type>() : std::nullopt;
}

/// Reads one JSON text strictly: UTF-8, no comments, no trailing commas, no member twice, nothing after the value, at
/// most 64 levels. O(bytes). The error says where.
TAN_INTERNAL Result<JsonValue> parseJson(std::string_view text);

} // namespace tetra
