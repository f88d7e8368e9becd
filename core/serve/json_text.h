// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/json.h"

#include <tan/base.h>

#include <cmath>
#include <concepts>
#include <string>
#include <string_view>

namespace tetra {

// JSON as it is written: values are texts of JSON, objects and arrays grow from them.

inline std::string jsonText(std::string_view text)
{
    return jsonString(text);
}
inline std::string jsonText(const char* text)
{
    return jsonString(text);
}
inline std::string jsonText(const std::string& text)
{
    return jsonString(text);
}
template <std::integral Number> std::string jsonText(Number number)
{
    return std::to_string(number);
}
inline std::string jsonText(bool yes)
{
    return yes ? "true" : "false";
}
/// What is not finite is null, as JSON has no word for it.
inline std::string jsonText(double number)
{
    return std::isfinite(number) ? formatNumber(number) : "null";
}

class JsonArrayText {
public:
    JsonArrayText& addText(std::string_view json)
    {
        text_ += text_.size() > 1 ? "," : "";
        text_ += json;
        return *this;
    }
    template <class Value> JsonArrayText& add(const Value& value) { return addText(jsonText(value)); }
    std::string text() const { return text_ + "]"; }

private:
    std::string text_ = "[";
};

class JsonObjectText {
public:
    JsonObjectText& addText(std::string_view name, std::string_view json)
    {
        text_ += text_.size() > 1 ? "," : "";
        text_ += jsonString(name) + ":";
        text_ += json;
        return *this;
    }
    template <class Value> JsonObjectText& add(std::string_view name, const Value& value)
    {
        return addText(name, jsonText(value));
    }
    std::string text() const { return text_ + "}"; }

private:
    std::string text_ = "{";
};

} // namespace tetra
