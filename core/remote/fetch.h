// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

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

/// Asks a server question after question on one connection (R28), which stays open in between for as long as the server
/// likes; one that it has closed is made anew. From any thread: of questions at once each has a connection of its own,
/// and that of the last one stays.
class ServerConnection {
public:
    /// As fetchOnce().
    Result<FetchedAnswer> fetch(const std::string& address, const std::string& token, std::uint64_t mostBytes,
                                const Progress& progress = {});

private:
    std::mutex mutex_;
    std::shared_ptr<void> kept_; ///< a handle of libcurl's, while no question is on its way; not shared
};

/// Asks a server once and takes its whole answer, of at most `mostBytes`; how long it thinks about it is its own
/// affair. A token goes along as "Authorization: Bearer" and nowhere else: redirections are not followed. Statuses that
/// refuse are answers, too. Cancelled within about a second. Errors: WrongUsage for what is no address, BadInput for
/// what network and server do, OutOfResource for too many bytes; they name the address without its query.
TAN_INTERNAL Result<FetchedAnswer> fetchOnce(const std::string& address, const std::string& token,
                                             std::uint64_t mostBytes, const Progress& progress = {});

} // namespace tetra
