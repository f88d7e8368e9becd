// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/remote/fetch.h"

#include "core/base/guarded.h"
#include "core/remote/address.h"
#include "core/remote/http_answer.h"
#include "core/remote/libcurl.h"
#include "core/remote/transfer_error.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <new>
#include <span>
#include <thread>
#include <utility>

namespace tetra {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr std::size_t longestAddress = 64 << 10; ///< with a question
constexpr std::chrono::seconds mostForConnectingOnce{15};
constexpr milliseconds longestWaitForTurn{5'000}, usualWaitForTurn{1'000}, betweenLooks{50};
constexpr std::uint64_t mostOfRefusal = 64 << 10, mostUnannounced = std::uint64_t(256) << 20;
constexpr std::uint64_t leastInSilence = 16 << 10;

/// A question on its way.
struct Fetching {
    const Progress& progress;
    const FetchLimits& limits;
    HttpAnswer head{};
    std::size_t headBytes = 0;
    std::vector<std::byte> content{};
    Clock::time_point since = Clock::now(); ///< when it was asked, or enough had come at last
    std::uint64_t cameBefore = 0;           ///< bytes of content that had come then
    bool isCut = false;                     ///< more than is taken of a refusal or of another type was on its way
    bool tooLarge = false;
    bool isSilent = false;
    bool lacksMemory = false; ///< libcurl, which calls us, knows no exceptions

    bool isWanted() const { return head.status == 200 && head.contentType == limits.type; }
    std::uint64_t mostBytes() const
    {
        if (!isWanted())
            return std::min(limits.mostBytes, mostOfRefusal);
        return head.contentLength ? limits.mostBytes : std::min(limits.mostBytes, mostUnannounced);
    }
};

std::size_t takeFetchedHead(char* line, std::size_t, std::size_t size, void* user)
try {
    constexpr std::size_t longestHead = 64 << 10;
    Fetching& fetching = *static_cast<Fetching*>(user);
    fetching.headBytes += size;
    if (fetching.headBytes > longestHead)
        return 0;
    takeHeaderLine(fetching.head, {line, size});
    return size;
} catch (const std::bad_alloc&) {
    static_cast<Fetching*>(user)->lacksMemory = true;
    return 0;
}

std::size_t takeFetchedContent(char* data, std::size_t, std::size_t size, void* user)
try {
    Fetching& fetching = *static_cast<Fetching*>(user);
    const auto bytes = std::as_bytes(std::span(data, size));
    const std::uint64_t room = fetching.mostBytes() - fetching.content.size();
    const bool isAnnounced = fetching.head.contentLength.value_or(0) > fetching.mostBytes();
    if (fetching.isWanted() && (size > room || isAnnounced)) {
        fetching.tooLarge = true;
        return 0;
    }
    fetching.isCut = size > room;
    const auto taken = bytes.first(std::min<std::uint64_t>(size, room));
    fetching.content.insert(fetching.content.end(), taken.begin(), taken.end());
    return taken.size();
} catch (const std::bad_alloc&) {
    static_cast<Fetching*>(user)->lacksMemory = true;
    return 0;
}

int tellFetching(void* user, curl_off_t expected, curl_off_t now, curl_off_t, curl_off_t)
{
    Fetching& fetching = *static_cast<Fetching*>(user);
    constexpr MarkedText waiting = Message::marked("Waiting for the server"), receiving = Message::marked("Receiving");
    fetching.progress.report(expected > 0 ? double(now) / double(expected) : 0, now > 0 ? receiving : waiting);
    const Clock::time_point time = Clock::now();
    const std::uint64_t came = fetching.content.size();
    if (came >= fetching.cameBefore + leastInSilence || (came > 0 && fetching.cameBefore == 0)) {
        fetching.since = time;
        fetching.cameBefore = came;
    }
    const bool isComplete = came > 0 && came == fetching.head.contentLength;
    fetching.isSilent =
        !isComplete && time - fetching.since > (came > 0 ? fetching.limits.silence : fetching.limits.thinking);
    return fetching.isSilent || fetching.progress.cancelled() ? 1 : 0;
}

Error noAnswer(const std::string& shown, const Refusal& refusal)
{
    return {refusal.kind, Message::say("'%1' does not answer: %2", shown, refusal.reason), shown};
}

/// An answer, and after how long to ask again if it says so.
struct Fetched {
    FetchedAnswer answer;
    milliseconds wait;
};

/// `curl`: set for the address.
Result<Fetched> fetched(CURL* curl, const std::string& shown, const std::string& token, const FetchLimits& limits,
                        const Progress& progress)
{
    std::unique_ptr<curl_slist, decltype(&::curl_slist_free_all)> headers(nullptr, &::curl_slist_free_all);
    if (!token.empty())
        headers.reset(::curl_slist_append(nullptr, ("Authorization: Bearer " + token).c_str()));
    if (!token.empty() && !headers)
        throw std::bad_alloc();
    Fetching fetching{progress, limits};
    std::array<char, CURL_ERROR_SIZE> detail{};
    CurlOptions options(curl);
    // A way that is dead, as behind a router that has forgotten it, is told from a server that thinks.
    options.set(CURLOPT_HTTPHEADER, headers.get())
        .set(CURLOPT_TCP_KEEPALIVE, 1L)
        .set(CURLOPT_TCP_KEEPIDLE, 10L)
        .set(CURLOPT_TCP_KEEPINTVL, 5L)
        .set(CURLOPT_ERRORBUFFER, detail.data())
        .set(CURLOPT_HEADERFUNCTION, &takeFetchedHead)
        .set(CURLOPT_HEADERDATA, &fetching)
        .set(CURLOPT_WRITEFUNCTION, &takeFetchedContent)
        .set(CURLOPT_WRITEDATA, &fetching)
        .set(CURLOPT_NOPROGRESS, 0L)
        .set(CURLOPT_XFERINFOFUNCTION, &tellFetching)
        .set(CURLOPT_XFERINFODATA, &fetching);
    if (options.code() != CURLE_OK) {
        ::curl_easy_reset(curl); // it points to what ends here
        return noAnswer(shown, refusedSettings(options.code()));
    }
    const CURLcode code = ::curl_easy_perform(curl);
    ::curl_easy_reset(curl); // it points to what ends here
    if (fetching.lacksMemory || code == CURLE_OUT_OF_MEMORY)
        throw std::bad_alloc();
    if (fetching.tooLarge)
        return Error{ErrorKind::OutOfResource, Message::say("'%1' sends more than %2, the most that is accepted.",
                                                            shown, neededBytesText(fetching.mostBytes()))};
    if (fetching.isSilent) {
        const milliseconds waited = fetching.content.empty() ? limits.thinking : limits.silence;
        return noAnswer(
            shown,
            again(Message::say(
                "nothing arrived for %1 seconds, or too slowly. Check the network, and whether the server is running.",
                formatNumber(double(waited.count()) / 1000))));
    }
    if (code == CURLE_ABORTED_BY_CALLBACK)
        return cancelledError(Message::marked("Asking the server"));
    if (!fetching.isCut && (code != CURLE_OK || fetching.head.status == 0))
        return noAnswer(shown,
                        code == CURLE_OK ? noHttp() : refusedTransfer(code, detail.data(), fetching.head.status));
    const auto asked = fetching.head.retryAfter;
    return Fetched{{fetching.head.status, fetching.head.contentType, std::move(fetching.content)},
                   asked ? std::min<milliseconds>(std::chrono::seconds(*asked), longestWaitForTurn) : usualWaitForTurn};
}

/// False if the wait was ended by a request to cancel.
bool waitFor(milliseconds time, const Progress& progress)
{
    const Clock::time_point end = Clock::now() + time;
    while (Clock::now() < end) {
        if (progress.cancelled())
            return false;
        progress.report(0, Message::marked("Waiting for the server"));
        std::this_thread::sleep_for(std::min<Clock::duration>(betweenLooks, end - Clock::now()));
    }
    return true;
}

} // namespace

Result<FetchedAnswer> ServerConnection::fetch(const std::string& address, const std::string& token,
                                              const FetchLimits& limits, const Progress& progress)
{
    const auto askOnce = [&](const std::string& shown) -> Result<Fetched> {
        std::shared_ptr<void> handle;
        {
            const std::lock_guard lock(mutex_);
            handle = std::exchange(kept_, nullptr);
        }
        if (handle == nullptr)
            handle.reset(newCurlHandle(), &::curl_easy_cleanup);
        if (handle == nullptr)
            throw std::bad_alloc();
        if (const CURLcode code = setCurlHandle(handle.get(), address, mostForConnectingOnce); code != CURLE_OK)
            return noAnswer(shown, refusedSettings(code));
        auto answer = fetched(handle.get(), shown, token, limits, progress);
        const std::lock_guard lock(mutex_);
        kept_.swap(handle);
        return answer;
    };
    const auto ask = [&]() -> Result<FetchedAnswer> {
        constexpr std::size_t mostShown = 16 << 10;
        const std::string shown = shownAddress(address.substr(0, mostShown));
        if (!isRemoteAddress(address) || address.size() > longestAddress)
            return Error{
                ErrorKind::WrongUsage,
                Message::say("'%1' is not the address of a server. Write it as http://HOST:PORT/NAME.tan.", shown)};
        for (int attempt = 0;; ++attempt) {
            auto got = askOnce(shown);
            if (!got)
                return got.error();
            if (!isBusy(got->answer.status) || attempt >= limits.retries)
                return std::move(got->answer);
            if (!waitFor(got->wait, progress))
                return cancelledError(Message::marked("Asking the server"));
        }
    };
    return guarded(Message::marked("Not enough memory for the server's answer. Request less."), ask);
}

Result<FetchedAnswer> fetchOnce(const std::string& address, const std::string& token, const FetchLimits& limits,
                                const Progress& progress)
{
    return ServerConnection().fetch(address, token, limits, progress);
}

} // namespace tetra
