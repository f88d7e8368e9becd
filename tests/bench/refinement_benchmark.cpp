// SPDX-License-Identifier: GPL-3.0-or-later
// Refinement of the synthetic C60 to error 0 with its whole history, as a whole and in blocks, against CGAL's bulk
// insertion of all the points in the same run, on one thread; and the peak memory of a build into a file.

#include "tests/bench/bench_report.h"
#include "tests/bench/cgal_bulk_insertion.h"

#include "core/base/reserved_array.h"
#include "core/history/model_writer.h"
#include "core/refine/lattice/lattice_refinement.h"
#include "plugins/samples/samples.h"

#include <tan/base.h>

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QTemporaryDir>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace tetra {

namespace {

/// Keeps the whole history in memory, block after block.
class MemoryHistory : public HistorySink {
public:
    Status reserve(std::uint64_t points)
    {
        for (Status status : {sites_.reserve(25 * points, MarkedText{"the history"}),
                              destroyers_.reserve(25 * points, MarkedText{"the history"}),
                              errors_.reserve(25 * points, MarkedText{"the history"})})
            if (!status)
                return status;
        return {};
    }
    void beginBlock()
    {
        blockStart_ = count_;
        blockSites_ = points_.size();
    }
    Status add(const HistoryStep& step) override
    {
        for (const HistoryTetrahedron& tetrahedron : step.star) {
            sites_[count_] = tetrahedron.sites;
            errors_[count_] = tetrahedron.error;
            destroyers_[count_++] = Model::never;
        }
        const std::uint32_t site = static_cast<std::uint32_t>(points_.size() - blockSites_);
        for (const std::uint32_t destroyed : step.destroyed)
            destroyers_[blockStart_ + destroyed] = site;
        points_.push_back(static_cast<std::uint32_t>(step.point));
        runningKeys_.push_back(std::min(step.keyBefore, site == 0 ? step.keyBefore : runningKeys_.back()));
        return {};
    }
    Status finish(float) override { return {}; }

private:
    std::uint64_t count_ = 0;
    std::uint64_t blockStart_ = 0;
    std::size_t blockSites_ = 0;
    ReservedArray<std::array<std::uint32_t, 3>> sites_;
    ReservedArray<std::uint32_t> destroyers_;
    ReservedArray<float> errors_;
    std::vector<std::uint32_t> points_;
    std::vector<float> runningKeys_;
};

Result<LatticeRefinementResult> refine(const Dataset& dataset, HistorySink& sink)
{
    LatticeRefinementOptions options;
    options.size = dataset.lattice.size;
    options.spacing = dataset.lattice.spacing;
    options.valueExtent = dataset.values.range().extent();
    return visitSampleType(dataset.values.type(), [&]<class T>() {
        return refineLattice(options, LatticeSamples(dataset.values.as<T>()), sink);
    });
}

/// All blocks of `cells` cells an edge, one after another; the sites and tetrahedra of all.
Result<LatticeRefinementResult> refineBlocks(const Dataset& dataset, std::uint32_t cells, MemoryHistory& history)
{
    const auto& size = dataset.lattice.size;
    LatticeBoxOptions options;
    options.latticeSize = size;
    options.metric = latticeMetric({cells + 1, cells + 1, cells + 1}, dataset.lattice.spacing).value();
    options.valueExtent = dataset.values.range().extent();
    LatticeRefiner refiner;
    LatticeRefinementResult sum;
    for (std::uint32_t z = 0; z + 1 < size[2]; z += cells)
        for (std::uint32_t y = 0; y + 1 < size[1]; y += cells)
            for (std::uint32_t x = 0; x + 1 < size[0]; x += cells) {
                options.box.origin = {x, y, z};
                for (std::size_t axis = 0; axis < 3; ++axis)
                    options.box.size[axis] = std::min(cells + 1, size[axis] - options.box.origin[axis]);
                options.centreAtOrigin = ((x + y + z) / cells & 1) == 0;
                history.beginBlock();
                const auto result = visitSampleType(dataset.values.type(), [&]<class T>() {
                    return refiner.refine(options, LatticeSamples(dataset.values.as<T>()), history);
                });
                if (!result)
                    return result;
                sum.sites += result->sites;
                sum.tetrahedra += result->tetrahedra;
            }
    return sum;
}

struct Yardstick {
    double seconds = 0;
    std::size_t cells = 0;
};

/// Of each the first run is not counted: memory that a virtual machine has never touched costs more than the work.
template <class Work> double medianSeconds(int repeats, const Work& work)
{
    std::vector<double> seconds;
    for (int i = 0; i <= repeats; ++i)
        seconds.push_back(work());
    seconds.erase(seconds.begin());
    return median(seconds);
}

Yardstick measureYardstick(std::uint32_t n, int repeats)
{
    Yardstick result;
    result.seconds = medianSeconds(repeats, [&] { return cgalBulkInsertionSeconds(n, result.cells); });
    return result;
}

/// As a whole if `blockCells` is 0.
BenchCase measure(std::uint32_t n, SampleType type, std::uint32_t blockCells, const Yardstick& yardstick, int repeats)
{
    const Dataset dataset = makeSample({"c60", n, type}).value();
    LatticeRefinementResult result;
    BenchCase one;
    one.seconds = medianSeconds(repeats, [&] {
        return secondsOf([&] {
            MemoryHistory history;
            // Blocks have the sites of their common faces twice.
            if (history.reserve(dataset.lattice.pointCount() * (blockCells == 0 ? 4 : 5) / 4).ok())
                result =
                    (blockCells == 0 ? refine(dataset, history) : refineBlocks(dataset, blockCells, history)).value();
        });
    });
    const QString typeName = QString::fromStdString(std::string(sampleTypeName(type)));
    one.name = QString("c60 %1^3 %2 %3to error 0, one thread")
                   .arg(n)
                   .arg(typeName, blockCells == 0 ? QString() : QString("in blocks of %1 ").arg(blockCells));
    one.yardstick = "CGAL EPICK bulk insertion of all points";
    one.yardstickSeconds = yardstick.seconds;
    one.more = {{"sites", qint64(result.sites)},
                {"tetrahedra", qint64(result.tetrahedra)},
                {"microseconds_per_site", 1e6 * one.seconds / result.sites},
                {"yardstick_cells", qint64(yardstick.cells)}};
    std::fprintf(stderr, "%s: %.3f s, %.3f of the yardstick\n", qPrintable(one.name), one.seconds,
                 one.seconds / yardstick.seconds);
    return one;
}

/// A build into a file, in a process of its own whose peak memory the system tells.
BenchCase measureMemory(std::uint32_t n, SampleType type)
{
    const QTemporaryDir folder;
    std::fflush(nullptr);
    BenchCase one;
    one.name =
        QString("c60 %1^3 %2, build into a file").arg(n).arg(QString::fromStdString(std::string(sampleTypeName(type))));
    rusage usage{};
    one.seconds = secondsOf([&] {
        const pid_t child = ::fork();
        if (child == 0) {
            const Dataset dataset = makeSample({"c60", n, type}).value();
            ModelDescription description;
            description.builder = "refinement";
            auto writer = ModelWriter::create(folder.filePath("model.tan").toStdString(), dataset, description);
            ::_exit(writer.ok() && refine(dataset, **writer).ok() ? 0 : 1);
        }
        int status = 1;
        ::wait4(child, &status, 0, &usage);
    });
    const double peak = 1024.0 * static_cast<double>(usage.ru_maxrss);
    std::fprintf(stderr, "%s: %.0f bytes a site at its peak\n", qPrintable(one.name), peak / (double(n) * n * n));
    one.more = {{"peak_bytes", peak}, {"peak_bytes_per_site", peak / (double(n) * n * n)}};
    return one;
}

} // namespace

} // namespace tetra

int main(int argc, char** argv)
{
    const QCoreApplication application(argc, argv);
    QCommandLineParser parser;
    parser.addHelpOption();
    parser.addOption({"json", "Print one JSON object."});
    parser.addOption({"repeats", "Runs of each case; the median is reported.", "N", "5"});
    parser.addOption({"sizes", "Points along an axis, separated by commas.", "LIST", "32,64,128"});
    parser.addOption({"types", "Sample types: uint8 needs half of the points, uint16 nine tenths, float all.", "LIST",
                      "uint16,float"});
    parser.addOption(
        {"blocks", "Cells along an edge of a block, separated by commas; 0: the whole.", "LIST", "0,16,32"});
    parser.process(application);
    const int repeats = std::max(1, parser.value("repeats").toInt());
    std::vector<tetra::BenchCase> cases;
    const QStringList sizes = parser.value("sizes").split(',');
    // Peak memory first: a process forked from a large one would inherit its size.
    std::vector<tetra::SampleType> types;
    for (const tetra::SampleType type :
         {tetra::SampleType::UInt8, tetra::SampleType::UInt16, tetra::SampleType::Float32})
        if (parser.value("types").split(',').contains(QString::fromStdString(std::string(sampleTypeName(type)))))
            types.push_back(type);
    for (const tetra::SampleType type : types)
        cases.push_back(tetra::measureMemory(sizes.last().toUInt(), type));
    for (const QString& size : sizes) {
        const std::uint32_t n = size.toUInt();
        const tetra::Yardstick yardstick = tetra::measureYardstick(n, repeats);
        for (const tetra::SampleType type : types)
            for (const QString& cells : parser.value("blocks").split(','))
                if (cells == "0" || n >= 2 * cells.toUInt())
                    cases.push_back(tetra::measure(n, type, cells.toUInt(), yardstick, repeats));
    }
    tetra::printReport("refinement", cases, parser.isSet("json"));
    return 0;
}
