// SPDX-License-Identifier: GPL-3.0-or-later
// The real datasets have the numbers of their description (R1, S6). Skipped without them.
#include "tests/lacks.h"
#include "tests/plugins/readers/vtk/vtk_test_files.h"

#include <QTest>

using namespace tetra;

class VtkRealDataTest : public QObject {
    Q_OBJECT

private slots:
    void numbersAreThoseOfTheDescription_data();
    void numbersAreThoseOfTheDescription();
};

void VtkRealDataTest::numbersAreThoseOfTheDescription_data()
{
    QTest::addColumn<QString>("array");
    QTest::addColumn<QString>("kind");
    QTest::addColumn<int>("points");
    QTest::addColumn<int>("cells");
    QTest::addColumn<double>("smallest");
    QTest::addColumn<double>("largest");
    const auto row = [](const char* file, const char* array, const char* kind, int points, int cells, double smallest,
                        double largest) {
        QTest::addRow("%s %s", file, array)
            << QString(array) << QString(kind) << points << cells << smallest << largest;
    };
    row("bluntfin/bluntfin.vts", "automatic", "curvilinear", 40960, 37479, 0.1926, 4.9775);
    row("bluntfin/bluntfin.vts", "pressure", "curvilinear", 40960, 37479, 0.2595, 10.0127);
    row("bluntfin/bluntfin.vts", "velocity_magnitude", "curvilinear", 40960, 37479, 0, 3.1229);
    row("bluntfin/bluntfin_density.vtk", "automatic", "curvilinear", 40960, 37479, 0.1926, 4.9775);
    row("bluntfin/bluntfin_tet.vtu", "automatic", "irregular", 40921, 187318, 0.1926, 4.9775);
    row("post/post.vts", "automatic", "curvilinear", 109744, 102675, -0.2166, 1.7583);
    row("post/post.vts", "velocity_magnitude", "curvilinear", 109744, 102675, 0, 1.3914);
    row("post/post_pressure.vtk", "automatic", "curvilinear", 109744, 102675, -0.2166, 1.7583);
    row("post/post_tet.vtu", "automatic", "irregular", 108300, 616050, -0.2166, 1.7583);
    // The two sides of its seam are cut differently: with its points joined it touches itself in 157 edges (C10).
    row("post/post_near_tet.vtk", "automatic", "irregular", 2200, 8750, 0.35537, 1.64124);
    row("regular/ironProt.vtk", "automatic", "regular", 314432, 300763, 0, 255);
    row("regular/hydrogen.vti", "automatic", "regular", 262144, 250047, 0, 1);
    row("irregular/spx.vtu", "automatic", "irregular", 2896, 12935, 0.2, 1);
    row("irregular/spx.vtk", "automatic", "irregular", 2896, 12935, 0.2, 1);
    row("irregular/bracket_57k.vtu", "automatic", "irregular", 16468, 56786, 0.014369, 20.8720);
    row("irregular/bracket_454k.vtu", "automatic", "irregular", 102578, 454288, 0.014369, 23.2680);
    row("irregular/disk_out_ref.ex2", "Temp", "irregular", 8499, 7472 * 6, 293.15, 913.15);
    row("irregular/disk_out_ref.ex2", "Pres", "irregular", 8499, 7472 * 6, 0.0067855, 0.0288185);
    row("irregular/disk_out_ref_tet.vtu", "automatic", "irregular", 8499, 44832, 293.15, 913.15);
    row("irregular/disk_out_ref_tet.vtu", "Pres", "irregular", 8499, 44832, 0.0067855, 0.0288185);
    row("scattered/probes.vtp", "automatic", "scattered", 245, 0, 10, 270);
}

void VtkRealDataTest::numbersAreThoseOfTheDescription()
{
    QFETCH(QString, array);
    QFETCH(QString, kind);
    QFETCH(int, points);
    QFETCH(int, cells);
    QFETCH(double, smallest);
    QFETCH(double, largest);
    const QString file = QString(QTest::currentDataTag()).section(' ', 0, 0);
    const auto path = std::filesystem::path(TAN_SOURCE_DIR) / "../shared/data" / file.toStdString();
    if (!std::filesystem::exists(path))
        QSKIP_WITHOUT("data");
    const auto dataset = readerOf(path).read(path, {{"array", array.toStdString()}}, {});
    QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
    QCOMPARE(QString::fromStdString(std::string(domainClassName(dataset->domain))), kind);
    QCOMPARE(dataset->pointCount(), std::uint64_t(points));
    if (dataset->domain == DomainClass::Irregular)
        QCOMPARE(dataset->tetrahedra->size(), std::size_t(cells));
    else if (dataset->domain != DomainClass::Scattered)
        QCOMPARE(dataset->lattice.cellCount(), std::uint64_t(cells));
    const double slack = 6e-5 * std::max(1., std::abs(largest));
    QVERIFY(std::abs(dataset->values.range().minimum - smallest) < slack);
    QVERIFY(std::abs(dataset->values.range().maximum - largest) < slack);

    const auto contents = readerOf(path).probe(path, {}, {});
    QVERIFY2(contents.ok(), contents.ok() ? "" : contents.error().text().c_str());
    QVERIFY(!contents->arrays.empty());
    if (contents->domain)
        QVERIFY(*contents->domain == dataset->domain);
}

QTEST_GUILESS_MAIN(VtkRealDataTest)
#include "vtk_real_data_test.moc"
