// SPDX-License-Identifier: GPL-3.0-or-later
// A finer volume inside a region, blended at its border (R24, S18): against a slow integrator of both fields, and the
// same field twice, which must look like one.
#include "core/render/volume/volume_view.h"
#include "tests/core/render/lattice_mesh.h"
#include "tests/core/render/scene_parts.h"
#include "tests/render/focus_fields.h"
#include "tests/render/picture_check.h"
#include "tests/render/volume_scenes.h"

#include <tan/render.h>

#include <QTest>

#include <cmath>

using namespace tetra;
using namespace tetra::testing;
using Eigen::Vector3d;

namespace {

constexpr int width = 30;
constexpr int height = 24;
const PictureOptions usual{.width = width, .height = height, .samplesPerAxis = 1};

/// The focus in the words of the test.
struct Focus {
    std::variant<Box, Sphere> region;
    double border;
    std::vector<Focus> more{};

    double weightAt(const Vector3d& place) const
    {
        double largest = weightOfFirst(place);
        for (const Focus& other : more)
            largest = std::max(largest, other.weightOfFirst(place));
        return largest;
    }

private:
    double weightOfFirst(const Vector3d& place) const
    {
        double distance = 0;
        if (const Sphere* const ball = std::get_if<Sphere>(&region))
            distance = std::max(0.0, (place - ball->centre).norm() - ball->radius);
        else {
            const Box& box = std::get<Box>(region);
            distance = (place - place.cwiseMax(box.least).cwiseMin(box.largest)).norm();
        }
        return border > 0 ? std::max(0.0, 1 - distance / border) : distance > 0 ? 0 : 1;
    }
};

/// The values of a mesh along a ray, by cutting the ray with every cell.
class ValuesAlong {
public:
    ValuesAlong(const TetrahedralMesh& mesh, const Vector3d& start, const Vector3d& direction)
    {
        for (const auto& cell : mesh.tetrahedra)
            cut(mesh, cell, start, direction);
    }
    /// NaN outside the domain.
    double at(double place) const
    {
        for (const Piece& piece : pieces_)
            if (place >= piece.enter && place <= piece.leave)
                return piece.atStart + place * piece.perLength;
        return std::nan("");
    }

private:
    struct Piece {
        double enter, leave, atStart, perLength;
    };
    void cut(const TetrahedralMesh& mesh, const std::array<std::uint32_t, 4>& cell, const Vector3d& start,
             const Vector3d& direction)
    {
        Eigen::Matrix4d corners;
        Eigen::Vector4d values;
        for (int i = 0; i < 4; ++i) {
            const std::uint32_t vertex = cell[static_cast<std::size_t>(i)];
            corners.col(i) << mesh.positions[vertex].cast<double>(), 1;
            values[i] = mesh.values[vertex];
        }
        const Eigen::Matrix4d inverse = corners.inverse();
        const Eigen::Vector4d weights = inverse * start.homogeneous(), rise = inverse.leftCols<3>() * direction;
        Piece piece{0, 1e300, values.dot(weights), values.dot(rise)};
        for (int i = 0; i < 4; ++i) {
            if (rise[i] > 0)
                piece.enter = std::max(piece.enter, -weights[i] / rise[i]);
            else if (rise[i] < 0)
                piece.leave = std::min(piece.leave, -weights[i] / rise[i]);
            else if (weights[i] < 0)
                return;
        }
        if (piece.enter < piece.leave)
            pieces_.push_back(piece);
    }

    std::vector<Piece> pieces_;
};

struct Fields {
    TetrahedralMesh coarse = latticeMesh(4, 1, Split::Six, waves);
    TetrahedralMesh fine = latticeMesh(7, 1, Split::Five, waves);
};

/// Marches through both fields in small steps.
Picture marched(const Fields& fields, const TransferFunction& function, const Focus& focus, const Camera& camera,
                const SceneParts& scene)
{
    const VolumeView view = makeVolumeView(camera, width, height, scene.bounds);
    const Eigen::Matrix3d worldFromImage = view.imageFromWorld.leftCols<3>().inverse();
    Picture picture{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto placeAt = [&](double w) {
                const double u = x + view.firstX(), v = y + view.firstY();
                const Vector3d image = camera.perspective ? Vector3d(u * w, v * w, w) : Vector3d(u, v, w);
                return Vector3d(worldFromImage * (image - view.imageFromWorld.col(3)));
            };
            const double nearest = camera.perspective ? view.nearest : 0;
            const Vector3d start = placeAt(nearest), direction = (placeAt(nearest + 1) - start).normalized();
            const ValuesAlong coarse(fields.coarse, start, direction), fine(fields.fine, start, direction);
            constexpr double step = 0.0004;
            Vector3d colour(0, 0, 0);
            double light = 1;
            for (double place = step / 2; place < 8 && light > 1e-6; place += step) {
                const Vector3d at = start + place * direction;
                if ((at.array() < 0).any() || (at.array() > 1).any() ||
                    std::ranges::any_of(scene.clipPlanes,
                                        [&](const ClipPlane& plane) { return plane.normal.dot(at) < plane.offset; }))
                    continue;
                const double weight = focus.weightAt(at);
                Vector3d glow(0, 0, 0);
                double extinction = 0;
                for (const auto& [values, share] : {std::pair(&coarse, 1 - weight), std::pair(&fine, weight)}) {
                    if (share == 0)
                        continue;
                    const TransferSample sample = evaluate(function, values->at(place));
                    extinction += share * sample.extinction;
                    glow += share * sample.extinction * Vector3d(sample.colour[0], sample.colour[1], sample.colour[2]);
                }
                if (extinction > 0)
                    colour += light * (1 - std::exp(-extinction * step)) / extinction * glow;
                light *= std::exp(-extinction * step);
            }
            std::array<std::uint8_t, 4> pixel{0, 0, 0, 255};
            for (int channel = 0; channel < 3; ++channel)
                pixel[static_cast<std::size_t>(channel)] =
                    static_cast<std::uint8_t>(std::lround(255 * std::min(1.0, colour[channel] + light)));
            picture.pixels.push_back(pixel);
        }
    return picture;
}

SceneParts sceneOf(const TetrahedralMesh& coarse, const TetrahedralMesh& fine, const TransferFunction& function,
                   const Focus& focus)
{
    SceneParts scene = volumeScene(coarse, function);
    scene.focus = FinePart{volumeOf(volumeMeshOf(fine), function), focus.region, focus.border};
    for (const Focus& other : focus.more)
        scene.focus->more.push_back({other.region, other.border});
    return scene;
}

Picture rendered(const SceneParts& scene, const Camera& camera, const PictureOptions& options = usual)
{
    return renderedByCpu(scene, camera, options);
}

int largestDifference(const Picture& one, const Picture& other)
{
    int largest = 0;
    for (std::size_t i = 0; i < one.pixels.size(); ++i)
        largest = std::max(largest, difference(one.pixels[i], other.pixels[i]));
    return largest;
}

} // namespace

class FocusSceneTest : public QObject {
    Q_OBJECT

private slots:
    void agreesWithTheIntegrator_data();
    void agreesWithTheIntegrator();
    void oneFieldTwiceIsOne_data();
    void oneFieldTwiceIsOne();
    void alongTheAxes_data();
    void alongTheAxes();
    void severalRegions_data();
    void severalRegions();
    void surfacesOfBothMeshes_data();
    void surfacesOfBothMeshes();
    void oneSurfaceTwiceIsOne();
    void insideTheFocus();
    void clipPlanesCutBoth();
    void surfacesAreMetInTheBorder();
    void hasAFunctionOfItsOwn();
    void besideTheDomainItIsNothing();
    void oneThreadEqualsMany();
    void refusesAFunctionOfAnotherMesh();
};

void FocusSceneTest::agreesWithTheIntegrator_data()
{
    QTest::addColumn<bool>("isBox");
    QTest::addColumn<double>("border");
    QTest::addColumn<double>("opacity");
    QTest::addColumn<bool>("perspective");
    for (const bool isBox : {false, true})
        for (const double border : {0.0, 0.02, 0.2})
            for (const double opacity : {0.2, 0.9})
                for (const bool perspective : {true, false})
                    QTest::addRow("%s, border %g, opacity %g, %s", isBox ? "box" : "ball", border, opacity,
                                  perspective ? "perspective" : "orthographic")
                        << isBox << border << opacity << perspective;
}

void FocusSceneTest::agreesWithTheIntegrator()
{
    QFETCH(bool, isBox);
    QFETCH(double, border);
    QFETCH(double, opacity);
    QFETCH(bool, perspective);
    const Fields fields;
    Focus focus{ball, border};
    if (isBox)
        focus.region = box;
    const TransferFunction function = rainbow(opacity);
    const SceneParts scene = sceneOf(fields.coarse, fields.fine, function, focus);
    const Camera camera = cameraAround(scene.bounds, perspective);
    const Picture picture = rendered(scene, camera);
    const int found = largestDifference(picture, marched(fields, function, focus, camera, scene));
    QVERIFY2(found <= 2, qPrintable(QString("%1 steps of 255, %2").arg(found).arg(savePicture(picture, "focus"))));
    SceneParts without = scene;
    without.focus.reset();
    QVERIFY(largestDifference(picture, rendered(without, camera)) > 3);
}

void FocusSceneTest::oneFieldTwiceIsOne_data()
{
    agreesWithTheIntegrator_data();
}

void FocusSceneTest::oneFieldTwiceIsOne()
{
    QFETCH(bool, isBox);
    QFETCH(double, border);
    QFETCH(double, opacity);
    QFETCH(bool, perspective);
    const Fields fields;
    Focus focus{ball, border};
    if (isBox)
        focus.region = box;
    SceneParts scene = sceneOf(fields.fine, fields.fine, rainbow(opacity), focus);
    const Camera camera = cameraAround(scene.bounds, perspective);
    const Picture picture = rendered(scene, camera);
    scene.focus.reset();
    const int found = largestDifference(picture, rendered(scene, camera));
    QVERIFY2(found <= 1, qPrintable(QString("%1 steps of 255").arg(found)));
}

/// The views that are called front, side and top: without perspective all rays are parallel to faces of the box, and
/// most pass beside it.
void FocusSceneTest::alongTheAxes_data()
{
    QTest::addColumn<int>("up");
    QTest::addColumn<double>("azimuth");
    QTest::addColumn<double>("elevation");
    for (const int up : {0, 2, 4}) // exactly along an axis; turns by 90 degrees are rounded
        QTest::addRow("axis %d up", up) << up << 0.0 << 0.0;
    QTest::addRow("top") << 4 << 0.0 << 90.0;
}

void FocusSceneTest::alongTheAxes()
{
    QFETCH(int, up);
    QFETCH(double, azimuth);
    QFETCH(double, elevation);
    const Fields fields;
    const TransferFunction function = rainbow(0.5);
    Camera camera;
    for (const double border : {0.0, 0.1}) {
        Focus focus{Box{{0.3, 0.35, 0.3}, {0.6, 0.65, 0.55}}, border};
        const SceneParts scene = sceneOf(fields.coarse, fields.fine, function, focus);
        camera = {.azimuth = azimuth, .elevation = elevation, .up = static_cast<UpAxis>(up), .perspective = false};
        camera = fitted(camera, scene.bounds);
        camera.target += Vector3d(0.003, 0.007, 0.011); // so that no ray lies in a face between cells
        const Picture picture = rendered(scene, camera);
        const int found = largestDifference(picture, marched(fields, function, focus, camera, scene));
        QVERIFY2(found <= 2, qPrintable(QString("%1 steps of 255, %2").arg(found).arg(savePicture(picture, "axes"))));
        SceneParts without = scene;
        without.focus.reset();
        QVERIFY(largestDifference(picture, rendered(without, camera)) > 3);
    }
}

/// C5: weights sum to one wherever borders overlap, and where rays meet several regions.
void FocusSceneTest::severalRegions_data()
{
    QTest::addColumn<QString>("places");
    QTest::addColumn<bool>("perspective");
    for (const QString places : {"apart", "overlapping borders", "overlapping", "one in the other", "three"})
        for (const bool perspective : {true, false})
            QTest::addRow("%s, %s", qPrintable(places), perspective ? "perspective" : "orthographic")
                << places << perspective;
}

void FocusSceneTest::severalRegions()
{
    QFETCH(QString, places);
    QFETCH(bool, perspective);
    Focus focus{Sphere{{0.25, 0.3, 0.4}, 0.12}, 0.06};
    if (places == "apart")
        focus.more = {{Sphere{{0.75, 0.75, 0.6}, 0.15}, 0.05}};
    else if (places == "overlapping borders")
        focus.more = {{Box{{0.45, 0.2, 0.3}, {0.7, 0.6, 0.6}}, 0.15}};
    else if (places == "overlapping")
        focus.more = {{Sphere{{0.45, 0.5, 0.5}, 0.28}, 0.1}};
    else if (places == "one in the other")
        focus.more = {{Sphere{{0.3, 0.35, 0.4}, 0.3}, 0.1}};
    else
        focus.more = {{Sphere{{0.55, 0.5, 0.5}, 0.1}, 0.1}, {Box{{0.7, 0.7, 0.3}, {0.9, 0.95, 0.8}}, 0}};
    const Fields fields;
    const TransferFunction function = rainbow(0.5);
    SceneParts scene = sceneOf(fields.coarse, fields.fine, function, focus);
    for (const double turn : {0.0, 70.0}) {
        const Camera camera = turned(cameraAround(scene.bounds, perspective), turn, 0);
        const Picture picture = rendered(scene, camera);
        const int found = largestDifference(picture, marched(fields, function, focus, camera, scene));
        QVERIFY2(found <= 2,
                 qPrintable(QString("%1 steps of 255, %2").arg(found).arg(savePicture(picture, "regions"))));
        SceneParts one = scene;
        one.focus->more.clear();
        QVERIFY(largestDifference(picture, rendered(one, camera)) > 3);
    }
    scene.volume = volumeOf(scene.focus->fine.mesh, function); // the same field twice looks like one
    const Camera camera = cameraAround(scene.bounds, perspective);
    SceneParts without = scene;
    without.focus.reset();
    QVERIFY(largestDifference(rendered(scene, camera), rendered(without, camera)) <= 1);
}

/// C5: in a region one sees the surface of the fine mesh alone, outside of its border that of the other one.
void FocusSceneTest::surfacesOfBothMeshes_data()
{
    QTest::addColumn<float>("opacity");
    QTest::addColumn<bool>("withVolume");
    for (const float opacity : {0.5f, 1.0f})
        for (const bool withVolume : {false, true})
            QTest::addRow("opacity %g%s", double(opacity), withVolume ? ", in volumes" : "") << opacity << withVolume;
}

void FocusSceneTest::surfacesOfBothMeshes()
{
    QFETCH(float, opacity);
    QFETCH(bool, withVolume);
    const Fields fields;
    const TransferFunction function = rainbow(0.3);
    const auto sceneWith = [&](const std::vector<FocusRegion>& regions) {
        SceneParts scene = volumeScene(fields.coarse, function);
        addLayer(scene, 0.55, {1, 0, 0}, opacity);
        SceneParts fine = volumeScene(fields.fine, function);
        addLayer(fine, 0.55, {0, 0, 1}, opacity);
        scene.surfaces.push_back(fine.surfaces.front());
        for (const bool isFine : {false, true})
            scene.surfaces[isFine ? 1 : 0].share = std::make_shared<const FocusShare>(FocusShare{regions, isFine});
        scene.focus =
            FinePart{*fine.volume, regions.front().shape, regions.front().border, {regions.begin() + 1, regions.end()}};
        if (!withVolume) {
            scene.volume.reset();
            scene.focus.reset();
        }
        return scene;
    };
    const auto alone = [&](const TetrahedralMesh& mesh, const Colour& colour) {
        SceneParts scene = volumeScene(mesh, function);
        addLayer(scene, 0.55, colour, opacity);
        if (!withVolume)
            scene.volume.reset();
        return scene;
    };
    const SceneParts everywhere = sceneWith({{Sphere{{0.5, 0.5, 0.5}, 5}, 0.1}, {Sphere{{0.2, 0.2, 0.2}, 0.1}, 0}});
    const SceneParts nowhere = sceneWith({{Sphere{{9, 9, 9}, 0.1}, 0.1}});
    for (const bool perspective : {true, false}) {
        const Camera camera = cameraAround(everywhere.bounds, perspective);
        QVERIFY(largestDifference(rendered(everywhere, camera), rendered(alone(fields.fine, {0, 0, 1}), camera)) <= 1);
        QVERIFY(largestDifference(rendered(nowhere, camera), rendered(alone(fields.coarse, {1, 0, 0}), camera)) <= 1);
    }
}

/// S18: opacities of one surface in two resolutions are those of one in optical depth, in the borders, too.
void FocusSceneTest::oneSurfaceTwiceIsOne()
{
    const Fields fields;
    const std::vector<FocusRegion> regions{{Sphere{{0.4, 0.5, 0.5}, 0.15}, 0.25},
                                           {Box{{0.6, 0.2, 0.2}, {0.9, 0.8, 0.9}}, 0.2}};
    for (const float opacity : {0.3f, 0.8f, 1.0f}) {
        SceneParts one = volumeScene(fields.fine, rainbow(0.3));
        addLayer(one, 0.55, {0.9f, 0.5f, 0.2f}, opacity);
        one.volume.reset();
        SceneParts two = one;
        two.surfaces.push_back(one.surfaces.front());
        for (const bool isFine : {false, true})
            two.surfaces[isFine ? 1 : 0].share = std::make_shared<const FocusShare>(FocusShare{regions, isFine});
        for (const bool perspective : {true, false}) {
            const Camera camera = cameraAround(one.bounds, perspective);
            QVERIFY(largestDifference(rendered(two, camera), rendered(one, camera)) <= 1);
            SceneParts half = two;
            half.surfaces.pop_back();
            QVERIFY(largestDifference(rendered(half, camera), rendered(one, camera)) > 30);
        }
    }
}

void FocusSceneTest::insideTheFocus()
{
    const Fields fields;
    const Focus focus{ball, 0.1};
    const TransferFunction function = rainbow(0.3);
    const SceneParts scene = sceneOf(fields.coarse, fields.fine, function, focus);
    for (const Vector3d& eye : {Vector3d(0.41, 0.52, 0.57), Vector3d(0.45, 0.14, 0.55)}) {
        const Camera camera = withEyeAt(cameraAround(scene.bounds, true), eye);
        QVERIFY(largestDifference(rendered(scene, camera), marched(fields, function, focus, camera, scene)) <= 2);
    }
}

void FocusSceneTest::clipPlanesCutBoth()
{
    const Fields fields;
    const Focus focus{ball, 0.15};
    const TransferFunction function = rainbow(0.5);
    SceneParts scene = sceneOf(fields.coarse, fields.fine, function, focus);
    scene.clipPlanes = {{{0.6, 0.8, 0}, 0.63}, {{0, 0, -1}, -0.8}};
    for (const bool perspective : {true, false}) {
        const Camera camera = cameraAround(scene.bounds, perspective);
        QVERIFY(largestDifference(rendered(scene, camera), marched(fields, function, focus, camera, scene)) <= 2);
    }
}

void FocusSceneTest::surfacesAreMetInTheBorder()
{
    const Fields fields;
    SceneParts scene = sceneOf(fields.fine, fields.fine, rainbow(0.4), {box, 0.1});
    addLayer(scene, 0.55, {0.9f, 0.5f, 0.2f}, 0.5f);
    for (const bool perspective : {true, false}) {
        const Camera camera = cameraAround(scene.bounds, perspective);
        SceneParts without = scene;
        without.focus.reset();
        // A way through the border is drawn before or behind a surface in it as a whole.
        QVERIFY(largestDifference(rendered(scene, camera), rendered(without, camera)) <= 3);
    }
}

void FocusSceneTest::hasAFunctionOfItsOwn()
{
    const Fields fields;
    const TransferFunction function =
        transferFunctionFromPoints({{0, {1, 0.2f, 0}, 0.1f}, {1, {0, 0.2f, 1}, 0.7f}}, 0.2);
    const SceneParts expected = volumeScene(fields.fine, function);
    SceneParts scene = volumeScene(fields.fine, rainbow(0.5));
    scene.focus = FinePart{volumeOf(scene.volume->mesh, function), Sphere{{0.5, 0.5, 0.5}, 2}, 0};
    for (const bool perspective : {true, false}) {
        const Camera camera = cameraAround(scene.bounds, perspective);
        QVERIFY(largestDifference(rendered(scene, camera), rendered(expected, camera)) <= 1);
    }
}

void FocusSceneTest::besideTheDomainItIsNothing()
{
    const Fields fields;
    SceneParts scene = sceneOf(fields.coarse, fields.fine, rainbow(0.5), {Sphere{{3, 3, 3}, 0.5}, 0.1});
    const Camera camera = cameraAround(scene.bounds, true);
    const Picture picture = rendered(scene, camera);
    scene.focus.reset();
    QCOMPARE(picture.pixels, rendered(scene, camera).pixels);
}

void FocusSceneTest::oneThreadEqualsMany()
{
    const Fields fields;
    const SceneParts scene = sceneOf(fields.coarse, fields.fine, rainbow(0.5), {ball, 0.1});
    const Camera camera = cameraAround(scene.bounds, true);
    PictureOptions options{.width = 150, .height = 140, .threads = 1, .depth = true};
    const Picture one = rendered(scene, camera, options);
    options.threads = 0;
    const Picture many = rendered(scene, camera, options);
    QCOMPARE(one.pixels, many.pixels);
    QCOMPARE(one.depth, many.depth);
}

void FocusSceneTest::refusesAFunctionOfAnotherMesh()
{
    const Fields fields;
    SceneParts scene = sceneOf(fields.coarse, fields.fine, rainbow(0.5), {ball, 0.1});
    scene.focus->fine.transfer = scene.volume->transfer;
    const auto picture = makeCpuBackend()->render(scene, cameraAround(scene.bounds, true), usual);
    QVERIFY(!picture);
    QCOMPARE(picture.error().kind, ErrorKind::WrongUsage);
}

QTEST_GUILESS_MAIN(FocusSceneTest)
#include "focus_scene_test.moc"
