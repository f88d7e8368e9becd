// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/sample_section.h"

#include <algorithm>

namespace tetra {

namespace {

constexpr std::uint64_t siteBytes = 4 + 4 + 8 + 4 + 1; // all but the value
constexpr std::uint64_t tetrahedronBytes = 12 + 4 + 2;
constexpr std::uint64_t shareOfArrays = 8;
constexpr std::size_t pieceBytes = 1 << 20;

} // namespace

std::uint64_t arrayBytes(const ModelCounts& counts, SampleType type) noexcept
{
    return counts.sites * (siteBytes + sampleSize(type)) + counts.tetrahedra * tetrahedronBytes;
}

bool keepsSamples(DomainClass domain, SampleType type, std::size_t positionBytes, std::uint64_t points,
                  const ModelCounts& counts) noexcept
{
    return isOnLattice(domain) &&
           points * (sampleSize(type) + positionBytes) <= arrayBytes(counts, type) / shareOfArrays;
}

Status writeSamples(const ScalarField& samples, const std::function<Status(std::span<const std::byte>)>& write)
{
    const std::span<const std::byte> bytes = samples.bytes();
    for (std::size_t at = 0; at < bytes.size(); at += pieceBytes)
        if (const Status written = write(bytes.subspan(at, std::min(pieceBytes, bytes.size() - at))); !written)
            return written;
    return {};
}

} // namespace tetra
