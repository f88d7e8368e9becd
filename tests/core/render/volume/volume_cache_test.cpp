// SPDX-License-Identifier: GPL-3.0-or-later
// What a volume is made of is made once and again only where it has to be.
#include "core/render/volume/volume_mesh.h"
#include "tests/core/render/volume/volume_meshes.h"

#include <tan/mesh.h>
#include <tan/render.h>

#include <QTest>

using namespace tetra;

namespace {

TransferFunction ramp(float opacity)
{
    return transferFunctionFromPoints({{0, {1, 0, 0}, 0}, {1, {0, 0, 1}, opacity}}, 0.5);
}

Volume made(VolumeCache& maker, const TransferFunction& function, bool shaded = false)
{
    auto volume = maker.update(function, shaded);
    if (!volume)
        qFatal("%s", volume.error().text().c_str());
    return *std::move(volume);
}

} // namespace

class VolumeCacheTest : public QObject {
    Q_OBJECT

private slots:
    void keepsWhatFits()
    {
        const auto mesh = std::make_shared<const TetrahedralMesh>(testing::randomLattice(3));
        VolumeCache maker(mesh);
        const Volume first = made(maker, ramp(0.5f));
        QVERIFY(first.mesh->mesh->tetrahedra == inSpatialOrder(*mesh)->tetrahedra);
        QCOMPARE(first.transfer->classes.size(), mesh->tetrahedra.size());
        QVERIFY(!first.shaded);

        const Volume lit = made(maker, ramp(0.5f), true);
        QVERIFY(lit.shaded);
        QCOMPARE(lit.mesh, first.mesh);
        QCOMPARE(lit.transfer, first.transfer);

        const Volume other = made(maker, ramp(0.75f));
        QCOMPARE(other.mesh, first.mesh);
        QVERIFY(other.transfer != first.transfer);
        QVERIFY(other.transfer->segments[1].perValue.extinction != first.transfer->segments[1].perValue.extinction);
    }

    void badFunctionsAreErrorsAndForgotten()
    {
        VolumeCache maker(std::make_shared<const TetrahedralMesh>(testing::oneCell()));
        TransferFunction descending = ramp(0.5f);
        std::swap(descending.opacities[0], descending.opacities[1]);
        for (int turn = 0; turn < 2; ++turn)
            QVERIFY(!maker.update(descending, false).ok());
        QCOMPARE(made(maker, ramp(0.5f)).transfer->segments.size(), std::size_t(3));
    }

    void reportsAndCancels()
    {
        VolumeCache maker(std::make_shared<const TetrahedralMesh>(testing::oneCell()));
        std::stop_source stop;
        double last = 0;
        bool falls = false;
        const Progress progress(stop.get_token(), [&](double fraction, const Message&) {
            falls |= fraction < last;
            last = fraction;
        });
        QVERIFY(maker.update(ramp(0.5f), false, progress).ok());
        QCOMPARE(last, 1.0);
        QVERIFY(!falls);
        stop.request_stop();
        QCOMPARE(maker.update(ramp(1), false, progress).error().kind, ErrorKind::Cancelled);
        QVERIFY(maker.update(ramp(1), false).ok());
    }
};

QTEST_GUILESS_MAIN(VolumeCacheTest)
#include "volume_cache_test.moc"
