// SPDX-License-Identifier: GPL-3.0-or-later
// Volumes with OpenGL 3.3 and with the compute shaders of 4.3: the same picture, and what each takes (B4, S14). Skipped
// where EGL gives no OpenGL 4.3.
#include "core/graphics/gl/gl_object.h"
#include "core/graphics/gl/scene_painter.h"
#include "tests/render/gl_level.h"
#include "tests/render/gl_volume_scenes.h"
#include "tests/render/same_picture.h"

#include <QTest>

#include <cstring>

using namespace tetra;
using namespace tetra::testing;

namespace {

constexpr PictureOptions usual{.width = 90, .height = 60};

/// The driver's own function, for one that answers differently to one question.
void (*realGetInteger)(unsigned, int*) = nullptr;
void getSmallBlocks(unsigned name, int* value)
{
    realGetInteger(name, value);
    if (name == gl::maximumShaderStorageBlockSize)
        *value = 1000;
}

/// What a painter draws in a context that finds its functions as `find` says.
struct PaintedPicture {
    GlLevel level = GlLevel::Gl33;
    std::string note;
    RenderStatistics statistics;
    Picture picture;
};

PaintedPicture paintedWith(const EglContext& context, const GetProcAddress& find, const Scene& scene,
                           const Camera& camera)
{
    const EglContext::Current current(context);
    const GlFunctions gl(context.getProcAddress());
    auto painter = ScenePainter::make(find);
    if (!painter)
        qFatal("%s", painter.error().text.c_str());
    const GlObject texture(gl.genTextures, gl.deleteTextures);
    const GlObject framebuffer(gl.genFramebuffers, gl.deleteFramebuffers);
    gl.bindTexture(gl::texture2D, texture.name());
    gl.texImage2D(gl::texture2D, 0, int(gl::rgba8), usual.width, usual.height, 0, gl::rgba, gl::unsignedByte, nullptr);
    gl.bindFramebuffer(gl::framebuffer, framebuffer.name());
    gl.framebufferTexture2D(gl::framebuffer, gl::colourAttachment0, gl::texture2D, texture.name(), 0);
    PaintedPicture painted;
    if (const Status status = (*painter)->draw(scene, camera, usual, framebuffer.name()); !status)
        qFatal("%s", status.error().text.c_str());
    painted.level = (*painter)->level();
    painted.note = (*painter)->note();
    painted.statistics = (*painter)->statistics();
    painted.picture = {usual.width, usual.height, {}};
    painted.picture.pixels.resize(std::size_t(usual.width) * usual.height);
    gl.readPixels(0, 0, usual.width, usual.height, gl::rgba, gl::unsignedByte, painted.picture.pixels.data());
    return painted;
}

int largestDifference(const Picture& one, const Picture& other)
{
    int largest = 0;
    for (int y = 0; y < one.height; ++y)
        for (int x = 0; x < one.width; ++x)
            largest = std::max(largest, difference(pixelAt(one, x, y), pixelAt(other, x, y)));
    return largest;
}

} // namespace

class GlLevelsTest : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<RenderBackend> older_;
    std::unique_ptr<RenderBackend> newer_;

private slots:
    void initTestCase()
    {
        if (const std::string reason = whyNoGl(GlLevel::Gl43); !reason.empty())
            QSKIP(reason.c_str());
        older_ = glBackendOf(GlLevel::Gl33);
        newer_ = glBackendOf(GlLevel::Gl43);
    }

    void samePictures_data()
    {
        QTest::addColumn<QString>("mesh");
        QTest::addColumn<bool>("perspective");
        for (const NamedMesh& mesh : meshes())
            for (const bool perspective : {true, false})
                QTest::addRow("%s, %s", mesh.name.c_str(), perspective ? "perspective" : "orthographic")
                    << QString::fromStdString(mesh.name) << perspective;
    }
    /// The same cells by the same formulas: equal but for the order of cells that have none, and the sum's rounding.
    void samePictures()
    {
        QFETCH(QString, mesh);
        QFETCH(bool, perspective);
        for (const char* function : {"ramps", "steps"}) {
            const Scene scene = sceneNamed(mesh, function);
            const Camera camera = cameraFor(scene, perspective);
            const Picture older = rendered(*older_, scene, camera, usual);
            const Picture newer = rendered(*newer_, scene, camera, usual);
            QVERIFY(shareOfOther(newer, newer.pixels.front()) > 0.05);
            QVERIFY(largestDifference(older, newer) <= 1);
            QVERIFY2(newer_->statistics().cellsOnCard, newer_->note().c_str());
            QVERIFY(!older_->statistics().cellsOnCard && !older_->statistics().orderOnCard);
            QCOMPARE(newer_->statistics().orderOnCard, scene.volume->mesh->convex);
            QCOMPARE(newer_->note(), std::string());
            QCOMPARE(older_->note(), std::string());
        }
    }

    /// Cells with nothing to be seen are those that the processor finds, and those beside the picture go, too.
    void leavesOutWhatIsNotSeen()
    {
        const Scene scene = sceneNamed("refined lattice", "steps");
        const Camera camera = zoomed(cameraFor(scene, true), 1.5);
        const auto cellsOf = [&](RenderBackend& backend, const Camera& from) {
            rendered(backend, scene, from, usual);
            return backend.statistics().cells;
        };
        QVERIFY(cellsOf(*newer_, camera) < scene.volume->mesh->mesh->tetrahedra.size());
        QCOMPARE(cellsOf(*newer_, camera), cellsOf(*older_, camera));
        Camera near = camera;
        near.fieldOfView = 1;
        QVERIFY(cellsOf(*newer_, near) < cellsOf(*older_, near) / 2);
        Camera beside = camera;
        beside.target += Eigen::Vector3d(100, 0, 0) * scene.bounds.diagonal().norm();
        QCOMPARE(cellsOf(*newer_, beside), std::size_t(0));
    }

    /// A new view sends next to nothing where the card orders the cells; ranks where the processor does.
    void sendsLittle()
    {
        const auto sentFor = [&](RenderBackend& backend, const char* mesh) {
            const Scene scene = sceneNamed(mesh, "ramps");
            rendered(backend, scene, cameraFor(scene, true), usual);
            rendered(backend, scene, turned(cameraFor(scene, true), 20, 5), usual);
            return static_cast<double>(backend.statistics().sentBytes) /
                   static_cast<double>(scene.volume->mesh->mesh->tetrahedra.size());
        };
        QVERIFY(sentFor(*newer_, "refined lattice") < 0.5);
        QVERIFY(sentFor(*older_, "refined lattice") > 10);
        const double ranks = sentFor(*newer_, "irregular with a hole");
        QVERIFY(ranks >= 4 && ranks < 4.5);
    }

    /// A driver that lacks something draws the same picture by other means, and says what it lacks.
    void fallsBack()
    {
        const auto context = EglContext::make();
        QVERIFY(context.ok());
        const GetProcAddress all = (*context)->getProcAddress();
        realGetInteger = reinterpret_cast<void (*)(unsigned, int*)>(all("glGetIntegerv"));
        const GetProcAddress withoutCompute = [&](const char* name) {
            return std::strcmp(name, "glDispatchCompute") == 0 ? nullptr : all(name);
        };
        const GetProcAddress smallBlocks = [&](const char* name) {
            return std::strcmp(name, "glGetIntegerv") == 0 ? reinterpret_cast<void*>(&getSmallBlocks) : all(name);
        };
        const Scene scene = sceneNamed("refined lattice", "ramps");
        const Camera camera = cameraFor(scene, true);
        const PaintedPicture expected = paintedWith(**context, all, scene, camera);
        QVERIFY(expected.level == GlLevel::Gl43 && expected.statistics.cellsOnCard && expected.note.empty());

        const PaintedPicture without = paintedWith(**context, withoutCompute, scene, camera);
        QVERIFY(without.level == GlLevel::Gl33 && !without.statistics.cellsOnCard);
        QVERIFY(without.note.find("glDispatchCompute") != std::string::npos);
        QVERIFY(largestDifference(without.picture, expected.picture) <= 1);

        const PaintedPicture small = paintedWith(**context, smallBlocks, scene, camera);
        QVERIFY(small.level == GlLevel::Gl43 && !small.statistics.cellsOnCard && small.statistics.cells > 100);
        QVERIFY(small.note.find("62 tetrahedra") != std::string::npos);
        QVERIFY(largestDifference(small.picture, expected.picture) <= 1);
    }
};

QTEST_GUILESS_MAIN(GlLevelsTest)
#include "gl_levels_test.moc"
