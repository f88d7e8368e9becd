// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reproduction/experiment.h"

#include "app/reproduction/subsampling.h"
#include "plugins/host/dataset_opening.h"

namespace tetra {

namespace {

constexpr const char* c60Caveat =
    "Another electron density of C60 than the paper's, which was not found: the sizes can be compared, "
    "the figures only roughly.";

/// Both ways to choose the next point (S4): ours and the paper's.
std::vector<Experiment> curvilinear(const Experiment& common)
{
    Experiment ours = common;
    ours.builderValues["error-in"] = std::string("grid"); // as in the paper
    ours.variant = "normalised";
    Experiment paper = ours;
    paper.variant = "as in the paper";
    paper.builderValues["selection"] = std::string("paper");
    return {ours, paper};
}

} // namespace

std::vector<Experiment> experimentsFor(const PaperModel& model)
{
    const ParameterValues block = {
        {"block", model.blockEdge == 0 ? std::string("none") : std::to_string(model.blockEdge)}};
    if (model.dataset == "BluntFin")
        return curvilinear({.variant = {},
                            .file = "bluntfin/bluntfinxyz.bin",
                            .readerValues = {{"array", std::string("density")}},
                            .builderValues = block,
                            .caveat = {}});
    if (model.dataset == "Post")
        return curvilinear({.variant = {},
                            .file = "post/postxyz.bin",
                            .readerValues = {{"array", std::string("pressure")}},
                            .builderValues = block,
                            .caveat = "The paper does not say which scalar it took; here it is the pressure."});
    if (model.dataset == "SOD")
        return {{.variant = {},
                 .file = "sod/sod_sub_32x32x32_uint8.nhdr",
                 .readerValues = {},
                 .builderValues = block,
                 .caveat =
                     "The paper does not say which 32 x 32 x 32 box it took; here it begins at sample (32, 32, 32)."}};
    if (model.dataset == "BuckyBall" && model.size[0] == 32)
        return {{.variant = {},
                 .file = "buckyball/bucky_32x32x32_uint8.nhdr",
                 .readerValues = {},
                 .builderValues = block,
                 .caveat = {}}};
    if (model.dataset == "BuckyBall" && (model.size[0] == 64 || model.size[0] == 128))
        return {{.variant = {},
                 .file = "buckyball/c60large_128x128x128_uint8.nhdr",
                 .readerValues = {},
                 .step = 128 / model.size[0],
                 .builderValues = block,
                 .caveat = c60Caveat}};
    return {};
}

Result<std::optional<Dataset>> openExperiment(PluginHost& host, const Experiment& experiment,
                                              const std::filesystem::path& data, const Progress& progress)
{
    std::error_code problem;
    const std::filesystem::path path = data / experiment.file;
    if (!std::filesystem::exists(path, problem))
        return std::optional<Dataset>();
    auto dataset = openDataset(host, path, {.values = experiment.readerValues}, progress);
    if (!dataset)
        return dataset.error();
    if (experiment.step == 1)
        return std::optional(*std::move(dataset));
    auto part = subsampled(*dataset, experiment.step);
    if (!part)
        return part.error();
    return std::optional(*std::move(part));
}

} // namespace tetra
