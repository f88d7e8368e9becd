// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/open.h>

#include <cstdint>
#include <filesystem>

namespace tetra {

/// Where models go that are unpacked or fetched, as the user's settings say: which folder, and how much it may take.
struct CacheChoice {
    std::filesystem::path folder; ///< empty: the usual one
    int gigabytes = 0;            ///< of 10^9 bytes; 0: as usual
};

/// From any thread.
CacheChoice cacheChoice();
void setCacheChoice(const CacheChoice& choice);

/// The usual ones, with all filled in.
CacheChoice usualCache();

struct ServerOffer;

/// Whether a model on a server can be had here: the cache has the room for it, and this machine the memory to unpack
/// it. As far as the server tells.
bool fitsHere(const ServerOffer& offer);

/// For openModel().
OpenOptions cacheOptions();

/// What the folder takes now. Reads it. Errors: it cannot be made.
Result<std::uint64_t> cachedBytes();
/// Removes all that nobody uses.
Status clearCache();

} // namespace tetra
