// SPDX-License-Identifier: GPL-3.0-or-later
// Several isosurfaces at once, each with its colour and opacity (R19), extracted only once.
#include "tests/core/render/lattice_mesh.h"
#include "tests/core/render/same_surface.h"

#include <tan/render.h>

#include <tbb/task_arena.h>

#include <QTest>

#include <cmath>
#include <new>
#include <set>
#include <tuple>
#include <utility>

using namespace tetra;
using testing::latticeMesh;
using testing::Split;

namespace {

std::shared_ptr<const TetrahedralMesh> cone()
{
    return std::make_shared<const TetrahedralMesh>(
        latticeMesh(12, 1, Split::Six, [](const Eigen::Vector3d& p) { return (p.array() - 0.5).matrix().norm(); }));
}

Isovalue at(double value)
{
    Isovalue isovalue;
    isovalue.value = value;
    return isovalue;
}

std::vector<Surface> surfacesOf(IsosurfaceCache& set, const std::vector<Isovalue>& isovalues)
{
    auto surfaces = set.update(isovalues);
    if (!surfaces)
        qFatal("%s", surfaces.error().text().c_str());
    return *std::move(surfaces);
}

} // namespace

class IsosurfaceCacheTest : public QObject {
    Q_OBJECT

private slots:
    /// Each of several surfaces is just what the extraction gives for its value alone.
    void severalIsovaluesAtOnce()
    {
        const auto mesh = cone();
        const auto gradients = vertexGradients(*mesh);
        IsosurfaceCache set(mesh);
        const std::vector<Isovalue> isovalues = {at(0.3), {0.2, 1, 0, 0, 0.25f, true}, at(0.4), at(0.3)};
        const auto surfaces = surfacesOf(set, isovalues);
        QCOMPARE(surfaces.size(), isovalues.size());
        for (std::size_t i = 0; i < isovalues.size(); ++i) {
            const auto alone = extractIsosurface(*mesh, gradients, isovalues[i].value);
            QVERIFY(!alone->triangles.empty());
            QVERIFY(alone->positions == surfaces[i].mesh->positions);
            QVERIFY(alone->triangles == surfaces[i].mesh->triangles);
        }
        QCOMPARE(surfaces[1].opacity, 0.25f);
        QCOMPARE(surfaces[1].colour.red, 1.0f);
    }

    /// From the second extraction on of the mesh in spatial order, by an index.
    void laterSurfacesAreTheSame()
    {
        const auto mesh = cone();
        const auto gradients = vertexGradients(*mesh);
        IsosurfaceCache set(mesh);
        for (const double isovalue : {0.3, 0.35, 0.4, 0.3}) {
            const auto surfaces = surfacesOf(set, {at(isovalue)});
            const auto alone = extractIsosurface(*mesh, gradients, isovalue);
            QVERIFY(testing::sameSurface(*surfaces[0].mesh, *alone));
            QVERIFY(testing::sameNormals(*surfaces[0].mesh, *alone));
        }
        const auto ordered = std::make_shared<OrderedMesh>(mesh);
        QVERIFY(ordered->ordered().ok());
        IsosurfaceCache fromOrdered(ordered);
        QVERIFY(testing::sameSurface(*surfacesOf(fromOrdered, {at(0.3)})[0].mesh,
                                     *extractIsosurface(*mesh, gradients, 0.3)));
    }

    void appearanceChangesExtractNothing()
    {
        IsosurfaceCache set(cone());
        std::vector<Isovalue> isovalues = {at(0.3), at(0.4)};
        const auto before = surfacesOf(set, isovalues);
        isovalues[0].opacity = 0.5f;
        isovalues[1].red = 0;
        isovalues.push_back(at(0.2));
        const auto after = surfacesOf(set, isovalues);
        QCOMPARE(after[0].mesh, before[0].mesh);
        QCOMPARE(after[1].mesh, before[1].mesh);
        QCOMPARE(after[0].opacity, 0.5f);

        isovalues[0].visible = false;
        QCOMPARE(surfacesOf(set, isovalues).size(), std::size_t(2));
        isovalues[0].visible = true;
        QCOMPARE(surfacesOf(set, isovalues)[0].mesh, before[0].mesh);
    }

    void surfacesOfRemovedValuesAreFreed()
    {
        IsosurfaceCache set(cone());
        auto surfaces = surfacesOf(set, {at(0.3), at(0.4)});
        const std::weak_ptr<const TriangleMesh> removed = surfaces[0].mesh;
        surfaces = surfacesOf(set, {at(0.4)});
        QVERIFY(removed.expired());
    }

    void unseenSurfacesAreNotExtracted()
    {
        IsosurfaceCache set(cone());
        std::vector<Isovalue> isovalues = {at(0.3), at(0.4)};
        isovalues[0].visible = false;
        isovalues[1].opacity = 0;
        QVERIFY(surfacesOf(set, isovalues).empty());
    }

    void badValuesAreErrors()
    {
        IsosurfaceCache set(cone());
        std::vector<Isovalue> bad(3, at(0.3));
        bad[0].value = std::nan("");
        bad[1].opacity = 1.5f;
        bad[2].opacity = std::nanf("");
        QVERIFY(!bad.empty());
        for (const Isovalue& isovalue : bad) {
            const auto surfaces = set.update(std::vector{at(0.4), isovalue});
            QVERIFY(!surfaces.ok());
            QCOMPARE(surfaces.error().kind, ErrorKind::WrongUsage);
        }
    }

    void theFirstFailureStopsTheOthers()
    {
        IsosurfaceCache set(cone());
        double last = 0;
        bool failed = false;
        const Progress progress({}, [&](double fraction, const Message&) {
            last = fraction;
            if (fraction > 0.35 && !std::exchange(failed, true)) // in the midst of a surface
                throw std::bad_alloc();
        });
        const std::vector<Isovalue> isovalues = {at(0.2), at(0.25), at(0.3), at(0.35), at(0.4)};
        tbb::task_arena oneThread(1);
        const auto surfaces = oneThread.execute([&] { return set.update(isovalues, progress); });
        QVERIFY(failed);
        QVERIFY(!surfaces.ok());
        QCOMPARE(surfaces.error().kind, ErrorKind::OutOfResource);
        QVERIFY2(last < 0.5, QByteArray::number(last));
    }

    void reportsAndCancels()
    {
        IsosurfaceCache set(cone());
        std::stop_source stop;
        double last = 0;
        bool falls = false;
        const Progress progress(stop.get_token(), [&](double fraction, const Message&) {
            falls |= fraction < last;
            last = fraction;
        });
        QVERIFY(set.update(std::vector{at(0.2), at(0.3), at(0.4)}, progress).ok());
        QCOMPARE(last, 1.0);
        QVERIFY(!falls);
        stop.request_stop();
        QCOMPARE(set.update(std::vector{at(0.25)}, progress).error().kind, ErrorKind::Cancelled);
        QVERIFY(set.update(std::vector{at(0.25)}).ok());
    }

    void furtherColoursAreDistinct()
    {
        std::set<std::tuple<float, float, float>> seen;
        for (std::size_t i = 0; i < 7; ++i) {
            const Colour colour = distinctColour(i);
            QVERIFY(seen.insert({colour.red, colour.green, colour.blue}).second);
        }
        QCOMPARE(distinctColour(7).red, distinctColour(0).red);
    }
};

QTEST_GUILESS_MAIN(IsosurfaceCacheTest)
#include "isosurface_cache_test.moc"
