// SPDX-License-Identifier: GPL-3.0-or-later
// Colours of a surface by its values: what the transfer function says at any place of any triangle.
#include "tests/core/render/holed_mesh.h"

#include <tan/render.h>

#include <QTest>

#include <map>

using namespace tetra;
using namespace tetra::testing;

namespace {

constexpr double smallPart = 1e-3; ///< of a piece, from its corners: a step's own value has two colours

TransferFunction ramps()
{
    return transferFunctionFromPoints(
        {{-0.5, {1, 0, 0}, 0.1f}, {0.3, {0, 1, 0.5f}, 0}, {0.7, {0.2f, 0.2f, 1}, 0.9f}, {2.5, {1, 1, 0}, 1}}, 1);
}

/// Two steps, one of them at the value of many vertices.
TransferFunction steps()
{
    return transferFunctionFromPoints({{-1, {1, 0, 0}, 1},
                                       {0, {1, 1, 0}, 1},
                                       {0, {0, 0, 1}, 1},
                                       {1.1, {0, 1, 1}, 1},
                                       {1.1, {1, 0, 1}, 1},
                                       {2, {0, 0, 0}, 1}},
                                      1);
}

double areaOf(const TriangleMesh& surface)
{
    double area = 0;
    for (const auto& [a, b, c] : surface.triangles) {
        const Eigen::Vector3d first = surface.positions[a].cast<double>();
        area +=
            (surface.positions[b].cast<double>() - first).cross(surface.positions[c].cast<double>() - first).norm() / 2;
    }
    return area;
}

bool near(const Colour& one, const std::array<double, 3>& other)
{
    constexpr double tolerance = 2e-4;
    return std::abs(one.red - other[0]) < tolerance && std::abs(one.green - other[1]) < tolerance &&
           std::abs(one.blue - other[2]) < tolerance;
}

} // namespace

class ValueColoursTest : public QObject {
    Q_OBJECT

private slots:
    void coloursAreExactEverywhere_data()
    {
        QTest::addColumn<int>("function");
        QTest::addColumn<unsigned>("seed");
        for (unsigned seed = 0; seed < 4; ++seed) {
            QTest::addRow("ramps, %u", seed) << 0 << seed;
            QTest::addRow("steps, %u", seed) << 1 << seed;
        }
    }
    void coloursAreExactEverywhere()
    {
        QFETCH(int, function);
        QFETCH(unsigned, seed);
        const TransferFunction transfer = function == 0 ? ramps() : steps();
        const TriangleMesh surface = extractBoundary(holedMesh(seed)).value();
        const TriangleMesh coloured = colouredByValue(surface, transfer);
        QCOMPARE(coloured.colours.size(), coloured.positions.size());
        QCOMPARE(coloured.values.size(), coloured.positions.size());
        QCOMPARE(coloured.normals.size(), coloured.positions.size());
        QVERIFY(coloured.triangles.size() > surface.triangles.size());
        QVERIFY(std::abs(areaOf(coloured) - areaOf(surface)) < 1e-5 * areaOf(surface));
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> share(smallPart, 1);
        for (const auto& triangle : coloured.triangles) {
            std::array<double, 3> weights = {share(random), share(random), share(random)};
            const double sum = weights[0] + weights[1] + weights[2];
            double value = 0;
            Colour colour;
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const double weight = weights[corner] / sum;
                const Colour& own = coloured.colours[triangle[corner]];
                value += weight * coloured.values[triangle[corner]];
                colour.red += static_cast<float>(weight) * own.red;
                colour.green += static_cast<float>(weight) * own.green;
                colour.blue += static_cast<float>(weight) * own.blue;
            }
            const auto least =
                std::min({coloured.values[triangle[0]], coloured.values[triangle[1]], coloured.values[triangle[2]]});
            const auto largest =
                std::max({coloured.values[triangle[0]], coloured.values[triangle[1]], coloured.values[triangle[2]]});
            if (largest - least > 1e-4f) // elsewhere rounding may put it on a step's other side
                QVERIFY(near(colour, evaluateUnmasked(transfer, value).colour));
        }
    }

    /// Neighbours are cut at the same places, bit for bit, so no crack opens.
    void theSurfaceStaysClosed()
    {
        using Place = std::array<double, 3>;
        for (unsigned seed = 0; seed < 4; ++seed) {
            const TriangleMesh coloured = colouredByValue(extractBoundary(holedMesh(seed)).value(), steps());
            std::map<std::pair<Place, Place>, int> edges;
            for (const auto& triangle : coloured.triangles)
                for (std::size_t corner = 0; corner < 3; ++corner) {
                    const auto placeOf = [&](std::size_t number) -> Place {
                        const Eigen::Vector3d& place = coloured.positions[triangle[number % 3]];
                        return {place.x(), place.y(), place.z()};
                    };
                    ++edges[{placeOf(corner), placeOf(corner + 1)}];
                    --edges[{placeOf(corner + 1), placeOf(corner)}];
                }
            QVERIFY(std::ranges::all_of(edges, [](const auto& edge) { return edge.second == 0; }));
        }
    }

    /// A triangle that ends at a step has the colour below it, one that begins there the colour above.
    void aStepAtAVertexHasTwoColours()
    {
        TriangleMesh surface;
        surface.positions = {{-1, 0, 0}, {0, 0, 0}, {0, 1, 0}, {1, 0, 0}};
        surface.normals.assign(4, Eigen::Vector3f::UnitZ());
        surface.values = {-1, 0, 0, 1};
        surface.triangles = {{0, 1, 2}, {1, 3, 2}};
        const TriangleMesh coloured = colouredByValue(surface, steps());
        QCOMPARE(coloured.triangles.size(), std::size_t(2));
        QVERIFY(coloured.colours[coloured.triangles[0][1]] == (Colour{1, 1, 0}));
        QVERIFY(coloured.colours[coloured.triangles[1][0]] == (Colour{0, 0, 1}));
    }

    void withoutPointsOrValuesItStays()
    {
        TriangleMesh surface = extractBoundary(holedMesh(0)).value();
        QVERIFY(colouredByValue(surface, {}).colours.empty());
        surface.values.clear();
        QVERIFY(colouredByValue(surface, ramps()).colours.empty());
    }

    /// The maker extracts and colours what is new only.
    void theMakerKeepsWhatItHas()
    {
        BoundaryCache maker(std::make_shared<const TetrahedralMesh>(holedMesh(2)));
        const auto plain = maker.plain({.opacity = 0.3f, .backFacesOnly = true});
        QVERIFY(plain.ok());
        QCOMPARE(plain->opacity, 0.3f);
        QVERIFY(plain->backFacesOnly && plain->mesh->colours.empty());
        QCOMPARE(maker.plain({})->mesh, plain->mesh);
        const auto coloured = maker.coloured(ramps(), {});
        QVERIFY(coloured.ok() && !coloured->mesh->colours.empty());
        QCOMPARE(maker.coloured(ramps(), {})->mesh, coloured->mesh);
        QVERIFY(maker.coloured(steps(), {})->mesh != coloured->mesh);
        for (const float opacity : {0.0f, -1.0f, 1.5f, std::numeric_limits<float>::quiet_NaN()})
            QCOMPARE(maker.plain({.opacity = opacity}).error().kind, ErrorKind::WrongUsage);
        TransferFunction wrong = ramps();
        std::swap(wrong.colours[0], wrong.colours[1]);
        QVERIFY(!maker.coloured(wrong, {}));
    }
};

QTEST_GUILESS_MAIN(ValueColoursTest)
#include "value_colours_test.moc"
