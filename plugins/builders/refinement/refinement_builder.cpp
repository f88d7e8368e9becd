// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/builders/refinement/refinement_builder.h"

#include "core/base/memory.h"
#include "core/data/weighting.h"
#include "plugins/api/threshold_parameters.h"
#include "plugins/api/weights_parameter.h"
#include "plugins/builders/refinement/block_choice.h"
#include "plugins/builders/refinement/curvilinear_build.h"
#include "plugins/builders/refinement/lattice_build.h"
#include "plugins/builders/refinement/scattered_build.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

namespace tetra {

namespace {

std::string notYet(const Dataset& dataset)
{
    return "Refinement does not take " + std::string(domainClassName(dataset.domain)) + " data.";
}

constexpr std::string_view normalised = "normalised";
constexpr std::string_view paper = "paper";

Parameter selectionParameter()
{
    Parameter selection;
    selection.id = "selection";
    selection.label = "Selection";
    selection.explanation = "For curvilinear data: 'normalised' takes the point that is farthest off in error or "
                            "warping; 'paper' compares the two in the units of the data, as the paper did, to "
                            "compare with it. Both keep cells from turning over.";
    selection.defaultValue = std::string(normalised);
    selection.choices = {std::string(normalised), std::string(paper)};
    selection.onlyWith = {domainId, {std::string(domainClassName(DomainClass::Curvilinear))}};
    return selection;
}

CurvilinearBuildRequest curvilinearRequest(const std::vector<Parameter>& parameters, const ParameterValues& values,
                                           const Weighting& weighting, std::optional<std::uint32_t> cells)
{
    CurvilinearBuildRequest request;
    request.weighting = weighting;
    request.blockEdge = cells.value_or(0);
    request.thresholds = buildThresholds(parameters, values);
    if (parameterValue<std::string>(parameters, values, "selection") == paper)
        request.selection = CurvilinearSelection::Paper;
    return request;
}

/// What a build of one kind takes, measured (docs/performance.md, "Estimates").
struct Costs {
    double fixedBytes = 30e6;  ///< of memory: the program
    double pointBytes = 0;     ///< of memory, for each point ...
    double siteBytes = 0;      ///< ... and besides for each site
    double modelSiteBytes = 0; ///< of the file, for each site
    double diskFactor = 1;     ///< of disk while it is built, over the model
    double siteSeconds = 0;    ///< on one thread, for each site
    double pointSeconds = 0;   ///< likewise for each point
    bool usesThreads = false;
};

Costs costsOf(const BuildSize& size, bool inBlocks)
{
    const auto points = static_cast<double>(size.points);
    if (size.domain == DomainClass::Scattered)
        return {.pointBytes = 60, .siteBytes = 700, .modelSiteBytes = 440, .siteSeconds = 25e-6};
    if (size.domain == DomainClass::Curvilinear)
        return {.pointBytes = 60, .siteBytes = 600, .modelSiteBytes = 340, .siteSeconds = 7e-6};
    if (inBlocks)
        return {.fixedBytes = 100e6,
                .siteBytes = 45,
                .modelSiteBytes = 300,
                .diskFactor = 1.65,
                .siteSeconds = 7.5e-6,
                .pointSeconds = 0.08e-6,
                .usesThreads = true};
    const double memoryMisses = std::clamp(std::log2(points / 32768) / 6, 0.0, 1.0); // 0 at 32^3, 1 at 128^3
    return {.pointBytes = 160,
            .siteBytes = 450,
            .modelSiteBytes = 295,
            .siteSeconds = (4 + 3 * memoryMisses) * 1e-6,
            .pointSeconds = 0.1e-6};
}

/// What refining data of this size takes, down to an error that is a share of the range (and the diagonal); not of
/// irregular ones. `inBlocks`: of regular lattices.
BuildEstimate estimateRefinement(const BuildSize& size, double error, bool inBlocks, unsigned threads)
{
    const Costs costs = costsOf(size, inBlocks);
    const auto points = static_cast<double>(size.points);
    const double sites = std::max(points * size.density.share(error), 8.0);
    const double data = points * static_cast<double>(sampleSize(size.type));
    BuildEstimate estimate;
    estimate.modelBytes = static_cast<std::uint64_t>(sites * costs.modelSiteBytes + 4096);
    estimate.diskBytes = static_cast<std::uint64_t>(static_cast<double>(estimate.modelBytes) * costs.diskFactor);
    estimate.memoryBytes =
        static_cast<std::uint64_t>(costs.fixedBytes + data + points * costs.pointBytes + sites * costs.siteBytes);
    estimate.seconds =
        (sites * costs.siteSeconds + points * costs.pointSeconds) / (costs.usesThreads ? std::max(1u, threads) : 1);
    return estimate;
}

} // namespace

Acceptance RefinementBuilder::accepts(const Dataset& dataset) const
{
    switch (dataset.domain) {
    case DomainClass::RegularLattice: return acceptLattice(dataset);
    case DomainClass::Curvilinear: return acceptCurvilinear(dataset);
    case DomainClass::Scattered: return acceptScattered(dataset);
    case DomainClass::Irregular: break;
    }
    return {0, notYet(dataset)};
}

std::vector<Parameter> RefinementBuilder::parameters() const
{
    return {errorThresholdParameter(
                "The error at which to stop; 0 keeps everything, so that any accuracy can be shown later."),
            warpingThresholdParameter({DomainClass::Curvilinear}), blockParameter(), selectionParameter(),
            weightsParameter()};
}

/// One threshold alone holds for error and warping.
ParameterValues RefinementBuilder::detail(double percent, DomainClass domain) const
{
    ParameterValues values{{"error", percent}};
    if (domain == DomainClass::Curvilinear)
        values["warping"] = 0.0;
    return values;
}

/// Only blocks of a regular lattice are independent of each other, each with a file of its own.
BuildAbilities RefinementBuilder::abilities(const Dataset& dataset, const ParameterValues& values) const
{
    if (dataset.domain != DomainClass::RegularLattice)
        return {};
    const auto cells =
        chooseBlocks(parameterValue<std::string>(parameters(), values, "block"), dataset.lattice, usableBytes());
    const bool inBlocks = cells && *cells;
    return {.usesThreads = inBlocks, .resumes = inBlocks, .keeps = !inBlocks};
}

std::optional<BuildEstimate> RefinementBuilder::estimate(const BuildSize& size, const ParameterValues& values,
                                                         unsigned threads) const
{
    if (size.domain == DomainClass::Irregular)
        return std::nullopt;
    const auto block = parameterValue<std::string>(parameters(), values, "block");
    const double error = size.domain == DomainClass::Curvilinear
                             ? buildThresholds(parameters(), values).error
                             : parameterValue<double>(parameters(), values, "error");
    return estimateRefinement(size, error / 100, takesBlocks(block, size.points, usableBytes()), threads);
}

Result<BuildReport> RefinementBuilder::build(const Dataset& dataset, const ParameterValues& values, BuildTarget& target,
                                             const Progress& progress) const
{
    const double error = parameterValue<double>(parameters(), values, "error");
    const auto weighting = parseWeighting(parameterValue<std::string>(parameters(), values, "weights"));
    if (!weighting)
        return weighting.error();
    const auto block = parameterValue<std::string>(parameters(), values, "block");
    const auto cells = givenBlocks(block);
    if (!cells)
        return cells.error();
    switch (dataset.domain) {
    case DomainClass::RegularLattice: return buildLattice(dataset, {error, block, *weighting}, target, progress);
    case DomainClass::Curvilinear:
        return buildCurvilinear(dataset, curvilinearRequest(parameters(), values, *weighting, *cells), target,
                                progress);
    case DomainClass::Scattered: return buildScattered(dataset, error, *weighting, target, progress);
    case DomainClass::Irregular: break;
    }
    return Error{ErrorKind::BadInput, notYet(dataset)};
}

} // namespace tetra
