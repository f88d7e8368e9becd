// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/queries/number_selection.h"

#include <array>
#include <vector>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace tetra {

namespace {

std::uint32_t* selectFrom(std::size_t first, std::span<const std::uint32_t> numbers, std::uint32_t least,
                          std::uint32_t largest, std::uint32_t* out)
{
    for (std::size_t place = first; place < numbers.size(); ++place) {
        *out = static_cast<std::uint32_t>(place);
        out += numbers[place] - least <= largest - least ? 1 : 0; // modulo 2^32: one comparison for both ends
    }
    return out;
}

std::uint32_t* selectPortably(std::span<const std::uint32_t> numbers, std::uint32_t least, std::uint32_t largest,
                              std::uint32_t* out)
{
    return selectFrom(0, numbers, least, largest, out);
}

#if defined(__x86_64__)

/// For each set of eight lanes the lanes themselves, pushed together.
constexpr std::array<std::array<std::uint8_t, 8>, 256> packedLanes()
{
    std::array<std::array<std::uint8_t, 8>, 256> table{};
    for (unsigned set = 0; set < 256; ++set)
        for (unsigned lane = 0, count = 0; lane < 8; ++lane)
            if ((set >> lane & 1) != 0)
                table[set][count++] = static_cast<std::uint8_t>(lane);
    return table;
}
constexpr std::array<std::array<std::uint8_t, 8>, 256> selectedLanes = packedLanes();

[[gnu::target("avx2,popcnt")]] std::uint32_t*
selectWithAvx2(std::span<const std::uint32_t> numbers, std::uint32_t least, std::uint32_t largest, std::uint32_t* out)
{
    const __m256i lows = _mm256_set1_epi32(static_cast<int>(least));
    const __m256i widths = _mm256_set1_epi32(static_cast<int>(largest - least));
    std::size_t place = 0;
    for (; place + 8 <= numbers.size(); place += 8) {
        const __m256i eight = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(numbers.data() + place));
        const __m256i offsets = _mm256_sub_epi32(eight, lows);
        const __m256i within = _mm256_cmpeq_epi32(_mm256_min_epu32(offsets, widths), offsets);
        const auto set = static_cast<unsigned>(_mm256_movemask_ps(_mm256_castsi256_ps(within)));
        const __m128i lanes = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(selectedLanes[set].data()));
        const __m256i places =
            _mm256_add_epi32(_mm256_cvtepu8_epi32(lanes), _mm256_set1_epi32(static_cast<int>(place)));
        _mm256_storeu_si256(reinterpret_cast<__m256i*>(out), places);
        out += __builtin_popcount(set);
    }
    return selectFrom(place, numbers, least, largest, out);
}

[[gnu::target("avx512f,popcnt")]] std::uint32_t*
selectWithAvx512(std::span<const std::uint32_t> numbers, std::uint32_t least, std::uint32_t largest, std::uint32_t* out)
{
    const __m512i lows = _mm512_set1_epi32(static_cast<int>(least));
    const __m512i widths = _mm512_set1_epi32(static_cast<int>(largest - least));
    __m512i places = _mm512_set_epi32(15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0);
    const __m512i step = _mm512_set1_epi32(16);
    std::size_t place = 0;
    for (; place + 16 <= numbers.size(); place += 16) {
        const __m512i offsets = _mm512_sub_epi32(_mm512_loadu_si512(numbers.data() + place), lows);
        const __mmask16 within = _mm512_cmple_epu32_mask(offsets, widths);
        _mm512_storeu_si512(out, _mm512_maskz_compress_epi32(within, places));
        out += __builtin_popcount(within);
        places = _mm512_add_epi32(places, step);
    }
    return selectFrom(place, numbers, least, largest, out);
}

#endif

std::vector<NumberSelectionVariant> runnableSelections()
{
    std::vector<NumberSelectionVariant> selections;
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx512f"))
        selections.push_back({"avx512", selectWithAvx512});
    if (__builtin_cpu_supports("avx2"))
        selections.push_back({"avx2", selectWithAvx2});
#endif
    selections.push_back({"portable", selectPortably});
    return selections;
}

} // namespace

std::span<const NumberSelectionVariant> numberSelections()
{
    static const std::vector<NumberSelectionVariant> selections = runnableSelections();
    return selections;
}

} // namespace tetra
