// SPDX-License-Identifier: GPL-3.0-or-later
// Files of each format, written by VTK from Python, hold for TAn what they hold for VTK there: positions and values,
// bit for bit (S6), whether VTK reads them for TAn or a reader of our own. Skipped without python3-vtk9.
#include "tests/lacks.h"
#include "tests/plugins/as_loaded.h"
#include "tests/plugins/readers/vtk/vtk_test_files.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTest>

#include <cstring>
#include <map>
#include <set>

using namespace tetra;

namespace {

/// What VTK read (make_vtk_files.py).
struct Reference {
    std::array<std::int64_t, 5> counts{};
    std::vector<std::array<double, 3>> positions;
    std::vector<double> values;

    explicit Reference(const QString& path)
    {
        QFile file(path);
        if (!file.open(QIODevice::ReadOnly))
            return;
        file.read(reinterpret_cast<char*>(counts.data()), sizeof counts);
        const auto points = static_cast<std::size_t>(counts[0]);
        positions.resize(points);
        values.resize(points);
        file.read(reinterpret_cast<char*>(positions.data()), qint64(points * sizeof positions[0]));
        file.read(reinterpret_cast<char*>(values.data()), qint64(points * sizeof(double)));
    }
};

std::array<double, 3> placeOf(const Dataset& dataset, std::uint64_t point)
{
    const Eigen::Vector3d place = dataset.position(point);
    return {place[0], place[1], place[2]};
}

/// As VTK keeps the numbers of a text of PLOT3D or EnSight.
std::array<double, 3> singlePrecision(const std::array<double, 3>& place)
{
    return {static_cast<float>(place[0]), static_cast<float>(place[1]), static_cast<float>(place[2])};
}

} // namespace

class VtkAgreementTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QProcess python;
        python.start("/usr/bin/python3", {TAN_SOURCE_DIR "/tests/plugins/readers/vtk/make_vtk_files.py",
                                          QString::fromStdString(folder_.path().string())});
        if (!python.waitForFinished(120'000) || python.exitCode() == 77)
            QSKIP_WITHOUT("python3-vtk9");
        QVERIFY2(python.exitCode() == 0, python.readAllStandardError().constData());
    }

    void valuesAreThoseOfVtk()
    {
        QDir dir(QString::fromStdString(folder_.path().string()));
        const QStringList references = dir.entryList({"*.ref"});
        QVERIFY(references.size() > 40);
        for (const QString& name : references) {
            const std::string file = name.chopped(4).toStdString();
            if (file.starts_with("blanked"))
                continue; // an irregular mesh, in a test of its own
            const ParameterValues first = file == "two.xyz"      ? ParameterValues{{"grid", std::int64_t(1)}}
                                          : file == "blocks.vtm" ? ParameterValues{{"part", std::string("1")}}
                                                                 : ParameterValues();
            const auto dataset = readerOf(file).read(folder_.path() / file, first, {});
            QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
            compare(*dataset, Reference(dir.filePath(name)), file);
        }
    }

    /// Every fourth point is blanked out, so that two of three cells of each row are left.
    void blankedCellsAreHoles()
    {
        const auto dataset = complete(readerOf("blanked.xyz").read(folder_.path() / "blanked.xyz", {}, {}));
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QVERIFY(dataset->domain == DomainClass::Irregular);
        QCOMPARE(dataset->pointCount(), std::uint64_t(3 * 5 * 6));
        QVERIFY(dataset->tetrahedra->size() >= std::size_t(2 * 4 * 5 * 5));
        QVERIFY(!dataset->remarks.empty());
    }

    /// The header of a NIfTI file may ask for it; VTK leaves it to the user.
    void niftiSamplesAreRescaled()
    {
        const auto plain = readerOf("image4.nii").read(folder_.path() / "image4.nii", {}, {});
        const auto scaled = readerOf("rescaled.nii").read(folder_.path() / "rescaled.nii", {}, {});
        QVERIFY(plain.ok() && scaled.ok());
        QVERIFY(scaled->values.type() == SampleType::Float32);
        for (std::uint64_t point = 0; point < plain->pointCount(); ++point)
            QCOMPARE(scaled->values.at(point), 2 * plain->values.at(point) + 5);
        QCOMPARE(scaled->remarks.size(), std::size_t(1));
    }

    void partsAndTimesCanBeChosen()
    {
        const Reader& reader = builtVtkReader();
        const auto second = reader.read(folder_.path() / "blocks.vtm", {{"part", std::string("2")}}, {});
        QVERIFY2(second.ok(), second.ok() ? "" : second.error().text().c_str());
        QVERIFY((second->bounds().min() - Eigen::Vector3d(0, 1, 2)).norm() < 1e-12);
        QVERIFY(!reader.read(folder_.path() / "blocks.vtm", {{"part", std::string("3")}}, {}).ok());
        const auto grid = readerOf("two.xyz").read(folder_.path() / "two.xyz", {{"grid", std::int64_t(2)}}, {});
        QVERIFY2(grid.ok(), grid.ok() ? "" : grid.error().text().c_str());
        QVERIFY(std::abs(grid->bounds().min()[0] - 20) < 1e-6);

        const auto first = reader.read(folder_.path() / "run.case", {}, {});
        const auto later = reader.read(folder_.path() / "run.case", {{"time", std::int64_t(2)}}, {});
        QVERIFY(first.ok() && later.ok());
        QVERIFY(std::abs(later->values.range().minimum - first->values.range().minimum - 10) < 1e-5);
        QVERIFY(!reader.read(folder_.path() / "run.case", {{"time", std::int64_t(3)}}, {}).ok());
        const auto contents = reader.probe(folder_.path() / "run.case", {}, {});
        QVERIFY(contents.ok());
        QCOMPARE(contents->timeSteps, (std::vector<double>{0.5, 1.5}));
        const auto blocks = reader.probe(folder_.path() / "blocks.vtm", {}, {});
        QVERIFY(blocks.ok());
        QCOMPARE(blocks->blocks.size(), std::size_t(2));
    }

private:
    /// Grids in VTK's order; others may have lost the points that no cell uses, and have another order.
    static void compare(const Dataset& dataset, const Reference& reference, const std::string& file)
    {
        const auto points = static_cast<std::size_t>(reference.counts[0]);
        QVERIFY2(dataset.pointCount() == points, file.c_str());
        std::map<std::array<double, 3>, double> expected;
        for (std::size_t point = 0; point < points; ++point)
            expected[reference.positions[point]] = reference.values[point];
        const bool inOrder =
            dataset.domain == DomainClass::RegularLattice || dataset.domain == DomainClass::Curvilinear;
        for (std::size_t point = 0; point < points; ++point) {
            const auto place = file.ends_with(".xyz") || file.ends_with(".case")
                                   ? singlePrecision(placeOf(dataset, point))
                                   : placeOf(dataset, point);
            if (inOrder)
                QVERIFY2(dataset.values.at(point) == reference.values[point], file.c_str());
            if (dataset.domain == DomainClass::RegularLattice) { // computed, not stored
                // VTK leaves out where a NIfTI lies; nifti_reader_test judges that.
                for (std::size_t axis = 0; axis < 3 && !file.ends_with(".nii"); ++axis)
                    QVERIFY2(std::abs(place[axis] - reference.positions[point][axis]) < 1e-9, file.c_str());
                continue;
            }
            const auto found = expected.find(place);
            QVERIFY2(found != expected.end(), file.c_str());
            QVERIFY2(dataset.values.at(point) == found->second, file.c_str());
        }
        if (inOrder)
            QCOMPARE(dataset.lattice.size,
                     (std::array{std::uint32_t(reference.counts[2]), std::uint32_t(reference.counts[3]),
                                 std::uint32_t(reference.counts[4])}));
        if (dataset.domain == DomainClass::Irregular)
            QCOMPARE(dataset.tetrahedra->size(), static_cast<std::size_t>(reference.counts[1]));
    }

    VtkFolder folder_;
};

QTEST_GUILESS_MAIN(VtkAgreementTest)
#include "vtk_agreement_test.moc"
