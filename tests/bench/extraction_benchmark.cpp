// SPDX-License-Identifier: GPL-3.0-or-later
// Prefix extraction from the model of the synthetic C60, one thread, from a warm map: how many tetrahedra of the
// history are scanned a second, and how that compares with copying as many bytes in the same run. Then what a viewer
// waits for: opening the file and extracting a first mesh, with the file's pages in memory and without, and what stays
// resident.

#include "tests/bench/bench_report.h"
#include "tests/bench/focus_cases.h"
#include "tests/bench/query_cases.h"

#include "core/base/memory.h"
#include "core/history/model_writer.h"
#include "core/history/query/region_refiner.h"
#include "core/refine/lattice/lattice_refinement.h"
#include "plugins/samples/samples.h"

#include <tan/query.h>

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QTemporaryDir>

#include <algorithm>
#include <cstdio>
#include <cstring>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace tetra {

namespace {

QString typeName(SampleType type)
{
    return QString::fromStdString(std::string(sampleTypeName(type)));
}

/// Builds the model in a process of its own, so that this one's memory is that of a viewer.
bool buildModel(const std::filesystem::path& path, std::uint32_t size, SampleType type)
{
    std::fflush(nullptr);
    const pid_t child = ::fork();
    if (child == 0) {
        const Dataset dataset = makeSample({"c60", size, type}).value();
        auto writer = ModelWriter::create(path, dataset, {});
        LatticeRefinementOptions options;
        options.size = dataset.lattice.size;
        options.spacing = dataset.lattice.spacing;
        options.valueExtent = dataset.values.range().extent();
        const bool built = writer.ok() && visitSampleType(type, [&]<class T>() {
                               return refineLattice(options, LatticeSamples(dataset.values.as<T>()), **writer).ok();
                           });
        ::_exit(built ? 0 : 1);
    }
    int status = 1;
    ::waitpid(child, &status, 0);
    return status == 0;
}

/// What extraction reads of the file and writes to the mesh.
struct Traffic {
    double read = 0;
    double written = 0;
};

Traffic trafficOf(const Model& model, std::uint32_t sites, const TetrahedralMesh& mesh)
{
    const double perTetrahedron = sizeof(model.otherSites()[0]) + sizeof(model.destroyers()[0]);
    const double perSite = sizeof(model.points()[0]) + sizeof(model.starOffsets()[0]) +
                           static_cast<double>(sampleSize(model.description().sampleType));
    return {static_cast<double>(model.starOffsets()[sites]) * perTetrahedron + sites * perSite,
            static_cast<double>(mesh.tetrahedra.size() * sizeof(mesh.tetrahedra[0]) +
                                mesh.positions.size() * sizeof(mesh.positions[0]) +
                                mesh.values.size() * sizeof(mesh.values[0]))};
}

BenchCase measureExtraction(const Model& model, const QString& name, double error, int repeats)
{
    const std::uint32_t sites = meshSizeAt(model, {error}).sites;
    TetrahedralMesh mesh = extractPrefix(model, sites).value(); // warms the map and the buffers
    const Traffic traffic = trafficOf(model, sites, mesh);
    const auto half = static_cast<std::size_t>((traffic.read + traffic.written) / 2);
    Buffer<std::byte> target(half);
    const Buffer<std::byte> source(half, std::byte{1});
    std::memcpy(target.data(), source.data(), half);
    std::vector<double> extracting;
    std::vector<double> copying;
    for (int i = 0; i < repeats; ++i) {
        extracting.push_back(
            secondsOf([&] { mesh = std::move(extractPrefix(model, sites, {}, std::move(mesh)).value()); }));
        copying.push_back(secondsOf([&] { std::memcpy(target.data(), source.data(), half); }));
    }
    BenchCase one;
    one.name = name + QString(", extraction at %1 %").arg(error);
    one.seconds = median(extracting);
    one.yardstick = "memcpy that reads and writes as many bytes";
    one.yardstickSeconds = median(copying);
    const auto scanned = static_cast<double>(model.starOffsets()[sites]);
    one.more = {{"sites", qint64(sites)},
                {"tetrahedra", qint64(mesh.tetrahedra.size())},
                {"scanned", scanned},
                {"scanned_per_second", scanned / one.seconds},
                {"bytes_read", traffic.read},
                {"bytes_written", traffic.written},
                {"share_of_copy_bandwidth", one.yardstickSeconds / one.seconds}};
    return one;
}

/// Asks the system to forget the file's pages, as if it had never been read.
void dropFromMemory(const std::filesystem::path& path)
{
    const int descriptor = ::open(path.c_str(), O_RDONLY);
    ::fsync(descriptor);
    ::posix_fadvise(descriptor, 0, 0, POSIX_FADV_DONTNEED);
    ::close(descriptor);
}

/// Opening, and the best mesh of at most so many tetrahedra.
BenchCase measureFirstMesh(const std::filesystem::path& path, const QString& name, std::uint64_t tetrahedra, bool cold,
                           int repeats)
{
    std::vector<double> seconds;
    std::vector<double> resident;
    BenchCase one;
    for (int i = 0; i < repeats; ++i) {
        if (cold)
            dropFromMemory(path);
        const auto before = static_cast<double>(residentBytes());
        std::shared_ptr<const Model> model;
        std::shared_ptr<const ExtractedMesh> mesh;
        seconds.push_back(secondsOf([&] {
            model = Model::open(path).value();
            MeshQuery query;
            query.budget = tetrahedra;
            mesh = MeshExtractor(model).extract(query).value();
        }));
        resident.push_back(static_cast<double>(residentBytes()) - before);
        one.more = {{"tetrahedra", qint64(mesh->mesh.tetrahedra.size())}, {"file_bytes", double(model->fileSize())}};
    }
    one.name =
        name + QString(", opening and a first mesh of %1 tetrahedra, %2").arg(tetrahedra).arg(cold ? "cold" : "warm");
    one.seconds = median(seconds);
    one.yardstick = "one second";
    one.yardstickSeconds = 1;
    one.more["resident_bytes"] = median(resident);
    return one;
}

std::vector<BenchCase> measureModel(const std::filesystem::path& path, const QString& name, int repeats)
{
    std::vector<BenchCase> cases;
    // Resident memory first, before buffers of this process could be used again.
    for (const bool cold : {true, false})
        for (const std::uint64_t tetrahedra : {100000, 1000000})
            cases.push_back(measureFirstMesh(path, name, tetrahedra, cold, repeats));
    const std::shared_ptr<const Model> model = Model::open(path).value();
    for (const double error : {1.0, 0.0})
        cases.push_back(measureExtraction(*model, name, error, repeats));
    for (const auto& some : {focusBoxCases(model, name, repeats), fieldCases(model, name, repeats)})
        cases.insert(cases.end(), some.begin(), some.end());
    for (BenchCase& one : RegionRefiner::fits(*model) ? measureFocus(*model, name, repeats) : std::vector<BenchCase>())
        cases.push_back(std::move(one));
    return cases;
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
    parser.addOption({"repeats", "Runs of each case, at least 5; the median is reported.", "N", "9"});
    parser.addOption({"size", "Points along an axis.", "N", "128"});
    parser.addOption({"model", "Measure this model in place of those of C60; may be repeated.", "FILE"});
    parser.process(application);
    const int repeats = std::max(5, parser.value("repeats").toInt());
    const QTemporaryDir folder;
    std::vector<BenchCase> cases;
    for (const QString& file : parser.values("model"))
        for (BenchCase& one : measureModel(file.toStdString(), file, repeats))
            cases.push_back(std::move(one));
    for (const SampleType type : {SampleType::UInt8, SampleType::Float32}) {
        if (parser.isSet("model"))
            break;
        const std::filesystem::path path = folder.filePath("model.tan").toStdString();
        if (!buildModel(path, parser.value("size").toUInt(), type)) {
            std::fprintf(stderr, "Building the model failed.\n");
            return 4;
        }
        const QString name = QString("c60 %1^3 %2").arg(parser.value("size"), typeName(type));
        for (BenchCase& one : measureModel(path, name, repeats))
            cases.push_back(std::move(one));
    }
    printReport("extraction", cases, parser.isSet("json"));
    return 0;
}
