// SPDX-License-Identifier: GPL-3.0-or-later
/// tan-bench-plots FOLDER: draws the charts that standard input describes into FOLDER/NAME.svg, by the code of
/// `tan reproduce`. The description is a JSON object from names to charts; plots.py says what they have.
#include "app/reproduction/chart.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTextStream>

namespace tetra {
namespace {

ChartTexts textsOf(const QJsonObject& chart)
{
    const auto textOf = [&chart](const char* name) { return chart[name].toString().toStdString(); };
    return {
        .title = textOf("title"), .note = textOf("note"), .unit = textOf("unit"), .description = textOf("description")};
}

ChartInk chartInk(const QJsonValue& value)
{
    return seriesInk(std::size_t(value["ink"].toInt()));
}

Drawing barsOf(const QJsonObject& described)
{
    BarChart chart{
        .texts = textsOf(described), .legend = {}, .rows = {}, .isLogarithmic = described["logarithmic"].toBool()};
    for (const QJsonValue name : described["legend"].toArray())
        chart.legend.emplace_back(name["name"].toString().toStdString(), chartInk(name));
    for (const QJsonValue value : described["rows"].toArray()) {
        BarRow row{.label = value["label"].toString().toStdString(), .bars = {}, .limit = {}};
        for (const QJsonValue bar : value["bars"].toArray())
            row.bars.push_back(bar.isNull() ? std::nullopt
                                            : std::optional(Bar{bar["value"].toDouble(),
                                                                bar["text"].toString().toStdString(), chartInk(bar)}));
        if (const QJsonValue limit = value["limit"]; limit.isObject())
            row.limit =
                BarLimit{limit["value"].toDouble(), limit["text"].toString().toStdString(), limit["missed"].toBool()};
        chart.rows.push_back(std::move(row));
    }
    return drawChart(chart);
}

Drawing linesOf(const QJsonObject& described)
{
    LineChart chart{.texts = textsOf(described), .across = described["across"].toString().toStdString(), .series = {}};
    for (const QJsonValue value : described["series"].toArray()) {
        LineSeries series{.name = value["name"].toString().toStdString(),
                          .ink = chartInk(value),
                          .points = {},
                          .style = LineSeries::Style::MarkedLine};
        for (const QJsonValue point : value["points"].toArray())
            series.points.emplace_back(point[0].toDouble(), point[1].toDouble());
        chart.series.push_back(std::move(series));
    }
    return drawChart(chart);
}

bool drawAll(const QJsonObject& charts, const QString& folder)
{
    for (auto chart = charts.begin(); chart != charts.end(); ++chart) {
        const QJsonObject described = chart.value().toObject();
        const std::string svg = (described.contains("rows") ? barsOf(described) : linesOf(described)).svg();
        QFile file(folder + '/' + chart.key() + ".svg");
        if (!file.open(QIODevice::WriteOnly) ||
            file.write(svg.data(), qsizetype(svg.size())) != qsizetype(svg.size())) {
            QTextStream(stderr) << "cannot write " << file.fileName() << ": " << file.errorString() << Qt::endl;
            return false;
        }
    }
    return true;
}

} // namespace
} // namespace tetra

int main(int argc, char** argv)
{
    QFile input;
    const QJsonDocument charts =
        input.open(stdin, QIODevice::ReadOnly) ? QJsonDocument::fromJson(input.readAll()) : QJsonDocument();
    if (argc != 2 || !charts.isObject()) {
        QTextStream(stderr) << "usage: tan-bench-plots FOLDER, with charts as JSON on standard input" << Qt::endl;
        return 2;
    }
    return tetra::drawAll(charts.object(), QString::fromLocal8Bit(argv[1])) ? 0 : 4;
}
