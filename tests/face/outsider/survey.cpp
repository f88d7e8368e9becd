// SPDX-License-Identifier: GPL-3.0-or-later
// survey FOLDER: goes through all of the library's face as a program of somebody else does. Makes a dataset of each
// kind from arrays, builds models of it by each method that takes it, proves them at eight accuracies, asks for meshes
// in every way, and draws them. Prints a line for each; ends with 1 if anything does not hold.
#include <tan/build.h>
#include <tan/query.h>
#include <tan/render.h>
#include <tan/verify.h>
#include <tan/version.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <random>

namespace {

using namespace tetra;

constexpr std::array<double, 8> percents = {50, 20, 10, 5, 2, 1, 0.1, 0};

[[noreturn]] void fail(const std::string& what)
{
    std::cerr << "survey: " << what << '\n';
    std::exit(1);
}

template <class Value> Value taken(Result<Value> result, const std::string& what)
{
    if (!result)
        fail(what + ": " + result.error().text());
    return *std::move(result);
}

void require(bool holds, const std::string& what)
{
    if (!holds)
        fail(what + " does not hold");
}

/// A vortex along z that narrows upwards.
double vortex(const Eigen::Vector3d& place)
{
    const double width = 0.6 - 0.3 * place.z() / 2;
    return std::exp(-place.head<2>().squaredNorm() / (width * width)) * std::cos(2 * place.z());
}

Dataset onLattice()
{
    Lattice lattice;
    lattice.size = {21, 19, 17};
    lattice.spacing = {0.1, 0.11, 0.12};
    lattice.origin = {-1, -1, 0};
    std::vector<float> values(lattice.pointCount());
    for (std::uint64_t point = 0; point < values.size(); ++point) {
        const auto [i, j, k] = lattice.coordinates(point);
        values[point] = static_cast<float>(vortex(lattice.position(i, j, k)));
    }
    return taken(latticeDataset(lattice, ScalarField::of(std::move(values)), "vortex"), "lattice");
}

/// The lattice bent to a quarter of a tube.
Dataset onGrid()
{
    const Dataset straight = onLattice();
    std::vector<Eigen::Vector3d> places;
    for (std::uint64_t point = 0; point < straight.pointCount(); ++point) {
        const Eigen::Vector3d place = straight.position(point);
        const double angle = place.z() * 0.75, radius = 3 + place.x();
        places.emplace_back(radius * std::cos(angle), place.y(), radius * std::sin(angle));
    }
    return taken(curvilinearDataset(straight.lattice.size, std::move(places), straight.values, "bent"), "grid");
}

Dataset onPoints()
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> anywhere(-1, 1);
    std::vector<Eigen::Vector3d> places;
    std::vector<double> values;
    for (int point = 0; point < 3000; ++point) {
        places.emplace_back(anywhere(random), anywhere(random), 1 + anywhere(random));
        values.push_back(vortex(places.back()));
    }
    return taken(scatteredDataset(std::move(places), std::move(values), "scattered"), "points");
}

/// Hexahedra over the points of the lattice, without those in the middle: a block with a hole through it.
Dataset onCells()
{
    const Dataset points = onLattice();
    const auto& size = points.lattice.size;
    CellComplex cells;
    ComplexValues values;
    for (std::uint64_t point = 0; point < points.pointCount(); ++point) {
        cells.positions.push_back(points.position(point));
        values.values.push_back(points.values.at(point));
    }
    cells.offsets.push_back(0);
    for (std::uint32_t k = 0; k + 1 < size[2]; ++k)
        for (std::uint32_t j = 0; j + 1 < size[1]; ++j)
            for (std::uint32_t i = 0; i + 1 < size[0]; ++i) {
                if (i > 7 && i < 12 && j > 6 && j < 11)
                    continue;
                for (std::uint32_t corner = 0; corner < 8; ++corner) // as VTK numbers a voxel
                    cells.corners.push_back(
                        points.lattice.index(i + (corner & 1), j + (corner >> 1 & 1), k + (corner >> 2)));
                cells.shapes.push_back(CellShape::Voxel);
                cells.offsets.push_back(cells.corners.size());
            }
    return taken(irregularDataset(cells, values, Source{.name = "with a hole", .path = {}}), "cells");
}

/// Every accuracy proved against the data.
void prove(const Model& model, const Dataset& dataset)
{
    std::vector<Accuracy> levels;
    for (const double percent : percents)
        levels.push_back({.error = percent});
    const VerificationReport report = taken(verify(model, dataset, levels), "verify");
    for (const LevelReport& level : report.levels)
        require(level.ok(), std::to_string(level.asked.error) + " %: " + (level.ok() ? "" : level.failures.front()));
    require(report.ok(), "the file");
}

/// Uniform, in a window, of some values, within a budget, in a focus: each mesh is what was asked for.
std::shared_ptr<const ExtractedMesh> ask(const std::shared_ptr<const Model>& model)
{
    const ModelDescription& about = model->description();
    const Eigen::Vector3d middle = about.bounds.center();
    MeshExtractor extractor(model);
    std::size_t before = 0;
    for (const double percent : percents) {
        const MeshSize size = meshSizeAt(*model, {.error = percent});
        require(size.tetrahedra >= before, "finer meshes are larger");
        before = size.tetrahedra;
    }
    MeshQuery query;
    query.error = 2;
    query.warping = 2; // in the ratio of the build: another one may have a smaller mesh
    const auto whole = taken(extractor.extract(query), "uniform");
    require(whole->mesh.tetrahedra.size() == meshSizeAt(*model, {.error = 2, .warping = 2}).tetrahedra,
            "the size foretold");

    MeshQuery windowed = query;
    windowed.window = Window{{about.bounds.min(), middle}, WindowBorder::Clipped};
    const auto part = taken(extractor.extract(windowed), "window");
    for (const Eigen::Vector3d& place : part->mesh.positions)
        require((place.cast<double>() - middle).maxCoeff() < 1e-5, "a clipped mesh ends at its window");

    MeshQuery ranged = query;
    ranged.values = {{0.5, 0.6}};
    require(taken(extractor.extract(ranged), "range")->mesh.tetrahedra.size() < whole->mesh.tetrahedra.size(),
            "some values are fewer tetrahedra");

    MeshQuery focused;
    focused.error = SpaceRamp{Sphere{middle, 0.3}, 0.5, 20, 0.2};
    focused.budget = 20000;
    const auto focus = taken(extractor.extract(focused), "focus");
    require(focus->wholeTetrahedra <= 20000, "a budget");
    require(taken(parseErrorField(toText(focused.error)), "text") == focused.error, "a field as text");
    return whole;
}

void draw(const std::shared_ptr<const ExtractedMesh>& extracted, const ModelDescription& about,
          const std::filesystem::path& path)
{
    const auto mesh = meshOf(extracted);
    Scene scene;
    scene.bounds = about.bounds;
    scene.drawables = taken(IsosurfaceCache(mesh).drawables(std::array{Isovalue{.value = 0.4}}), "isosurface");
    require(!shapesOf<Surface>(scene).front()->mesh->triangles.empty(), "an isosurface of some triangles");
    scene.drawables.push_back(
        {.id = "boundary", .shape = taken(BoundaryCache(mesh).plain({.opacity = 0.2f}), "boundary")});
    auto function = fittedTransferFunction(volumeHistogram(*mesh, about.range.minimum, about.range.maximum, 64),
                                           about.bounds.diagonal().norm() / 40);
    function = taken(transferFunctionFromText(transferFunctionToText(function)), "transfer function");
    for (OpacityPoint& point : function.opacities)
        point.opacity /= 2;
    scene.drawables.push_back({.id = "volume", .shape = taken(VolumeCache(mesh).update(function, true), "volume")});
    require(drawableOf(scene, "volume") != nullptr && drawableOf(scene, "fog") == nullptr, "drawables by their ids");
    const Picture picture =
        taken(makeCpuBackend()->render(scene, fitted({.azimuth = 50}, scene.bounds), {.width = 400, .height = 300}),
              "picture");
    const auto drawn = std::ranges::count_if(picture.pixels, [](const auto& pixel) { return pixel[1] < 250; });
    require(drawn > 10000, "something is seen");
    std::ofstream file(path, std::ios::binary);
    file << "P6 " << picture.width << ' ' << picture.height << " 255\n";
    for (const auto& pixel : picture.pixels)
        file.write(reinterpret_cast<const char*>(pixel.data()), 3);
    require(file.good(), path.string());
}

} // namespace

int main(int count, char** arguments)
{
    if (count != 2)
        fail("usage: survey FOLDER");
    const std::filesystem::path folder = arguments[1];
    require(libraryVersion() == LibraryVersion{TAN_VERSION_MAJOR, TAN_VERSION_MINOR, TAN_VERSION_PATCH},
            "the library of these headers");
    for (const Dataset& dataset : {onLattice(), onGrid(), onPoints(), onCells()})
        for (const BuildMethod& method :
             {BuildMethod(Refinement{}), BuildMethod(Refinement{.block = 8}), BuildMethod(Decimation{})}) {
            const auto* refinement = std::get_if<Refinement>(&method);
            const std::string name =
                std::string(domainClassName(dataset.domain)) + (refinement == nullptr ? "-decimated"
                                                                : refinement->block   ? "-blocks"
                                                                                      : "-whole");
            const auto report = buildModel(dataset, folder / (name + ".tan"), method);
            if (!report &&
                (report.error().kind == ErrorKind::BadInput || report.error().kind == ErrorKind::WrongUsage)) {
                // not a method for these data
                std::cout << std::left << std::setw(24) << name << report.error().text() << '\n';
                continue;
            }
            const auto model = taken(Model::open(folder / (name + ".tan")), "open");
            require(taken(report, name).sites == model->siteCount(), "as many sites as reported");
            prove(*model, dataset);
            draw(ask(model), model->description(), folder / (name + ".ppm"));
            std::cout << std::left << std::setw(24) << name << std::right << std::setw(8) << model->siteCount()
                      << " sites " << std::setw(9) << model->tetrahedronCount() << " tetrahedra, all proved\n";
        }
}
