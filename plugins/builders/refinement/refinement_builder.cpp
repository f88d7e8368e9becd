// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/builders/refinement/refinement_builder.h"

#include "plugins/api/space_parameter.h"
#include "plugins/api/threshold_parameters.h"
#include "plugins/api/weights_parameter.h"
#include <tan/build.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

namespace tetra {

namespace {

constexpr std::string_view normalised = Message::marked("normalised");
constexpr std::string_view paper = Message::marked("paper");
constexpr std::string_view inGrid = Message::marked("grid");
constexpr std::string_view inSpace = Message::marked("space");
constexpr std::string_view automatic = Message::marked("automatic");
constexpr std::string_view computational = computationalSpace;

/// A parameter of data that are refined in computational space.
Parameter inComputationalSpace(Parameter parameter)
{
    parameter.onlyWith.id = domainId;
    parameter.onlyWith.values.emplace_back(std::string(domainClassName(DomainClass::Curvilinear)));
    parameter.orWith = {"space", {std::string(computational)}};
    return parameter;
}

Parameter selectionParameter()
{
    Parameter selection;
    selection.id = "selection";
    selection.label = Message::marked("Selection");
    selection.explanation =
        Message::marked("For curvilinear data: 'normalised' takes the point that is farthest off in error or warping; "
                        "'paper' compares the two in the units of the data, as the paper did, for comparison with it. "
                        "Both keep cells from turning inside out.");
    selection.defaultValue = std::string(normalised);
    selection.choices = {std::string(normalised), std::string(paper)};
    return inComputationalSpace(std::move(selection));
}

Parameter errorInParameter()
{
    Parameter errorIn;
    errorIn.id = "error-in";
    errorIn.label = Message::marked("Error in");
    errorIn.explanation =
        Message::marked("For curvilinear data: 'grid' keeps the error in the grid, at the points' indices, as the "
                        "paper did; 'space' also the error in space, where the points lie, which is what you see. That "
                        "takes more vertices and time, and the whole grid in memory. 'automatic' keeps both for grids "
                        "of up to a million points that are refined as a whole, using both thresholds.");
    errorIn.defaultValue = std::string(automatic);
    errorIn.choices = {std::string(automatic), std::string(inGrid), std::string(inSpace)};
    return inComputationalSpace(std::move(errorIn));
}

Parameter blockParameter()
{
    Parameter block;
    block.id = "block";
    block.label = Message::marked("Block");
    block.explanation = Message::marked(
        "The edge length, in cells, of the blocks that are refined independently, a few of them in memory at a time; "
        "'none' refines the dataset as a whole; 'automatic' uses blocks where a lattice or grid is large.");
    block.unit = Message::marked("cells");
    block.defaultValue = std::string("automatic");
    block.words = {Message::marked("automatic"), Message::marked("none")};
    block = inComputationalSpace(std::move(block));
    block.onlyWith.values.insert(block.onlyWith.values.begin(),
                                 std::string(domainClassName(DomainClass::RegularLattice)));
    return block;
}

/// Refinement::block of the parameter's text. Error: WrongUsage, it is none of its values.
Result<std::optional<std::uint32_t>> blockOf(const std::string& text)
{
    if (text == "automatic")
        return std::optional<std::uint32_t>();
    if (text == "none")
        return std::optional(0u);
    const auto cells = parseNumber<std::uint32_t>(text);
    if (!cells || *cells == 0)
        return Error{
            ErrorKind::WrongUsage,
            Message::say("The block size '%1' is not \"automatic\", \"none\" or a number of cells of at least 1.",
                         text)};
    return cells;
}

/// Whether data in computational space are refined with the error in space.
bool keepsInSpace(const std::vector<Parameter>& known, const ParameterValues& values, std::uint64_t points)
{
    const auto chosen = [&](const char* id) { return parameterValue<std::string>(known, values, id); };
    if (chosen("error-in") != automatic)
        return chosen("error-in") == inSpace;
    const auto block = blockOf(chosen("block"));
    return block && !takesBlocks(*block, points, usableBytes()) && chosen("selection") == normalised &&
           orderedByOf(known, values) == OrderedBy::Both && keepsErrorInSpace(points);
}

Message reasonFor(const Dataset& dataset)
{
    switch (dataset.domain) {
    case DomainClass::RegularLattice:
        return Message::say("A regular lattice: refinement keeps the exact domain and is the fastest method.");
    case DomainClass::Curvilinear:
        if (dataset.convex)
            return Message::say("A rectilinear grid: refinement in physical space keeps the exact domain.");
        return Message::say("A curvilinear grid: refinement in computational space bounds the error in the grid and "
                            "the warping, even where cells of the grid are folded, and can bound the error in space.");
    case DomainClass::Scattered: return Message::say("Scattered points: refinement fills their convex hull.");
    case DomainClass::Irregular: break;
    }
    return Message::say("A mesh of convex domain: refinement keeps the exact domain, with tetrahedra of its own.");
}

/// What a build of one kind takes, measured (docs/lab/performance.md, "Estimates").
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

Costs costsOf(const BuildSize& size, bool inBlocks, bool isInSpace)
{
    const auto points = static_cast<double>(size.points);
    if (size.domain == DomainClass::Scattered)
        return {.pointBytes = 60, .siteBytes = 700, .modelSiteBytes = 440, .siteSeconds = 25e-6};
    if (size.domain == DomainClass::Curvilinear && isInSpace) // for each site of a build that is not
        return {
            .pointBytes = 110, .siteBytes = 700, .modelSiteBytes = 400, .siteSeconds = 150e-6, .pointSeconds = 40e-6};
    if (size.domain == DomainClass::Curvilinear && !inBlocks)
        return {.pointBytes = 60, .siteBytes = 600, .modelSiteBytes = 340, .siteSeconds = 7e-6};
    if (size.domain == DomainClass::Curvilinear)
        return {.fixedBytes = 100e6,
                .pointBytes = 24,
                .siteBytes = 45,
                .modelSiteBytes = 345,
                .diskFactor = 1.65,
                .siteSeconds = 12e-6,
                .pointSeconds = 0.3e-6,
                .usesThreads = true};
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
/// irregular ones. `inBlocks`: of lattices and grids. `isInSpace`: of grids, the error in space is kept, too.
BuildEstimate estimateRefinement(const BuildSize& size, double error, bool inBlocks, bool isInSpace, unsigned threads)
{
    const Costs costs = costsOf(size, inBlocks, isInSpace);
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
    if (const Status possible = checkRefinement(dataset); !possible)
        return {0, possible.error().message};
    // Between its points a mesh is what its own cells say; those decimation begins with, and those of a grid if it is
    // a mesh and not too large.
    const bool isBent = dataset.domain == DomainClass::Curvilinear && !dataset.convex;
    return {dataset.domain == DomainClass::Irregular ? 0.5 : isBent ? 0.9 : 1, reasonFor(dataset)};
}

std::vector<Parameter> RefinementBuilder::parameters() const
{
    return {errorThresholdParameter(Message::marked(
                "Refinement stops at this error; 0 keeps everything, so that any accuracy can be shown later.")),
            inComputationalSpace(warpingThresholdParameter({})),
            inComputationalSpace(orderedByParameter({})),
            spaceParameter({std::string(rectilinear)}),
            blockParameter(),
            selectionParameter(),
            errorInParameter(),
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

/// Blocks are independent of each other.
BuildAbilities RefinementBuilder::abilities(const Dataset& dataset, const ParameterValues& values) const
{
    const auto block = blockOf(parameterValue<std::string>(parameters(), values, "block"));
    if (!isOnLattice(dataset.domain) || !block)
        return {.resumes = true};
    const auto chosen = [&](const char* id) { return parameterValue<std::string>(parameters(), values, id); };
    if (dataset.domain == DomainClass::Curvilinear &&
        (chosen("selection") == paper || (dataset.convex && chosen("space") != computational)))
        return {.resumes = true}; // these take no blocks
    if (dataset.domain == DomainClass::Curvilinear && keepsInSpace(parameters(), values, dataset.pointCount()))
        return {.usesThreads = true, .resumes = true}; // nor does this, but it measures on all of them
    const auto cells = chooseBlocks(*block, dataset.lattice, usableBytes());
    const bool inBlocks = cells && *cells > 0;
    return {.usesThreads = inBlocks, .resumes = true, .takesParts = inBlocks};
}

std::optional<BuildEstimate> RefinementBuilder::estimate(const BuildSize& size, const ParameterValues& values,
                                                         unsigned threads) const
{
    const auto block = blockOf(parameterValue<std::string>(parameters(), values, "block"));
    if ((size.domain == DomainClass::Irregular && !size.convex) || !block)
        return std::nullopt;
    BuildSize taken = size;
    const bool isGridOrMesh = size.domain == DomainClass::Curvilinear || size.domain == DomainClass::Irregular;
    if (isGridOrMesh && size.convex && parameterValue<std::string>(parameters(), values, "space") != computational)
        taken.domain = DomainClass::Scattered;
    double error = parameterValue<double>(parameters(), values, "error");
    if (taken.domain == DomainClass::Curvilinear && !(error > 0))
        error = parameterValue<double>(parameters(), values, "warping");
    return estimateRefinement(taken, error / 100, takesBlocks(*block, size.points, usableBytes()),
                              keepsInSpace(parameters(), values, size.points), threads);
}

namespace {

Result<Refinement> refinementOf(const std::vector<Parameter>& known, const ParameterValues& values)
{
    const auto weighting = parseWeighting(parameterValue<std::string>(known, values, "weights"));
    if (!weighting)
        return weighting.error();
    const auto block = blockOf(parameterValue<std::string>(known, values, "block"));
    if (!block)
        return block.error();
    Refinement refinement;
    refinement.error = parameterValue<double>(known, values, "error");
    refinement.warping = parameterValue<double>(known, values, "warping");
    refinement.block = *block;
    refinement.paperSelection = parameterValue<std::string>(known, values, "selection") == paper;
    refinement.orderedBy = orderedByOf(known, values);
    refinement.inSpace = parameterValue<std::string>(known, values, "error-in") == inSpace;
    refinement.computational = parameterValue<std::string>(known, values, "space") == computational;
    refinement.weighting = *weighting;
    return refinement;
}

} // namespace

Result<Dataset> RefinementBuilder::taken(const Dataset& dataset, const ParameterValues& values,
                                         const Progress& progress) const
{
    const auto refinement = refinementOf(parameters(), settled(dataset, values));
    return refinement ? takenFor(*refinement, dataset, progress) : refinement.error();
}

ParameterValues RefinementBuilder::settled(const Dataset& dataset, const ParameterValues& values) const
{
    const bool isInIndices =
        dataset.domain == DomainClass::Curvilinear &&
        (!dataset.convex || parameterValue<std::string>(parameters(), values, "space") == computational);
    ParameterValues known = values;
    if (isInIndices)
        known["error-in"] = std::string(keepsInSpace(parameters(), values, dataset.pointCount()) ? inSpace : inGrid);
    return known;
}

Result<BuildReport> RefinementBuilder::build(const Dataset& dataset, const ParameterValues& values, BuildTarget& target,
                                             const Progress& progress) const
{
    const auto refinement = refinementOf(parameters(), settled(dataset, values));
    return refinement ? buildInto(dataset, *refinement, target, progress) : refinement.error();
}

} // namespace tetra
