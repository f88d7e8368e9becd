// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/json.h"

#include <tan/base.h>

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tetra {

/// The members of a JSON object, read one after the other: a member that is missing leaves the value as it is, one of
/// another type is remembered as the error, by its whole name ("mesh.focus.radius"). The first error stays. Refers to
/// the object.
class JsonFields {
public:
    /// Null, and what is no object, has no members.
    JsonFields(const JsonValue* object, std::string name, std::optional<Error>& error)
        : object_(object), name_(std::move(name)), error_(error)
    {
    }

    const JsonValue* find(std::string_view key) const { return object_ != nullptr ? object_->find(key) : nullptr; }
    bool has(std::string_view key) const { return find(key) != nullptr; }
    /// All of them; null if it is no object.
    const JsonObject* members() const { return object_ != nullptr ? object_->object() : nullptr; }

    void read(std::string_view key, bool& value) const
    {
        const JsonValue* const found = find(key);
        if (const bool* truth = found != nullptr ? std::get_if<bool>(&found->content) : nullptr)
            value = *truth;
        else
            refuse(key, Message::marked("true or false"));
    }
    void read(std::string_view key, double& value) const
    {
        if (const auto number = numberOf(find(key)))
            value = *number;
        else
            refuse(key, Message::marked("a number"));
    }
    void read(std::string_view key, float& value) const
    {
        double wide = value;
        read(key, wide);
        value = static_cast<float>(wide);
    }
    void read(std::string_view key, std::string& value) const
    {
        const JsonValue* const found = find(key);
        if (const std::string* text = found != nullptr ? found->string() : nullptr)
            value = *text;
        else
            refuse(key, Message::marked("text in quotes"));
    }
    /// Three numbers.
    template <class Vector> void readThree(std::string_view key, Vector& value) const
    {
        if (const auto three = threeOf(find(key)))
            for (int axis = 0; axis < 3; ++axis)
                value[axis] = (*three)[static_cast<std::size_t>(axis)];
        else
            refuse(key, Message::marked("three numbers in brackets"));
    }
    /// The number of the name among `names`, an enumeration's.
    template <class Enumeration, std::size_t count>
    void readName(std::string_view key, const std::array<const char*, count>& names, Enumeration& value) const
    {
        std::string name = names[static_cast<std::size_t>(value)];
        read(key, name);
        for (std::size_t i = 0; i < count; ++i)
            if (name == names[i]) {
                value = static_cast<Enumeration>(i);
                return;
            }
        refuse(key, Message::marked("one of the known names"));
    }
    /// The members of a member; none if it is missing.
    JsonFields fields(std::string_view key) const
    {
        const JsonValue* const found = find(key);
        if (found == nullptr || found->object() == nullptr)
            refuse(key, Message::marked("an object, in braces"));
        return {found, full(key), error_};
    }
    /// The members of each object of a list; none if it is missing.
    std::vector<JsonFields> list(std::string_view key) const
    {
        std::vector<JsonFields> elements;
        const JsonValue* const found = find(key);
        if (const JsonArray* const array = found != nullptr ? found->array() : nullptr)
            for (std::size_t i = 0; i < array->size(); ++i)
                elements.emplace_back(&(*array)[i], full(key) + "[" + std::to_string(i) + "]", error_);
        return elements;
    }
    /// What is there must be `wanted`; what is missing need not be there.
    void refuse(std::string_view key, MarkedText wanted) const
    {
        if (has(key))
            refuse({ErrorKind::BadInput, Message::say("\"%1\" must be %2.", full(key), wanted)});
    }
    void refuse(const Error& error) const
    {
        if (!error_)
            error_ = error;
    }

    static std::optional<double> numberOf(const JsonValue* value)
    {
        return value != nullptr ? value->numberAs<double>() : std::nullopt;
    }
    static std::optional<std::array<double, 3>> threeOf(const JsonValue* value)
    {
        const JsonArray* const list = value != nullptr ? value->array() : nullptr;
        std::array<double, 3> three{};
        if (list == nullptr || list->size() != three.size())
            return std::nullopt;
        for (std::size_t axis = 0; axis < three.size(); ++axis) {
            const auto number = numberOf(&(*list)[axis]);
            if (!number)
                return std::nullopt;
            three[axis] = *number;
        }
        return three;
    }

private:
    std::string full(std::string_view key) const
    {
        return name_.empty() ? std::string(key) : name_ + "." + std::string(key);
    }

    const JsonValue* object_;
    std::string name_;
    std::optional<Error>& error_;
};

// Values as they are written.

/// The same with its numbers as those of values are written, whatever text they came with.
inline JsonValue withOwnNumbers(JsonValue value)
{
    if (JsonArray* const elements = value.array()) {
        for (JsonValue& element : *elements)
            element = withOwnNumbers(std::move(element));
    } else if (JsonObject* const members = value.object()) {
        for (auto& [name, member] : *members)
            member = withOwnNumbers(std::move(member));
    } else if (const auto number = value.numberAs<double>()) {
        value = *number;
    }
    return value;
}

/// The name of a choice among `names`, an enumeration's.
template <class Choice, std::size_t count>
JsonValue jsonName(const std::array<const char*, count>& names, Choice choice)
{
    return std::string(names[static_cast<std::size_t>(choice)]);
}
template <class Vector> JsonValue jsonThree(const Vector& vector)
{
    return JsonArray{vector[0], vector[1], vector[2]};
}

} // namespace tetra
