// SPDX-License-Identifier: GPL-3.0-or-later
// The Bucky Ball from end to end: refined, written, mapped, proved right at every level of the paper's Table 2 and
// coarser ones (R8, R13, R14, B3), in no more bytes than the format promises.
#include "core/base/checksum.h"
#include "core/history/model_writer.h"
#include "core/refine/lattice/lattice_refinement.h"
#include "tests/core/history/model_fixture.h"
#include "tests/lacks.h"

#include <tan/verify.h>

#include <QTemporaryDir>
#include <QTest>

using namespace tetra;

class BuckyModelTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        const std::filesystem::path source = TAN_SOURCE_DIR "/../shared/data/buckyball/bucky_32x32x32_uint8.raw";
        if (!std::filesystem::exists(source))
            QSKIP_WITHOUT("data");
        const auto bytes = std::make_shared<const std::vector<std::byte>>(readBytes(source));
        QCOMPARE(bytes->size(), std::size_t(32 * 32 * 32));
        dataset_.lattice.size = {32, 32, 32};
        dataset_.values = ScalarField(SampleType::UInt8, bytes->size(), {bytes, bytes->data()});
        dataset_.source = {"bucky", source, checksum(*bytes)};
        build();
    }

    void historyAndFileAreAsSmallAsPromised()
    {
        QVERIFY2(model_->tetrahedronCount() <= 425'000, qPrintable(QString::number(model_->tetrahedronCount())));
        const double bytes = static_cast<double>(model_->fileSize()) / static_cast<double>(model_->tetrahedronCount());
        QVERIFY2(bytes <= 21, qPrintable(QString::number(bytes)));
    }

    void everyLevelIsProved()
    {
        const auto verdict = verify(*model_, dataset_, {{100}, {50}, {4}, {3}, {2}, {1}, {0.5}, {0.2}, {0.1}, {0}});
        QVERIFY(verdict.ok());
        for (const std::string& failure : verdict->failures)
            qWarning("%s", failure.c_str());
        for (const LevelReport& level : verdict->levels)
            for (const std::string& failure : level.failures)
                qWarning("%g %%: %s", level.asked.error, failure.c_str());
        QVERIFY(verdict->ok());
        for (const LevelReport& level : verdict->levels)
            QVERIFY(level.measured.error.largest <= level.asked.error + 1e-9);
    }

private:
    void build()
    {
        const std::filesystem::path path = folder_.filePath("bucky.tan").toStdString();
        auto writer = ModelWriter::create(path, dataset_, {});
        QVERIFY(writer.ok());
        LatticeRefinementOptions options;
        options.size = dataset_.lattice.size;
        options.valueExtent = dataset_.values.range().extent();
        QVERIFY(refineLattice(options, LatticeSamples(dataset_.values.as<std::uint8_t>()), **writer).ok());
        const auto model = Model::open(path);
        QVERIFY(model.ok());
        model_ = model.value();
    }

    QTemporaryDir folder_;
    Dataset dataset_;
    std::shared_ptr<const Model> model_;
};

QTEST_GUILESS_MAIN(BuckyModelTest)
#include "bucky_model_test.moc"
