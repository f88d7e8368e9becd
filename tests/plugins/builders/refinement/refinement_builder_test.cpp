// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/builders/refinement/refinement_builder.h"

#include "core/base/checksum.h"
#include "core/history/model_writer.h"
#include "plugins/host/plugin_host.h"
#include "plugins/samples/samples.h"

#include <tan/verify.h>

#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <memory>
#include <random>

using namespace tetra;

namespace {

/// A field of random values of one type on any lattice.
template <class T> Dataset randomDataset(const Lattice& lattice, SampleType type, double from, double to, unsigned seed)
{
    const auto values = std::make_shared<std::vector<T>>(lattice.pointCount());
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> value(from, to);
    std::ranges::generate(*values, [&] { return static_cast<T>(value(random)); });
    const std::shared_ptr<const std::byte> bytes(values, reinterpret_cast<const std::byte*>(values->data()));
    const ScalarField field(type, lattice.pointCount(), bytes);
    return {.lattice = lattice, .values = field, .source = {"random", {}, checksum(field.bytes())}};
}

} // namespace

/// R8, R12 and B3: what the builder makes is a model that the independent checker proves.
class RefinementBuilderTest : public QObject {
    Q_OBJECT

private slots:
    void isFoundAndLoadedByTheHost()
    {
        PluginHost host({.folders = {TAN_BINARY_DIR "/lib/tan/plugins"}});
        const auto builders = host.builders();
        QVERIFY(std::ranges::any_of(builders, [](const auto& provided) { return provided.id == "refinement"; }));
    }

    void saysWhyItRefuses()
    {
        const RefinementBuilder builder;
        const Dataset small =
            randomDataset<std::uint8_t>({{4, 5, 6}, {1, 1, 1}, {0, 0, 0}}, SampleType::UInt8, 0, 9, 1);
        QVERIFY(builder.accepts(small).score > 0.5);
        Dataset large = small;
        large.lattice.size = {4000, 4000, 4000};
        const Acceptance refused = builder.accepts(large);
        QCOMPARE(refused.score, 0.0);
        QVERIFY(QString::fromStdString(refused.reason.text()).contains("4000 x 4000 x 4000"));
    }

    void everyLevelIsProved_data()
    {
        QTest::addColumn<QString>("type");
        QTest::addColumn<double>("spacingZ");
        QTest::addColumn<double>("stop");
        QTest::newRow("bytes") << "uint8" << 1.0 << 0.0;
        QTest::newRow("signed shorts, stretched cells") << "int16" << 2.5 << 0.0;
        QTest::newRow("floats, flat cells, stopped at 5 %") << "float" << 0.3 << 5.0;
        QTest::newRow("doubles") << "double" << 1.0 << 0.0;
        QTest::newRow("large integers") << "int32" << 1.0 << 1.0;
    }
    void everyLevelIsProved()
    {
        QFETCH(QString, type);
        QFETCH(double, spacingZ);
        QFETCH(double, stop);
        const Lattice lattice{{9, 11, 8}, {1, 1, spacingZ}, {-3, 4, 5}};
        const Dataset dataset =
            type == "uint8"    ? randomDataset<std::uint8_t>(lattice, SampleType::UInt8, 0, 256, 2)
            : type == "int16"  ? randomDataset<std::int16_t>(lattice, SampleType::Int16, -3000, 30000, 3)
            : type == "float"  ? randomDataset<float>(lattice, SampleType::Float32, -1e-3, 1e-3, 4)
            : type == "double" ? randomDataset<double>(lattice, SampleType::Float64, 1e9, 1e9 + 1, 5)
                               : randomDataset<std::int32_t>(lattice, SampleType::Int32, -2e9, 2e9, 6);
        const QTemporaryDir folder;
        const std::filesystem::path path = folder.filePath("model.tan").toStdString();
        ModelDescription description;
        description.builder = "refinement";
        auto writer = ModelWriter::create(path, dataset, description);
        QVERIFY(writer.ok());
        BuildTarget target{**writer};
        const Result<BuildReport> report = RefinementBuilder().build(dataset, {{"error", stop}}, target, {});
        QVERIFY2(report.ok(), report.ok() ? "" : report.error().text().c_str());
        QCOMPARE(report->inverted, std::uint64_t(0));
        const auto model = Model::open(path);
        QVERIFY(model.ok());
        QCOMPARE(std::uint64_t((*model)->siteCount()), report->sites);
        QVERIFY((*model)->tetrahedronCount() <= report->tetrahedra);
        QVERIFY((*model)->finalKey() <= stop / 100 * dataset.values.range().extent());
        std::vector<Accuracy> levels;
        for (const double percent : {50.0, 20.0, 10.0, 5.0})
            levels.push_back({percent});
        if (stop == 0)
            levels.push_back({0});
        const Result<VerificationReport> verdict = verify(**model, dataset, levels);
        QVERIFY(verdict.ok());
        for (const std::string& failure : verdict->failures)
            qWarning("%s", failure.c_str());
        for (const LevelReport& level : verdict->levels)
            for (const std::string& failure : level.failures)
                qWarning("%s", failure.c_str());
        QVERIFY(verdict->ok());
    }

    void cancellingLeavesNoFile()
    {
        const QTemporaryDir folder;
        const std::filesystem::path path = folder.filePath("model.tan").toStdString();
        const Dataset dataset = makeSample({"noise", 40, {}, 1}).value();
        std::stop_source stop;
        {
            auto writer = ModelWriter::create(path, dataset, {});
            QVERIFY(writer.ok());
            const Progress progress(stop.get_token(), [&](double fraction, const Message&) {
                if (fraction > 0.1)
                    stop.request_stop();
            });
            BuildTarget target{**writer};
            const Result<BuildReport> report = RefinementBuilder().build(dataset, {}, target, progress);
            QVERIFY(!report.ok());
            QCOMPARE(report.error().kind, ErrorKind::Cancelled);
        }
        QVERIFY(std::filesystem::is_empty(folder.path().toStdString()));
    }
};

QTEST_GUILESS_MAIN(RefinementBuilderTest)
#include "refinement_builder_test.moc"
