// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cells/cell_complex.h"
#include "core/cells/cell_orientation.h"
#include "tests/core/cells/reference_cells.h"

#include <QTest>

#include <numeric>

using namespace tetra;

namespace {

double totalVolume(const Dataset& dataset)
{
    double volume = 0;
    for (const auto& tetrahedron : *dataset.tetrahedra)
        volume += volumeOf(*dataset.positions, tetrahedron);
    return volume;
}

CellComplex singleCell(CellShape shape)
{
    CellComplex complex;
    complex.positions = referenceNodes(shape);
    complex.shapes = {shape};
    complex.corners.resize(complex.positions.size());
    std::iota(complex.corners.begin(), complex.corners.end(), 0);
    if (shape == CellShape::Voxel)
        for (std::uint32_t i = 0; i < 8; ++i)
            complex.corners[i] = hexahedronCorner(i);
    complex.offsets = {0, complex.corners.size()};
    return complex;
}

} // namespace

class IrregularDatasetTest : public QObject {
    Q_OBJECT
private slots:
    /// R1.
    void everyShape()
    {
        for (int number = 0; number < static_cast<int>(CellShape::Polyhedron); ++number) {
            const auto shape = static_cast<CellShape>(number);
            const CellComplex complex = singleCell(shape);
            ComplexValues values;
            values.values.resize(complex.positions.size(), 1.5);
            const auto dataset = irregularDataset(complex, values, {.name = "cell", .path = {}, .hash = 0});
            QVERIFY2(dataset.ok(), dataset ? "" : dataset.error().text.c_str());
            QVERIFY2(dataset->remarks.empty(), dataset->remarks.empty() ? "" : dataset->remarks[0].c_str());
            QCOMPARE(6 * totalVolume(*dataset), referenceVolume6(shape));
            QCOMPARE(dataset->positions->size(), complex.positions.size());
            QCOMPARE(dataset->domain, DomainClass::Irregular);
        }
    }
};

QTEST_GUILESS_MAIN(IrregularDatasetTest)
#include "irregular_dataset_test.moc"
