// SPDX-License-Identifier: GPL-3.0-or-later
// Boundaries of meshes with holes on the OpenGL back end against the CPU's (B4), by TAN_GL_LEVEL at most: colours of
// vertices, translucent ones in the volume, and without what faces the eye. Skipped where EGL gives no OpenGL 3.3.
#include "tests/core/render/scene_parts.h"
#include "tests/render/boundary_scenes.h"
#include "tests/render/gl_test.h"
#include "tests/render/same_picture.h"
#include "tests/soak.h"

#include <QTest>

using namespace tetra;
using namespace tetra::testing;

class GlBoundaryTest : public GlTest {
    Q_OBJECT

private slots:
    void initTestCase() { makeGl(); }

    void sameAsTheCpu_data()
    {
        QTest::addColumn<QString>("look");
        QTest::addColumn<bool>("volume");
        QTest::addColumn<bool>("perspective");
        int row = 0;
        for (const char* look : {"translucent", "values", "far side", "faint values"})
            for (const bool volume : {false, true})
                for (const bool perspective : {false, true})
                    if (takesRow(row))
                        QTest::addRow("%s%s%s", look, volume ? ", volume" : "", perspective ? "" : ", orthographic")
                            << QString(look) << volume << perspective;
    }
    void sameAsTheCpu()
    {
        QFETCH(QString, look);
        QFETCH(bool, volume);
        QFETCH(bool, perspective);
        for (const unsigned seed : {1u, 2u}) {
            if (volume && seed == 1)
                continue; // volumes take their time; they are cut open
            SceneParts scene = boundaryScene(seed, look, volume);
            const Camera camera = boundaryCamera(scene, perspective);
            if (seed == 2)
                scene.clipPlanes = {{{0, 1, 0}, 0.7}};
            const PictureOptions options{.width = 100, .height = 75, .background = {0.2f, 0.5f, 0.3f}};
            PictureOptions single = options;
            single.width *= options.samplesPerAxis;
            single.height *= options.samplesPerAxis;
            single.samplesPerAxis = 1;
            const SamplePictures samples{rendered(*cpu_, scene, camera, single), rendered(*gl_, scene, camera, single),
                                         options.samplesPerAxis};
            // A piece of a triangle between two values may be narrower than a sample.
            constexpr int strays = 1;
            const QString name = QString("gl_boundary_%1_%2").arg(QTest::currentDataTag()).arg(seed);
            QVERIFY(samePicture(rendered(*cpu_, scene, camera, options), rendered(*gl_, scene, camera, options),
                                rendered(*gl_, scene, camera, options), QString(name).replace(' ', '_').remove(','),
                                strays, &samples));
        }
    }

    /// From within, where triangles reach behind the eye.
    void eyeInTheMesh()
    {
        for (const bool backFacesOnly : {false, true}) {
            SceneParts scene = boundaryScene(4, "values", false);
            scene.surfaces[0].backFacesOnly = backFacesOnly;
            Camera camera = boundaryCamera(scene, true);
            camera.distance = 0.2;
            camera.fieldOfView = 80;
            const PictureOptions options{.width = 150, .height = 110};
            const Picture gl = rendered(*gl_, scene, camera, options);
            QVERIFY(samePicture(rendered(*cpu_, scene, camera, options), gl, gl, "gl_boundary_within", 2));
        }
    }
};

QTEST_GUILESS_MAIN(GlBoundaryTest)
#include "gl_boundary_test.moc"
