// SPDX-License-Identifier: GPL-3.0-or-later
/// R1, B3: models of scattered points, from the table to the proof; and what is wrong with damaged ones is found.
#include "plugins/builders/refinement/refinement_builder.h"

#include "core/history/model_writer.h"
#include "plugins/readers/points/point_reader.h"
#include "tests/core/history/model_fixture.h"
#include "tests/lacks.h"
#include "tests/verdict_text.h"

#include <tan/verify.h>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <random>

using namespace tetra;
using format::SectionId;

using testing::textOf;

namespace {

const std::vector<Accuracy> levels = {{4}, {3}, {2}, {1}, {0.5}, {0.2}, {0.1}, {0}};

Dataset datasetOf(std::vector<Eigen::Vector3d> positions, std::vector<double> values)
{
    Dataset dataset;
    const auto kept = std::make_shared<const std::vector<double>>(std::move(values));
    dataset.domain = DomainClass::Scattered;
    dataset.lattice.size = {static_cast<std::uint32_t>(kept->size()), 1, 1};
    dataset.positions = std::make_shared<const std::vector<Eigen::Vector3d>>(std::move(positions));
    dataset.values =
        ScalarField(SampleType::Float64, kept->size(), {kept, reinterpret_cast<const std::byte*>(kept->data())});
    dataset.source = {"points", {}, contentHash(dataset.values, dataset.positions)};
    return dataset;
}

/// Random points, or those of a grid with the tenths that no double holds.
Dataset points(std::size_t count, bool onGrid, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> coordinate(-1, 1);
    std::vector<Eigen::Vector3d> positions;
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i) {
        positions.emplace_back(coordinate(random), coordinate(random), coordinate(random));
        if (onGrid)
            positions.back() = {0.1 * static_cast<double>(i % 7), 0.1 * static_cast<double>(i / 7 % 7),
                                0.1 * static_cast<double>(i / 49)};
        values.push_back(std::sin(4 * positions.back()[0]) * positions.back()[1] + positions.back()[2]);
    }
    return datasetOf(std::move(positions), std::move(values));
}

} // namespace

class ScatteredBuildTest : public QObject {
    Q_OBJECT

private:
    std::filesystem::path path() const { return folder_.filePath("model.tan").toStdString(); }

    std::shared_ptr<const Model> build(const Dataset& dataset, const std::string& weights = {})
    {
        ModelDescription description;
        description.builder = "refinement";
        description.parameters = {{"weights", weights}};
        auto writer = ModelWriter::create(path(), dataset, description);
        BuildTarget target{**writer};
        const auto report = RefinementBuilder().build(dataset, {{"weights", weights}}, target, {});
        if (!report)
            qWarning("%s", report.error().text().c_str());
        return report.ok() ? Model::open(path()).value() : nullptr;
    }

    QTemporaryDir folder_;

private slots:
    void everyLevelIsProved_data()
    {
        QTest::addColumn<std::size_t>("count");
        QTest::addColumn<bool>("onGrid");
        QTest::addColumn<QString>("weights");
        QTest::newRow("random") << std::size_t(500) << false << "";
        QTest::newRow("grid") << std::size_t(343) << true << "";
        QTest::newRow("weighted") << std::size_t(500) << false << "point:0.5,0.5,0.5,0.4,0.05;value:0.2,0.1";
        QTest::newRow("four") << std::size_t(4) << false << "";
        QTest::newRow("five") << std::size_t(5) << false << "";
        QTest::newRow("twelve") << std::size_t(12) << false << "";
    }
    void everyLevelIsProved()
    {
        QFETCH(std::size_t, count);
        QFETCH(bool, onGrid);
        QFETCH(QString, weights);
        const Dataset dataset = points(count, onGrid, 1);
        const auto model = build(dataset, weights.toStdString());
        QVERIFY(model != nullptr);
        const auto verdict = verify(*model, dataset, levels);
        QVERIFY2(verdict.ok() && verdict->ok(), qPrintable(textOf(verdict)));
    }

    void realPointsAreProved_data()
    {
        QTest::addColumn<QString>("file");
        for (const char* file : {"forge_probes.csv", "fiji_quakes.csv", "disk_out_ref_points.csv"})
            QTest::newRow(file) << file;
    }
    void realPointsAreProved()
    {
        QFETCH(QString, file);
        const QString table = TAN_SOURCE_DIR "/../shared/data/scattered/" + file;
        if (!QFile::exists(table))
            QSKIP_WITHOUT("data");
        const auto dataset = PointReader().read(table.toStdString(), {}, {});
        const auto model = build(*dataset);
        QVERIFY(model != nullptr);
        const auto verdict = verify(*model, *dataset, levels);
        QVERIFY2(verdict.ok() && verdict->ok(), qPrintable(textOf(verdict)));
        QVERIFY(verdict->levels.back().measured.error.largest < 1e-9);
    }

    void damageIsFound_data()
    {
        QTest::addColumn<QString>("damage");
        QTest::addColumn<QString>("finding");
        QTest::newRow("swapped corners") << "swap"
                                         << "inverted";
        QTest::newRow("a corner twice") << "twice"
                                        << "flat";
        QTest::newRow("another corner") << "corner"
                                        << "belongs to one cell only";
        QTest::newRow("a cell lost") << "lost"
                                     << "belongs to one cell only";
        QTest::newRow("smaller claim") << "claim"
                                       << "more than the claimed";
        QTest::newRow("smaller own error") << "own"
                                           << "larger than the own error";
    }
    void damageIsFound()
    {
        QFETCH(QString, damage);
        QFETCH(QString, finding);
        const Dataset dataset = points(300, false, 2);
        QVERIFY(build(dataset) != nullptr);
        FileParts parts(readBytes(path()));
        const auto destroyers = parts.elements<std::uint32_t>(SectionId::Destroyers);
        const auto last = std::size_t(std::find(destroyers.rbegin(), destroyers.rend(), Model::never).base() -
                                      destroyers.begin() - 1);
        auto& others = parts.elements<std::array<std::uint32_t, 3>>(SectionId::OtherSites)[last];
        if (damage == "swap")
            std::swap(others[0], others[1]);
        if (damage == "twice")
            others[0] = others[1];
        if (damage == "corner")
            others[0] = others[0] == 0 ? 1 : others[0] - 1;
        if (damage == "lost")
            destroyers[last] = static_cast<std::uint32_t>(parts.header().siteCount) - 1;
        if (damage == "claim")
            for (float& error : parts.elements<float>(SectionId::SiteRunningKeys))
                if (std::isfinite(error))
                    error *= 0.9f;
        if (damage == "own")
            for (std::uint16_t& error : parts.elements<std::uint16_t>(SectionId::OwnErrors))
                error = 0;
        parts.repairChecksums();
        writeBytes(path(), parts.content);
        const auto model = Model::open(path());
        QVERIFY(model.ok());
        const auto verdict = verify(**model, dataset, {{20}, {5}, {0}});
        QVERIFY(!verdict.ok() || !verdict->ok());
        QVERIFY2(textOf(verdict).contains(finding), qPrintable(textOf(verdict)));
    }

    void anotherDatasetIsNamed()
    {
        const auto model = build(points(60, false, 1));
        const QString text = textOf(verify(*model, points(61, false, 1), {{0}}));
        QVERIFY2(text.contains("another dataset: 60 scattered points of type double"), qPrintable(text));
        QVERIFY2(text.contains("has 61 scattered points of type double."), qPrintable(text));
    }

    void otherPositionsAreFound()
    {
        const Dataset dataset = points(100, false, 3);
        const auto model = build(dataset);
        std::vector<Eigen::Vector3d> moved = *dataset.positions;
        moved[17][1] = std::nextafter(moved[17][1], 2);
        std::vector<double> values;
        for (std::uint64_t i = 0; i < 100; ++i)
            values.push_back(dataset.values.at(i));
        const auto verdict = verify(*model, datasetOf(std::move(moved), std::move(values)), {{0}});
        QVERIFY(verdict.ok() && !verdict->ok());
        QVERIFY2(textOf(verdict).contains("other samples or positions"), qPrintable(textOf(verdict)));
    }
};

QTEST_GUILESS_MAIN(ScatteredBuildTest)
#include "scattered_build_test.moc"
