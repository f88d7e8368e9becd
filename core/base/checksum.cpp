// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/checksum.h"

#include "core/base/simd.h"

#include <climits>
#include <cstdlib>
#include <cstring>

// With the definitions in view the state is a plain member: creating one cannot fail on its own.
#define XXH_STATIC_LINKING_ONLY
#include <xxhash.h>

namespace tetra {

namespace {

std::uint64_t checksumByLibrary(std::span<const std::byte> bytes) noexcept
{
    return XXH3_64bits(bytes.data(), bytes.size());
}

} // namespace

struct Checksum::State {
    XXH3_state_t content;
};

Checksum::Checksum() : state_(std::make_unique<State>())
{
    XXH3_64bits_reset(&state_->content);
}

Checksum::~Checksum() = default;
Checksum::Checksum(Checksum&&) noexcept = default;
Checksum& Checksum::operator=(Checksum&&) noexcept = default;

void Checksum::add(std::span<const std::byte> bytes) noexcept
{
    XXH3_64bits_update(&state_->content, bytes.data(), bytes.size());
}

std::uint64_t Checksum::value() const noexcept
{
    return XXH3_64bits_digest(&state_->content);
}

void Checksum::reset() noexcept
{
    XXH3_64bits_reset(&state_->content);
}

} // namespace tetra

// The library's functions are compiled for the least processor that there is, which takes three times as long. So once
// more from the source, under names of their own, for processors with wider vectors.
#if defined(TETRA_SIMD_8)
#include <immintrin.h>
#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2")
#endif
#define XXH_VECTOR 2 // XXH_AVX2: the macros of the processor are those of before the pragma
#define XXH_INLINE_ALL
#include <xxhash.h>

namespace tetra {

namespace {

std::uint64_t checksumWithAvx2(std::span<const std::byte> bytes) noexcept
{
    return XXH3_64bits(bytes.data(), bytes.size());
}

} // namespace

} // namespace tetra
#if defined(__clang__)
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif
#endif

namespace tetra {

std::uint64_t checksum(std::span<const std::byte> bytes) noexcept
{
#if defined(TETRA_SIMD_8)
    if (simdLevel() >= SimdLevel::Eight)
        return checksumWithAvx2(bytes);
#endif
    return checksumByLibrary(bytes);
}

} // namespace tetra
