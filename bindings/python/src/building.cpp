// SPDX-License-Identifier: GPL-3.0-or-later
// Models out of datasets, and the proof that they are what they claim to be.
#include "binding.h"
#include "opened_model.h"

#include <tan/build.h>
#include <tan/verify.h>

namespace tetra::python {

namespace {

/// What Python says of a build; nothing is what the library's own default is.
struct BuildOptions {
    std::string method; ///< empty: the suitable one
    double error = 0;
    double warping = 0;
    std::optional<double> finest;
    std::optional<std::uint32_t> block;
    std::optional<std::string> order;
    std::optional<std::string> orderedBy;
    std::string weights;
};

OrderedBy orderedByOf(const BuildOptions& options)
{
    constexpr std::array<std::pair<std::string_view, OrderedBy>, 3> orders{
        {{"both", OrderedBy::Both}, {"error", OrderedBy::Error}, {"warping", OrderedBy::Warping}}};
    return choice("ordered_by", options.orderedBy.value_or("both"), orders);
}

/// The suitable method's own choices, with those of the options.
BuildMethod refined(Refinement refinement, const BuildOptions& options)
{
    if (options.finest || options.order)
        raise({ErrorKind::WrongUsage,
               Message::say("'finest' and 'order' are options of decimation, and the data are refined. Leave them out, "
                            "or build by decimation.")});
    refinement.error = options.error;
    refinement.warping = options.warping;
    refinement.block = options.block;
    refinement.orderedBy = orderedByOf(options);
    if (refinement.orderedBy != OrderedBy::Both || options.block.value_or(0) > 0)
        refinement.inSpace = false;
    refinement.weighting = valueOf(parseWeighting(options.weights));
    return refinement;
}

BuildMethod decimated(Decimation decimation, const BuildOptions& options)
{
    if (options.block)
        raise({ErrorKind::WrongUsage,
               Message::say("'block' is an option of refinement, and the data are decimated. Leave it out, or build by "
                            "refinement.")});
    using enum DecimationOrder;
    constexpr std::array<std::pair<std::string_view, DecimationOrder>, 3> orders{
        {{"exact", ExactError}, {"paper", PaperEstimates}, {"rounds", IndependentRounds}}};
    decimation.error = options.error;
    decimation.warping = options.warping;
    decimation.finest = options.finest.value_or(0);
    decimation.order = choice("order", options.order.value_or("exact"), orders);
    decimation.orderedBy = orderedByOf(options);
    decimation.weighting = valueOf(parseWeighting(options.weights));
    return decimation;
}

BuildMethod methodOf(const BuildOptions& options, const Dataset& dataset, const BuildMethod& suitable)
{
    const auto* const refinement = std::get_if<Refinement>(&suitable);
    const auto* const decimation = std::get_if<Decimation>(&suitable);
    constexpr std::array<std::pair<std::string_view, int>, 3> methods{{{"", 0}, {"refinement", 1}, {"decimation", 2}}};
    int method = choice("method", options.method, methods);
    if (method == 0)
        method = refinement != nullptr ? 1 : 2;
    if (method == 2)
        return decimated(decimation != nullptr ? *decimation : Decimation{}, options);
    Refinement chosen = refinement != nullptr ? *refinement : Refinement{};
    if (refinement == nullptr && dataset.domain == DomainClass::Curvilinear)
        chosen.inSpace = keepsErrorInSpace(dataset.pointCount());
    return refined(std::move(chosen), options);
}

py::dict build(const HeldDataset& held, const std::string& output, const BuildOptions& options,
               const py::object& progress)
{
    std::optional<BuildMethod> suitable;
    runInterruptibly(py::none(), [&](const Progress&) { suitable = suitableMethod(held.dataset); });
    const BuildMethod method = methodOf(options, held.dataset, *suitable);
    const BuildReport report =
        finished(progress, [&](const Progress& told) { return buildModel(held.dataset, output, method, told); });
    py::dict facts;
    facts["sites"] = report.sites;
    facts["tetrahedra"] = report.tetrahedra;
    facts["inverted"] = report.inverted;
    facts["degenerate"] = report.degenerate;
    return facts;
}

/// The data as the model's builder took them, where that was in another form.
Result<Dataset> takenBy(const Model& model, const Dataset& dataset, const Progress& progress)
{
    if (dataset.domain == model.description().domain)
        return dataset;
    if (model.description().builder == "decimation")
        return takenFor(Decimation{}, dataset, progress);
    return takenFor(Refinement{}, dataset, progress);
}

py::dict statisticsOf(const ResidualStatistics& statistics)
{
    py::dict facts;
    facts["largest"] = statistics.largest;
    facts["mean"] = statistics.mean;
    facts["percentile_99"] = statistics.percentile99;
    facts["root_mean_square"] = statistics.rootMeanSquare;
    return facts;
}

py::dict levelOf(const LevelReport& level)
{
    py::dict facts;
    facts["error"] = level.asked.error;
    facts["warping"] = level.asked.warping;
    facts["sites"] = level.sites;
    facts["tetrahedra"] = level.tetrahedra;
    facts["conforming"] = level.conforming;
    facts["covers"] = level.covers;
    facts["inverted"] = level.inverted;
    facts["degenerate"] = level.degenerate;
    facts["error_statistics"] = statisticsOf(level.measured.error);
    facts["warping_statistics"] = statisticsOf(level.measured.warping);
    facts["error_in_space"] = statisticsOf(level.measured.errorInSpace);
    facts["failures"] = level.failures;
    return facts;
}

py::dict prove(const OpenedModel& opened, const HeldDataset& held, const std::vector<std::array<double, 2>>& levels,
               const py::object& progress)
{
    std::vector<Accuracy> asked;
    for (const auto& [error, warping] : levels)
        asked.push_back({error, warping});
    const VerificationReport report = finished(progress, [&](const Progress& told) -> Result<VerificationReport> {
        const auto taken = takenBy(*opened.model(), held.dataset, told.part(0, 0.05));
        if (!taken)
            return taken.error();
        return verify(*opened.model(), *taken, asked, told.part(0.05, 1));
    });
    py::dict facts;
    py::list judged;
    for (const LevelReport& level : report.levels)
        judged.append(levelOf(level));
    facts["ok"] = report.ok();
    facts["failures"] = report.failures;
    facts["levels"] = judged;
    return facts;
}

} // namespace

void bindBuilding(py::module_& module)
{
    py::class_<BuildOptions>(module, "BuildOptions")
        .def(py::init<>())
        .def_readwrite("method", &BuildOptions::method)
        .def_readwrite("error", &BuildOptions::error)
        .def_readwrite("warping", &BuildOptions::warping)
        .def_readwrite("finest", &BuildOptions::finest)
        .def_readwrite("block", &BuildOptions::block)
        .def_readwrite("order", &BuildOptions::order)
        .def_readwrite("ordered_by", &BuildOptions::orderedBy)
        .def_readwrite("weights", &BuildOptions::weights);
    module.def("build", &build);
    module.def("verify", &prove);
}

} // namespace tetra::python
