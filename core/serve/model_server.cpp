// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/serve/model_server.h"

#include "core/base/checksum.h"
#include "core/base/json_writer.h"
#include "core/base/text.h"
#include "core/history/error_meaning.h"
#include "core/history/format.h"
#include "core/history/query_words.h"
#include "core/packed/packed_mesh.h"
#include "core/remote/percent_encoding.h"
#include "core/serve/mesh_facts.h"
#include "core/serve/served_query.h"
#include "core/serve/served_sizes.h"

#include <tan/open.h>
#include <tan/query.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <ctime>
#include <future>
#include <limits>

#include <malloc.h>

namespace tetra {
namespace {

constexpr int notModel = 422, noRoom = 507;

std::tm utc(std::int64_t seconds)
{
    const std::time_t time = seconds;
    std::tm parts{};
    ::gmtime_r(&time, &parts);
    return parts;
}

/// A number with so many digits or more, zeros before it.
std::string padded(int number, std::size_t digits = 2)
{
    const std::string text = std::to_string(number);
    return std::string(digits - std::min(digits, text.size()), '0') + text;
}
std::string clockText(const std::tm& time)
{
    return padded(time.tm_hour) + ":" + padded(time.tm_min) + ":" + padded(time.tm_sec);
}

/// "Thu, 26 Nov 2026 09:05:00 GMT", in every locale.
std::string httpDate(std::int64_t seconds)
{
    constexpr std::array days = {"Sun", "Mon", "Tue", "Wed", "Thu", "Fri", "Sat"};
    constexpr std::array months = {"Jan", "Feb", "Mar", "Apr", "May", "Jun", "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
    const std::tm time = utc(seconds);
    return std::string(days[static_cast<std::size_t>(time.tm_wday)]) + ", " + padded(time.tm_mday) + " " +
           months[static_cast<std::size_t>(time.tm_mon)] + " " + padded(time.tm_year + 1900, 4) + " " +
           clockText(time) + " GMT";
}

/// "2026-11-26T09:05:00Z"
std::string isoDate(std::int64_t seconds)
{
    const std::tm time = utc(seconds);
    return padded(time.tm_year + 1900, 4) + "-" + padded(time.tm_mon + 1) + "-" + padded(time.tm_mday) + "T" +
           clockText(time) + "Z";
}

/// Whether they are equal, in a time that does not tell where they differ.
bool isEqualInSecret(std::string_view one, std::string_view other)
{
    unsigned difference = one.size() == other.size() ? 0 : 1;
    for (std::size_t i = 0; i < other.size(); ++i)
        difference |=
            static_cast<unsigned char>(one.empty() ? 0 : one[i % one.size()]) ^ static_cast<unsigned char>(other[i]);
    return difference == 0;
}

/// "localhost:8080" and the like; names of hosts have no capitals that count.
bool isThisMachine(std::string_view host)
{
    if (const std::size_t colon = host.rfind(':'); colon != std::string_view::npos && !host.ends_with(']'))
        host = host.substr(0, colon);
    return isLoopback(
        smallLetters(host.starts_with('[') && host.ends_with(']') ? host.substr(1, host.size() - 2) : host));
}

bool hasTag(std::string_view list, std::string_view tag)
{
    return list == "*" || list.find(tag) != std::string_view::npos;
}

/// The part of a file of `size` bytes that a header Range asks for. Nothing: all of it, as if there were no header.
/// Several ranges at once, other units and what is no range are not understood (RFC 9110, 14.2).
struct AskedRange {
    std::uint64_t first = 0;
    std::uint64_t count = 0; ///< 0: there is nothing of it
};
std::optional<AskedRange> askedRange(std::string_view header, std::uint64_t size)
{
    constexpr std::string_view unit = "bytes=";
    if (!header.starts_with(unit))
        return {};
    header.remove_prefix(unit.size());
    const std::size_t dash = header.find('-');
    if (dash == std::string_view::npos)
        return {};
    const auto number = [](std::string_view text) -> std::optional<std::uint64_t> {
        if (text.empty() || !std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; }))
            return {};
        constexpr std::size_t mostDigits = 19; // more than any file has
        return text.size() > mostDigits ? std::numeric_limits<std::int64_t>::max() : parseNumber<std::uint64_t>(text);
    };
    const std::string_view begin = header.substr(0, dash), end = header.substr(dash + 1);
    const auto first = number(begin), last = number(end);
    if (begin.empty() && last) // the last bytes
        return AskedRange{size - std::min(size, *last), std::min(size, *last)};
    if (!first || (!end.empty() && !last) || (last && *last < *first))
        return {};
    if (*first >= size)
        return AskedRange{};
    return AskedRange{*first, std::min(size - 1, last.value_or(size - 1)) - *first + 1};
}

ServedAnswer jsonAnswer(const JsonObject& object)
{
    return textAnswer(200, "application/json", compactJson(object) + "\n");
}

Error beingChanged()
{
    return {ErrorKind::OutOfResource, Message::say("The file is being changed. Ask again.")};
}

ServedAnswer notAModel(const ServedFile& file)
{
    return errorAnswer(notModel, "'" + printable(file.name) + "' cannot be opened as a model.");
}

ServedAnswer comeAgain(ServedAnswer refusal)
{
    refusal.headers.emplace_back("Retry-After", "2");
    return refusal;
}

/// What is said of an error. Those about files name where they lie, which is nobody's business, so that only what is
/// wrong with a question is told as it is.
ServedAnswer refusal(const Error& error, const ServedFile& file)
{
    const std::string name = "'" + printable(file.name) + "'";
    switch (error.kind) {
    case ErrorKind::WrongUsage: return errorAnswer(400, error.text());
    case ErrorKind::CannotWrite:
        return errorAnswer(
            noRoom,
            "The disk of the server's cache folder has no room to unpack " + name +
                ", or cannot be written. The server's operator can correct this; the file itself can be downloaded.");
    case ErrorKind::OutOfResource:
    case ErrorKind::NotYet:
        return comeAgain(errorAnswer(503, "The server lacks memory, threads or open files for " + name +
                                              ", or the file is being changed. Ask again later."));
    case ErrorKind::Cancelled: return errorAnswer(504, "The client no longer waits for this.");
    case ErrorKind::BadInput: break;
    }
    return errorAnswer(500, "The file of " + name + " was found damaged. The server's operator can replace it.");
}

ServedAnswer cannotLook(const Error& error)
{
    return comeAgain(errorAnswer(503, error.text()));
}

/// The most tetrahedra that the whole mesh of a query has, as far as the sizes of uniform meshes tell.
std::uint64_t expectedTetrahedra(const Model& model, const MeshQuery& query)
{
    if (query.range) {
        const std::uint32_t sites =
            std::max(meshSizeAt(model, query.range->one).sites, meshSizeAt(model, query.range->other).sites);
        return model.starOffsets()[sites];
    }
    if (query.budget || !query.error.isConstant() || !query.warping.isConstant())
        return 0;
    return meshSizeAt(model, {query.error.bounds().minimum, query.warping.bounds().minimum}).tetrahedra;
}

ServedAnswer tooLarge(std::uint64_t most)
{
    return errorAnswer(413, "The mesh has more than " + std::to_string(most) +
                                " tetrahedra, the most that this server sends. Use a larger error, or request the best "
                                "mesh of a given size with 'budget'.");
}

PlaceScale scaleOf(const Model& model)
{
    const ModelDescription& description = model.description();
    if (description.domain == DomainClass::RegularLattice) {
        const Lattice& lattice = description.lattice;
        // Axes that are mirrored or exchanged lead along one of the world, others along all three.
        return {lattice.origin, lattice.directions.cwiseAbs() * lattice.spacing};
    }
    return {description.bounds.min(), {1, 1, 1}};
}

/// What the receiver is told besides the mesh: the figures of `tan extract`, the facts that it writes into files, and
/// what ExtractedMesh says.
std::string factsText(const ServedFile& file, const Model& model, const MeshQuery& query, const ExtractedMesh& mesh)
{
    JsonArray facts;
    for (const auto& [name, value] : meshFacts(model, query, mesh)) {
        if (const auto* text = std::get_if<std::string>(&value))
            facts.push_back(
                JsonArray{name, name == "model" ? std::filesystem::path(file.name).filename().string() : *text});
        else
            facts.push_back(JsonArray{name, std::get<double>(value)});
    }
    JsonObject ofMesh{{"whole_sites", mesh.wholeSites},
                      {"whole_tetrahedra", mesh.wholeTetrahedra},
                      {"kept_sites", mesh.keptSites},
                      {"kept_tetrahedra", mesh.keptTetrahedra},
                      {"scale", mesh.scale},
                      {"method", wordOf(methodWords, mesh.method)}};
    if (mesh.reached) {
        ofMesh["reached_error"] = mesh.reached->error;
        ofMesh["reached_warping"] = mesh.reached->warping;
    }
    return compactJson(JsonObject{{"figures", meshFigures(model, query, mesh)},
                                  {"facts", facts},
                                  {"mesh", ofMesh},
                                  {"overlaps", mesh.overlaps},
                                  {"tag", file.tag}});
}

} // namespace

bool isLoopback(std::string_view address)
{
    return address == "localhost" || address == "::1" ||
           (address.starts_with("127.") &&
            std::ranges::all_of(address, [](char c) { return c == '.' || (c >= '0' && c <= '9'); }));
}

bool isOrigin(std::string_view text)
{
    const std::size_t scheme = text.starts_with("https://") ? 8 : text.starts_with("http://") ? 7 : text.size();
    const std::string_view host = text.substr(scheme);
    return !host.empty() && std::ranges::all_of(host, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') ||
               std::string_view("-.:[]").find(c) != std::string_view::npos;
    });
}

/// One of the few meshes that are worked on at a time.
class ModelServer::Turn {
public:
    Turn(ModelServer& server, const std::stop_token& gone) : server_(server)
    {
        constexpr std::chrono::milliseconds lookUpEvery{100};
        const auto until = std::chrono::steady_clock::now() + server.limits_.waiting;
        std::unique_lock lock(server.mutex_);
        while (server.working_ >= server.limits_.meshes && !gone.stop_requested() &&
               std::chrono::steady_clock::now() < until)
            server.turnOver_.wait_for(lock, lookUpEvery);
        isTaken_ = server.working_ < server.limits_.meshes;
        server.working_ += isTaken_ ? 1 : 0;
    }
    ~Turn()
    {
        if (!isTaken_)
            return;
        // What a mesh took goes back to the system: another thread's share of the heap would never use it again.
        ::malloc_trim(0);
        const std::lock_guard lock(server_.mutex_);
        --server_.working_;
        server_.turnOver_.notify_one();
    }
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;

    bool isTaken() const noexcept { return isTaken_; }

private:
    ModelServer& server_;
    bool isTaken_ = false;
};

ModelServer::ModelServer(ServedFolder folder, ServedTo whom, ModelServerLimits limits)
    : folder_(std::move(folder)), whom_(std::move(whom)), limits_(limits)
{
}

bool ModelServer::takesLong(const ServedRequest& request)
{
    return request.target == "/" || request.target.find('?') != std::string::npos;
}

HttpServer::Handler ModelServer::handler()
{
    return {.takesLong = takesLong, .answer = [this](const ServedRequest& request) { return answer(request); }};
}

bool ModelServer::isFromKnownOrigin(const ServedRequest& request) const
{
    const auto origin = request.header("origin");
    return origin && std::ranges::find(whom_.origins, *origin) != whom_.origins.end();
}

/// Why somebody is not answered, if so.
std::optional<ServedAnswer> ModelServer::refusalOf(const ServedRequest& request) const
{
    if (whom_.token.empty()) {
        if (isThisMachine(request.header("host").value_or("localhost")))
            return {};
        return errorAnswer(403, "This server answers requests for localhost only.");
    }
    constexpr std::string_view scheme = "Bearer ";
    const std::string given = request.header("authorization").value_or("");
    if (given.starts_with(scheme) && isEqualInSecret(whom_.token, std::string_view(given).substr(scheme.size())))
        return {};
    ServedAnswer refused = errorAnswer(401, "A token is required: Authorization: Bearer TOKEN.");
    refused.headers.emplace_back("WWW-Authenticate", "Bearer");
    return refused;
}

/// Pages of the origins that were named may read what their browser gets, whatever it is; a browser asks first, without
/// the token, whether it may send one.
ServedAnswer ModelServer::answer(const ServedRequest& request)
try {
    const bool isKnown = isFromKnownOrigin(request);
    if (request.method == HttpMethod::Options) {
        ServedAnswer told = isKnown ? ServedAnswer() : errorAnswer(405, "Method Not Allowed");
        if (isKnown) {
            told.status = 204;
            told.headers = {{"Access-Control-Allow-Origin", *request.header("origin")},
                            {"Access-Control-Allow-Methods", "GET, HEAD"},
                            {"Access-Control-Allow-Headers", "Authorization, Range, If-Range, If-None-Match"},
                            {"Access-Control-Max-Age", "600"},
                            {"Vary", "Origin"}};
        }
        if (!isKnown)
            told.headers = {{"Allow", "GET, HEAD"}, {"Connection", "close"}};
        return told;
    }
    ServedAnswer answer = answerWhoMay(request);
    if (!whom_.origins.empty())
        answer.headers.emplace_back("Vary", "Origin");
    if (isKnown) {
        answer.headers.emplace_back("Access-Control-Allow-Origin", *request.header("origin"));
        answer.headers.emplace_back("Access-Control-Expose-Headers",
                                    "Accept-Ranges, Content-Length, Content-Range, ETag, Last-Modified, Retry-After");
    }
    return answer;
} catch (const std::exception&) {
    return comeAgain(errorAnswer(503, "The server does not have enough memory for this answer."));
}

ServedAnswer ModelServer::answerWhoMay(const ServedRequest& request)
{
    if (auto refused = refusalOf(request))
        return *std::move(refused);
    const std::size_t mark = request.target.find('?');
    const std::string_view path =
        std::string_view(request.target).substr(1, mark == std::string::npos ? mark : mark - 1);
    if (path.empty())
        return list(request);
    const auto name = percentDecoded(path);
    const auto found = name ? folder_.find(*name) : Result<std::optional<ServedFile>>(std::nullopt);
    if (!found)
        return cannotLook(found.error());
    const std::optional<ServedFile>& file = *found;
    if (!file)
        return errorAnswer(404, "There is no such model here. '/' lists the available ones.");
    if (mark == std::string::npos)
        return fileAnswer(request, *file);
    const std::string_view query = std::string_view(request.target).substr(mark + 1);
    return query == aboutQuestion   ? aboutAnswer(request, *file)
           : query == sizesQuestion ? sizesAnswer(request, *file)
                                    : meshAnswer(request, *file, query);
}

ServedAnswer ModelServer::list(const ServedRequest& request) const
{
    JsonArray models;
    const auto names = folder_.names(limits_.listed);
    if (!names)
        return cannotLook(names.error());
    for (const std::string& name : *names) {
        if (request.gone.stop_requested())
            return errorAnswer(503, "The client no longer waits for this list.");
        const auto found = folder_.find(name);
        if (!found)
            return cannotLook(found.error());
        const std::optional<ServedFile>& file = *found;
        format::Header header;
        if (!file || file->size < sizeof header || !file->read(0, {reinterpret_cast<char*>(&header), sizeof header}) ||
            header.magic != format::magic)
            continue;
        models.push_back(JsonObject{{"file", name},
                                    {"url", "/" + percentEncoded(name)},
                                    {"bytes", file->size},
                                    {"changed", isoDate(file->changed)},
                                    {"tag", file->tag},
                                    {"sites", std::uint64_t(header.siteCount)},
                                    {"tetrahedra", std::uint64_t(header.tetrahedronCount)}});
    }
    return jsonAnswer({{"models", models}});
}

ServedAnswer ModelServer::fileAnswer(const ServedRequest& request, const ServedFile& file) const
{
    ServedAnswer answer;
    answer.type = "application/octet-stream";
    answer.headers = {{"ETag", file.tag},
                      {"Last-Modified", httpDate(file.changed)},
                      {"Accept-Ranges", "bytes"},
                      {"Cache-Control", "no-cache"}};
    if (const auto known = request.header("if-none-match"); known && hasTag(*known, file.tag)) {
        answer.status = 304;
        return answer;
    }
    const auto condition = request.header("if-range");
    const auto wanted = request.header("range");
    std::optional<AskedRange> range;
    if (wanted && (!condition || *condition == file.tag)) // by its date a file is not known well enough
        range = askedRange(*wanted, file.size);
    const std::string size = std::to_string(file.size);
    if (range && range->count == 0) {
        ServedAnswer refused = errorAnswer(416, "The file has " + size + " bytes.");
        refused.headers = {{"Content-Range", "bytes */" + size}, {"Accept-Ranges", "bytes"}};
        return refused;
    }
    if (range) {
        answer.status = 206;
        answer.headers.emplace_back("Content-Range", "bytes " + std::to_string(range->first) + "-" +
                                                         std::to_string(range->first + range->count - 1) + "/" + size);
    }
    answer.size = range ? range->count : file.size;
    answer.read = [file, first = range ? range->first : 0](std::uint64_t offset, std::span<char> to) {
        return file.read(first + offset, to);
    };
    return answer;
}

Result<std::shared_ptr<const Model>> ModelServer::modelOf(const ServedFile& file, const Progress& progress)
{
    {
        const std::lock_guard lock(mutex_);
        const auto found = std::ranges::find(models_, file.name, &OpenModel::name);
        if (found != models_.end() && found->tag == file.tag) {
            models_.splice(models_.begin(), models_, found);
            return found->model;
        }
        if (found != models_.end())
            models_.erase(found);
    }
    const auto path = file.path();
    if (!path)
        return beingChanged();
    const auto found = openModel(path->string(), {}, progress); // one that is packed is unpacked into the cache
    if (!found)
        return found.error();
    const std::shared_ptr<const Model>& model = found->model;
    if (file.path() != path) // another file may have come there meanwhile
        return beingChanged();
    const std::lock_guard lock(mutex_);
    if (std::ranges::find(models_, file.name, &OpenModel::name) == models_.end())
        models_.push_front({file.name, file.tag, model});
    while (models_.size() > limits_.models)
        models_.pop_back();
    return model;
}

/// Without opening it: what the front of its file tells.
ServedAnswer ModelServer::aboutAnswer(const ServedRequest& request, const ServedFile& file) const
{
    const auto path = file.path();
    const auto facts = path ? modelFacts(path->string(), Progress(request.gone, {})) : beingChanged();
    if (!facts)
        return facts.error().kind == ErrorKind::BadInput ? notAModel(file) : refusal(facts.error(), file);
    return jsonAnswer({{"form", facts->form == ModelForm::Packed ? "packed" : "explicit"},
                       {"bytes", facts->fileBytes},
                       {"unpacked_bytes", facts->unpackedBytes},
                       {"sites", facts->sites},
                       {"tetrahedra", facts->tetrahedra},
                       {"error_kind", wordOf(errorKindWords, errorMeaning(facts->description))},
                       {"tag", file.tag}});
}

ServedAnswer ModelServer::sizesAnswer(const ServedRequest& request, const ServedFile& file)
{
    return inTurn(request, file, [&](const Progress& progress) -> Result<ServedAnswer> {
        const auto model = modelOf(file, progress);
        if (!model)
            return model.error().kind == ErrorKind::BadInput ? notAModel(file) : Result<ServedAnswer>(model.error());
        const WholeSizes sizes = sizesOfWhole(**model);
        if (const Status intact = (*model)->checkIntact(); !intact)
            return intact.error();
        JsonArray meshes;
        for (const MeshSize& size : sizes.meshes)
            meshes.push_back(JsonArray{size.sites, size.tetrahedra, size.error, size.warping});
        return jsonAnswer({{"sites", sizes.sites},
                           {"tetrahedra", sizes.tetrahedra},
                           {"bytes", file.size},
                           {"warps", (*model)->description().warpingWeight > 0},
                           {"error_kind", wordOf(errorKindWords, errorMeaning((*model)->description()))},
                           {"meshes", meshes},
                           {"tag", file.tag}});
    });
}

/// What is worked on when it is its turn, for as long as that may take and somebody waits for it.
ServedAnswer ModelServer::inTurn(const ServedRequest& request, const ServedFile& file,
                                 const std::function<Result<ServedAnswer>(const Progress& progress)>& work)
{
    const Turn turn(*this, request.gone);
    if (!turn.isTaken())
        return comeAgain(errorAnswer(503, "Too many meshes are requested at once. Try again."));
    // In a thread that ends with it, so that the next one takes over its stack and its share of the heap: the threads
    // of all connections would each keep theirs.
    std::stop_source over;
    auto worked = std::async(std::launch::async, work, Progress(request.gone, {}).alsoCancelledBy(over.get_token()));
    if (worked.wait_for(limits_.time) != std::future_status::ready)
        over.request_stop();
    const auto answer = worked.get();
    if (answer)
        return *answer;
    if (answer.error().kind != ErrorKind::Cancelled)
        return refusal(answer.error(), file);
    return errorAnswer(504, over.stop_requested() ? "This mesh takes longer than the server allows. Use a larger error."
                                                  : "The client no longer waits for this mesh.");
}

ServedAnswer ModelServer::meshAnswer(const ServedRequest& request, const ServedFile& file, std::string_view query)
{
    const auto words = QueryWords::fromUrl(query);
    const auto asked = words ? words->query() : words.error();
    if (!asked)
        return errorAnswer(400, asked.error().text());

    // The same question to the same file has the same answer, in the same form: 2 has positions in doubles.
    const std::string question = file.tag + " " + std::string(query);
    const std::string tag =
        "\"mesh-2-" + std::to_string(checksum(std::as_bytes(std::span(question.data(), question.size())))) + "\"";
    ServedAnswer answer;
    answer.type = packedMeshType;
    answer.headers = {{"ETag", tag}, {"Cache-Control", "no-cache"}};
    if (const auto known = request.header("if-none-match"); known && hasTag(*known, tag)) {
        answer.status = 304;
        return answer;
    }

    return inTurn(request, file, [&](const Progress& progress) -> Result<ServedAnswer> {
        const auto model = modelOf(file, progress);
        if (!model)
            return model.error().kind == ErrorKind::BadInput ? notAModel(file) : Result<ServedAnswer>(model.error());
        if ((words->has("warping") || words->has("warping-field")) && !((*model)->description().warpingWeight > 0))
            return errorAnswer(400, "'warping' is for models of curvilinear or irregular data only, and the data of '" +
                                        printable(file.name) + "' cannot warp. Leave it out.");
        if (const Status sound = checkQuery(**model, *asked); !sound)
            return sound.error();
        const auto isTooLarge = [this](std::uint64_t tetrahedra) { return tetrahedra > limits_.tetrahedra; };
        if (isTooLarge(expectedTetrahedra(**model, *asked)) || isTooLarge(asked->budget.value_or(0)))
            return tooLarge(limits_.tetrahedra);
        auto mesh = MeshExtractor(*model).extract(*asked, progress);
        // A damaged file is told in place of what came of it.
        if (mesh || mesh.error().kind != ErrorKind::Cancelled)
            if (const Status right = (*model)->confirm(progress.withCallback({})); !right)
                return right.error();
        if (!mesh)
            return mesh.error();
        if (isTooLarge((*mesh)->wholeTetrahedra) || isTooLarge((*mesh)->mesh.tetrahedra.size()))
            return tooLarge(limits_.tetrahedra);
        if (const Status some = checkNotEmpty(*asked, **model, (*mesh)->mesh); !some && words->value("empty") != "yes")
            return some.error();
        auto packed = packMesh((*mesh)->mesh, (*mesh)->birthErrors, (*mesh)->deathErrors,
                               factsText(file, **model, *asked, **mesh), scaleOf(**model), progress);
        if (!packed)
            return packed.error();
        answer.note = std::to_string((*mesh)->mesh.tetrahedra.size()) + " tetrahedra";
        answer.size = packed->size();
        answer.read = [bytes = std::make_shared<const std::vector<std::byte>>(std::move(*packed))](std::uint64_t offset,
                                                                                                   std::span<char> to) {
            std::memcpy(to.data(), bytes->data() + offset, to.size());
            return true;
        };
        return answer;
    });
}

} // namespace tetra
