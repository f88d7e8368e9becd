// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/model_building.h"

#include "core/base/memory.h"
#include "core/build/model_build.h"
#include "plugins/host/interrupted_build.h"
#include "plugins/host/output_check.h"
#include "plugins/host/parameter_values.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <iterator>

namespace tetra {
namespace {

Result<Provided<Builder>> named(PluginHost& host, const Dataset& dataset, const std::string& id)
{
    auto builder = host.builder(id);
    if (!builder)
        return builder;
    if (const Acceptance acceptance = builder->plugin->accepts(dataset); !(acceptance.score > 0))
        return Error{ErrorKind::BadInput, Message::say("The builder '%1' does not accept '%2': %3", id,
                                                       dataset.source.name, acceptance.reason)};
    return builder;
}

bool keeps(const BuildControl& control)
{
    return control.keepWhenCancelled != nullptr && *control.keepWhenCancelled;
}

/// How a build ended that was not in vain.
struct EndedBuild {
    BuildReport report;
    bool stoppedEarly = false;
};

Result<EndedBuild> keepWhatIsFinished(ModelWriter& writer)
{
    if (const Status finished = writer.finishEarly(); !finished)
        return finished.error();
    BuildReport report;
    report.sites = writer.siteCount();
    report.tetrahedra = writer.tetrahedronCount();
    return EndedBuild{report, true};
}

Result<EndedBuild> buildInto(const Provided<Builder>& provided, const Dataset& dataset, const ParameterValues& values,
                             const std::filesystem::path& output, const Progress& progress, const BuildControl& control)
{
    const Builder& builder = *provided.plugin;
    ModelDescription description;
    description.builder = provided.id;
    description.parameters = usedTexts(builder.parameters(), values, dataset);
    std::ranges::move(importTexts(control.imported), std::back_inserter(description.parameters));
    constexpr double takenEnd = 0.02; // how far it is then
    const auto taken = builder.taken(dataset, values, progress.part(0, takenEnd));
    if (!taken)
        return taken.error();
    const auto file = ModelFileTarget::open(output, *taken, description, control.resume);
    if (!file)
        return file.error();
    ModelWriter& writer = (*file)->writer();
    const auto watch = control.live != nullptr ? control.live->watch(writer, *taken, description) : nullptr;
    BuildTarget target = (*file)->target(watch ? *watch : writer);
    if (control.resume)
        leaveNote(target.workFolder, buildNote(dataset, provided, values));
    target.keepWhenCancelled = control.keepWhenCancelled;
    if (control.live != nullptr)
        target.preview = [live = control.live](const auto& hand) { live->show(hand); };
    auto report = builder.build(*taken, values, target, progress.part(takenEnd, 1));
    if (!report && control.resume)
        (*file)->keepWork();
    if (!report && report.error().kind == ErrorKind::Cancelled && keeps(control) && writer.siteCount() > 0)
        return keepWhatIsFinished(writer);
    if (!report) {
        // What a builder makes of values that change under it may fail in any way.
        if (const Status intact = dataset.checkIntact(); !intact && report.error().kind != ErrorKind::Cancelled)
            return intact.error();
        return report.error();
    }
    if (writer.siteCount() > 0) { // what the file holds, whatever the builder says
        report->sites = writer.siteCount();
        report->tetrahedra = writer.tetrahedronCount();
    }
    const bool stoppedEarly = progress.cancelled() && keeps(control);
    if (stoppedEarly && control.resume)
        (*file)->keepWork();
    return EndedBuild{*report, stoppedEarly};
}

} // namespace

Result<Provided<Builder>> chooseBuilder(PluginHost& host, const Dataset& dataset, const std::optional<std::string>& id)
{
    if (id)
        return named(host, dataset, *id);
    Provided<Builder> best;
    double bestScore = 0;
    Message reasons;
    for (auto& builder : host.builders()) {
        const Acceptance acceptance = builder.plugin->accepts(dataset);
        reasons = Message::say("%1\n%2: %3", reasons, builder.id, acceptance.reason);
        if (acceptance.score > bestScore) {
            bestScore = acceptance.score;
            best = std::move(builder);
        }
    }
    if (best.plugin == nullptr)
        return Error{ErrorKind::BadInput, Message::say("No builder accepts '%1'.%2%3", dataset.source.name, reasons,
                                                       host.explainMissing(PluginKind::Builder))};
    return best;
}

Result<ModelBuild> buildModel(PluginHost& host, const Dataset& dataset, const std::optional<std::string>& builderId,
                              const ParameterValues& values, const std::filesystem::path& output,
                              const Progress& progress, const BuildControl& control)
{
    const auto builder = chooseBuilder(host, dataset, builderId);
    if (!builder)
        return builder.error();
    if (const Status known =
            checkParameterValues(Message::say("builder '%1'", builder->id), builder->plugin->parameters(), values);
        !known)
        return known.error();
    if (const Status used = checkOfUse(builder->plugin->parameters(), values, dataset); !used)
        return used.error();
    if (const Status safe = checkOutput(output, std::array{dataset.source.path}); !safe)
        return safe.error();
    if (const Status safe = checkModelOutput(output); !safe)
        return safe.error();

    if (progress.cancelled())
        return cancelledError(Message::marked("The build"));
    if (const Status intact = dataset.checkIntact(); !intact)
        return intact.error();
    const auto start = std::chrono::steady_clock::now();
    const auto ended = buildInto(*builder, dataset, values, output, progress, control);
    if (!ended)
        return ended.error();
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    std::error_code problem;
    const auto size = std::filesystem::file_size(output, problem);
    return ModelBuild{builder->id,         ended->report,      elapsed.count(),
                      peakResidentBytes(), problem ? 0 : size, ended->stoppedEarly};
}

} // namespace tetra
