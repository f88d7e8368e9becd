// SPDX-License-Identifier: GPL-3.0-or-later
// What a large CGNS file holds is told by its headers, without its arrays, and as it is told of a small one, which is
// read for it.
#include "tests/lacks.h"
#include "tests/plugins/readers/vtk/vtk_test_files.h"

#include <QProcess>
#include <QTest>

#include <filesystem>

using namespace tetra;

namespace {

/// "Density, Velocity (3), Heat of cells in K".
QString arraysTold(const FileContents& contents)
{
    QStringList told;
    for (const FileArray& array : contents.arrays)
        told << QString::fromStdString(array.name) +
                    (array.components > 1 ? " (" + QString::number(array.components) + ")" : QString()) +
                    (array.perCell ? " of cells" : "") +
                    (array.unit.empty() ? QString() : " in " + QString::fromStdString(array.unit));
    return told.join(", ");
}

QString blocksTold(const FileContents& contents)
{
    QStringList told;
    for (const std::string& block : contents.blocks)
        told << QString::fromStdString(block);
    return told.join(", ");
}

} // namespace

class CgnsHeadersTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QProcess python;
        python.start("/usr/bin/python3", {TAN_SOURCE_DIR "/tests/plugins/readers/vtk/make_cgns_files.py",
                                          QString::fromStdString(folder_.path().string())});
        const bool isOver = python.waitForFinished(120'000);
        QVERIFY2(isOver || python.error() == QProcess::FailedToStart, "the files are not written in two minutes");
        if (!isOver || python.exitCode() == 77)
            QSKIP_WITHOUT("python3-h5py");
        QVERIFY2(python.exitCode() == 0, python.readAllStandardError().constData());
    }

    void headersTellWhatReadingTells_data()
    {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<ParameterValues>("values");
        QTest::addColumn<QString>("arrays");
        QTest::addColumn<QString>("blocks");
        QTest::addColumn<QString>("taken");
        const auto row = [](const char* what, const char* name, const ParameterValues& values, const char* arrays,
                            const char* blocks, const char* taken) {
            QTest::newRow(what) << QByteArray(name) << values << QString(arrays) << QString(blocks) << QString(taken);
        };
        const char* const flow = "Density in kg/m^3, Velocity (3) in m/s";
        row("steps", "steps.cgns", {}, flow, "Zone1, Zone2",
            "array: Density (a guess); time step: 1 of 2, time 0 (a guess); unit of the values: kg/m^3");
        row("a step, a vector", "steps.cgns",
            {{"array", std::string("Velocity")}, {"time", std::int64_t(2)}, {"component", std::string("1")}}, flow,
            "Zone1, Zone2", "array: Velocity; component: 1; time step: 2 of 2, time 2.5; unit of the values: m/s");
        row("a part", "steps.cgns", {{"part", std::string("Zone2")}, {"array", std::string("Density")}}, flow,
            "Zone1, Zone2",
            "array: Density; block: Zone2; time step: 1 of 2, time 0 (a guess); unit of the values: kg/m^3");
        row("bases", "bases.cgns", {}, "Pressure, Heat of cells", "Base1/Zone, Base2/Zone",
            "array: Pressure (a guess)");
        row("meshes", "mesh.cgns", {}, "Temperature in K", "Solid, Fluid",
            "array: Temperature; block: Fluid; unit of the values: K");
    }
    void headersTellWhatReadingTells()
    {
        QFETCH(QByteArray, name);
        QFETCH(ParameterValues, values);
        const std::filesystem::path small = folder_.path() / name.toStdString();
        const auto read = builtVtkReader().probe(small, values, {});
        const auto told = builtVtkReader().probe(enlarged(small), values, {});
        QVERIFY2(read.ok(), read.ok() ? "" : read.error().text().c_str());
        QVERIFY2(told.ok(), told.ok() ? "" : told.error().text().c_str());
        for (const FileContents* contents : {&*read, &*told}) {
            QTEST(arraysTold(*contents), "arrays");
            QTEST(blocksTold(*contents), "blocks");
            QTEST(takenOf(contents->taken), "taken");
        }
        QVERIFY(read->arrays.front().range && !told->arrays.front().range);
        QVERIFY(told->domain == read->domain && told->lattice.size == read->lattice.size);
        QCOMPARE(told->points, read->points);
        QCOMPARE(told->cells, read->cells);
        QCOMPARE(told->timeSteps, read->timeSteps);
        QCOMPARE(leftOutOf(told->leftOut), leftOutOf(read->leftOut));
        QVERIFY(told->untold == read->untold);
    }

    void partsAndArraysThatAreNotThere()
    {
        const auto told =
            builtVtkReader().probe(enlarged(folder_.path() / "mesh.cgns"), {{"part", std::string("x")}}, {});
        QVERIFY2(told.ok(), told.ok() ? "" : told.error().text().c_str());
        QCOMPARE(blocksTold(*told), QString("Solid, Fluid"));
        QVERIFY(told->taken.empty());
    }

    void theUnitIsThatOfTheModel()
    {
        const auto dataset =
            builtVtkReader().read(folder_.path() / "steps.cgns", {{"array", std::string("Density")}}, {});
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QVERIFY2(takenOf(dataset->source.taken).endsWith("unit of the values: kg/m^3"),
                 qPrintable(takenOf(dataset->source.taken)));
    }

    /// What cannot be told is said.
    void headersThatAreNotRead()
    {
        const auto dataset = builtVtkReader().read(folder_.path() / "odd.cgns", {}, {});
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QVERIFY2(leftOutOf(dataset->source.leftOut).contains("Its units are not known"),
                 qPrintable(leftOutOf(dataset->source.leftOut)));
    }

private:
    /// The same file, as long as one that is not read to tell what it holds; HDF5 does not mind what lies behind.
    static std::filesystem::path enlarged(const std::filesystem::path& file)
    {
        const std::filesystem::path large = file.parent_path() / ("large_" + file.filename().string());
        std::filesystem::copy_file(file, large, std::filesystem::copy_options::overwrite_existing);
        std::filesystem::resize_file(large, 65ULL << 20U);
        return large;
    }

    VtkFolder folder_;
};

QTEST_GUILESS_MAIN(CgnsHeadersTest)
#include "cgns_headers_test.moc"
