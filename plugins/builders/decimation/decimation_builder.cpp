// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/builders/decimation/decimation_builder.h"

#include "plugins/api/space_parameter.h"
#include "plugins/api/threshold_parameters.h"
#include "plugins/api/weights_parameter.h"

#include <string_view>

namespace tetra {

namespace {

constexpr std::string_view exact = Message::marked("exact"), paper = Message::marked("paper"),
                           rounds = Message::marked("rounds");

Parameter orderParameter()
{
    Parameter order;
    order.id = "order";
    order.label = Message::marked("Order");
    order.explanation = Message::marked(
        "Which point is removed next: 'exact' takes the one whose loss does the least harm, for the fewest points; "
        "'paper' estimates that by gradients and planes, as the paper did; 'rounds' takes many points that are not "
        "neighbours at a time, so that a focus region needs the fewest additional points.");
    order.defaultValue = std::string(exact);
    order.choices = {std::string(exact), std::string(paper), std::string(rounds)};
    return order;
}

std::vector<std::string> domainsThatWarp()
{
    return {std::string(domainClassName(DomainClass::Curvilinear)), std::string(rectilinear),
            std::string(domainClassName(DomainClass::Irregular)), std::string(domainClassName(DomainClass::Scattered))};
}

std::vector<std::string> domainsOfGrids()
{
    return {std::string(domainClassName(DomainClass::Curvilinear)), std::string(rectilinear)};
}

constexpr std::string_view oneSided = Message::marked("one-sided"), twoSided = Message::marked("two-sided");

Parameter distanceParameter()
{
    Parameter distance;
    distance.id = "distance";
    distance.label = Message::marked("Distance");
    distance.explanation =
        Message::marked("What the warping of irregular data measures: 'one-sided', as the paper did, how far the "
                        "points of the data's boundary are from that of a mesh; 'two-sided' also how far any place on "
                        "a mesh's boundary is from that of the data.");
    distance.defaultValue = std::string(oneSided);
    distance.choices = {std::string(oneSided), std::string(twoSided)};
    distance.onlyWith = {domainId, {std::string(domainClassName(DomainClass::Irregular))}};
    return distance;
}

DecimationOrder orderOf(const std::string& name)
{
    if (name == paper)
        return DecimationOrder::PaperEstimates;
    return name == rounds ? DecimationOrder::IndependentRounds : DecimationOrder::ExactError;
}

Message reasonFor(const Dataset& dataset)
{
    switch (dataset.domain) {
    case DomainClass::Irregular: return Message::say("An irregular mesh: decimation keeps its shape and its cavities.");
    case DomainClass::Curvilinear:
        return Message::say("A curvilinear grid: decimation uses the mesh of its cells, and needs the fewest "
                            "tetrahedra for an error in space, where the points lie.");
    case DomainClass::RegularLattice:
        return Message::say(
            "A regular lattice: decimation takes fewer points for the same accuracy, but more time and memory.");
    case DomainClass::Scattered: break;
    }
    return Message::say("Scattered points: decimation begins with the Delaunay mesh of all of them, and needs fewer of "
                        "them for the same accuracy, but more time and memory.");
}

bool isComputational(const std::vector<Parameter>& known, const ParameterValues& values, DomainClass domain)
{
    return domain == DomainClass::Curvilinear &&
           parameterValue<std::string>(known, values, "space") == computationalSpace;
}

/// Of a grid as many as if it had a cell for each point, cut as decimation cuts it; of points as their Delaunay mesh.
double tetrahedraOf(const BuildSize& size)
{
    if (size.domain == DomainClass::Irregular)
        return static_cast<double>(size.tetrahedra);
    if (size.domain == DomainClass::Scattered)
        return 6.7 * static_cast<double>(size.points);
    return static_cast<double>(size.points) * (size.domain == DomainClass::Curvilinear ? 6 : 5);
}

/// What decimating data of this size to the coarsest mesh takes, with a model that leaves out meshes finer than
/// `finest`, a share of the range. `isBox`: in the space of the indices.
BuildEstimate estimateDecimation(const BuildSize& size, double finest, bool isBox)
{
    // Of all that ever lived, with their sites; and how many these are for each one of the dataset.
    const double modelTetrahedronBytes = isBox ? 21 : 26;
    const double livedOverKept = isBox ? 2.7 : 3.5;
    constexpr double collapseSeconds = 60e-6;
    constexpr double fixedBytes = 30e6; // of memory: the program, and as decimationBytes()
    constexpr double pointBytes = 700;
    constexpr double tetrahedronBytes = 100;
    BuildEstimate estimate;
    const double tetrahedra = tetrahedraOf(size);
    const double whole = tetrahedra * livedOverKept * modelTetrahedronBytes;
    estimate.modelBytes = static_cast<std::uint64_t>(whole * (finest > 0 ? size.density.share(finest) : 1));
    estimate.diskBytes = estimate.modelBytes;
    estimate.memoryBytes = static_cast<std::uint64_t>(
        whole + fixedBytes + static_cast<double>(size.points) * pointBytes + tetrahedra * tetrahedronBytes);
    estimate.seconds = static_cast<double>(size.points) * collapseSeconds;
    return estimate;
}

} // namespace

Acceptance DecimationBuilder::accepts(const Dataset& dataset) const
{
    if (const Status possible = checkDecimation(dataset); !possible)
        return {0, possible.error().message};
    if (dataset.domain == DomainClass::Irregular)
        return {1, reasonFor(dataset)};
    if (dataset.domain != DomainClass::Curvilinear || dataset.convex)
        return {0.5, reasonFor(dataset)};
    const Status isMesh = checkAsMesh(dataset);
    return isMesh ? Acceptance{1, reasonFor(dataset)} : Acceptance{0.5, isMesh.error().message};
}

std::vector<Parameter> DecimationBuilder::parameters() const
{
    return {
        errorThresholdParameter(Message::marked("Decimation stops at this error; 0 continues to the coarsest mesh.")),
        warpingThresholdParameter(domainsThatWarp()),
        orderedByParameter(domainsThatWarp()),
        thresholdParameter(
            "finest", Message::marked("Finest error"),
            Message::marked(
                "Leaves meshes of smaller errors out of the model, to make it smaller; 0 keeps everything."),
            Message::marked("% of the value range")),
        orderParameter(),
        spaceParameter(domainsOfGrids()),
        distanceParameter(),
        weightsParameter()};
}

ParameterValues DecimationBuilder::detail(double percent, DomainClass /*domain*/) const
{
    return {{"finest", percent}};
}

/// The history runs from the last collapse back, and there may be a last one at any time.
BuildAbilities DecimationBuilder::abilities(const Dataset&, const ParameterValues&) const
{
    return {.usesThreads = false, .resumes = true, .keeps = true};
}

std::optional<BuildEstimate> DecimationBuilder::estimate(const BuildSize& size, const ParameterValues& values,
                                                         unsigned) const
{
    const bool isBox = size.domain == DomainClass::RegularLattice || isComputational(parameters(), values, size.domain);
    return estimateDecimation(size, parameterValue<double>(parameters(), values, "finest") / 100, isBox);
}

/// What it has no use for the host refuses.
Result<Dataset> DecimationBuilder::taken(const Dataset& dataset, const ParameterValues& values,
                                         const Progress& progress) const
{
    Decimation decimation;
    decimation.computational = isComputational(parameters(), values, dataset.domain);
    return takenFor(decimation, dataset, progress);
}

Result<BuildReport> DecimationBuilder::build(const Dataset& dataset, const ParameterValues& values, BuildTarget& target,
                                             const Progress& progress) const
{
    const std::vector<Parameter> known = parameters();
    const auto weighting = parseWeighting(parameterValue<std::string>(known, values, "weights"));
    if (!weighting)
        return weighting.error();
    Decimation decimation;
    decimation.error = parameterValue<double>(known, values, "error");
    decimation.warping = parameterValue<double>(known, values, "warping");
    decimation.finest = parameterValue<double>(known, values, "finest");
    decimation.order = orderOf(parameterValue<std::string>(known, values, "order"));
    decimation.orderedBy = orderedByOf(known, values);
    decimation.weighting = *weighting;
    decimation.computational = isComputational(known, values, dataset.domain);
    decimation.twoSided =
        dataset.domain == DomainClass::Irregular && parameterValue<std::string>(known, values, "distance") == twoSided;
    return buildInto(dataset, decimation, target, progress);
}

} // namespace tetra
