// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/server/model_server.h"

#include "app/command_line/extracted_content.h"
#include "app/command_line/option_values.h"
#include "app/command_line/queried_mesh.h"
#include "app/command_line/query_options.h"
#include "core/base/checksum.h"
#include "core/base/text.h"
#include "core/history/format.h"
#include "core/history/query_words.h"
#include "core/opening/served_model.h"
#include "core/packed/packed_mesh.h"
#include "core/remote/percent_encoding.h"

#include <tan/open.h>
#include <tan/query.h>

#include <QDateTime>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <array>
#include <cstring>
#include <future>

#include <malloc.h>

namespace tetra {
namespace {

std::string httpDate(std::int64_t seconds)
{
    return QLocale::c()
        .toString(QDateTime::fromSecsSinceEpoch(seconds, Qt::UTC), "ddd, dd MMM yyyy hh:mm:ss 'GMT'")
        .toStdString();
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

ServedAnswer jsonAnswer(const QJsonObject& object)
{
    return textAnswer(200, "application/json", QJsonDocument(object).toJson(QJsonDocument::Indented).toStdString());
}

/// A query of a URL as the words of a command line: "error=1&window=..." is --error=1 --window=...
std::optional<std::vector<std::string>> wordsOf(std::string_view query)
{
    std::vector<std::string> words;
    while (!query.empty()) {
        const std::size_t end = query.find('&');
        const auto word = percentDecoded(query.substr(0, end));
        if (!word)
            return {};
        if (!word->empty())
            words.push_back("--" + *word);
        query.remove_prefix(end == std::string_view::npos ? query.size() : end + 1);
    }
    return words;
}

int statusOf(const Error& error)
{
    switch (error.kind) {
    case ErrorKind::WrongUsage: return 400;
    case ErrorKind::OutOfResource: return 503;
    case ErrorKind::Cancelled: return 504;
    default: return 500;
    }
}

ServedAnswer refusal(const Error& error)
{
    return errorAnswer(statusOf(error), error.text());
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

Error beingChanged()
{
    return {ErrorKind::OutOfResource, Message::say("The file is being changed. Ask again.")};
}

Error notAModel(const ServedFile& file)
{
    return {ErrorKind::BadInput, Message::say("'%1' cannot be opened as a model.", printable(file.name))};
}

Error tooLarge(std::uint64_t most)
{
    return {
        ErrorKind::OutOfResource,
        Message::say("The mesh has more than %1 tetrahedra, the most that this server gives. Ask for a larger error, "
                     "or for the best mesh of so many with 'budget'.",
                     most)};
}

/// What else a program may ask than the command line offers, beside queryOptions().
std::vector<Option> furtherOptions()
{
    return {{.name = "warping-field",
             .placeholder = "TEXT",
             .explanation = "In place of --warping, the largest one at each place, as --field."},
            {.name = "empty",
             .placeholder = "ANSWER",
             .explanation = "With 'yes' a mesh without tetrahedra is an answer and no refusal."}};
}

Result<MeshQuery> questionIn(const Arguments& arguments)
{
    auto query = queryOf(arguments);
    const auto warping = arguments.value("warping-field");
    if (!query || !warping)
        return query;
    const auto field = parseErrorField(*warping);
    if (!field || arguments.has("warping"))
        return Error{ErrorKind::WrongUsage,
                     "'--warping-field': " + (field ? "'--warping' does not go with it." : field.error().text())};
    query->warping = *field;
    return query;
}

/// What the receiver is told besides the mesh: the figures of `tan extract`, the facts that it writes into files, and
/// what ExtractedMesh says.
std::string factsText(const ServedFile& file, const Model& model, const MeshQuery& query, const ExtractedMesh& mesh)
{
    QJsonArray facts;
    for (const auto& [name, value] : meshFacts(model, query, mesh)) {
        const QString key = QString::fromStdString(name);
        if (const auto* text = std::get_if<std::string>(&value))
            facts.append(
                QJsonArray{key, QString::fromStdString(
                                    name == "model" ? std::filesystem::path(file.name).filename().string() : *text)});
        else
            facts.append(QJsonArray{key, std::get<double>(value)});
    }
    const QJsonObject ofMesh{{"whole_sites", static_cast<qint64>(mesh.wholeSites)},
                             {"whole_tetrahedra", static_cast<qint64>(mesh.wholeTetrahedra)},
                             {"kept_sites", static_cast<qint64>(mesh.keptSites)},
                             {"kept_tetrahedra", static_cast<qint64>(mesh.keptTetrahedra)},
                             {"scale", mesh.scale},
                             {"method", wordOf(methodWords, mesh.method)}};
    return QJsonDocument(QJsonObject{{"figures", figuresOf(model, query, mesh)},
                                     {"facts", facts},
                                     {"mesh", ofMesh},
                                     {"overlaps", mesh.overlaps},
                                     {"tag", QString::fromStdString(file.tag)}})
        .toJson(QJsonDocument::Compact)
        .toStdString();
}

} // namespace

bool isLoopback(std::string_view address)
{
    return address == "localhost" || address == "::1" ||
           (address.starts_with("127.") &&
            std::ranges::all_of(address, [](char c) { return c == '.' || (c >= '0' && c <= '9'); }));
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

ModelServer::ModelServer(ServedFolder folder, std::string token, ModelServerLimits limits)
    : folder_(std::move(folder)), token_(std::move(token)), limits_(limits)
{
}

bool ModelServer::isAllowed(const ServedRequest& request) const
{
    if (token_.empty())
        return isThisMachine(request.header("Host").value_or("localhost"));
    constexpr std::string_view scheme = "Bearer ";
    const std::string given = request.header("Authorization").value_or("");
    return given.starts_with(scheme) && isEqualInSecret(token_, std::string_view(given).substr(scheme.size()));
}

ServedAnswer ModelServer::answer(const ServedRequest& request)
try {
    if (!isAllowed(request)) {
        if (token_.empty())
            return errorAnswer(403, "This server answers requests for localhost only.");
        ServedAnswer refused = errorAnswer(401, "A token is needed: Authorization: Bearer TOKEN.");
        refused.headers.emplace_back("WWW-Authenticate", "Bearer");
        return refused;
    }
    const std::size_t mark = request.target.find('?');
    const std::string_view path =
        std::string_view(request.target).substr(1, mark == std::string::npos ? mark : mark - 1);
    if (path.empty())
        return list();
    const auto name = percentDecoded(path);
    const auto found = name ? folder_.find(*name) : Result<std::optional<ServedFile>>(std::nullopt);
    if (!found)
        return refusal(found.error());
    const std::optional<ServedFile>& file = *found;
    if (!file)
        return errorAnswer(404, "There is no such model here. '/' lists those that there are.");
    if (mark == std::string::npos)
        return fileAnswer(request, *file);
    const std::string_view query = std::string_view(request.target).substr(mark + 1);
    return query == aboutQuestion   ? aboutAnswer(request, *file)
           : query == sizesQuestion ? sizesAnswer(request, *file)
                                    : meshAnswer(request, *file, query);
} catch (const std::exception&) {
    return errorAnswer(503, "Not enough memory for this answer.");
}

ServedAnswer ModelServer::list() const
{
    QJsonArray models;
    const auto names = folder_.names(limits_.listed);
    if (!names)
        return refusal(names.error());
    for (const std::string& name : *names) {
        const auto found = folder_.find(name);
        if (!found)
            return refusal(found.error());
        const std::optional<ServedFile>& file = *found;
        format::Header header;
        if (!file || file->size < sizeof header || !file->read(0, {reinterpret_cast<char*>(&header), sizeof header}) ||
            header.magic != format::magic)
            continue;
        models.append(
            QJsonObject{{"file", QString::fromStdString(name)},
                        {"url", QString::fromStdString("/" + percentEncoded(name))},
                        {"bytes", static_cast<qint64>(file->size)},
                        {"changed", QDateTime::fromSecsSinceEpoch(file->changed, Qt::UTC).toString(Qt::ISODate)},
                        {"tag", QString::fromStdString(file->tag)},
                        {"sites", static_cast<qint64>(header.siteCount)},
                        {"tetrahedra", static_cast<qint64>(header.tetrahedronCount)}});
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
    if (const auto known = request.header("If-None-Match"); known && hasTag(*known, file.tag)) {
        answer.status = 304;
        return answer;
    }
    const auto condition = request.header("If-Range");
    const auto wanted = request.header("Range");
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
    if (!found) {
        const ErrorKind kind = found.error().kind;
        const bool isTold = kind == ErrorKind::Cancelled || kind == ErrorKind::OutOfResource;
        return Error{isTold ? kind : ErrorKind::BadInput,
                     notAModel(file).message}; // where it lies is nobody's business
    }
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
        return errorAnswer(500, notAModel(file).text()); // where it lies is nobody's business
    return jsonAnswer({{"form", facts->form == ModelForm::Packed ? "packed" : "explicit"},
                       {"bytes", static_cast<qint64>(facts->fileBytes)},
                       {"unpacked_bytes", static_cast<qint64>(facts->unpackedBytes)},
                       {"sites", static_cast<qint64>(facts->sites)},
                       {"tetrahedra", static_cast<qint64>(facts->tetrahedra)},
                       {"tag", QString::fromStdString(file.tag)}});
}

ServedAnswer ModelServer::sizesAnswer(const ServedRequest& request, const ServedFile& file)
{
    return inTurn(request, [&](const Progress& progress) -> Result<ServedAnswer> {
        const auto model = modelOf(file, progress);
        if (!model)
            return model.error();
        const WholeSizes sizes = sizesOfWhole(**model);
        if (const Status intact = (*model)->checkIntact(); !intact)
            return notAModel(file);
        QJsonArray meshes;
        for (const MeshSize& size : sizes.meshes)
            meshes.append(QJsonArray{static_cast<qint64>(size.sites), static_cast<qint64>(size.tetrahedra), size.error,
                                     size.warping});
        return jsonAnswer({{"sites", static_cast<qint64>(sizes.sites)},
                           {"tetrahedra", static_cast<qint64>(sizes.tetrahedra)},
                           {"bytes", static_cast<qint64>(file.size)},
                           {"warps", (*model)->description().warpingWeight > 0},
                           {"meshes", meshes},
                           {"tag", QString::fromStdString(file.tag)}});
    });
}

/// What is worked on when it is its turn, for as long as that may take and somebody waits for it.
ServedAnswer ModelServer::inTurn(const ServedRequest& request,
                                 const std::function<Result<ServedAnswer>(const Progress& progress)>& work)
{
    const Turn turn(*this, request.gone);
    if (!turn.isTaken()) {
        ServedAnswer busy = errorAnswer(503, "Too many meshes are asked for at once. Ask again.");
        busy.headers.emplace_back("Retry-After", "2");
        return busy;
    }
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
        return refusal(answer.error());
    return errorAnswer(504, over.stop_requested()
                                ? "This mesh takes longer than the server may work on one. Ask for a larger error."
                                : "Nobody waits for this mesh any more.");
}

ServedAnswer ModelServer::meshAnswer(const ServedRequest& request, const ServedFile& file, std::string_view query)
{
    const auto words = wordsOf(query);
    if (!words)
        return errorAnswer(400, "The query is not encoded as it should be: '%' and two digits.");
    Syntax syntax;
    syntax.options = queryOptions();
    std::ranges::move(furtherOptions(), std::back_inserter(syntax.options));
    const auto arguments = parseArguments(syntax, *words);
    if (!arguments)
        return refusal(arguments.error());
    const auto asked = questionIn(*arguments);
    if (!asked)
        return refusal(asked.error());

    // The same question to the same file has the same answer.
    const std::string question = file.tag + " " + std::string(query);
    const std::string tag =
        "\"mesh-" + std::to_string(checksum(std::as_bytes(std::span(question.data(), question.size())))) + "\"";
    ServedAnswer answer;
    answer.type = packedMeshType;
    answer.headers = {{"ETag", tag}, {"Cache-Control", "no-cache"}};
    if (const auto known = request.header("If-None-Match"); known && hasTag(*known, tag)) {
        answer.status = 304;
        return answer;
    }

    return inTurn(request, [&](const Progress& progress) -> Result<ServedAnswer> {
        const auto model = modelOf(file, progress);
        if (!model)
            return model.error();
        if (const Status warps = checkWarpingOption(*arguments, **model); !warps)
            return warps.error();
        if (const Status sound = checkQuery(**model, *asked); !sound)
            return sound.error();
        const auto isTooLarge = [this](std::uint64_t tetrahedra) { return tetrahedra > limits_.tetrahedra; };
        if (isTooLarge(expectedTetrahedra(**model, *asked)) || isTooLarge(asked->budget.value_or(0)))
            return errorAnswer(413, tooLarge(limits_.tetrahedra).text());
        const auto mesh = confirmed(**model, MeshExtractor(*model).extract(*asked, progress), progress);
        if (!mesh)
            return mesh.error();
        if (isTooLarge((*mesh)->wholeTetrahedra) || isTooLarge((*mesh)->mesh.tetrahedra.size()))
            return errorAnswer(413, tooLarge(limits_.tetrahedra).text());
        if (const Status some = checkNotEmpty(*arguments, **model, (*mesh)->mesh);
            !some && arguments->value("empty") != "yes")
            return some.error();
        auto packed = packMesh((*mesh)->mesh, (*mesh)->birthErrors, (*mesh)->deathErrors,
                               factsText(file, **model, *asked, **mesh), progress);
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
