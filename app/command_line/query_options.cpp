// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/query_options.h"

#include "app/command_line/option_values.h"
#include <tan/query.h>

#include <algorithm>
#include <utility>

namespace tetra {
namespace {

std::vector<Option> focusOptions()
{
    return {{.name = "focus",
             .placeholder = "REGION",
             .explanation = "Where the mesh is finer: box:x0,y0,z0,x1,y1,z1 or sphere:x,y,z,r, in the data's own "
                            "coordinates. Where several overlap, the smallest error counts.",
             .repeatable = true},
            {.name = "focus-error",
             .placeholder = "PERCENT",
             .explanation = "The largest error within the focus; --error holds elsewhere."},
            {.name = "focus-warping",
             .placeholder = "PERCENT",
             .explanation = "Likewise the largest warping; --warping holds elsewhere.",
             .byDefault = "the same number as the focus error, or the warping elsewhere if that is smaller"},
            {.name = "falloff",
             .placeholder = "LENGTH",
             .explanation = "The distance from the focus over which the error grows from the inner to the outer one.",
             .byDefault = "0, a sharp border"}};
}

/// How accurate one mesh is, and where.
std::vector<Option> fieldOptions()
{
    Option error = errorOption();
    error.byDefault += ", or with --budget and without a focus 0";
    std::vector<Option> options = {error, warpingOption()};
    std::ranges::move(focusOptions(), std::back_inserter(options));
    options.push_back(
        {.name = "field",
         .placeholder = "TEXT",
         .explanation = "Instead of --error and --focus: the largest error at each place as an expression, such as "
                        "'min(sphere(5,5,5, 2; 0.5, 4, 1), isovalues(100; 0.1, 4, 20))'; the manual explains it under "
                        "'The command line'. Unless --warping is given, the warping is limited by the same numbers."});
    options.push_back({.name = "budget",
                       .placeholder = "N",
                       .explanation = "At most N tetrahedra; all requested errors and warpings are scaled up by the "
                                      "smallest common factor that allows it."});
    options.push_back({.name = "method",
                       .placeholder = "NAME",
                       .explanation = "How a mesh of varying accuracy, or with separate limits for error and warping, "
                                      "is found: closed-set, insertion (into the coarse mesh: one sharp focus in a "
                                      "lattice, any in a grid), or automatic, the smaller one.",
                       .byDefault = "automatic"});
    return options;
}

/// Many meshes in place of one.
std::vector<Option> rangeOptions()
{
    return {
        {.name = "range",
         .placeholder = "A,B",
         .explanation = "Instead of --error: all tetrahedra that are in the mesh of some error from A to B, each with "
                        "the errors at which it appears and disappears: the arrays birth_error and death_error."},
        {.name = "births",
         .placeholder = "LO,HI",
         .explanation = "With --range: only tetrahedra that appear at an error above LO and up to HI; HI may be inf."},
        {.name = "deaths",
         .placeholder = "LO,HI",
         .explanation = "With --range: only tetrahedra that are replaced at an error from LO to HI."}};
}

std::vector<Option> partOptions()
{
    return {{.name = "window",
             .placeholder = "X0,Y0,Z0,X1,Y1,Z1",
             .explanation =
                 "Only what lies in this crop box, given by two opposite corners in the data's own coordinates."},
            {.name = "border",
             .placeholder = "KIND",
             .explanation = "Tetrahedra on the border of the crop box: intersecting keeps those that touch it, "
                            "contained only those inside, clipped cuts them.",
             .byDefault = "intersecting"},
            {.name = "values",
             .placeholder = "LO,HI",
             .explanation = "Only tetrahedra that can contain a value from LO to HI.",
             .repeatable = true}};
}

} // namespace

std::vector<Option> queryOptions()
{
    std::vector<Option> all;
    for (auto options : {fieldOptions(), rangeOptions(), partOptions()})
        std::ranges::move(options, std::back_inserter(all));
    return all;
}

bool asksForMesh(const Arguments& arguments)
{
    return std::ranges::any_of(
        queryOptions(), [&](const Option& option) { return option.name != "warping" && arguments.has(option.name); });
}

PresentView anyView()
{
    return {Eigen::Vector3d(0, 0, 0), {0}, {{0, 1}}};
}

QueryWords queryWords(const Arguments& arguments)
{
    std::vector<QueryWords::Word> words;
    for (const Option& option : queryOptions())
        for (const std::string& value : arguments.values(option.name))
            words.emplace_back(option.name, value);
    return QueryWords(std::move(words));
}

Result<MeshQuery> queryOf(const Arguments& arguments, const PresentView& present)
{
    return queryWords(arguments).query("--", present);
}

} // namespace tetra
