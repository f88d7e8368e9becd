// SPDX-License-Identifier: GPL-3.0-or-later
// What can be chosen of a VTK file, and how its grids become datasets (R1, S6).
#include "tests/plugins/as_loaded.h"
#include "tests/plugins/readers/vtk/vtk_test_files.h"

#include <QTest>

using namespace tetra;

namespace {

const QByteArray vector = "<DataArray type=\"Float64\" Name=\"wind\" NumberOfComponents=\"2\" format=\"ascii\">";

/// The lattice with a vector besides: (3 n, 4 n) at point n.
QByteArray withVector()
{
    QByteArray values;
    for (int n = 0; n < 27; ++n)
        values += QByteArray::number(3 * n) + " " + QByteArray::number(4 * n) + " ";
    return with(vtiText(), "</PointData>", vector + values + "</DataArray></PointData>");
}

} // namespace

class VtkChoicesTest : public QObject {
    Q_OBJECT

private slots:
    void latticesKeepPlaceAndType()
    {
        const auto dataset = read(vtiText());
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QVERIFY(dataset->domain == DomainClass::RegularLattice);
        QCOMPARE(dataset->lattice.size, (std::array<std::uint32_t, 3>{3, 3, 3}));
        QCOMPARE(dataset->lattice.spacing, Eigen::Vector3d(0.5, 1, 2));
        QCOMPARE(dataset->lattice.origin, Eigen::Vector3d(1, 2, 3));
        QVERIFY(dataset->values.type() == SampleType::Float32);
        for (std::uint64_t point = 0; point < 27; ++point)
            QCOMPARE(dataset->values.at(point), double(point));
        QVERIFY(dataset->remarks.empty());
        QCOMPARE(dataset->source.name, std::string("file.vti, value"));
    }

    void componentsAndMagnitude()
    {
        const auto value = [&](const char* component) {
            const auto dataset =
                read(withVector(), {{"array", std::string("wind")}, {"component", std::string(component)}});
            return dataset ? dataset->values.at(7) : -1;
        };
        QCOMPARE(value("0"), 21.);
        QCOMPARE(value("1"), 28.);
        QCOMPARE(value("magnitude"), 35.);
        QCOMPARE(value("2"), -1.);
        const auto automatic = read(withVector());
        QCOMPARE(automatic->values.at(7), 7.);
        const auto numbered = read(withVector(), {{"array", std::string("2")}});
        QCOMPARE(numbered->values.at(7), 35.);
    }

    void unknownArraysAreRefusedWithTheList()
    {
        const auto dataset = read(vtiText(), {{"array", std::string("nothing")}});
        QVERIFY(!dataset.ok());
        QVERIFY(dataset.error().kind == ErrorKind::WrongUsage);
        QVERIFY2(dataset.error().text().find("'value', 'cells' (of cells)") != std::string::npos,
                 dataset.error().text().c_str());
    }

    /// The cells n = 0 ... 7 of a lattice of 2 x 2 x 2: corners have their cell's value, the middle the mean.
    void valuesOfCellsAreBroughtToThePoints()
    {
        const auto dataset = read(vtiText(), {{"array", std::string("cells")}});
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QCOMPARE(dataset->values.at(0), 0.);
        QCOMPARE(dataset->values.at(26), 7.);
        QCOMPARE(dataset->values.at(13), 3.5);
        QCOMPARE(dataset->values.at(1), 0.5);
        QCOMPARE(dataset->remarks.size(), std::size_t(1));
    }

    void samplesThatAreNoNumbersAreHoles()
    {
        const auto dataset = read(with(vtiText(), "25 26", "25 nan"));
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QVERIFY(dataset->domain == DomainClass::Irregular);
        QCOMPARE(dataset->values.notFiniteCount(), std::uint64_t(0));
        QCOMPARE(dataset->pointCount(), std::uint64_t(26));
    }

    void hiddenCellsAreHoles()
    {
        const QByteArray ghosts =
            "<DataArray type=\"UInt8\" Name=\"vtkGhostType\" format=\"ascii\">32 0 0 0 0 0 0 0</DataArray>";
        const auto dataset = read(with(vtiText(), "<CellData>", "<CellData>" + ghosts));
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QVERIFY(dataset->domain == DomainClass::Irregular);
        QCOMPARE(dataset->pointCount(), std::uint64_t(26));
    }

    void equalStepsAreALattice_data()
    {
        QTest::addColumn<QByteArray>("steps");
        QTest::addColumn<bool>("regular");
        QTest::newRow("equal") << QByteArray("0 0.1 0.2") << true;
        QTest::newRow("backwards") << QByteArray("0.2 0.1 0") << true;
        QTest::newRow("not equal") << QByteArray("0 0.1 0.21") << false;
    }
    void equalStepsAreALattice()
    {
        QFETCH(QByteArray, steps);
        QFETCH(bool, regular);
        const QByteArray text = "# vtk DataFile Version 3.0\nt\nASCII\nDATASET RECTILINEAR_GRID\nDIMENSIONS 3 2 2\n"
                                "X_COORDINATES 3 float\n" +
                                steps +
                                "\nY_COORDINATES 2 float\n0 1\nZ_COORDINATES 2 float\n0 1\nPOINT_DATA 12\n"
                                "SCALARS v int 1\nLOOKUP_TABLE default\n0 1 2 3 4 5 6 7 8 9 10 11\n";
        const auto dataset = builtVtkReader().read(folder_.write("file.vtk", text), {}, {});
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QCOMPARE(dataset->domain == DomainClass::RegularLattice, regular);
        QVERIFY(dataset->values.type() == SampleType::Int32);
        const bool backwards = steps.startsWith("0.2");
        QCOMPARE(dataset->values.at(0), 0.);
        QCOMPARE(float(dataset->position(0)[0]), backwards ? 0.2f : 0.f);
        QCOMPARE(float(dataset->position(1)[0]), 0.1f);
        if (regular)
            QCOMPARE(dataset->lattice.isLeftHanded(), backwards);
    }

    void probingTellsWithoutReading()
    {
        const auto contents = builtVtkReader().probe(folder_.write("file.vti", withVector()), {}, {});
        QVERIFY2(contents.ok(), contents.ok() ? "" : contents.error().text().c_str());
        QVERIFY(contents->domain == DomainClass::RegularLattice);
        QCOMPARE(contents->points, std::uint64_t(27));
        QCOMPARE(contents->lattice.size, (std::array<std::uint32_t, 3>{3, 3, 3}));
        QCOMPARE(contents->lattice.spacing, Eigen::Vector3d(0.5, 1, 2));
        QCOMPARE(contents->arrays.size(), std::size_t(3));
        QCOMPARE(contents->arrays[1].name, std::string("wind"));
        QCOMPARE(contents->arrays[1].components, 2);
        QVERIFY(contents->arrays[2].perCell);
    }

    void cancellingEndsIt()
    {
        std::stop_source stop;
        stop.request_stop();
        const auto dataset = builtVtkReader().read(folder_.write("file.vti", vtiText()), {}, {stop.get_token(), {}});
        QVERIFY(!dataset.ok());
        QVERIFY(dataset.error().kind == ErrorKind::Cancelled);
    }

private:
    Result<Dataset> read(const QByteArray& vti, const ParameterValues& values = {})
    {
        return complete(builtVtkReader().read(folder_.write("file.vti", vti), values, {}));
    }

    VtkFolder folder_;
};

QTEST_GUILESS_MAIN(VtkChoicesTest)
#include "vtk_choices_test.moc"
