// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/remote/remote_file.h"

#include "core/base/guarded.h"
#include "core/base/text.h"
#include "core/remote/http_answer.h"
#include "core/remote/libcurl.h"
#include "core/remote/piece_store.h"
#include "core/remote/transfer_error.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cstring>
#include <deque>
#include <functional>
#include <list>
#include <mutex>
#include <optional>
#include <random>
#include <thread>
#include <utility>

#include <curl/curl.h>

namespace tetra {

namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr std::uint64_t pieceBytes = PieceStore::pieceBytes;
constexpr std::uint64_t mergedGap = 64 << 10;
constexpr std::size_t mostInFlight = 4;
constexpr milliseconds longestPause{5'000}, mostForConnecting{15'000}, betweenLooks{50};
constexpr std::size_t longestAddress = 16 << 10;
constexpr std::size_t longestHead = 256 << 10; ///< of an answer with all redirections
constexpr long mostRedirections = 5;
constexpr MarkedText notEnoughMemory = Message::marked("Not enough memory to read '%1'. Close other programs.");

Error cannotRead(std::string_view address, const Refusal& refusal)
{
    const std::string shown = shownAddress(address);
    return {refusal.kind, Message::say("Cannot read '%1': %2", shown, refusal.reason), shown, refusal.wants};
}

Refusal changedFile()
{
    return final(Message::say("the file on the server was changed while it was read. Open it again."));
}

Refusal packed(const std::string& coding)
{
    return final(Message::say("the server or a proxy compresses what it sends (%1), so that parts of the file cannot "
                              "be located. Download the file and open the copy.",
                              printable(coding)));
}

Refusal noLength()
{
    return final(
        Message::say("the server does not state the length of the file. Download the file and open the copy."));
}

Refusal webPage()
{
    return final(Message::say("the server sends a web page or a list instead of data. Open the address in a browser: "
                              "you may have to log in, or to choose a file there and give its address."));
}

Refusal noRanges()
{
    return final(Message::say("its server delivers files only as a whole, not in parts (range requests). Download the "
                              "file and open the copy, or put it on a server that supports ranges."));
}

Refusal wrongPart()
{
    return final(Message::say(
        "the server sends a different part of the file from the one requested. Download the file and open the copy."));
}

constexpr int unauthorized = 401;

/// `wantsBearer`: HttpAnswer's.
Refusal credentialWanted(bool wantsBearer)
{
    Refusal refusal = wantsBearer ? final(Message::say("the server requires a token. Give the one issued by its "
                                                       "operator; on the command line with '--token-file'."))
                                  : final(Message::say("the server requires a name and a password. Give them in the "
                                                       "address, https://NAME:PASSWORD@..., or download the file."));
    refusal.wants = wantsBearer ? Credential::Token : Credential::Password;
    return refusal;
}

/// What a status means that brings no data. `wantsBearer`: HttpAnswer's.
Refusal refusedStatus(int status, bool wantsBearer)
{
    const auto mayHaveMoved = [](Refusal refusal) {
        refusal.moved = true;
        return refusal;
    };
    switch (status) {
    case unauthorized: return mayHaveMoved(credentialWanted(wantsBearer));
    case 407:
        return final(
            Message::say("the proxy requires a name and a password. Set https_proxy to an address with both."));
    case 403:
        return mayHaveMoved(final(Message::say(
            "the server does not allow it (403). Ask its operator, or check whether the address has expired.")));
    case 404:
    case 410:
        return mayHaveMoved(
            final(Message::say("there is no such file on the server (%1). Check the address.", status)));
    case 408:
    case 425: return again(Message::say("the server is busy (%1). Try again later.", status));
    default: break;
    }
    if (isBusy(status)) {
        Refusal refusal = again(Message::say("the server is busy (%1). Try again later.", status));
        refusal.kind = ErrorKind::OutOfResource;
        return refusal;
    }
    if (status >= 500)
        return again(Message::say("the server failed (%1). Try again later, or tell its operator.", status));
    return final(Message::say("the server answers with status %1 instead of data. Check the address.", status));
}

/// Spreads what comes over time; libcurl's own limit lets bursts of a megabyte through.
class RateLimit {
public:
    explicit RateLimit(std::uint64_t bytesPerSecond) : bytesPerSecond_(bytesPerSecond) {}

    /// When the next bytes may be taken.
    Clock::time_point next() const { return next_; }
    void take(std::size_t bytes)
    {
        if (bytesPerSecond_ == 0)
            return;
        const std::chrono::duration<double> time(double(bytes) / double(bytesPerSecond_));
        next_ = std::max(next_, Clock::now()) + std::chrono::duration_cast<Clock::duration>(time);
    }

private:
    std::uint64_t bytesPerSecond_;
    Clock::time_point next_{};
};

/// One range, on its way or waiting for it.
struct Request {
    std::uint64_t offset = 0; ///< all before it has come; the start of a piece
    std::uint64_t end = 0;
    std::string address;
    HttpAnswer answer;
    bool checked = false;
    std::size_t headBytes = 0;
    std::uint64_t answerEnd = 0;
    std::vector<std::byte> piece; ///< what has come of the piece at `offset`
    std::optional<Refusal> refusal;
    std::optional<Error> failure; ///< of whoever takes the pieces
    bool lacksMemory = false;     ///< libcurl, which calls us, knows no exceptions
    int fruitless = 0;            ///< attempts in a row
    std::uint64_t depth = 1;      ///< answers that were waited for up to its own
    Clock::time_point notBefore{};
    bool isPaused = false; ///< for the limit of the rate
    CURL* handle = nullptr;
    curl_slist* headers = nullptr;
    std::array<char, CURL_ERROR_SIZE> detail{};

    // Of the whole piece of work:
    const HttpAnswer* first = nullptr; ///< the answer that others are held against, if there was one
    std::uint64_t size = 0;            ///< of the file, if there was one
    const std::function<Status(std::uint64_t offset, std::span<const std::byte> piece)>* take = nullptr;
    std::uint64_t* bytes = nullptr;
    RateLimit* rate = nullptr;
    Clock::time_point* lastPiece = nullptr;
};

/// Holds an answer's head against what was asked for, when its content begins or there is none.
std::optional<Refusal> checkAnswer(Request& request, std::span<const std::byte> start)
{
    const HttpAnswer& answer = request.answer;
    switch (useOfAnswer(answer, {request.offset, request.end, request.first, request.size}, start)) {
    case AnswerUse::Part: break;
    case AnswerUse::EmptyFile: return final(Message::say("the file is empty. Check the address."));
    case AnswerUse::Changed: return changedFile();
    case AnswerUse::WebPage: return webPage();
    case AnswerUse::WholeFile: return noRanges();
    case AnswerUse::Packed: return packed(answer.contentEncoding);
    case AnswerUse::OtherPart: return wrongPart();
    case AnswerUse::NoLength: return noLength();
    case AnswerUse::TooLong:
        return final(Message::say("the server says that the file has %1, more than any model has. Check the address.",
                                  neededBytesText(*answer.contentRange->total)));
    case AnswerUse::CutShort: return brokenOff();
    case AnswerUse::NoAnswer: return noHttp();
    case AnswerUse::OtherStatus: return refusedStatus(answer.status, answer.wantsBearer);
    }
    request.answerEnd = *answer.contentRange->last + 1;
    if (request.first == nullptr) {
        request.size = *answer.contentRange->total;
        request.end = std::min(request.end, request.size);
    }
    return {};
}

std::size_t takeHead(char* line, std::size_t, std::size_t size, void* user)
try {
    Request& request = *static_cast<Request*>(user);
    request.headBytes += size;
    if (request.headBytes > longestHead) {
        request.refusal = noHttp();
        return 0;
    }
    takeHeaderLine(request.answer, {line, size});
    return size;
} catch (const std::bad_alloc&) {
    static_cast<Request*>(user)->lacksMemory = true;
    return 0;
}

std::size_t takeContent(char* data, std::size_t, std::size_t size, void* user)
try {
    Request& request = *static_cast<Request*>(user);
    if (Clock::now() < request.rate->next()) {
        request.isPaused = true;
        return CURL_WRITEFUNC_PAUSE;
    }
    std::span<const std::byte> bytes = std::as_bytes(std::span(data, size));
    request.rate->take(size);
    *request.bytes += size;
    if (!request.checked) {
        request.checked = true;
        request.refusal = checkAnswer(request, bytes);
        if (request.refusal)
            return 0;
    }
    if (bytes.size() > request.answerEnd - request.offset - request.piece.size()) {
        request.refusal = wrongPart();
        return 0;
    }
    while (!bytes.empty()) {
        const std::size_t whole = std::min(pieceBytes, request.end - request.offset);
        const std::span<const std::byte> part = bytes.first(std::min(bytes.size(), whole - request.piece.size()));
        request.piece.insert(request.piece.end(), part.begin(), part.end());
        bytes = bytes.subspan(part.size());
        if (request.piece.size() < whole)
            break;
        if (const Status taken = (*request.take)(request.offset, request.piece); !taken) {
            request.failure = taken.error();
            return 0;
        }
        request.piece.clear();
        request.offset += whole;
        request.fruitless = 0;
        *request.lastPiece = Clock::now();
    }
    return size;
} catch (const std::bad_alloc&) {
    static_cast<Request*>(user)->lacksMemory = true;
    return 0;
}

/// Opens connections and keeps them for the next requests. One thread at a time.
class Connections {
public:
    Connections() : multi_(isCurlReady() ? ::curl_multi_init() : nullptr)
    {
        if (multi_ == nullptr)
            throw std::bad_alloc();
        // Known since 7.30, and no more than are asked for anyway.
        ::curl_multi_setopt(multi_, CURLMOPT_MAX_TOTAL_CONNECTIONS, long(mostInFlight));
    }
    ~Connections() { ::curl_multi_cleanup(multi_); }
    Connections(const Connections&) = delete;
    Connections& operator=(const Connections&) = delete;

    CURLM* multi() const { return multi_; }

private:
    CURLM* multi_;
};

} // namespace

class RemoteFile::Shared {
public:
    Shared(std::string_view givenAddress, const RemoteOptions& givenOptions)
        : address(givenAddress), options(givenOptions), rate_(givenOptions.bytesPerSecond), current_(givenAddress)
    {
    }

    /// The first request, and the store that its answer leads to.
    Status open(const CacheFolder& cache, const Progress& progress)
    {
        std::vector<std::byte> start;
        const Sink take = [&](std::uint64_t, std::span<const std::byte> piece) -> Status {
            start.assign(piece.begin(), piece.end());
            return {};
        };
        const ByteRange range{0, pieceBytes};
        if (const Status got = request({&range, 1}, take, progress); !got)
            return got;
        state = !first_->tellsChanges() ? std::string()
                                        : addressWithoutUser(address) + '\n' + first_->entityTag + '\n' +
                                              first_->lastModified + '\n' + std::to_string(size);
        const bool isTemporary = state.empty() || options.afresh;
        std::string key = state;
        if (isTemporary) {
            std::random_device random;
            key = addressWithoutUser(address) + '\n' + std::to_string(random()) + std::to_string(random());
        }
        Result<std::shared_ptr<PieceStore>> opened = PieceStore::open(cache, key, size, isTemporary, progress);
        if (!opened)
            return opened.error();
        store_ = std::move(*opened);
        return store_->write(0, start);
    }

    Status fetch(std::span<const ByteRange> ranges, const Progress& progress)
    {
        return guardedHere([&] { return fetchRanges(ranges, progress); });
    }

    Status read(std::uint64_t offset, std::span<std::byte> to, const Progress& progress)
    {
        return guardedHere([&] { return readBytes(offset, to, progress); });
    }

    void forget() { store_->clear(); }

    RemoteCounts counts() const
    {
        const std::lock_guard lock(counting_);
        return counts_;
    }

    const std::string address;
    const RemoteOptions options;
    std::uint64_t size = 0;
    std::string state;

private:
    using Sink = std::function<Status(std::uint64_t offset, std::span<const std::byte> piece)>;

    template <class Function> Status guardedHere(const Function& work) const
    {
        return guarded(notEnoughMemory, work, shownAddress(address));
    }

    Status fetchRanges(std::span<const ByteRange> ranges, const Progress& progress)
    {
        for (const ByteRange& range : ranges)
            if (const Status within = checkRange(range.offset, range.size); !within)
                return within;
        return fetchPieces(store_->missing(ranges), progress);
    }

    Status readBytes(std::uint64_t offset, std::span<std::byte> to, const Progress& progress)
    {
        if (const Status within = checkRange(offset, to.size()); !within)
            return within;
        if (to.empty())
            return {};
        std::vector<std::uint64_t> wanted, missing;
        for (std::uint64_t piece = offset / pieceBytes; piece <= (offset + to.size() - 1) / pieceBytes; ++piece)
            wanted.push_back(piece);
        std::vector<std::byte> bytes(pieceBytes);
        for (int attempt = 0; attempt < 3; ++attempt) {
            missing.clear();
            for (const std::uint64_t piece : wanted) {
                const ByteRange range = store_->rangeOf(piece);
                if (!store_->read(piece, std::span(bytes).first(range.size))) {
                    missing.push_back(piece);
                    continue;
                }
                const std::uint64_t first = std::max(range.offset, offset);
                const std::uint64_t end = std::min(range.offset + range.size, offset + to.size());
                std::memcpy(to.data() + (first - offset), bytes.data() + (first - range.offset), end - first);
            }
            if (missing.empty())
                return {};
            if (progress.cancelled())
                return cancelledError(activity());
            if (const Status fetched = fetchPieces(missing, progress.withCallback({})); !fetched)
                return fetched;
            wanted = missing;
        }
        return Error{ErrorKind::CannotWrite,
                     Message::say("The cache folder returns other bytes than were written to it. Check its disk, or "
                                  "set XDG_CACHE_HOME to a folder on another one.")};
    }

    Message activity() const { return Message::say("Reading '%1'", shownAddress(address)); }

    Status checkRange(std::uint64_t offset, std::uint64_t bytes) const
    {
        if (offset <= size && bytes <= size - offset)
            return {};
        return cannotRead(
            address,
            final(Message::say("it ends too early. It is not a complete model: ask the person who put it there.")));
    }

    Status fetchPieces(const std::vector<std::uint64_t>& pieces, const Progress& progress)
    {
        if (pieces.empty())
            return {};
        const std::vector<ByteRange> ranges = mergedRanges(pieces, pieceBytes, mergedGap, size);
        std::uint64_t all = 0, came = 0;
        for (const ByteRange& range : ranges)
            all += range.size;
        const Sink take = [&](std::uint64_t offset, std::span<const std::byte> piece) {
            came += piece.size();
            progress.report(double(came) / double(all), Message::marked("Reading from the network"));
            return store_->write(offset / pieceBytes, piece);
        };
        return request(ranges, take, progress);
    }

    /// Has all ranges come, each piece once, in no order.
    Status request(std::span<const ByteRange> ranges, const Sink& take, const Progress& progress)
    {
        std::unique_lock network(network_, std::defer_lock);
        while (!network.try_lock_for(betweenLooks))
            if (progress.cancelled())
                return cancelledError(activity());
        if (!connections_)
            connections_.emplace();
        Work work{*this, take, progress};
        const Status done = run(work, ranges);
        const std::lock_guard lock(counting_);
        counts_.requests += work.counts.requests;
        counts_.bytes += work.counts.bytes;
        counts_.roundTrips += work.counts.roundTrips;
        counts_.connections += work.counts.connections;
        counts_.breaks += work.counts.breaks;
        return done;
    }

    /// One call's requests; whichever of them are open are closed at its end.
    struct Work {
        Work(Shared& givenShared, const Sink& givenTake, const Progress& givenProgress)
            : shared(givenShared), take(givenTake), progress(givenProgress)
        {
        }
        ~Work()
        {
            for (Request& request : running)
                shared.stop(request);
        }
        Work(const Work&) = delete;
        Work& operator=(const Work&) = delete;

        Shared& shared;
        const Sink& take;
        const Progress& progress;
        std::list<Request> waiting, running; ///< lists: libcurl keeps pointers to the requests
        RemoteCounts counts;
        Clock::time_point lastPiece = Clock::now();
        std::optional<Refusal> busy; ///< what the server said that is at its limit, and has been asked to wait for
    };

    Status run(Work& work, std::span<const ByteRange> ranges)
    {
        for (const ByteRange& range : ranges) {
            Request& request = work.waiting.emplace_back();
            request.offset = range.offset;
            request.end = range.offset + range.size;
            request.address = current_;
            request.first = first_ ? &*first_ : nullptr;
            request.size = size;
            request.take = &work.take;
            request.bytes = &work.counts.bytes;
            request.rate = &rate_;
            request.lastPiece = &work.lastPiece;
        }
        while (!work.waiting.empty() || !work.running.empty()) {
            if (work.progress.cancelled())
                return cancelledError(activity());
            const Clock::time_point now = Clock::now();
            if (now - work.lastPiece > silence() && work.busy)
                return cannotRead(address, *work.busy);
            if (now - work.lastPiece > silence())
                return cannotRead(address, final(Message::say("nothing arrived from the server for %1 seconds, or too "
                                                              "slowly. Check the network, or try again later.",
                                                              formatNumber(double(silence().count()) / 1000))));
            for (auto next = work.waiting.begin(); next != work.waiting.end() && work.running.size() < mostInFlight;) {
                const auto request = next++;
                if (request->notBefore > now)
                    continue;
                work.running.splice(work.running.end(), work.waiting, request);
                if (const CURLcode code = start(*request); code != CURLE_OK)
                    return cannotRead(address, refusedSettings(code));
                ++work.counts.requests;
            }
            int active = 0;
            ::curl_multi_perform(connections_->multi(), &active);
            int left = 0;
            bool any = false;
            while (const CURLMsg* const message = ::curl_multi_info_read(connections_->multi(), &left)) {
                if (message->msg != CURLMSG_DONE)
                    continue;
                any = true;
                const auto done = std::ranges::find(work.running, message->easy_handle, &Request::handle);
                assert(done != work.running.end());
                if (const Status finished = finish(work, done, message->data.result); !finished)
                    return finished;
            }
            if (!any)
                wait(work);
        }
        return {};
    }

    /// Until something may have happened.
    void wait(Work& work)
    {
        const auto left = std::chrono::ceil<milliseconds>(rate_.next() - Clock::now());
        const auto most = std::clamp(left, milliseconds(1), betweenLooks);
        const bool isLimited = std::ranges::any_of(work.running, &Request::isPaused);
        ::curl_multi_poll(connections_->multi(), nullptr, 0,
                          static_cast<int>((isLimited ? most : betweenLooks).count()), nullptr);
        for (Request& request : work.running)
            if (request.isPaused && Clock::now() >= rate_.next()) {
                request.isPaused = false;
                ::curl_easy_pause(request.handle, CURLPAUSE_CONT); // what fails is told by the transfer
            }
    }

    /// A limit of the rate may not be what ends a wait.
    milliseconds silence() const
    {
        if (options.bytesPerSecond == 0)
            return options.silence;
        return std::max(options.silence, milliseconds(8000 * pieceBytes / options.bytesPerSecond));
    }

    /// CURLE_OK, or why the request cannot be made.
    CURLcode start(Request& request)
    {
        request.answer = {};
        request.checked = false;
        request.isPaused = false;
        request.headBytes = 0;
        request.answerEnd = 0;
        request.piece.clear();
        request.refusal.reset();
        request.detail[0] = '\0';
        request.handle = newCurlHandle();
        if (request.handle == nullptr)
            return CURLE_OUT_OF_MEMORY;
        const milliseconds mostToConnect = std::min(mostForConnecting, options.silence);
        if (const CURLcode set = setCurlHandle(request.handle, request.address, mostToConnect); set != CURLE_OK)
            return set;
        const std::string range = std::to_string(request.offset) + '-' + std::to_string(request.end - 1);
        const std::string_view validator = request.first ? request.first->validator() : std::string_view();
        const auto addHeader = [&request](const char* name, std::string_view value) {
            curl_slist* const longer =
                value.empty() ? request.headers
                              : ::curl_slist_append(request.headers, std::string(name).append(value).c_str());
            request.headers = longer != nullptr ? longer : request.headers;
            return value.empty() || longer != nullptr;
        };
        if (!addHeader("If-Range: ", validator) || !addHeader("Authorization: Bearer ", options.token))
            return CURLE_OUT_OF_MEMORY;
        const bool isSafe = smallLetters(address.substr(0, 6)) == "https:";
        CurlOptions set(request.handle); // copies are made of all texts but the buffer for errors
        set.set(CURLOPT_REDIR_PROTOCOLS_STR, isSafe ? "https" : "http,https")
            .set(CURLOPT_FOLLOWLOCATION, options.token.empty() ? 1L : 0L)
            .set(CURLOPT_MAXREDIRS, mostRedirections)
            .set(CURLOPT_QUICK_EXIT, 1L)
            .set(CURLOPT_RANGE, range.c_str())
            .set(CURLOPT_HTTPHEADER, request.headers)
            .set(CURLOPT_ERRORBUFFER, request.detail.data())
            .set(CURLOPT_HEADERFUNCTION, &takeHead)
            .set(CURLOPT_HEADERDATA, &request)
            .set(CURLOPT_WRITEFUNCTION, &takeContent)
            .set(CURLOPT_WRITEDATA, &request)
            .set(CURLOPT_SUPPRESS_CONNECT_HEADERS, 1L);
        if (set.code() != CURLE_OK)
            return set.code();
        return ::curl_multi_add_handle(connections_->multi(), request.handle) == CURLM_OK ? CURLE_OK
                                                                                          : CURLE_OUT_OF_MEMORY;
    }

    void stop(Request& request)
    {
        if (request.handle != nullptr) {
            ::curl_multi_remove_handle(connections_->multi(), request.handle);
            ::curl_easy_cleanup(request.handle);
        }
        ::curl_slist_free_all(std::exchange(request.headers, nullptr));
        request.handle = nullptr;
    }

    /// A request has ended, well or not: it is done, to be made again, or an error for all of the work.
    Status finish(Work& work, std::list<Request>::iterator request, CURLcode code)
    {
        long redirections = 0, connections = 0;
        ::curl_easy_getinfo(request->handle, CURLINFO_REDIRECT_COUNT, &redirections);
        ::curl_easy_getinfo(request->handle, CURLINFO_NUM_CONNECTS, &connections);
        work.counts.requests += static_cast<std::uint64_t>(redirections);
        work.counts.connections += static_cast<std::uint64_t>(connections);
        request->depth += static_cast<std::uint64_t>(redirections);
        const std::uint64_t depth = request->depth;
        work.counts.roundTrips = std::max(work.counts.roundTrips, depth);
        if (code == CURLE_OK && !request->checked)
            request->refusal = checkAnswer(*request, {});
        if (code == CURLE_OK && !request->refusal && request->offset == request->end && !first_) {
            first_ = request->answer;
            size = request->size;
            const char* effective = nullptr;
            if (::curl_easy_getinfo(request->handle, CURLINFO_EFFECTIVE_URL, &effective) == CURLE_OK &&
                effective != nullptr && redirections > 0)
                current_ = effective;
        }
        if (request->lacksMemory)
            throw std::bad_alloc();
        const bool isDone = code == CURLE_OK && !request->refusal && request->offset == request->end;
        std::optional<Refusal> refusal = request->refusal;
        if (!isDone && !refusal)
            refusal =
                code == CURLE_OK ? brokenOff() : refusedTransfer(code, request->detail.data(), request->answer.status);
        stop(*request);
        for (Request& next : work.waiting)
            next.depth = std::max(next.depth, depth + 1);
        if (request->failure)
            return *request->failure;
        if (isDone) {
            work.running.erase(request);
            return {};
        }
        // A redirection's address may have had its time while the original one has not.
        const bool isMoved = refusal->moved && request->address != address;
        // A host that is not there at all is told soon.
        const int retries = first_ ? options.retries : std::min(options.retries, 2);
        if (!isMoved && (!refusal->again || request->fruitless >= retries))
            return cannotRead(address, *refusal);
        request->address = address;
        const milliseconds pause = options.firstPause * (std::int64_t(1) << std::min(request->fruitless, 10));
        const milliseconds asked = std::chrono::seconds(request->answer.retryAfter.value_or(0));
        request->notBefore = Clock::now() + std::min(std::max(pause, asked), longestPause);
        work.busy = isBusy(request->answer.status) ? refusal : std::nullopt;
        ++request->fruitless;
        ++request->depth;
        ++work.counts.breaks;
        work.waiting.splice(work.waiting.begin(), work.running, request);
        return {};
    }

    std::timed_mutex network_; ///< guards all of these but the last two
    std::optional<Connections> connections_;
    RateLimit rate_;
    std::optional<HttpAnswer> first_;
    std::string current_; ///< where redirections led
    std::shared_ptr<PieceStore> store_;
    mutable std::mutex counting_;
    RemoteCounts counts_;
};

bool isUnauthorized(const Error& error)
{
    return error.wants != Credential::None;
}

std::vector<ByteRange> mergedRanges(std::span<const std::uint64_t> pieces, std::uint64_t bytesOfPiece,
                                    std::uint64_t gap, std::uint64_t size)
{
    std::vector<ByteRange> ranges;
    for (const std::uint64_t piece : pieces) {
        const std::uint64_t offset = piece * bytesOfPiece, end = std::min(offset + bytesOfPiece, size);
        if (!ranges.empty() && offset - (ranges.back().offset + ranges.back().size) < gap)
            ranges.back().size = end - ranges.back().offset;
        else
            ranges.push_back({offset, end - offset});
    }
    return ranges;
}

Result<RemoteFile> RemoteFile::open(std::string_view address, const CacheFolder& cache, const RemoteOptions& options,
                                    const Progress& progress)
{
    if (!isRemoteAddress(address) || address.size() > longestAddress || addressWithoutUser(address).empty()) {
        Refusal refusal = refusedTransfer(CURLE_URL_MALFORMAT, nullptr, 0);
        return cannotRead(address, refusal);
    }
    const auto work = [&]() -> Result<RemoteFile> {
        const auto shared = std::make_shared<Shared>(address, options);
        if (const Status opened = shared->open(cache, progress); !opened)
            return opened.error();
        return RemoteFile(shared);
    };
    return guarded(notEnoughMemory, work, shownAddress(address));
}

const std::string& RemoteFile::address() const noexcept
{
    return shared_->address;
}

std::uint64_t RemoteFile::size() const noexcept
{
    return shared_->size;
}

std::string RemoteFile::state() const
{
    return shared_->state;
}

ByteSource RemoteFile::source() const
{
    return {
        .size = shared_->size,
        .read = [shared = shared_](std::uint64_t offset, std::span<std::byte> to,
                                   const Progress& progress) { return shared->read(offset, to, progress); },
        .fetch = [shared = shared_](std::span<const ByteRange> ranges,
                                    const Progress& progress) { return shared->fetch(ranges, progress); },
    };
}

RemoteCounts RemoteFile::counts() const
{
    return shared_->counts();
}

void RemoteFile::forget() const
{
    shared_->forget();
}

} // namespace tetra
