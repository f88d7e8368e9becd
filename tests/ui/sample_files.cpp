// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/sample_files.h"

#include "core/data/value_scale.h"
#include "core/history/model_writer.h"
#include "core/history/value_statistics.h"
#include "plugins/samples/samples.h"

#include <QtGlobal>

#include <fstream>

namespace tetra {
namespace {

/// Tests cannot go on without their samples.
template <class Value> Value require(Result<Value> result)
{
    if (!result)
        qFatal("%s", result.error().text().c_str());
    return *std::move(result);
}

} // namespace

std::unique_ptr<PluginHost> hostOfThisBuild()
{
    PluginHostOptions options;
    options.folders = {TAN_BINARY_DIR "/lib/tan/plugins"};
    return std::make_unique<PluginHost>(options);
}

Dataset sampleDataset(std::uint32_t size)
{
    SampleRequest request;
    request.size = size;
    request.type = SampleType::UInt8;
    return require(makeSample(request));
}

std::filesystem::path writeNrrd(const Dataset& dataset, const std::filesystem::path& folder, const std::string& name)
{
    const std::filesystem::path path = folder / name;
    std::ofstream file(path, std::ios::binary);
    const auto& size = dataset.lattice.size;
    file << "NRRD0004\ntype: " << sampleTypeName(dataset.values.type()) << "\ndimension: 3\nsizes: " << size[0] << ' '
         << size[1] << ' ' << size[2] << "\nspacings: 1 1 1\nendian: little\nencoding: raw\n\n";
    const auto bytes = dataset.values.bytes();
    file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    return path;
}

namespace {

std::filesystem::path buildRefined(PluginHost& host, const Dataset& dataset, const std::filesystem::path& path,
                                   double errorPercent, ModelDescription description)
{
    const auto builder = require(host.builder("refinement"));
    description.builder = builder.id;
    const auto writer = require(ModelWriter::create(path, dataset, description));
    BuildTarget target{*writer};
    require(builder.plugin->build(dataset, {{"error", errorPercent}, {"error-in", std::string("grid")}}, target, {}));
    return path;
}

} // namespace

std::filesystem::path buildSampleModel(PluginHost& host, const Dataset& dataset, const std::filesystem::path& folder,
                                       double errorPercent)
{
    return buildRefined(host, dataset, folder / "c60.tan", errorPercent, {});
}

std::filesystem::path buildLogarithmModel(PluginHost& host, std::uint32_t size, const std::filesystem::path& folder)
{
    const ValueScale scale{.logarithmic = true, .from = 1};
    ModelDescription description;
    description.parameters = {{std::string(scaleParameter), scaleText(scale)}};
    return buildRefined(host, require(scaled(sampleDataset(size), scale)), folder / "c60-log.tan", 0, description);
}

std::filesystem::path buildMapModel(PluginHost& host, std::uint32_t size, const std::filesystem::path& folder)
{
    Dataset dataset = sampleDataset(size);
    dataset.source.name = "c60.map";
    ModelDescription description;
    description.parameters = statisticsTexts(dataset);
    return buildRefined(host, dataset, folder / "c60-map.tan", 0, description);
}

} // namespace tetra
