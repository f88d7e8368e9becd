// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/decimation/distinct_numbers.h"

#include "core/base/simd.h"

#include <bit>
#include <cstddef>

#if defined(TETRA_SIMD_16)
#include <immintrin.h>
#endif

namespace tetra {

namespace {

constexpr std::uint32_t noNumber = 0xffffffff;

#if defined(TETRA_SIMD_16)

constexpr std::size_t most = 64; ///< that registers hold

/// Compares each number with all that were met, sixteen at once. Returns how many distinct ones there are; gives up
/// with 0 where they are more than `most`.
TETRA_SIMD_16 std::size_t findInRegisters(std::span<const std::uint32_t> numbers, std::uint32_t* distinct,
                                          std::uint32_t* places)
{
    alignas(64) std::uint32_t met[most];
    __m512i first = _mm512_set1_epi32(-1);
    for (std::size_t i = 0; i < most; i += 16)
        _mm512_store_si512(met + i, first);
    std::size_t count = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const __m512i number = _mm512_set1_epi32(static_cast<int>(numbers[i]));
        std::uint64_t found = _mm512_cmpeq_epi32_mask(first, number);
        for (std::size_t block = 16; block < count; block += 16)
            found |= std::uint64_t(_mm512_cmpeq_epi32_mask(_mm512_load_si512(met + block), number)) << block;
        if (found != 0) {
            places[i] = static_cast<std::uint32_t>(std::countr_zero(found));
            continue;
        }
        if (count == most)
            return 0;
        if (count < 16)
            first = _mm512_mask_mov_epi32(first, static_cast<__mmask16>(1U << count), number);
        else
            met[count] = numbers[i];
        distinct[count] = numbers[i];
        places[i] = static_cast<std::uint32_t>(count++);
    }
    return count;
}

#endif

} // namespace

void DistinctNumbers::find(std::span<const std::uint32_t> numbers, std::vector<std::uint32_t>& distinct,
                           std::span<std::uint32_t> places)
{
#if defined(TETRA_SIMD_16)
    static const bool inRegisters = hasSimd16();
    if (inRegisters) {
        distinct.resize(most);
        const std::size_t count = findInRegisters(numbers, distinct.data(), places.data());
        distinct.resize(count);
        if (count > 0)
            return;
    }
#endif
    findByTable(numbers, distinct, places);
}

void DistinctNumbers::findByTable(std::span<const std::uint32_t> numbers, std::vector<std::uint32_t>& distinct,
                                  std::span<std::uint32_t> places)
{
    distinct.clear();
    const std::size_t last = std::bit_ceil(2 * numbers.size() + 1) - 1;
    table_.assign(last + 1, noNumber);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        std::size_t at = numbers[i] * std::size_t{0x9e3779b1} >> 7 & last;
        while (table_[at] != noNumber && distinct[table_[at]] != numbers[i])
            at = (at + 1) & last;
        if (table_[at] == noNumber) {
            table_[at] = static_cast<std::uint32_t>(distinct.size());
            distinct.push_back(numbers[i]);
        }
        places[i] = table_[at];
    }
}

} // namespace tetra
