// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/history/query/questions.h"

#include "core/history/query/history_part.h"
#include "core/verify/curvilinear_cells.h"

#include <tan/query.h>

#include <array>
#include <optional>
#include <vector>

namespace tetra {

namespace {

template <class Array> void appendArray(std::string& text, const Array& array)
{
    const auto bytes = std::as_bytes(std::span(array));
    text.append(reinterpret_cast<const char*>(bytes.data()), bytes.size()).append("|");
}

std::string contentOf(const ExtractedMesh& mesh)
{
    std::string text = meshContent(mesh.mesh);
    appendArray(text, mesh.sites);
    appendArray(text, mesh.points);
    appendArray(text, mesh.birthErrors);
    appendArray(text, mesh.deathErrors);
    return text + std::to_string(mesh.wholeSites) + " " + std::to_string(mesh.wholeTetrahedra) + " " +
           std::to_string(mesh.scale);
}

/// One after the other of one extractor.
Question meshesOf(std::vector<MeshQuery> queries)
{
    return [queries = std::move(queries)](const ModelPointer& model) -> Result<std::string> {
        MeshExtractor extractor(model);
        std::string text;
        for (const MeshQuery& query : queries) {
            const auto mesh = extractor.extract(query);
            if (!mesh)
                return mesh.error();
            text += contentOf(**mesh);
        }
        return text;
    };
}

MeshQuery uniformQuery(double error, std::optional<std::uint64_t> budget = {})
{
    MeshQuery query;
    query.error = error;
    query.warping = anyWarping;
    query.budget = budget;
    return query;
}

MeshQuery fieldQuery(const ErrorField& field, VariableMethod method, std::optional<std::uint64_t> budget = {})
{
    MeshQuery query = uniformQuery(0, budget);
    query.error = field;
    query.method = method;
    return query;
}

Result<std::string> answerOfPrefix(const ModelPointer& model, double error)
{
    const MeshSize size = meshSizeAt(*model, {error});
    const auto mesh = extractPrefix(*model, size.sites);
    return mesh ? Result<std::string>(meshContent(*mesh)) : Result<std::string>(mesh.error());
}

Result<std::string> answerOfPart(const ModelPointer& model, std::span<const ValueRange> values,
                                 const std::optional<Window>& window)
{
    MeshQuery query{.window = window, .range = LifeRange{{20}, {3}}};
    query.values.assign(values.begin(), values.end());
    const auto part = MeshExtractor(model).extract(query);
    return part ? Result<std::string>(contentOf(**part)) : Result<std::string>(part.error());
}

} // namespace

std::string meshContent(const TetrahedralMesh& mesh)
{
    std::string text;
    appendArray(text, mesh.positions);
    appendArray(text, mesh.values);
    appendArray(text, mesh.tetrahedra);
    return text;
}

/// Every kind of question that the library answers, about a model with these bounds.
std::map<std::string, Question> questionsAbout(const ModelDescription& model)
{
    const Eigen::AlignedBox3d& bounds = model.bounds;
    const Eigen::Vector3d centre = bounds.center();
    const ErrorField focus(SpaceRamp{Box{bounds.min(), centre}, 1, 30, 0});
    const ErrorField graded(
        SpaceRamp{Sphere{centre, 0.2 * bounds.diagonal().norm()}, 2, 40, 0.3 * bounds.diagonal().norm()});
    const double middle = (model.range.minimum + model.range.maximum) / 2;
    const ErrorField nearValue = ErrorField::nearValues(std::array{middle}, 1, 40, 0.1 * model.range.extent());
    const Window window{Box{bounds.min(), centre}, WindowBorder::Clipped};
    const std::vector<ValueRange> values{{middle, model.range.maximum}};
    MeshQuery inWindow = uniformQuery(4);
    inWindow.window = window;
    inWindow.values = values;
    return {
        {"levels",
         [](const ModelPointer& asked) -> Result<std::string> {
             const std::string text = levelsAsCsv(*asked, std::vector<Accuracy>{{50}, {10}, {2}, {0}});
             const Status intact = asked->checkIntact();
             return intact ? Result<std::string>(text) : Result<std::string>(intact.error());
         }},
        {"inverted tetrahedra",
         [](const ModelPointer& asked) -> Result<std::string> {
             const std::array sites{asked->siteCount() / 2, asked->siteCount()};
             const auto counted = countInverted(*asked, sites);
             if (!counted)
                 return counted.error();
             std::string text;
             appendArray(text, *counted);
             return text;
         }},
        {"coarse prefix", [](const ModelPointer& asked) { return answerOfPrefix(asked, 25); }},
        {"all sites", [](const ModelPointer& asked) { return answerOfPrefix(asked, 0); }},
        {"range", [](const ModelPointer& asked) { return answerOfPart(asked, {}, {}); }},
        {"range in a window",
         [=](const ModelPointer& asked) {
             return answerOfPart(asked, values, Window{window.box, WindowBorder::Contained});
         }},
        {"finer and coarser", meshesOf({uniformQuery(12), uniformQuery(8), uniformQuery(10), uniformQuery(30)})},
        {"budget", meshesOf({uniformQuery(0, 400)})},
        {"window", meshesOf({inWindow})},
        {"closed set", meshesOf({uniformQuery(3), fieldQuery(focus, VariableMethod::ClosedSet)})},
        {"graded closed set", meshesOf({fieldQuery(graded, VariableMethod::ClosedSet)})},
        {"near a value", meshesOf({fieldQuery(nearValue, VariableMethod::Automatic)})},
        {"closed set in a budget", meshesOf({fieldQuery(graded, VariableMethod::ClosedSet, 500)})},
        {"insertion", meshesOf({fieldQuery(focus, VariableMethod::Insertion)})},
        {"insertion in a budget", meshesOf({fieldQuery(focus, VariableMethod::Insertion, 600)})},
    };
}

} // namespace tetra
