// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/blocks/run_batches.h"

#include <algorithm>

namespace tetra {

Result<std::optional<std::uint32_t>> RunBatches::nextKey()
{
    if (position_ == buffer_.size() && read_ == files_->header(block_).wordCount)
        return std::optional<std::uint32_t>();
    if (const Status fetched = fetch(1); !fetched)
        return fetched.error();
    return std::optional(take());
}

Result<std::uint32_t> RunBatches::groupCount()
{
    if (const Status fetched = fetch(1); !fetched)
        return fetched.error();
    return take();
}

Result<RunBatches::Group> RunBatches::nextGroup()
{
    if (const Status fetched = fetch(3); !fetched)
        return fetched.error();
    const std::uint32_t sites = take();
    Group group{take(), take(), {}};
    if (const Status fetched = fetch(sites); !fetched)
        return fetched.error();
    group.points = std::span(buffer_).subspan(position_, sites);
    position_ += sites;
    return group;
}

/// Makes sure that so many words are in the buffer.
Status RunBatches::fetch(std::uint32_t words)
{
    const std::size_t have = buffer_.size() - position_;
    if (have >= words)
        return {};
    std::ranges::copy(std::span(buffer_).subspan(position_), buffer_.begin());
    const std::uint64_t left = files_->header(block_).wordCount - read_;
    const std::uint64_t more = std::min<std::uint64_t>(std::max<std::uint64_t>(words - have, bufferWords_), left);
    buffer_.resize(have + std::max<std::uint64_t>(more, words - have));
    position_ = 0;
    const std::span<std::uint32_t> room = std::span(buffer_).subspan(have);
    const Status read = files_->readWords(block_, read_, room); // tells a run that ends too early
    read_ += room.size();
    return read;
}

} // namespace tetra
