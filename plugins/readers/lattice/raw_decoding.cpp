// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/raw_decoding.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstring>

namespace tetra {

namespace {

template <std::size_t Size> void reverseEach(std::span<std::byte> samples)
{
    for (std::size_t first = 0; first + Size <= samples.size(); first += Size)
        std::ranges::reverse(samples.subspan(first).template first<Size>());
}

} // namespace

void toNativeOrder(std::span<std::byte> samples, SampleType type, std::endian order)
{
    if (order == std::endian::native)
        return;
    switch (sampleSize(type)) {
    case 2: return reverseEach<2>(samples);
    case 4: return reverseEach<4>(samples);
    case 8: return reverseEach<8>(samples);
    default: return;
    }
}

Status copyRawSamples(std::span<const std::byte> encoded, SampleType type, std::endian order,
                      std::span<std::byte> samples, const Progress& progress)
{
    assert(encoded.size() == samples.size());
    constexpr std::size_t pieceBytes = std::size_t(4) << 20;
    for (std::size_t done = 0; done < samples.size(); done += pieceBytes) {
        if (progress.cancelled())
            return cancelledError(Message::marked("Reading"));
        const auto piece = samples.subspan(done, std::min(pieceBytes, samples.size() - done));
        std::memcpy(piece.data(), encoded.data() + done, piece.size());
        toNativeOrder(piece, type, order);
        progress.report(static_cast<double>(done + piece.size()) / static_cast<double>(samples.size()),
                        Message::marked("Reading"));
    }
    return {};
}

} // namespace tetra
