// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/focus_cases.h"

#include "core/history/query/region_refiner.h"

#include <algorithm>
#include <cmath>

namespace tetra {

namespace {

constexpr double inner = 0.5;
constexpr double outer = 4;
constexpr int steps = 10;
constexpr double stepShare = 0.02;

/// Whether the bounding box of a tetrahedron meets a box.
bool meets(const TetrahedralMesh& mesh, const std::array<std::uint32_t, 4>& tetrahedron, const Box& box)
{
    Eigen::AlignedBox3d bounds;
    for (const std::uint32_t vertex : tetrahedron)
        bounds.extend(mesh.positions[vertex]);
    return Eigen::AlignedBox3d(box.least, box.largest).intersects(bounds.cast<double>());
}

/// The middle of the part of the domain, of 16^3, with the most vertices.
Eigen::Vector3d densestPlace(const TetrahedralMesh& mesh, const Eigen::AlignedBox3d& bounds)
{
    constexpr int parts = 16;
    std::vector<int> counts(parts * parts * parts);
    for (const Eigen::Vector3d& position : mesh.positions) {
        const Eigen::Array3d share = (position.cast<double>() - bounds.min()).array() / bounds.sizes().array();
        const Eigen::Array3i part = (share * parts).cast<int>().min(parts - 1);
        ++counts[static_cast<std::size_t>((part[2] * parts + part[1]) * parts + part[0])];
    }
    const auto most = static_cast<int>(std::ranges::max_element(counts) - counts.begin());
    const Eigen::Array3d part(most % parts, most / parts % parts, most / parts / parts);
    return bounds.min() + ((part + 0.5) / parts * bounds.sizes().array()).matrix();
}

Box boxAt(const Eigen::AlignedBox3d& bounds, const Eigen::Vector3d& centre, double share)
{
    const Eigen::Vector3d half = bounds.sizes() * (std::cbrt(share) / 2);
    const Eigen::Vector3d middle = centre.cwiseMax(bounds.min() + half).cwiseMin(bounds.max() - half);
    return {middle - half, middle + half};
}

struct Uniform {
    TetrahedralMesh fine;
    TetrahedralMesh coarse;
    double seconds = 0; ///< for the fine one, into fresh buffers
};

double overhead(const Uniform& uniform, const Box& box, std::uint64_t tetrahedra)
{
    const auto count = [&box](const TetrahedralMesh& mesh, bool wanted) {
        return std::ranges::count_if(mesh.tetrahedra, [&](const auto& one) { return meets(mesh, one, box) == wanted; });
    };
    return static_cast<double>(tetrahedra) /
           static_cast<double>(count(uniform.fine, true) + count(uniform.coarse, false));
}

BenchCase made(const QString& name, std::vector<double> seconds, const Uniform& uniform)
{
    BenchCase one;
    one.name = name;
    one.seconds = median(std::move(seconds));
    one.yardstick = "uniform extraction at 0.5 % into fresh buffers";
    one.yardstickSeconds = uniform.seconds;
    return one;
}

void measureBox(RegionRefiner& focus, const Box& box, const Eigen::Vector3d& towards, const Uniform& uniform,
                const QString& name, int repeats, std::vector<BenchCase>& cases)
{
    std::vector<double> seconds;
    ExtractedMesh mesh = focus.extract({box, inner, outer, 0}, true).value(); // loads what is kept
    for (int i = 0; i < repeats; ++i)
        seconds.push_back(secondsOf([&] { mesh = focus.extract({box, inner, outer, 0}, true).value(); }));
    BenchCase fresh = made(name + ", afresh", std::move(seconds), uniform);
    fresh.more = {{"tetrahedra", qint64(mesh.wholeTetrahedra)},
                  {"sites", qint64(mesh.wholeSites)},
                  {"sites_inside", qint64(focus.sitesInside({box, inner, outer, 0}))},
                  {"overhead", overhead(uniform, box, mesh.wholeTetrahedra)}};
    cases.push_back(std::move(fresh));

    std::vector<double> moves;
    for (int i = 0; i < repeats; ++i) {
        mesh = focus.extract({box, inner, outer, 0}, true, {}, std::move(mesh)).value();
        for (int step = 1; step <= steps; ++step) {
            const Eigen::Vector3d offset = towards * step;
            const SpaceRamp ramp{Box{box.least + offset, box.largest + offset}, inner, outer, 0};
            moves.push_back(secondsOf([&] { mesh = focus.extract(ramp, false, {}, std::move(mesh)).value(); }));
        }
    }
    double sum = 0;
    for (const double move : moves)
        sum += move;
    BenchCase moved = made(name + ", dragged by 2 %", moves, uniform);
    moved.more = {{"mean_seconds", sum / static_cast<double>(moves.size())},
                  {"most_seconds", *std::ranges::max_element(moves)}};
    cases.push_back(std::move(moved));
}

} // namespace

std::vector<BenchCase> measureFocus(const Model& model, const QString& name, int repeats)
{
    std::vector<BenchCase> cases;
    if (!RegionRefiner::fits(model))
        return cases;
    Uniform uniform;
    const std::uint32_t sites = meshSizeAt(model, {inner}).sites;
    std::vector<double> seconds;
    for (int i = 0; i < repeats; ++i)
        seconds.push_back(secondsOf([&] { (void)extractPrefix(model, sites).value(); }));
    uniform.seconds = median(std::move(seconds));
    uniform.fine = extractPrefix(model, sites).value();
    uniform.coarse = extractPrefix(model, meshSizeAt(model, {outer}).sites).value();

    RegionRefiner focus(model);
    const Eigen::AlignedBox3d bounds = model.description().lattice.bounds();
    const Eigen::Vector3d dense = densestPlace(uniform.fine, bounds);
    for (const bool atCentre : {true, false})
        for (const double share : {0.01, 0.02, 0.05, 0.125, 0.25}) {
            const Box box = boxAt(bounds, atCentre ? Eigen::Vector3d(bounds.center()) : dense, share);
            Eigen::Vector3d direction = bounds.center() - (box.least + box.largest) / 2;
            if (direction.norm() < bounds.sizes().norm() * stepShare)
                direction = Eigen::Vector3d(1, 1, 1);
            measureBox(focus, box, direction.normalized() * bounds.sizes()[0] * stepShare, uniform,
                       name +
                           QString(", focus of %1 % %2").arg(100 * share).arg(atCentre ? "at the centre" : "on detail"),
                       repeats, cases);
        }
    return cases;
}

} // namespace tetra
