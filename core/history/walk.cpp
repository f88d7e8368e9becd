// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/walk.h"

#include "core/history/site_positions.h"
#include "core/mesh/topology.h"

#include <algorithm>
#include <array>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace tetra {

Status walkHistory(const Model& model, std::uint32_t first, std::uint32_t end, const Progress& progress,
                   const Message& activity, const std::function<Status(const Stars&)>& visit)
{
    // Visited at once, as far as whole stars go: their offsets fit the cache.
    constexpr std::uint64_t tetrahedraAtOnce = 1 << 12;
    constexpr std::uint32_t starsAtOnce = 1 << 9;
    constexpr std::uint64_t piecesAtOnce = 64; // between two looks at whether the work was cancelled

    const std::uint64_t* const file = model.starOffsets().data();
    if (!model.check(file[first]) || !model.check(file[end]))
        return model.checkIntact();
    const std::uint64_t begin = file[first];
    const std::uint64_t all = file[end];
    if (begin > all || all > model.tetrahedronCount() || (first == 0 && begin != 0))
        return inconsistentModel(model, Message::say("its star offsets do not match its tetrahedra"));
    std::array<std::uint64_t, starsAtOnce + 1> offsets; // no vector, which takes a tenth of a prefix' time
    offsets[0] = begin;
    std::uint64_t piece = 0;
    for (std::uint32_t site = first; site < end; ++piece) {
        const std::uint32_t most = std::min(starsAtOnce, end - site);
        if (!model.check(model.starOffsets().subspan(site, most + std::size_t(1))))
            return model.checkIntact();
        std::uint32_t count = 0;
        while (count < most && offsets[count] - offsets[0] < tetrahedraAtOnce) {
            const std::uint64_t next = file[site + count + 1];
            if (next < offsets[count] || next > all)
                return inconsistentModel(model, Message::say("the star offsets of site %1 are invalid", site + count));
            offsets[++count] = next;
        }
        if (piece % piecesAtOnce == 0) {
            if (progress.cancelled())
                return cancelledError(activity);
            progress.report(static_cast<double>(offsets[0] - begin) / static_cast<double>(all - begin + 1), activity);
        }
        const Stars stars{model.otherSites(), model.destroyers(), site,
                          std::span(offsets).first(count + std::size_t(1))};
        if (!model.check(stars.otherSites.subspan(stars.first(), stars.count())) ||
            !model.check(stars.destroyers.subspan(stars.first(), stars.count())))
            return model.checkIntact();
        if (const Status visited = visit(stars); !visited)
            return visited;
        site += count;
        offsets[0] = offsets[count];
    }
    return {};
}

namespace {

bool comeBefore(const std::array<std::uint32_t, 3>& others, std::uint32_t creator)
{
    return (std::uint32_t(others[0] < creator) & std::uint32_t(others[1] < creator) &
            std::uint32_t(others[2] < creator)) != 0;
}

#if defined(__x86_64__)

/// A mapped file lies in small pages, at whose ends the processor stops to fetch by itself what comes next.
void fetchAhead(const Stars& stars, std::uint64_t tetrahedron)
{
    constexpr std::uint64_t ahead = 512;
    constexpr std::size_t line = 64;
    const auto* const others = reinterpret_cast<const char*>(stars.otherSites.data() + tetrahedron + ahead);
    for (std::size_t byte = 0; byte < 4 * line; byte += line) // a star's, more or less
        _mm_prefetch(others + byte, _MM_HINT_T0);
    _mm_prefetch(reinterpret_cast<const char*>(stars.destroyers.data() + tetrahedron + ahead), _MM_HINT_T0);
}

/// One tetrahedron at a time, its sites as one vector. SSE2 compares signed numbers: flipping the top bits of both
/// sides makes that the order of unsigned ones.
AliveScan scanPlainly(const Stars& stars, std::uint32_t sites, Tetrahedron* out)
{
    const __m128i topBits = _mm_set1_epi32(static_cast<int>(0x80000000));
    __m128i right = _mm_set1_epi32(-1);
    bool lastRight = true;
    const std::uint64_t last = stars.otherSites.size() - 1; // 16 bytes cannot be read there
    for (std::size_t star = 0; star + 1 < stars.offsets.size(); ++star) {
        const std::uint32_t creator = stars.firstSite + static_cast<std::uint32_t>(star);
        const __m128i creators = _mm_xor_si128(_mm_set1_epi32(static_cast<int>(creator)), topBits);
        const __m128 creatorFirst = _mm_castsi128_ps(_mm_cvtsi32_si128(static_cast<int>(creator)));
        std::uint64_t t = stars.offsets[star];
        const std::uint64_t end = stars.offsets[star + 1];
        fetchAhead(stars, t);
        for (; t < std::min(end, last); ++t) {
            const __m128i others = _mm_loadu_si128(reinterpret_cast<const __m128i*>(stars.otherSites.data() + t));
            right = _mm_and_si128(right, _mm_cmplt_epi32(_mm_xor_si128(others, topBits), creators));
            const __m128 shifted = _mm_castsi128_ps(_mm_shuffle_epi32(others, _MM_SHUFFLE(2, 1, 0, 0)));
            _mm_storeu_ps(reinterpret_cast<float*>(out), _mm_move_ss(shifted, creatorFirst));
            out += stars.destroyers[t] >= sites;
        }
        if (t < end) {
            const std::array<std::uint32_t, 3> others = stars.otherSites[t];
            lastRight = comeBefore(others, creator);
            *out = {creator, others[0], others[1], others[2]};
            out += stars.destroyers[t] >= sites;
        }
    }
    constexpr int threeNumbers = 0x0fff; // the fourth belongs to the next tetrahedron
    return {out, lastRight && (_mm_movemask_epi8(right) & threeNumbers) == threeNumbers};
}

#else

AliveScan scanPlainly(const Stars& stars, std::uint32_t sites, Tetrahedron* out)
{
    bool right = true;
    for (std::size_t star = 0; star + 1 < stars.offsets.size(); ++star) {
        const std::uint32_t creator = stars.firstSite + static_cast<std::uint32_t>(star);
        for (std::uint64_t t = stars.offsets[star]; t < stars.offsets[star + 1]; ++t) {
            const std::array<std::uint32_t, 3> others = stars.otherSites[t];
            right &= comeBefore(others, creator);
            *out = {creator, others[0], others[1], others[2]};
            out += stars.destroyers[t] >= sites;
        }
    }
    return {out, right};
}

#endif

#if defined(TETRA_SIMD_16)

/// The four lanes of each of four tetrahedra, for each set of them.
constexpr std::array<std::uint16_t, 16> laneTable = {0x0000, 0x000f, 0x00f0, 0x00ff, 0x0f00, 0x0f0f, 0x0ff0, 0x0fff,
                                                     0xf000, 0xf00f, 0xf0f0, 0xf0ff, 0xff00, 0xff0f, 0xfff0, 0xffff};

/// Four tetrahedra at a time: 12 numbers are spread to 16, the living ones pushed together. All but the last few of a
/// star go without masks for what is there.
TETRA_SIMD_16 AliveScan scanBySixteen(const Stars& stars, std::uint32_t sites, Tetrahedron* out)
{
    constexpr std::uint32_t otherLanes = 0xeeee; // all but the creators'
    constexpr __mmask16 twelve = 0x0fff;
    const __m512i spread = _mm512_set_epi32(11, 10, 9, 0, 8, 7, 6, 0, 5, 4, 3, 0, 2, 1, 0, 0);
    const __m128i bound = _mm_set1_epi32(static_cast<int>(sites));
    __mmask16 wrong = 0;
    for (std::size_t star = 0; star + 1 < stars.offsets.size(); ++star) {
        const std::uint32_t creator = stars.firstSite + static_cast<std::uint32_t>(star);
        const __m512i creators = _mm512_set1_epi32(static_cast<int>(creator));
        const std::uint64_t end = stars.offsets[star + 1];
        std::uint64_t t = stars.offsets[star];
        fetchAhead(stars, t);
        for (; t + 4 <= end; t += 4) {
            const __m128i destroyers = _mm_loadu_si128(reinterpret_cast<const __m128i*>(stars.destroyers.data() + t));
            const std::uint32_t alive = _mm_cmpge_epu32_mask(destroyers, bound);
            const __m512i numbers = _mm512_maskz_loadu_epi32(twelve, stars.otherSites.data() + t);
            const __m512i four = _mm512_mask_permutexvar_epi32(creators, otherLanes, spread, numbers);
            wrong = _kor_mask16(wrong, _mm512_mask_cmpge_epu32_mask(otherLanes, four, creators));
            _mm512_storeu_si512(out, _mm512_maskz_compress_epi32(laneTable[alive], four));
            out += __builtin_popcount(alive);
        }
        if (t < end) {
            const auto present = static_cast<std::uint32_t>(0xf >> (4 - (end - t)));
            const auto presentNumbers = static_cast<__mmask16>(_pdep_u32(present, 0x249) * 0x7);
            const std::uint32_t alive = _mm_mask_cmpge_epu32_mask(
                static_cast<__mmask8>(present),
                _mm_maskz_loadu_epi32(static_cast<__mmask8>(present), stars.destroyers.data() + t), bound);
            const __m512i numbers = _mm512_maskz_loadu_epi32(presentNumbers, stars.otherSites.data() + t);
            const __m512i four = _mm512_mask_permutexvar_epi32(creators, otherLanes, spread, numbers);
            const auto otherNumbers = static_cast<__mmask16>(laneTable[present] & otherLanes);
            wrong = _kor_mask16(wrong, _mm512_mask_cmpge_epu32_mask(otherNumbers, four, creators));
            _mm512_storeu_si512(out, _mm512_maskz_compress_epi32(laneTable[alive], four));
            out += __builtin_popcount(alive);
        }
    }
    return {out, wrong == 0};
}

#endif

} // namespace

AliveScan scanAlive(const Stars& stars, std::uint32_t sites, std::array<std::uint32_t, 4>* out, SimdLevel level)
{
#if defined(TETRA_SIMD_16)
    if (level == SimdLevel::Sixteen)
        return scanBySixteen(stars, sites, out);
#else
    static_cast<void>(level);
#endif
    return scanPlainly(stars, sites, out);
}

} // namespace tetra
