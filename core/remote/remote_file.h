// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/byte_source.h"
#include "core/remote/address.h"
#include "core/remote/cache_folder.h"

#include <tan/base.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

struct RemoteOptions {
    /// A wait ends with an error when for so long no further 16 KiB have come: whether the server is silent, drips, or
    /// breaks off again and again.
    std::chrono::milliseconds silence{30'000};
    /// How often a request that broke off is made again, as long as no attempt brings anything; the first pause, which
    /// doubles.
    int retries = 5;
    std::chrono::milliseconds firstPause{200};
    /// Bytes a second that are asked of the server, all requests together; 0: no limit.
    std::uint64_t bytesPerSecond = 0;
    /// Goes along as "Authorization: Bearer"; then redirections are not followed.
    std::string token{};
    /// Asks for all of it, and leaves nothing in the cache.
    bool afresh = false;
};

/// What reading has cost since the file was opened.
struct RemoteCounts {
    std::uint64_t requests = 0;    ///< those that were made again, and redirections, too
    std::uint64_t bytes = 0;       ///< of content that came, without heads
    std::uint64_t roundTrips = 0;  ///< answers that were waited for one after the other, without those of connecting
    std::uint64_t connections = 0; ///< that were opened
    std::uint64_t breaks = 0;      ///< requests that broke off and were made again
};

/// Whether an error says that a server gives a file only to whom it knows (401).
TAN_INTERNAL bool isUnauthorized(const Error& error);

/// The ranges to request for the pieces: neighbours, and those with fewer than `gap` bytes between them, share one
/// range. `pieces` ascend and are `pieceBytes` long, the last one of a file of `size` bytes less.
TAN_INTERNAL std::vector<ByteRange> mergedRanges(std::span<const std::uint64_t> pieces, std::uint64_t pieceBytes,
                                                 std::uint64_t gap, std::uint64_t size);

/// A file on any HTTP server that gives ranges of it (R28, B5). open() makes one request, of the first 16 KiB; source()
/// then reads what it has in a cache folder (piece_store.h) and asks the server for what it has not: ranges with less
/// than 64 KiB between them merged, at most four at a time over connections that stay open; a broken transfer resumes
/// where it stopped. Only the data in transit are in memory.
///
/// Each answer is held against the first one: a file that is changed meanwhile is refused, with If-Range before its
/// bytes come. What the server sends is otherwise taken as it is: whoever reads a model checks it. Without an
/// ETag or a Last-Modified that is past (HttpAnswer::tellsChanges()) nothing tells a changed file of the same size, and
/// the cache is emptied at the end.
///
/// source() may be called from any number of threads; those that need the network wait for each other. Cancelling ends
/// each call within a tenth of a second. Copies share the file. Errors name the address and say what to do: BadInput
/// for all that server and network do, WrongUsage for what is no address, CannotWrite where the cache has no room.
class TAN_INTERNAL RemoteFile {
public:
    static Result<RemoteFile> open(std::string_view address, const CacheFolder& cache,
                                   const RemoteOptions& options = {}, const Progress& progress = {});

    const std::string& address() const noexcept;
    std::uint64_t size() const noexcept;
    /// What stands for this state of this file, for keys of a cache; empty if nothing tells its states apart.
    std::string state() const;
    /// fetch() reports progress, read() does not.
    ByteSource source() const;
    RemoteCounts counts() const;
    /// Throws away what the cache has of it, for whoever finds by checksums of its own that these are not the file's
    /// bytes: all is asked for again.
    void forget() const;

private:
    class Shared;
    explicit RemoteFile(std::shared_ptr<Shared> shared) : shared_(std::move(shared)) {}

    std::shared_ptr<Shared> shared_;
};

} // namespace tetra
