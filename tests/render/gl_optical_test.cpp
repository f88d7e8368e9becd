// SPDX-License-Identifier: GPL-3.0-or-later
// Optical models of one's own on the OpenGL back end against the CPU's (B4): each combination, among surfaces and clip
// planes. Skipped where EGL gives no OpenGL 3.3.
#include "tests/core/render/scene_parts.h"
#include "tests/render/gl_test.h"
#include "tests/render/same_picture.h"
#include "tests/render/volume_scenes.h"
#include "tests/soak.h"

#include <QTest>

#include <cmath>

using namespace tetra;
using namespace tetra::testing;

namespace {

/// Absorbs by the steepness of the field, and glows by the mean value.
std::shared_ptr<const OpticalModel> steepFog()
{
    OpticalModel model;
    model.evaluate = [](const OpticalPieces& pieces) {
        for (std::size_t i = 0; i < pieces.count; ++i) {
            pieces.transmittance[i] = std::exp(-pieces.length[i] * pieces.gradient[i]);
            const float opacity = 1 - pieces.transmittance[i];
            pieces.red[i] = opacity * std::min(1.0f, (pieces.entry[i] + pieces.exit[i]) / 2);
            pieces.green[i] = opacity * 0.5f;
            pieces.blue[i] = opacity * 0.25f;
        }
    };
    model.shader = R"GLSL(
vec4 lightOfPiece(float entry, float exit, float way, float gradient)
{
    float opacity = 1.0 - exp(-way * gradient);
    return vec4(opacity * min(1.0, (entry + exit) * 0.5), opacity * 0.5, opacity * 0.25, opacity);
}
)GLSL";
    return std::make_shared<const OpticalModel>(model);
}

double wavy(const Eigen::Vector3d& place)
{
    return 0.5 + 0.4 * std::sin(2 * place.x()) * std::cos(1.5 * place.y()) + 0.05 * place.z();
}

} // namespace

class GlOpticalTest : public GlTest {
    Q_OBJECT

private slots:
    void initTestCase() { makeGl(); }

    void sameAsTheCpu_data()
    {
        QTest::addColumn<QString>("model");
        QTest::addColumn<QString>("beside");
        QTest::addColumn<bool>("perspective");
        int row = 0;
        for (const char* model : {"over", "maximum", "sum"})
            for (const char* beside : {"nothing", "surfaces", "planes"})
                for (const bool perspective : {false, true})
                    if (takesRow(row, 5))
                        QTest::addRow("%s, %s%s", model, beside, perspective ? "" : ", orthographic")
                            << QString(model) << QString(beside) << perspective;
    }
    void sameAsTheCpu()
    {
        QFETCH(QString, model);
        QFETCH(QString, beside);
        QFETCH(bool, perspective);
        // Transparent below 0.3, where the models are not asked.
        SceneParts scene = volumeScene(latticeMesh(5, 4, Split::Six, wavy),
                                       transferFunctionFromPoints({{0.3, {1, 1, 1}, 0}, {0.3, {1, 1, 1}, 0.5f}}));
        scene.volume->model = model == "over"      ? steepFog()
                              : model == "maximum" ? maximumIntensity(0.3, 1.1, {1, 0.7f, 0.4f})
                                                   : xRay(0.3, 1.1, 3, {0.4f, 0.7f, 1});
        if (beside == "surfaces") {
            addLayer(scene, 0.45, {0.9f, 0.1f, 0.2f}, 0.4f);
            addLayer(scene, 0.8, {0.2f, 0.8f, 0.3f}, 1);
        }
        if (beside == "planes")
            scene.clipPlanes = {{{1, 0.5, 0}, 2}, {{0, 0, -1}, -3}};
        const Camera camera = cameraAround(scene.bounds, perspective);
        const PictureOptions options{.width = 100, .height = 75, .background = {0.2f, 0.3f, 0.1f}};
        PictureOptions single = options;
        single.width *= options.samplesPerAxis;
        single.height *= options.samplesPerAxis;
        single.samplesPerAxis = 1;
        const SamplePictures samples{rendered(*cpu_, scene, camera, single), rendered(*gl_, scene, camera, single),
                                     options.samplesPerAxis};
        const QString name = QString("gl_optical_%1").arg(QTest::currentDataTag()).replace(' ', '_').remove(',');
        const Picture cpu = rendered(*cpu_, scene, camera, options);
        QVERIFY(samePicture(cpu, rendered(*gl_, scene, camera, options), rendered(*gl_, scene, camera, options), name,
                            1, &samples));
        scene.volume->model = nullptr;
        QVERIFY(rendered(*cpu_, scene, camera, options).pixels != cpu.pixels);
    }

    void depthsAreThoseOfSurfaces()
    {
        SceneParts scene =
            volumeScene(latticeMesh(3, 4, Split::Six, wavy), transferFunctionFromPoints({{0, {1, 1, 1}, 0.9f}}));
        addLayer(scene, 0.7, {0.2f, 0.8f, 0.3f}, 1);
        scene.volume->model = maximumIntensity(0, 1, {1, 1, 1});
        const PictureOptions options{.width = 40, .height = 30, .samplesPerAxis = 1, .depth = true};
        const Camera camera = cameraAround(scene.bounds, true);
        const auto depths = [&](RenderBackend& backend) { return rendered(backend, scene, camera, options).depth; };
        const auto cpu = depths(*cpu_), gl = depths(*gl_);
        int finite = 0, same = 0;
        for (std::size_t i = 0; i < cpu.size(); ++i) {
            finite += std::isfinite(cpu[i]) ? 1 : 0;
            same += cpu[i] == gl[i] || std::abs(cpu[i] - gl[i]) < 0.01 * cpu[i] ? 1 : 0;
        }
        QVERIFY(finite > 100 && finite < 1100);
        QVERIFY2(same > 1180, qPrintable(QString::number(same))); // edges may fall into the next pixel
    }

    void tinyRangesHaveAShader()
    {
        // The reciprocal of each is more than a float holds.
        const std::shared_ptr<const OpticalModel> models[] = {maximumIntensity(0, 1e-40, {1, 1, 1}),
                                                              xRay(0, 1e-40, 1e-40, {1, 1, 1})};
        for (const auto& model : models) {
            SceneParts scene = fogCube(0.5f);
            scene.volume->model = model;
            const PictureOptions options{.width = 20, .height = 20};
            const auto cpu = cpu_->render(scene, beforeCube(), options), gl = gl_->render(scene, beforeCube(), options);
            QVERIFY(cpu.ok());
            QVERIFY2(gl.ok(), gl ? "" : gl.error().text().c_str());
            QCOMPARE(gl->pixels[10 * 20 + 10], cpu->pixels[10 * 20 + 10]);
        }
    }

    /// The same text with other data: each picture has its own.
    void tablesOfRaysAreData()
    {
        OpticalModel model = *maximumIntensity(0, 1, {1, 1, 1});
        model.rayShader = "vec4 lightOfRay(float opacity)\n{\n"
                          "    return vec4(rayDatum(rayDataCount() - 1).rgb, 1.0);\n}\n";
        SceneParts scene = fogCube(0.5f);
        const PictureOptions options{.width = 20, .height = 20};
        for (int round = 0; round < 3; ++round) {
            const auto share = static_cast<float>(round) / 2;
            model.rayData.assign(static_cast<std::size_t>(1 + 100 * round), {0, 0, 0, 0});
            model.rayData.back() = {share, 1 - share, 0.2f, 0};
            model.lightOfRay = [colour = model.rayData.back()](float) {
                return std::array{colour[0], colour[1], colour[2], 1.0f};
            };
            scene.volume->model = std::make_shared<const OpticalModel>(model);
            const auto cpu = cpu_->render(scene, beforeCube(), options), gl = gl_->render(scene, beforeCube(), options);
            QVERIFY(cpu.ok());
            QVERIFY2(gl.ok(), gl ? "" : gl.error().text().c_str());
            const auto& pixel = gl->pixels[10 * 20 + 10];
            QVERIFY(std::abs(pixel[0] - 255 * share) <= 1 && std::abs(pixel[1] - 255 * (1 - share)) <= 1);
            QCOMPARE(pixel, cpu->pixels[10 * 20 + 10]);
        }
        model.rayData.resize(65'537);
        scene.volume->model = std::make_shared<const OpticalModel>(model);
        Scene made = scene;
        made.maker = "example.rays";
        const auto refused = gl_->render(made, beforeCube(), options);
        QVERIFY(!refused && refused.error().kind == ErrorKind::BadInput);
        QVERIFY2(refused.error().text().find("'example.rays'") != std::string::npos, refused.error().text().c_str());
    }

    void aShaderThatIsNoneIsAnError()
    {
        SceneParts scene = fogCube(0.5f);
        OpticalModel model = *steepFog();
        model.shader = "vec4 lightOfPiece(int nonsense";
        scene.volume->model = std::make_shared<const OpticalModel>(model);
        const auto picture = gl_->render(scene, beforeCube(), {.width = 20, .height = 20});
        QVERIFY(!picture && picture.error().text().find("optical model") != std::string::npos);
        // It is the maker's mistake, not the driver's, and the compiler says where.
        Scene made = scene;
        made.maker = "example.fog";
        const auto blamed = gl_->render(made, beforeCube(), {.width = 20, .height = 20});
        QVERIFY(!blamed && blamed.error().kind == ErrorKind::BadInput);
        const std::string text = blamed.error().text();
        QVERIFY2(text.starts_with("The plugin 'example.fog' ") && text.find("driver") == std::string::npos,
                 text.c_str());
        QVERIFY2(text.size() > text.find("says: ") + 6, text.c_str());
        QVERIFY(gl_->render(fogCube(0.5f), beforeCube(), {.width = 20, .height = 20}).ok()); // it goes on
    }
};

QTEST_GUILESS_MAIN(GlOpticalTest)
#include "gl_optical_test.moc"
