// SPDX-License-Identifier: GPL-3.0-or-later
// The judge of irregular models (B3, R4, R5, S12): what decimation makes is proved, and each kind of lie is found.
#include "core/model/verification.h"
#include "tests/core/model/irregular/irregular_models.h"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <functional>

using namespace tetra;

namespace {

const std::vector<Accuracy> levels = {{100, anyWarping}, {30, 30}, {10, 10}, {3, 3}, {1, 1}, {0, 0}};

QString textOf(const Result<Verdict>& verdict)
{
    if (!verdict)
        return "Error: " + QString::fromStdString(verdict.error().text);
    QStringList texts;
    for (const std::string& text : verdict->failures)
        texts << QString::fromStdString(text);
    for (const LevelVerdict& level : verdict->levels)
        for (const std::string& text : level.failures)
            texts << QString("%1 %: %2").arg(level.asked.error).arg(QString::fromStdString(text));
    return texts.join('\n');
}

using Lie = std::function<void(RecordedHistory&, Dataset&)>;

} // namespace
Q_DECLARE_METATYPE(Lie)

class IrregularVerificationTest : public QObject {
    Q_OBJECT

private slots:
    void decimatedModelsAreProved()
    {
        int coarser = 0;
        for (std::uint32_t seed = 0; seed < 40; ++seed) {
            const Dataset dataset = randomIrregular(seed);
            const auto model = modelOf(path(), dataset, decimated(dataset));
            const auto verdict = verify(*model, dataset, levels);
            QVERIFY2(verdict.ok() && verdict->ok(), qPrintable(QString("seed %1\n").arg(seed) + textOf(verdict)));
            for (const LevelVerdict& level : verdict->levels) {
                QVERIFY(level.conforming && level.covers && level.inverted == 0);
                QVERIFY(level.twoSidedWarping && *level.twoSidedWarping <= level.twoSidedBound);
                QVERIFY(*level.twoSidedWarping >= level.largestWarping);
                coarser += level.largestWarping > 0 ? 1 : 0;
            }
            const LevelVerdict& finest = verdict->levels.back();
            QCOMPARE(finest.largestError, 0.0);
            QCOMPARE(finest.largestWarping, 0.0);
            QCOMPARE(finest.twoSidedBound, 0.0);
        }
        QVERIFY(coarser > 40);
    }

private:
    std::filesystem::path path() const { return folder_.filePath("model.tan").toStdString(); }

    QTemporaryDir folder_;
};

QTEST_GUILESS_MAIN(IrregularVerificationTest)
#include "irregular_verification_test.moc"
