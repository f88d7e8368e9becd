// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/query_cases.h"

#include "core/history/query/window.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace tetra {

namespace {

constexpr double fine = 0.5;
constexpr double coarse = 4;

std::shared_ptr<const ExtractedMesh> extracted(MeshExtractor& extractor, const MeshQuery& query)
{
    auto mesh = extractor.extract(query);
    if (!mesh) {
        std::fprintf(stderr, "%s\n", mesh.error().text().c_str());
        std::exit(4);
    }
    return *std::move(mesh);
}

/// A query for which curvilinear data must keep their warping, too.
MeshQuery bothWithin(const ErrorField& field)
{
    MeshQuery query;
    query.error = field;
    query.warping = field;
    return query;
}

double freshSeconds(const std::shared_ptr<const Model>& model, double error, int repeats)
{
    const std::uint32_t sites = meshSizeAt(*model, {error, error}).sites;
    std::vector<double> seconds;
    for (int i = 0; i < repeats; ++i)
        seconds.push_back(secondsOf([&] { (void)extractPrefix(*model, sites).value(); }));
    return median(seconds);
}

SpaceRamp boxAt(const Model& model, double volume, double where)
{
    const Eigen::AlignedBox3d& bounds = model.description().bounds;
    const Eigen::Vector3d half = bounds.sizes() * std::cbrt(volume) / 2;
    const Eigen::Vector3d centre = bounds.center() + bounds.sizes() * where;
    return {Box{centre - half, centre + half}, fine, coarse, 0};
}

std::size_t meeting(const TetrahedralMesh& mesh, const Box& box)
{
    TetrahedralMesh copy = mesh;
    if (!keepWindow(copy, {box, WindowBorder::Intersecting}))
        std::exit(4);
    return copy.tetrahedra.size();
}

BenchCase focusCase(const std::shared_ptr<const Model>& model, const QString& name, double volume,
                    VariableMethod method, double fineSeconds, double ideal, int repeats)
{
    MeshExtractor extractor(model);
    std::shared_ptr<const ExtractedMesh> mesh;
    std::vector<double> seconds;
    for (int i = 0; i <= repeats; ++i) {
        mesh.reset();
        MeshQuery query = bothWithin(boxAt(*model, volume, 0.3)); // elsewhere: nothing to go on from
        query.method = method;
        extracted(extractor, query);
        query.error = query.warping = boxAt(*model, volume, 0);
        seconds.push_back(secondsOf([&] { mesh = extracted(extractor, query); }));
    }
    seconds.erase(seconds.begin()); // makes what is kept from query to query
    BenchCase one;
    one.name = name + QString(", box of %1 % by %2%3")
                          .arg(100 * volume)
                          .arg(mesh->method == VariableMethod::Insertion ? "insertion" : "closed set")
                          .arg(method == VariableMethod::Automatic ? " (automatic)" : "");
    one.seconds = median(seconds);
    one.yardstick = "uniform fine mesh, afresh";
    one.yardstickSeconds = fineSeconds;
    one.more = {{"sites", qint64(mesh->wholeSites)},
                {"tetrahedra", qint64(mesh->wholeTetrahedra)},
                {"sites_per_second", mesh->wholeSites / one.seconds},
                {"overhead", static_cast<double>(mesh->wholeTetrahedra) / ideal}};
    return one;
}

} // namespace

std::vector<BenchCase> focusBoxCases(const std::shared_ptr<const Model>& model, const QString& name, int repeats)
{
    std::vector<BenchCase> cases;
    const double fineSeconds = freshSeconds(model, fine, repeats);
    MeshExtractor extractor(model);
    const auto fineMesh = extracted(extractor, bothWithin(fine));
    MeshExtractor other(model);
    const auto coarseMesh = extracted(other, bothWithin(coarse));
    for (const double volume : {0.01, 0.05, 0.125, 0.25}) {
        const auto box = std::get<Box>(boxAt(*model, volume, 0).region);
        const double ideal = static_cast<double>(meeting(fineMesh->mesh, box)) +
                             static_cast<double>(coarseMesh->mesh.tetrahedra.size() - meeting(coarseMesh->mesh, box));
        for (const VariableMethod method : {VariableMethod::ClosedSet, VariableMethod::Automatic})
            cases.push_back(focusCase(model, name, volume, method, fineSeconds, ideal, repeats));
    }
    return cases;
}

std::vector<BenchCase> fieldCases(const std::shared_ptr<const Model>& model, const QString& name, int repeats)
{
    const Eigen::AlignedBox3d& bounds = model->description().bounds;
    const ValueRange range = model->description().range;
    const double middle = (range.minimum + range.maximum) / 2;
    const ErrorField graded = SpaceRamp{Sphere{bounds.center(), 0}, fine, 2 * coarse, bounds.diagonal().norm() / 2};
    const ErrorField surface = ErrorField::nearValues(std::array{middle}, fine, 2 * coarse, range.extent() / 8);
    std::vector<std::pair<QString, MeshQuery>> queries = {{"graded", bothWithin(graded)},
                                                          {"isovalue", bothWithin(surface)},
                                                          {"both", bothWithin(smallerOf(graded, surface))},
                                                          {"graded, 200,000 tetrahedra", bothWithin(graded)}};
    queries.back().second.budget = 200000;
    const double fineSeconds = freshSeconds(model, fine, repeats);
    std::vector<BenchCase> cases;
    for (const auto& [text, query] : queries) {
        MeshExtractor extractor(model);
        std::vector<double> seconds;
        std::shared_ptr<const ExtractedMesh> mesh = extracted(extractor, query);
        for (int i = 0; i < repeats; ++i) {
            mesh.reset();
            seconds.push_back(secondsOf([&] { mesh = extracted(extractor, query); }));
        }
        BenchCase one;
        one.name = name + ", " + text;
        one.seconds = median(seconds);
        one.yardstick = "uniform fine mesh, afresh";
        one.yardstickSeconds = fineSeconds;
        one.more = {{"sites", qint64(mesh->wholeSites)},
                    {"tetrahedra", qint64(mesh->wholeTetrahedra)},
                    {"scale", mesh->scale},
                    {"sites_per_second", mesh->wholeSites / one.seconds}};
        cases.push_back(one);
    }
    return cases;
}

} // namespace tetra
