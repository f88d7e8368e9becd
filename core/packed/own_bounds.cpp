// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rounding.h"
#include "core/mesh/topology.h"
#include "core/packed/number_order.h"
#include "core/packed/range_coder.h"
#include "core/packed/site_replay.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>
#include <vector>

namespace tetra {

namespace {

constexpr std::uint32_t noParent = 0xffffffff;

using SitePlace = std::array<std::int32_t, 3>;

std::int64_t determinantOf(const SitePlace& o, const SitePlace& p, const SitePlace& q, const SitePlace& r)
{
    std::array<std::int64_t, 3> a{}, b{}, c{};
    for (std::size_t i = 0; i < 3; ++i) {
        a[i] = p[i] - o[i];
        b[i] = q[i] - o[i];
        c[i] = r[i] - o[i];
    }
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// What the points that are no sites probably have to do with a tetrahedron.
struct OthersInside {
    std::uint32_t count = 0; ///< one more than most: too many to look at
    double error = 0;        ///< the largest difference of what the last mesh says there
};

/// The mesh of a history's sites at its end, and what it says of the other points.
class LastMesh {
public:
    LastMesh(const SiteFacts& facts, const HistoryArrays& history)
        : size_(facts.history.lattice.size), history_(history), isSite_(facts.history.lattice.pointCount()),
          isInteger_(isInteger(facts.history.sampleType))
    {
        const std::size_t sites = history.points.size();
        values_.resize(sites);
        places_.resize(sites);
        creators_.resize(history.otherSites.size());
        visitSampleType(facts.history.sampleType, [&]<class T>() {
            for (std::size_t site = 0; site < sites; ++site) {
                T value;
                std::memcpy(&value, history.values.data() + site * sizeof(T), sizeof(T));
                values_[site] = static_cast<double>(value);
            }
        });
        for (std::size_t site = 0; site < sites; ++site) {
            const std::uint32_t point = history.points[site];
            isSite_[point] = true;
            places_[site] = {static_cast<std::int32_t>(point % size_[0]),
                             static_cast<std::int32_t>(point / size_[0] % size_[1]),
                             static_cast<std::int32_t>(point / size_[0] / size_[1])};
            for (std::uint64_t t = history.starOffsets[site]; t < history.starOffsets[site + 1]; ++t)
                creators_[t] = static_cast<std::uint32_t>(site);
        }
        if (sites == isSite_.size())
            return;
        expected_.resize(isSite_.size());
        for (std::uint32_t t = 0; t < creators_.size(); ++t)
            if (isAlive(t))
                forEachOther(t, [&](std::uint64_t point, double interpolated) {
                    expected_[point] = isInteger_ ? std::floor(interpolated + 0.5) : interpolated;
                });
    }

    bool isAlive(std::uint32_t t) const { return history_.destroyers[t] == Model::never; }
    std::uint32_t creator(std::uint32_t t) const { return creators_[t]; }

    OthersInside othersIn(std::uint32_t t) const
    {
        OthersInside others;
        if (expected_.empty())
            return others;
        const bool looked = forEachOther(t, [&](std::uint64_t point, double interpolated) {
            ++others.count;
            others.error = std::max(others.error, std::abs(expected_[point] - interpolated));
        });
        if (!looked)
            others.count = std::numeric_limits<std::uint32_t>::max();
        return others;
    }

private:
    Tetrahedron cornersOf(std::uint32_t t) const
    {
        const auto& [a, b, c] = history_.otherSites[t];
        return {creators_[t], a, b, c};
    }

    /// Calls visit(point, interpolation) for the points in a tetrahedron that are no sites, those on its faces among
    /// them; false if it is too large to be looked through.
    template <class Visit> bool forEachOther(std::uint32_t t, const Visit& visit) const
    {
        constexpr std::uint64_t mostLookedAt = 1 << 18;
        const Tetrahedron sites = cornersOf(t);
        std::array<SitePlace, 4> corners{};
        SitePlace low = places_[sites[0]], high = low;
        for (std::size_t i = 0; i < 4; ++i) {
            corners[i] = places_[sites[i]];
            for (std::size_t axis = 0; axis < 3; ++axis) {
                low[axis] = std::min(low[axis], corners[i][axis]);
                high[axis] = std::max(high[axis], corners[i][axis]);
            }
        }
        std::uint64_t boxed = 1;
        for (std::size_t axis = 0; axis < 3; ++axis)
            boxed *= static_cast<std::uint64_t>(high[axis] - low[axis] + 1);
        if (boxed > mostLookedAt && !isAlive(t))
            return false;
        if (!isOneCell(low, high))
            lookThrough(sites, corners, low, high, visit);
        return true;
    }

    /// A cell has no points but its corners, of which those in a tetrahedron of these are its own.
    static bool isOneCell(const SitePlace& low, const SitePlace& high)
    {
        return high[0] - low[0] <= 1 && high[1] - low[1] <= 1 && high[2] - low[2] <= 1;
    }

    template <class Visit> void lookThrough(const Tetrahedron& sites, const std::array<SitePlace, 4>& corners,
                                            const SitePlace& low, const SitePlace& high, const Visit& visit) const
    {
        const std::int64_t whole = determinantOf(corners[0], corners[1], corners[2], corners[3]);
        if (whole <= 0)
            return;
        std::array<std::int64_t, 4> weights{}, step{};
        const auto weightsAt = [&](const SitePlace& at) -> std::array<std::int64_t, 4> {
            std::array<std::int64_t, 4> there{};
            for (std::size_t i = 1; i < 4; ++i) {
                std::array<SitePlace, 4> with = corners;
                with[i] = at;
                there[i] = determinantOf(with[0], with[1], with[2], with[3]);
            }
            there[0] = whole - there[1] - there[2] - there[3];
            return there;
        };
        for (std::int32_t z = low[2]; z <= high[2]; ++z)
            for (std::int32_t y = low[1]; y <= high[1]; ++y) {
                weights = weightsAt({low[0], y, z});
                if (low[0] < high[0]) {
                    step = weightsAt({low[0] + 1, y, z});
                    for (std::size_t i = 0; i < 4; ++i)
                        step[i] -= weights[i];
                }
                std::uint64_t point =
                    (std::uint64_t(z) * size_[1] + std::uint64_t(y)) * size_[0] + std::uint64_t(low[0]);
                for (std::int32_t x = low[0]; x <= high[0]; ++x, ++point) {
                    const bool noneIsNegative = (weights[0] | weights[1] | weights[2] | weights[3]) >= 0;
                    if (noneIsNegative && !isSite_[point])
                        visit(point, interpolated(sites, weights, whole));
                    for (std::size_t i = 0; i < 4; ++i)
                        weights[i] += step[i];
                }
            }
    }

    double interpolated(const Tetrahedron& sites, const std::array<std::int64_t, 4>& weights, std::int64_t whole) const
    {
        double sum = 0;
        for (std::size_t i = 0; i < 4; ++i)
            sum += static_cast<double>(weights[i]) * values_[sites[i]];
        return sum / static_cast<double>(whole);
    }

    std::array<std::uint32_t, 3> size_;
    const HistoryArrays& history_;
    std::vector<bool> isSite_;
    bool isInteger_;
    std::vector<double> values_;
    std::vector<SitePlace> places_;
    std::vector<std::uint32_t> creators_;
    std::vector<double> expected_; ///< of the points that are no sites
};

/// Of each tetrahedron the one that died where it was made, and had the face that it fills; or none.
std::vector<std::uint32_t> parentsOf(const HistoryArrays& history, const LastMesh& mesh)
{
    const std::size_t sites = history.points.size();
    const std::size_t count = history.otherSites.size();
    std::vector<std::uint64_t> offsets(sites + 1);
    for (const std::uint32_t site : history.destroyers)
        if (site != Model::never)
            ++offsets[site + std::size_t(1)];
    for (std::size_t site = 0; site < sites; ++site)
        offsets[site + 1] += offsets[site];
    std::vector<std::uint32_t> deaths(offsets[sites]);
    std::vector<std::uint64_t> next(offsets.begin(), offsets.end() - 1);
    for (std::uint32_t t = 0; t < count; ++t)
        if (history.destroyers[t] != Model::never)
            deaths[next[history.destroyers[t]]++] = t;
    std::vector<std::uint32_t> parents(count, noParent);
    std::vector<std::pair<Triangle, std::uint32_t>> faces;
    for (std::size_t site = 0; site < sites; ++site) {
        faces.clear();
        for (std::uint64_t i = offsets[site]; i < offsets[site + 1]; ++i) {
            const std::uint32_t t = deaths[i];
            const auto& [a, b, c] = history.otherSites[t];
            const Tetrahedron corners{mesh.creator(t), a, b, c};
            for (const auto& [i0, i1, i2] : cornersOfFace) {
                Triangle face{corners[i0], corners[i1], corners[i2]};
                std::ranges::sort(face);
                faces.emplace_back(face, t);
            }
        }
        std::ranges::sort(faces);
        for (std::uint64_t t = history.starOffsets[site]; t < history.starOffsets[site + 1]; ++t) {
            Triangle face = history.otherSites[t];
            std::ranges::sort(face);
            const auto found = std::ranges::lower_bound(faces, std::pair(face, std::uint32_t(0)));
            if (found != faces.end() && found->first == face)
                parents[t] = found->second;
        }
    }
    return parents;
}

struct BoundModels {
    BitModel isLower[2][2][3];    ///< warping, alive, what is known of it
    BitModel isExpected[2][2][8]; ///< likewise, how many points
    NumberModel numbers[2][2][3];
    NumberModel all;
};

template <class Coder> class BoundCoder {
    static constexpr bool encodes = std::is_same_v<Coder, RangeEncoder>;

public:
    BoundCoder(const SiteFacts& facts, HistoryArrays& history, Coder& coder, const Model* model)
        : facts_(facts.history), history_(history), coder_(coder), model_(model), mesh_(facts, history)
    {
    }

    void run()
    {
        const bool warps = !history_.ownWarpings.empty();
        bool follow = false; // all of them from the sites
        if constexpr (encodes)
            follow = std::ranges::equal(history_.ownErrors, model_->ownErrors()) &&
                     std::ranges::equal(history_.ownWarpings, model_->ownWarpings());
        if (models_.all.code(coder_, follow ? 1 : 0) != 0)
            return;
        const std::vector<std::uint32_t> parents = parentsOf(history_, mesh_);
        std::size_t site = 0;
        for (std::uint32_t t = 0; t < history_.otherSites.size(); ++t) {
            while (history_.starOffsets[site + 1] <= t)
                ++site;
            const OthersInside others = mesh_.othersIn(t);
            if (others.count == 0)
                continue; // nothing but sites
            code(0, t, parents[t], history_.runningKeys[site], others);
            if (warps)
                code(1, t, parents[t], history_.runningKeys[site], others);
        }
    }

private:
    void code(std::size_t kind, std::uint32_t t, std::uint32_t parent, float key, const OthersInside& others)
    {
        std::vector<std::uint16_t>& own = kind == 0 ? history_.ownErrors : history_.ownWarpings;
        std::uint16_t actual = 0;
        if constexpr (encodes)
            actual = kind == 0 ? model_->ownErrors()[t] : model_->ownWarpings()[t];
        const std::uint16_t lower = own[t];
        const std::size_t alive = mesh_.isAlive(t) ? 1 : 0;
        std::uint16_t expected = lower;
        if (kind == 0)
            expected = std::max(lower, halfBound(roundedUp(others.error), facts_.extent));
        const std::size_t known = expected > lower ? 2 : lower > 0 ? 1 : 0;
        if (known == 2) {
            const auto many = std::min<std::size_t>(static_cast<std::size_t>(std::bit_width(others.count)), 8) - 1;
            if (codedBit(coder_, models_.isExpected[kind][alive][many], actual == expected)) {
                own[t] = expected;
                return;
            }
        }
        if (codedBit(coder_, models_.isLower[kind][alive][known], actual == lower))
            return;
        std::uint16_t from = expected;
        std::size_t source = 0;
        if (alive != 0 || known != 2) {
            const double whole = kind == 0 ? facts_.extent : facts_.diagonal * facts_.warpingWeight;
            const double share = static_cast<double>(key) / whole;
            source = 1;
            from = share > 0 && share < 1 ? halfRoundedUp(static_cast<float>(share)) : std::uint16_t(0x3c00);
            if (parent != noParent && own[parent] > 0) {
                source = 2;
                from = own[parent];
            }
        }
        const std::uint64_t coded = models_.numbers[kind][alive][source].code(coder_, zigzag(actual, from, 16));
        own[t] = static_cast<std::uint16_t>(unzigzag(coded, from, 16));
    }

    const HistoryFacts& facts_;
    HistoryArrays& history_;
    Coder& coder_;
    const Model* model_;
    LastMesh mesh_;
    BoundModels models_;
};

} // namespace

std::vector<std::byte> encodeOwnBounds(const SiteFacts& facts, HistoryArrays& history, const Model& model)
{
    RangeEncoder coder;
    BoundCoder<RangeEncoder>(facts, history, coder, &model).run();
    return coder.finish();
}

bool decodeOwnBounds(const SiteFacts& facts, std::span<const std::byte> bytes, HistoryArrays& history)
{
    RangeDecoder coder(bytes);
    BoundCoder<RangeDecoder>(facts, history, coder, nullptr).run();
    return !coder.overrun();
}

} // namespace tetra
