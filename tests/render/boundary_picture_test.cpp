// SPDX-License-Identifier: GPL-3.0-or-later
// What a boundary needs of the CPU back end: colours of vertices, and surfaces without what faces the eye; against
// closed forms and against the same triangles taken out by hand.
#include "core/render/view_transform.h"
#include "tests/core/render/scene_parts.h"
#include "tests/render/boundary_scenes.h"
#include "tests/render/same_picture.h"
#include "tests/render/scenes.h"

#include <tan/render.h>

#include <QTest>

using namespace tetra;
using namespace tetra::testing;

namespace {

constexpr float half = 4; ///< of the coloured floor's side

/// The floor z = 0, red by x and green by y; without normals, which light it the same from everywhere.
MeshPointer colouredFloor()
{
    auto mesh = std::make_shared<TriangleMesh>(*quad({-half, -half, 0}, {2 * half, 0, 0}, {0, 2 * half, 0}));
    mesh->normals.assign(4, Eigen::Vector3f::Zero());
    for (const Eigen::Vector3d& place : mesh->positions)
        mesh->colours.push_back({float(place.x() / half + 1) / 2, float(place.y() / half + 1) / 2, 0.25f});
    return mesh;
}

/// Where the ray through the middle of a pixel meets the floor.
std::optional<Eigen::Vector3d> floorAt(const Eigen::Matrix4d& worldFromClip, const Picture& picture, int x, int y)
{
    const auto placeAt = [&](double depth) -> Eigen::Vector3d {
        return (worldFromClip *
                Eigen::Vector4d((x + 0.5) / picture.width * 2 - 1, 1 - (y + 0.5) / picture.height * 2, depth, 1))
            .hnormalized();
    };
    const Eigen::Vector3d from = placeAt(-0.9), to = placeAt(0.9);
    const double part = -from.z() / (to.z() - from.z());
    const Eigen::Vector3d place = from + part * (to - from);
    if (!(part > -1) || place.head<2>().cwiseAbs().maxCoeff() > half)
        return std::nullopt;
    return place;
}

int toByte(float channel)
{
    return static_cast<int>(channel * 255 + 0.5f);
}

} // namespace

class BoundaryPictureTest : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<RenderBackend> cpu_ = makeCpuBackend();

private slots:
    void coloursAreLinearOnTheSurface_data()
    {
        QTest::addColumn<double>("distance");
        QTest::addColumn<bool>("perspective");
        QTest::newRow("orthographic") << 6.0 << false;
        QTest::newRow("perspective") << 6.0 << true;
        QTest::newRow("above the floor, which reaches behind the eye") << 1.0 << true;
    }
    void coloursAreLinearOnTheSurface()
    {
        QFETCH(double, distance);
        QFETCH(bool, perspective);
        SceneParts scene;
        scene.bounds = cube(half);
        scene.surfaces = {{quad({50, 50, 50}, {1, 0, 0}, {0, 1, 0}), {1, 0, 0}, 1}, {colouredFloor(), {}, 1}};
        const Camera camera{
            .target = {0, 0, 0}, .distance = distance, .azimuth = 20, .elevation = 25, .perspective = perspective};
        const PictureOptions options{.width = 120, .height = 90, .background = {0, 0, 1}, .samplesPerAxis = 1};
        const Picture picture = rendered(*cpu_, scene, camera, options);
        const Eigen::Matrix4d worldFromClip =
            makeViewTransform(camera, picture.width, picture.height, scene.bounds).clipFromWorld.inverse();
        int seen = 0;
        for (int y = 0; y < picture.height; ++y)
            for (int x = 0; x < picture.width; ++x) {
                const auto& [red, green, blue, alpha] = pixelAt(picture, x, y);
                const auto place = floorAt(worldFromClip, picture, x, y);
                if (!place || blue == 255)
                    continue; // beside the floor
                const auto share = [](double at) { return static_cast<float>((at / half + 1) / 2); };
                const Colour expected{share(place->x()), share(place->y()), 0.25f};
                QVERIFY(std::abs(red - toByte(expected.red)) <= 2 && std::abs(green - toByte(expected.green)) <= 2);
                QVERIFY(std::abs(blue - toByte(expected.blue)) <= 1);
                ++seen;
            }
        QVERIFY(seen > picture.width * picture.height / 4);
    }

    void whatFacesTheEyeIsLeftOut_data()
    {
        QTest::addColumn<QString>("look");
        QTest::addColumn<bool>("perspective");
        for (const char* look : {"translucent", "values"})
            for (const bool perspective : {true, false})
                QTest::addRow("%s, %d", look, perspective) << QString(look) << perspective;
    }
    void whatFacesTheEyeIsLeftOut()
    {
        QFETCH(QString, look);
        QFETCH(bool, perspective);
        SceneParts scene = boundaryScene(5, look, false);
        const Camera camera = boundaryCamera(scene, perspective);
        const Eigen::Vector3d eye = eyePosition(camera);
        const Eigen::Vector3d towards = eye - camera.target;
        auto farSide = std::make_shared<TriangleMesh>(*scene.surfaces[0].mesh);
        std::erase_if(farSide->triangles, [&](const auto& triangle) {
            const auto at = [&](std::size_t i) {
                return farSide->positions[triangle[i]].template cast<double>().eval();
            };
            const Eigen::Vector3d normal = (at(1) - at(0)).cross(at(2) - at(0));
            return normal.dot(perspective ? Eigen::Vector3d(eye - at(0)) : towards) > 0;
        });
        const PictureOptions options{.width = 150, .height = 110};
        const Picture both = rendered(*cpu_, scene, camera, options);
        scene.surfaces[0].backFacesOnly = true;
        const Picture culled = rendered(*cpu_, scene, camera, options);
        SceneParts byHand = scene;
        byHand.surfaces[0] = {farSide, scene.surfaces[0].colour, scene.surfaces[0].opacity};
        QVERIFY(culled.pixels == rendered(*cpu_, byHand, camera, options).pixels);
        QVERIFY(culled.pixels != both.pixels);
    }

    void badColoursAreErrors()
    {
        for (const bool values : {true, false}) {
            auto mesh = std::make_shared<TriangleMesh>(*colouredFloor());
            mesh->colours.pop_back();
            if (values) {
                mesh->colours.clear();
                mesh->values = {1, 2};
            }
            const auto picture = cpu_->render(SceneParts{{{mesh, {}, 1}}, {}, cube(1)}, {}, {});
            QVERIFY(!picture && picture.error().kind == ErrorKind::WrongUsage);
        }
    }
};

QTEST_GUILESS_MAIN(BoundaryPictureTest)
#include "boundary_picture_test.moc"
