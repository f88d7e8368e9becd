// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <QJsonObject>
#include <QJsonValue>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tetra {

/// The object that a text of JSON holds. Numbers that JSON does not have and writers put there all the same, NaN and
/// Infinity, become texts. The error is the end of a sentence that begins with the name of the file.
Result<QJsonObject> parseJsonObject(std::span<const std::byte> text);

/// Nothing if the value is no text.
std::optional<std::string> jsonText(const QJsonValue& value);

/// Whole numbers from 0; nothing if the value is no list of these, or has more than an array has axes.
std::optional<std::vector<std::uint64_t>> jsonCounts(const QJsonValue& value);

/// Finite numbers; nothing if the value is no list of these, or has more than an array has axes.
std::optional<std::vector<double>> jsonNumbers(const QJsonValue& value);

/// The most axes that an array may have, as NumPy's.
inline constexpr std::size_t mostZarrAxes = 32;

} // namespace tetra
