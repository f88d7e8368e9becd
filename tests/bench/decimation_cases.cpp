// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/decimation_cases.h"

#include "core/decimate/decimation.h"
#include "core/decimate/lattice_tetrahedra.h"
#include "plugins/samples/samples.h"
#include "tests/bench/cgal_bulk_insertion.h"
#include "tests/bench/mesh_judge.h"
#include "tests/bench/vtk_decimation.h"
#include "tests/core/refine/recorded_history.h"

#include <QFile>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace tetra {

namespace {

/// Takes a history and keeps of it how the key falls from site to site.
struct KeySink : HistorySink {
    std::vector<float> runningKeys; ///< the smallest key of the meshes with at most so many sites
    Status add(const HistoryStep& step) override
    {
        runningKeys.push_back(runningKeys.empty() ? step.keyBefore : std::min(runningKeys.back(), step.keyBefore));
        return {};
    }
    Status finish(float) override { return {}; }
};

/// One percent of the diagonal is worth one of the value range.
DecimationOptions optionsFor(const PlainMesh& mesh)
{
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& position : mesh.positions)
        box.extend(position);
    const auto [low, high] = std::ranges::minmax(mesh.values);
    DecimationOptions options;
    options.warpingWeight = (high - low) / box.diagonal().norm();
    return options;
}

DecimationMesh inputOf(const PlainMesh& mesh)
{
    DecimationMesh input;
    input.positions = mesh.positions;
    input.values = mesh.values;
    input.tetrahedra = mesh.tetrahedra;
    return input;
}

/// The largest number of sites whose mesh has at most so many tetrahedra.
std::size_t sitesFor(const RecordedHistory& history, std::size_t tetrahedra)
{
    std::vector<std::int64_t> change(history.points.size() + 1);
    for (const auto& t : history.tetrahedra) {
        ++change[t.sites[0]];
        if (t.destroyer < history.points.size())
            --change[t.destroyer];
    }
    std::size_t best = 0;
    std::int64_t alive = 0;
    for (std::size_t site = 0; site < history.points.size(); ++site) {
        alive += change[site];
        if (alive <= std::int64_t(tetrahedra))
            best = site + 1;
    }
    return best;
}

PlainMesh meshAt(const RecordedHistory& history, const PlainMesh& original, std::size_t sites)
{
    PlainMesh mesh;
    for (std::size_t site = 0; site < sites; ++site) {
        mesh.positions.push_back(original.positions[history.points[site]]);
        mesh.values.push_back(original.values[history.points[site]]);
    }
    for (const auto& t : history.tetrahedra)
        if (history.alive(t, sites))
            mesh.tetrahedra.push_back(t.sites);
    return mesh;
}

void addJudgement(const QString& whose, const PlainMesh& original, const PlainMesh& mesh, QJsonObject& figures)
{
    const MeshJudgement judgement = judge(original, mesh);
    figures[whose + "_tetrahedra"] = qint64(mesh.tetrahedra.size());
    figures[whose + "_vertices"] = qint64(mesh.positions.size());
    figures[whose + "_largest_error_percent"] = judgement.largestError;
    figures[whose + "_mean_error_percent"] = judgement.meanError;
    figures[whose + "_outside"] = qint64(judgement.outside);
    figures[whose + "_farthest_outside_percent"] = judgement.farthestOutside;
    figures[whose + "_inverted"] = qint64(judgement.inverted);
    figures[whose + "_overshoot_percent"] = judgement.overshoot;
}

struct TimedDecimation {
    double seconds = 0;
    DecimationResult result;
    std::vector<float> runningKeys;
};

TimedDecimation timeDecimation(const DecimationMesh& mesh, const DecimationOptions& options)
{
    TimedDecimation timed;
    KeySink sink;
    timed.seconds = secondsOn(1, [&] { timed.result = decimate(mesh, options, sink).value(); });
    timed.runningKeys = std::move(sink.runningKeys);
    return timed;
}

/// At the accuracies of the paper's Table 2.
void addSites(const TimedDecimation& timed, const std::vector<double>& values, QJsonObject& figures)
{
    const auto [low, high] = std::ranges::minmax(values);
    for (const double percent : {4.0, 3.0, 2.0, 1.0, .5, .2, .1}) {
        const double key = percent / 100 * (high - low);
        const auto sites =
            std::ranges::find_if(timed.runningKeys, [key](float at) { return static_cast<double>(at) <= key; }) -
            timed.runningKeys.begin();
        figures[QString("sites_at_%1_percent").arg(percent)] = qint64(sites);
    }
}

BenchCase latticeCase(const QString& name, std::uint32_t n, const std::vector<double>& values)
{
    std::vector<Eigen::Vector3d> positions;
    for (std::uint32_t z = 0; z < n; ++z)
        for (std::uint32_t y = 0; y < n; ++y)
            for (std::uint32_t x = 0; x < n; ++x)
                positions.emplace_back(x, y, z);
    const auto tetrahedra = latticeTetrahedra({n, n, n}, LatticeCut::Five);
    DecimationMesh mesh;
    mesh.positions = positions;
    mesh.values = values;
    mesh.tetrahedra = tetrahedra;
    mesh.box = true;
    const TimedDecimation timed = timeDecimation(mesh, {});
    const double collapses = timed.result.sites - timed.result.initialSites;
    std::size_t cells = 0;
    BenchCase one{.name = name,
                  .seconds = timed.seconds,
                  .yardstick = "CGAL EPICK bulk insertion of all points",
                  .yardstickSeconds = cgalBulkInsertionSeconds(n, cells),
                  .more = {}};
    one.more = {{"collapses_per_second", collapses / timed.seconds},
                {"evaluations_per_collapse", double(timed.result.evaluations) / collapses},
                {"sites_left", qint64(timed.result.initialSites)}};
    addSites(timed, values, one.more);
    std::fprintf(stderr, "%s: %.2f s, %.0f collapses a second, %.2f times the seconds of CGAL's bulk insertion\n",
                 qPrintable(name), timed.seconds, collapses / timed.seconds, timed.seconds / one.yardstickSeconds);
    return one;
}

} // namespace

std::vector<BenchCase> compareWithVtk(const QString& name, const QString& file)
{
    std::vector<BenchCase> cases;
    if (!QFile::exists(file)) {
        std::fprintf(stderr, "%s skipped: no data (%s)\n", qPrintable(name), qPrintable(file));
        return cases;
    }
    const auto vtk = decimateByVtk(file, {.5, .2, .1});
    if (!vtk) {
        std::fprintf(stderr, "%s skipped: no VTK; it needs the package python3-vtk9\n", qPrintable(name));
        return cases;
    }
    const DecimationMesh input = inputOf(vtk->original);
    DecimationOptions options = optionsFor(vtk->original);
    RecordedHistory history;
    const auto whole = decimate(input, options, history);
    if (!whole) {
        std::fprintf(stderr, "%s skipped: %s\n", qPrintable(name), whole.error().text().c_str());
        return cases;
    }
    for (const VtkDecimation::Level& level : vtk->levels) {
        const std::size_t sites = sitesFor(history, level.mesh.tetrahedra.size());
        const PlainMesh ours = meshAt(history, vtk->original, sites);
        // The next split would leave this error behind: collapses up to it lead here.
        options.stopKey = sites < history.points.size() ? history.runningKeys[sites] : 0;
        BenchCase one{.name = QString("%1, %2 % of %3 tetrahedra")
                                  .arg(name)
                                  .arg(100 * level.share)
                                  .arg(vtk->original.tetrahedra.size()),
                      .seconds = timeDecimation(input, options).seconds,
                      .yardstick = "vtkUnstructuredGridQuadricDecimation",
                      .yardstickSeconds = level.seconds,
                      .more = {}};
        addJudgement("ours", vtk->original, ours, one.more);
        addJudgement("vtk", vtk->original, level.mesh, one.more);
        std::fprintf(stderr, "%s: done\n", qPrintable(one.name));
        cases.push_back(one);
    }
    return cases;
}

std::vector<BenchCase> collapsesOfLattice(const QString& file, std::uint32_t n)
{
    QFile raw(file);
    if (!raw.open(QIODevice::ReadOnly) || raw.size() != qint64(n) * n * n) {
        std::fprintf(stderr, "collapses of a lattice skipped: no data (%s)\n", qPrintable(file));
        return {};
    }
    const QByteArray bytes = raw.readAll();
    std::vector<double> values;
    for (const char byte : bytes)
        values.push_back(static_cast<unsigned char>(byte));
    return {latticeCase(QString("Bucky %1^3 to its coarsest mesh").arg(n), n, values)};
}

std::vector<BenchCase> growthOfTime(const std::vector<std::uint32_t>& sizes)
{
    std::vector<BenchCase> cases;
    const auto work = [](std::uint32_t n) { return 3.0 * n * n * n * std::log(n); };
    for (const std::uint32_t n : sizes) {
        const Dataset dataset = makeSample({"c60", n, SampleType::Float32}).value();
        const std::span<const float> samples = dataset.values.as<float>();
        cases.push_back(latticeCase(QString("c60 %1^3 to its coarsest mesh").arg(n), n,
                                    std::vector<double>(samples.begin(), samples.end())));
        const double first = cases.front().seconds / work(sizes.front());
        cases.back().more["time_over_n_log_n"] = cases.back().seconds / work(n) / first;
    }
    return cases;
}

} // namespace tetra
