// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace tetra {

/// The date of a time by the conventions CF (chapter 4.4): of 1073364 "hours since 1900-01-01" by the calendar
/// "gregorian" it is "2022-06-13 12:00"; to the nearest second. Nothing where the units or the calendar are others, or
/// the year is none of 0 to 9999: units of months and years have no length, and dates with a zone other than UTC are
/// left to the reader.
std::optional<std::string> dateOf(double time, std::string_view units, std::string_view calendar);

} // namespace tetra
