// SPDX-License-Identifier: GPL-3.0-or-later
// What arrays have to be like to be data: points that have a volume between them.
#include <tan/build.h>
#include <tan/data.h>

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace tetra;

namespace {

/// 5 x 5 points of an oblique plane.
std::vector<Eigen::Vector3d> planePoints()
{
    std::vector<Eigen::Vector3d> points;
    for (int j = 0; j < 5; ++j)
        for (int i = 0; i < 5; ++i)
            points.emplace_back(i, j, 0.5 * i - 0.25 * j + 3);
    return points;
}

Result<Dataset> datasetOf(const std::vector<Eigen::Vector3d>& points)
{
    return scatteredDataset(points, std::vector<double>(points.size(), 1), "points");
}

bool isTold(const Dataset& dataset)
{
    return std::ranges::any_of(dataset.remarks, [](const Message& remark) {
        return remark.text().starts_with("All its points lie in a plane");
    });
}

} // namespace

class DatasetMakingTest : public QObject {
    Q_OBJECT
private slots:
    void pointsInAPlaneAreTold_data()
    {
        QTest::addColumn<std::vector<Eigen::Vector3d>>("points");
        QTest::newRow("a plane") << planePoints();
        QTest::newRow("a line") << std::vector<Eigen::Vector3d>{{0, 0, 0}, {1, 2, 3}, {2, 4, 6}, {3, 6, 9}, {4, 8, 12}};
    }
    void pointsInAPlaneAreTold()
    {
        QFETCH(const std::vector<Eigen::Vector3d>, points);
        const auto dataset = datasetOf(points);
        QVERIFY2(dataset.ok(), dataset ? "" : dataset.error().text().c_str());
        QVERIFY(isTold(*dataset));
        const auto none = tetrahedrized(*dataset);
        QVERIFY(!none.ok());
        QVERIFY2(none.error().text().find("All points of 'points' lie in a plane") != std::string::npos,
                 none.error().text().c_str());
    }

    /// As exactly as the tetrahedra between them are made.
    void onePointBesideThePlaneIsEnough()
    {
        std::vector<Eigen::Vector3d> points = planePoints();
        points[7].z() = std::nextafter(points[7].z(), std::numeric_limits<double>::infinity());
        const auto dataset = datasetOf(points);
        QVERIFY2(dataset.ok(), dataset ? "" : dataset.error().text().c_str());
        QVERIFY(!isTold(*dataset) && tetrahedrized(*dataset).ok());
    }
};

QTEST_GUILESS_MAIN(DatasetMakingTest)
#include "dataset_making_test.moc"
