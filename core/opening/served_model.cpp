// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/opening/served_model.h"

#include "core/base/json.h"
#include "core/history/query_words.h"
#include "core/packed/packed_mesh.h"
#include "core/remote/fetch.h"
#include "core/remote/remote_file.h"
#include "core/serve/served_query.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace tetra {
namespace {

Message tokenWanted(const std::string& shownAddress)
{
    return Message::say("The server of '%1' requires a token. Give the one issued by its operator; on the command line "
                        "with '--token-file'.",
                        shownAddress);
}

constexpr std::uint64_t mostFoundTetrahedra = std::uint64_t(1) << 30;
/// What stands at the front of a model's file is told within milliseconds.
constexpr FetchLimits limitsOfFacts{"application/json", 64 << 10};
/// For its sizes a model is opened, and may have to be unpacked.
constexpr FetchLimits limitsOfSizes{"application/json", 4 << 20, longestThinking};

std::string_view textIn(const FetchedAnswer& answer)
{
    return {reinterpret_cast<const char*>(answer.content.data()), answer.content.size()};
}

template <class Number> std::optional<Number> numberIn(const JsonValue* value)
{
    const JsonValue::Number* const number = value != nullptr ? value->number() : nullptr;
    return number != nullptr ? parseNumber<Number>(number->text) : std::nullopt;
}

template <class Number> std::optional<Number> numberIn(const JsonValue& object, std::string_view name)
{
    return numberIn<Number>(object.find(name));
}

/// What a server says that does not answer as asked.
Error saidOtherwise(const std::string& address, const FetchedAnswer& answer)
{
    constexpr std::size_t mostSaid = 1000;
    if (answer.status == 401)
        return {ErrorKind::WrongUsage, tokenWanted(shownAddress(address)), shownAddress(address), Credential::Token};
    const auto json = parseJson(textIn(answer));
    const JsonValue* const said = json ? json->find("error") : nullptr;
    if (answer.status == 200 || said == nullptr || said->string() == nullptr)
        return {ErrorKind::BadInput,
                Message::say("'%1' does not extract meshes (status %2): only a TAn server ('tan serve') of this "
                             "version does. Download the model from there instead.",
                             shownAddress(address), answer.status)};
    const ErrorKind kind = answer.status == 400 ? ErrorKind::WrongUsage
                           : answer.status == 413 || answer.status == 429 || answer.status >= 503
                               ? ErrorKind::OutOfResource
                               : ErrorKind::BadInput;
    return {kind,
            Message::say("The server of '%1' says: %2", shownAddress(address), said->string()->substr(0, mostSaid))};
}

Error saysNonsense(const std::string& address)
{
    return {ErrorKind::BadInput,
            Message::say("What '%1' says of its model cannot be read. The server may run another version of TAn.",
                         shownAddress(address))};
}

/// More than any model has, or less.
constexpr std::uint32_t leastServedSites = 4, mostServedSites = 0xfffffffe;
constexpr std::uint64_t mostServedTetrahedra = std::uint64_t(1) << 40, mostServedBytes = std::uint64_t(1) << 44;

Error saysTheImpossible(const std::string& address, const Message& what)
{
    return {ErrorKind::BadInput,
            Message::say("What '%1' says of its model is impossible: %2. Tell its operator, or download the model and "
                         "check it with 'tan verify'.",
                         shownAddress(address), what),
            shownAddress(address)};
}

/// Whether a model can be so large: else what is wrong with it.
std::optional<Message> impossibleModel(std::uint32_t sites, std::uint64_t tetrahedra, std::uint64_t bytes)
{
    if (sites < leastServedSites || sites > mostServedSites)
        return Message::say("it has %1 sites", sites);
    if (tetrahedra == 0 || tetrahedra > mostServedTetrahedra)
        return Message::say("it has %1 tetrahedra", tetrahedra);
    if (bytes == 0 || bytes > mostServedBytes)
        return Message::say("it has %1 bytes", bytes);
    return {};
}

/// The same of its meshes, the first of which is the coarsest one.
std::optional<Message> impossibleMesh(const WholeSizes& sizes)
{
    const MeshSize* before = nullptr;
    for (const MeshSize& mesh : sizes.meshes) {
        if (mesh.sites < leastServedSites || mesh.sites > sizes.sites)
            return Message::say("a mesh has %1 of its %2 sites", mesh.sites, sizes.sites);
        if (mesh.tetrahedra == 0 || mesh.tetrahedra > sizes.tetrahedra)
            return Message::say("a mesh has %1 of its %2 tetrahedra", mesh.tetrahedra, sizes.tetrahedra);
        if (!(mesh.error >= 0) || !std::isfinite(mesh.error) || !(mesh.warping >= 0) || !std::isfinite(mesh.warping))
            return Message::say("a mesh has the error %1 % and the warping %2 %", formatNumber(mesh.error),
                                formatNumber(mesh.warping));
        if (before != nullptr && mesh.sites <= before->sites)
            return Message::say("a mesh with %1 sites comes before one with %2", before->sites, mesh.sites);
        before = &mesh;
    }
    return {};
}

/// The same of a mesh that it sent.
std::optional<Message> impossibleAnswer(const ExtractedMesh& mesh, const UnpackedMesh& sent, const WholeSizes& whole)
{
    const auto isLife = [](float error) { return error >= 0; };      // no NaN
    const bool isOfSites = mesh.method != VariableMethod::Insertion; // which takes points that are no sites, too
    if (mesh.keptSites > mesh.wholeSites || (isOfSites && mesh.wholeSites > whole.sites))
        return Message::say("a mesh has %1 of %2 sites, and the model %3", mesh.keptSites, mesh.wholeSites,
                            whole.sites);
    if (mesh.keptTetrahedra > mesh.wholeTetrahedra || (isOfSites && mesh.wholeTetrahedra > whole.tetrahedra))
        return Message::say("a mesh has %1 of %2 tetrahedra, and the model %3", mesh.keptTetrahedra,
                            mesh.wholeTetrahedra, whole.tetrahedra);
    if (!std::isfinite(mesh.scale) || !(mesh.scale >= 1))
        return Message::say("a mesh keeps %1 times the error", formatNumber(mesh.scale));
    if (const auto& has = mesh.reached; has && (!std::isfinite(has->error) || !(has->error >= 0) ||
                                                !std::isfinite(has->warping) || !(has->warping >= 0)))
        return Message::say("a mesh has the error %1 % and the warping %2 %", formatNumber(has->error),
                            formatNumber(has->warping));
    if (!std::ranges::all_of(sent.birthErrors, isLife) || !std::ranges::all_of(sent.deathErrors, isLife))
        return Message::say("a tetrahedron exists at errors that are not numbers of at least 0");
    return {};
}

/// An answer in JSON.
Result<JsonValue> askedFor(const std::string& address, std::string_view question, const std::string& token,
                           const FetchLimits& limits, ServerConnection& connection, const Progress& progress)
{
    const auto answer = connection.fetch(address + "?" + std::string(question), token, limits, progress);
    if (!answer)
        return answer.error();
    if (answer->status != 200 || answer->contentType != "application/json")
        return saidOtherwise(address, *answer);
    auto json = parseJson(textIn(*answer));
    return json ? std::move(json) : saysNonsense(address);
}

/// [sites, tetrahedra, error, warping]
std::optional<MeshSize> sizeIn(const JsonValue& entry)
{
    constexpr std::size_t numbers = 4;
    const JsonArray* const array = entry.array();
    if (array == nullptr || array->size() != numbers)
        return {};
    const auto sites = numberIn<std::uint32_t>(&(*array)[0]);
    const auto tetrahedra = numberIn<std::uint64_t>(&(*array)[1]);
    const auto error = numberIn<double>(&(*array)[2]), warping = numberIn<double>(&(*array)[3]);
    if (!sites || !tetrahedra || !error || !warping)
        return {};
    return MeshSize{*sites, *tetrahedra, *error, *warping};
}

std::optional<WholeSizes> sizesIn(const JsonValue& told)
{
    WholeSizes sizes;
    const auto sites = numberIn<std::uint32_t>(told, "sites");
    const auto tetrahedra = numberIn<std::uint64_t>(told, "tetrahedra");
    const auto bytes = numberIn<std::uint64_t>(told, "bytes");
    const JsonValue* const meshes = told.find("meshes");
    if (!sites || !tetrahedra || !bytes || meshes == nullptr || meshes->array() == nullptr || meshes->array()->empty())
        return {};
    sizes.sites = *sites;
    sizes.tetrahedra = *tetrahedra;
    sizes.bytes = *bytes;
    for (const JsonValue& entry : *meshes->array()) {
        const auto size = sizeIn(entry);
        if (!size)
            return {};
        sizes.meshes.push_back(*size);
    }
    return sizes;
}

/// What is told of a mesh beside it.
bool takeFigures(const JsonValue& told, ExtractedMesh& mesh)
{
    const JsonValue* const figures = told.find("mesh");
    if (figures == nullptr)
        return false;
    const auto wholeSites = numberIn<std::uint32_t>(*figures, "whole_sites");
    const auto wholeTetrahedra = numberIn<std::uint64_t>(*figures, "whole_tetrahedra");
    const auto keptSites = numberIn<std::uint32_t>(*figures, "kept_sites");
    const auto keptTetrahedra = numberIn<std::uint64_t>(*figures, "kept_tetrahedra");
    const auto scale = numberIn<double>(*figures, "scale");
    const JsonValue* const method = figures->find("method");
    const JsonValue* const overlaps = told.find("overlaps");
    if (!wholeSites || !wholeTetrahedra || !keptSites || !keptTetrahedra || !scale || method == nullptr ||
        method->string() == nullptr || overlaps == nullptr)
        return false;
    const auto known = choiceOf<VariableMethod>(methodWords, *method->string());
    const bool* const isOver = std::get_if<bool>(&overlaps->content);
    if (!known || isOver == nullptr)
        return false;
    mesh.wholeSites = *wholeSites;
    mesh.wholeTetrahedra = *wholeTetrahedra;
    mesh.keptSites = *keptSites;
    mesh.keptTetrahedra = *keptTetrahedra;
    mesh.scale = *scale;
    const auto error = numberIn<double>(*figures, "reached_error");
    const auto warping = numberIn<double>(*figures, "reached_warping");
    if (error && warping)
        mesh.reached = Accuracy{*error, *warping};
    mesh.method = *known;
    mesh.overlaps = *isOver;
    return true;
}

/// The answer to a question for a mesh.
Result<UnpackedMesh> fetchMesh(const std::string& address, const std::string& question, const std::string& token,
                               ServerConnection& connection, const Progress& progress)
{
    constexpr double fetchedAt = 0.7;
    const auto answer =
        connection.fetch(address + "?" + question, token, limitsOfMesh(packedMeshType), progress.part(0, fetchedAt));
    if (!answer)
        return answer.error();
    if (answer->status != 200 || answer->contentType != packedMeshType)
        return saidOtherwise(address, *answer);
    return unpackMesh(answer->content, mostFoundTetrahedra, progress.part(fetchedAt, 1));
}

/// And near enough that what is reckoned with coordinates stays finite.
bool isFinite(const TetrahedralMesh& mesh)
{
    return std::ranges::all_of(mesh.positions, isUsablePlace) &&
           std::ranges::all_of(mesh.values, [](float value) { return std::isfinite(value); });
}

} // namespace

Result<ServerOffer> askServer(const std::string& address, const std::string& token, const Progress& progress)
{
    const std::string place = placeOf(address, false);
    const auto answer = fetchOnce(place + "?" + std::string(aboutQuestion), token, limitsOfFacts, progress);
    constexpr int unauthorized = 401;
    ServerOffer offer;
    if (!answer && answer.error().kind == ErrorKind::OutOfResource)
        return offer; // the file, whatever is asked
    if (!answer)
        return answer.error();
    const auto told = parseJson(textIn(*answer));
    offer.wantsToken = told && answer->status == unauthorized && told->find("error") != nullptr;
    if (told && answer->status == 404 && told->find("error") != nullptr)
        return saidOtherwise(place, *answer);
    if (!told || answer->status != 200)
        return offer;
    const auto bytes = numberIn<std::uint64_t>(*told, "bytes");
    const auto unpacked = numberIn<std::uint64_t>(*told, "unpacked_bytes");
    const auto sites = numberIn<std::uint32_t>(*told, "sites");
    const JsonValue* const form = told->find("form");
    if (!bytes || !unpacked || !sites || form == nullptr || form->string() == nullptr)
        return offer;
    for (const std::uint64_t size : {*bytes, *unpacked})
        if (const auto wrong = impossibleModel(*sites, 1, size))
            return saysTheImpossible(place, *wrong);
    return ServerOffer{.findsMeshes = true,
                       .form = *form->string() == "packed" ? ModelForm::Packed : ModelForm::Explicit,
                       .fileBytes = *bytes,
                       .unpackedBytes = *unpacked,
                       .sites = *sites};
}

ServedModel::ServedModel(std::string address, std::string token, std::string tag, bool warps, WholeSizes sizes,
                         std::unique_ptr<ServerConnection> connection)
    : WholeElsewhere(std::move(sizes)), address_(std::move(address)), token_(std::move(token)), tag_(std::move(tag)),
      warps_(warps), connection_(std::move(connection))
{
}

Result<std::shared_ptr<const ServedModel>> ServedModel::ask(const std::string& address, const std::string& token,
                                                            const Progress& progress)
{
    auto connection = std::make_unique<ServerConnection>();
    const auto told = askedFor(address, sizesQuestion, token, limitsOfSizes, *connection, progress);
    if (!told)
        return told.error();
    auto sizes = sizesIn(*told);
    const JsonValue* const tag = told->find("tag");
    const JsonValue* const warps = told->find("warps");
    const bool* const isWarping = warps != nullptr ? std::get_if<bool>(&warps->content) : nullptr;
    if (!sizes || tag == nullptr || tag->string() == nullptr || isWarping == nullptr)
        return saysNonsense(address);
    if (const auto wrong = impossibleModel(sizes->sites, sizes->tetrahedra, sizes->bytes))
        return saysTheImpossible(address, *wrong);
    if (const auto wrong = impossibleMesh(*sizes))
        return saysTheImpossible(address, *wrong);
    return std::make_shared<const ServedModel>(address, token, *tag->string(), *isWarping, *std::move(sizes),
                                               std::move(connection));
}

Result<std::shared_ptr<const ExtractedMesh>> ServedModel::extract(const MeshQuery& query,
                                                                  const Progress& progress) const
{
    const auto question = QueryWords::of(query, warps_);
    if (!question)
        return question.error();
    auto unpacked = fetchMesh(address_, "empty=yes&" + question->toUrl(), token_, *connection_, progress);
    if (!unpacked)
        return unpacked.error();
    const auto told = parseJson(unpacked->facts);
    const JsonValue* const tag = told ? told->find("tag") : nullptr;
    auto mesh = std::make_shared<ExtractedMesh>();
    if (tag == nullptr || tag->string() == nullptr || !takeFigures(*told, *mesh) || !isFinite(unpacked->mesh))
        return saysNonsense(address_);
    if (*tag->string() != tag_)
        return Error{ErrorKind::BadInput,
                     Message::say("The model '%1' was changed on its server. Open it again.", shownAddress(address_))};
    if (const auto wrong = impossibleAnswer(*mesh, *unpacked, sizes()))
        return saysTheImpossible(address_, *wrong);
    mesh->mesh = std::move(unpacked->mesh);
    mesh->sites.resize(mesh->mesh.positions.size());
    std::ranges::fill(mesh->sites, ExtractedMesh::noSite);
    mesh->birthErrors = std::move(unpacked->birthErrors);
    mesh->deathErrors = std::move(unpacked->deathErrors);
    return std::shared_ptr<const ExtractedMesh>(std::move(mesh));
}

Result<UnpackedMesh> servedMesh(const std::string& address, const std::string& question, const std::string& token,
                                const Progress& progress)
{
    ServerConnection connection;
    auto mesh = fetchMesh(address, question, token, connection, progress);
    if (mesh && !isFinite(mesh->mesh))
        return saysNonsense(address);
    return mesh;
}

bool wantsToken(const Error& error)
{
    return error.wants == Credential::Token;
}

} // namespace tetra
