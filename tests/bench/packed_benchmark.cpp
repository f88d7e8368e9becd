// SPDX-License-Identifier: GPL-3.0-or-later
// Packed models: their bytes by part, and how long packing, replaying and unpacking take.

#include "tests/bench/bench_report.h"

#include "plugins/samples/samples.h"

#include <tan/build.h>
#include <tan/packed.h>

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QTemporaryDir>

#include <cstdio>
#include <fstream>

namespace tetra {

namespace {

/// A file of bare samples, as PATH:NXxNYxNZ:TYPE; or the synthetic C60, as c60:N:TYPE.
Result<Dataset> datasetOf(const QString& text)
{
    const QStringList words = text.split(':');
    const auto wrong = [&] {
        return Error{ErrorKind::WrongUsage,
                     Message(text.toStdString() + " is neither PATH:NXxNYxNZ:TYPE nor c60:N:TYPE")};
    };
    if (words.size() != 3)
        return wrong();
    std::optional<SampleType> type;
    for (int number = 0; number < 8; ++number)
        if (words[2].toStdString() == sampleTypeName(SampleType(number)))
            type = SampleType(number);
    if (!type)
        return wrong();
    if (words[0] == "c60")
        return makeSample({"c60", words[1].toUInt(), *type});
    const QStringList sizes = words[1].split('x');
    if (sizes.size() != 3)
        return wrong();
    Lattice lattice;
    lattice.size = {sizes[0].toUInt(), sizes[1].toUInt(), sizes[2].toUInt()};
    auto samples = allocateSamples(*type, lattice.pointCount());
    if (!samples)
        return samples.error();
    std::ifstream file(words[0].toStdString(), std::ios::binary);
    if (!file.read(reinterpret_cast<char*>(samples->get()),
                   static_cast<std::streamsize>(lattice.pointCount() * sampleSize(*type))))
        return wrong();
    return latticeDataset(lattice, ScalarField(*type, lattice.pointCount(), *samples), words[0].toStdString());
}

Result<BenchCase> measurePacking(const QString& text, const Refinement& method)
{
    const auto dataset = datasetOf(text);
    if (!dataset)
        return dataset.error();
    const QTemporaryDir folder;
    const auto path = [&](const char* name) { return std::filesystem::path(folder.filePath(name).toStdString()); };
    Result<BuildReport> built = BuildReport();
    const double building = secondsOf([&] { built = buildModel(*dataset, path("model.tan"), method); });
    if (!built)
        return built.error();
    const auto model = Model::open(path("model.tan"));
    if (!model)
        return model.error();
    Result<PackReport> report = PackReport();
    const double packing = secondsOf([&] { report = packModel(**model, path("packed.tan")); });
    if (!report)
        return report.error();
    const auto packed = PackedModel::open(path("packed.tan"));
    if (!packed)
        return packed.error();
    Status made;
    const double prefix =
        secondsOf([&] { made = unpackPrefix(**packed, (*packed)->levels().size() - 1, path("prefix.tan")); });
    if (!made)
        return made.error();
    Result<UnpackReport> unpacked = UnpackReport();
    const double unpacking = secondsOf([&] { unpacked = unpackModel(**packed, path("again.tan")); });
    if (!unpacked)
        return unpacked.error();
    const double sites = (*model)->siteCount();
    const auto raw = static_cast<double>(dataset->pointCount() * sampleSize(dataset->values.type()));
    BenchCase one;
    one.name = text.section('/', -1);
    one.seconds = unpacking;
    one.yardstick = "building";
    one.yardstickSeconds = building;
    one.more = {{"sites", sites},
                {"method", int(report->method)},
                {"levels", int((*packed)->levels().size())},
                {"file_bytes", double(report->fileBytes)},
                {"of_raw", double(report->fileBytes) / raw},
                {"of_model", double(report->fileBytes) / double((*model)->fileSize())},
                {"position_bytes_per_site", double(report->positions) / sites},
                {"value_bytes_per_site", double(report->values) / sites},
                {"accuracy_bytes_per_site", double(report->accuracy) / sites},
                {"own_error_bytes_per_site", double(report->ownErrors) / sites},
                {"other_bytes_per_site", double(report->other) / sites},
                {"packing_over_building", packing / building},
                {"prefix_sites_per_second", sites / prefix},
                {"unpacked_sites_per_second", sites / unpacking}};
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
    parser.addOption({"error", "Where the build stops, % of the value range.", "PERCENT", "0"});
    parser.addOption({"block", "Cells along an edge of a block; 0: the whole.", "N", "0"});
    parser.addPositionalArgument("DATA", "PATH:NXxNYxNZ:TYPE of a file of bare samples, or c60:N:TYPE.", "[DATA...]");
    parser.process(application);
    QStringList data = parser.positionalArguments();
    if (data.isEmpty())
        data = {"c60:32:uint8", "c60:64:uint16", "c60:64:float"};
    tetra::Refinement method;
    method.error = parser.value("error").toDouble();
    method.block = parser.value("block").toUInt();
    std::vector<tetra::BenchCase> cases;
    for (const QString& text : data) {
        const auto measured = tetra::measurePacking(text, method);
        if (!measured) {
            std::fprintf(stderr, "%s\n", measured.error().text().c_str());
            return 1;
        }
        cases.push_back(*measured);
    }
    tetra::printReport("packed", cases, parser.isSet("json"));
    return 0;
}
