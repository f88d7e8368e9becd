// SPDX-License-Identifier: GPL-3.0-or-later
// The renderers of examples/: both back ends draw the same of what they make (B4). Skipped where there is no
// OpenGL 3.3.
#include "tests/core/render/lattice_mesh.h"
#include "tests/examples/example_plugins.h"
#include "tests/lacks.h"
#include "tests/render/same_picture.h"

#include <tan/render.h>

#include <QTest>

#include <cmath>

using namespace tetra;
using namespace tetra::testing;

namespace {

const PictureOptions options{.width = 160, .height = 120, .background = {0.2f, 0.3f, 0.1f}};
const Eigen::AlignedBox3d box(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(4, 4, 4));

double wavy(const Eigen::Vector3d& place)
{
    return 0.5 + 0.4 * std::sin(2 * place.x()) * std::cos(1.5 * place.y()) + 0.05 * place.z();
}

struct Look {
    const char* name;
    const char* mode;
    ParameterValues values;
};

std::vector<Look> looks()
{
    return {
        {"slice", "example.slice", {{"height", 47.0}}},
        {"slice without arrows", "example.slice", {{"height", 20.0}, {"arrows", false}}},
        {"slice clipped", "example.slice", {{"height", 47.0}, {"clip", std::string("1,0.5,0,2")}}},
        {"projection", "example.projection", {}},
        {"projection above", "example.projection", {{"threshold", 60.0}}},
        {"projection clipped", "example.projection", {{"clip", std::string("1,0.5,0,2")}}},
        {"shells", "example.shells", {{"band", OwnValue{"example.band", R"({"low": 0.3, "high": 0.9})"}}}},
    };
}

/// Pixels that show more than the background.
int drawnPixels(const Picture& picture)
{
    const auto& background = pixelAt(picture, 0, 0);
    return static_cast<int>(
        std::ranges::count_if(picture.pixels, [&](const auto& pixel) { return difference(pixel, background) > 2; }));
}

} // namespace

class ExamplePicturesTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        auto backend = makeGlBackend();
        if (!backend) {
            noteLack("OpenGL");
            QSKIP(("skipped: " + backend.error().text()).c_str());
        }
        gl_ = std::move(*backend);
        host_ = hostWithExamples();
    }

    void sameOnBothBackEnds_data()
    {
        QTest::addColumn<qsizetype>("look");
        QTest::addColumn<bool>("perspective");
        const auto all = looks();
        for (const bool perspective : {true, false})
            for (std::size_t look = 0; look < all.size(); ++look)
                QTest::addRow("%s%s", all[look].name, perspective ? "" : " orthographic")
                    << static_cast<qsizetype>(look) << perspective;
    }
    void sameOnBothBackEnds()
    {
        QFETCH(qsizetype, look);
        QFETCH(bool, perspective);
        const auto all = looks();
        const auto scene =
            sceneOf(all[static_cast<std::size_t>(look)].mode, all[static_cast<std::size_t>(look)].values);
        Camera camera{.azimuth = 25, .elevation = 35};
        camera.perspective = perspective;
        camera = fitted(camera, box);
        PictureOptions single = options;
        single.width *= options.samplesPerAxis;
        single.height *= options.samplesPerAxis;
        single.samplesPerAxis = 1;
        const SamplePictures samples{rendered(*cpu_, *scene, camera, single), rendered(*gl_, *scene, camera, single),
                                     options.samplesPerAxis};
        const Picture cpu = rendered(*cpu_, *scene, camera, options);
        QVERIFY(drawnPixels(cpu) > options.width * options.height / 20);
        const QString name = QString("example_%1").arg(QTest::currentDataTag()).replace(' ', '_');
        QVERIFY(samePicture(cpu, rendered(*gl_, *scene, camera, options), rendered(*gl_, *scene, camera, options), name,
                            1, &samples));
    }

    /// They face the eye: another camera, another shape, of one scene.
    void arrowsFollowTheCamera()
    {
        const auto with = sceneOf("example.slice", {});
        const auto without = sceneOf("example.slice", {{"arrows", false}});
        for (const double azimuth : {0.0, 140.0}) {
            const Camera camera = fitted({.azimuth = azimuth, .elevation = 50}, box);
            const Picture picture = rendered(*cpu_, *with, camera, options);
            QVERIFY(picture.pixels != rendered(*cpu_, *without, camera, options).pixels);
            QVERIFY(samePicture(picture, rendered(*gl_, *with, camera, options), rendered(*gl_, *with, camera, options),
                                "example_arrows", 3));
        }
    }

private:
    /// As the program has it: the host fills in what is not chosen.
    std::shared_ptr<const Scene> sceneOf(const std::string& mode, const ParameterValues& values)
    {
        const auto renderer = host_->renderer(mode);
        if (!renderer)
            qFatal("%s", renderer.error().text().c_str());
        const auto session = renderer->plugin->open({mesh_, {}, box});
        const auto scene = session->prepare({values}, {});
        if (!scene)
            qFatal("%s", scene.error().text().c_str());
        return *scene;
    }

    std::shared_ptr<const TetrahedralMesh> mesh_ =
        std::make_shared<const TetrahedralMesh>(latticeMesh(6, 4, Split::Six, wavy));
    std::unique_ptr<RenderBackend> cpu_ = makeCpuBackend();
    std::unique_ptr<RenderBackend> gl_;
    std::unique_ptr<PluginHost> host_;
};

QTEST_GUILESS_MAIN(ExamplePicturesTest)
#include "pictures_test.moc"
