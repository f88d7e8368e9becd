// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/number_text.h"

#include <array>

namespace tetra {

namespace {

template <class Number> std::string shortest(Number number)
{
    std::array<char, 32> text{}; // -1.7976931348623157e+308 has 24 characters
    const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), number);
    return {text.data(), end};
}

} // namespace

std::string formatNumber(double number)
{
    return shortest(number);
}

std::string formatNumber(float number)
{
    return shortest(number);
}

} // namespace tetra
