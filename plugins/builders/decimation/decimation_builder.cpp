// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/builders/decimation/decimation_builder.h"

#include "core/base/memory.h"
#include "core/base/text.h"
#include "core/data/weighting.h"
#include "core/decimate/decimation.h"
#include "plugins/api/threshold_parameters.h"
#include "plugins/api/weights_parameter.h"
#include "plugins/builders/decimation/decimation_input.h"
#include "plugins/builders/decimation/decimation_need.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>
#include <vector>

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

/// Hands on a history, coarse first, as far as the first mesh whose key is no more than `finest`. If it `keeps` that
/// mesh, it can be asked for.
class HistoryBeginning final : public HistorySink {
public:
    HistoryBeginning(HistorySink& next, double finest, bool keeps) : next_(next), finest_(finest), keeps_(keeps) {}

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
        if (keeps_)
            keep(step);
        return next_.add(step);
    }
    Status finish(float finalKey) override { return complete_ ? Status() : next_.finish(finalKey); }

    std::uint64_t sites() const noexcept { return sites_; }
    std::uint64_t tetrahedra() const noexcept { return tetrahedra_; }
    /// The finest mesh, of the dataset's points.
    std::vector<std::array<std::uint32_t, 4>> mesh() const
    {
        std::vector<std::array<std::uint32_t, 4>> living;
        std::ranges::copy_if(kept_, std::back_inserter(living),
                             [](const auto& corners) { return corners != destroyed; });
        return living;
    }

private:
    static constexpr std::array<std::uint32_t, 4> destroyed{};

    void keep(const HistoryStep& step)
    {
        points_.push_back(static_cast<std::uint32_t>(step.point));
        for (const std::uint32_t index : step.destroyed)
            kept_[index] = destroyed;
        for (const HistoryTetrahedron& tetrahedron : step.star) {
            const auto& sites = tetrahedron.sites;
            kept_.push_back({points_.back(), points_[sites[0]], points_[sites[1]], points_[sites[2]]});
        }
    }

    HistorySink& next_;
    double finest_;
    bool keeps_;
    std::vector<std::uint32_t> points_;              ///< of the sites
    std::vector<std::array<std::uint32_t, 4>> kept_; ///< by history index
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

/// A model from a finest mesh on that is coarser than its coarsest one would hold nothing.
Status checkFinest(double finest, const BuildThresholds& thresholds)
{
    const double stop = thresholds.error;
    if (!(stop > 0) || finest <= stop)
        return {};
    return Error{ErrorKind::WrongUsage, "The finest error (" + formatNumber(finest) +
                                            " %) is larger than the error at which to stop (" + formatNumber(stop) +
                                            " %). Choose a smaller finest error, or 0 to keep everything."};
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
    const double finest = parameterValue<double>(known, values, "finest");
    const BuildThresholds thresholds = buildThresholds(known, values);
    if (const Status possible = checkFinest(finest, thresholds); !possible)
        return possible.error();
    const auto weighting = parseWeighting(parameterValue<std::string>(known, values, "weights"));
    if (!weighting)
        return weighting.error();
    const auto input = DecimationInput::make(dataset, *weighting, progress.part(0, 0.02));
    if (!input)
        return input.error();
    DecimationOptions options = optionsFor(dataset, thresholds);
    options.order = orderOf(parameterValue<std::string>(known, values, "order"));
    const DecimationMesh mesh = input->mesh();
    const bool isGrid = dataset.domain == DomainClass::Curvilinear;
    const double finestKey = finest / 100 * thresholdKey({}, dataset).valueExtent;
    HistoryBeginning history(target.history, finest > 0 ? finestKey : -1, isGrid && finest > 0);
    const auto result = decimate(mesh, options, history, progress.part(0.02, 1));
    if (!result)
        return result.error();
    BuildReport report{history.sites(), history.tetrahedra(), 0, 0};
    if (isGrid) {
        const PhysicalSigns signs =
            finest > 0 ? physicalSigns(dataset, history.mesh()) : physicalSigns(dataset, mesh.tetrahedra);
        report.inverted = signs.inverted;
        report.degenerate = signs.degenerate;
    }
    return report;
}

} // namespace tetra
