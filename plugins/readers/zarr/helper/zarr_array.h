// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/zarr/helper/zarr_codecs.h"
#include "plugins/readers/zarr/helper/zarr_folder.h"
#include "plugins/readers/zarr/helper/zarr_numbers.h"

#include <tan/base.h>

#include <QJsonObject>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tetra {

/// How the numbers of a chunk lie in it.
struct ZarrChunks {
    std::vector<std::uint64_t> shape;
    std::vector<std::size_t> order; ///< the axes of the array, from the one that runs slowest to the fastest
    bool isBigEndian = false;
    std::vector<ZarrCodec> codecs{}; ///< as they were applied

    std::uint64_t numberCount() const
    {
        std::uint64_t count = 1;
        for (const std::uint64_t size : shape)
            count *= size; // checked when it was read
        return count;
    }
};

/// Chunks of chunks in one file, with an index of them.
struct ZarrShards {
    std::vector<std::uint64_t> shape;
    bool indexIsFirst = false; ///< else at the end of the file
    bool indexHasChecksum = false;
    bool indexIsBigEndian = false;
};

/// What the metadata say of an array.
struct ZarrArray {
    std::string path; ///< in the folder that was opened
    int version = 2;
    std::vector<std::uint64_t> shape;
    ZarrNumber number = ZarrNumber::UInt8;
    ZarrChunks chunks;                    ///< those that are unpacked
    std::optional<ZarrShards> shards{};   ///< the files in which these lie, if there are any
    std::vector<std::byte> fill{};        ///< keptNumber(): what chunks have that nobody wrote
    bool fillIsSaid = true;               ///< else it is 0
    char separator = '.';                 ///< between the numbers of a chunk in the name of its file
    bool separatorIsSaid = true;          ///< else it may be the other one
    bool namesBeginWithC = false;         ///< "c/0/0/0"
    std::vector<std::string> axisNames{}; ///< as many as axes, or none; empty texts where one has none
    QJsonObject attributes{};

    const std::vector<std::uint64_t>& fileShape() const { return shards ? shards->shape : chunks.shape; }
};

/// What a folder says that it is, unread.
struct ZarrNode {
    enum class Kind : std::uint8_t { None, Group, Array };
    Kind kind = Kind::None;
    int version = 2;
    QJsonObject metadata{};
    QJsonObject attributes{};
};

/// Of the folder of this path; version 3 where both are there.
Result<ZarrNode> zarrNode(const ZarrFolder& folder, const std::string& path);

/// The array that a node is. Errors, sentences about "it": what is missing, contradicts itself, or is not read, by its
/// name.
Result<ZarrArray> zarrArray(const std::string& path, const ZarrNode& node);

/// The name of the file of a chunk (or of a shard), from the array's own folder.
std::string chunkName(const ZarrArray& array, const std::vector<std::uint64_t>& numbers);

} // namespace tetra
