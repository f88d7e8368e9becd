// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/builders/refinement/refinement_builder.h"

#include <QtTest>

#include <cmath>
#include <memory>

using namespace tetra;

namespace {

/// Counts what a build hands over.
struct CountingSink : HistorySink {
    double warpingWeight = -1;
    std::uint64_t sites = 0;
    std::uint64_t tetrahedra = 0;
    float finalKey = -1;

    Status begin(const HistoryTraits& traits) override
    {
        warpingWeight = traits.warpingWeight;
        return {};
    }
    Status add(const HistoryStep& step) override
    {
        ++sites;
        tetrahedra += step.star.size();
        return {};
    }
    Status finish(float key) override
    {
        finalKey = key;
        return {};
    }
};

/// A quarter of a pipe, 12 x 9 x 8 points; the values are the angle, or all the same.
Dataset pipe(bool constant)
{
    Dataset dataset;
    dataset.domain = DomainClass::Curvilinear;
    dataset.lattice.size = {12, 9, 8};
    const auto positions = std::make_shared<std::vector<Eigen::Vector3d>>();
    const auto values = std::make_shared<std::vector<float>>();
    for (std::uint64_t point = 0; point < dataset.lattice.pointCount(); ++point) {
        const auto at = dataset.lattice.coordinates(point);
        const double angle = 0.14 * at[0], radius = 2 + at[1] * (0.4 + 0.03 * at[1]);
        positions->emplace_back(radius * std::sin(angle), radius * std::cos(angle), at[2] * (1 + 0.04 * at[2]));
        values->push_back(constant ? 5.0f : static_cast<float>(angle * angle));
    }
    dataset.positions = positions;
    const std::shared_ptr<const std::byte> bytes(values, reinterpret_cast<const std::byte*>(values->data()));
    dataset.values = ScalarField(SampleType::Float32, values->size(), bytes);
    return dataset;
}

} // namespace

/// R8, R12, S4, S10: what the parameters mean for curvilinear grids.
class CurvilinearBuildTest : public QObject {
    Q_OBJECT

private slots:
    void isAccepted()
    {
        Dataset dataset = pipe(false);
        const Acceptance grid = RefinementBuilder().accepts(dataset);
        QVERIFY(grid.score > 0.5 && grid.score < 1); // the second choice, if the grid is a mesh
        QVERIFY(!grid.reason.text().empty());
        dataset.lattice.size = {4000, 4000, 4000};
        const Acceptance tooLarge = RefinementBuilder().accepts(dataset);
        QCOMPARE(tooLarge.score, 0.0);
        QVERIFY(!tooLarge.reason.text().empty() && tooLarge.reason.text() != grid.reason.text());
    }

    /// R12, C8: one threshold alone means the same in every builder (decimation_builder_test.cpp).
    void thresholdsSayWhereToStopAndWhatCounts_data()
    {
        QTest::addColumn<double>("error");
        QTest::addColumn<double>("warping");
        QTest::addColumn<double>("ratio"); // what one % of the diagonal is worth in % of the value range
        QTest::addColumn<double>("stop");  // the final key in % of the value range
        QTest::newRow("everything") << 0.0 << 0.0 << 1.0 << 0.0;
        QTest::newRow("both") << 2.0 << 2.0 << 1.0 << 2.0;
        QTest::newRow("shape counts more") << 4.0 << 1.0 << 4.0 << 4.0;
        QTest::newRow("values count more") << 1.0 << 5.0 << 0.2 << 1.0;
        QTest::newRow("error alone") << 2.0 << 0.0 << 1.0 << 2.0;
        QTest::newRow("warping alone") << 0.0 << 2.0 << 1.0 << 2.0;
    }
    void thresholdsSayWhereToStopAndWhatCounts()
    {
        QFETCH(double, error);
        QFETCH(double, warping);
        QFETCH(double, ratio);
        QFETCH(double, stop);
        const Dataset dataset = pipe(false);
        const double extent = dataset.values.range().extent();
        const double diagonal = dataset.bounds().diagonal().norm();
        for (const std::string selection : {"normalised", "paper"}) {
            CountingSink sink;
            BuildTarget target{sink};
            const auto report = RefinementBuilder().build(
                dataset,
                {{"error", error}, {"warping", warping}, {"selection", selection}, {"error-in", std::string("grid")}},
                target, {});
            QVERIFY(report.ok());
            QCOMPARE(report->sites, sink.sites);
            QCOMPARE(report->tetrahedra, sink.tetrahedra);
            QCOMPARE(report->inverted, std::uint64_t(0));
            QCOMPARE(sink.warpingWeight, ratio * extent / diagonal);
            QVERIFY(sink.finalKey >= 0 && double(sink.finalKey) <= stop / 100 * extent);
            QVERIFY(sink.sites > 8 && (stop > 0) == (sink.sites < dataset.pointCount() * 9 / 10));
        }
    }

    /// C12: unless something else is asked for, a grid that is refined as a whole keeps the error in space, and the
    /// model says so.
    void theErrorInSpaceIsKeptWhereItCan()
    {
        const RefinementBuilder builder;
        const Dataset dataset = pipe(false);
        const auto errorIn = [&](const ParameterValues& values) {
            return std::get<std::string>(builder.settled(dataset, values).at("error-in"));
        };
        QCOMPARE(errorIn({}), std::string("space"));
        for (const auto& [id, value] : {std::pair("error-in", "grid"), std::pair("selection", "paper"),
                                        std::pair("by", "error"), std::pair("block", "4")})
            QCOMPARE(errorIn({{id, std::string(value)}}), std::string("grid"));
        QCOMPARE(errorIn({{"error-in", std::string("space")}}), std::string("space"));
        QVERIFY(keepsErrorInSpace(1'000'000) && !keepsErrorInSpace(1'000'001));
        Dataset rectilinear = dataset;
        rectilinear.convex = true;
        QVERIFY(!builder.settled(rectilinear, {}).contains("error-in"));
    }

    /// R6: points far from what matters need less accuracy.
    void weightsSaveSites()
    {
        const Dataset dataset = pipe(false);
        const auto sitesWith = [&](const std::string& weights) -> std::uint64_t {
            CountingSink sink;
            BuildTarget target{sink};
            const auto report = RefinementBuilder().build(
                dataset, {{"error", 1.0}, {"warping", 1.0}, {"weights", weights}, {"error-in", std::string("grid")}},
                target, {});
            return report ? sink.sites : 0;
        };
        const std::uint64_t near = sitesWith("point:0,2,0,1,0.01");
        QVERIFY(near > 8 && near < sitesWith("") / 2);
        QCOMPARE(sitesWith("point:0,2,0,1,1"), sitesWith(""));
    }

    /// A field without a range still has a shape.
    void constantFieldKeepsTheShape()
    {
        const Dataset dataset = pipe(true);
        CountingSink sink;
        BuildTarget target{sink};
        QVERIFY(RefinementBuilder().build(dataset, {}, target, {}).ok());
        QVERIFY(sink.warpingWeight > 0);
        QVERIFY(sink.sites > 100);
    }
};

QTEST_GUILESS_MAIN(CurvilinearBuildTest)
#include "curvilinear_build_test.moc"
