// SPDX-License-Identifier: GPL-3.0-or-later
// Volumes and hybrids of the OpenGL back end against the CPU's (B4, R20, R21). Skipped where EGL gives no OpenGL 3.3.
#include "core/graphics/resolve.h"
#include "core/graphics/volume/volume_renderer.h"
#include "tests/core/graphics/volume/volume_meshes.h"
#include "tests/render/same_picture.h"
#include "tests/render/scenes.h"

#include <QTest>

using namespace tetra;
using namespace tetra::testing;

namespace {

const std::vector<NamedMesh>& meshes()
{
    static const std::vector<NamedMesh> all = volumeMeshes();
    return all;
}

std::vector<NamedFunction> functionsFor(const VolumeMesh& mesh)
{
    const auto [low, high] = std::ranges::minmax(mesh.mesh->values);
    return volumeFunctions(low, high, mesh.bounds.diagonal().norm() / 10);
}

Volume volumeOf(const TetrahedralMesh& tetrahedra, const std::string& functionName)
{
    auto mesh = makeVolumeMesh(std::make_shared<const TetrahedralMesh>(tetrahedra));
    if (!mesh)
        qFatal("%s", mesh.error().text.c_str());
    const auto functions = functionsFor(*mesh);
    const auto function = std::ranges::find(functions, functionName, &NamedFunction::name);
    auto transfer = makeVolumeTransfer(tetrahedra, function->function);
    if (!transfer)
        qFatal("%s", transfer.error().text.c_str());
    return {std::make_shared<VolumeMesh>(std::move(*mesh)), std::make_shared<VolumeTransfer>(std::move(*transfer))};
}

Volume volumeNamed(const std::string& meshName, const std::string& functionName)
{
    return volumeOf(std::ranges::find(meshes(), meshName, &NamedMesh::name)->mesh, functionName);
}

/// What the CPU's volume renderer makes of a scene with nothing else.
Picture volumePicture(const Scene& scene, const Camera& camera, const PictureOptions& options)
{
    const VolumeOptions samples{options.width * options.samplesPerAxis, options.height * options.samplesPerAxis};
    const auto order = orderForCamera(*scene.volume->mesh, camera, samples);
    auto volume = drawVolume(*scene.volume->mesh, *scene.volume->transfer, order->cells, camera, samples);
    if (!volume)
        qFatal("%s", volume.error().text.c_str());
    if (!options.transparentBackground)
        for (auto& sample : volume->samples) {
            const float light = 1 - sample[3];
            sample = {sample[0] + light * options.background.red, sample[1] + light * options.background.green,
                      sample[2] + light * options.background.blue, 1};
        }
    Picture picture{options.width, options.height, {}};
    picture.pixels.resize(static_cast<std::size_t>(options.width * options.height));
    resolve(volume->samples, samples.width, options.samplesPerAxis, 0, 0, picture);
    return picture;
}

/// The part of the pixels that are not `colour`: something is seen there.
double shareOfOther(const Picture& picture, const std::array<std::uint8_t, 4>& colour)
{
    const auto same = std::ranges::count(picture.pixels, colour);
    return 1 - static_cast<double>(same) / static_cast<double>(picture.pixels.size());
}

Camera cameraFor(const Scene& scene, bool perspective)
{
    Camera camera;
    camera.azimuth = 33;
    camera.elevation = 21;
    camera.perspective = perspective;
    return zoomed(fitted(camera, scene.bounds), 0.8);
}

} // namespace

class GlVolumeTest : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<RenderBackend> gl_;

    /// Checks that OpenGL's picture is `expected`, twice, and that there is something to be seen.
    void compare(const Picture& expected, const Scene& scene, const Camera& camera, const PictureOptions& options,
                 double leastSeen = 0.05)
    {
        QVERIFY(shareOfOther(expected, expected.pixels.front()) > leastSeen);
        const Picture gl = rendered(*gl_, scene, camera, options);
        const Picture again = rendered(*gl_, scene, camera, options);
        const QString name = QString("gl_volume_%1_%2").arg(QTest::currentTestFunction(), QTest::currentDataTag());
        QVERIFY(samePicture(expected, gl, again, QString(name).replace(' ', '_').remove(',')));
    }

private slots:
    void initTestCase()
    {
        auto backend = makeGlBackend();
        if (!backend)
            QSKIP(("skipped: " + backend.error().text).c_str());
        gl_ = std::move(*backend);
    }

    void sameAsTheCpu_data()
    {
        QTest::addColumn<QString>("mesh");
        QTest::addColumn<QString>("function");
        QTest::addColumn<bool>("perspective");
        for (const NamedMesh& mesh : meshes())
            for (const char* function : {"ramp", "ramps", "steps", "spikes", "opaque"})
                for (const bool perspective : {true, false})
                    QTest::addRow("%s, %s, %s", mesh.name.c_str(), function,
                                  perspective ? "perspective" : "orthographic")
                        << QString::fromStdString(mesh.name) << QString(function) << perspective;
    }
    void sameAsTheCpu()
    {
        QFETCH(QString, mesh);
        QFETCH(QString, function);
        QFETCH(bool, perspective);
        Scene scene;
        scene.volume = volumeNamed(mesh.toStdString(), function.toStdString());
        scene.bounds = scene.volume->mesh->bounds;
        const Camera camera = cameraFor(scene, perspective);
        const PictureOptions options{.width = 90, .height = 60, .background = {0.2f, 0.5f, 0.3f}};
        compare(volumePicture(scene, camera, options), scene, camera, options);
    }
};

QTEST_GUILESS_MAIN(GlVolumeTest)
#include "gl_volume_test.moc"
