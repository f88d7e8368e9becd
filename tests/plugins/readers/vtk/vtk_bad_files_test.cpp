// SPDX-License-Identifier: GPL-3.0-or-later
// Damaged files of the VTK formats end in an error that names the file, or in a dataset that is one (S6, S20).
#include "tests/plugins/readers/vtk/vtk_test_files.h"

#include <QFile>
#include <QTest>

using namespace tetra;

namespace {

const std::filesystem::path data = std::filesystem::path(TAN_SOURCE_DIR) / "../shared/data";

bool isWhole(const Dataset& dataset)
{
    const std::uint64_t points = dataset.values.count();
    const bool positions = dataset.positions == nullptr || dataset.positions->size() == points;
    const bool tetrahedra =
        dataset.domain != DomainClass::Irregular || (dataset.tetrahedra != nullptr && !dataset.tetrahedra->empty());
    return points > 0 && dataset.values.notFiniteCount() == 0 && positions && tetrahedra;
}

/// Every change is one that a file may not have.
std::vector<BadFile> wrong(const QByteArray& name, const QByteArray& good,
                           const std::vector<std::pair<QByteArray, QByteArray>>& changes)
{
    std::vector<BadFile> files;
    for (const auto& [from, to] : changes)
        files.push_back({from.left(30) + " -> " + to.left(30), name, with(good, from, to)});
    return files;
}

std::vector<BadFile> wrongFiles()
{
    std::vector<BadFile> all;
    const auto add = [&](const std::vector<BadFile>& files) { all.insert(all.end(), files.begin(), files.end()); };
    add(wrong("bad.vti", vtiText(),
              {{"0 2 0 2 0 2", "0 2 0 2 0 0"},
               {"0 2 0 2 0 2\" Origin", "0 2000000 0 2000000 0 2000000\" Origin"},
               {"0 2 0 2 0 2", "0 -2 0 2 0 2"},
               {"Spacing=\"0.5 1 2\"", "Spacing=\"0 1 2\""},
               {"Spacing=\"0.5 1 2\"", "Spacing=\"nan 1 2\""},
               {"Spacing=\"0.5 1 2\"", "Spacing=\"1 2\""},
               {"Origin=\"1 2 3\"", "Origin=\"1e300 2 3\""},
               {"type=\"ImageData\"", "type=\"Table\""},
               {"type=\"ImageData\"", "type=\"PolyData\""}}));
    add(wrong("bad.vts", vtsText(),
              {{"0 2 0 2 0 2", "0 3 0 2 0 2"},
               {"Float32\" Name=\"Points\"", "Float32\" Name=\"Points\" offset=\"99\""},
               {"NumberOfComponents=\"3\"", "NumberOfComponents=\"2\""},
               {"0 0 0\n", "nan 0 0\n"},
               {"Points>", "Pints>"}}));
    add(wrong("bad.vtu", vtuText(),
              {{"NumberOfPoints=\"5\"", "NumberOfPoints=\"500000000000\""},
               {"NumberOfPoints=\"5\"", "NumberOfPoints=\"-5\""},
               {"NumberOfCells=\"2\"", "NumberOfCells=\"99\""},
               {"4 1 2 3", "4 1 2 300"},
               {"4 1 2 3", "4 1 2 -3"},
               {">4 8<", ">4 9000<"},
               {">4 8<", ">8 4<"},
               {">10 10<", ">10 42<"},
               {">10 10<", ">10 71<"},
               {">10 10<", ">10 250<"},
               {">10 10<", ">12 12<"},
               {"0 0 0 1 0 0", "0 0 0 inf 0 0"}}));
    add(wrong("bad.vtp", vtpText(),
              {{"NumberOfPoints=\"5\"", "NumberOfPoints=\"99999999999\""},
               {"NumberOfPoints=\"5\"", "NumberOfPoints=\"0\""},
               {"0 0 0 1 0 0", "0 0 0 nan 0 0"},
               {"<PointData", "<PointDatum"},
               {"Float32\" Name=\"value\"", "String\" Name=\"value\""}}));
    add(wrong("bad.vtk", legacyText(),
              {{"DIMENSIONS 3 3 3", "DIMENSIONS 3 3 1"},
               {"DIMENSIONS 3 3 3", "DIMENSIONS -3 3 3"},
               {"DIMENSIONS 3 3 3", "DIMENSIONS 2000000 2000000 2000000"},
               {"DIMENSIONS 3 3 3", "DIMENSIONS a b c"},
               {"SPACING 0.5", "SPACING 0"},
               {"POINT_DATA 27", "POINT_DATA 999999999999"},
               {"POINT_DATA 27", "POINT_DATA 12"},
               {"value float 1", "value float 99"},
               {"value float 1", "value quaternion 1"},
               {"STRUCTURED_POINTS", "TEAPOTS"}}));
    add(wrong("mesh.vtk", legacyMeshText(),
              {{"POINTS 5", "POINTS 500000000000"},
               {"POINTS 5", "POINTS -1"},
               {"CELLS 2 10", "CELLS 2 1000000000000"},
               {"CELLS 2 10", "CELLS 2000000000 10"},
               {"4 4 1 2 3", "4 4 1 2 33"},
               {"4 4 1 2 3", "400 4 1 2 3"},
               {"4 4 1 2 3", "-4 4 1 2 3"},
               {"CELL_TYPES 2\n10", "CELL_TYPES 2\n99"}}));
    return all;
}

} // namespace

class VtkBadFilesTest : public QObject {
    Q_OBJECT

private slots:
    void theGoodOnesAreRead_data()
    {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<QByteArray>("content");
        QTest::newRow("vti") << QByteArray("good.vti") << vtiText();
        QTest::newRow("vts") << QByteArray("good.vts") << vtsText();
        QTest::newRow("vtu") << QByteArray("good.vtu") << vtuText();
        QTest::newRow("vtp") << QByteArray("good.vtp") << vtpText();
        QTest::newRow("vtk") << QByteArray("good.vtk") << legacyText();
        QTest::newRow("vtk of cells") << QByteArray("mesh.vtk") << legacyMeshText();
    }
    void theGoodOnesAreRead()
    {
        QFETCH(QByteArray, name);
        QFETCH(QByteArray, content);
        const auto dataset = builtVtkReader().read(folder_.write(name, content), {}, {});
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text.c_str());
        QVERIFY(isWhole(*dataset));
    }

    /// What cannot be right is refused.
    void wrongFilesAreRefused()
    {
        QStringList accepted;
        for (const BadFile& file : wrongFiles()) {
            const auto dataset = builtVtkReader().read(folder_.write(file.name, file.content), {}, {});
            if (dataset)
                accepted << file.name + ": " + file.what;
            else
                QVERIFY2(dataset.error().text.find(file.name.toStdString()) != std::string::npos,
                         dataset.error().text.c_str());
        }
        QVERIFY2(accepted.isEmpty(), qPrintable("\n" + accepted.join('\n')));
    }

    /// What may be right by chance is read or refused, for every cut and change.
    void damagedFilesAreReadOrRefused_data()
    {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<QByteArray>("content");
        QTest::newRow("vti") << QByteArray("bad.vti") << vtiText();
        QTest::newRow("vts") << QByteArray("bad.vts") << vtsText();
        QTest::newRow("vtu") << QByteArray("bad.vtu") << vtuText();
        QTest::newRow("vtp") << QByteArray("bad.vtp") << vtpText();
        QTest::newRow("vtk") << QByteArray("bad.vtk") << legacyText();
        QTest::newRow("vtk of cells") << QByteArray("bad.vtk") << legacyMeshText();
        for (const char* name : {"regular/hydrogen.vti", "irregular/disk_out_ref.ex2", "irregular/spx.vtu"}) {
            QFile file(QString::fromStdString((data / name).string()));
            if (file.open(QIODevice::ReadOnly))
                QTest::newRow(name) << "bad" + QByteArray(std::filesystem::path(name).extension().c_str())
                                    << file.readAll();
        }
    }
    void damagedFilesAreReadOrRefused()
    {
        QFETCH(QByteArray, name);
        QFETCH(QByteArray, content);
        for (const BadFile& file : damaged(name, content)) {
            const auto dataset = builtVtkReader().read(folder_.write(file.name, file.content), {}, {});
            if (dataset)
                QVERIFY2(isWhole(*dataset), file.what.constData());
            else
                QVERIFY2(dataset.error().text.find(file.name.toStdString()) != std::string::npos,
                         dataset.error().text.c_str());
        }
    }

private:
    VtkFolder folder_;
};

QTEST_GUILESS_MAIN(VtkBadFilesTest)
#include "vtk_bad_files_test.moc"
