// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/zarr/helper/zarr_json.h"

#include <QJsonArray>
#include <QJsonDocument>

#include <cmath>
#include <string_view>

namespace tetra {
namespace {

/// The text with "NaN" for NaN and the like, where they stand outside of texts.
std::string withoutOddNumbers(std::string_view text)
{
    constexpr std::string_view oddNumbers[] = {"NaN", "-Infinity", "Infinity"};
    std::string result;
    result.reserve(text.size());
    bool isInText = false;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const char letter = text[at];
        if (isInText && letter == '\\' && at + 1 < text.size()) {
            result += letter;
            result += text[++at];
            continue;
        }
        if (letter == '"')
            isInText = !isInText;
        std::string_view found;
        for (const std::string_view odd : oddNumbers)
            if (!isInText && found.empty() && text.substr(at, odd.size()) == odd)
                found = odd;
        if (found.empty()) {
            result += letter;
        } else {
            result += '"' + std::string(found) + '"';
            at += found.size() - 1;
        }
    }
    return result;
}

} // namespace

Result<QJsonObject> parseJsonObject(std::span<const std::byte> text)
{
    const std::string clean =
        withoutOddNumbers(std::string_view(reinterpret_cast<const char*>(text.data()), text.size()));
    QJsonParseError problem;
    const QJsonDocument document =
        QJsonDocument::fromJson(QByteArray(clean.data(), static_cast<qsizetype>(clean.size())), &problem);
    if (problem.error != QJsonParseError::NoError)
        return Error{ErrorKind::BadInput, Message::say("is not JSON: %1 at byte %2. Copy or export it again.",
                                                       problem.errorString().toStdString(), problem.offset)};
    if (!document.isObject())
        return Error{ErrorKind::BadInput, Message::say("holds no JSON object. Copy or export it again.")};
    return document.object();
}

std::optional<std::string> jsonText(const QJsonValue& value)
{
    return value.isString() ? std::optional(value.toString().toStdString()) : std::nullopt;
}

std::optional<std::vector<std::uint64_t>> jsonCounts(const QJsonValue& value)
{
    const QJsonArray list = value.toArray();
    if (!value.isArray() || list.size() > static_cast<qsizetype>(mostZarrAxes))
        return std::nullopt;
    std::vector<std::uint64_t> counts;
    for (const QJsonValue entry : list) {
        const qint64 count = entry.toInteger(-1);
        if (count < 0)
            return std::nullopt;
        counts.push_back(static_cast<std::uint64_t>(count));
    }
    return counts;
}

std::optional<std::vector<double>> jsonNumbers(const QJsonValue& value)
{
    const QJsonArray list = value.toArray();
    if (!value.isArray() || list.size() > static_cast<qsizetype>(mostZarrAxes))
        return std::nullopt;
    std::vector<double> numbers;
    for (const QJsonValue entry : list) {
        const double number = entry.toDouble(std::nan(""));
        if (!std::isfinite(number))
            return std::nullopt;
        numbers.push_back(number);
    }
    return numbers;
}

} // namespace tetra
