// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes with polyhedra become tetrahedra that fill the same volume, fit together and keep linear fields (R1); what is
// no polyhedron is refused or left out, and told (S6, S20).
#include "core/data/cells/clean_cells.h"
#include "core/data/cells/irregular_check.h"
#include "core/mesh/topology.h"
#include "tests/core/data/cells/cell_cases.h"
#include "tests/core/data/cells/polyhedral_meshes.h"

#include <tan/data.h>

#include <QTest>

#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <set>

using namespace tetra;

namespace {

double volumeOf(const Dataset& dataset)
{
    double volume = 0;
    for (const auto& [a, b, c, d] : *dataset.tetrahedra) {
        const auto& places = *dataset.positions;
        volume += (places[b] - places[a]).dot((places[c] - places[a]).cross(places[d] - places[a])) / 6;
    }
    return volume;
}

double linear(const Eigen::Vector3d& place)
{
    return place.dot(Eigen::Vector3d(1, 2, 4));
}

/// What is wrong with a dataset that is to fill a volume and to have linearValues(); empty if nothing is.
QString mistakes(const Result<Dataset>& dataset, double volume)
{
    if (!dataset)
        return QString::fromStdString(dataset.error().text());
    if (const Status sound = checkIrregular(*dataset); !sound)
        return QString::fromStdString(sound.error().text());
    if (const double found = volumeOf(*dataset); std::abs(found - volume) > 1e-12 * volume)
        return QString("its volume is %1, not %2").arg(found, 0, 'g', 17).arg(volume, 0, 'g', 17);
    double largest = 0;
    for (const Eigen::Vector3d& place : *dataset->positions)
        largest = std::max(largest, std::abs(linear(place)));
    for (std::uint64_t point = 0; point < dataset->pointCount(); ++point)
        if (std::abs(dataset->values.at(point) - linear(dataset->position(point))) > 1e-14 * largest)
            return QString("point %1 has another value").arg(point);
    return {};
}

/// The area of the boundary where `isThere` says so of its corners.
double boundaryArea(const Dataset& dataset, const std::function<bool(const Eigen::Vector3d&)>& isThere)
{
    std::map<Triangle, int> counts;
    for (const auto& t : *dataset.tetrahedra)
        for (const auto& face : cornersOfFace) {
            Triangle key = {t[face[0]], t[face[1]], t[face[2]]};
            std::ranges::sort(key);
            ++counts[key];
        }
    double area = 0;
    for (const auto& [face, count] : counts) {
        const auto& places = *dataset.positions;
        if (count == 1 && std::ranges::all_of(face, [&](std::uint32_t corner) { return isThere(places[corner]); }))
            area += (places[face[1]] - places[face[0]]).cross(places[face[2]] - places[face[0]]).norm() / 2;
    }
    return area;
}

bool says(const Dataset& dataset, const QString& text)
{
    return remarksOf(dataset).contains(text);
}

/// Six times the volume within faces that all look outwards, or all inwards.
double volume6Within(const std::vector<Eigen::Vector3d>& places, const PolyhedronFaces& triangles)
{
    double volume = 0;
    for (const auto& face : triangles)
        volume += places[face[0]].dot(places[face[1]].cross(places[face[2]]));
    return std::abs(volume);
}

CellComplex oneCell(const std::vector<Eigen::Vector3d>& places, const PolyhedronFaces& faces)
{
    CellComplex complex;
    complex.positions = places;
    for (const auto& face : faces) {
        complex.corners.push_back(face.size());
        complex.corners.insert(complex.corners.end(), face.begin(), face.end());
    }
    complex.shapes = {CellShape::Polyhedron};
    complex.offsets = {0, complex.corners.size()};
    return complex;
}

const std::vector<Eigen::Vector3d>& cubePlaces()
{
    static const std::vector<Eigen::Vector3d> places = referenceNodes(CellShape::Hexahedron);
    return places;
}

PolyhedronFaces cubeFaces()
{
    return facesOfCell(CellShape::Hexahedron, std::vector<std::uint64_t>{0, 1, 2, 3, 4, 5, 6, 7});
}

/// A tower of cubes of volume 8 as polyhedra, and what is to be tried as the last cell, with points of its own.
CellComplex beside(const CellComplex& last, int cubes)
{
    PolyhedralMesh mesh(1);
    for (int k = 0; k < cubes; ++k) {
        std::vector<std::uint64_t> corners;
        for (const Eigen::Vector3d& place : cubePlaces())
            corners.push_back(mesh.point(place + Eigen::Vector3d(10, 0, 2 * k)));
        mesh.add(facesOfCell(CellShape::Hexahedron, corners));
    }
    CellComplex complex = mesh.inOrder();
    const std::uint64_t first = complex.positions.size();
    complex.positions.insert(complex.positions.end(), last.positions.begin(), last.positions.end());
    std::uint64_t pointsLeft = 0;
    for (const std::uint64_t corner : last.corners) {
        complex.corners.push_back(pointsLeft == 0 ? corner : first + corner);
        pointsLeft = pointsLeft == 0 ? corner : pointsLeft - 1;
    }
    complex.shapes.push_back(CellShape::Polyhedron);
    complex.offsets.push_back(complex.corners.size());
    return complex;
}

} // namespace

class PolyhedraTest : public QObject {
    Q_OBJECT
private slots:
    /// Hexahedra, prisms and pyramids whose faces are not flat, all of them or half as polyhedra: they agree with one
    /// another and with the others on each face.
    void besideOtherCells()
    {
        for (std::uint32_t seed = 0; seed < 8; ++seed) {
            const RandomCells cells({1 + seed % 4, 2, 3}, 0.1, seed, RandomCells::Kinds::NoTetrahedra);
            for (const std::uint32_t every : {1U, 2U})
                for (const bool centres : {false, true}) {
                    CellComplex complex = withPolyhedra(cells.complex(), every, seed);
                    complex.addsCentres = centres;
                    const auto dataset = datasetOf(complex, linearValues(complex));
                    const QString wrong = mistakes(dataset, cells.volume());
                    QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
                    QVERIFY(says(*dataset, "were cut into tetrahedra."));
                    QVERIFY(!says(*dataset, "left out"));
                }
        }
    }

    /// Of cubes of volume 8 some are eight: what lies between is cut through all points, and what no tetrahedra fill
    /// gets a point in the middle, or is left out whole.
    void refinedHexahedra_data()
    {
        QTest::addColumn<int>("size");
        QTest::addColumn<std::function<bool(int, int, int)>>("isFine");
        const auto row = [](const char* name, int size, const std::function<bool(int, int, int)>& isFine) {
            QTest::newRow(name) << size << isFine;
        };
        row("a half", 3, [](int i, int, int) { return i < 2; });
        row("a ball", 4, [](int i, int j, int k) { return i * i + j * j + k * k < 7; });
        row("here and there", 4, [](int i, int j, int k) { return (3 * i + 5 * j + 7 * k + i * j * k) % 4 == 0; });
    }
    void refinedHexahedra()
    {
        QFETCH(const int, size);
        QFETCH(const std::function<bool(int, int, int)>, isFine);
        const double volume = 8.0 * size * size * size;
        std::uint32_t left = 0;
        for (std::uint32_t seed = 0; seed < 2; ++seed) {
            CellComplex complex = refinedCubes(size, seed, isFine).complex();
            complex.addsCentres = true;
            const auto whole = datasetOf(complex, linearValues(complex));
            const QString wrong = mistakes(whole, volume);
            QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
            QVERIFY(!whole->faultyCells);
            // No seam anywhere: the boundary is that of the box.
            QVERIFY(std::abs(boundaryArea(*whole, [](const auto&) { return true; }) - 24.0 * size * size) < 1e-9);
            QVERIFY(whole->convex);
            const std::uint64_t centres = whole->pointCount() - complex.positions.size();
            QVERIFY(centres == 0 || says(*whole, QString("%1 of them got a point in the middle.").arg(centres)));

            complex.addsCentres = false;
            complex.mostFaulty = 1;
            const auto holes = datasetOf(complex, linearValues(complex));
            QVERIFY2(holes.ok(), holes ? "" : holes.error().text().c_str());
            const std::size_t faulty = holes->faultyCells ? holes->faultyCells->size() : 0;
            const QString wrongBeside = mistakes(holes, volume - 8.0 * double(faulty));
            QVERIFY2(wrongBeside.isEmpty(), qPrintable(wrongBeside));
            QVERIFY(faulty <= centres); // a search may find what no corner sees
            if (faulty == 0)
                continue;
            ++left;
            QCOMPARE(holes->faultyCells->front().fault, CellFault::Warped);
            QVERIFY(says(*holes, QString("no tetrahedra between their own points fill them: %1.").arg(faulty)));
            complex.mostFaulty = 0.001;
            const auto refused = datasetOf(complex, linearValues(complex));
            QVERIFY(!refused.ok());
            const QString text = QString::fromStdString(refused.error().text());
            QVERIFY2(text.startsWith(QString("%1 of the mesh's").arg(faulty)) && text.contains("more than 0.1%") &&
                         text.contains("'--polyhedra centre'") && text.contains("'--faulty "),
                     qPrintable(text));
        }
        QVERIFY(left > 0);
    }

    /// Hexagons and squares, no new point needed.
    void truncatedOctahedraNeedNoPoint()
    {
        for (std::uint32_t seed = 0; seed < 4; ++seed) {
            std::uint32_t cells = 0;
            CellComplex complex = truncatedOctahedra(3, seed, cells).complex();
            for (const bool centres : {false, true}) {
                complex.addsCentres = centres;
                const auto dataset = datasetOf(complex, linearValues(complex));
                const QString wrong = mistakes(dataset, 32.0 * cells);
                QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
                QCOMPARE(dataset->pointCount(), complex.positions.size());
                QCOMPARE(remarksOf(*dataset), QString("%1 polyhedra were cut into tetrahedra. ").arg(cells));
            }
        }
    }

    /// Each polyhedron with points of its own, as some programs write them: joined by their places first.
    void pointsOnOnePlaceAreJoined()
    {
        std::uint32_t cells = 0;
        const CellComplex joined = truncatedOctahedra(2, 5, cells).complex();
        CellComplex apart = joined;
        apart.positions.clear();
        for (std::size_t cell = 0; cell < joined.shapes.size(); ++cell) {
            std::map<std::uint64_t, std::uint64_t> own;
            std::uint64_t pointsLeft = 0;
            for (std::uint64_t i = joined.offsets[cell]; i < joined.offsets[cell + 1]; ++i) {
                std::uint64_t& corner = apart.corners[i];
                if (pointsLeft == 0) {
                    pointsLeft = corner;
                    continue;
                }
                --pointsLeft;
                const auto [found, isNew] = own.emplace(corner, apart.positions.size());
                if (isNew)
                    apart.positions.push_back(joined.positions[corner]);
                corner = found->second;
            }
        }
        const auto dataset = datasetOf(apart, linearValues(apart));
        const QString wrong = mistakes(dataset, 32.0 * cells);
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
        QCOMPARE(dataset->pointCount(), joined.positions.size());
        QVERIFY(says(*dataset, "at the same place as another were merged"));
    }

    /// Concave cells with straight corners in their faces.
    void concaveCells()
    {
        for (std::uint32_t seed = 0; seed < 6; ++seed) {
            CellComplex complex = lShapes(3, seed).complex();
            complex.addsCentres = true;
            const auto dataset = datasetOf(complex, linearValues(complex));
            const QString wrong = mistakes(dataset, 4.0 * 27);
            QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
            QVERIFY(std::abs(boundaryArea(*dataset, [](const auto&) { return true; }) - 144) < 1e-10);
            QVERIFY(says(*dataset, "got a point in the middle."));
        }
    }

    /// Two cells with a face of which three points lie on a line: only one of its diagonals is good, and both take it,
    /// whichever the numbers ask for.
    void straightCornersOfSharedFaces()
    {
        int whole = 0;
        for (std::uint32_t seed = 0; seed < 100; ++seed) {
            PolyhedralMesh mesh(seed);
            const auto corners = [&](double far) {
                std::vector<std::uint64_t> points;
                for (const Eigen::Vector3d& place :
                     {Eigen::Vector3d(far, 0, 0), Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0, 4, 0),
                      Eigen::Vector3d(far, 4, 0), Eigen::Vector3d(far, 0, 4), Eigen::Vector3d(0, 2, 2),
                      Eigen::Vector3d(0, 4, 4), Eigen::Vector3d(far, 4, 4)})
                    points.push_back(mesh.point(place));
                return points;
            };
            if (seed % 2 == 0)
                mesh.add(CellShape::Hexahedron, corners(-4));
            else
                mesh.add(facesOfCell(CellShape::Hexahedron, corners(-4)));
            mesh.add(facesOfCell(CellShape::Hexahedron, corners(4)));
            CellComplex complex = mesh.complex();
            complex.addsCentres = true;
            const auto dataset = datasetOf(complex, linearValues(complex));
            if (!dataset)
                continue;
            ++whole;
            QVERIFY(checkIrregular(*dataset).ok());
            QCOMPARE(boundaryArea(*dataset, [](const Eigen::Vector3d& place) { return place[0] == 0; }), 0.0);
        }
        QVERIFY2(whole > 60, qPrintable(QString::number(whole)));
    }

    /// E. Schoenhardt's: no tetrahedra between its six points fill it.
    void schoenhardtsPolyhedron()
    {
        std::vector<Eigen::Vector3d> places;
        for (int layer = 0; layer < 2; ++layer)
            for (int i = 0; i < 3; ++i) {
                const double angle = 2 * std::numbers::pi / 3 * i + std::numbers::pi / 6 * layer;
                places.emplace_back(std::cos(angle), std::sin(angle), layer);
            }
        PolyhedronFaces faces = {{0, 2, 1}, {3, 4, 5}};
        for (std::uint64_t i = 0; i < 3; ++i) {
            const std::uint64_t next = (i + 1) % 3;
            faces.push_back({i, next, 3 + next});
            faces.push_back({i, 3 + next, 3 + i});
        }
        CellComplex complex = oneCell(places, faces);
        const auto refused = datasetOf(complex, linearValues(complex));
        QVERIFY(!refused.ok());
        QVERIFY2(refused.error().text().starts_with("1 of the mesh's 1 cells are polyhedra that no tetrahedra"),
                 refused.error().text().c_str());
        complex.addsCentres = true;
        const auto dataset = datasetOf(complex, linearValues(complex));
        const QString wrong = mistakes(dataset, volume6Within(places, faces) / 6);
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
        QCOMPARE(dataset->tetrahedra->size(), std::size_t(8));
        QVERIFY(says(*dataset, "1 polyhedron was cut into tetrahedra around a point in its middle."));
    }

    /// Every fan of these faces has a flat triangle: a tetrahedron's, with two points on each edge.
    void facesWithoutAFan()
    {
        PolyhedralMesh mesh(3);
        const std::vector<Eigen::Vector3d> corners = {{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 3}};
        PolyhedronFaces faces;
        for (const auto& face : cornersOfFace) {
            faces.emplace_back();
            for (std::size_t i = 0; i < 3; ++i)
                for (int step = 0; step < 3; ++step)
                    faces.back().push_back(
                        mesh.point(corners[face[i]] + (corners[face[(i + 1) % 3]] - corners[face[i]]) / 3 * step));
        }
        mesh.add(faces);
        CellComplex complex = mesh.complex();
        complex.addsCentres = true;
        const auto dataset = datasetOf(complex, linearValues(complex));
        const QString wrong = mistakes(dataset, 4.5);
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
        QCOMPARE(dataset->tetrahedra->size(), std::size_t(28));
    }

    /// The point in the middle has the value of its cell; as everywhere, points have the mean of the cells around them.
    void valuesOfCells()
    {
        CellComplex complex = refinedCubes(4, 2, [](int i, int, int) { return i < 2; }).complex();
        complex.addsCentres = true;
        const std::size_t points = complex.positions.size();
        ComplexValues values{.values = {}, .perCell = true, .type = SampleType::Float64};
        std::map<std::uint64_t, std::set<std::uint64_t>> pointsOfCells;
        for (std::size_t cell = 0; cell < complex.shapes.size(); ++cell)
            values.values.push_back(double(cell));
        const auto dataset = datasetOf(complex, values);
        QVERIFY2(dataset.ok(), dataset ? "" : dataset.error().text().c_str());
        const auto valueAround = [&](const Eigen::Vector3d& middle) { // of the cell with its corners beside the place
            std::vector<std::uint64_t> memory;
            for (std::size_t cell = 0; cell < complex.shapes.size(); ++cell) {
                if (complex.shapes[cell] != CellShape::Polyhedron)
                    continue;
                const auto own = pointsOf(complex, cell, memory);
                if (std::ranges::all_of(*own, [&](std::uint64_t point) {
                        return (complex.positions[point] - middle).cwiseAbs().maxCoeff() < 1.5;
                    }))
                    return double(cell);
            }
            return -1.0;
        };
        std::set<std::array<double, 3>> own;
        for (const Eigen::Vector3d& place : complex.positions)
            own.insert({place[0], place[1], place[2]});
        std::uint64_t middles = 0;
        for (std::uint64_t point = 0; point < dataset->pointCount(); ++point) {
            const Eigen::Vector3d place = dataset->position(point);
            if (own.contains({place[0], place[1], place[2]}))
                continue;
            ++middles;
            QCOMPARE(dataset->values.at(point), valueAround(place));
        }
        QVERIFY(middles > 0);
        QCOMPARE(dataset->pointCount(), points + middles);
    }

    /// The mean of whole numbers is none.
    void wholeNumbers()
    {
        for (const bool centres : {false, true}) {
            CellComplex complex = refinedCubes(4, 2, [](int i, int, int) { return i < 2; }).complex();
            complex.addsCentres = centres;
            complex.mostFaulty = 1;
            ComplexValues values{.values = {}, .perCell = false, .type = SampleType::UInt8};
            values.values.resize(complex.positions.size());
            for (std::size_t point = 0; point < values.values.size(); ++point)
                values.values[point] = double(point % 200);
            const auto dataset = datasetOf(complex, values);
            QVERIFY2(dataset.ok(), dataset ? "" : dataset.error().text().c_str());
            QCOMPARE(dataset->values.type(), centres ? SampleType::Float32 : SampleType::UInt8);
            QVERIFY(dataset->values.range().minimum >= 0 && dataset->values.range().maximum <= 199);
        }
    }

    /// Of a region the judgement is about the cells in it.
    void onlyTheRegionIsJudged()
    {
        CellComplex complex = beside(oneCell(cubePlaces(), {{0, 1, 2}, {0, 1, 3}, {1, 2, 3}}), 2); // it is open
        QVERIFY(!datasetOf(complex, linearValues(complex)).ok());
        complex.region = Eigen::AlignedBox3d(Eigen::Vector3d(9, -1, -1), Eigen::Vector3d(13, 3, 5));
        const auto dataset = datasetOf(complex, linearValues(complex));
        const QString wrong = mistakes(dataset, 16);
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
    }

    void notClosed_data()
    {
        QTest::addColumn<CellComplex>("cell");
        PolyhedronFaces faces = cubeFaces();
        faces.pop_back();
        QTest::newRow("a face is missing") << oneCell(cubePlaces(), faces);
        faces = cubeFaces();
        faces.push_back(faces.front());
        QTest::newRow("a face is there twice") << oneCell(cubePlaces(), faces);
        faces = cubeFaces();
        faces[0] = {0, 3, 2, 1, 3};
        QTest::newRow("a face has a point twice") << oneCell(cubePlaces(), faces);
        faces = cubeFaces();
        faces[0] = {0, 1};
        QTest::newRow("a face of two points") << oneCell(cubePlaces(), faces);
        faces = cubeFaces();
        faces[0].clear();
        QTest::newRow("a face without points") << oneCell(cubePlaces(), faces);
        std::vector<Eigen::Vector3d> places = cubePlaces();
        faces = cubeFaces();
        for (std::uint64_t i = 0; i < 8; ++i)
            places.push_back(places[i] + Eigen::Vector3d(-5, 0, 0));
        for (const auto& face : cubeFaces()) {
            faces.emplace_back();
            for (const std::uint64_t point : face)
                faces.back().push_back(point + 8);
        }
        QTest::newRow("two at once") << oneCell(places, faces);
        // Its six points are those of a cube with opposite ones joined: the projective plane, with one side.
        QTest::newRow("one side") << oneCell({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {0, 1, 1}},
                                             {{0, 1, 2},
                                              {0, 2, 3},
                                              {0, 3, 4},
                                              {0, 4, 5},
                                              {0, 5, 1},
                                              {1, 2, 4},
                                              {2, 3, 5},
                                              {3, 4, 1},
                                              {4, 5, 2},
                                              {5, 1, 3}});
        QTest::newRow("no faces") << oneCell(cubePlaces(), {});
    }
    /// Alone it is refused; as one cell of several, where that many may be faulty, left out and listed.
    void notClosed()
    {
        QFETCH(const CellComplex, cell);
        const auto alone = datasetOf(cell, linearValues(cell));
        QVERIFY(!alone.ok());
        QCOMPARE(alone.error().kind, ErrorKind::BadInput);
        QVERIFY2(alone.error().text().starts_with("The faces of 1 of the mesh's 1 cells do not enclose a volume; the "
                                                  "first is cell 0"),
                 alone.error().text().c_str());
        CellComplex complex = beside(cell, 4);
        complex.mostFaulty = 0.2;
        const auto dataset = datasetOf(complex, linearValues(complex));
        const QString wrong = mistakes(dataset, 32);
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
        QVERIFY(dataset->faultyCells && dataset->faultyCells->size() == 1);
        QCOMPARE(dataset->faultyCells->front().cell, std::uint64_t(4));
        QCOMPARE(dataset->faultyCells->front().fault, CellFault::NoVolume);
        QVERIFY(says(*dataset, "Polyhedra left out because their faces do not enclose a volume: 1."));
    }

    void flatOnesAreLeftOut()
    {
        std::vector<Eigen::Vector3d> places = cubePlaces();
        for (Eigen::Vector3d& place : places)
            place[2] = 0.5 * place[0] + 0.25 * place[1];
        for (std::size_t i = 4; i < 8; ++i)
            places[i] += Eigen::Vector3d(0.5, 0, 0.25);
        const CellComplex complex = beside(oneCell(places, cubeFaces()), 1);
        const auto dataset = datasetOf(complex, linearValues(complex));
        QVERIFY2(dataset.ok(), dataset ? "" : dataset.error().text().c_str());
        QCOMPARE(volumeOf(*dataset), 8.0);
    }

    void damagedFaces_data()
    {
        QTest::addColumn<CellComplex>("complex");
        QTest::addColumn<QString>("text");
        CellComplex complex = oneCell(cubePlaces(), cubeFaces());
        complex.corners[0] = 1000;
        QTest::newRow("too many points") << complex << "Faces of polyhedra have more points than are listed (1 in all";
        complex.corners[0] = std::uint64_t(-1);
        QTest::newRow("far too many") << complex << "Faces of polyhedra have more points than are listed (1 in all";
        complex = oneCell(cubePlaces(), cubeFaces());
        complex.corners[2] = 8;
        QTest::newRow("no such point") << complex << "Cells refer to points that do not exist (1 in all";
        complex = oneCell(cubePlaces(), cubeFaces());
        complex.positions[5][1] = std::nan("");
        QTest::newRow("no place") << complex << "not finite";
        complex = oneCell(cubePlaces(), cubeFaces());
        complex.mostFaulty = std::nan("");
        QTest::newRow("no share") << complex << "The share of cells that may be faulty is nan";
    }
    void damagedFaces()
    {
        QFETCH(const CellComplex, complex);
        QFETCH(const QString, text);
        const auto dataset = datasetOf(complex, {.values = std::vector<double>(complex.positions.size(), 1)});
        QVERIFY(!dataset.ok());
        QVERIFY2(QString::fromStdString(dataset.error().text()).contains(text), dataset.error().text().c_str());
    }

    /// S20: numbers without any sense are refused, or make a mesh that is sound.
    void garbage()
    {
        std::mt19937 random(9);
        for (int trial = 0; trial < 1500; ++trial) {
            CellComplex complex;
            for (unsigned point = 0; point < 4 + random() % 6; ++point)
                complex.positions.emplace_back(random() % 4, random() % 4, random() % 4);
            complex.offsets = {0};
            for (unsigned cell = 0; cell < 1 + random() % 3; ++cell) {
                for (unsigned face = 0; face < random() % 8; ++face) {
                    const unsigned count = random() % 5 == 0 ? random() % 7 : 3;
                    complex.corners.push_back(count);
                    for (unsigned point = 0; point < count; ++point)
                        complex.corners.push_back(random() % complex.positions.size());
                }
                complex.shapes.push_back(CellShape::Polyhedron);
                complex.offsets.push_back(complex.corners.size());
            }
            complex.addsCentres = trial % 2 == 0;
            complex.mostFaulty = trial % 3 == 0 ? 1 : 0.001;
            const auto dataset = datasetOf(complex, linearValues(complex));
            QVERIFY(dataset ? checkIrregular(*dataset).ok() : !dataset.error().text().empty());
        }
    }
};

QTEST_GUILESS_MAIN(PolyhedraTest)
#include "polyhedra_test.moc"
