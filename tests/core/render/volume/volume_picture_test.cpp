// SPDX-License-Identifier: GPL-3.0-or-later
// Direct volume rendering (R20, R22, S15) against a slow integrator, from outside, inside and behind.
#include "core/render/scene_checks.h"
#include "core/render/volume/volume_renderer.h"
#include "tests/core/render/lattice_mesh.h"
#include "tests/core/render/scene_parts.h"
#include "tests/core/render/volume/ray_integrator.h"
#include "tests/core/render/volume/volume_meshes.h"

#include <tan/render.h>

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

using namespace tetra;
using namespace tetra::testing;
using Eigen::Vector3d;

namespace {

constexpr int width = 28;
constexpr int height = 20;

const std::vector<NamedMesh>& meshes()
{
    static const std::vector<NamedMesh> all = volumeMeshes();
    return all;
}

const TetrahedralMesh& meshNamed(const QString& name)
{
    return std::ranges::find(meshes(), name.toStdString(), &NamedMesh::name)->mesh;
}

Eigen::AlignedBox3d boundsOf(const TetrahedralMesh& mesh)
{
    Eigen::AlignedBox3d bounds;
    for (const auto& position : mesh.positions)
        if (position.allFinite())
            bounds.extend(Vector3d(position.cast<double>()));
    return bounds;
}

std::vector<NamedFunction> functionsFor(const TetrahedralMesh& mesh)
{
    const auto [low, high] = std::ranges::minmax(mesh.values);
    return volumeFunctions(low, high, boundsOf(mesh).diagonal().norm() / 10);
}

NamedFunction functionNamed(const TetrahedralMesh& mesh, const std::string& name)
{
    const auto functions = functionsFor(mesh);
    return *std::ranges::find(functions, name, &NamedFunction::name);
}

VolumePicture drawn(const TetrahedralMesh& mesh, const TransferFunction& function, const Camera& camera,
                    VolumeOptions options = {width, height})
{
    const auto shared = std::make_shared<const TetrahedralMesh>(mesh);
    const auto volume = makeVolumeMesh(shared);
    const auto transfer = makeVolumeTransfer(mesh, function);
    const auto order = orderForCamera(volume.value(), camera, options);
    auto picture = drawVolume(volume.value(), transfer.value(), order.value(), camera, options);
    if (!picture)
        qFatal("%s", picture.error().text().c_str());
    return std::move(picture).value();
}

Camera cameraFor(const TetrahedralMesh& mesh, bool perspective)
{
    Camera camera;
    camera.azimuth = 33;
    camera.elevation = 21;
    camera.perspective = perspective;
    return zoomed(fitted(camera, boundsOf(mesh)), 0.8);
}

void verifyNear(const PictureDifference& difference, bool opaque)
{
    const QString found = QString("largest %1, mean %2").arg(difference.largest * 255).arg(difference.mean);
    QVERIFY2(difference.largest <= (opaque ? 2.0 : 1.0) / 255 && difference.mean <= 1e-4, qPrintable(found));
}

bool sameSamples(const VolumePicture& one, const VolumePicture& other)
{
    return std::ranges::equal(one.samples, other.samples) && std::ranges::equal(one.depth, other.depth);
}

} // namespace

class VolumePictureTest : public QObject {
    Q_OBJECT

private slots:
    void agreesWithTheIntegrator_data();
    void agreesWithTheIntegrator();
    void eyeInTheMesh_data();
    void eyeInTheMesh();
    void behindTheEyeIsNothing();
    void alongTheAxesOfALattice();
    void cyclesOfTheOrder_data();
    void cyclesOfTheOrder();
    void constantFields();
    void emptyFunctions();
    void cellsInAnyOrderOfStorage();
    void oneThreadEqualsMany();
    void flatCellsAndHolesInTheValues();
    void depthIsWhereHalfIsHidden();
    void anySizeOfPicture();
    void theLargestPicturesAreWhole();
    void tellsWhatIsWrong();
    void canBeCancelled();
};

void VolumePictureTest::agreesWithTheIntegrator_data()
{
    QTest::addColumn<QString>("mesh");
    QTest::addColumn<QString>("function");
    QTest::addColumn<bool>("perspective");
    for (const NamedMesh& mesh : meshes())
        for (const NamedFunction& function : functionsFor(mesh.mesh))
            for (const bool perspective : {true, false})
                QTest::addRow("%s, %s, %s", mesh.name.c_str(), function.name.c_str(),
                              perspective ? "perspective" : "orthographic")
                    << QString::fromStdString(mesh.name) << QString::fromStdString(function.name) << perspective;
}

void VolumePictureTest::agreesWithTheIntegrator()
{
    QFETCH(QString, mesh);
    QFETCH(QString, function);
    QFETCH(bool, perspective);
    const TetrahedralMesh& tetrahedra = meshNamed(mesh);
    const NamedFunction chosen = functionNamed(tetrahedra, function.toStdString());
    const Camera camera = cameraFor(tetrahedra, perspective);
    const auto difference = compare(drawn(tetrahedra, chosen.function, camera),
                                    RayIntegrator(tetrahedra, chosen.function, camera, width, height));
    QVERIFY(difference.seen > 0.01);
    verifyNear(difference, chosen.opaque);
}

void VolumePictureTest::eyeInTheMesh_data()
{
    QTest::addColumn<QString>("mesh");
    QTest::addColumn<Camera>("camera");
    for (const char* name : {"irregular with a hole", "refined lattice", "random lattice"}) {
        const TetrahedralMesh& mesh = meshNamed(name);
        Camera camera = cameraFor(mesh, true);
        camera.fieldOfView = 60;
        const Eigen::AlignedBox3d bounds = boundsOf(mesh);
        const Vector3d inside = bounds.min() + Vector3d(0.41, 0.47, 0.38).cwiseProduct(bounds.sizes());
        const Vector3d vertex = mesh.positions[mesh.positions.size() / 2].cast<double>();
        QTest::addRow("%s, inside", name) << QString(name) << withEyeAt(camera, inside);
        QTest::addRow("%s, at a vertex", name) << QString(name) << withEyeAt(camera, vertex);
        QTest::addRow("%s, at the front", name)
            << QString(name) << withEyeAt(camera, bounds.center() - 0.5 * bounds.sizes().y() * Vector3d(0, 1, 0));
    }
}

void VolumePictureTest::eyeInTheMesh()
{
    QFETCH(QString, mesh);
    QFETCH(Camera, camera);
    const TetrahedralMesh& tetrahedra = meshNamed(mesh);
    for (const NamedFunction& function : functionsFor(tetrahedra)) {
        const auto difference = compare(drawn(tetrahedra, function.function, camera),
                                        RayIntegrator(tetrahedra, function.function, camera, width, height));
        verifyNear(difference, function.opaque);
    }
}

void VolumePictureTest::behindTheEyeIsNothing()
{
    const TetrahedralMesh& mesh = meshNamed("refined lattice");
    Camera camera = cameraFor(mesh, true);
    camera = withEyeAt(camera, eyePosition(camera) + 2.5 * (camera.target - eyePosition(camera)));
    const auto picture = drawn(mesh, functionNamed(mesh, "ramps").function, camera);
    QVERIFY(!picture.samples.empty());
    for (const auto& sample : picture.samples)
        QCOMPARE(sample[3], 0.0f);
}

void VolumePictureTest::alongTheAxesOfALattice()
{
    const TetrahedralMesh mesh = randomLattice(3);
    const TransferFunction function = functionNamed(mesh, "ramps").function;
    for (const double elevation : {0.0, 90.0, -90.0})
        for (const double azimuth : {0.0, 45.0, 90.0})
            for (const bool perspective : {true, false}) {
                Camera camera = cameraFor(mesh, perspective);
                camera.azimuth = azimuth;
                camera.elevation = elevation;
                const auto difference =
                    compare(drawn(mesh, function, camera), RayIntegrator(mesh, function, camera, width, height));
                verifyNear(difference, false);
            }
}

void VolumePictureTest::cyclesOfTheOrder_data()
{
    QTest::addColumn<TetrahedralMesh>("mesh");
    QTest::addColumn<bool>("perspective");
    for (const bool perspective : {true, false}) {
        const char* view = perspective ? "perspective" : "orthographic";
        QTest::addRow("three sticks, %s", view) << threeSticks() << perspective;
        QTest::addRow("needles, %s", view) << needles(40, 3) << perspective;
    }
}

/// C13: what hides itself in a circle is seen rightly along each ray; no order of whole sticks shows them so. The
/// samples are so near to each other that some of them see each part of the circle.
void VolumePictureTest::cyclesOfTheOrder()
{
    QFETCH(TetrahedralMesh, mesh);
    QFETCH(bool, perspective);
    for (std::size_t vertex = 0; vertex < mesh.values.size(); ++vertex) // neighbours differ
        mesh.values[vertex] = static_cast<float>(vertex / 4 % 3) * 0.4f + static_cast<float>(vertex % 4) * 0.05f;
    const VolumeOptions options{84, 60};
    Camera camera = cameraFor(mesh, perspective);
    camera.azimuth = camera.elevation = 0;
    const TransferFunction dense =
        transferFunctionFromPoints({{0, {1, 0, 0}, 0.9f}, {0.5f, {0, 1, 0}, 0.9f}, {1, {0, 0, 1}, 0.9f}}, 0.1);
    const RayIntegrator integrator(mesh, dense, camera, options.width, options.height);
    verifyNear(compare(drawn(mesh, dense, camera, options), integrator), true);
    const VolumeMesh volume = makeVolumeMesh(std::make_shared<const TetrahedralMesh>(mesh)).value();
    const VisibilityOrder order = orderForCamera(volume, camera, options).value();
    QCOMPARE(order.brokenCycles, std::size_t(0));
    if (mesh.tetrahedra.size() != 3)
        return;
    QVERIFY(order.cycles == 1 && order.pieces.cutCells > 0);
    const VolumeTransfer transfer = makeVolumeTransfer(mesh, dense).value();
    std::array<std::uint32_t, 3> whole{0, 1, 2};
    do {
        VisibilityOrder wrong;
        wrong.cells.assign(whole.begin(), whole.end());
        const auto picture = drawVolume(volume, transfer, wrong, camera, options);
        QVERIFY(compare(picture.value(), integrator).largest > 20.0 / 255);
    } while (std::ranges::next_permutation(whole).found);
}

void VolumePictureTest::constantFields()
{
    TetrahedralMesh mesh = meshNamed("refined lattice");
    std::ranges::fill(mesh.values, 0.5f);
    const double unit = boundsOf(mesh).diagonal().norm() / 10;
    const TransferFunction step = transferFunctionFromPoints({{0.5, {1, 0, 0}, 0.9f}, {0.5, {0, 1, 0}, 0.2f}}, unit);
    const TransferFunction constant = transferFunctionFromPoints({{0.5, {0.3f, 0.6f, 0.9f}, 0.4f}}, unit);
    for (const TransferFunction& function : {step, constant, volumeFunctions(0, 1, unit)[1].function}) {
        const Camera camera = cameraFor(mesh, true);
        const auto picture = drawn(mesh, function, camera);
        verifyNear(compare(picture, RayIntegrator(mesh, function, camera, width, height)), false);
    }
    // The value on the step belongs to the upper side (S16).
    const auto picture = drawn(mesh, step, cameraFor(mesh, true));
    QVERIFY(!picture.samples.empty());
    for (const auto& sample : picture.samples)
        QCOMPARE(sample[0], 0.0f);
}

void VolumePictureTest::emptyFunctions()
{
    const TetrahedralMesh& mesh = meshNamed("refined lattice");
    const auto [low, high] = std::ranges::minmax(mesh.values);
    const TransferFunction clear = transferFunctionFromPoints({{low, {1, 1, 1}, 0}, {high, {1, 0, 0}, 0}}, 1);
    for (const TransferFunction& function : {TransferFunction(), clear}) {
        const auto picture = drawn(mesh, function, cameraFor(mesh, true));
        QCOMPARE(picture.drawnCells, std::size_t(0));
        for (const auto& sample : picture.samples)
            QCOMPARE(sample, (std::array<float, 4>{}));
    }
    TetrahedralMesh nothing;
    for (const auto& sample : drawn(nothing, clear, {}).samples)
        QCOMPARE(sample[3], 0.0f);
}

void VolumePictureTest::cellsInAnyOrderOfStorage()
{
    std::mt19937 random(9);
    QVERIFY(!meshes().empty());
    for (const NamedMesh& named : meshes()) {
        const TransferFunction function = functionNamed(named.mesh, "steps").function;
        const Camera camera = cameraFor(named.mesh, true);
        TetrahedralMesh shuffled = named.mesh;
        std::ranges::shuffle(shuffled.tetrahedra, random);
        const auto one = drawn(named.mesh, function, camera);
        const auto other = drawn(shuffled, function, camera);
        for (std::size_t i = 0; i < one.samples.size(); ++i)
            for (std::size_t channel = 0; channel < 4; ++channel)
                QVERIFY(std::abs(one.samples[i][channel] - other.samples[i][channel]) < 1e-5f);
    }
}

void VolumePictureTest::oneThreadEqualsMany()
{
    const TetrahedralMesh& mesh = meshNamed("irregular with a hole");
    const TransferFunction function = functionNamed(mesh, "ramps").function;
    VolumeOptions options{200, 150, 1, true};
    const auto one = drawn(mesh, function, cameraFor(mesh, true), options);
    options.threads = 0;
    QVERIFY(sameSamples(one, drawn(mesh, function, cameraFor(mesh, true), options)));
}

void VolumePictureTest::flatCellsAndHolesInTheValues()
{
    TetrahedralMesh mesh = meshNamed("random lattice");
    mesh.values[21] = std::numeric_limits<float>::quiet_NaN();
    mesh.values[5] = std::numeric_limits<float>::infinity();
    mesh.positions[60] = Eigen::Vector3d::Constant(std::numeric_limits<float>::quiet_NaN());
    mesh.tetrahedra.push_back({0, 1, 2, 3}); // on a line
    mesh.tetrahedra.push_back({0, 1, 4, 5}); // in a plane
    mesh.tetrahedra.push_back({0, 0, 0, 0}); // a point
    const TransferFunction function = functionNamed(meshNamed("random lattice"), "ramps").function;
    for (const bool perspective : {true, false}) {
        const Camera camera = cameraFor(meshNamed("random lattice"), perspective);
        const auto difference =
            compare(drawn(mesh, function, camera), RayIntegrator(mesh, function, camera, width, height));
        QVERIFY(difference.seen > 0.05);
        verifyNear(difference, false);
    }
}

void VolumePictureTest::depthIsWhereHalfIsHidden()
{
    // A cube of half a unit of optical depth a unit of length: half is hidden after 2 ln 2.
    const TetrahedralMesh mesh = latticeMesh(4, 4, Split::Six, [](const Vector3d&) { return 0.5; });
    const TransferFunction function =
        transferFunctionFromPoints({{0, {1, 1, 1}, static_cast<float>(1 - std::exp(-0.5))}}, 1);
    for (const bool perspective : {true, false}) {
        Camera camera;
        camera.perspective = perspective;
        camera.target = {2, 2, 2};
        camera.distance = 10;
        camera.azimuth = 0;
        camera.elevation = 0;
        const auto picture = drawn(mesh, function, camera, {31, 31, 0, true});
        const std::size_t middle = 15 * 31 + 15;
        QVERIFY(std::abs(picture.depth[middle] - (8 + 2 * std::log(2.0))) < 0.02);
        QCOMPARE(picture.depth[0], std::numeric_limits<float>::infinity());
    }
}

void VolumePictureTest::anySizeOfPicture()
{
    const TetrahedralMesh& mesh = meshNamed("one cell");
    const TransferFunction function = functionNamed(mesh, "ramps").function;
    const Camera camera = cameraFor(mesh, true);
    for (const auto& [columns, rows] : {std::pair{1, 1}, {1, 300}, {65, 63}, {64, 64}, {131, 5}}) {
        const auto picture = drawn(mesh, function, camera, {columns, rows});
        QCOMPARE(picture.samples.size(), std::size_t(columns * rows));
        verifyNear(compare(picture, RayIntegrator(mesh, function, camera, columns, rows)), false);
    }
}

/// From inside, where every ray meets cells, some of them cut by the near plane: the last column and row are drawn,
/// too.
void VolumePictureTest::theLargestPicturesAreWhole()
{
    const TetrahedralMesh& mesh = meshNamed("refined lattice");
    const Eigen::AlignedBox3d bounds = boundsOf(mesh);
    Camera camera = withEyeAt(cameraFor(mesh, true), bounds.center() + 0.013 * bounds.sizes());
    camera.fieldOfView = 0.003; // across one sample
    const TransferFunction black = transferFunctionFromPoints({{0, {0, 0, 0}, 1}}, bounds.diagonal().norm() / 1000);
    for (const auto& [columns, rows] : {std::pair{largestPictureSide, 1}, {1, largestPictureSide}})
        for (const auto& sample : drawn(mesh, black, camera, {columns, rows}).samples)
            QVERIFY(sample[3] > 0.9f);

    // Back ends draw larger ones in parts.
    const auto shared = std::make_shared<const TetrahedralMesh>(mesh);
    SceneParts scene{{}, {}, bounds};
    scene.volume = Volume{std::make_shared<const VolumeMesh>(makeVolumeMesh(shared).value()),
                          std::make_shared<const VolumeTransfer>(makeVolumeTransfer(mesh, black).value())};
    for (const auto& [columns, rows] : {std::pair{largestPictureSide, 1}, {1, largestPictureSide}}) {
        const auto picture =
            makeCpuBackend()->render(scene, camera, {.width = columns, .height = rows, .samplesPerAxis = 1});
        QVERIFY(picture.ok());
        for (const auto& pixel : picture->pixels)
            QVERIFY(pixel[0] < 25);
    }
}

void VolumePictureTest::tellsWhatIsWrong()
{
    auto mesh = std::make_shared<TetrahedralMesh>(oneCell());
    const auto volume = makeVolumeMesh(mesh).value();
    const auto transfer = makeVolumeTransfer(*mesh, {}).value();
    const VisibilityOrder order{{0}, {}, 0, 0}, wrong{{1}, {}, 0, 0};
    QVERIFY(drawVolume(volume, transfer, order, {}, {8, 8}).ok());
    QVERIFY(!drawVolume(volume, transfer, wrong, {}, {8, 8}).ok());
    QVERIFY(!drawVolume(volume, {}, order, {}, {8, 8}).ok());
    for (const VolumeOptions& options :
         {VolumeOptions{0, 8}, VolumeOptions{8, -1}, VolumeOptions{40000, 8}, VolumeOptions{largestPictureSide + 1, 1},
          VolumeOptions{1, largestPictureSide + 1}}) {
        QVERIFY(!drawVolume(volume, transfer, order, {}, options).ok());
        QVERIFY(!orderForCamera(volume, {}, options).ok());
    }
    QVERIFY(!makeVolumeTransfer(*mesh, {{}, {{0, 2}}}).ok());
    auto broken = std::make_shared<TetrahedralMesh>(oneCell());
    broken->tetrahedra[0][2] = 4;
    QVERIFY(!makeVolumeMesh(broken).ok());
    broken->tetrahedra[0][2] = 2;
    broken->values.pop_back();
    QVERIFY(!makeVolumeMesh(broken).ok());
}

void VolumePictureTest::canBeCancelled()
{
    const auto mesh = std::make_shared<const TetrahedralMesh>(meshNamed("irregular with a hole"));
    const auto volume = makeVolumeMesh(mesh).value();
    const auto transfer = makeVolumeTransfer(*mesh, functionNamed(*mesh, "ramps").function).value();
    const Camera camera = cameraFor(*mesh, true);
    const auto order = orderForCamera(volume, camera, {600, 600}).value();
    std::stop_source stop;
    double last = 0;
    const Progress progress(stop.get_token(), [&](double fraction, const Message&) {
        last = fraction;
        if (fraction > 0.5)
            stop.request_stop();
    });
    const auto picture = drawVolume(volume, transfer, order, camera, {600, 600, 1}, progress);
    QVERIFY(!picture.ok() && picture.error().kind == ErrorKind::Cancelled);
    QVERIFY(last > 0.5 && last < 1);
    QVERIFY(!orderForCamera(volume, camera, {600, 600, 1}, progress).ok());
}

QTEST_GUILESS_MAIN(VolumePictureTest)
#include "volume_picture_test.moc"
