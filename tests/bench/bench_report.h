// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>
#include <QString>

#include <functional>
#include <vector>

namespace tetra {

/// One measurement beside its yardstick, both from the same run of the program: machines are noisy, ratios are not.
struct BenchCase {
    QString name;
    double seconds = 0;
    QString yardstick; ///< what it is compared with
    double yardstickSeconds = 0;
    QJsonObject more; ///< further figures, by name
};

/// Seconds that `work` takes.
double secondsOf(const std::function<void()>& work);
/// Seconds that `work` has a core, on all threads together.
double processSecondsOf(const std::function<void()>& work);
/// The middle one, or the mean of the two middle ones.
double median(std::vector<double> values);

/// Prints the cases to stdout: one JSON object if `json` (docs/command-line), else a table.
void printReport(const QString& name, const std::vector<BenchCase>& cases, bool json);

} // namespace tetra
