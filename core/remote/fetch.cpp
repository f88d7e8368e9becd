// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/remote/fetch.h"

#include "core/base/guarded.h"
#include "core/remote/http_answer.h"
#include "core/remote/libcurl.h"
#include "core/remote/remote_file.h"

#include <array>
#include <chrono>
#include <memory>
#include <new>
#include <span>
#include <utility>

namespace tetra {
namespace {

constexpr std::chrono::seconds mostForConnectingOnce{15};

/// A question on its way.
struct Fetching {
    const Progress& progress;
    std::uint64_t mostBytes;
    HttpAnswer head{};
    std::size_t headBytes = 0;
    std::vector<std::byte> content{};
    bool tooLarge = false;
    bool lacksMemory = false; ///< libcurl, which calls us, knows no exceptions
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
    if (size > fetching.mostBytes - fetching.content.size()) {
        fetching.tooLarge = true;
        return 0;
    }
    const auto bytes = std::as_bytes(std::span(data, size));
    fetching.content.insert(fetching.content.end(), bytes.begin(), bytes.end());
    return size;
} catch (const std::bad_alloc&) {
    static_cast<Fetching*>(user)->lacksMemory = true;
    return 0;
}

int tellFetching(void* user, curl_off_t expected, curl_off_t now, curl_off_t, curl_off_t)
{
    const Fetching& fetching = *static_cast<Fetching*>(user);
    constexpr MarkedText waiting = Message::marked("Waiting for the server"), receiving = Message::marked("Receiving");
    fetching.progress.report(expected > 0 ? double(now) / double(expected) : 0, now > 0 ? receiving : waiting);
    return fetching.progress.cancelled() ? 1 : 0;
}

/// `curl`: set for the address.
Result<FetchedAnswer> fetched(CURL* curl, const std::string& shown, const std::string& token, std::uint64_t mostBytes,
                              const Progress& progress)
{
    std::unique_ptr<curl_slist, decltype(&::curl_slist_free_all)> headers(nullptr, &::curl_slist_free_all);
    if (!token.empty())
        headers.reset(::curl_slist_append(nullptr, ("Authorization: Bearer " + token).c_str()));
    if (!token.empty() && !headers)
        throw std::bad_alloc();
    Fetching fetching{progress, mostBytes};
    std::array<char, CURL_ERROR_SIZE> detail{};
    ::curl_easy_setopt(curl, CURLOPT_HTTPHEADER, headers.get());
    ::curl_easy_setopt(curl, CURLOPT_TCP_KEEPALIVE, 1L);
    ::curl_easy_setopt(curl, CURLOPT_ERRORBUFFER, detail.data());
    ::curl_easy_setopt(curl, CURLOPT_HEADERFUNCTION, &takeFetchedHead);
    ::curl_easy_setopt(curl, CURLOPT_HEADERDATA, &fetching);
    ::curl_easy_setopt(curl, CURLOPT_WRITEFUNCTION, &takeFetchedContent);
    ::curl_easy_setopt(curl, CURLOPT_WRITEDATA, &fetching);
    ::curl_easy_setopt(curl, CURLOPT_NOPROGRESS, 0L);
    ::curl_easy_setopt(curl, CURLOPT_XFERINFOFUNCTION, &tellFetching);
    ::curl_easy_setopt(curl, CURLOPT_XFERINFODATA, &fetching);
    const CURLcode code = ::curl_easy_perform(curl);
    ::curl_easy_reset(curl); // it points to what ends here
    if (fetching.lacksMemory || code == CURLE_OUT_OF_MEMORY)
        throw std::bad_alloc();
    if (fetching.tooLarge)
        return Error{ErrorKind::OutOfResource, Message::say("'%1' sends more than %2, the most that is taken.", shown,
                                                            neededBytesText(mostBytes))};
    if (code == CURLE_ABORTED_BY_CALLBACK)
        return cancelledError(Message::marked("Asking the server"));
    if (code == CURLE_COULDNT_CONNECT)
        return Error{
            ErrorKind::BadInput,
            Message::say("'%1' gives no answer: there is nothing at that host and port. Check the address, and "
                         "whether the server runs.",
                         shown)};
    if (code == CURLE_COULDNT_RESOLVE_HOST)
        return Error{
            ErrorKind::BadInput,
            Message::say("'%1' gives no answer: its host is not found. Check the address and the network.", shown)};
    if (code != CURLE_OK || fetching.head.status == 0)
        return Error{ErrorKind::BadInput,
                     Message::say("'%1' gives no answer (%2). Check the address, and whether the server runs.", shown,
                                  printable(detail[0] != 0 ? detail.data() : ::curl_easy_strerror(code)))};
    return FetchedAnswer{fetching.head.status, fetching.head.contentType, std::move(fetching.content)};
}

} // namespace

Result<FetchedAnswer> ServerConnection::fetch(const std::string& address, const std::string& token,
                                              std::uint64_t mostBytes, const Progress& progress)
{
    const auto ask = [&]() -> Result<FetchedAnswer> {
        const std::string shown = shownAddress(address);
        if (!isRemoteAddress(address))
            return Error{ErrorKind::WrongUsage,
                         Message::say("'%1' is no address of a server. Write it as http://HOST:PORT/NAME.tan.", shown)};
        std::shared_ptr<void> handle;
        {
            const std::lock_guard lock(mutex_);
            handle = std::exchange(kept_, nullptr);
        }
        if (handle == nullptr)
            handle.reset(newCurlHandle(address, mostForConnectingOnce), &::curl_easy_cleanup);
        else if (!renewCurlHandle(handle.get(), address, mostForConnectingOnce))
            throw std::bad_alloc();
        if (handle == nullptr)
            throw std::bad_alloc();
        auto answer = fetched(handle.get(), shown, token, mostBytes, progress);
        const std::lock_guard lock(mutex_);
        kept_.swap(handle);
        return answer;
    };
    return guarded(Message::marked("Not enough memory for what the server sends. Ask for less."), ask);
}

Result<FetchedAnswer> fetchOnce(const std::string& address, const std::string& token, std::uint64_t mostBytes,
                                const Progress& progress)
{
    return ServerConnection().fetch(address, token, mostBytes, progress);
}

} // namespace tetra
