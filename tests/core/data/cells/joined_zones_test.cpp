// SPDX-License-Identifier: GPL-3.0-or-later
// Structured zones become one mesh that fills what they fill (R1); what does not fit together is told (S6, S20).
#include "core/data/cells/irregular_check.h"
#include "tests/core/data/cells/cell_cases.h"

#include <tan/zones.h>

#include <QTest>

#include <cmath>
#include <functional>
#include <limits>

using namespace tetra;

namespace {

using Place = Eigen::Vector3d;

double linear(const Place& place)
{
    return place.dot(Place(1, 2, 4));
}

/// A grid of so many points whose point (i, j, k) lies where `at` says, with a linear field as `Number`s.
template <class Number = double>
Dataset zone(const std::array<std::uint32_t, 3>& size, const std::function<Place(double, double, double)>& at)
{
    std::vector<Place> places;
    std::vector<Number> values;
    for (std::uint32_t k = 0; k < size[2]; ++k)
        for (std::uint32_t j = 0; j < size[1]; ++j)
            for (std::uint32_t i = 0; i < size[0]; ++i) {
                places.push_back(at(i, j, k));
                values.push_back(static_cast<Number>(linear(places.back())));
            }
    Dataset grid{
        .domain = DomainClass::Curvilinear, .lattice = {}, .values = {}, .source = {.name = "zone", .path = {}}};
    grid.lattice.size = size;
    grid.positions = std::make_shared<const std::vector<Place>>(std::move(places));
    grid.values = ScalarField::of(std::move(values));
    return grid;
}

/// A box of unit cells, bent to a parallelepiped, from `low` on.
Dataset box(const std::array<std::uint32_t, 3>& size, const Place& low)
{
    return zone(size, [&](double i, double j, double k) {
        const Place place = low + Place(i, j, k);
        return Place(place[0] + 0.5 * place[1], place[1], place[2] + 0.25 * place[0]);
    });
}

double volumeOf(const Dataset& dataset)
{
    double volume = 0;
    for (const auto& [a, b, c, d] : *dataset.tetrahedra) {
        const auto& places = *dataset.positions;
        volume += (places[b] - places[a]).dot((places[c] - places[a]).cross(places[d] - places[a])) / 6;
    }
    return volume;
}

Result<Dataset> meshOf(const std::vector<Dataset>& zones)
{
    auto joined = joinZones(zones);
    if (!joined)
        return joined.error();
    auto mesh = datasetOf(joined->complex, joined->values);
    if (mesh)
        mesh->remarks.insert(mesh->remarks.begin(), joined->remarks.begin(), joined->remarks.end());
    return mesh;
}

/// What is wrong with a mesh that is to have the linear field, this volume and so many points; empty if nothing is.
QString mistakes(const Result<Dataset>& mesh, double volume, std::uint64_t points)
{
    if (!mesh)
        return QString::fromStdString(mesh.error().text());
    if (const Status sound = checkIrregular(*mesh); !sound)
        return QString::fromStdString(sound.error().text());
    if (std::abs(volumeOf(*mesh) - volume) > 1e-12 * volume)
        return QString("its volume is %1").arg(volumeOf(*mesh));
    if (mesh->pointCount() != points)
        return QString("it has %1 points").arg(mesh->pointCount());
    for (std::uint64_t point = 0; point < points; ++point)
        if (mesh->values.at(point) != linear(mesh->position(point)))
            return QString("point %1 has another value").arg(point);
    return {};
}

bool says(const Dataset& dataset, const QString& text)
{
    return remarksOf(dataset).contains(text);
}

} // namespace

class JoinedZonesTest : public QObject {
    Q_OBJECT
private slots:
    /// Two by two; one runs along other axes, so that it is mirrored.
    void fourZones()
    {
        std::vector<Dataset> zones = {box({4, 4, 4}, {0, 0, 0}), box({4, 4, 4}, {3, 0, 0}), box({4, 4, 4}, {0, 3, 0})};
        zones.push_back(zone({4, 4, 4}, [](double j, double i, double k) {
            const Place place(3 + i, 3 + j, k);
            return Place(place[0] + 0.5 * place[1], place[1], place[2] + 0.25 * place[0]);
        }));
        const auto mesh = meshOf(zones);
        const QString wrong = mistakes(mesh, 6 * 6 * 3, 7 * 7 * 4);
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
        QVERIFY2(says(*mesh, "Its 4 zones were joined into one mesh, in which they share 36 faces."),
                 qPrintable(remarksOf(*mesh)));
        QVERIFY(!says(*mesh, "seam"));
        QVERIFY(says(*mesh, "were merged with it"));
    }

    /// A zone with half the step along its border: the mesh has a seam there, which is counted from both sides.
    void otherPointsOnTheBorder()
    {
        const Dataset fine = zone({3, 7, 7}, [](double i, double j, double k) { return Place(3 + i, j / 2, k / 2); });
        const Dataset coarse = zone({4, 4, 4}, [](double i, double j, double k) { return Place(i, j, k); });
        const auto mesh = meshOf({coarse, fine});
        const QString wrong = mistakes(mesh, 27 + 18, 64 + 147 - 16);
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
        QVERIFY(says(*mesh, "Its 2 zones were put into one mesh, in which no two of them share a face."));
        QVERIFY2(says(*mesh, "Faces of zones that meet another zone with different points there: 45."),
                 qPrintable(remarksOf(*mesh)));
    }

    /// A bent border in steps of different lengths, along which the zones lie near each other, and a third zone apart.
    void bentBorders()
    {
        const auto ring = [](double first, double steps) {
            return [first, steps](double i, double j, double k) {
                const double angle = j / steps;
                return Place((first + i) * std::cos(angle), (first + i) * std::sin(angle), k);
            };
        };
        const auto joined = joinZones(std::vector<Dataset>{zone({3, 9, 3}, ring(5, 8)), zone({3, 13, 3}, ring(7, 12)),
                                                           zone({3, 9, 3}, ring(20, 8))});
        QVERIFY2(joined.ok(), joined ? "" : joined.error().text().c_str());
        QCOMPARE(joined->remarks.size(), std::size_t(2));
        QCOMPARE(joined->remarks[1].text(), "Faces of zones that meet another zone with different points there: 40. "
                                            "The mesh has a seam there, and is not connected across it.");
    }

    void apart()
    {
        const auto mesh = meshOf({box({3, 3, 3}, {0, 0, 0}), box({3, 3, 3}, {3, 0, 0})});
        const QString wrong = mistakes(mesh, 16, 54);
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
        QVERIFY(says(*mesh, "no two of them share a face") && !says(*mesh, "seam"));
    }

    void overlapsAreRefused()
    {
        const auto mesh = meshOf({box({4, 4, 4}, {0, 0, 0}), box({4, 4, 4}, {2.5, 0.5, 0.5})});
        QVERIFY(!mesh.ok());
        QVERIFY2(mesh.error().text().find("it overlaps others") != std::string::npos, mesh.error().text().c_str());
    }

    /// Hidden cells and values that are not finite are holes, and no part of what zones share.
    void holes()
    {
        Dataset first = box({4, 4, 4}, {0, 0, 0});
        const Dataset second = box({4, 4, 4}, {3, 0, 0});
        std::vector<GridCell> cells(27, GridCell::Kept);
        cells[2] = GridCell::Blanked; // at the border
        first.cells = std::make_shared<const std::vector<GridCell>>(cells);
        std::vector<double> values(first.values.as<double>().begin(), first.values.as<double>().end());
        values[63] = std::numeric_limits<double>::quiet_NaN(); // a corner of the last cell, at the border, too
        first.values = ScalarField::of(values);
        const auto mesh = meshOf({first, second});
        const QString wrong = mistakes(mesh, 54 - 2, 64 + 64 - 16);
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
        QVERIFY2(says(*mesh, "in which they share 7 faces"), qPrintable(remarksOf(*mesh)));
        QVERIFY(says(*mesh, "1 cell is blanked out") && says(*mesh, "1 cell has a value that is not finite"));
        QVERIFY(!says(*mesh, "seam"));
    }

    /// One that wraps around, so that it meets itself.
    void aRingAlone()
    {
        const auto joined = joinZones(std::vector<Dataset>{zone({3, 5, 3}, [](double i, double j, double k) {
            constexpr std::array<std::array<double, 2>, 5> around = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 0}}};
            const auto& [x, y] = around[static_cast<std::size_t>(j)];
            return Place((1 + i) * x, (1 + i) * y, k);
        })});
        QVERIFY(joined.ok());
        QVERIFY(joined->remarks.empty());
        const auto mesh = datasetOf(joined->complex, joined->values);
        const QString wrong = mistakes(mesh, 2.0 * (18 - 2), 3 * 4 * 3);
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
    }

    void surfacesAreLeftOut()
    {
        const auto mesh = meshOf({box({3, 3, 3}, {0, 0, 0}), box({3, 1, 3}, {0, 0, 0}), box({3, 3, 3}, {2, 0, 0})});
        const QString wrong = mistakes(mesh, 16, 45);
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
        QVERIFY(says(*mesh, "Its 2 zones were joined") &&
                says(*mesh, "Zones left out because they have no volume: 1."));
    }

    void typesOfValues()
    {
        const auto at = [](double i, double j, double k) { return Place(i, j, k); };
        const auto beside = [](double i, double j, double k) { return Place(2 + i, j, k); };
        const auto floats = joinZones(std::vector<Dataset>{zone<float>({3, 3, 3}, at), zone<float>({3, 3, 3}, beside)});
        QVERIFY(floats.ok());
        QCOMPARE(floats->values.type, SampleType::Float32);
        const auto mixed = joinZones(std::vector<Dataset>{zone<float>({3, 3, 3}, at), zone<double>({3, 3, 3}, beside)});
        QVERIFY(mixed.ok());
        QCOMPARE(mixed->values.type, SampleType::Float64);
    }

    void refusals()
    {
        QVERIFY(!joinZones({}).ok());
        const auto flat = joinZones(std::vector<Dataset>{box({3, 1, 3}, {0, 0, 0})});
        QVERIFY(!flat.ok());
        QVERIFY(flat.error().text().starts_with("None of the zones has cells"));
        Dataset points = box({3, 3, 3}, {0, 0, 0});
        points.domain = DomainClass::Scattered;
        QVERIFY(!joinZones(std::vector<Dataset>{points}).ok());
        Dataset short1 = box({3, 3, 3}, {0, 0, 0});
        short1.values = ScalarField::of(std::vector<double>(26, 1));
        QVERIFY(!joinZones(std::vector<Dataset>{short1}).ok());
        Dataset cells = box({3, 3, 3}, {0, 0, 0});
        cells.cells = std::make_shared<const std::vector<GridCell>>(7, GridCell::Kept);
        QVERIFY(!joinZones(std::vector<Dataset>{cells}).ok());
        std::stop_source stop;
        stop.request_stop();
        const auto cancelled = joinZones(std::vector<Dataset>{box({3, 3, 3}, {0, 0, 0})},
                                         Progress(stop.get_token(), [](double, const Message&) {}));
        QVERIFY(!cancelled.ok());
        QCOMPARE(cancelled.error().kind, ErrorKind::Cancelled);
    }
};

QTEST_GUILESS_MAIN(JoinedZonesTest)
#include "joined_zones_test.moc"
