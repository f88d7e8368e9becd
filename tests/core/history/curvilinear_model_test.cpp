// SPDX-License-Identifier: GPL-3.0-or-later
// Models of domains whose points have positions of their own (R1, R4, S4): what is written comes back, meshes lie in
// physical space and are positive there, a query takes both thresholds.
#include "core/base/rounding.h"
#include "core/data/dataset_checks.h"
#include "core/history/model_writer.h"
#include "tests/core/history/model_fixture.h"

#include <tan/query.h>

#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <set>

using namespace tetra;
using format::SectionId;

namespace {

constexpr std::array<std::uint32_t, 3> size = {6, 5, 4};

double sixVolumes(const TetrahedralMesh& mesh, const std::array<std::uint32_t, 4>& t)
{
    const auto edge = [&](int corner) -> Eigen::Vector3d {
        return (mesh.positions[t[corner]] - mesh.positions[t[0]]).cast<double>();
    };
    return edge(1).dot(edge(2).cross(edge(3)));
}

/// Makes the section one that readers skip.
void hide(FileParts& file, SectionId id)
{
    file.section(id).flags = 0;
    file.section(id).id = 99;
}

/// Five points, one in the middle of the others, as a builder for scattered data hands them over.
Dataset fivePoints()
{
    auto positions = std::make_shared<std::vector<Eigen::Vector3d>>(
        std::vector<Eigen::Vector3d>{{1. / 3, 0.5, 0.25}, {0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 3}});
    const std::shared_ptr<float[]> samples(new float[5]{1, 0, 0, 0, 0});
    ScalarField values(SampleType::Float32, 5,
                       std::shared_ptr<const std::byte>(samples, reinterpret_cast<const std::byte*>(samples.get())));
    return {.domain = DomainClass::Scattered,
            .lattice = {{5, 1, 1}, {1, 1, 1}, {0, 0, 0}},
            .positions = positions,
            .values = values,
            .source = {"five", {}, contentHash(values, positions)}};
}

} // namespace

class CurvilinearModelTest : public QObject {
    Q_OBJECT

private slots:
    void init() { folder_ = std::make_unique<QTemporaryDir>(); }

    void whatIsWrittenComesBack_data()
    {
        QTest::addColumn<bool>("precise");
        QTest::addColumn<bool>("mirrored");
        QTest::newRow("floats") << false << false;
        QTest::newRow("doubles") << true << false;
        QTest::newRow("left-handed") << false << true;
    }
    void whatIsWrittenComesBack()
    {
        QFETCH(bool, precise);
        QFETCH(bool, mirrored);
        const Dataset dataset = bentBumps(SampleType::Float32, size, precise, mirrored);
        QCOMPARE(isLeftHanded(dataset), mirrored);
        const auto model = write(dataset);
        const ModelDescription& description = model->description();
        QCOMPARE(description.domain, DomainClass::Curvilinear);
        QCOMPARE(description.lattice.size, dataset.lattice.size);
        QVERIFY(description.bounds.isApprox(dataset.bounds(), 0));
        QCOMPARE(description.leftHanded, mirrored);
        QCOMPARE(description.warpingWeight, historyOf(dataset).traits.warpingWeight);
        QVERIFY(description.warpingWeight > 0);
        QCOMPARE(model->floatPositions().empty(), precise);
        QCOMPARE(model->doublePositions().empty(), !precise);
        for (std::uint32_t site = 0; site < model->siteCount(); ++site)
            QCOMPARE(model->position(site), dataset.position(model->points()[site]));
    }

    /// Rounded up, of those tetrahedra that are stored.
    void ownWarpingsAreBounds()
    {
        const Dataset dataset = bentBumps(SampleType::Float32, size);
        const auto model = write(dataset);
        const RecordedSteps& history = historyOf(dataset);
        QCOMPARE(model->ownWarpings().size(), std::size_t(model->tetrahedronCount()));
        std::multiset<double> claimed;
        for (std::uint64_t t = 0; t < model->tetrahedronCount(); ++t) {
            claimed.insert(model->ownWarping(t));
            QCOMPARE(model->ownWarping(t),
                     static_cast<double>(halfToFloat(model->ownWarpings()[t])) * dataset.bounds().diagonal().norm());
        }
        std::multiset<double> given;
        for (const auto& step : history.steps)
            for (const HistoryTetrahedron& tetrahedron : step.star)
                given.insert(static_cast<double>(tetrahedron.warping));
        QVERIFY(*claimed.rbegin() >= *given.rbegin());
        QVERIFY(*claimed.rbegin() <= *given.rbegin() * 1.001);
    }

    /// Every mesh is positive in physical space, whichever hand the grid has.
    void meshesArePositive()
    {
        for (const bool mirrored : {false, true}) {
            const auto model = write(bentBumps(SampleType::UInt8, size, false, mirrored));
            for (const double percent : {20., 5., 1., 0.}) {
                const auto mesh = extractPrefix(*model, meshSizeAt(*model, {percent, percent}).sites);
                QVERIFY(mesh.ok());
                QVERIFY(!mesh->tetrahedra.empty());
                for (const auto& tetrahedron : mesh->tetrahedra)
                    QVERIFY(sixVolumes(*mesh, tetrahedron) > 0);
                for (std::uint32_t site = 0; site < mesh->positions.size(); ++site)
                    QCOMPARE(mesh->positions[site], model->position(site));
            }
        }
    }

    /// C1, R14: the first mesh that keeps both limits, each by itself, found here by going through all batches; 100 %
    /// is no limit.
    void aQueryTakesBothLimits()
    {
        const auto model = write(bentBumps(SampleType::Float32, size));
        QCOMPARE(meshSizeAt(*model, {0, 0}).sites, model->siteCount());
        QCOMPARE(meshSizeAt(*model, {anyError, anyWarping}).sites, 8U);
        std::mt19937 random(3);
        int apart = 0;
        for (int pair = 0; pair < 2000; ++pair) {
            const auto limit = [&random] { return std::uniform_real_distribution(0., 12.)(random); };
            const Accuracy asked = {pair % 5 == 0 ? anyError : limit(), pair % 5 == 1 ? anyWarping : limit()};
            const MeshSize found = meshSizeAt(*model, asked);
            QCOMPARE(found.sites, firstKeeping(*model, asked));
            QVERIFY(asked.error >= anyError || found.error <= asked.error);
            QVERIFY(asked.warping >= anyWarping || found.warping <= asked.warping);
            apart += found.sites < firstByKey(*model, asked) ? 1 : 0;
        }
        QVERIFY(apart > 0); // the key alone does not tell
    }

    /// C1: files that do not tell error and warping apart say of both what the key says.
    void withoutBatchBoundsTheKeyHolds()
    {
        write(bentBumps(SampleType::Float32, size));
        FileParts file(readBytes(path()));
        for (const SectionId id : {SectionId::BatchErrors, SectionId::BatchWarpings})
            file.section(id).id = static_cast<std::uint32_t>(id) + 200; // ones that readers skip
        file.repairChecksums();
        writeBytes(path(), file.content);
        const auto model = Model::open(path());
        QVERIFY2(model.ok(), model.ok() ? "" : model.error().text().c_str());
        QVERIFY((*model)->batchErrors().empty() && (*model)->batchWarpings().empty());
        for (const Accuracy& asked : {Accuracy{1, 5}, {5, 1}, {1, anyWarping}, {anyError, 1}, {2, 3}}) {
            const MeshSize found = meshSizeAt(**model, asked);
            QCOMPARE(found.sites, firstByKey(**model, asked));
            QVERIFY(std::abs(found.warping - found.error) < 1e-9); // the weight is that of 1 : 1
        }
    }

    /// Builders are written by others.
    void wrongWarpingWeightsAreRefused_data()
    {
        QTest::addColumn<double>("weight");
        QTest::newRow("none") << 0.;
        QTest::newRow("negative") << -1.;
        QTest::newRow("infinite") << std::numeric_limits<double>::infinity();
        QTest::newRow("not a number") << std::numeric_limits<double>::quiet_NaN();
    }
    void wrongWarpingWeightsAreRefused()
    {
        QFETCH(double, weight);
        const Dataset dataset = bentBumps(SampleType::Float32, size);
        const auto writer = ModelWriter::create(path(), dataset, {});
        QVERIFY(writer.ok());
        QVERIFY(!(*writer)->begin({weight}).ok());
        const auto regular = ModelWriter::create(path(), bumps(SampleType::Float32, size), {});
        QVERIFY(regular.ok());
        QCOMPARE((*regular)->begin({weight}).ok(), weight == 0);
        QVERIFY(!(*regular)->begin({1}).ok());
    }

    void withoutTheWeightNothingIsWritten()
    {
        const Dataset dataset = bentBumps(SampleType::Float32, size);
        const RecordedSteps& history = historyOf(dataset);
        const auto writer = ModelWriter::create(path(), dataset, {});
        QVERIFY(writer.ok());
        const auto& step = history.steps[0];
        QVERIFY(!(*writer)->add({step.point, step.keyBefore, step.star, step.destroyed}).ok());
        QVERIFY(!std::filesystem::exists(path()));
    }

    void scatteredPointsComeBack()
    {
        const Dataset dataset = fivePoints();
        const auto writer = ModelWriter::create(path(), dataset, {});
        QVERIFY(writer.ok());
        constexpr float infinite = std::numeric_limits<float>::infinity();
        for (std::uint64_t point = 1; point < 4; ++point)
            QVERIFY((*writer)->add({point, infinite, {}, {}}).ok());
        const HistoryTetrahedron first{{0, 2, 1}, 1};
        QVERIFY((*writer)->add({4, infinite, std::span(&first, 1), {}}).ok());
        const HistoryTetrahedron star[] = {{{0, 2, 1}}, {{0, 1, 3}}, {{0, 3, 2}}, {{1, 2, 3}}};
        const std::uint32_t destroyed = 0;
        QVERIFY((*writer)->add({0, 1, star, std::span(&destroyed, 1)}).ok());
        const Status finished = (*writer)->finish(0);
        QVERIFY2(finished.ok(), finished.ok() ? "" : finished.error().text().c_str());
        const auto model = Model::open(path());
        QVERIFY2(model.ok(), model.ok() ? "" : model.error().text().c_str());
        QCOMPARE((*model)->description().domain, DomainClass::Scattered);
        QVERIFY((*model)->ownWarpings().empty());
        QCOMPARE(meshSizeAt(**model, {100}).sites, 4U);
        const auto mesh = extractPrefix(**model, 5);
        QVERIFY(mesh.ok());
        QCOMPARE(mesh->tetrahedra.size(), std::size_t(4));
        for (std::uint32_t site = 0; site < 5; ++site)
            QCOMPARE((*model)->position(site), dataset.position((*model)->points()[site]));
    }

    void damageIsFound_data()
    {
        QTest::addColumn<std::function<void(FileParts&)>>("damage");
        QTest::addColumn<QString>("text");
        const auto row = [](const char* name, std::function<void(FileParts&)> damage, const char* text) {
            QTest::newRow(name) << std::move(damage) << QString(text);
        };
        row(
            "no weight", [](FileParts& f) { f.header().warpingWeight = 0; }, "warping weight");
        row(
            "a weight that is no number", [](FileParts& f) { f.header().warpingWeight = std::nan(""); },
            "warping weight");
        row(
            "hand", [](FileParts& f) { f.header().leftHanded = 2; }, "handedness");
        row(
            "bounds", [](FileParts& f) { f.header().boundingBox[0] = 1e9; }, "bounding box");
        row(
            "no positions", [](FileParts& f) { hide(f, SectionId::SitePositions); }, "'site positions' is missing");
        row(
            "elements", [](FileParts& f) { f.section(SectionId::SitePositions).elementBytes = 24; }, "site positions");
        row(
            "no warpings", [](FileParts& f) { hide(f, SectionId::OwnWarpings); }, "'own warpings' is missing");
        row(
            "called regular", [](FileParts& f) { f.header().domainClass = 0; }, "bounding box");
        row(
            "irregular", [](FileParts& f) { f.header().domainClass = 2; }, "a lattice of 6 x 5 x 4 points");
        row(
            "a class of its own", [](FileParts& f) { f.header().domainClass = 4; }, "domain class 4");
    }
    void damageIsFound()
    {
        QFETCH(std::function<void(FileParts&)>, damage);
        QFETCH(QString, text);
        write(bentBumps(SampleType::Float32, size));
        FileParts file(readBytes(path()));
        damage(file);
        file.repairChecksums();
        writeBytes(path(), file.content);
        const auto opened = Model::open(path());
        QVERIFY(!opened.ok());
        QVERIFY2(QString::fromStdString(opened.error().text()).contains(text), opened.error().text().c_str());
    }

private:
    /// Going through the meshes at the ends of batches.
    static std::uint32_t firstKeeping(const Model& model, const Accuracy& asked)
    {
        const double error = asked.error >= anyError ? 1e300 : asked.error / 100 * model.description().range.extent();
        const double warping = asked.warping >= anyWarping ? 1e300 : asked.warping / 100 * model.diagonal();
        for (std::size_t batch = 0; batch < model.batchEnds().size(); ++batch)
            if (static_cast<double>(model.batchErrors()[batch]) <= error &&
                static_cast<double>(model.batchWarpings()[batch]) <= warping)
                return model.batchEnds()[batch] + 1;
        return model.siteCount();
    }
    static std::uint32_t firstByKey(const Model& model, const Accuracy& asked)
    {
        const double error = asked.error >= anyError ? 1e300 : asked.error / 100 * model.description().range.extent();
        const double warping = asked.warping >= anyWarping ? 1e300 : asked.warping / 100 * model.diagonal();
        const double key = std::min(error, warping * model.description().warpingWeight);
        const auto& keys = model.runningKeys();
        return static_cast<std::uint32_t>(
            std::ranges::find_if(keys, [key](float one) { return static_cast<double>(one) <= key; }) - keys.begin());
    }

    std::filesystem::path path() const { return folder_->filePath("model.tan").toStdString(); }
    std::shared_ptr<const Model> write(const Dataset& dataset) const
    {
        writeModel(path(), dataset);
        const auto model = Model::open(path());
        if (!model)
            qFatal("%s", model.error().text().c_str());
        return *model;
    }

    std::unique_ptr<QTemporaryDir> folder_;
};

QTEST_GUILESS_MAIN(CurvilinearModelTest)
#include "curvilinear_model_test.moc"
