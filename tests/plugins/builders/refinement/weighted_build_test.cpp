// SPDX-License-Identifier: GPL-3.0-or-later
/// R6: a build with weights puts its sites where they count, and the checker proves what it claims.
#include "plugins/builders/refinement/refinement_builder.h"

#include "core/history/model_writer.h"
#include "plugins/samples/samples.h"

#include <tan/data.h>
#include <tan/verify.h>

#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>

using namespace tetra;

namespace {

QString failuresOf(const VerificationReport& verdict)
{
    QStringList texts;
    for (const std::string& text : verdict.failures)
        texts << QString::fromStdString(text);
    for (const LevelReport& level : verdict.levels)
        for (const std::string& text : level.failures)
            texts << QString::fromStdString(text);
    return texts.join('\n');
}

} // namespace

class WeightedBuildTest : public QObject {
    Q_OBJECT

private:
    /// The model of `dataset` with these weights; `told` is what the file says they were.
    std::shared_ptr<const Model> build(const Dataset& dataset, const std::string& weights, double error,
                                       const std::string& told)
    {
        const std::filesystem::path path = folder_.filePath("model.tan").toStdString();
        ModelDescription description;
        description.builder = "refinement";
        description.parameters = {{"weights", told}};
        auto writer = ModelWriter::create(path, dataset, description);
        BuildTarget target{**writer};
        const auto report = RefinementBuilder().build(dataset, {{"error", error}, {"weights", weights}}, target, {});
        return report.ok() ? Model::open(path).value() : nullptr;
    }
    static std::ptrdiff_t sitesNear(const Model& model, const Dataset& dataset, const Eigen::Vector3d& place,
                                    double distance, std::uint32_t ofFirst)
    {
        return std::ranges::count_if(model.points().first(ofFirst), [&](std::uint32_t point) {
            return (dataset.position(point) - place).norm() < distance;
        });
    }

    QTemporaryDir folder_;

private slots:
    void sitesGoWhereTheyCount()
    {
        const Dataset dataset = makeSample({"marschner-lobb", 21, {}, 1}).value();
        const auto plain = build(dataset, "", 0, "");
        const auto weighted = build(dataset, "point:4,4,4,6,0.05", 0, "point:4,4,4,6,0.05");
        const std::uint32_t total = 1500;
        QVERIFY(plain && weighted && plain->siteCount() > total && weighted->siteCount() > total);
        QVERIFY(2 * sitesNear(*plain, dataset, {4, 4, 4}, 6, total) <
                3 * sitesNear(*weighted, dataset, {4, 4, 4}, 6, total));
    }

    void theWeightedErrorIsProved_data()
    {
        QTest::addColumn<SampleType>("type");
        QTest::addColumn<QString>("weights");
        for (const SampleType type :
             {SampleType::UInt8, SampleType::Int16, SampleType::Int32, SampleType::Float32, SampleType::Float64}) {
            const QByteArray name(sampleTypeName(type).data());
            QTest::newRow(name + ", place") << type << "point:3,3,3,5;box:6,6,0,9,9,9,0,0.3";
            QTest::newRow(name + ", value and place") << type << "value:0.5,0.2,0.01;point:3,3,3,5,0.001";
        }
    }
    void theWeightedErrorIsProved()
    {
        QFETCH(SampleType, type);
        QFETCH(QString, weights);
        const Dataset dataset = makeSample({"marschner-lobb", 10, type, 1}).value();
        const auto model = build(dataset, weights.toStdString(), 0, weights.toStdString());
        QVERIFY(model != nullptr);
        const auto verdict = verify(*model, dataset, {{4}, {3}, {2}, {1}, {0.5}, {0.2}, {0.1}, {0}});
        QVERIFY2(verdict.ok() && verdict->ok(), qPrintable(failuresOf(*verdict)));
    }

    /// A model that claims other weights than it was built with does not keep its error.
    void otherWeightsAreFoundOut()
    {
        const Dataset dataset = makeSample({"marschner-lobb", 12, SampleType::UInt8, 1}).value();
        const std::string weights = "point:3,3,3,4,0.01";
        for (const std::string told : {"", "point:8,8,8,4,0.01"}) {
            const auto model = build(dataset, weights, 0, told);
            QVERIFY(model != nullptr);
            const auto verdict = verify(*model, dataset, {{2}});
            QVERIFY(verdict.ok() && !verdict->ok());
            QVERIFY2(failuresOf(*verdict).contains("more than the claimed"), qPrintable(failuresOf(*verdict)));
        }
        const auto unreadable = build(dataset, weights, 0, "point:8,8");
        const auto verdict = verify(*unreadable, dataset, {{2}});
        QVERIFY2(failuresOf(*verdict).contains("weights cannot be read"), qPrintable(failuresOf(*verdict)));
    }

    void stopsAtTheWeightedError()
    {
        const Dataset dataset = makeSample({"marschner-lobb", 12, {}, 1}).value();
        const auto plain = build(dataset, "", 5, "");
        const auto weighted = build(dataset, "point:3,3,3,4", 5, "point:3,3,3,4");
        QVERIFY(weighted->finalKey() <= 0.05 * dataset.values.range().extent());
        QVERIFY(weighted->siteCount() < plain->siteCount());
    }

    void badWeightsAreRefused()
    {
        const Dataset dataset = makeSample({"noise", 4, {}, 1}).value();
        auto writer = ModelWriter::create(folder_.filePath("refused.tan").toStdString(), dataset, {});
        BuildTarget target{**writer};
        const auto report = RefinementBuilder().build(dataset, {{"weights", std::string("point:1")}}, target, {});
        QVERIFY(!report.ok());
        QCOMPARE(report.error().kind, ErrorKind::WrongUsage);
    }
};

QTEST_GUILESS_MAIN(WeightedBuildTest)
#include "weighted_build_test.moc"
