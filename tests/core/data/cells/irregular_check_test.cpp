// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/data/cells/irregular_check.h"

#include <QTest>

#include <stop_token>
#include <utility>
#include <vector>

using namespace tetra;

namespace {

using Tetrahedra = std::vector<std::array<std::uint32_t, 4>>;

Dataset datasetOf(std::vector<Eigen::Vector3d> positions, Tetrahedra tetrahedra)
{
    Dataset dataset;
    dataset.domain = DomainClass::Irregular;
    dataset.lattice.size = {static_cast<std::uint32_t>(positions.size()), 1, 1};
    const auto values = std::make_shared<std::vector<float>>(positions.size(), 2.0f);
    dataset.values =
        ScalarField(SampleType::Float32, values->size(), {values, reinterpret_cast<const std::byte*>(values->data())});
    dataset.positions = std::make_shared<const std::vector<Eigen::Vector3d>>(std::move(positions));
    dataset.tetrahedra = std::make_shared<const Tetrahedra>(std::move(tetrahedra));
    return dataset;
}

const std::vector<Eigen::Vector3d> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};

/// Tetrahedra of which each two overlap.
std::pair<std::vector<Eigen::Vector3d>, Tetrahedra> copiesNearby(std::uint32_t count)
{
    std::vector<Eigen::Vector3d> positions;
    Tetrahedra tetrahedra;
    for (std::uint32_t copy = 0; copy < count; ++copy) {
        for (std::size_t i = 0; i < 4; ++i)
            positions.push_back(corners[i] + Eigen::Vector3d::Constant(.001 * copy));
        tetrahedra.push_back({4 * copy, 4 * copy + 1, 4 * copy + 2, 4 * copy + 3});
    }
    return {positions, tetrahedra};
}

} // namespace

class IrregularCheckTest : public QObject {
    Q_OBJECT
private slots:
    void sound()
    {
        QVERIFY(checkIrregular(datasetOf(corners, {{0, 1, 2, 3}, {1, 2, 3, 4}})).ok());
        // Two components.
        auto positions = corners;
        positions.resize(4);
        for (std::size_t i = 0; i < 4; ++i)
            positions.push_back(corners[i] + Eigen::Vector3d(0.5, 0.5, 0.5));
        QVERIFY(checkIrregular(datasetOf(positions, {{0, 1, 2, 3}, {4, 5, 6, 7}})).ok());
    }

    /// C10: what only touches does not overlap, whether it touches in a point or an edge of both, or in places that
    /// have other names, or in faces that do not fit together.
    void touching()
    {
        auto positions = corners;
        positions.push_back({-1, -1, -1});
        positions.push_back({-1, 0, -1});
        positions.push_back({0, -1, -1});
        QVERIFY(checkIrregular(datasetOf(positions, {{0, 1, 2, 3}, {1, 2, 3, 4}, {0, 5, 6, 7}})).ok());
        positions.resize(5);
        positions.push_back({-1, -1, 0});
        positions.push_back({-1, -2, 0});
        QVERIFY(checkIrregular(datasetOf(positions, {{0, 1, 2, 3}, {1, 2, 3, 4}, {0, 5, 6, 3}})).ok());
        positions = {corners.begin(), corners.begin() + 4};
        for (std::size_t i = 0; i < 4; ++i)
            positions.push_back(corners[i] + Eigen::Vector3d(1, 0, 0));
        QVERIFY(checkIrregular(datasetOf(positions, {{0, 1, 2, 3}, {4, 5, 6, 7}})).ok());
        for (std::size_t i = 0; i < 4; ++i)
            positions[4 + i] = {0.25 + 0.5 * corners[i][0], 0.125 + 0.5 * corners[i][1], -corners[i][2]};
        QVERIFY(checkIrregular(datasetOf(positions, {{0, 1, 2, 3}, {5, 4, 6, 7}})).ok());
        positions[7] = {0.3, 0.3, 0.01};
        QVERIFY(!checkIrregular(datasetOf(positions, {{0, 1, 2, 3}, {4, 5, 6, 7}})).ok());
    }

    /// S6, S20: each thing that is relied on.
    void faults_data()
    {
        QTest::addColumn<Dataset>("dataset");
        QTest::addColumn<QString>("says");
        QTest::newRow("turned") << datasetOf(corners, {{0, 1, 2, 3}, {1, 3, 2, 4}}) << "1 tetrahedron that is flat";
        QTest::newRow("unused") << datasetOf(corners, {{0, 1, 2, 3}}) << "1 points that no tetrahedron";
        QTest::newRow("range") << datasetOf(corners, {{0, 1, 2, 5}}) << "point 5 of 5";
        QTest::newRow("far") << datasetOf({corners[0], corners[1], corners[2], {0, 0, 1e200}}, {{0, 1, 2, 3}})
                             << "not too large to compute with";
        QTest::newRow("none") << datasetOf(corners, {}) << "no tetrahedra";
        QTest::newRow("twice") << datasetOf(corners, {{0, 1, 2, 3}, {1, 2, 3, 4}, {1, 2, 3, 4}}) << "three or more";
        auto positions = corners;
        positions.push_back({-1, -1, 0});
        positions.push_back({-1, -1, 1});
        QTest::newRow("edge") << datasetOf(positions, {{0, 1, 2, 3}, {1, 2, 3, 4}, {0, 3, 5, 6}}) << "flat or inverted";
        positions = {corners.begin(), corners.begin() + 4};
        for (std::size_t i = 0; i < 4; ++i)
            positions.push_back(corners[i] * 0.25 + Eigen::Vector3d(0.1, 0.1, 0.1));
        QTest::newRow("inside") << datasetOf(positions, {{0, 1, 2, 3}, {4, 5, 6, 7}})
                                << "1 pair of tetrahedra that overlap";
        for (std::size_t i = 0; i < 4; ++i)
            positions[4 + i] = corners[i] + Eigen::Vector3d(0.1, 0.1, 0.1);
        QTest::newRow("overlap") << datasetOf(positions, {{0, 1, 2, 3}, {4, 5, 6, 7}})
                                 << "1 pair of tetrahedra that overlap";
    }
    void faults()
    {
        QFETCH(const Dataset, dataset);
        QFETCH(const QString, says);
        const Status checked = checkIrregular(dataset);
        QVERIFY(!checked.ok());
        QVERIFY2(QString::fromStdString(checked.error().text()).contains(says), checked.error().text().c_str());
    }

    /// Each of many pairs may take a while, and each of a tetrahedron's pairs is asked about in one go.
    void overlapsCanBeCancelled()
    {
        const auto [positions, tetrahedra] = copiesNearby(40);
        std::stop_source stop;
        int asked = 0;
        const auto cancelAtFirst = [&](std::uint32_t, std::uint32_t) {
            ++asked;
            stop.request_stop();
            return false;
        };
        const MeshOverlaps found = findOverlaps(positions, tetrahedra, findMeshFaces(tetrahedra), cancelAtFirst,
                                                Progress(stop.get_token(), [](double, const Message&) {}));
        QCOMPARE(asked, 1);
        QCOMPARE(found.pairs.size(), 1u);
    }

    /// A mesh that is wrong everywhere is not counted to the end.
    void manyOverlapsAreNotCounted()
    {
        const auto [positions, tetrahedra] = copiesNearby(50);
        const Status checked = checkIrregular(datasetOf(positions, tetrahedra));
        QVERIFY(!checked.ok());
        QVERIFY2(checked.error().text().find("more than 1000 pairs of tetrahedra that overlap") != std::string::npos,
                 checked.error().text().c_str());
    }

    /// A part in the cavity of another one is no fault: two shells of a tetrahedron with a smaller one in the hole.
    void partsInCavities()
    {
        const Eigen::Vector3d centre(0.25, 0.25, 0.25);
        std::vector<Eigen::Vector3d> positions;
        for (const double scale : {1.0, 0.5, 0.25})
            for (std::size_t i = 0; i < 4; ++i)
                positions.push_back(centre + scale * (corners[i] - centre));
        Tetrahedra tetrahedra = {{8, 9, 10, 11}};
        // Between the outer and the middle one, a prism for each face, cut in three.
        for (const auto& [a, b, c] : {std::array<std::uint32_t, 3>{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}})
            tetrahedra.insert(tetrahedra.end(), {{a, b, c, a + 4}, {b, c, a + 4, b + 4}, {c, a + 4, b + 4, c + 4}});
        for (auto& t : tetrahedra) {
            const Eigen::Vector3d a = positions[t[0]];
            if ((positions[t[1]] - a).dot((positions[t[2]] - a).cross(positions[t[3]] - a)) < 0)
                std::swap(t[0], t[1]);
        }
        const Status checked = checkIrregular(datasetOf(positions, tetrahedra));
        QVERIFY2(checked.ok(), checked ? "" : checked.error().text().c_str());
    }
};

QTEST_GUILESS_MAIN(IrregularCheckTest)
#include "irregular_check_test.moc"
