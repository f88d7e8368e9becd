// SPDX-License-Identifier: GPL-3.0-or-later
// The text of which mesh is seen: the member "mesh" of a view.
#include "core/view/view_text.h"

#include "core/history/query_words.h"

#include <algorithm>
#include <array>

namespace tetra {
namespace {

constexpr std::array focusShapeNames = {"none", "box", "sphere", "view", "isovalues", "opacity"};
constexpr std::array warpingNames = {"asError", "own", "none"};

JsonValue regionsToJson(const std::vector<MovableRegion>& regions)
{
    JsonArray list;
    for (const MovableRegion& region : regions) {
        if (const Box* const box = std::get_if<Box>(&region))
            list.push_back(JsonObject{{"least", jsonThree(box->least)}, {"largest", jsonThree(box->largest)}});
        else
            list.push_back(JsonObject{{"centre", jsonThree(std::get<Sphere>(region).centre)},
                                      {"radius", std::get<Sphere>(region).radius}});
    }
    return list;
}

void readRegions(const JsonFields& fields, std::vector<MovableRegion>& regions)
{
    if (fields.has("others"))
        regions.clear();
    for (const JsonFields& one : fields.list("others")) {
        if (one.has("radius")) {
            Sphere sphere;
            one.readThree("centre", sphere.centre);
            one.read("radius", sphere.radius);
            regions.emplace_back(sphere);
        } else {
            Box box;
            one.readThree("least", box.least);
            one.readThree("largest", box.largest);
            regions.emplace_back(box);
        }
    }
}

JsonValue focusToJson(const FocusState& focus)
{
    return JsonObject{{"shape", jsonName(focusShapeNames, focus.shape)},
                      {"centre", jsonThree(focus.centre)},
                      {"size", jsonThree(focus.size)},
                      {"radius", focus.radius},
                      {"error", focus.error},
                      {"falloff", focus.falloff},
                      {"distance", focus.distance},
                      {"valueFalloff", focus.valueFalloff},
                      {"others", regionsToJson(focus.others)},
                      {"number", focus.number}};
}

void readFocus(const JsonFields& fields, FocusState& focus)
{
    fields.readName("shape", focusShapeNames, focus.shape);
    fields.readThree("centre", focus.centre);
    fields.readThree("size", focus.size);
    fields.read("radius", focus.radius);
    fields.read("error", focus.error);
    fields.read("falloff", focus.falloff);
    fields.read("distance", focus.distance);
    fields.read("valueFalloff", focus.valueFalloff);
    readRegions(fields, focus.others);
    double number = focus.number;
    fields.read("number", number);
    focus.number = static_cast<std::uint32_t>(std::clamp(number, 0.0, static_cast<double>(mostFocusRegions)));
}

JsonValue rangeToJson(const RangeState& range)
{
    return JsonObject{{"on", range.enabled},          {"fine", range.fine},     {"coarse", range.coarse},
                      {"bornAbove", range.bornAbove}, {"bornTo", range.bornTo}, {"diedFrom", range.diedFrom},
                      {"diedTo", range.diedTo}};
}

void readRange(const JsonFields& fields, RangeState& range)
{
    fields.read("on", range.enabled);
    fields.read("fine", range.fine);
    fields.read("coarse", range.coarse);
    fields.read("bornAbove", range.bornAbove);
    fields.read("bornTo", range.bornTo);
    fields.read("diedFrom", range.diedFrom);
    fields.read("diedTo", range.diedTo);
}

JsonValue windowToJson(const WindowState& window)
{
    return JsonObject{{"on", window.enabled},
                      {"least", jsonThree(window.window.box.least)},
                      {"largest", jsonThree(window.window.box.largest)},
                      {"border", jsonName(borderWords, window.window.border)}};
}

void readWindow(const JsonFields& fields, WindowState& window)
{
    fields.read("on", window.enabled);
    fields.readThree("least", window.window.box.least);
    fields.readThree("largest", window.window.box.largest);
    fields.readName("border", borderWords, window.window.border);
}

} // namespace

void readBudget(const JsonFields& fields, std::uint64_t& budget)
{
    constexpr double mostTetrahedra = 1e15;
    auto wide = static_cast<double>(budget);
    fields.read("budget", wide);
    budget = static_cast<std::uint64_t>(std::clamp(wide, 0.0, mostTetrahedra));
}

JsonValue toJson(const QueryState& query)
{
    const WarpingChoice& warping = query.warping;
    const ValueFilter& values = query.values;
    return JsonObject{
        {"error", query.error},
        {"warping", JsonObject{{"limit", jsonName(warpingNames, warping.limit)}, {"percent", warping.percent}}},
        {"byBudget", query.byBudget},
        {"budget", query.budget},
        {"focus", focusToJson(query.focus)},
        {"range", rangeToJson(query.range)},
        {"window", windowToJson(query.window)},
        {"values", JsonObject{{"on", values.enabled}, {"least", values.least}, {"largest", values.largest}}}};
}

void readQuery(const JsonFields& fields, QueryState& query)
{
    fields.read("error", query.error);
    const JsonFields warping = fields.fields("warping");
    warping.readName("limit", warpingNames, query.warping.limit);
    warping.read("percent", query.warping.percent);
    fields.read("byBudget", query.byBudget);
    readBudget(fields, query.budget);
    readFocus(fields.fields("focus"), query.focus);
    readRange(fields.fields("range"), query.range);
    readWindow(fields.fields("window"), query.window);
    const JsonFields values = fields.fields("values");
    values.read("on", query.values.enabled);
    values.read("least", query.values.least);
    values.read("largest", query.values.largest);
}

} // namespace tetra
