// SPDX-License-Identifier: GPL-3.0-or-later
// What the graphics card computes (OpenGL 4.3): sums, sorting, and keys that order every face exactly (S14). Skipped
// where EGL gives no OpenGL with compute shaders.
#include "core/graphics/gl/compute/card_keys.h"
#include "core/graphics/gl/compute/key_sort.h"
#include "core/graphics/gl/egl_context.h"
#include "core/mesh/spatial_order.h"
#include "tests/core/graphics/lattice_mesh.h"
#include "tests/core/graphics/volume/exact_order.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <random>

using namespace tetra;
using namespace tetra::testing;

namespace {

using Pair = std::array<std::uint32_t, 2>;

double nothingAt(const Eigen::Vector3d&)
{
    return 0;
}

VolumeMesh volumeOf(const TetrahedralMesh& mesh)
{
    return makeVolumeMesh(std::make_shared<const TetrahedralMesh>(mesh)).value();
}

} // namespace

class GlComputeTest : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<EglContext> egl_;
    std::optional<EglContext::Current> current_;
    std::optional<GlFunctions> gl_;
    std::optional<ComputeFunctions> compute_;
    ComputePrograms programs_;

    ComputeContext context() const { return {*gl_, *compute_}; }

    std::vector<std::uint32_t> wordsOf(const StorageBuffer& buffer, std::size_t count)
    {
        std::vector<std::uint32_t> words(count);
        if (count > 0)
            buffer.read(context(), 0, std::as_writable_bytes(std::span(words)));
        return words;
    }

    /// The keys for an eye, none if they did not come to an end.
    std::vector<std::uint32_t> keysFor(const CardMesh& mesh, const EyePoint& eye, const Eigen::AlignedBox3d& bounds,
                                       unsigned& rounds)
    {
        CardKeys keys;
        const Result<bool> made = keys.make(context(), programs_, mesh, eye, bounds);
        if (!made)
            qFatal("%s", made.error().text.c_str());
        rounds = std::max(rounds, keys.rounds());
        return *made ? wordsOf(keys.keys(), mesh.cellCount) : std::vector<std::uint32_t>();
    }

    /// Checks all faces for eyes around a mesh; the most rounds that it took.
    unsigned checkOrders(const VolumeMesh& volume, std::span<const EyePoint> eyes)
    {
        CardMesh mesh;
        if (const Status status = fillMesh(context(), volume, mesh); !status)
            qFatal("%s", status.error().text.c_str());
        unsigned rounds = 0;
        for (const EyePoint& eye : eyes) {
            const auto keys = keysFor(mesh, eye, volume.bounds, rounds);
            if (keys.size() != mesh.cellCount)
                qFatal("no order");
            const FacesInOrder faces = checkFaces(*volume.mesh, volume.adjacency, eye, keys);
            if (faces.wrong > 0 || faces.compared < mesh.cellCount / 2)
                qFatal("%zu of %zu faces are wrong", faces.wrong, faces.compared);
        }
        return rounds;
    }

private slots:
    void initTestCase()
    {
        auto made = EglContext::make();
        if (!made)
            QSKIP(("skipped: " + made.error().text).c_str());
        egl_ = std::move(*made);
        current_.emplace(*egl_);
        gl_.emplace(egl_->getProcAddress());
        compute_.emplace(egl_->getProcAddress());
        if (const Status status = checkCompute(*gl_, *compute_); !status)
            QSKIP(("skipped: " + status.error().text).c_str());
        Result<ComputePrograms> programs = makeComputePrograms(*gl_);
        QVERIFY2(programs.ok(), programs.ok() ? "" : programs.error().text.c_str());
        programs_ = std::move(*programs);
    }

    void cleanupTestCase()
    {
        programs_ = {};
        current_.reset();
    }

    void sums()
    {
        std::mt19937 random(4);
        PrefixSums sums;
        for (const std::size_t count : {1u, 7u, 8u, 2047u, 2048u, 2049u, 100000u, 2048u * 2048u + 5u, 3u}) {
            std::vector<std::uint32_t> numbers(count), expected(count);
            std::ranges::generate(numbers, [&] { return random() % 1000; });
            std::exclusive_scan(numbers.begin(), numbers.end(), expected.begin(), 0u);
            StorageBuffer buffer;
            buffer.fill(context(), std::as_bytes(std::span(numbers)));
            sums.run(context(), *programs_.sums, buffer, count);
            QVERIFY(wordsOf(buffer, count) == expected);
        }
    }

    /// Equal keys stay as they are; bits that do not count are not looked at.
    void sorting()
    {
        std::mt19937 random(5);
        KeySort sort;
        for (const std::size_t count : {1u, 15u, 16u, 17u, 4095u, 100003u})
            for (const unsigned bits : {4u, 17u, 32u}) {
                std::vector<Pair> pairs(count);
                for (std::uint32_t i = 0; i < count; ++i)
                    pairs[i] = {static_cast<std::uint32_t>(i % 3 == 0 ? random() : random() % 7), i};
                sort.reserve(context(), count);
                StorageBuffer start;
                start.fill(context(), std::as_bytes(std::span(pairs)));
                gl_->bindBuffer(gl::shaderStorageBuffer, sort.pairs().name());
                gl_->bufferData(gl::shaderStorageBuffer, static_cast<std::ptrdiff_t>(count * sizeof(Pair)),
                                pairs.data(), gl::dynamicCopy);
                sort.run(context(), programs_, count, bits);
                const std::uint32_t mask = bits > 28 ? ~0u : (1u << (bits + 3) / 4 * 4) - 1;
                std::ranges::stable_sort(pairs, {}, [&](const Pair& pair) { return pair[0] & mask; });
                std::vector<Pair> sorted(count);
                sort.pairs().read(context(), 0, std::as_writable_bytes(std::span(sorted)));
                QVERIFY(sorted == pairs);
            }
    }

    /// Without a tolerance: from anywhere outside and inside, in planes of the lattice and hardly beside them. Delaunay
    /// meshes take few rounds.
    void everyFaceIsExactlyRight()
    {
        std::mt19937 random(16);
        for (const NamedMesh& named : delaunayMeshes())
            for (const bool spatial : {false, true}) {
                const VolumeMesh volume = volumeOf(spatial ? inSpatialOrder(named.mesh).value() : named.mesh);
                const unsigned rounds = checkOrders(volume, eyesAround(volume.bounds, 40, random));
                qInfo("%s: %u rounds", named.name.c_str(), rounds);
                QVERIFY(rounds <= 64);
            }
    }

    void ties_data()
    {
        QTest::addColumn<int>("split");
        QTest::addColumn<double>("tilt");
        for (const int split : {5, 6})
            for (const double tilt : {0.0, 1e-3, 1e-6, 1e-9})
                QTest::addRow("%d, %g", split, tilt) << split << tilt;
    }
    /// Where nearly all cells are in ties: all of a cube, and of whole planes of cubes; from along the axes and a
    /// little beside, where keys cannot tell the cubes of a row.
    void ties()
    {
        QFETCH(int, split);
        QFETCH(double, tilt);
        const VolumeMesh volume = volumeOf(boxLattice(9, split == 5 ? Split::Five : Split::Six));
        const Eigen::Vector3d centre = volume.bounds.center();
        std::vector<EyePoint> eyes;
        for (int axis = 0; axis < 3; ++axis)
            for (const double side : {-1.0, 1.0}) {
                const Eigen::Vector3d along = side * Eigen::Vector3d::Unit(axis);
                const Eigen::Vector3d direction = along + tilt * Eigen::Vector3d(1, 0.7, -0.4);
                eyes.push_back({direction, false});
                eyes.push_back({centre + 1000 * direction, true});
                eyes.push_back({volume.bounds.max().cwiseProduct(direction.cwiseAbs()) + 3 * along, true});
            }
        const unsigned rounds = checkOrders(volume, eyes);
        qInfo("%u rounds", rounds);
    }

    /// The keys do not depend on what ran first.
    void keysAreTheSameAgain()
    {
        const VolumeMesh volume = volumeOf(boxLattice(9, Split::Six));
        CardMesh mesh;
        QVERIFY(fillMesh(context(), volume, mesh).ok());
        unsigned rounds = 0;
        const EyePoint eye{{20, 31, 17}, true};
        const auto keys = keysFor(mesh, eye, volume.bounds, rounds);
        for (int i = 0; i < 5; ++i)
            QVERIFY(keysFor(mesh, eye, volume.bounds, rounds) == keys);
    }

    /// What is not Delaunay takes more rounds, and is as right.
    void otherMeshes()
    {
        for (const float most : {0.01f, 0.06f, 0.12f}) {
            const VolumeMesh volume = volumeOf(shakenLattice(most));
            QVERIFY(volume.convex);
            std::mt19937 random(8);
            const unsigned rounds = checkOrders(volume, eyesAround(volume.bounds, 20, random));
            qInfo("%g: %u rounds", double(most), rounds);
        }
    }

    /// Cells that lie before each other in a circle have no order, which is found out.
    void circles()
    {
        VolumeMesh volume = volumeOf(latticeMesh(2, 2, Split::Five, nothingAt));
        const EyePoint eye{{10.3, 12.1, 14.7}, true};
        const Buffer<std::uint8_t> facing = faceFacing(*volume.mesh, eye);
        std::array<std::uint32_t, 3> seen{};
        for (std::uint32_t cell = 0; cell < 3; ++cell)
            while ((facing[cell] >> seen[cell] & 1) == 0)
                ++seen[cell];
        for (std::uint32_t cell = 0; cell < 3; ++cell) {
            const std::uint32_t next = (cell + 1) % 3;
            volume.adjacency.neighbours[cell].fill(FaceAdjacency::none);
            volume.adjacency.neighbours[cell][seen[cell]] = next * 4;
        }
        CardMesh mesh;
        QVERIFY(fillMesh(context(), volume, mesh).ok());
        CardKeys keys;
        const Result<bool> made = keys.make(context(), programs_, mesh, eye, volume.bounds);
        QVERIFY(made.ok() && !*made);
        QVERIFY(keys.rounds() == CardKeys::mostRounds);
    }

    void takesAnOrder()
    {
        const std::vector<std::uint32_t> order{3, 0, 4, 2, 1};
        CardKeys keys;
        keys.take(context(), order);
        QCOMPARE(wordsOf(keys.keys(), 5), (std::vector<std::uint32_t>{1, 4, 3, 0, 2}));
        QCOMPARE(keys.bits(), 3u);
    }

    void noCells()
    {
        CardMesh mesh;
        QVERIFY(fillMesh(context(), volumeOf({}), mesh).ok());
        CardKeys keys;
        QVERIFY(*keys.make(context(), programs_, mesh, {}, {}));
    }
};

QTEST_GUILESS_MAIN(GlComputeTest)
#include "gl_compute_test.moc"
