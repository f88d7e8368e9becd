// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/transfer.h>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace tetra {

/// What presets look like elsewhere: a list of [red, green, blue, opacity], null for an opacity that a preset has not.

inline constexpr int sampleCount = 256;
inline constexpr double withinByte = 1.0 / 255;

inline std::vector<double> valuesOver(double first, double last)
{
    std::vector<double> values;
    for (int sample = 0; sample < sampleCount; ++sample)
        values.push_back(std::lerp(first, last, sample / (sampleCount - 1.0)));
    return values;
}

inline QJsonObject request(const std::string& file, const std::vector<double>& values)
{
    QJsonArray list;
    for (const double value : values)
        list.append(value);
    return {{"file", QString::fromStdString(file)}, {"values", list}};
}

/// What a program answers to the requests; nothing if it is not there, or what it needs is not (it ends with 77 then).
inline std::optional<QJsonArray> looksIn(const QString& program, const QStringList& arguments,
                                         const QJsonArray& requests)
{
    QProcess process;
    process.start(program, arguments);
    if (!process.waitForStarted())
        return std::nullopt;
    process.write(QJsonDocument(requests).toJson());
    process.closeWriteChannel();
    if (!process.waitForFinished(300'000) || process.exitCode() == 77)
        return std::nullopt;
    if (process.exitCode() != 0)
        qWarning() << process.readAllStandardError();
    return QJsonDocument::fromJson(process.readAllStandardOutput()).array();
}

inline double worstDifference(const TransferFunction& function, const std::vector<double>& values,
                              const QJsonArray& looks)
{
    double worst = looks.size() == sampleCount ? 0 : 1;
    for (std::size_t sample = 0; sample < values.size(); ++sample) {
        const TransferSample ours = evaluate(function, values[sample]);
        // What a mask hides has a colour there that nobody sees.
        const auto colour = evaluateUnmasked(function, values[sample]).colour;
        const QJsonArray theirs = looks[qsizetype(sample)].toArray();
        for (qsizetype channel = 0; channel < 3; ++channel)
            worst = std::max(worst, std::abs(colour[std::size_t(channel)] - theirs[channel].toDouble(9)));
        if (!theirs[3].isNull())
            worst = std::max(worst,
                             std::abs(-std::expm1(-ours.extinction * function.unitDistance) - theirs[3].toDouble(9)));
    }
    return worst;
}

/// Two to seven points of each curve from -3 upwards, some of them steps.
inline TransferFunction randomFunctionInParaview(std::mt19937& random)
{
    std::uniform_real_distribution<float> unit(0, 1);
    TransferFunction function;
    function.unitDistance = 0.5 + unit(random);
    const auto fill = [&](auto& points, const auto& pointAt) {
        double value = -3;
        for (std::size_t point = 2 + random() % 6; point > 0; --point) {
            points.push_back(pointAt(value));
            if (random() % 4 != 0 || points.size() < 2 || points[points.size() - 2].value == value)
                value += 0.1 + double(unit(random));
        }
    };
    fill(function.colours, [&](double value) {
        return ColourPoint{value, {unit(random), unit(random), unit(random)}};
    });
    fill(function.opacities, [&](double value) { return OpacityPoint{value, unit(random)}; });
    return function;
}

} // namespace tetra
