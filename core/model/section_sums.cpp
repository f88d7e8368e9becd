// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/section_sums.h"

#include <algorithm>

namespace tetra {

void SectionSums::add(std::span<const std::byte> bytes)
{
    whole_.add(bytes);
    while (!bytes.empty()) {
        const auto piece = bytes.first(std::min<std::size_t>(bytes.size(), format::chunkBytes - inChunk_));
        if (piece.size() == format::chunkBytes) {
            full_.push_back(checksum(piece));
        } else {
            chunk_.add(piece);
            inChunk_ += piece.size();
        }
        if (inChunk_ == format::chunkBytes) {
            full_.push_back(chunk_.value());
            chunk_.reset();
            inChunk_ = 0;
        }
        bytes = bytes.subspan(piece.size());
    }
}

std::vector<std::uint64_t> SectionSums::ofChunks() const
{
    std::vector<std::uint64_t> sums = full_;
    if (inChunk_ > 0)
        sums.push_back(chunk_.value());
    return sums;
}

void ChunkSums::append(const SectionSums& sums)
{
    const std::vector<std::uint64_t> chunks = sums.ofChunks();
    elements_.insert(elements_.end(), chunks.begin(), chunks.end());
}

} // namespace tetra
