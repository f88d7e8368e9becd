// SPDX-License-Identifier: GPL-3.0-or-later
// A packed mesh is the mesh, in few bytes, and bytes from anywhere are a mesh or an error (R28, C16).
#include "core/packed/packed_mesh.h"

#include "core/base/checksum.h"
#include "tests/core/history/query/some_models.h"
#include "tests/core/packed/any_order.h"

#include <tan/query.h>

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <random>

using namespace tetra;

namespace {

/// The bytes that the mesh was packed to; none if it does not come back.
std::vector<std::byte> thereAndBack(const TetrahedralMesh& mesh, std::span<const float> births = {},
                                    std::span<const float> deaths = {}, const PlaceScale& scale = {})
{
    const auto packed = packMesh(mesh, births, deaths, "facts", scale);
    if (!packed) {
        qWarning("%s", packed.error().text().c_str());
        return {};
    }
    const auto unpacked = unpackMesh(*packed, mesh.tetrahedra.size() + mesh.positions.size());
    if (!unpacked) {
        qWarning("%s", unpacked.error().text().c_str());
        return {};
    }
    const bool same =
        unpacked->facts == "facts" &&
        inAnyOrder(mesh, births, deaths) == inAnyOrder(unpacked->mesh, unpacked->birthErrors, unpacked->deathErrors);
    return same ? *packed : std::vector<std::byte>();
}

/// Tetrahedra of any vertices: over each other, with faces of many sides, some a corner twice.
TetrahedralMesh randomSoup(std::mt19937& random, std::size_t vertices, std::size_t tetrahedra)
{
    TetrahedralMesh mesh;
    std::uniform_real_distribution<float> number(-1, 1);
    for (std::size_t i = 0; i < vertices; ++i) {
        mesh.positions.emplace_back(number(random), number(random), number(random));
        mesh.values.push_back(number(random) * 1e30f);
    }
    for (std::size_t i = 0; i < tetrahedra; ++i) {
        std::array<std::uint32_t, 4> corners{};
        for (std::uint32_t& corner : corners)
            corner = static_cast<std::uint32_t>(random() % vertices);
        mesh.tetrahedra.push_back(corners);
    }
    return mesh;
}

void repairSum(std::vector<std::byte>& packed)
{
    const std::uint64_t sum = checksum(std::span(packed).first(packed.size() - 8));
    std::memcpy(packed.data() + packed.size() - 8, &sum, sizeof sum);
}

} // namespace

class PackedMeshTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        models_ = someModels(folder_.path().toStdString());
        QVERIFY(!models_.empty());
    }

    /// Every query of every kind of data; and a conforming mesh takes a small part of its arrays.
    void meshesOfModelsComeBack()
    {
        for (const SomeModel& some : models_) {
            const ModelDescription& about = some.model->description();
            const Eigen::Vector3d centre = about.bounds.center();
            std::vector<MeshQuery> queries(6);
            queries[1].error = 3;
            queries[2].window = Window{{about.bounds.min(), centre}, WindowBorder::Clipped};
            queries[3].window = Window{{about.bounds.min(), centre}, WindowBorder::Contained};
            queries[4].values = {{about.range.minimum, (about.range.minimum + about.range.maximum) / 2}};
            queries[5].range = LifeRange{{10, anyWarping}, {1, anyWarping}};
            for (std::size_t i = 0; i < queries.size(); ++i) {
                const auto found = MeshExtractor(some.model).extract(queries[i]);
                QVERIFY2(found.ok(), some.name.c_str());
                const ExtractedMesh& mesh = **found;
                const auto packed = thereAndBack(mesh.mesh, mesh.birthErrors, mesh.deathErrors);
                QVERIFY2(!packed.empty(), (some.name + ", query " + std::to_string(i)).c_str());
                // Of positions that no floats hold half of the bytes are as good as random.
                const bool floats = std::ranges::all_of(mesh.mesh.positions, [](const Eigen::Vector3d& position) {
                    return position.cast<float>().cast<double>() == position;
                });
                const std::size_t arrays =
                    (floats ? 16 : 28) * mesh.mesh.positions.size() + 16 * mesh.mesh.tetrahedra.size();
                if (i < 2)
                    QVERIFY2(packed.size() < 200 + arrays / 3, (some.name + ": " + std::to_string(packed.size()) +
                                                                " of " + std::to_string(arrays) + " bytes")
                                                                   .c_str());
            }
        }
    }

    void anyTetrahedraComeBack()
    {
        std::mt19937 random(7);
        for (const auto& [vertices, tetrahedra] : {std::pair<std::size_t, std::size_t>{0, 0},
                                                   {1, 0},
                                                   {5, 0},
                                                   {1, 1},
                                                   {4, 1},
                                                   {4, 30},
                                                   {6, 200},
                                                   {50, 400},
                                                   {3000, 500},
                                                   {300, 20000}}) {
            const auto packed = thereAndBack(randomSoup(random, vertices, tetrahedra));
            QVERIFY2(!packed.empty(), (std::to_string(vertices) + ", " + std::to_string(tetrahedra)).c_str());
        }
    }

    void everyBitOfANumberComesBack()
    {
        std::mt19937 random(8);
        TetrahedralMesh mesh = randomSoup(random, 600, 900);
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            mesh.positions[i][1] = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
            mesh.values[i] = std::array{0.0f,
                                        -0.0f,
                                        std::numeric_limits<float>::infinity(),
                                        -std::numeric_limits<float>::infinity(),
                                        std::numeric_limits<float>::quiet_NaN(),
                                        std::numeric_limits<float>::denorm_min()}[i % 6];
        }
        QVERIFY(!thereAndBack(mesh).empty());
    }

    void everyBitOfADoubleComesBack()
    {
        std::mt19937_64 random(12);
        std::mt19937 soup(12);
        for (const PlaceScale& scale :
             {PlaceScale{}, PlaceScale{{1e9, -3, 0}, {1e-3, 7, 1}}, PlaceScale{{0, 0, 0}, {1e-300, 1e300, 0.1}}}) {
            TetrahedralMesh mesh = randomSoup(soup, 600, 900);
            for (std::size_t i = 0; i < mesh.positions.size(); ++i)
                mesh.positions[i] = {std::bit_cast<double>(random()), mesh.positions[i][1] + 1e-12,
                                     std::array{0.0, -0.0, 0.1, 1e300}[i % 4]};
            QVERIFY(!thereAndBack(mesh, {}, {}, scale).empty());
        }
    }

    /// A lattice takes as little anywhere as where its coordinates are small integers.
    void latticesTakeAsLittleAnywhere()
    {
        const auto lattice = std::ranges::find_if(models_, [](const SomeModel& some) {
            return some.model->description().domain == DomainClass::RegularLattice;
        });
        QVERIFY(lattice != models_.end());
        const auto found = MeshExtractor(lattice->model).extract({.error = 1});
        QVERIFY(found.ok());
        const Lattice& near = lattice->model->description().lattice;
        const PlaceScale scale{{339385.3, 4264212.7, -1e-3}, {0.05, 0.05, 0.1}};
        TetrahedralMesh here = (*found)->mesh, there = here;
        for (std::size_t i = 0; i < here.positions.size(); ++i) {
            here.positions[i] = ((here.positions[i] - near.origin).array() / near.spacing.array()).round();
            there.positions[i] = scale.origin + scale.unit.cwiseProduct(here.positions[i]);
        }
        const auto few = thereAndBack(here), many = thereAndBack(there, {}, {}, scale);
        QVERIFY(!few.empty() && !many.empty());
        QVERIFY2(many.size() < 1.1 * few.size() + 100, qPrintable(QString("%1, %2").arg(few.size()).arg(many.size())));
    }

    void whatDoesNotBelongTogetherIsRefused()
    {
        std::mt19937 random(9);
        TetrahedralMesh mesh = randomSoup(random, 10, 10);
        mesh.tetrahedra[3][2] = 10;
        QCOMPARE(packMesh(mesh, {}, {}, "").error().kind, ErrorKind::WrongUsage);
        mesh.tetrahedra[3][2] = 9;
        const std::vector<float> births(9);
        QCOMPARE(packMesh(mesh, births, births, "").error().kind, ErrorKind::WrongUsage);
        QVERIFY(packMesh(mesh, {}, {}, "").ok());
        mesh.values.pop_back();
        QCOMPARE(packMesh(mesh, {}, {}, "").error().kind, ErrorKind::WrongUsage);
    }

    void moreThanIsWantedIsRefused()
    {
        std::mt19937 random(10);
        const auto packed = packMesh(randomSoup(random, 10, 10), {}, {}, "");
        QVERIFY(unpackMesh(*packed, 10).ok());
        QCOMPARE(unpackMesh(*packed, 9).error().kind, ErrorKind::OutOfResource);
        std::stop_source stop;
        stop.request_stop();
        const auto large = packMesh(randomSoup(random, 10, 5000), {}, {}, "");
        QCOMPARE(unpackMesh(*large, 5000, Progress(stop.get_token(), {})).error().kind, ErrorKind::Cancelled);
        QCOMPARE(packMesh(randomSoup(random, 10, 5000), {}, {}, "", {}, Progress(stop.get_token(), {})).error().kind,
                 ErrorKind::Cancelled);
    }

    /// A damaged one is refused; one that was made to have the right sum gives an error or a mesh whose corners exist.
    void damageIsFoundAndMaliceDoesNoHarm()
    {
        const auto found = MeshExtractor(models_[0].model).extract({.error = 5.0});
        const auto whole = packMesh((*found)->mesh, {}, {}, "facts");
        QVERIFY(whole.ok());
        std::mt19937 random(11);
        int refused = 0, meshes = 0;
        for (int round = 0; round < 600; ++round) {
            std::vector<std::byte> packed = *whole;
            const std::size_t place = round < 56 ? static_cast<std::size_t>(round) : random() % packed.size();
            packed[place] ^= std::byte(1 << random() % 8);
            if (round % 3 == 2)
                packed.resize(random() % packed.size());
            QCOMPARE(unpackMesh(packed, 1 << 20).error().kind, ErrorKind::BadInput);
            if (packed.size() < 8)
                continue;
            repairSum(packed);
            const auto unpacked = unpackMesh(packed, 1 << 20);
            if (!unpacked) {
                ++refused;
                continue;
            }
            ++meshes;
            for (const auto& corners : unpacked->mesh.tetrahedra)
                for (const std::uint32_t corner : corners)
                    QVERIFY(corner < unpacked->mesh.positions.size());
        }
        QVERIFY2(refused > 50 && meshes > 0, (std::to_string(refused) + ", " + std::to_string(meshes)).c_str());
    }

private:
    QTemporaryDir folder_;
    std::vector<SomeModel> models_;
};

QTEST_GUILESS_MAIN(PackedMeshTest)
#include "packed_mesh_test.moc"
