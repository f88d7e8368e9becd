// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/model_samples.h"

#include "core/base/guarded.h"
#include "core/base/progress.h"
#include "core/history/whole_elsewhere.h"
#include "plugins/host/dataset_opening.h"
#include "plugins/host/import_options.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <utility>
#include <vector>

namespace tetra {
namespace {

namespace fs = std::filesystem;

constexpr MarkedText reading = Message::marked("Reading the data");

/// The samples of a model that has a site for each.
template <class Value> Result<Dataset> fromSites(const Model& model, const Progress& progress)
{
    const auto* const ofSites = reinterpret_cast<const Value*>(model.values().data());
    std::vector<Value> samples(model.siteCount());
    constexpr std::size_t atOnce = 1 << 20;
    for (std::size_t site = 0; site < samples.size(); ++site) {
        if (site % atOnce == 0) {
            progress.report(static_cast<double>(site) / static_cast<double>(samples.size()), reading);
            if (progress.cancelled())
                return cancelledError(reading);
        }
        if (const std::uint32_t point = model.points()[site]; point < samples.size())
            samples[point] = ofSites[site];
    }
    if (const Status intact = model.checkIntact(); !intact)
        return intact.error();
    return latticeDataset(model.description().lattice, ScalarField::of(std::move(samples)),
                          model.description().sourceName);
}

Error notAtHand(const Model& model, const Message& why)
{
    return {ErrorKind::BadInput,
            Message::say("The data of '%1' cannot be shown: %2 Put the file from which the model was built, '%3', "
                         "beside the model.",
                         model.path().string(), why, model.description().sourceName)};
}

/// The data file beside a model.
Result<Dataset> fromFile(const Model& model, PluginHost& host, const Progress& progress)
{
    const ModelDescription& about = model.description();
    const fs::path file = model.path().parent_path() / fs::path(about.sourceName).filename();
    std::error_code problem;
    if (about.sourceName.empty() || model.elsewhere() != nullptr || !fs::exists(file, problem))
        return notAtHand(model, Message::say("the model holds %1 of the %2 samples.", model.siteCount(),
                                             about.lattice.pointCount()));
    const auto reader = chooseReader(host, file, importReaderOf(about));
    if (!reader)
        return reader.error();
    const auto options = importOf(about, reader->plugin->parameters());
    if (!options)
        return options.error();
    auto dataset = openDataset(host, file, *options, progress);
    if (!dataset)
        return dataset;
    if (dataset->source.hash != about.sourceHash || dataset->lattice.size != about.lattice.size)
        return notAtHand(model, Message::say("the file of that name beside it contains other values."));
    dataset->lattice = about.lattice; // which may have been corrected since
    return dataset;
}

} // namespace

Result<std::shared_ptr<const Dataset>> samplesOf(const Model& model, PluginHost& host, const Progress& progress)
{
    return guarded(Message::marked("Not enough memory to show the data beside the mesh. Close other programs."),
                   [&]() -> Result<std::shared_ptr<const Dataset>> {
                       const ModelDescription& about = model.description();
                       if (about.domain != DomainClass::RegularLattice)
                           return Error{ErrorKind::WrongUsage,
                                        Message::say("Only the samples of a lattice can be shown beside the mesh, and "
                                                     "these data are %1.",
                                                     domainClassText(about.domain))};
                       const bool whole =
                           model.elsewhere() == nullptr && model.siteCount() == about.lattice.pointCount();
                       auto dataset =
                           whole ? visitSampleType(about.sampleType,
                                                   [&]<class Value> { return fromSites<Value>(model, progress); })
                                 : fromFile(model, host, progress);
                       if (!dataset)
                           return dataset.error();
                       return std::make_shared<const Dataset>(*std::move(dataset));
                   });
}

} // namespace tetra
