// SPDX-License-Identifier: GPL-3.0-or-later
// A part of a picture is what the whole picture has there (C5: what a lens magnifies is a part of a larger picture), by
// the CPU to the bit, by OpenGL where there is some.
#include "tests/render/focus_fields.h"
#include "tests/render/gl_test.h"
#include "tests/render/same_picture.h"
#include "tests/render/scenes.h"
#include "tests/render/volume_scenes.h"

#include <QTest>

#include <algorithm>
#include <functional>
#include <map>
#include <vector>

using namespace tetra;
using namespace tetra::testing;
using Eigen::Vector3d;

namespace {

constexpr int width = 120, height = 84;

SceneParts surfaces()
{
    const Scene ofMesh = volumeScene(latticeMesh(7, 1, Split::Six, waves), rainbow(0.8));
    SceneParts scene;
    scene.bounds = ofMesh.bounds;
    scene.surfaces.push_back({sphere({0.4f, 0.4f, 0.5f}, 0.3f, 24), {0.9f, 0.3f, 0.1f}});
    scene.surfaces.push_back({sphere({0.6f, 0.6f, 0.5f}, 0.35f, 12), {0.1f, 0.3f, 0.9f}, 0.4f});
    // Far beyond the picture, so that it is cut there.
    scene.surfaces.push_back({quad({-60, -60, -0.2f}, {120, 0, 0}, {0, 120, 0}), {0.5f, 0.6f, 0.5f}});
    auto coloured = std::make_shared<TriangleMesh>(*quad({0, 0.2f, 0}, {1, 0, 0}, {0, 0.5f, 1}));
    coloured->colours = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}};
    scene.surfaces.push_back({coloured, {}, 0.6f});
    scene.lines.push_back(boxOutline(scene.bounds, {0, 0, 0}, 1.7f));
    return scene;
}

SceneParts volume()
{
    return volumeScene(latticeMesh(6, 1, Split::Six, waves), rainbow(0.7));
}

SceneParts both()
{
    SceneParts scene = volume();
    scene.surfaces = surfaces().surfaces;
    scene.lines = surfaces().lines;
    scene.clipPlanes = {{{1, 0.2, 0.1}, 0.25}};
    return scene;
}

SceneParts focus()
{
    SceneParts scene = volume();
    scene.focus = FinePart{volumeOf(volumeMeshOf(latticeMesh(9, 1, Split::Five, waves)), rainbow(0.7)), ball, 0.1};
    return scene;
}

const std::map<QString, std::function<SceneParts()>> scenes = {
    {"surfaces", surfaces},
    {"a volume", volume},
    {"both and a clip plane", both},
    {"a focus", focus},
    {"a domain with a hole",
     [] {
         const TetrahedralMesh mesh = irregularWithHole();
         return volumeScene(mesh, functionFor(mesh, "ramps").function);
     }},
};

/// Cells of a domain that is not convex may be in another order where that makes no difference but of rounding.
double largestDepthDifference(const Picture& one, const Picture& other)
{
    double largest = 0;
    for (std::size_t i = 0; i < one.depth.size(); ++i)
        if (one.depth[i] != other.depth[i]) // infinite alike or not
            largest = std::max(largest, std::abs(double(one.depth[i]) - other.depth[i]));
    return largest;
}

/// In parts that end beside the tiles of the back ends, put together.
Picture inParts(RenderBackend& backend, const Scene& scene, const Camera& camera, PictureOptions options)
{
    Picture all{options.width, options.height, {}};
    all.pixels.resize(static_cast<std::size_t>(options.width * options.height));
    all.depth.resize(options.depth ? all.pixels.size() : 0);
    const std::array columns{0, options.width * 3 / 10, options.width}, rows{0, options.height - 33, options.height};
    for (std::size_t row = 0; row + 1 < rows.size(); ++row)
        for (std::size_t column = 0; column + 1 < columns.size(); ++column) {
            const PixelRectangle part{columns[column], rows[row], columns[column + 1] - columns[column],
                                      rows[row + 1] - rows[row]};
            options.part = part;
            const Picture drawn = rendered(backend, scene, camera, options);
            if (drawn.width != part.width || drawn.height != part.height)
                qFatal("a part has another size");
            for (int y = 0; y < part.height; ++y)
                for (int x = 0; x < part.width; ++x) {
                    const auto to = static_cast<std::size_t>((part.top + y) * options.width + part.left + x);
                    const auto from = static_cast<std::size_t>(y * part.width + x);
                    all.pixels[to] = drawn.pixels[from];
                    if (options.depth)
                        all.depth[to] = drawn.depth[from];
                }
        }
    return all;
}

} // namespace

class PicturePartsTest : public GlTest {
    Q_OBJECT

private slots:
    void initTestCase() { makeGlIfThere(); }

    void partsAreTheWhole_data()
    {
        QTest::addColumn<QString>("scene");
        QTest::addColumn<bool>("perspective");
        QTest::addColumn<bool>("inside");
        QTest::addColumn<int>("samples");
        for (const auto& [name, make] : scenes)
            for (const bool perspective : {true, false})
                for (const bool inside : {false, true})
                    if (perspective || !inside)
                        QTest::addRow("%s, %s%s", qPrintable(name), perspective ? "perspective" : "orthographic",
                                      inside ? " from inside" : "")
                            << name << perspective << inside << (inside ? 1 : 2);
    }
    void partsAreTheWhole()
    {
        QFETCH(QString, scene);
        QFETCH(bool, perspective);
        QFETCH(bool, inside);
        QFETCH(int, samples);
        const Scene drawn = scenes.at(scene)();
        Camera camera = cameraAround(drawn.bounds, perspective);
        if (inside)
            camera = withEyeAt(camera, drawn.bounds.center() + 0.1 * drawn.bounds.sizes());
        PictureOptions options{.width = width, .height = height, .samplesPerAxis = samples, .depth = true};
        const Picture whole = rendered(*cpu_, drawn, camera, options);
        QVERIFY(std::ranges::any_of(whole.pixels, [&](const auto& pixel) { return pixel != whole.pixels.front(); }));
        const Picture parts = inParts(*cpu_, drawn, camera, options);
        QVERIFY(parts.pixels == whole.pixels);
        const double off = largestDepthDifference(parts, whole);
        QVERIFY2(off <= 1e-5 * drawn.bounds.diagonal().norm(), qPrintable(QString::number(off)));
        if (!gl_)
            return;
        options.depth = false;
        const Picture glWhole = rendered(*gl_, drawn, camera, options);
        const Picture glParts = inParts(*gl_, drawn, camera, options);
        QVERIFY(
            samePicture(glWhole, glParts, glParts, QString("parts_%1").arg(QTest::currentDataTag()).replace(' ', '_')));
    }

    /// Pictures that are larger than what is drawn at once are drawn in parts, too.
    void largePicturesAreTheirParts_data()
    {
        QTest::addColumn<int>("columns");
        QTest::addColumn<int>("rows");
        QTest::newRow("wide") << 4200 << 3;
        QTest::newRow("high") << 3 << 4200;
    }
    void largePicturesAreTheirParts()
    {
        QFETCH(int, columns);
        QFETCH(int, rows);
        const Scene scene = both();
        Camera camera = cameraAround(scene.bounds, true);
        camera.fieldOfView = 0.03; // across the shorter side
        const bool isWide = columns > rows;
        PictureOptions options{.width = columns, .height = rows};
        QVERIFY(!backends().empty());
        for (RenderBackend* backend : backends()) {
            options.part.reset();
            const Picture whole = rendered(*backend, scene, camera, options);
            QVERIFY(
                std::ranges::any_of(whole.pixels, [&](const auto& pixel) { return pixel != whole.pixels.front(); }));
            // Over the place where the whole is cut, and before and behind it.
            for (const int first : {100, 2000, 4050, 4110}) {
                const PixelRectangle part = isWide ? PixelRectangle{first, 0, 80, 3} : PixelRectangle{0, first, 3, 80};
                options.part = part;
                const Picture drawn = rendered(*backend, scene, camera, options);
                int wrong = 0;
                for (int y = 0; y < part.height; ++y)
                    for (int x = 0; x < part.width; ++x)
                        wrong += difference(pixelAt(drawn, x, y), pixelAt(whole, part.left + x, part.top + y)) > 2;
                QVERIFY2(wrong == 0 || (backend == gl_.get() && wrong <= 3), qPrintable(QString::number(wrong)));
            }
        }
    }

    /// What depends on the size of the picture is of the whole one.
    void customDrawablesKnowTheWhole()
    {
        SceneParts parts = surfaces();
        Scene scene = parts;
        auto custom = std::make_shared<CustomDrawable>();
        std::vector<std::pair<int, int>> sizes;
        custom->draw = [&](const Camera&, int w, int h) {
            sizes.emplace_back(w, h);
            return std::vector<Drawable>{};
        };
        scene.drawables.push_back({.id = "custom", .shape = std::shared_ptr<const CustomDrawable>(custom)});
        const PictureOptions options{.width = width, .height = height, .part = PixelRectangle{10, 20, 30, 40}};
        for (RenderBackend* backend : backends())
            rendered(*backend, scene, cameraAround(scene.bounds, true), options);
        QCOMPARE(sizes, std::vector(backends().size(), std::pair(width, height)));
    }

    /// A part of a picture that nobody could hold in memory.
    void partsOfHugePictures()
    {
        const Scene scene = both();
        const Camera camera = cameraAround(scene.bounds, true);
        constexpr int factor = 200;
        const PictureOptions options{
            .width = width * factor, .height = height * factor, .part = PixelRectangle{12080, 8480, 40, 30}};
        const Picture small = rendered(*cpu_, scene, camera, {.width = width, .height = height, .samplesPerAxis = 1});
        QVERIFY(!backends().empty());
        for (RenderBackend* backend : backends()) {
            const Picture part = rendered(*backend, scene, camera, options);
            QCOMPARE(part.width, 40);
            // Its middle is that of a pixel of the small picture.
            QVERIFY(difference(pixelAt(part, 20, 20), pixelAt(small, 60, 42)) <= 3);
        }
    }

    void badPartsAreErrors_data()
    {
        QTest::addColumn<int>("left");
        QTest::addColumn<int>("columns");
        QTest::newRow("before the picture") << -1 << 10;
        QTest::newRow("beyond it") << width - 9 << 10;
        QTest::newRow("far beyond it") << 5 << std::numeric_limits<int>::max();
        QTest::newRow("nothing") << 5 << 0;
    }
    void badPartsAreErrors()
    {
        QFETCH(int, left);
        QFETCH(int, columns);
        const PictureOptions options{.width = width, .height = height, .part = PixelRectangle{left, 0, columns, 10}};
        QVERIFY(!backends().empty());
        for (RenderBackend* backend : backends()) {
            const auto picture = backend->render({}, {}, options);
            QVERIFY(!picture);
            QCOMPARE(picture.error().kind, ErrorKind::WrongUsage);
        }
    }
};

QTEST_GUILESS_MAIN(PicturePartsTest)
#include "picture_parts_test.moc"
