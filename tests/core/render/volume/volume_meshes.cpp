// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/render/volume/volume_meshes.h"

#include "tests/core/history/model_fixture.h"
#include "tests/core/history/query/lattice_models.h"
#include "tests/core/render/lattice_mesh.h"

#include <tan/query.h>

#include <Eigen/Geometry>

#include <QTemporaryDir>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace tetra::testing {
namespace {

TetrahedralMesh extracted(const Dataset& dataset)
{
    const QTemporaryDir folder;
    const std::filesystem::path path = folder.filePath("model.tan").toStdString();
    writeModel(path, dataset);
    const auto model = Model::open(path);
    const double percent = dataset.values.range().extent() / 100;
    auto mesh = extractPrefix(*model.value(), meshSizeAt(*model.value(), {2 * percent}).sites);
    if (!mesh)
        qFatal("%s", mesh.error().text().c_str());
    return std::move(mesh).value();
}

double waves(const Eigen::Vector3d& p)
{
    return 0.5 + 0.25 * std::sin(4 * p.x() + p.y()) + 0.25 * std::cos(5 * p.y() - 3 * p.z() * p.x());
}

} // namespace

TetrahedralMesh oneCell()
{
    TetrahedralMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0.1f, 0}, {0.2f, 1, 0.1f}, {0.3f, 0.2f, 1}};
    mesh.values = {0, 0.3f, 1, 0.7f};
    mesh.tetrahedra = {{0, 1, 2, 3}};
    return mesh;
}

TetrahedralMesh irregularWithHole()
{
    constexpr std::uint32_t cells = 5;
    TetrahedralMesh mesh = latticeMesh(cells, 1, Split::Six, waves);
    std::mt19937 random(4);
    std::uniform_real_distribution<float> jitter(-0.03f, 0.03f);
    for (auto& position : mesh.positions)
        position += Eigen::Vector3d(jitter(random), jitter(random), jitter(random));
    // Six tetrahedra a cube, cubes along x first. A tunnel along x, a slit, and what it cuts off.
    decltype(mesh.tetrahedra) kept;
    for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
        const std::size_t cube = t / 6, j = cube / cells % cells, k = cube / cells / cells;
        const bool tunnel = j == 2 && k == 2;
        const bool slit = k == 3;
        if (!tunnel && !(slit && j != 0) && t % 37 != 5)
            kept.push_back(mesh.tetrahedra[t]);
    }
    mesh.tetrahedra = kept;
    return mesh;
}

TetrahedralMesh refinedLattice()
{
    return extracted(bumps(SampleType::Float32, {9, 8, 7}));
}

TetrahedralMesh refinedBentGrid()
{
    return extracted(bentBumps(SampleType::Float32, {7, 6, 5}));
}

TetrahedralMesh refinedInBlocks()
{
    const QTemporaryDir folder;
    const Dataset dataset = bumps(SampleType::UInt8, {9, 7, 9});
    const auto model = modelOf(dataset, 4, folder.path().toStdString());
    const double percent = dataset.values.range().extent() / 100;
    auto mesh = extractPrefix(*model, meshSizeAt(*model, {2 * percent}).sites);
    if (!mesh)
        qFatal("%s", mesh.error().text().c_str());
    return std::move(mesh).value();
}

TetrahedralMesh variableResolution()
{
    const QTemporaryDir folder;
    const Dataset dataset = bumps(SampleType::Float32, {9, 8, 7});
    const std::filesystem::path path = folder.filePath("model.tan").toStdString();
    writeModel(path, dataset);
    const Lattice& lattice = dataset.lattice;
    MeshQuery query;
    query.error = SpaceRamp{Sphere{lattice.origin, 3 * lattice.spacing[0]}, 0.5, 20, 4 * lattice.spacing[0]};
    const auto mesh = MeshExtractor(Model::open(path).value()).extract(query);
    if (!mesh)
        qFatal("%s", mesh.error().text().c_str());
    return mesh.value()->mesh;
}

TetrahedralMesh randomLattice(std::uint32_t seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> value(0, 1);
    TetrahedralMesh mesh = latticeMesh(3, 1, Split::Five, [&](const Eigen::Vector3d&) { return value(random); });
    std::ranges::shuffle(mesh.tetrahedra, random);
    return mesh;
}

namespace {

using Corners = std::array<Eigen::Vector3d, 4>;

void addCell(TetrahedralMesh& mesh, Corners corners)
{
    if ((corners[1] - corners[0]).dot((corners[2] - corners[0]).cross(corners[3] - corners[0])) < 0)
        std::swap(corners[2], corners[3]);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const Eigen::Vector3d& corner : corners) {
        mesh.positions.push_back(corner);
        mesh.values.push_back(static_cast<float>(0.5 + 0.5 * std::sin(3 * corner.x() + 2 * corner.y() - corner.z())));
    }
    mesh.tetrahedra.push_back({first, first + 1, first + 2, first + 3});
}

/// Whether a plane parts them: along a face of one, or along an edge of each.
bool areApart(const Corners& one, const Corners& other)
{
    const auto isBetween = [&](const Eigen::Vector3d& normal) {
        const auto reach = [&](const Corners& of) {
            const std::array<double, 4> heights{normal.dot(of[0]), normal.dot(of[1]), normal.dot(of[2]),
                                                normal.dot(of[3])};
            return std::ranges::minmax(heights);
        };
        const auto a = reach(one), b = reach(other);
        const double margin = 1e-3 * normal.norm();
        return margin > 1e-9 && (a.max + margin < b.min || b.max + margin < a.min);
    };
    std::vector<Eigen::Vector3d> edges[2];
    for (int side = 0; side < 2; ++side)
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < i; ++j)
                edges[side].emplace_back((side == 0 ? one : other)[i] - (side == 0 ? one : other)[j]);
    for (int side = 0; side < 2; ++side)
        for (const auto& a : edges[side])
            for (const auto& b : edges[side])
                if (isBetween(a.cross(b)))
                    return true;
    return std::ranges::any_of(edges[0], [&](const auto& a) {
        return std::ranges::any_of(edges[1], [&](const auto& b) { return isBetween(a.cross(b)); });
    });
}

} // namespace

TetrahedralMesh threeSticks()
{
    TetrahedralMesh mesh;
    const auto corner = [](int number) {
        const double angle = number * 2.0943951023931953;
        return Eigen::Vector3d(std::cos(angle), 0, std::sin(angle));
    };
    for (int stick = 0; stick < 3; ++stick) {
        const Eigen::Vector3d along = corner(stick + 1) - corner(stick);
        const Eigen::Vector3d back = corner(stick) - 0.3 * along + Eigen::Vector3d(0, 0.3, 0);
        const Eigen::Vector3d front = corner(stick + 1) + 0.3 * along - Eigen::Vector3d(0, 0.3, 0);
        const Eigen::Vector3d across = 0.1 * along.cross(Eigen::Vector3d::UnitY()).normalized();
        const Eigen::Vector3d deep(0, 0.1, 0);
        addCell(mesh, {back - across, back + across, front - deep, front + deep});
    }
    return mesh;
}

TetrahedralMesh needles(int count, std::uint32_t seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> coordinate(-1, 1), thickness(0.04, 0.16);
    const auto somewhere = [&] { return Eigen::Vector3d(coordinate(random), coordinate(random), coordinate(random)); };
    TetrahedralMesh mesh;
    std::vector<Corners> all;
    while (static_cast<int>(all.size()) < count) {
        const Eigen::Vector3d from = somewhere(), to = somewhere();
        if ((to - from).norm() < 1)
            continue;
        const Eigen::Vector3d a = thickness(random) * (to - from).cross(somewhere()).normalized();
        const Eigen::Vector3d b = thickness(random) * (to - from).cross(somewhere()).normalized();
        const Corners corners{from - a, from + a, to - b, to + b};
        if (std::ranges::all_of(all, [&](const Corners& other) { return areApart(corners, other); })) {
            all.push_back(corners);
            addCell(mesh, corners);
        }
    }
    return mesh;
}

std::vector<NamedMesh> volumeMeshes()
{
    return {{"one cell", oneCell()},
            {"irregular with a hole", irregularWithHole()},
            {"refined lattice", refinedLattice()},
            {"refined in blocks", refinedInBlocks()},
            {"variable resolution", variableResolution()},
            {"refined bent grid", refinedBentGrid()},
            {"random lattice", randomLattice(7)}};
}

std::vector<NamedFunction> volumeFunctions(double smallest, double largest, double unitDistance)
{
    const auto make = [&](std::vector<TransferPoint> points) {
        for (TransferPoint& point : points)
            point.value = std::lerp(smallest, largest, point.value);
        return transferFunctionFromPoints(points, unitDistance);
    };
    // The knots of the colours lie elsewhere than those of the opacities, and so do their steps.
    const auto twoCurves = [&] {
        TransferFunction function{{{0.1, {0, 0, 1}}, {0.45, {0, 1, 0}}, {0.45, {1, 1, 0}}, {0.8, {1, 0, 0.5f}}},
                                  {{0.2, 0}, {0.4, 0.5f}, {0.6, 0.1f}, {0.6, 0.4f}, {0.95, 0.02f}},
                                  unitDistance};
        for (ColourPoint& point : function.colours)
            point.value = std::lerp(smallest, largest, point.value);
        for (OpacityPoint& point : function.opacities)
            point.value = std::lerp(smallest, largest, point.value);
        return function;
    };
    return {
        {"ramp", make({{0, {0, 0, 1}, 0}, {1, {1, 0.5f, 0}, 0.6f}})},
        {"ramps", make({{0, {0, 0, 1}, 0},
                        {0.05, {0, 0.2f, 1}, 0.02f},
                        {0.2, {0, 0.8f, 1}, 0.1f},
                        {0.25, {0, 1, 1}, 0.12f},
                        {0.5, {0, 1, 0}, 0.25f},
                        {0.75, {1, 1, 0}, 0.5f},
                        {1, {1, 0, 0}, 0.8f}})},
        {"steps", make({{0.3, {1, 1, 1}, 0},
                        {0.3, {1, 0, 0}, 0.5f},
                        {0.5, {1, 0, 0}, 0.5f},
                        {0.5, {0, 1, 0}, 0.1f},
                        {0.7, {0, 0, 1}, 0.3f},
                        {0.7, {0, 0, 0}, 0}})},
        {"spikes", make({{0.25, {1, 1, 0}, 0},
                         {0.26, {1, 1, 0}, 0.99f},
                         {0.27, {0, 1, 1}, 0},
                         {0.6, {1, 0, 1}, 0},
                         {0.605, {1, 0, 1}, 0.9999f},
                         {0.605, {0, 1, 0}, 0.2f},
                         {0.7, {0, 0.5f, 0}, 0}})},
        {"opaque",
         make({{0.2, {0, 0, 0}, 0},
               {0.4, {0.2f, 0.4f, 1}, 0.2f},
               {0.55, {1, 0.9f, 0.8f}, 0.3f},
               {0.55, {0.9f, 0.3f, 0.1f}, 1},
               {0.8, {0.2f, 0.7f, 0.1f}, 1}}),
         true},
        {"two curves", twoCurves()},
    };
}

} // namespace tetra::testing
