// SPDX-License-Identifier: GPL-3.0-or-later
// A model keeps all samples of a lattice where they are cheap (FORMAT.md, section 23), however it was stopped.
#include "core/history/model_writer.h"
#include "tests/core/history/model_fixture.h"

#include <tan/verify.h>

#include <QTemporaryDir>
#include <QTest>

using namespace tetra;

class SampleSectionTest : public QObject {
    Q_OBJECT

private slots:
    /// FORMAT.md: only where they take at most an eighth of the rest.
    void samplesAreKeptWhereTheyAreCheap()
    {
        const Dataset dataset = bumps(SampleType::Float64, {7, 6, 8});
        const RecordedSteps& history = historyOf(dataset);
        QVERIFY(!history.steps.empty());
        for (std::uint32_t sites = 9; sites < history.steps.size(); sites += 7) {
            auto writer = ModelWriter::create(path(), dataset, {});
            for (std::uint32_t site = 0; site < sites; ++site) {
                const RecordedSteps::Step& step = history.steps[site];
                QVERIFY((*writer)->add({step.point, step.keyBefore, step.star, step.destroyed}).ok());
            }
            QVERIFY((*writer)->finishEarly().ok());
            const auto model = Model::open(path());
            QVERIFY(model.ok());
            const std::uint64_t rest = (*model)->siteCount() * (21 + 8ull) + (*model)->tetrahedronCount() * 18;
            QCOMPARE((*model)->samples().empty(), dataset.pointCount() * 8 > rest / 8);
            const auto verdict = verify(**model, dataset, {});
            QVERIFY2(verdict->ok(), verdict->ok() ? "" : verdict->failures[0].c_str());
        }
    }

private:
    std::filesystem::path path() const { return folder_.filePath("model.tan").toStdString(); }

    QTemporaryDir folder_;
};

QTEST_GUILESS_MAIN(SampleSectionTest)
#include "sample_section_test.moc"
