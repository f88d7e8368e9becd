// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimate/collapse_star.h"

#include <QTest>

#include <algorithm>
#include <random>
#include <vector>

using namespace tetra;

namespace {

constexpr std::size_t length = 32; // of a column
constexpr std::size_t lanes = 8;

/// Tetrahedra with weights that are small integers: ties are many.
struct RandomFan {
    std::vector<double> columns = std::vector<double>(12 * length);
    std::vector<std::uint32_t> faces;

    explicit RandomFan(std::mt19937& random)
    {
        std::uniform_int_distribution<int> weight(-2, 2);
        std::ranges::generate(columns, [&] { return weight(random); });
        for (std::uint32_t face = 0; face < 29; ++face)
            if (face % 5 != 0) // some have no tetrahedron
                faces.push_back(face);
    }

    StarTetrahedra tetrahedra() const { return {columns, length, faces, {1, 0, -2}}; }
    /// The product of three rows of columns with a place from the apex.
    double at(std::size_t column, std::uint32_t face, const std::array<double, 3>& place) const
    {
        const double* row = columns.data() + column * length + face;
        return row[0] * (place[0] - 1) + row[length] * place[1] + row[2 * length] * (place[2] + 2);
    }
    std::uint32_t ownerOf(const std::array<double, 3>& place) const
    {
        const auto depth = [&](std::uint32_t face) {
            return std::min({at(0, face, place), at(3, face, place), at(6, face, place)});
        };
        return *std::ranges::max_element(faces, {}, depth); // the first of equals
    }
};

} // namespace

class StarLocatorTest : public QObject {
    Q_OBJECT
private slots:
    void ownersAreTheFirstDeepest_data();
    void ownersAreTheFirstDeepest();
};

void StarLocatorTest::ownersAreTheFirstDeepest_data()
{
    QTest::addColumn<int>("placeCount");
    QTest::newRow("few places") << 8;
    QTest::newRow("many places") << 1000;
}

void StarLocatorTest::ownersAreTheFirstDeepest()
{
    QFETCH(int, placeCount);
    std::mt19937 random(7);
    std::uniform_int_distribution<int> coordinate(-4, 4);
    for (int round = 0; round < 20; ++round) {
        const RandomFan fan(random);
        StarLocator location(fan.tetrahedra(), static_cast<std::size_t>(placeCount));
        for (int block = 0; block < placeCount / int(lanes); ++block) {
            std::array<std::array<double, lanes>, 3> places{};
            for (auto& coordinates : places)
                std::ranges::generate(coordinates, [&] { return coordinate(random); });
            std::array<std::uint32_t, lanes> owners{};
            std::array<double, lanes> steps{};
            location.locateEight({places[0].data(), places[1].data(), places[2].data()}, owners.data(), steps.data());
            for (std::size_t lane = 0; lane < lanes; ++lane) {
                const std::array<double, 3> place = {places[0][lane], places[1][lane], places[2][lane]};
                QCOMPARE(owners[lane], fan.ownerOf(place));
                QCOMPARE(steps[lane], fan.at(9, owners[lane], place));
            }
        }
    }
}

QTEST_APPLESS_MAIN(StarLocatorTest)
#include "star_locator_test.moc"
