// SPDX-License-Identifier: GPL-3.0-or-later
// Presets that ParaView 5.11 writes look here as they do there, and ours look there as they do here: within a 255th at
// 256 values. What ParaView wrote and saw is in paraview_5_11.json, made by in_paraview.py; where pvpython is
// installed, it is asked anew.
#include "plugins/widgets/curves/whole_function.h"
#include "tests/core/transfer/import/looks.h"

#include <tan/transfer.h>

#include <QFile>
#include <QStandardPaths>
#include <QTest>

using namespace tetra;

namespace {

constexpr const char* folder = TAN_SOURCE_DIR "/tests/core/transfer/import/";

QJsonArray checkedInFacts()
{
    QFile file(folder + QString("paraview_5_11.json"));
    return file.open(QFile::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).array() : QJsonArray();
}

std::optional<QJsonArray> askParaview(const char* what, const QJsonArray& requests = {})
{
    const QString program = QStandardPaths::findExecutable("pvpython");
    if (program.isEmpty())
        return std::nullopt;
    return looksIn(program, {"--disable-registry", folder + QString("in_paraview.py"), what}, requests);
}

struct Fact {
    std::vector<double> values;
    QJsonArray looks;
    ImportedTransfer imported;
};

Fact factOf(const QJsonValue& json)
{
    Fact fact;
    fact.values = valuesOver(json["first"].toDouble(), json["last"].toDouble());
    fact.looks = json["looks"].toArray();
    auto imported = importTransferFunctions(json["file"].toString().toStdString(), {});
    if (!imported || imported->size() != 1)
        qFatal("A preset of ParaView's is refused.");
    fact.imported = imported->front();
    return fact;
}

} // namespace

class ParaviewTest : public QObject {
    Q_OBJECT

private slots:
    void presetsOfParaviewLookAsThere_data();
    void presetsOfParaviewLookAsThere();
    void theFactsAreParaviews();
    void functionsLookTheSameInParaview();
};

void ParaviewTest::presetsOfParaviewLookAsThere_data()
{
    QTest::addColumn<QJsonObject>("fact");
    for (const QJsonValue& fact : checkedInFacts())
        QTest::newRow(qPrintable(QString::fromStdString(factOf(fact).imported.name))) << fact.toObject();
}

void ParaviewTest::presetsOfParaviewLookAsThere()
{
    QFETCH(QJsonObject, fact);
    const Fact known = factOf(fact);
    QCOMPARE(known.looks[0].toArray()[3].isNull(), known.imported.coloursOnly);
    const double worst = worstDifference(known.imported.function, known.values, known.looks);
    QVERIFY2(worst <= withinByte, qPrintable(QString("%1 of 255").arg(255 * worst)));
}

void ParaviewTest::theFactsAreParaviews()
{
    const auto facts = askParaview("facts");
    if (!facts)
        QSKIP("skipped: no pvpython");
    const QJsonArray known = checkedInFacts();
    QCOMPARE(facts->size(), known.size());
    for (qsizetype i = 0; i < facts->size(); ++i) {
        const Fact now = factOf((*facts)[i]), before = factOf(known[i]);
        QCOMPARE(now.values, before.values);
        QVERIFY2(worstDifference(now.imported.function, now.values, now.looks) <= withinByte,
                 now.imported.name.c_str());
        QVERIFY2(worstDifference(now.imported.function, now.values, before.looks) <= withinByte,
                 now.imported.name.c_str());
    }
}

void ParaviewTest::functionsLookTheSameInParaview()
{
    std::mt19937 random(17);
    QJsonArray requests;
    std::vector<TransferFunction> functions;
    std::vector<std::vector<double>> values;
    for (int round = 0; round < 60; ++round) {
        TransferFunction function = randomFunctionInParaview(random);
        if (round % 3 == 0)
            function = withMask(function, {-2.5 + 0.01 * double(random() % 100), 0.01 * double(random() % 300) - 1.5});
        functions.push_back(function);
        values.push_back(
            valuesOver(transferPoints(function).front().value - 0.3, transferPoints(function).back().value + 0.301));
        requests.append(request(transferFunctionToParaview(function, "ours " + std::to_string(round)), values.back()));
    }
    const auto theirs = askParaview("looks", requests);
    if (!theirs)
        QSKIP("skipped: no pvpython");
    QVERIFY(!functions.empty());
    for (std::size_t round = 0; round < functions.size(); ++round) {
        const double worst = worstDifference(functions[round], values[round], (*theirs)[qsizetype(round)].toArray());
        QVERIFY2(worst <= withinByte, qPrintable(QString("round %1: %2 of 255").arg(round).arg(255 * worst)));
    }
}

QTEST_APPLESS_MAIN(ParaviewTest)
#include "paraview_test.moc"
