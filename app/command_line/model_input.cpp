// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/model_input.h"

#include "app/command_line/server_mesh.h"
#include "app/command_line/table.h"
#include "core/base/text.h"
#include "core/remote/address.h"

#include <tan/packed.h>

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

namespace tetra {
namespace {

/// Fetched unasked.
constexpr std::uint64_t aMoment = 32 << 20;

/// That some part of a mesh is to keep.
std::optional<Accuracy> finestAsked(const MeshQuery& query, const Arguments& arguments)
{
    if (query.range)
        return Accuracy{std::min(query.range->one.error, query.range->other.error),
                        std::min(query.range->one.warping, query.range->other.warping)};
    // A mesh that points are inserted into needs all samples, and one is held against the finest.
    if (query.method == VariableMethod::Insertion || arguments.has("deviation"))
        return std::nullopt;
    if (query.budget && !arguments.has("error"))
        return std::nullopt;
    return Accuracy{query.error.bounds().minimum, query.warping.bounds().minimum};
}

/// Whether nothing but a budget says how fine the mesh is.
bool isBudgetAlone(const MeshQuery& query, const Arguments& arguments)
{
    constexpr std::array<std::string_view, 6> others = {"error", "warping", "field", "focus", "lens", "method"};
    return query.budget && std::ranges::none_of(others, [&](std::string_view option) { return arguments.has(option); });
}

/// As much of a packed model, or one on a server, as has a mesh beyond the budget, so that the one before it is there.
Result<FoundModel> openForBudget(const std::string& place, std::uint64_t budget, OpenOptions options,
                                 const Progress& progress)
{
    constexpr double frontEnd = 0.02;
    constexpr double usually = 5, tooFew = 1.05; // tetrahedra a site; how much beyond what was found to be too few
    const auto facts = modelFacts(place, progress.part(0, frontEnd), options.token);
    if (!facts)
        return facts.error();
    const auto asked = static_cast<double>(budget);
    double sites = asked / usually, done = frontEnd;
    for (const LevelInFile& level : std::span(facts->levels).first(facts->levels.size() - 1)) {
        if (level.bytes > options.mostBytes)
            break;
        if (level.sites <= sites)
            continue;
        options.accuracy = Accuracy{level.error, level.warping};
        const double end = (done + 1) / 2;
        auto found = openModel(place, options, progress.part(std::exchange(done, end), end));
        if (!found)
            return found;
        const MeshSize finest = meshSizeAt(*found->model, {.error = 0, .warping = 0});
        if (finest.tetrahedra > budget)
            return found;
        sites = tooFew * finest.sites * asked / static_cast<double>(std::max<std::uint64_t>(finest.tetrahedra, 1));
    }
    options.accuracy.reset();
    return openModel(place, options, progress.part(done, 1));
}

bool saysHowAccurate(const Arguments& arguments)
{
    constexpr std::array<std::string_view, 6> options = {"error", "warping", "field", "focus", "range", "method"};
    return std::ranges::any_of(options, [&](std::string_view option) { return arguments.has(option); });
}

/// What all that opens a model is told: the token of its server, if one was given.
Result<OpenOptions> optionsWithToken(const Arguments& arguments, const std::filesystem::path& place)
{
    auto token = tokenOption(arguments, place);
    if (!token)
        return token.error();
    OpenOptions options;
    options.token = *std::move(token);
    return options;
}

} // namespace

std::string modelExplanation()
{
    return "The model, packed or not: a file, or its address on a server (http:// or https://).";
}

std::string shownInput(const std::string& place)
{
    return isAddress(place) ? shownAddress(placeOf(place, false)) : visibleText(place);
}

bool isAtHand(const std::filesystem::path& place)
{
    return !isAddress(place.string()) && !isPacked(place);
}

Result<FoundModel> openInput(const Invocation& invocation, const std::filesystem::path& place, const MeshQuery& query,
                             const Progress& progress)
{
    const bool isAtServer = invocation.arguments.has("at-server");
    if (isAtServer && !isAddress(place.string()))
        return Error{ErrorKind::WrongUsage, "'--at-server' needs the address of a model that 'tan serve' offers, "
                                            "http://HOST:PORT/NAME.tan, and '" +
                                                place.string() + "' is not one."};
    const auto withToken = optionsWithToken(invocation.arguments, place);
    if (!withToken)
        return withToken.error();
    OpenOptions options = *withToken;
    options.accuracy = finestAsked(query, invocation.arguments);
    const bool needsAll = invocation.arguments.has("deviation");
    if (isAddress(place.string()) && !saysHowAccurate(invocation.arguments) && !needsAll)
        options.mostBytes = aMoment;
    if (isBudgetAlone(query, invocation.arguments) && !needsAll && !isAtServer && !isAtHand(place))
        return openForBudget(place.string(), *query.budget, std::move(options), progress);
    return openModel(isAtServer ? placeOf(place.string(), true) : place.string(), options, progress);
}

std::vector<Option> serverOptions()
{
    return {{.name = "at-server",
             .placeholder = "",
             .explanation = "MODEL is http://HOST:PORT/NAME.tan, and 'tan serve' there finds the mesh: only that is "
                            "sent."},
            tokenFileOption()};
}

Option tokenFileOption()
{
    return {.name = "token-file",
            .placeholder = "FILE",
            .explanation = "For a model on a server: a file whose first line is the server's access token."};
}

Result<std::string> tokenOption(const Arguments& arguments, const std::filesystem::path& place)
{
    const auto file = arguments.value("token-file");
    if (!file)
        return std::string();
    if (!isAddress(place.string()))
        return Error{ErrorKind::WrongUsage,
                     "'--token-file' is for models on a server, and '" + place.string() + "' is a file. Leave it out."};
    return tokenIn(*file);
}

Result<FoundModel> openSessionInput(const Invocation& invocation, const std::filesystem::path& place,
                                    const Progress& progress)
{
    const auto options = optionsWithToken(invocation.arguments, place);
    if (!options)
        return options.error();
    return openModel(place.string(), *options, progress);
}

Result<FoundModel> openWholeInput(const Invocation& invocation, const std::filesystem::path& place,
                                  const Progress& progress)
{
    auto options = optionsWithToken(invocation.arguments, place);
    if (!options)
        return options.error();
    options->afresh = true;
    return openModel(placeOf(place.string(), false), *options, progress);
}

void tellPart(const FoundModel& found, Outcome& outcome)
{
    if (found.isWhole)
        return;
    const std::uint32_t sites = found.model->siteCount();
    outcome.figures["read_part"] = JsonObject{
        {"sites", sites}, {"of_sites", found.sitesOfWhole}, {"bytes", found.readBytes}, {"of_bytes", found.fileBytes}};
    outcome.text += "read of the model: " + std::to_string(sites) + " of " + std::to_string(found.sitesOfWhole) +
                    " sites, " + byteText(found.readBytes) + " of " + byteText(found.fileBytes) +
                    ", as much as the mesh needs\n";
}

} // namespace tetra
