// SPDX-License-Identifier: GPL-3.0-or-later
// What vtkTAnReader gives to VTK is what `tan extract` writes, as VTK's own reader reads it.
#include "tests/app/program.h"

#include <vtkTAnReader.h>

#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkTetra.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <QFile>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

using namespace tetra;

namespace {

using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

/// Differences of two arrays, in a word or two; empty if they are the same.
QString differenceOf(vtkDataArray* found, vtkDataArray* expected)
{
    if (found == nullptr || expected == nullptr)
        return "missing";
    if (found->GetNumberOfTuples() != expected->GetNumberOfTuples() ||
        found->GetNumberOfComponents() != expected->GetNumberOfComponents())
        return "another size";
    for (vtkIdType i = 0; i < found->GetNumberOfTuples(); ++i)
        for (int c = 0; c < found->GetNumberOfComponents(); ++c)
            if (found->GetComponent(i, c) != expected->GetComponent(i, c))
                return QString("tuple %1: %2, not %3")
                    .arg(i)
                    .arg(found->GetComponent(i, c), 0, 'g', 17)
                    .arg(expected->GetComponent(i, c), 0, 'g', 17);
    return {};
}

std::array<vtkIdType, 4> cornersOf(vtkUnstructuredGrid& grid, vtkIdType cell)
{
    vtkNew<vtkIdList> corners;
    grid.GetCellPoints(cell, corners);
    return {corners->GetId(0), corners->GetId(1), corners->GetId(2), corners->GetId(3)};
}

double volumeOf(vtkUnstructuredGrid& grid, vtkIdType cell)
{
    std::array<std::array<double, 3>, 4> at{};
    const auto corners = cornersOf(grid, cell);
    for (std::size_t i = 0; i < 4; ++i)
        grid.GetPoint(corners[i], at[i].data());
    return vtkTetra::ComputeVolume(at[0].data(), at[1].data(), at[2].data(), at[3].data());
}

double volumeOf(vtkUnstructuredGrid& grid)
{
    double sum = 0;
    for (vtkIdType cell = 0; cell < grid.GetNumberOfCells(); ++cell)
        sum += std::abs(volumeOf(grid, cell));
    return sum;
}

bool isGhost(vtkUnstructuredGrid& grid, vtkIdType cell)
{
    const vtkUnsignedCharArray* const marks = grid.GetCellGhostArray();
    return marks != nullptr && const_cast<vtkUnsignedCharArray*>(marks)->GetValue(cell) != 0;
}

/// How many cells of a grid have each face, by the places of its corners.
std::map<std::set<std::array<double, 3>>, int> facesOf(vtkUnstructuredGrid& grid, bool ownedOnly)
{
    std::map<std::set<std::array<double, 3>>, int> faces;
    for (vtkIdType cell = 0; cell < grid.GetNumberOfCells(); ++cell) {
        if (ownedOnly && isGhost(grid, cell))
            continue;
        const auto corners = cornersOf(grid, cell);
        for (std::size_t without = 0; without < 4; ++without) {
            std::set<std::array<double, 3>> face;
            for (std::size_t i = 0; i < 4; ++i)
                if (i != without) {
                    std::array<double, 3> place{};
                    grid.GetPoint(corners[i], place.data());
                    face.insert(place);
                }
            ++faces[face];
        }
    }
    return faces;
}

} // namespace

class VtkReaderTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    QString path(const QString& name) const { return folder_.filePath(name); }
    Run tan(const QStringList& words) const { return runTan(words, folder_.path()); }

    vtkSmartPointer<vtkTAnReader> reader(const QString& model) const
    {
        auto made = vtkSmartPointer<vtkTAnReader>::New();
        made->SetFileName(path(model).toUtf8().constData());
        return made;
    }

private slots:
    /// A lattice at an angle, a curvilinear grid, an irregular mesh, and a lattice of logarithms.
    void initTestCase()
    {
        const auto made = [&](const QStringList& words) {
            const Run run = tan(words);
            QVERIFY2(run.exitCode == 0, run.messages.constData());
        };
        made({"sample", "c60", "--size", "16", "-o", "c60.nrrd"});
        // At an angle, in millimetres.
        QFile nrrd(path("c60.nrrd"));
        QVERIFY(nrrd.open(QIODevice::ReadOnly));
        QByteArray content = nrrd.readAll();
        nrrd.close();
        static const QRegularExpression directions("space directions:[^\n]*\n");
        const QRegularExpressionMatch line = directions.match(QString::fromLatin1(content.left(500)));
        QVERIFY(line.hasMatch());
        content.replace(line.capturedStart(), line.capturedLength(),
                        "space directions: (0.6,0.8,0) (-0.8,0.6,0) (0,0,1)\n"
                        "space units: \"mm\" \"mm\" \"mm\"\n");
        QVERIFY(nrrd.open(QIODevice::WriteOnly) && nrrd.write(content) == content.size());
        nrrd.close();
        made({"build", "c60.nrrd", "-o", "c60.tan"});
        made({"sample", "bent-duct", "--size", "10", "-o", "duct.xyz"});
        made({"build", "duct.xyz", "-o", "duct.tan"});
        made({"sample", "part", "--size", "12", "-o", "part.vtu"});
        made({"build", "part.vtu", "-o", "part.tan"});
        QFile table(path("decades.csv"));
        QVERIFY(table.open(QIODevice::WriteOnly));
        table.write("x,y,z,nut\n");
        for (int i = 0; i < 216; ++i)
            table.write(
                QString("%1,%2,%3,%4\n").arg(i % 6).arg(i / 6 % 6).arg(i / 36).arg(std::pow(10, i % 7)).toUtf8());
        table.close();
        made({"build", "decades.csv", "--scale", "log", "-o", "logs.tan"});
    }

    void meshesAreThoseOfExtract_data()
    {
        QTest::addColumn<QString>("model");
        QTest::addColumn<double>("error");
        for (const char* model : {"c60", "duct", "part", "logs"})
            for (const double error : {4.0, 1.0, 0.0})
                QTest::addRow("%s %g", model, error) << QString(model) << error;
    }
    void meshesAreThoseOfExtract()
    {
        QFETCH(const QString, model);
        QFETCH(const double, error);
        const Run run = tan({"extract", model + ".tan", "--error", QString::number(error), "-o", "mesh.vtu"});
        QVERIFY2(run.exitCode == 0, run.messages.constData());
        vtkNew<vtkXMLUnstructuredGridReader> file;
        file->SetFileName(path("mesh.vtu").toUtf8().constData());
        file->Update();
        vtkUnstructuredGrid& expected = *file->GetOutput();
        const auto source = reader(model + ".tan");
        source->SetError(error);
        source->Update();
        vtkUnstructuredGrid& found = *source->GetOutput();
        QVERIFY(found.GetNumberOfCells() > 0);
        QCOMPARE(found.GetNumberOfCells(), expected.GetNumberOfCells());
        QCOMPARE(differenceOf(found.GetPoints()->GetData(), expected.GetPoints()->GetData()), QString());
        for (vtkIdType cell = 0; cell < found.GetNumberOfCells(); ++cell)
            QVERIFY(found.GetCellType(cell) == VTK_TETRA && cornersOf(found, cell) == cornersOf(expected, cell));
        QVERIFY(expected.GetPointData()->GetNumberOfArrays() > 0);
        for (int i = 0; i < expected.GetPointData()->GetNumberOfArrays(); ++i) {
            const char* const name = expected.GetPointData()->GetArrayName(i);
            const QString different =
                differenceOf(found.GetPointData()->GetArray(name), expected.GetPointData()->GetArray(name));
            QVERIFY2(different.isEmpty(), qPrintable(QString(name) + ": " + different));
        }
        QVERIFY(found.GetPointData()->GetScalars() != nullptr);
        for (const char* fact : {"error", "error_scale", "reached_error"}) {
            vtkDataArray* const told = expected.GetFieldData()->GetArray(fact);
            QVERIFY2(told != nullptr, fact);
            QVERIFY2(found.GetFieldData()->GetArray(fact)->GetTuple1(0) == told->GetTuple1(0), fact);
        }
        if (model == "c60")
            QCOMPARE(found.GetFieldData()->GetAbstractArray("unit")->GetVariantValue(0).ToString(), std::string("mm"));
    }

    /// What is asked for changes from update to update of one reader.
    void queriesAreAnswered()
    {
        const auto source = reader("c60.tan");
        source->SetError(0);
        source->Update();
        const double volume = volumeOf(*source->GetOutput());
        const vtkIdType all = source->GetOutput()->GetNumberOfCells();
        source->SetBudget(all / 10);
        source->Update();
        QVERIFY(source->GetOutput()->GetNumberOfCells() <= all / 10);
        QVERIFY(std::abs(volumeOf(*source->GetOutput()) - volume) < 1e-6 * volume);
        source->SetBudget(0);
        source->SetError(20);
        source->Update();
        const vtkIdType coarse = source->GetOutput()->GetNumberOfCells();
        source->SetFocus(true);
        std::array<double, 3> centre{};
        source->GetOutput()->GetCenter(centre.data());
        source->SetFocusCentre(centre.data());
        source->SetFocusRadius(6);
        source->SetFocusError(0.5);
        source->Update();
        QVERIFY(source->GetOutput()->GetNumberOfCells() > coarse && source->GetOutput()->GetNumberOfCells() < all);
        source->SetFocus(false);
        source->SetRegion(true);
        source->SetRegionBounds(-2, 3, 6, 9, 4, 8);
        source->SetRegionBorder(2);
        source->Update();
        QVERIFY(std::abs(volumeOf(*source->GetOutput()) - 5 * 3 * 4) < 1e-6);
    }

    /// Pieces have all of the mesh once, and with a layer of ghosts each cell has all of its neighbours.
    void piecesMakeTheMesh_data()
    {
        QTest::addColumn<int>("pieces");
        for (const int pieces : {2, 3, 7})
            QTest::addRow("%d", pieces) << pieces;
    }
    void piecesMakeTheMesh()
    {
        QFETCH(const int, pieces);
        const auto source = reader("c60.tan");
        source->Update();
        Grid whole = Grid::New();
        whole->DeepCopy(source->GetOutput());
        const auto facesOfWhole = facesOf(*whole, false);
        vtkIdType cells = 0, points = 0;
        double volume = 0;
        for (int piece = 0; piece < pieces; ++piece) {
            source->UpdatePiece(piece, pieces, 1);
            vtkUnstructuredGrid& part = *source->GetOutput();
            vtkIdType own = 0;
            for (vtkIdType cell = 0; cell < part.GetNumberOfCells(); ++cell)
                if (!isGhost(part, cell)) {
                    ++own;
                    volume += std::abs(volumeOf(part, cell));
                }
            QVERIFY(std::abs(own - whole->GetNumberOfCells() / pieces) <= pieces);
            cells += own;
            vtkUnsignedCharArray* const marks = part.GetPointGhostArray();
            for (vtkIdType point = 0; point < part.GetNumberOfPoints(); ++point)
                points += marks->GetValue(point) == 0 ? 1 : 0;
            const auto faces = facesOf(part, false);
            for (const auto& [face, count] : facesOf(part, true))
                QVERIFY(faces.at(face) == facesOfWhole.at(face));
        }
        QCOMPARE(cells, whole->GetNumberOfCells());
        QCOMPARE(points, whole->GetNumberOfPoints());
        QVERIFY(std::abs(volume - volumeOf(*whole)) < 1e-6 * volume);
    }

    void whatIsWrongIsSaid()
    {
        const auto said = [](vtkTAnReader& source) {
            std::string text;
            vtkNew<vtkCallbackCommand> listener;
            listener->SetClientData(&text);
            listener->SetCallback([](vtkObject*, unsigned long, void* into, void* error) {
                *static_cast<std::string*>(into) += static_cast<const char*>(error);
            });
            source.AddObserver("ErrorEvent", listener);
            source.Update();
            return QString::fromStdString(text);
        };
        const QString missing = said(*reader("none.tan"));
        QVERIFY2(missing.contains("none.tan") && missing.contains("No such file"), qPrintable(missing));
        QFile other(path("other.tan"));
        QVERIFY(other.open(QIODevice::WriteOnly) && other.write("nothing") > 0);
        other.close();
        QVERIFY(!said(*reader("other.tan")).isEmpty());
        QCOMPARE(vtkTAnReader::CanReadFile(path("other.tan").toUtf8().constData()), 0);
        QCOMPARE(vtkTAnReader::CanReadFile(path("c60.tan").toUtf8().constData()), 1);
        const auto tight = reader("c60.tan");
        tight->SetBudget(1);
        const QString budget = said(*tight);
        QVERIFY2(budget.contains("budget"), qPrintable(budget));
    }
};

QTEST_GUILESS_MAIN(VtkReaderTest)
#include "vtk_reader_test.moc"
