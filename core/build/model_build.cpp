// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/build/model_build.h"

#include "core/base/file_writer.h"
#include "core/base/finished_file.h"
#include "core/base/guarded.h"
#include "core/base/mapped_file.h"
#include "core/build/decimation_build.h"
#include "core/history/build_facts.h"
#include "core/history/format.h"
#include "core/history/model_writer.h"
#include "core/history/value_statistics.h"

#include <tan/build.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <string>
#include <utility>

namespace tetra {

namespace {

using Parameters = std::vector<std::pair<std::string, std::string>>;

/// `description`, with `chosen` in place of what it has of the same names.
ModelDescription withParameters(ModelDescription description, const Parameters& chosen)
{
    for (const auto& parameter : chosen) {
        const auto known = std::ranges::find(description.parameters, parameter.first, &Parameters::value_type::first);
        if (known != description.parameters.end())
            *known = parameter;
        else
            description.parameters.push_back(parameter);
    }
    return description;
}

Result<WorkFolder> openWorkFolder(const std::filesystem::path& output, bool resume)
{
    // Whether the model can be written at all is better said of the model than of a folder.
    if (const Result<FileWriter> writer = FileWriter::create(output); !writer)
        return writer.error();
    return WorkFolder::open(workFolderOf(output), resume ? WorkFolder::Leftovers::Keep : WorkFolder::Leftovers::Remove);
}

} // namespace

bool beginsLikeModel(std::span<const std::byte> firstBytes) noexcept
{
    return firstBytes.size() >= format::magic.size() &&
           std::ranges::equal(std::as_bytes(std::span(format::magic)), firstBytes.first(format::magic.size()));
}

Status checkModelOutput(const std::filesystem::path& output)
{
    std::error_code problem;
    if (!std::filesystem::is_regular_file(output, problem) || std::filesystem::file_size(output, problem) == 0)
        return checkTarget(output); // nothing to lose that is a file: missing or empty
    const auto file = RegularFile::open(output);
    const auto begin = file ? file->front(format::magic.size()) : file.error();
    if (!begin) // what cannot be looked at may be anything
        return begin.error();
    if (beginsLikeModel(std::as_bytes(std::span(*begin))))
        return checkTarget(output);
    return Error{ErrorKind::WrongUsage, Message::say("'%1' exists and is not a TAn model, so it is not overwritten. "
                                                     "Give the model another name, or remove that file first.",
                                                     output.string())};
}

std::filesystem::path workFolderOf(const std::filesystem::path& output)
{
    std::filesystem::path folder = behindLinks(output); // so that they are on one disk
    folder += ".work";
    return folder;
}

ModelFileTarget::ModelFileTarget(std::filesystem::path output, const Dataset& dataset, ModelDescription description,
                                 WorkFolder folder, bool resume)
    : output_(output), wanted_(std::move(output)), dataset_(dataset), description_(std::move(description)),
      folder_(std::move(folder)), resume_(resume)
{
}

Result<std::unique_ptr<ModelFileTarget>> ModelFileTarget::open(const std::filesystem::path& output,
                                                               const Dataset& dataset,
                                                               const ModelDescription& description, bool resume,
                                                               Finished finished)
{
    auto folder = openWorkFolder(output, resume);
    if (!folder)
        return folder.error();
    std::unique_ptr<ModelFileTarget> target(
        new ModelFileTarget(output, dataset, description, *std::move(folder), resume));
    if (finished == Finished::Later)
        target->output_ = target->folder_.path() / output.filename();
    auto writer = ModelWriter::create(target->output_, dataset, description, target->folder_.path());
    if (!writer)
        return writer.error();
    target->writer_ = *std::move(writer);
    return target;
}

Status ModelFileTarget::place(const std::filesystem::path& path) const
{
    std::error_code problem;
    if (const auto there = std::filesystem::status(wanted_, problem); std::filesystem::exists(there))
        std::filesystem::permissions(output_, there.permissions(), problem); // as far as the file system has any
    return replaceFile(output_, path);
}

BuildTarget ModelFileTarget::target(HistorySink& history)
{
    BuildTarget target{.history = history, .workFolder = folder_.path(), .resume = resume_};
    target.ofFixedSize = [this](const FixedCounts& counts, const Parameters& chosen) {
        return ModelFileWriter::create(output_, dataset_, withParameters(description_, chosen), counts, folder_.path());
    };
    return target;
}

// The face.

namespace {

std::string nameOf(DecimationOrder order)
{
    switch (order) {
    case DecimationOrder::ExactError: return "exact";
    case DecimationOrder::PaperEstimates: return "paper";
    case DecimationOrder::IndependentRounds: return "rounds";
    }
    return "";
}

// What a model keeps of how it was built, by the names of the builders' parameters.

ModelDescription provenanceOf(const Refinement& refinement, const Dataset& dataset)
{
    ModelDescription description;
    description.builder = buildText::refinement;
    Parameters& parameters = description.parameters;
    parameters.emplace_back(buildText::error, formatNumber(refinement.error));
    if (dataset.domain == DomainClass::Curvilinear)
        parameters.emplace_back("warping", formatNumber(refinement.warping));
    if (isOnLattice(dataset.domain))
        parameters.emplace_back(buildText::block, !refinement.block       ? "automatic"
                                                  : *refinement.block > 0 ? std::to_string(*refinement.block)
                                                                          : "none");
    if (dataset.domain == DomainClass::Curvilinear)
        parameters.emplace_back(buildText::selection, refinement.paperSelection ? buildText::paper : "normalised");
    if (refinement.inSpace)
        parameters.emplace_back(buildText::errorIn, buildText::space);
    parameters.emplace_back(buildText::weights, weightingText(refinement.weighting));
    if (dataset.domain == DomainClass::RegularLattice)
        description.metric = refinement.metric;
    return description;
}

ModelDescription provenanceOf(const Decimation& decimation, const Dataset& dataset)
{
    ModelDescription description;
    description.builder = "decimation";
    Parameters& parameters = description.parameters;
    parameters.emplace_back(buildText::error, formatNumber(decimation.error));
    if (dataset.domain != DomainClass::RegularLattice)
        parameters.emplace_back("warping", formatNumber(decimation.warping));
    parameters.emplace_back("finest", formatNumber(decimation.finest));
    parameters.emplace_back("order", nameOf(decimation.order));
    if (decimation.computational)
        parameters.emplace_back("space", "computational");
    if (dataset.domain == DomainClass::Irregular)
        parameters.emplace_back(buildText::distance, decimation.twoSided ? buildText::twoSided : "one-sided");
    parameters.emplace_back(buildText::weights, weightingText(decimation.weighting));
    return description;
}

Status checkPercents(std::initializer_list<double> percents)
{
    for (const double percent : percents)
        if (!(percent >= 0 && percent <= 100))
            return Error{ErrorKind::WrongUsage,
                         Message::say("%1 is not a percentage at which to stop. Give one from 0 to 100.",
                                      formatNumber(percent))};
    return {};
}

Status check(const Refinement& refinement)
{
    return checkPercents({refinement.error, refinement.warping});
}

Status check(const Decimation& decimation)
{
    return checkPercents({decimation.error, decimation.warping, decimation.finest});
}

/// Has `build`, a function of a BuildTarget, fill the file.
template <class Build> Result<BuildReport> fillFile(const Dataset& dataset, const std::filesystem::path& output,
                                                    const ModelDescription& description, const Build& build)
{
    if (const Status safe = checkModelOutput(output); !safe)
        return safe.error();
    const auto file = ModelFileTarget::open(output, dataset, description, false);
    if (!file)
        return file.error();
    ModelWriter& writer = (*file)->writer();
    BuildTarget target = (*file)->target(writer);
    Result<BuildReport> report = build(target);
    // What comes of values that change meanwhile may fail in any way.
    if (const Status intact = dataset.checkIntact();
        !intact && !(!report && report.error().kind == ErrorKind::Cancelled))
        return intact.error();
    if (report && writer.siteCount() > 0) {
        report->sites = writer.siteCount();
        report->tetrahedra = writer.tetrahedronCount();
    }
    return report;
}

template <class Method> Result<BuildReport> buildFile(const Dataset& dataset, const std::filesystem::path& output,
                                                      const Method& method, const Progress& progress)
{
    if (const Status usable = check(method); !usable)
        return usable.error();
    if (progress.cancelled())
        return cancelledError(Message::marked("The build"));
    const auto taken = takenFor(method, dataset, progress.part(0, 0.05));
    if (!taken)
        return taken.error();
    ModelDescription description = provenanceOf(method, *taken);
    std::ranges::move(statisticsTexts(*taken), std::back_inserter(description.parameters));
    return fillFile(*taken, output, description,
                    [&](BuildTarget& target) { return buildInto(*taken, method, target, progress.part(0.05, 1)); });
}

constexpr MarkedText noMemory =
    Message::marked("Not enough memory to build a model. Close other programs, or take fewer samples.");

} // namespace

BuildMethod suitableMethod(const Dataset& dataset)
{
    if (dataset.domain == DomainClass::Irregular)
        return Decimation{};
    if (dataset.domain != DomainClass::Curvilinear || dataset.convex)
        return Refinement{};
    if (checkAsMesh(dataset) && checkDecimation(dataset))
        return Decimation{};
    Refinement refinement;
    refinement.inSpace = keepsErrorInSpace(dataset.pointCount());
    return refinement;
}

Result<BuildReport> buildModel(const Dataset& dataset, const std::filesystem::path& output, const BuildMethod& method,
                               const Progress& progress)
{
    return guarded(noMemory, [&] {
        return std::visit([&](const auto& chosen) { return buildFile(dataset, output, chosen, progress); }, method);
    });
}

Result<BuildReport> buildModel(const Dataset& dataset, const std::filesystem::path& output)
{
    return guarded(noMemory, [&] { return buildModel(dataset, output, suitableMethod(dataset)); });
}

Result<BuildReport> writeModel(const Dataset& dataset, const std::filesystem::path& output, std::string builder,
                               const std::function<Status(HistorySink& history)>& build)
{
    return guarded(noMemory, [&]() -> Result<BuildReport> {
        ModelDescription description;
        description.builder = std::move(builder);
        return fillFile(dataset, output, description, [&](BuildTarget& target) -> Result<BuildReport> {
            if (const Status built = build(target.history); !built)
                return built.error();
            return BuildReport{};
        });
    });
}

} // namespace tetra
