// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/serve/mesh_facts.h"

#include "core/data/value_scale.h"
#include "core/history/error_meaning.h"
#include "core/history/query_words.h"
#include "core/verify/verify_mesh.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>

namespace tetra {
namespace {

using Facts = std::vector<std::pair<std::string, std::variant<double, std::string>>>;

/// A number where the field is one, else its text.
void addField(Facts& facts, const std::string& name, const ErrorField& field, double scale)
{
    if (field.isConstant())
        facts.emplace_back(name, keptPercent(field.bounds().minimum, scale));
    else
        facts.emplace_back(name + "_field", toText(field));
}

JsonObject sizeFigures(const MeshSize& size)
{
    return {{"error", size.error}, {"warping", size.warping}, {"sites", size.sites}, {"tetrahedra", size.tetrahedra}};
}

/// Six digits of a number, as many as a place needs to be found.
std::string shortNumber(double number)
{
    constexpr int digits = 6;
    std::array<char, 32> text{}; // -1.23457e-308 has 13 characters
    const auto [end, error] =
        std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::general, digits);
    return {text.data(), end};
}

/// Whether only some of the lives are asked for.
bool isLimited(const ValueRange& lives)
{
    constexpr double all = std::numeric_limits<double>::infinity();
    return lives.minimum != -all || lives.maximum != all;
}

} // namespace

Facts meshFacts(const Model& model, const MeshQuery& query, const ExtractedMesh& mesh,
                const std::optional<double>& errorInSpace)
{
    Facts facts = {{"model", model.path().filename().string()}, {"source", model.description().sourceName}};
    if (!model.description().valueName.empty())
        facts.emplace_back("array", model.description().valueName);
    if (holdsLogarithms(model.description().parameters))
        facts.emplace_back(std::string(scaleFact), std::string(logarithmFact));
    if (!model.description().lengthUnit.empty())
        facts.emplace_back("unit", model.description().lengthUnit);
    if (query.range) {
        // Of a model at a server the sizes are known only about.
        const auto errorOf = [&model](const Accuracy& end) {
            return model.elsewhere() != nullptr ? end.error : meshSizeAt(model, end).error;
        };
        const double one = errorOf(query.range->one), other = errorOf(query.range->other);
        facts.emplace_back("coarsest_error", std::max(one, other));
        facts.emplace_back("finest_error", std::min(one, other));
        addErrorKind(facts, errorMeaning(model.description(), query), errorInSpace);
        return facts;
    }
    addField(facts, "error", query.error, mesh.scale);
    if (model.description().warpingWeight > 0)
        addField(facts, "warping", query.warping, mesh.scale);
    facts.emplace_back("error_scale", mesh.scale);
    if (mesh.reached) {
        facts.emplace_back("reached_error", mesh.reached->error);
        if (model.description().warpingWeight > 0)
            facts.emplace_back("reached_warping", mesh.reached->warping);
    }
    addErrorKind(facts, errorMeaning(model.description(), query), errorInSpace);
    return facts;
}

JsonObject meshFigures(const Model& model, const MeshQuery& query, const ExtractedMesh& mesh)
{
    JsonObject figures{{"sites", mesh.mesh.positions.size()},
                       {"tetrahedra", mesh.mesh.tetrahedra.size()},
                       {"error_kind", wordOf(errorKindWords, errorMeaning(model.description(), query))}};
    if (query.range) {
        if (model.elsewhere() != nullptr) // the sizes of its meshes are known only about
            return figures;
        MeshSize coarse = meshSizeAt(model, query.range->one), fine = meshSizeAt(model, query.range->other);
        if (coarse.sites > fine.sites)
            std::swap(coarse, fine);
        figures["coarse"] = sizeFigures(coarse);
        figures["fine"] = sizeFigures(fine);
        return figures;
    }
    const Accuracy kept = keptEverywhere(query, mesh.scale);
    const bool warps = model.description().warpingWeight > 0;
    if (mesh.reached) {
        figures["reached_error"] = mesh.reached->error;
        figures["reached_warping"] = warps ? mesh.reached->warping : 0.0;
        if (holdsLogarithms(model.description().parameters))
            figures["reached_factor"] = factorOf(mesh.reached->error, model.description().range);
    }
    figures["error"] = kept.error;
    figures["warping"] = warps ? kept.warping : 0.0;
    figures["scale"] = mesh.scale;
    figures["method"] = wordOf(methodWords, mesh.method);
    figures["kept_sites"] = mesh.keptSites;
    figures["kept_tetrahedra"] = mesh.keptTetrahedra;
    figures["whole_sites"] = mesh.wholeSites;
    figures["whole_tetrahedra"] = mesh.wholeTetrahedra;
    return figures;
}

Status checkNotEmpty(const MeshQuery& query, const Model& model, const TetrahedralMesh& mesh)
{
    if (!mesh.tetrahedra.empty())
        return {};
    const ModelDescription& data = model.description();
    const auto place = [](const Eigen::Vector3d& p) {
        return "(" + shortNumber(p[0]) + ", " + shortNumber(p[1]) + ", " + shortNumber(p[2]) + ")";
    };
    const bool isOfLives = query.range && (isLimited(query.range->births) || isLimited(query.range->deaths));
    const std::string asked = isOfLives               ? "appears and disappears at such errors there"
                              : !query.window         ? "has such values"
                              : !query.values.empty() ? "is in that crop box with such values"
                                                      : "is in that crop box";
    return Error{ErrorKind::WrongUsage, "No tetrahedron " + asked + ", so nothing was written. The data lie between " +
                                            place(data.bounds.min()) + " and " + place(data.bounds.max()) +
                                            ", with values from " + shortNumber(data.range.minimum) + " to " +
                                            shortNumber(data.range.maximum) + "."};
}

} // namespace tetra
