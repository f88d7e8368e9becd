// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/builders/decimation/decimation_builder.h"

#include "core/build/decimation_build.h"
#include "core/decimate/lattice_tetrahedra.h"
#include "tests/core/refine/recorded_history.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

using namespace tetra;

namespace {

Dataset latticeData(const std::array<std::uint32_t, 3>& size)
{
    Dataset dataset;
    dataset.lattice.size = size;
    const auto values = std::make_shared<std::vector<float>>();
    for (std::uint64_t point = 0; point < dataset.lattice.pointCount(); ++point) {
        const auto at = dataset.lattice.coordinates(point);
        values->push_back(static_cast<float>(std::sin(0.7 * at[0]) * at[1] + std::cos(0.9 * at[2])));
    }
    const std::shared_ptr<const std::byte> bytes(values, reinterpret_cast<const std::byte*>(values->data()));
    dataset.values = ScalarField(SampleType::Float32, values->size(), bytes);
    return dataset;
}

/// The same values on a quarter of a pipe.
Dataset gridData(const std::array<std::uint32_t, 3>& size)
{
    Dataset dataset = latticeData(size);
    dataset.domain = DomainClass::Curvilinear;
    const auto positions = std::make_shared<std::vector<Eigen::Vector3d>>();
    for (std::uint64_t point = 0; point < dataset.lattice.pointCount(); ++point) {
        const auto at = dataset.lattice.coordinates(point);
        const double angle = 1.5 * at[0] / size[0], radius = 2 + 0.4 * at[1];
        positions->emplace_back(radius * std::sin(angle), radius * std::cos(angle), at[2]);
    }
    dataset.positions = positions;
    return dataset;
}

/// The pipe as an irregular mesh.
Dataset irregularData(const std::array<std::uint32_t, 3>& size)
{
    Dataset dataset = gridData(size);
    dataset.tetrahedra =
        std::make_shared<const std::vector<std::array<std::uint32_t, 4>>>(latticeTetrahedra(size, LatticeCut::Five));
    dataset.domain = DomainClass::Irregular;
    dataset.lattice = {};
    dataset.lattice.size = {static_cast<std::uint32_t>(dataset.pointCount()), 1, 1};
    return dataset;
}

Dataset dataOf(const QString& kind)
{
    constexpr std::array<std::uint32_t, 3> size{7, 6, 5};
    return kind == "lattice" ? latticeData(size) : kind == "grid" ? gridData(size) : irregularData(size);
}

Result<BuildReport> build(const Dataset& dataset, const ParameterValues& values, RecordedHistory& history,
                          const Progress& progress = {})
{
    BuildTarget target{.history = history};
    return DecimationBuilder().build(dataset, values, target, progress);
}

} // namespace

/// R11, R12: what the builder takes, what its parameters mean, and what it says beforehand.
class DecimationBuilderTest : public QObject {
    Q_OBJECT

private slots:
    void acceptsWhatHasCells()
    {
        const DecimationBuilder builder;
        QCOMPARE(builder.accepts(dataOf("irregular")).score, 1.0);
        const Acceptance lattice = builder.accepts(dataOf("lattice"));
        QVERIFY(lattice.score > 0 && lattice.score < 1);
        QVERIFY2(lattice.reason.text().find("memory") != std::string::npos, lattice.reason.text().c_str());
        QCOMPARE(builder.accepts(dataOf("grid")).score, 1.0); // whose cells are a mesh
        Dataset folded = dataOf("grid");
        auto positions = std::make_shared<std::vector<Eigen::Vector3d>>(*folded.positions);
        std::swap((*positions)[60], (*positions)[61]);
        folded.positions = positions;
        QVERIFY(builder.accepts(folded).score > 0 && builder.accepts(folded).score < 0.9);
        Dataset points = dataOf("irregular");
        points.domain = DomainClass::Scattered;
        points.tetrahedra = nullptr;
        QVERIFY(builder.accepts(points).score > 0 && builder.accepts(points).score < 1); // C6
        RecordedHistory history;
        QVERIFY(!build(points, {}, history)); // as a mesh only, which taken() makes
        const auto mesh = builder.taken(points, {}, {});
        QVERIFY(mesh.ok() && build(*mesh, {}, history).ok());
        const Acceptance flat = builder.accepts(latticeData({4, 1, 4}));
        QCOMPARE(flat.score, 0.0);
        QVERIFY(flat.reason.text().find("cell") != std::string::npos);
    }

    void memoryIsSaidAndRefusedBeforehand()
    {
        const DecimationSize size = decimationSize(dataOf("lattice"));
        QCOMPARE(size.points, std::uint64_t(7 * 6 * 5));
        QCOMPARE(size.tetrahedra, std::uint64_t(5 * 6 * 5 * 4));
        QCOMPARE(decimationSize(dataOf("irregular")).tetrahedra, size.tetrahedra);
        const std::uint64_t need = decimationNeed(size);
        QVERIFY(need > 24 * size.points + 16 * size.tetrahedra);
        QVERIFY(checkDecimationNeed(size, 0).ok());
        QVERIFY(checkDecimationNeed(size, need).ok());
        const Status refused = checkDecimationNeed(size, need - 1);
        QVERIFY(!refused);
        QVERIFY(refused.error().kind == ErrorKind::OutOfResource);
        QVERIFY(refused.error().text().find("memory") != std::string::npos);
        QVERIFY(!checkDecimationNeed({5'000'000'000, 1}, std::numeric_limits<std::uint64_t>::max()));
    }

    /// With 0, 0 down to the coarsest mesh; the whole mesh is always the end.
    void keepsThePointsAndGoesToTheEnd_data()
    {
        QTest::addColumn<QString>("kind");
        for (const char* kind : {"lattice", "grid", "irregular"})
            QTest::newRow(kind) << kind;
    }
    void keepsThePointsAndGoesToTheEnd()
    {
        QFETCH(QString, kind);
        const Dataset dataset = dataOf(kind);
        RecordedHistory history;
        const auto report = build(dataset, {}, history);
        QVERIFY2(report.ok(), report ? "" : report.error().text().c_str());
        QCOMPARE(report->sites, dataset.pointCount());
        QCOMPARE(history.points.size(), dataset.pointCount());
        QCOMPARE(report->tetrahedra, history.tetrahedra.size());
        QCOMPARE(report->inverted, 0u);
        QCOMPARE(report->degenerate, 0u);
        QVERIFY(!history.traits.delaunay);
        QCOMPARE(history.finalKey, 0.0f);
        const auto alive = std::ranges::count_if(
            history.tetrahedra, [&](const auto& t) { return history.alive(t, history.points.size()); });
        QCOMPARE(std::uint64_t(alive), decimationSize(dataset).tetrahedra);
        if (kind != "irregular")
            QVERIFY(std::ranges::count(history.runningKeys, std::numeric_limits<float>::infinity()) < 20);
    }

    /// R12, C8: one threshold alone means the same in every builder (curvilinear_build_test.cpp).
    void thresholdsSayWhereToStopAndWhatCounts_data()
    {
        QTest::addColumn<QString>("kind");
        QTest::addColumn<double>("error");
        QTest::addColumn<double>("warping");
        QTest::addColumn<double>("ratio"); // what one % of the diagonal is worth in % of the value range
        QTest::addColumn<double>("stop");  // in % of the value range
        for (const QString kind : {"grid", "irregular"}) {
            QTest::addRow("%s, both", qPrintable(kind)) << kind << 4.0 << 4.0 << 1.0 << 4.0;
            QTest::addRow("%s, shape counts more", qPrintable(kind)) << kind << 8.0 << 2.0 << 4.0 << 8.0;
            QTest::addRow("%s, error alone", qPrintable(kind)) << kind << 6.0 << 0.0 << 1.0 << 6.0;
            QTest::addRow("%s, warping alone", qPrintable(kind)) << kind << 0.0 << 6.0 << 1.0 << 6.0;
        }
        QTest::addRow("lattice") << QString("lattice") << 5.0 << 0.0 << 0.0 << 5.0;
    }
    void thresholdsSayWhereToStopAndWhatCounts()
    {
        QFETCH(QString, kind);
        QFETCH(double, error);
        QFETCH(double, warping);
        QFETCH(double, ratio);
        QFETCH(double, stop);
        const Dataset dataset = dataOf(kind);
        RecordedHistory whole, history;
        QVERIFY(build(dataset, {}, whole).ok());
        QVERIFY(build(dataset, {{"error", error}, {"warping", warping}}, history).ok());
        const double percent = dataset.values.range().extent() / 100;
        const double expected = ratio * percent / (dataset.bounds().diagonal().norm() / 100);
        QVERIFY(std::abs(history.traits.warpingWeight - expected) <= 1e-9 * expected);
        const auto initial = [](const RecordedHistory& h) {
            return std::size_t(std::ranges::count(h.runningKeys, std::numeric_limits<float>::infinity()));
        };
        QVERIFY(initial(history) > initial(whole));
        QVERIFY(initial(history) < history.points.size());
        QVERIFY(history.runningKeys[initial(history)] <= stop * percent * 1.000001);
    }

    /// Meshes finer than that are left out, and no others.
    void finestErrorLeavesOutWhatIsFiner_data()
    {
        QTest::addColumn<QString>("kind");
        for (const QString kind : {"lattice", "grid", "irregular"})
            QTest::addRow("%s", qPrintable(kind)) << kind;
    }
    void finestErrorLeavesOutWhatIsFiner()
    {
        QFETCH(QString, kind);
        const Dataset dataset = dataOf(kind);
        RecordedHistory whole, history;
        QVERIFY(build(dataset, {}, whole).ok());
        const auto report = build(dataset, {{"finest", 4.0}}, history);
        QVERIFY(report.ok());
        QCOMPARE(std::size_t(report->sites), history.points.size());
        QVERIFY(history.points.size() < whole.points.size());
        QVERIFY(std::equal(history.points.begin(), history.points.end(), whole.points.begin()));
        const double key = dataset.values.range().extent() * 0.04;
        QVERIFY(history.runningKeys.back() > key); // one mesh before
        QCOMPARE(history.finalKey, whole.runningKeys[history.points.size()]);
        QVERIFY(history.finalKey <= key);

        RecordedHistory none;
        const auto refused = build(dataset, {{"finest", 4.0}, {"error", 3.0}}, none);
        QVERIFY(!refused.ok() && refused.error().kind == ErrorKind::WrongUsage);
        QVERIFY2(refused.error().text().starts_with("The finest error (4 %) is larger than"),
                 refused.error().text().c_str());
        QVERIFY(build(dataset, {{"finest", 3.0}, {"error", 3.0}}, none).ok());
    }

    /// S5, S6: a grid with a fold and a collapsed line is decimated in computational space; what is turned over is
    /// said of the finest mesh that the model holds.
    void countsWhatIsTurnedOver_data()
    {
        QTest::addColumn<double>("finest");
        QTest::addRow("whole") << 0.0;
        QTest::addRow("next to the whole") << 1e-12;
        QTest::addRow("cut") << 1.0;
    }
    void countsWhatIsTurnedOver()
    {
        QFETCH(double, finest);
        Dataset dataset = dataOf("grid");
        auto positions = std::make_shared<std::vector<Eigen::Vector3d>>();
        for (std::uint64_t point = 0; point < dataset.pointCount(); ++point) {
            const auto at = dataset.lattice.coordinates(point);
            positions->emplace_back(at[0], at[1] + at[0] / 2.0, at[2] - at[1] / 4.0); // exact in what follows
        }
        for (std::uint32_t k = 0; k < 5; ++k)
            (*positions)[dataset.lattice.index(0, 0, k)] = {0, 0, 1};
        (*positions)[dataset.lattice.index(3, 3, 2)] += Eigen::Vector3d(0, 0, 1.5);
        dataset.positions = positions;
        RecordedHistory history;
        const auto report = build(dataset, {{"finest", finest}}, history);
        QVERIFY(report.ok());
        QVERIFY(report->inverted > 0);
        QVERIFY(report->degenerate > 0);
        std::uint64_t inverted = 0, degenerate = 0;
        for (const RecordedHistory::Tetrahedron& tetrahedron : history.tetrahedra) {
            if (tetrahedron.destroyer != 0xffffffff)
                continue;
            std::array<Eigen::Vector3d, 4> at;
            std::ranges::transform(tetrahedron.sites, at.begin(),
                                   [&](std::uint32_t site) { return (*positions)[history.points[site]]; });
            const double volume = (at[1] - at[0]).dot((at[2] - at[0]).cross(at[3] - at[0]));
            inverted += volume < 0 ? 1 : 0;
            degenerate += volume == 0 ? 1 : 0;
        }
        QCOMPARE(report->inverted, inverted);
        QCOMPARE(report->degenerate, degenerate);
    }

    /// R6: far from what matters more may be lost.
    void weightsCount()
    {
        const Dataset dataset = dataOf("lattice");
        RecordedHistory plain, weighted;
        QVERIFY(build(dataset, {{"error", 5.0}}, plain).ok());
        QVERIFY(build(dataset, {{"error", 5.0}, {"weights", std::string("point:0,0,0,2")}}, weighted).ok());
        const auto initial = [](const RecordedHistory& h) {
            return std::ranges::count(h.runningKeys, std::numeric_limits<float>::infinity());
        };
        QVERIFY(initial(weighted) < initial(plain));
        RecordedHistory none;
        QVERIFY(build(dataset, {{"weights", std::string("circle:1")}}, none).error().kind == ErrorKind::WrongUsage);
    }

    void stopsWhenCancelled()
    {
        std::stop_source source;
        source.request_stop();
        RecordedHistory history;
        const auto report = build(dataOf("irregular"), {}, history, Progress(source.get_token(), {}));
        QVERIFY(!report);
        QVERIFY(report.error().kind == ErrorKind::Cancelled);
    }
};

QTEST_APPLESS_MAIN(DecimationBuilderTest)
#include "decimation_builder_test.moc"
