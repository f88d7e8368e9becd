// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/bench_report.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QTextStream>

#include <algorithm>
#include <chrono>
#include <cstdio>

#include <time.h>

namespace tetra {

double secondsOf(const std::function<void()>& work)
{
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double processSecondsOf(const std::function<void()>& work)
{
    const auto now = [] {
        timespec time{};
        ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
        return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
    };
    const double start = now();
    work();
    return now() - start;
}

double median(std::vector<double> values)
{
    std::ranges::sort(values);
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

void printReport(const QString& name, const std::vector<BenchCase>& cases, bool json)
{
    QTextStream out(stdout);
    QJsonArray array;
    for (const BenchCase& one : cases) {
        const double ratio = one.yardstickSeconds > 0 ? one.seconds / one.yardstickSeconds : 0;
        QJsonObject object = one.more;
        object["case"] = one.name;
        object["seconds"] = one.seconds;
        object["yardstick"] = one.yardstick;
        object["yardstick_seconds"] = one.yardstickSeconds;
        object["ratio"] = ratio;
        array.append(object);
        if (json)
            continue;
        out << one.name << ": " << one.seconds << " s";
        if (one.yardstickSeconds > 0)
            out << ", " << ratio << " of " << one.yardstick << " (" << one.yardstickSeconds << " s)";
        for (auto figure = one.more.begin(); figure != one.more.end(); ++figure)
            out << ", " << figure.key() << ' ' << figure.value().toVariant().toString();
        out << '\n';
    }
    if (json)
        out << QJsonDocument(QJsonObject{{"name", name}, {"cases", array}}).toJson();
}

} // namespace tetra
