// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// A server's answer to one question.
struct FetchedAnswer {
    int status = 0;
    std::string contentType; ///< small letters, without parameters
    std::vector<std::byte> content;
};

/// What an answer may be, and how long it may take.
struct FetchLimits {
    /// The media type that is wanted. Of anything else, and of refusals, no more than the first 64 KiB are taken.
    std::string_view type;
    /// The most that is taken of what is wanted; at most 256 MiB of it if the server does not say how long it is.
    std::uint64_t mostBytes;
    /// How long the server may think before its answer begins.
    std::chrono::milliseconds thinking{30'000};
    /// What may pass then without the end or 16 KiB more.
    std::chrono::milliseconds silence{30'000};
    /// How often it is asked again when it says that it is at its limit (429, 503), after the time that it names, at
    /// most five seconds each.
    int retries = 3;
};

/// How long a server may think about what takes work: to open a model or to find a mesh. One that is gone is noticed
/// sooner, by the network itself.
inline constexpr std::chrono::milliseconds longestThinking{120'000};

/// Those of a mesh: no more than a part of this machine's memory.
inline FetchLimits limitsOfMesh(std::string_view type) noexcept
{
    constexpr std::uint64_t most = std::uint64_t(8) << 30;
    const std::uint64_t usable = usableBytes();
    return {type, usable == 0 ? most : std::min(most, usable / 4), longestThinking};
}

/// Asks a server question after question on one connection (R28), which stays open in between for as long as the server
/// likes; one that it has closed is made anew. From any thread: of questions at once each has a connection of its own,
/// and that of the last one stays.
class ServerConnection {
public:
    /// As fetchOnce().
    Result<FetchedAnswer> fetch(const std::string& address, const std::string& token, const FetchLimits& limits,
                                const Progress& progress = {});

private:
    std::mutex mutex_;
    std::shared_ptr<void> kept_; ///< a handle of libcurl's, while no question is on its way; not shared
};

/// Asks a server once and takes its whole answer. A token goes along as "Authorization: Bearer" and nowhere else:
/// redirections are not followed. Statuses that refuse are answers, too. Cancelled within about a second. Errors:
/// WrongUsage for what is no address, BadInput for what network and server do, silence among it, OutOfResource for too
/// many bytes; they name the address without its query.
TAN_INTERNAL Result<FetchedAnswer> fetchOnce(const std::string& address, const std::string& token,
                                             const FetchLimits& limits, const Progress& progress = {});

} // namespace tetra
