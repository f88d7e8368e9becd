// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/model_building.h"

#include "core/base/file_writer.h"
#include "core/base/mapped_file.h"
#include "core/base/memory.h"
#include "core/build/model_build.h"
#include "core/history/format.h"
#include "core/history/value_statistics.h"
#include "plugins/host/interrupted_build.h"
#include "plugins/host/output_check.h"
#include "plugins/host/parameter_values.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <fstream>
#include <optional>

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
    std::filesystem::path model;
};

/// In the work folder of a build that can be resumed: the checksum of the model that it has kept under its own name.
constexpr const char* keptFile = "kept";

/// Of a model's file (FORMAT.md); nothing of anything shorter.
std::optional<format::Header> headerOf(const std::filesystem::path& model)
{
    format::Header header;
    std::ifstream file(model, std::ios::binary);
    return file.read(reinterpret_cast<char*>(&header), sizeof header) ? std::optional(header) : std::nullopt;
}

std::string checksumText(const std::filesystem::path& model)
{
    const auto header = headerOf(model);
    return header ? std::to_string(header->checksum) : std::string();
}

/// Of the finest mesh, in percent of the value range.
double errorOf(const std::filesystem::path& model)
{
    const auto header = headerOf(model);
    const double extent = header ? header->valueRange[1] - header->valueRange[0] : 0;
    return extent > 0 ? 100 * header->finalKey / extent : 0;
}

/// Of a small file of our own; nothing if it is not there.
std::string contentOf(const std::filesystem::path& path)
{
    constexpr std::size_t most = 64;
    const auto text = wholeText(path, most);
    return text ? *text : std::string();
}

/// That name, or the next one with a number that no file has.
std::filesystem::path freePlace(const std::filesystem::path& output, double error)
{
    const std::filesystem::path real = behindLinks(output); // where the file is made
    const std::filesystem::path first = real.parent_path() / keptName(real, error);
    std::filesystem::path place = first;
    std::error_code unknown;
    for (int number = 2; std::filesystem::exists(std::filesystem::symlink_status(place, unknown)); ++number)
        place.replace_filename(first.stem().string() + "-" + std::to_string(number) + first.extension().string());
    return place;
}

Result<EndedBuild> keepWhatIsFinished(ModelWriter& writer)
{
    if (const Status finished = writer.finishEarly(); !finished)
        return finished.error();
    BuildReport report;
    report.sites = writer.siteCount();
    report.tetrahedra = writer.tetrahedronCount();
    return EndedBuild{report, true, {}};
}

/// Gives what is finished its name: one of its own if it is not whole and a finished model has the one that was asked
/// for. In a build that can be resumed a note lets the next part replace what this one has kept.
Result<EndedBuild> placed(const ModelFileTarget& file, EndedBuild ended, const std::filesystem::path& output,
                          const BuildTarget& target)
{
    const bool isBeside = ended.stoppedEarly && keepsBeside(output);
    ended.model = isBeside ? freePlace(output, errorOf(file.finished())) : output;
    const std::string kept = checksumText(file.finished());
    if (const Status named = file.place(ended.model); !named)
        return named.error();
    if (ended.stoppedEarly && target.resume && !isBeside)
        std::ofstream(target.workFolder / keptFile, std::ios::binary) << kept;
    return ended;
}

Result<EndedBuild> buildInto(const Provided<Builder>& provided, const Dataset& dataset, const ParameterValues& given,
                             const std::filesystem::path& output, const Progress& progress, const BuildControl& control)
{
    const Builder& builder = *provided.plugin;
    const ParameterValues values = builder.settled(dataset, given);
    ModelDescription description;
    description.builder = provided.id;
    description.parameters = usedTexts(builder.parameters(), values, dataset);
    std::ranges::move(importTexts(control.imported), std::back_inserter(description.parameters));
    std::ranges::move(statisticsTexts(dataset), std::back_inserter(description.parameters));
    constexpr double takenEnd = 0.02; // how far it is then
    const auto taken = builder.taken(dataset, values, progress.part(0, takenEnd));
    if (!taken)
        return taken.error();
    const auto file =
        ModelFileTarget::open(output, *taken, description, control.resume, ModelFileTarget::Finished::Later);
    if (!file)
        return file.error();
    ModelWriter& writer = (*file)->writer();
    const auto watch = control.live != nullptr ? control.live->watch(writer, *taken, description) : nullptr;
    BuildTarget target = (*file)->target(watch ? *watch : writer);
    if (control.resume)
        leaveNote(target.workFolder, buildNote(dataset, provided, given));
    target.keepWhenCancelled = control.keepWhenCancelled;
    if (control.partsIn)
        target.part = BuildPart{.folder = *control.partsIn, .merges = true};
    if (control.live != nullptr)
        target.preview = [live = control.live](const auto& hand) { live->show(hand); };
    auto report = builder.build(*taken, values, target, progress.part(takenEnd, 1));
    if (!report && control.resume)
        (*file)->keepWork();
    if (!report && report.error().kind == ErrorKind::Cancelled && keeps(control) && writer.siteCount() > 0) {
        const auto kept = keepWhatIsFinished(writer);
        return kept ? placed(**file, *kept, output, target) : kept;
    }
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
    // Who is asked to stop in the last moments has often finished all the same.
    const bool stoppedEarly = keeps(control) && report->stoppedEarly.value_or(progress.cancelled());
    if (stoppedEarly && control.resume)
        (*file)->keepWork();
    return placed(**file, {*report, stoppedEarly, {}}, output, target);
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

std::string keptName(const std::filesystem::path& output, double error)
{
    constexpr double largestShort = 99.5; // of those that two digits can say without an exponent
    std::array<char, 32> digits{};
    const auto [last, problem] = error < largestShort
                                     ? std::to_chars(digits.begin(), digits.end(), error, std::chars_format::general, 2)
                                     : std::to_chars(digits.begin(), digits.end(), error, std::chars_format::fixed, 0);
    const std::string number(digits.begin(), problem == std::errc() ? last : digits.begin());
    const std::string end = error > 0 ? "-" + number + "-percent" : std::string("-stopped");
    return output.stem().string() + end + output.extension().string();
}

bool keepsBeside(const std::filesystem::path& output)
{
    std::error_code problem;
    if (const auto size = std::filesystem::file_size(output, problem); problem || size == 0)
        return false;
    const std::string kept = contentOf(workFolderOf(output) / keptFile);
    return kept.empty() || kept != checksumText(output);
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
    const auto size = std::filesystem::file_size(ended->model, problem);
    return ModelBuild{builder->id,        ended->report,       elapsed.count(), peakResidentBytes(),
                      problem ? 0 : size, ended->stoppedEarly, ended->model};
}

} // namespace tetra
