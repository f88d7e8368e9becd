// SPDX-License-Identifier: GPL-3.0-or-later
/// Regions and strides of datasets against the plain definition, on random parts.
#include "core/data/dataset_part.h"
#include "core/mesh/manifold.h"
#include "plugins/samples/samples.h"
#include <tan/base.h>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <map>
#include <random>
#include <set>

using namespace tetra;

namespace {

constexpr std::uint32_t rounds = 60;

Eigen::AlignedBox3d boxOf(std::array<std::uint32_t, 3> first, std::array<std::uint32_t, 3> last)
{
    return {Eigen::Vector3d(first[0], first[1], first[2]), Eigen::Vector3d(last[0], last[1], last[2])};
}

/// A region with at least two points along each axis, and a stride that keeps them.
DatasetPart randomPart(const Lattice& lattice, std::uint32_t round, std::mt19937& random)
{
    DatasetPart part;
    std::array<std::uint32_t, 3> first{};
    std::array<std::uint32_t, 3> last{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        first[axis] = std::uniform_int_distribution<std::uint32_t>(0, lattice.size[axis] - 2)(random);
        last[axis] = std::uniform_int_distribution<std::uint32_t>(first[axis] + 1, lattice.size[axis] - 1)(random);
        part.stride[axis] = std::uniform_int_distribution<std::uint32_t>(1, last[axis] - first[axis])(random);
    }
    if (random() % 4 != 0)
        part.region = boxOf(first, last);
    else
        part.stride = {1 + round % 3u, 1, 1 + round % 2u};
    return part;
}

Dataset grid(const char* name, std::uint32_t size)
{
    return *makeSample({.name = name, .size = size, .type = std::nullopt, .seed = 3});
}

/// The dataset with its samples in a mapped file.
Dataset mapped(Dataset dataset, const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly))
        qFatal("cannot write");
    const auto bytes = dataset.values.bytes();
    file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<qint64>(bytes.size()));
    file.close();
    dataset.mappedFile = *MappedFile::open(path.toStdString());
    dataset.values = ScalarField(dataset.values.type(), dataset.values.count(),
                                 {dataset.mappedFile, dataset.mappedFile->bytes().data()});
    return dataset;
}

/// A box of n^3 cubes of six tetrahedra each.
Dataset irregular(std::uint32_t n)
{
    constexpr std::array<std::array<std::uint32_t, 3>, 6> orders = {
        {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
    Lattice lattice{.size = {n + 1, n + 1, n + 1}};
    auto positions = std::make_shared<std::vector<Eigen::Vector3d>>();
    auto values = std::make_shared<std::vector<double>>();
    for (std::uint64_t point = 0; point < lattice.pointCount(); ++point) {
        const auto at = lattice.coordinates(point);
        positions->push_back(lattice.position(at[0], at[1], at[2]));
        values->push_back(static_cast<double>(point));
    }
    auto tetrahedra = std::make_shared<std::vector<std::array<std::uint32_t, 4>>>();
    for (std::uint32_t cell = 0; cell < n * n * n; ++cell)
        for (const auto& order : orders) {
            std::array<std::uint32_t, 3> at = {cell % n, cell / n % n, cell / n / n};
            std::array<std::uint32_t, 4> corners{};
            for (std::size_t i = 0; i < 4; ++i) {
                corners[i] = static_cast<std::uint32_t>(lattice.index(at[0], at[1], at[2]));
                if (i < 3)
                    ++at[order[i]];
            }
            const Eigen::Vector3d a = (*positions)[corners[0]];
            if (((*positions)[corners[1]] - a).dot(((*positions)[corners[2]] - a).cross((*positions)[corners[3]] - a)) <
                0)
                std::swap(corners[2], corners[3]);
            tetrahedra->push_back(corners);
        }
    Dataset dataset;
    dataset.domain = DomainClass::Irregular;
    dataset.lattice.size = {static_cast<std::uint32_t>(positions->size()), 1, 1};
    dataset.positions = positions;
    dataset.values =
        ScalarField(SampleType::Float64, values->size(), {values, reinterpret_cast<const std::byte*>(values->data())});
    dataset.tetrahedra = tetrahedra;
    dataset.source = {"cubes", {}, 1};
    return dataset;
}

/// By the definition: each edge of the boundary's triangles in two of them, and those around each point one fan.
bool boundaryIsManifold(const std::vector<std::array<std::uint32_t, 4>>& tetrahedra)
{
    std::map<std::array<std::uint32_t, 3>, int> faces;
    for (const auto& corners : tetrahedra)
        for (std::size_t left = 0; left < 4; ++left) {
            std::array<std::uint32_t, 3> face{};
            for (std::size_t i = 0, j = 0; i < 4; ++i)
                if (i != left)
                    face[j++] = corners[i];
            std::ranges::sort(face);
            ++faces[face];
        }
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    std::map<std::uint32_t, std::map<std::uint32_t, std::vector<std::uint32_t>>> links; // of boundary points
    for (const auto& [face, count] : faces)
        if (count == 1)
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t a = face[(i + 1) % 3];
                const std::uint32_t b = face[(i + 2) % 3];
                ++edges[std::minmax(a, b)];
                links[face[i]][a].push_back(b);
                links[face[i]][b].push_back(a);
            }
    if (!std::ranges::all_of(edges, [](const auto& edge) { return edge.second == 2; }))
        return false;
    return std::ranges::all_of(links, [](const auto& entry) {
        const auto& link = entry.second;
        std::set<std::uint32_t> reached;
        std::vector<std::uint32_t> next = {link.begin()->first};
        while (!next.empty()) {
            const std::uint32_t point = next.back();
            next.pop_back();
            if (reached.insert(point).second)
                next.insert(next.end(), link.at(point).begin(), link.at(point).end());
        }
        return reached.size() == link.size();
    });
}

} // namespace

class DatasetPartTest : public QObject {
    Q_OBJECT

private:
    QTemporaryDir folder_;

private slots:
    void aPartOfAGridHasItsPoints_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<bool>("inFile");
        QTest::newRow("lattice") << "c60" << false;
        QTest::newRow("mapped lattice") << "c60" << true;
        QTest::newRow("curvilinear") << "blunt-body" << false;
    }

    void aPartOfAGridHasItsPoints()
    {
        QFETCH(QString, name);
        QFETCH(bool, inFile);
        Dataset dataset = grid(qPrintable(name), 12);
        dataset.lattice.spacing = dataset.positions ? Eigen::Vector3d(1, 1, 1) : Eigen::Vector3d(0.5, 2, 1);
        if (inFile)
            dataset = mapped(std::move(dataset), folder_.filePath("grid.raw"));
        std::mt19937 random(5);
        for (std::uint32_t round = 0; round < rounds; ++round) {
            const DatasetPart part = randomPart(dataset.lattice, round, random);
            const auto taken = takePart(dataset, part);
            QVERIFY2(taken, taken ? "" : taken.error().text().c_str());
            const Eigen::Vector3d first = part.region ? part.region->min() : Eigen::Vector3d(0, 0, 0);
            for (std::uint64_t point = 0; point < taken->pointCount(); ++point) {
                const auto at = taken->lattice.coordinates(point);
                std::array<std::uint32_t, 3> source{};
                for (std::size_t axis = 0; axis < 3; ++axis)
                    source[axis] = static_cast<std::uint32_t>(first[static_cast<Eigen::Index>(axis)]) +
                                   at[axis] * part.stride[axis];
                const std::uint64_t original = dataset.lattice.index(source[0], source[1], source[2]);
                QCOMPARE(taken->values.at(point), dataset.values.at(original));
                QVERIFY((taken->position(point) - dataset.position(original)).norm() < 1e-12);
            }
            for (int axis = 0; axis < 3; ++axis) { // not one more would fit
                const auto a = static_cast<std::size_t>(axis);
                const double last =
                    part.region ? part.region->max()[axis] : static_cast<double>(dataset.lattice.size[a] - 1);
                QVERIFY(first[axis] + double(taken->lattice.size[a]) * part.stride[a] > last);
            }
            QCOMPARE(taken->source.hash, contentHash(taken->values, taken->positions));
            QVERIFY(part.isWhole() || taken->source.name != dataset.source.name);
        }
    }

    void layersOfAMappedFileStayThere()
    {
        const Dataset dataset = mapped(grid("c60", 16), folder_.filePath("layers.raw"));
        DatasetPart part{.region = boxOf({0, 0, 3}, {15, 15, 9})};
        const auto layers = takePart(dataset, part);
        QVERIFY(layers);
        QCOMPARE(layers->values.bytes().data(),
                 dataset.values.bytes().data() + 3 * 16 * 16 * sampleSize(dataset.values.type()));
        QCOMPARE(layers->mappedFile, dataset.mappedFile);
        part.stride = {1, 1, 2};
        const auto thinned = takePart(dataset, part);
        QVERIFY(thinned && thinned->mappedFile == nullptr);
    }

    void wrongPartsAreRefused_data()
    {
        QTest::addColumn<QString>("region");
        QTest::addColumn<QString>("stride");
        QTest::addColumn<QString>("says");
        QTest::newRow("outside") << "0,0,0,8,7,7"
                                 << ""
                                 << "from 0 to 7";
        QTest::newRow("negative") << "-1,0,0,7,7,7"
                                  << ""
                                  << "from 0 to 7";
        QTest::newRow("coordinates") << "0,0,300,7,7,1000"
                                     << ""
                                     << "not coordinates: along z whole numbers from 0 to 7";
        QTest::newRow("not a whole number") << "0,0.5,0,7,7,7"
                                            << ""
                                            << "along y";
        QTest::newRow("one layer") << "0,0,3,7,7,3"
                                   << ""
                                   << "1 points along z";
        QTest::newRow("too large a stride") << ""
                                            << "1,8,1"
                                            << "1 points along y";
    }

    void wrongPartsAreRefused()
    {
        QFETCH(QString, region);
        QFETCH(QString, stride);
        QFETCH(QString, says);
        const DatasetPart part{.region = *parseRegion(region.toStdString()),
                               .stride = *parseStride(stride.toStdString())};
        const auto taken = takePart(grid("c60", 8), part);
        QVERIFY(!taken);
        QCOMPARE(taken.error().kind, ErrorKind::WrongUsage);
        QVERIFY2(QString::fromStdString(taken.error().text()).contains(says), taken.error().text().c_str());
        QVERIFY(!partOfLattice(grid("c60", 8).lattice, part));
    }

    void textsAreReadAgain()
    {
        std::mt19937 random(11);
        const Lattice lattice{.size = {40, 30, 20}};
        for (std::uint32_t round = 0; round < rounds; ++round) {
            const DatasetPart part = randomPart(lattice, round, random);
            const auto region = parseRegion(regionText(part));
            QVERIFY(region && region->has_value() == part.region.has_value());
            QVERIFY(!part.region || ((*region)->min() == part.region->min() && (*region)->max() == part.region->max()));
            QCOMPARE(*parseStride(strideText(part)), part.stride);
        }
        for (const char* wrong : {"1,2,3", "a,b,c,d,e,f", "5,0,0,1,1,1", "0,0,0,1,1,inf", "0,0,0,1,1,1,1"})
            QVERIFY2(!parseRegion(wrong), wrong);
        for (const char* wrong : {"0", "-1", "1,2", "x", "1,0,1", "1,1,1,1"})
            QVERIFY2(!parseStride(wrong), wrong);
    }

    void scatteredPointsOfABoxAreTaken()
    {
        const Dataset dataset = grid("scattered", 10);
        QCOMPARE(dataset.domain, DomainClass::Scattered);
        std::mt19937 random(2);
        const Eigen::AlignedBox3d bounds = dataset.bounds();
        for (std::uint32_t round = 0; round < rounds; ++round) {
            Eigen::AlignedBox3d box;
            for (int corner = 0; corner < 2; ++corner)
                box.extend(bounds.min() + bounds.sizes().cwiseProduct(
                                              Eigen::Vector3d(std::uniform_real_distribution<double>(0, 1)(random),
                                                              std::uniform_real_distribution<double>(0, 1)(random),
                                                              std::uniform_real_distribution<double>(0, 1)(random))));
            std::vector<std::pair<double, double>> expected; // x and value, in order
            for (std::uint64_t point = 0; point < dataset.pointCount(); ++point)
                if (box.contains(dataset.position(point)))
                    expected.emplace_back(dataset.position(point)[0], dataset.values.at(point));
            const auto taken = takePart(dataset, {.region = box});
            QCOMPARE(taken.ok(), expected.size() >= 4);
            for (std::uint64_t point = 0; taken && point < taken->pointCount(); ++point)
                QCOMPARE(std::pair(taken->position(point)[0], taken->values.at(point)), expected[point]);
            QVERIFY(!taken || taken->lattice.pointCount() == expected.size());
        }
        QVERIFY(!takePart(dataset, {.stride = {2, 2, 2}}));
    }

    void tetrahedraInABoxAreTakenWhole()
    {
        const Dataset dataset = irregular(6);
        const auto taken =
            takePart(dataset, {.region = Eigen::AlignedBox3d(Eigen::Vector3d(0.5, -1, 2), Eigen::Vector3d(4.5, 3, 9))});
        QVERIFY2(taken, taken ? "" : taken.error().text().c_str());
        QCOMPARE(taken->tetrahedra->size(), std::size_t(3 * 3 * 4 * 6)); // cubes 1..4 x 0..3 x 2..6
        QCOMPARE(taken->pointCount(), std::uint64_t(4 * 4 * 5));
        for (const auto& corners : *taken->tetrahedra)
            for (const std::uint32_t point : corners) // the values are the numbers that the points had
                QCOMPARE(taken->position(point), dataset.position(static_cast<std::uint64_t>(taken->values.at(point))));
        QVERIFY(boundaryIsManifold(*taken->tetrahedra));
        QVERIFY(!takePart(dataset,
                          {.region = Eigen::AlignedBox3d(Eigen::Vector3d(0.1, 0.1, 0.1), Eigen::Vector3d(0.9, 5, 5))}));
    }

    void whatHangsByAPointOrAnEdgeGoes()
    {
        const Dataset dataset = irregular(4);
        const auto& all = *dataset.tetrahedra;
        std::mt19937 random(9);
        for (std::uint32_t round = 0; round < rounds; ++round) {
            std::vector<std::uint8_t> chosen(all.size());
            const unsigned share = 1 + random() % 9;
            for (std::uint8_t& one : chosen)
                one = random() % 10 < share;
            const std::vector<std::uint8_t> before = chosen;
            const auto removed = restrictToManifold(all, static_cast<std::uint32_t>(dataset.pointCount()), chosen);
            std::vector<std::array<std::uint32_t, 4>> left;
            std::uint64_t gone = 0;
            for (std::size_t i = 0; i < all.size(); ++i) {
                QVERIFY(chosen[i] <= before[i]);
                gone += before[i] - chosen[i];
                if (chosen[i] != 0)
                    left.push_back(all[i]);
            }
            QCOMPARE(removed, gone);
            QVERIFY(boundaryIsManifold(left));
        }
        std::vector<std::uint8_t> whole(all.size(), 1);
        QCOMPARE(restrictToManifold(all, static_cast<std::uint32_t>(dataset.pointCount()), whole), std::uint64_t(0));
    }

    void aCancelledPartIsNone()
    {
        std::stop_source stop;
        stop.request_stop();
        const auto taken = takePart(grid("c60", 8), {.stride = {2, 2, 2}}, Progress(stop.get_token(), {}));
        QVERIFY(!taken);
        QCOMPARE(taken.error().kind, ErrorKind::Cancelled);
    }
};

QTEST_GUILESS_MAIN(DatasetPartTest)
#include "dataset_part_test.moc"
