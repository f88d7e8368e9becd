// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/zarr/helper/zarr_shard.h"

namespace tetra {
namespace {

constexpr std::uint64_t indexNumber = 8, indexEntry = 2 * indexNumber, checksumBytes = 4;

std::uint64_t numberIn(std::span<const std::byte> bytes, bool isBigEndian)
{
    std::uint64_t number = 0;
    for (std::size_t byte = 0; byte < indexNumber; ++byte)
        number = number << 8U | std::to_integer<std::uint64_t>(bytes[isBigEndian ? byte : indexNumber - 1 - byte]);
    return number;
}

Error damagedShard(const Message& how)
{
    return {ErrorKind::BadInput, Message::say("it is damaged: %1. Copy or export it again.", how)};
}

} // namespace

Result<ShardIndex> ShardIndex::of(const ZarrArray& array, std::span<const std::byte> file)
{
    const ZarrShards& shards = *array.shards;
    ShardIndex index;
    index.file_ = file;
    index.isBigEndian_ = shards.indexIsBigEndian;
    const std::uint64_t checksum = shards.indexHasChecksum ? checksumBytes : 0;
    std::uint64_t count = 1;
    for (std::size_t axis = 0; axis < shards.shape.size(); ++axis) {
        index.counts_.push_back(shards.shape[axis] / array.chunks.shape[axis]);
        if (index.counts_.back() > file.size()) // before the product overflows
            return damagedShard(Message::say("it is shorter than the index of its chunks"));
        count *= index.counts_.back();
        if (count > file.size() / indexEntry)
            return damagedShard(Message::say("it is shorter than the index of its chunks"));
    }
    const std::uint64_t length = count * indexEntry;
    if (length + checksum > file.size())
        return damagedShard(Message::say("it is shorter than the index of its chunks"));
    index.index_ = file.subspan(shards.indexIsFirst ? 0 : file.size() - length - checksum, length);
    if (shards.indexHasChecksum) {
        std::uint32_t said = 0;
        const std::byte* at = index.index_.data() + length;
        for (std::size_t byte = 0; byte < checksumBytes; ++byte)
            said |= std::to_integer<std::uint32_t>(at[byte]) << 8 * byte;
        if (said != castagnoliChecksum(index.index_))
            return damagedShard(Message::say("the checksum of the index of its chunks is wrong"));
    }
    return index;
}

Result<std::optional<std::span<const std::byte>>> ShardIndex::chunk(const std::vector<std::uint64_t>& numbers) const
{
    std::uint64_t entry = 0;
    for (std::size_t axis = 0; axis < numbers.size(); ++axis)
        entry = entry * counts_[axis] + numbers[axis];
    const std::uint64_t offset = numberIn(index_.subspan(entry * indexEntry), isBigEndian_);
    const std::uint64_t length = numberIn(index_.subspan(entry * indexEntry + indexNumber), isBigEndian_);
    if (~offset == 0 && ~length == 0)
        return std::optional<std::span<const std::byte>>();
    if (offset > file_.size() || length > file_.size() - offset)
        return damagedShard(Message::say("the index of its chunks points beyond its end"));
    return std::optional(file_.subspan(offset, length));
}

} // namespace tetra
