// SPDX-License-Identifier: GPL-3.0-or-later
/// R2, R3, B3: meshes of any kind are proved right, and what is wrong with a damaged one is found.
#include "core/verify/verify_mesh.h"

#include "tests/core/verify/mesh_cases.h"

#include <tan/query.h>

#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <functional>
#include <optional>

using namespace tetra;

namespace {

QString textOf(const Result<LevelReport>& verdict)
{
    if (!verdict)
        return "Error: " + QString::fromStdString(verdict.error().text());
    QStringList texts;
    for (const std::string& text : verdict->failures)
        texts << QString::fromStdString(text);
    return texts.join('\n');
}

/// |value - interpolation| at a place in the cell, in units of the values; nothing outside.
std::optional<double> errorIn(const TetrahedralMesh& mesh, const std::array<std::uint32_t, 4>& cell,
                              const Eigen::Vector3d& place, double value)
{
    Eigen::Matrix4d corners;
    Eigen::Vector4d values;
    for (int corner = 0; corner < 4; ++corner) {
        corners.col(corner) << mesh.positions[cell[static_cast<std::size_t>(corner)]].cast<double>(), 1;
        values[corner] = static_cast<double>(mesh.values[cell[static_cast<std::size_t>(corner)]]);
    }
    const Eigen::Vector4d weights = corners.fullPivLu().solve(Eigen::Vector4d(place[0], place[1], place[2], 1));
    if (weights.minCoeff() < -1e-6)
        return {};
    return std::abs(weights.dot(values) - value);
}

/// The error of each sample in % of the range, where space is physical.
std::vector<double> errorsOf(const Dataset& dataset, const TetrahedralMesh& mesh)
{
    std::vector<double> errors(dataset.pointCount(), 0);
    for (std::uint64_t sample = 0; sample < errors.size(); ++sample)
        for (const auto& cell : mesh.tetrahedra)
            if (const auto error = errorIn(mesh, cell, dataset.position(sample), dataset.values.at(sample)))
                errors[sample] = std::max(errors[sample], 100 * *error / dataset.values.range().extent());
    return errors;
}

using Damage = std::function<void(Case&)>;

} // namespace

class MeshVerificationTest : public QObject {
    Q_OBJECT

private slots:
    void init() { folder_ = std::make_unique<QTemporaryDir>(); }

    void levelsAreProved_data() { kinds(); }
    void levelsAreProved()
    {
        QFETCH(QString, kind);
        const Dataset dataset = datasetOf(kind);
        const auto model = modelOf(path(), dataset);
        const std::vector<Accuracy> levels = {{30, 30}, {8, 20}, {2, 1}, {0, 0}};
        const auto verdict = verify(*model, dataset, levels);
        QVERIFY(verdict.ok() && verdict->ok());
        for (std::size_t level = 0; level < levels.size(); ++level) {
            const Case made = uniform(*model, levels[level]);
            const auto proved = verifyMesh(*model, dataset, made.query, made.mesh);
            QVERIFY2(proved.ok() && proved->ok(), qPrintable(textOf(proved)));
            const LevelReport& same = verdict->levels[level];
            QCOMPARE(proved->asked.error, same.asked.error);
            QCOMPARE(proved->asked.warping, same.asked.warping);
            QCOMPARE(proved->sites, same.sites);
            QCOMPARE(proved->tetrahedra, same.tetrahedra);
            QCOMPARE(proved->measured.error.largest, same.measured.error.largest);
            QCOMPARE(proved->measured.warping.largest, same.measured.warping.largest);
            QVERIFY(proved->conforming && proved->covers && proved->inverted == 0);
            // What is measured in passing, of what the model itself has.
            const auto passing = measureInSpace(*model, made.query, made.mesh);
            QVERIFY(passing.ok());
            QCOMPARE(passing->has_value(), dataset.domain == DomainClass::Curvilinear && !model->samples().empty());
            if (*passing) {
                const ErrorInSpace& found = **passing;
                QCOMPARE(found.largest, same.measured.errorInSpace.largest);
                QCOMPARE(found.mean, same.measured.errorInSpace.mean);
                QCOMPARE(found.outside, same.measured.errorInSpace.outside);
            }
        }
    }

    /// C15: mean, percentile and root mean square are those of the errors at all samples; without a grid that is
    /// bent they are the error in space, too (C12).
    void statisticsAreOfAllSamples_data()
    {
        QTest::addColumn<QString>("kind");
        for (const char* kind : {"integers", "floats", "scattered"})
            QTest::newRow(kind) << QString(kind);
    }
    void statisticsAreOfAllSamples()
    {
        QFETCH(QString, kind);
        const Dataset dataset = datasetOf(kind);
        const auto model = modelOf(path(), dataset);
        for (const double percent : {30, 8, 2}) {
            const Case made = uniform(*model, {percent, anyWarping});
            const auto proved = verifyMesh(*model, dataset, made.query, made.mesh);
            QVERIFY2(proved.ok() && proved->ok(), qPrintable(textOf(proved)));
            std::vector<double> errors = errorsOf(dataset, made.mesh.mesh);
            std::ranges::sort(errors);
            const auto count = static_cast<double>(errors.size());
            double sum = 0, squares = 0;
            for (const double error : errors) {
                sum += error;
                squares += error * error;
            }
            const ResidualStatistics& found = proved->measured.error;
            const auto near = [](double one, double other) { return std::abs(one - other) < 1e-4; }; // mesh of floats
            QVERIFY(near(found.largest, errors.back()));
            QVERIFY(near(found.mean, sum / count));
            QVERIFY(near(found.rootMeanSquare, std::sqrt(squares / count)));
            QVERIFY(near(found.percentile99, errors[static_cast<std::size_t>(std::ceil(0.99 * count)) - 1]));
            QVERIFY(found.mean > 0 && found.mean < found.rootMeanSquare && found.rootMeanSquare < found.largest);
            QCOMPARE(proved->measured.errorInSpace.largest, found.largest);
            QCOMPARE(proved->measured.errorInSpace.mean, found.mean);
            QCOMPARE(proved->measured.errorInSpace.outside, std::uint64_t(0));
        }
    }

    /// A mesh finer in a sphere and near some values than elsewhere.
    void varyingMeshesAreProved_data() { kinds(); }
    void varyingMeshesAreProved()
    {
        QFETCH(QString, kind);
        const Dataset dataset = datasetOf(kind);
        const auto model = modelOf(path(), dataset);
        const Eigen::AlignedBox3d bounds = dataset.bounds();
        const SpaceRamp ramp{Sphere{bounds.min(), bounds.diagonal().norm() / 4}, 1, 20, bounds.diagonal().norm() / 8};
        const double middle = dataset.values.range().minimum + dataset.values.range().extent() / 2;
        const ErrorField near = ErrorField::nearValues(std::array{middle}, 1, 30, dataset.values.range().extent() / 9);
        MeshExtractor extractor(model);
        for (const ErrorField& field : {ErrorField(ramp), near, smallerOf(ramp, near)}) {
            MeshQuery query;
            query.error = field;
            query.warping = 10.0;
            query.method = VariableMethod::ClosedSet;
            const auto mesh = extractor.extract(query);
            QVERIFY(mesh.ok());
            const auto proved = verifyMesh(*model, dataset, query, **mesh);
            QVERIFY2(proved.ok() && proved->ok(), qPrintable(textOf(proved)));
            QCOMPARE(proved->asked.error, field.bounds().maximum);
        }
    }

    /// A point of the dataset need not be a site.
    void verticesMayBeNoSites_data() { kinds(); }
    void verticesMayBeNoSites()
    {
        QFETCH(QString, kind);
        const Dataset dataset = datasetOf(kind);
        const auto model = modelOf(path(), dataset);
        Case made = uniform(*model, {2, 2});
        std::ranges::fill(made.mesh.sites, ExtractedMesh::noSite);
        const auto proved = verifyMesh(*model, dataset, made.query, made.mesh);
        QVERIFY2(proved.ok() && proved->ok(), qPrintable(textOf(proved)));
    }

    void damageIsFound_data()
    {
        QTest::addColumn<QString>("kind");
        QTest::addColumn<Damage>("damage");
        QTest::addColumn<QString>("says");
        for (const char* kind : {"integers", "floats", "bent", "bent mirrored", "scattered"}) {
            const auto row = [kind](const char* name, const Damage& damage, const char* says) {
                QTest::addRow("%s: %s", kind, name) << QString(kind) << damage << QString(says);
            };
            row(
                "missing cell", [](Case& c) { c.mesh.mesh.tetrahedra.pop_back(); }, "belongs to one cell only");
            row(
                "cell twice", [](Case& c) { c.mesh.mesh.tetrahedra.push_back(c.mesh.mesh.tetrahedra[3]); },
                "on the same side");
            row(
                "cell in place of another", [](Case& c) { c.mesh.mesh.tetrahedra[2] = c.mesh.mesh.tetrahedra[5]; },
                "belongs to ");
            row(
                "corners exchanged",
                [](Case& c) { std::swap(c.mesh.mesh.tetrahedra[4][1], c.mesh.mesh.tetrahedra[4][2]); },
                "Inverted cell");
            row(
                "corner twice", [](Case& c) { c.mesh.mesh.tetrahedra[4][1] = c.mesh.mesh.tetrahedra[4][2]; },
                "Flat cell");
            row(
                "corners of two cells exchanged",
                [](Case& c) {
                    auto& cells = c.mesh.mesh.tetrahedra;
                    for (std::size_t other = 1; other < cells.size(); ++other)
                        if (std::ranges::find(cells[other], cells[0][0]) == cells[other].end()) {
                            std::swap(cells[0][0], cells[other][0]);
                            return;
                        }
                },
                "belongs to");
            row(
                "two vertices exchanged",
                [](Case& c) {
                    std::swap(c.mesh.mesh.positions[1], c.mesh.mesh.positions.back());
                    std::swap(c.mesh.mesh.values[1], c.mesh.mesh.values.back());
                    std::swap(c.mesh.sites[1], c.mesh.sites.back());
                },
                "cell");
            row(
                "moved vertex", [](Case& c) { c.mesh.mesh.positions[6][1] += 0.01F; },
                "does not lie where site 6 does");
            row(
                "vertex rounded to a float",
                [](Case& c) {
                    Eigen::Vector3d& place = c.mesh.mesh.positions[6];
                    place = place.cast<float>().cast<double>() == place ? (place * (1 + 1e-15)).eval()
                                                                        : place.cast<float>().cast<double>().eval();
                },
                "does not lie where site 6 does");
            row(
                "moved vertex without a site",
                [](Case& c) {
                    c.mesh.mesh.positions[6][1] += 0.01F;
                    c.mesh.sites[6] = ExtractedMesh::noSite;
                },
                "is not a point of the dataset");
            row(
                "vertex nowhere",
                [](Case& c) {
                    c.mesh.mesh.positions[6].setConstant(std::numeric_limits<float>::quiet_NaN());
                    c.mesh.sites[6] = ExtractedMesh::noSite;
                },
                "is not a point of the dataset");
            row(
                "vertex far away",
                [](Case& c) {
                    c.mesh.mesh.positions[6].setConstant(3e38F);
                    c.mesh.sites[6] = ExtractedMesh::noSite;
                },
                "is not a point of the dataset");
            row(
                "value", [](Case& c) { c.mesh.mesh.values[5] += 0.25F; }, "has the value");
            row(
                "site beyond the last", [](Case& c) { c.mesh.sites[5] = 1'000'000; },
                "does not lie where site 1000000 does");
            row(
                "other site", [](Case& c) { c.mesh.sites[5] = 6; }, "does not lie where site 6 does");
            row(
                "vertex twice",
                [](Case& c) {
                    c.mesh.mesh.positions[5] = c.mesh.mesh.positions[4];
                    c.mesh.mesh.values[5] = c.mesh.mesh.values[4];
                    c.mesh.sites[5] = c.mesh.sites[4];
                },
                "is the same point as an earlier one");
            row(
                "corner beyond the last vertex", [](Case& c) { c.mesh.mesh.tetrahedra[1][3] = 0x7fffffff; },
                "beyond the last vertex");
            row(
                "values missing", [](Case& c) { c.mesh.mesh.values.pop_back(); }, "values and");
            row(
                "sites missing", [](Case& c) { c.mesh.sites.clear(); }, "0 numbers of sites");
            row(
                "nothing", [](Case& c) { c.mesh = {}; }, "The mesh is empty.");
            row(
                "asked for more", [](Case& c) { c.query.error = 0.0; }, "more than the claimed");
        }
        for (const char* kind : {"far", "bent doubles", "scattered"})
            QTest::addRow("%s: one vertex rounded to floats", kind) << QString(kind) << Damage([](Case& c) {
                for (Eigen::Vector3d& position : c.mesh.mesh.positions)
                    if (const Eigen::Vector3d rounded = position.cast<float>().cast<double>(); rounded != position) {
                        position = rounded;
                        return;
                    }
            }) << QString("does not lie where site");
        QTest::newRow("bent: warping") << QString("bent") << Damage([](Case& c) { c.query.warping = 0.0; })
                                       << QString("The warping at sample");
        QTest::newRow("bent: hand") << QString("bent") << Damage([](Case& c) {
            for (auto& cell : c.mesh.mesh.tetrahedra)
                std::swap(cell[0], cell[1]);
        }) << QString("Inverted cell");
    }
    void damageIsFound()
    {
        QFETCH(QString, kind);
        QFETCH(Damage, damage);
        QFETCH(QString, says);
        const Dataset dataset = datasetOf(kind);
        const auto model = modelOf(path(), dataset);
        Case made = uniform(*model, {8, 8});
        QVERIFY(made.mesh.sites.size() < model->siteCount());
        QVERIFY(verifyMesh(*model, dataset, made.query, made.mesh)->ok());
        damage(made);
        const auto verdict = verifyMesh(*model, dataset, made.query, made.mesh);
        QVERIFY(verdict.ok());
        QVERIFY2(!verdict->ok() && textOf(verdict).contains(says), qPrintable(textOf(verdict)));
    }

    /// Each sample for itself: where the field is lowered to below the mesh's error there, and only there, it fails.
    void theFieldIsKeptAtEachSample_data()
    {
        QTest::addColumn<QString>("kind");
        for (const char* kind : {"integers", "floats", "scattered"})
            QTest::newRow(kind) << QString(kind);
    }
    void theFieldIsKeptAtEachSample()
    {
        QFETCH(QString, kind);
        const Dataset dataset = datasetOf(kind);
        const auto model = modelOf(path(), dataset);
        const Case made = uniform(*model, {10});
        const std::vector<double> errors = errorsOf(dataset, made.mesh.mesh);
        int kept = 0;
        int broken = 0;
        for (std::uint64_t sample = 0; sample < dataset.pointCount(); ++sample) {
            for (const double lowered : {errors[sample] + 0.01, errors[sample] - 0.01}) {
                if (lowered < 0)
                    continue;
                MeshQuery query = made.query;
                query.error = SpaceRamp{Sphere{dataset.position(sample), 0}, lowered, 10, 0};
                const auto verdict = verifyMesh(*model, dataset, query, made.mesh);
                QVERIFY(verdict.ok());
                const bool expected = lowered >= errors[sample] || errors[sample] < 1e-9;
                QVERIFY2(verdict->ok() == expected, qPrintable(QString::number(sample) + ": " + textOf(verdict)));
                QVERIFY2(expected || textOf(verdict).contains("The error at "), qPrintable(textOf(verdict)));
                ++(expected ? kept : broken);
            }
        }
        QVERIFY(kept > 50 && broken > 20);
    }

    /// Cells that even all points leave inverted are counted, and borne wherever they stand; others are failures (S5).
    void incurablyInvertedCellsAreBorne()
    {
        Dataset dataset = bentBumps(SampleType::Float32, {5, 4, 4});
        auto positions = std::make_shared<std::vector<Eigen::Vector3d>>(*dataset.positions);
        (*positions)[2 + 5 * (1 + 4 * 2)] += Eigen::Vector3d(0, 0, -4); // through its neighbours
        dataset.positions = positions;
        dataset.source.hash = contentHash(dataset.values, dataset.positions);
        const auto model = modelOf(path(), dataset);
        const Case finest = uniform(*model, {0, 0});
        const auto verdict = verifyMesh(*model, dataset, finest.query, finest.mesh);
        QVERIFY2(verdict.ok() && verdict->ok(), qPrintable(textOf(verdict)));
        QVERIFY(verdict->inverted > 0);
        int failed = 0;
        for (const double asked : {20.0, 10.0, 5.0, 2.0, 1.0, 0.5}) {
            const Case coarse = uniform(*model, {asked, anyWarping});
            const auto found = verifyMesh(*model, dataset, coarse.query, coarse.mesh);
            QVERIFY(found.ok());
            failed += textOf(found).contains("is inverted in physical space") ? 1 : 0;
        }
        QVERIFY(failed > 0);
    }

    void theScaleCounts()
    {
        const Dataset dataset = datasetOf("floats");
        const auto model = modelOf(path(), dataset);
        Case made = uniform(*model, {10});
        const double reached = meshSizeAt(*model, {10}).error;
        QVERIFY(reached > 5);
        made.query.error = reached / 3;
        QVERIFY(!verifyMesh(*model, dataset, made.query, made.mesh)->ok());
        made.mesh.scale = 3;
        const auto verdict = verifyMesh(*model, dataset, made.query, made.mesh);
        QVERIFY2(verdict->ok(), qPrintable(textOf(verdict)));
        made.mesh.scale = 2.9;
        QVERIFY(!verifyMesh(*model, dataset, made.query, made.mesh)->ok());
    }

    void anotherDatasetIsFound()
    {
        const auto model = modelOf(path(), datasetOf("floats"));
        const Case made = uniform(*model, {10});
        const auto verdict = verifyMesh(*model, datasetOf("integers"), made.query, made.mesh);
        QVERIFY2(verdict.ok() && textOf(verdict).contains("built from another dataset"), qPrintable(textOf(verdict)));
    }

    void partsOfMeshesAreRefused()
    {
        const Dataset dataset = datasetOf("floats");
        const auto model = modelOf(path(), dataset);
        Case made = uniform(*model, {10});
        made.query.values = {{0, 1}};
        QCOMPARE(verifyMesh(*model, dataset, made.query, made.mesh).error().kind, ErrorKind::WrongUsage);
        made.query.values.clear();
        made.query.window = Window{};
        QCOMPARE(verifyMesh(*model, dataset, made.query, made.mesh).error().kind, ErrorKind::WrongUsage);
    }

    void cancelledWorkSaysSo_data() { kinds(); }
    void cancelledWorkSaysSo()
    {
        QFETCH(QString, kind);
        const Dataset dataset = datasetOf(kind);
        const auto model = modelOf(path(), dataset);
        const Case made = uniform(*model, {10});
        std::stop_source source;
        source.request_stop();
        const auto verdict = verifyMesh(*model, dataset, made.query, made.mesh, Progress(source.get_token(), {}));
        QVERIFY(!verdict.ok());
        QCOMPARE(verdict.error().kind, ErrorKind::Cancelled);
    }

private:
    static void kinds()
    {
        QTest::addColumn<QString>("kind");
        for (const char* kind : {"integers", "floats", "bent", "bent doubles", "bent mirrored", "scattered"})
            QTest::newRow(kind) << QString(kind);
    }
    std::filesystem::path path() const { return folder_->filePath("model.tan").toStdString(); }

    std::unique_ptr<QTemporaryDir> folder_;
};

QTEST_GUILESS_MAIN(MeshVerificationTest)
#include "mesh_verification_test.moc"
