// SPDX-License-Identifier: GPL-3.0-or-later
// Building the synthetic C60 and a curvilinear grid in blocks, file and all, on two threads against one (R10, B6, C7),
// in turn.

#include "tests/bench/bench_report.h"

#include "plugins/host/model_building.h"
#include "plugins/samples/samples.h"

#include <tbb/global_control.h>

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QTemporaryDir>

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

namespace tetra {
namespace {

constexpr std::array<int, 2> threadCounts = {1, 2};

struct Built {
    std::array<std::vector<double>, threadCounts.size()> seconds; ///< of each run, for each number of threads
    std::uint64_t fileBytes = 0;
};

Result<Built> buildInTurn(PluginHost& host, const Dataset& dataset, const QString& block, int repeats)
{
    const QTemporaryDir folder;
    const std::filesystem::path path = folder.filePath("model.tan").toStdString();
    Built built;
    // The first round is not counted: memory that a virtual machine has never touched costs more than the work.
    for (int run = 0; run <= repeats; ++run)
        for (std::size_t i = 0; i < threadCounts.size(); ++i) {
            const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                            static_cast<std::size_t>(threadCounts[i]));
            const auto model = buildModel(host, dataset, "refinement", {{"block", block.toStdString()}}, path);
            if (!model)
                return model.error();
            if (run > 0)
                built.seconds[i].push_back(model->seconds);
            built.fileBytes = model->fileBytes;
        }
    return built;
}

} // namespace
} // namespace tetra

int main(int argc, char** argv)
{
    using namespace tetra;
    const QCoreApplication application(argc, argv);
    QCommandLineParser parser;
    parser.addHelpOption();
    parser.addOption({"json", "Print one JSON object."});
    parser.addOption({"size", "Points along an axis.", "N", "128"});
    parser.addOption({"block", "Cells along an edge of a block.", "N", "16"});
    parser.addOption({"repeats", "Runs of each case; the median is reported.", "N", "3"});
    parser.process(application);
    PluginHost host({.folders = {TAN_BINARY_DIR "/lib/tan/plugins"}});
    const QString size = parser.value("size"), block = parser.value("block");
    std::vector<BenchCase> cases;
    for (const auto& [sample, type] :
         {std::pair("c60", SampleType::UInt16), std::pair("o-grid", SampleType::Float32)}) {
        const Dataset dataset = makeSample({sample, size.toUInt(), type}).value();
        const auto built = buildInTurn(host, dataset, block, std::max(1, parser.value("repeats").toInt()));
        if (!built) {
            std::fprintf(stderr, "%s\n", built.error().text().c_str());
            return 4;
        }
        BenchCase one;
        one.name = QString("%1 %2^3 %3 in blocks of %4 into a file, 2 threads")
                       .arg(sample, size, QString::fromStdString(std::string(sampleTypeName(type))), block);
        one.seconds = median(built->seconds[1]);
        one.more["file_bytes"] = qint64(built->fileBytes);
        addCompared(one, {{"the same on one thread", median(built->seconds[0])}}, cases);
    }
    printReport("threads", cases, parser.isSet("json"));
    return 0;
}
