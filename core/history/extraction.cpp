// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/extraction.h"

#include "core/history/site_positions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <string>
#include <vector>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace tetra {

namespace {

using Tetrahedron = std::array<std::uint32_t, 4>;

bool comeBefore(const std::array<std::uint32_t, 3>& others, std::uint32_t creator)
{
    return (std::uint32_t(others[0] < creator) & std::uint32_t(others[1] < creator) &
            std::uint32_t(others[2] < creator)) != 0;
}

AliveScan scanPortably(const Stars& stars, std::uint32_t sites, Tetrahedron* out)
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
AliveScan scanWithSse2(const Stars& stars, std::uint32_t sites, Tetrahedron* out)
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

/// The four lanes of each of four tetrahedra, for each set of them.
constexpr std::array<std::uint16_t, 16> laneTable = {0x0000, 0x000f, 0x00f0, 0x00ff, 0x0f00, 0x0f0f, 0x0ff0, 0x0fff,
                                                     0xf000, 0xf00f, 0xf0f0, 0xf0ff, 0xff00, 0xff0f, 0xfff0, 0xffff};

/// Four tetrahedra at a time: 12 numbers are spread to 16, the living ones pushed together. All but the last few of a
/// star go without masks for what is there.
[[gnu::target("avx512f,avx512vl,avx512bw,bmi2,popcnt")]] AliveScan scanWithAvx512(const Stars& stars,
                                                                                  std::uint32_t sites, Tetrahedron* out)
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

bool hasAvx512()
{
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
           __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("bmi2");
}

#endif

std::vector<AliveScanVariant> runnableScans()
{
    std::vector<AliveScanVariant> scans;
#if defined(__x86_64__)
    if (hasAvx512())
        scans.push_back({"avx512", scanWithAvx512});
    scans.push_back({"sse2", scanWithSse2});
#endif
    scans.push_back({"portable", scanPortably});
    return scans;
}

} // namespace

std::span<const AliveScanVariant> aliveScans()
{
    static const std::vector<AliveScanVariant> scans = runnableScans();
    return scans;
}

namespace {

using Tetrahedron = std::array<std::uint32_t, 4>;

/// Scanned at once, as far as whole stars go: their offsets fit the cache, and the room behind the mesh is small.
constexpr std::uint64_t tetrahedraAtOnce = 1 << 12;
constexpr std::uint32_t starsScannedAtOnce = 1 << 9;
/// Room behind the mesh for tetrahedra that are written before it is known that they are dead.
constexpr std::uint64_t slack = 2 * tetrahedraAtOnce;
/// Pieces between two looks at whether the work was cancelled.
constexpr std::uint64_t piecesAtOnce = 64;

/// Takes the mesh out of the file, some stars at a time.
class PrefixScan {
public:
    PrefixScan(const Model& model, std::uint32_t sites, Buffer<Tetrahedron>& out)
        : model_(model), sites_(sites), expected_(model.meshSizes()[sites - 1]), out_(out)
    {
    }

    Status run(const Progress& progress);

private:
    Status readOffsets();
    bool check() const;
    Status scanStars();
    Status scanLongStars();
    Error tooMany() const;

    const Model& model_;
    const AliveScanFunction scan_ = aliveScans().front().scan;
    const std::uint32_t sites_;
    const std::uint64_t expected_;   ///< tetrahedra in the mesh, as the file says
    std::uint64_t scannedInAll_ = 0; ///< tetrahedra that the sites created
    Buffer<Tetrahedron>& out_;
    std::uint64_t found_ = 0;
    std::uint32_t site_ = 0;
    std::vector<std::uint64_t> offsets_; ///< a checked copy of those from site_ on: the file may change
};

Status PrefixScan::run(const Progress& progress)
{
    scannedInAll_ = model_.starOffsets()[sites_];
    if (!model_.check(model_.starOffsets()[0]) || !model_.check(model_.starOffsets()[sites_]))
        return model_.checkIntact();
    if (scannedInAll_ > model_.tetrahedronCount() || expected_ > scannedInAll_ || model_.starOffsets()[0] != 0)
        return inconsistentModel(model_, "its star offsets do not fit its mesh sizes");
    out_.resize(expected_ + slack);
    for (std::uint64_t piece = 0; site_ < sites_; ++piece) {
        if (const Status right = readOffsets(); !right)
            return right;
        if (piece % piecesAtOnce == 0) {
            if (progress.cancelled())
                return cancelledError("Extracting the mesh");
            progress.report(static_cast<double>(offsets_.front()) / static_cast<double>(scannedInAll_ + 1),
                            "Extracting the mesh");
        }
        if (!check())
            return model_.checkIntact();
        const bool fits = offsets_.back() - offsets_.front() + aliveScanOverrun <= out_.size() - found_;
        if (const Status right = fits ? scanStars() : scanLongStars(); !right)
            return right;
        site_ += static_cast<std::uint32_t>(offsets_.size() - 1);
    }
    if (found_ != expected_)
        return inconsistentModel(model_, "the mesh of " + std::to_string(sites_) + " sites has " +
                                             std::to_string(found_) + " tetrahedra instead of " +
                                             std::to_string(expected_));
    out_.resize(found_);
    return {};
}

/// The tetrahedra of the next piece. Here, because what is summed up now is still in the cache when it is scanned.
bool PrefixScan::check() const
{
    const std::uint64_t first = offsets_.front();
    const std::uint64_t count = offsets_.back() - first;
    return model_.check(model_.otherSites().subspan(first, count)) &&
           model_.check(model_.destroyers().subspan(first, count));
}

/// Copies and checks the offsets of the stars of the next piece.
Status PrefixScan::readOffsets()
{
    const std::uint64_t* const offsets = model_.starOffsets().data() + site_;
    const std::uint32_t most = std::min(starsScannedAtOnce, sites_ - site_);
    if (!model_.check(model_.starOffsets().subspan(site_, most + std::size_t(1))))
        return model_.checkIntact();
    offsets_.assign(1, offsets_.empty() ? 0 : offsets_.back());
    while (offsets_.size() <= most && offsets_.back() - offsets_.front() < tetrahedraAtOnce) {
        const std::uint64_t next = offsets[offsets_.size()];
        if (next < offsets_.back() || next > scannedInAll_)
            return inconsistentModel(model_, "the star offsets of site " + std::to_string(site_ + offsets_.size() - 1) +
                                                 " make no sense");
        offsets_.push_back(next);
    }
    return {};
}

Status PrefixScan::scanStars()
{
    const AliveScan scanned =
        scan_({model_.otherSites(), model_.destroyers(), site_, offsets_}, sites_, out_.data() + found_);
    found_ = static_cast<std::uint64_t>(scanned.end - out_.data());
    if (!scanned.sitesComeBefore)
        return inconsistentModel(model_, "a tetrahedron of site " + std::to_string(site_) +
                                             " or soon after has a site that " + "comes after its creator");
    return found_ > expected_ ? tooMany() : Status();
}

/// Stars that may have more tetrahedra than there is room for: one tetrahedron at a time.
Status PrefixScan::scanLongStars()
{
    for (std::size_t star = 0; star + 1 < offsets_.size(); ++star)
        for (std::uint64_t t = offsets_[star]; t < offsets_[star + 1]; ++t) {
            const auto creator = static_cast<std::uint32_t>(site_ + star);
            const std::array<std::uint64_t, 2> one = {t, t + 1};
            Tetrahedron alive[1 + aliveScanOverrun];
            const AliveScan scanned = scan_({model_.otherSites(), model_.destroyers(), creator, one}, sites_, alive);
            if (!scanned.sitesComeBefore)
                return inconsistentModel(model_, "a tetrahedron of site " + std::to_string(creator) +
                                                     " has a site that comes after its creator");
            if (scanned.end == alive)
                continue;
            if (found_ == expected_)
                return tooMany();
            out_[found_++] = alive[0];
        }
    return {};
}

Error PrefixScan::tooMany() const
{
    return inconsistentModel(model_, "the mesh of " + std::to_string(sites_) + " sites has more than the " +
                                         std::to_string(expected_) + " tetrahedra that it should have");
}

Status extractInto(const Model& model, std::uint32_t sites, const Progress& progress, TetrahedralMesh& mesh)
{
    if (sites == 0) {
        mesh = {};
        return model.checkIntact(); // damage may be why there are none
    }
    if (const Status scanned = PrefixScan(model, sites, mesh.tetrahedra).run(progress); !scanned)
        return scanned;
    turnToPhysicalSpace(model, mesh.tetrahedra);
    if (const Status placed = placeSites(model, sites, mesh.positions); !placed)
        return placed;
    if (const Status copied = copyValues(model, sites, mesh.values); !copied)
        return copied;
    return model.checkIntact();
}

/// The largest running key of meshes that are as accurate as asked (S4).
double keyOf(const Model& model, const Accuracy& accuracy)
{
    constexpr double unlimited = std::numeric_limits<double>::infinity();
    const double extent = model.description().range.extent();
    const double weight = model.description().warpingWeight;
    const double byError = extent > 0 || weight == 0 ? accuracy.error / 100 * extent : unlimited;
    const bool warpingCounts = weight > 0 && accuracy.warping < anyWarping;
    return std::min(byError, warpingCounts ? accuracy.warping / 100 * weight * model.diagonal() : unlimited);
}

} // namespace

MeshSize meshSizeAt(const Model& model, const Accuracy& accuracy)
{
    const double asked = keyOf(model, accuracy);
    const std::span<const float> errors = model.runningErrors();
    // The mesh of the first N sites has the error that was there before site N entered. Infinity is no mesh yet.
    const auto reached = std::ranges::partition_point(errors, [&](const float& error) {
        return !model.check(error) || std::isinf(error) || !(static_cast<double>(error) <= asked);
    });
    return meshSizeOf(model, static_cast<std::uint32_t>(reached - errors.begin()));
}

MeshSize meshSizeOf(const Model& model, std::uint32_t sites)
{
    if (sites == 0) // only in a damaged file: the initial sites have no error
        return {};
    const double extent = model.description().range.extent();
    const double weight = model.description().warpingWeight;
    const std::span<const float> errors = model.runningErrors();
    const float& next = sites == errors.size() ? errors.back() : errors[sites];
    const double key = sites == errors.size() ? std::min(model.finalError(), next) : next;
    if (!model.check(next) || !model.check(model.meshSizes()[sites - 1]))
        return {};
    return {sites, model.meshSizes()[sites - 1], extent > 0 ? 100 * key / extent : 0,
            weight > 0 ? 100 * key / (weight * model.diagonal()) : 0};
}

Result<TetrahedralMesh> extractPrefix(const Model& model, std::uint32_t sites, const Progress& progress,
                                      TetrahedralMesh reuse)
{
    if (sites > model.siteCount())
        return Error{ErrorKind::WrongUsage, "'" + model.path().string() + "' has " + std::to_string(model.siteCount()) +
                                                " sites, fewer than the " + std::to_string(sites) + " asked for."};
    if (sites > 0 && (!model.check(model.groupGoesOn()[sites - 1]) || !model.check(model.meshSizes()[sites - 1])))
        if (const Status intact = model.checkIntact(); !intact)
            return intact.error();
    if (sites > 0 && model.groupGoesOn()[sites - 1] != 0)
        return Error{ErrorKind::WrongUsage, "The first " + std::to_string(sites) + " sites of '" +
                                                model.path().string() + "' have no mesh of their own: site " +
                                                std::to_string(sites) + " enters together with the one before it."};
    try {
        if (const Status extracted = extractInto(model, sites, progress, reuse); !extracted)
            return extracted.error();
    } catch (const std::bad_alloc&) {
        return Error{ErrorKind::OutOfResource,
                     "Not enough memory for a mesh of " + std::to_string(sites) + " sites. Choose a larger error."};
    }
    return reuse;
}

} // namespace tetra
