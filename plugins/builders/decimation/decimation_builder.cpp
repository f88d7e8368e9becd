// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/builders/decimation/decimation_builder.h"

#include "core/base/byte_text.h"
#include "core/base/memory.h"
#include "core/data/weighting.h"
#include "core/mesh/decimation/decimation.h"
#include "plugins/api/threshold_parameters.h"
#include "plugins/api/weights_parameter.h"
#include "plugins/builders/decimation/decimation_input.h"
#include "plugins/builders/decimation/decimation_need.h"

#include <string_view>

namespace tetra {

namespace {

constexpr std::string_view exact = "exact", paper = "paper", rounds = "rounds";

Parameter orderParameter()
{
    Parameter order;
    order.id = "order";
    order.label = "Order";
    order.explanation =
        "Which point goes next: 'exact' takes the one whose loss does the least harm, for the fewest points; 'paper' "
        "estimates that by gradients and planes, as the paper did; 'rounds' takes many points at a time that do not "
        "touch, so that a focus region needs the least besides.";
    order.defaultValue = std::string(exact);
    order.choices = {std::string(exact), std::string(paper), std::string(rounds)};
    return order;
}

DecimationOrder orderOf(const std::string& name)
{
    if (name == paper)
        return DecimationOrder::PaperEstimates;
    return name == rounds ? DecimationOrder::IndependentRounds : DecimationOrder::ExactError;
}

/// Without thresholds to the coarsest mesh.
DecimationOptions optionsFor(const Dataset& dataset, const BuildThresholds& thresholds)
{
    const ThresholdKey key = thresholdKey(thresholds, dataset);
    DecimationOptions options;
    options.warpingWeight = key.warpingWeight;
    if (key.stopKey)
        options.stopKey = *key.stopKey;
    return options;
}

/// Hands on a history, coarse first, as far as the first mesh whose key is no more than `finest`.
class HistoryBeginning final : public HistorySink {
public:
    HistoryBeginning(HistorySink& next, double finest) : next_(next), finest_(finest) {}

    Status begin(const HistoryTraits& traits) override { return next_.begin(traits); }
    Status add(const HistoryStep& step) override
    {
        if (complete_)
            return {};
        if (static_cast<double>(step.keyBefore) <= finest_) {
            complete_ = true;
            return next_.finish(step.keyBefore);
        }
        ++sites_;
        tetrahedra_ += step.star.size();
        return next_.add(step);
    }
    Status finish(float finalKey) override { return complete_ ? Status() : next_.finish(finalKey); }

    std::uint64_t sites() const noexcept { return sites_; }
    std::uint64_t tetrahedra() const noexcept { return tetrahedra_; }

private:
    HistorySink& next_;
    double finest_;
    bool complete_ = false;
    std::uint64_t sites_ = 0;
    std::uint64_t tetrahedra_ = 0;
};

std::string reasonFor(const Dataset& dataset)
{
    switch (dataset.domain) {
    case DomainClass::Irregular: return "An irregular mesh: decimation keeps its shape and its cavities.";
    case DomainClass::Curvilinear:
        return "A curvilinear grid: decimation takes fewer points for the same accuracy, but more time and memory.";
    case DomainClass::RegularLattice:
        return "A regular lattice: decimation takes fewer points for the same accuracy, but more time and memory.";
    case DomainClass::Scattered: break;
    }
    return "Scattered points have no tetrahedra that decimation could begin with. Refine them instead.";
}

/// Why the dataset cannot be decimated at all.
Status checkInput(const Dataset& dataset)
{
    if (dataset.domain == DomainClass::Scattered)
        return Error{ErrorKind::BadInput, reasonFor(dataset)};
    const DecimationSize size = decimationSize(dataset);
    if (size.tetrahedra == 0)
        return Error{ErrorKind::BadInput, "A tetrahedral mesh needs a cell: two points or more along each axis."};
    return checkDecimationNeed(size, usableBytes());
}

} // namespace

Acceptance DecimationBuilder::accepts(const Dataset& dataset) const
{
    if (const Status possible = checkInput(dataset); !possible)
        return {0, possible.error().text};
    return {dataset.domain == DomainClass::Irregular ? 1.0 : 0.5, reasonFor(dataset)};
}

std::vector<Parameter> DecimationBuilder::parameters() const
{
    return {errorThresholdParameter("The error at which to stop; 0 goes on to the coarsest mesh."),
            warpingThresholdParameter({DomainClass::Curvilinear, DomainClass::Irregular}),
            thresholdParameter("finest", "Finest error",
                               "Leaves meshes of smaller errors out of the model, so that it is smaller; 0 keeps "
                               "everything.",
                               "% of the value range"),
            orderParameter(), weightsParameter()};
}

ParameterValues DecimationBuilder::detail(double percent, DomainClass /*domain*/) const
{
    return {{"finest", percent}};
}

/// The history runs from the last collapse back, so there is none before the end.
BuildAbilities DecimationBuilder::abilities(const Dataset&, const ParameterValues&) const
{
    return {.usesThreads = false, .resumes = false, .keeps = false};
}

std::optional<BuildEstimate> DecimationBuilder::estimate(const BuildSize& size, const ParameterValues& values,
                                                         unsigned) const
{
    if (size.domain == DomainClass::Scattered)
        return std::nullopt;
    return estimateDecimation(size, parameterValue<double>(parameters(), values, "finest") / 100);
}

Result<BuildReport> DecimationBuilder::build(const Dataset& dataset, const ParameterValues& values, BuildTarget& target,
                                             const Progress& progress) const
{
    if (const Status possible = checkInput(dataset); !possible)
        return possible.error();
    const std::vector<Parameter> known = parameters();
    const auto weighting = parseWeighting(parameterValue<std::string>(known, values, "weights"));
    if (!weighting)
        return weighting.error();
    const auto input = DecimationInput::make(dataset, *weighting, progress.part(0, 0.02));
    if (!input)
        return input.error();
    DecimationOptions options = optionsFor(dataset, buildThresholds(known, values));
    options.order = orderOf(parameterValue<std::string>(known, values, "order"));
    const DecimationMesh mesh = input->mesh();
    const double finest = parameterValue<double>(known, values, "finest");
    const double finestKey = finest / 100 * thresholdKey({}, dataset).valueExtent;
    HistoryBeginning history(target.history, finest > 0 ? finestKey : -1);
    const auto result = decimate(mesh, options, history, progress.part(0.02, 1));
    if (!result)
        return result.error();
    BuildReport report{history.sites(), history.tetrahedra(), 0, 0};
    if (dataset.domain == DomainClass::Curvilinear) {
        const LiftedSigns signs = liftedSigns(dataset, mesh.tetrahedra);
        report.inverted = signs.inverted;
        report.degenerate = signs.degenerate;
    }
    return report;
}

} // namespace tetra
