// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <functional>
#include <string>
#include <string_view>

namespace tetra {

/// What a number is written with, as locales differ in it; without anything between groups of digits. UTF-8.
struct NumberSigns {
    std::string decimalPoint = ".";
    std::string minus = "-";
    std::string plus = "+"; ///< of exponents
    std::string exponent = "e";
    char32_t zero = U'0'; ///< the other digits follow it
    bool operator==(const NumberSigns&) const = default;
};

/// `plain`: a number as the C locale writes it, such as "-1.5e+07".
std::string withSigns(std::string_view plain, const NumberSigns& signs);

/// How annotations write numbers, and what they say.
struct AnnotationLanguage {
    NumberSigns numbers{};
    std::function<std::string(const Message&)> translate{}; ///< called by whoever lays out or paints; null: English

    std::string say(const Message& message) const { return translate ? translate(message) : message.text(); }
};

} // namespace tetra
