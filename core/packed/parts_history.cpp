// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/packed/parts_history.h"

#include "core/base/flat_index.h"
#include "core/base/rounding.h"
#include "core/mesh/topology.h"
#include "core/packed/number_order.h"
#include "core/packed/range_coder.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <queue>
#include <type_traits>

namespace tetra {

namespace {

constexpr std::uint32_t nowhere = 0xffffffff; ///< no tetrahedron, no site

/// The corners of a triangle, ascending.
struct SortedTriangle {
    std::uint32_t a = 0, b = 0, c = 0;
    bool operator==(const SortedTriangle&) const = default;
};

struct TriangleHash {
    std::uint64_t operator()(const SortedTriangle& t) const noexcept
    {
        const std::uint64_t one = (std::uint64_t(t.a) << 32 | t.b) * 0x9e3779b97f4a7c15u;
        return (one ^ one >> 29 ^ t.c) * 0xbf58476d1ce4e5b9u;
    }
};

/// `odd`: whether sorting the corners takes an odd permutation.
SortedTriangle sortedTriangle(Triangle corners, bool& odd)
{
    auto& [a, b, c] = corners;
    odd = false;
    const auto order = [&odd](std::uint32_t& x, std::uint32_t& y) {
        if (x > y) {
            std::swap(x, y);
            odd = !odd;
        }
    };
    order(a, b);
    order(b, c);
    order(a, b);
    return {a, b, c};
}

Triangle faceOf(const Tetrahedron& sites, std::size_t face)
{
    const auto& [a, b, c] = cornersOfFace[face];
    return {sites[a], sites[b], sites[c]};
}

double powerOfTen(unsigned exponent)
{
    double power = 1;
    for (unsigned i = 0; i < exponent; ++i)
        power *= 10; // exactly, up to 10^22
    return power;
}

/// A number in units of 1 / `unit`, if it is no more than doubles count.
std::optional<std::int64_t> wholeUnits(double number, double unit)
{
    const double units = std::floor(number * unit + 0.5);
    if (!(std::abs(units) <= 0x1p53))
        return std::nullopt;
    return static_cast<std::int64_t>(units);
}

constexpr unsigned mostDecimals = 12;

/// The fewest digits behind the point with which a number can be written; one more than most if there are none.
template <class T> unsigned decimalsIn(T number)
{
    for (unsigned digits = 0; digits <= mostDecimals; ++digits) {
        const double unit = powerOfTen(digits);
        const auto units = wholeUnits(static_cast<double>(number), unit);
        if (units && orderOf(number) == orderOf(nearestNumber<T>(static_cast<double>(*units) / unit)))
            return digits;
    }
    return mostDecimals + 1;
}

using Place = std::array<double, 3>;

/// Six times the volume of (o, a, b, c).
double volumeOf(const Place& o, const Place& a, const Place& b, const Place& c)
{
    Place u{}, v{}, w{};
    for (std::size_t i = 0; i < 3; ++i) {
        u[i] = a[i] - o[i];
        v[i] = b[i] - o[i];
        w[i] = c[i] - o[i];
    }
    return u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) + u[2] * (v[0] * w[1] - v[1] * w[0]);
}

} // namespace

/// The mesh of the sites so far, and what the next ones are predicted from.
struct HistoryState {
    HistoryFacts facts;
    HistoryArrays arrays;
    std::vector<Tetrahedron> corners;               ///< of each tetrahedron, as they are stored: the creator first
    std::vector<std::array<std::uint32_t, 4>> next; ///< its neighbours, opposite to its corners; of the living
    std::vector<std::uint8_t>
        fronts; ///< likewise: where their creators may be in the builder's order of corners, as bits
    std::vector<std::uint32_t> marks;
    std::uint32_t mark = 0;
    std::vector<Place> places; ///< of the sites, in the space that the mesh was made in
    std::vector<bool> used;    ///< points of a lattice that are sites
    /// The living by their own keys, some of the dead among them; and those of at least the running key, ascending.
    std::priority_queue<std::pair<double, std::uint32_t>> queue;
    std::vector<std::uint32_t> due;
    std::uint64_t living = 0;

    explicit HistoryState(const HistoryFacts& known) : facts(known)
    {
        if (isOnLattice(facts.domain))
            used.resize(facts.lattice.pointCount());
    }

    std::uint32_t siteCount() const { return static_cast<std::uint32_t>(arrays.points.size()); }
    std::uint32_t tetrahedronCount() const { return static_cast<std::uint32_t>(corners.size()); }
    bool alive(std::uint32_t t) const { return arrays.destroyers[t] == Model::never; }
    /// Builders that put a new corner in the place of one that goes; others put it in front.
    bool turnsInPlace() const { return !facts.delaunay || !isOnLattice(facts.domain); }
    std::size_t sampleBytes() const { return sampleSize(facts.sampleType); }
    template <class T> T valueOf(std::uint32_t site) const
    {
        T value;
        std::memcpy(&value, arrays.values.data() + site * sizeof(T), sizeof(T));
        return value;
    }
    double value(std::uint32_t site) const
    {
        return visitSampleType(facts.sampleType,
                               [&]<class T>() -> double { return static_cast<double>(valueOf<T>(site)); });
    }
    template <class T> T coordinate(std::uint32_t site, std::size_t axis) const
    {
        T value;
        std::memcpy(&value, arrays.positions.data() + (std::size_t(3) * site + axis) * sizeof(T), sizeof(T));
        return value;
    }
    Place placeOfPoint(std::uint32_t point) const
    {
        const auto& size = facts.lattice.size;
        const std::uint32_t x = point % size[0], y = point / size[0] % size[1], z = point / size[0] / size[1];
        return {x * facts.lattice.spacing[0], y * facts.lattice.spacing[1], z * facts.lattice.spacing[2]};
    }
    double ownKey(std::uint32_t t) const
    {
        const double error = static_cast<double>(halfToFloat(arrays.ownErrors[t])) * facts.extent;
        if (arrays.ownWarpings.empty())
            return error;
        return std::max(error,
                        static_cast<double>(halfToFloat(arrays.ownWarpings[t])) * facts.diagonal * facts.warpingWeight);
    }

    double volume(std::uint32_t t) const
    {
        const auto& [a, b, c, d] = corners[t];
        return volumeOf(places[a], places[b], places[c], places[d]);
    }
    /// The weights of a tetrahedron's corners at a place; false if it has no volume.
    bool weightsAt(std::uint32_t t, const Place& place, std::array<double, 4>& weights) const
    {
        const double whole = volume(t);
        if (whole == 0)
            return false;
        for (std::size_t i = 0; i < 4; ++i) {
            const auto& [a, b, c] = faceOf(corners[t], i);
            weights[i] = volumeOf(place, places[a], places[b], places[c]) / whole;
        }
        return true;
    }
    bool contains(std::uint32_t t, const Place& place) const
    {
        for (std::size_t i = 0; i < 4; ++i) {
            const auto& [a, b, c] = faceOf(corners[t], i);
            if (volumeOf(place, places[a], places[b], places[c]) < 0)
                return false;
        }
        return true;
    }
    /// Calls visit(point) for the points of a box of the lattice that contains() says are in a tetrahedron, ascending.
    /// Four volumes change by the same from one point to the next: they are added up, and computed only where rounding
    /// may decide.
    template <class Visit> void visitPointsIn(std::uint32_t t, const std::array<std::uint32_t, 3>& low,
                                              const std::array<std::uint32_t, 3>& high, Visit visit) const
    {
        const auto& size = facts.lattice.size;
        const auto pointAt = [&](std::uint32_t x, std::uint32_t y, std::uint32_t z) {
            return (z * size[1] + y) * size[0] + x;
        };
        const auto volumeAt = [&](std::size_t side, std::uint32_t x, std::uint32_t y, std::uint32_t z) {
            const auto& [a, b, c] = faceOf(corners[t], side);
            return volumeOf(placeOfPoint(pointAt(x, y, z)), places[a], places[b], places[c]);
        };
        constexpr double unsureShare = 1e-6; // of the box, far more than rounding makes, and hardly a point's share
        double unsure = unsureShare;
        for (std::size_t axis = 0; axis < 3; ++axis)
            unsure *= (high[axis] - low[axis] + 1) * facts.lattice.spacing[axis];
        std::array<double, 4> atLow{}, alongX{}, alongY{}, alongZ{};
        const auto slope = [](double from, double to, std::uint32_t steps) {
            return steps == 0 ? 0 : (to - from) / steps;
        };
        for (std::size_t side = 0; side < 4; ++side) {
            const double v = atLow[side] = volumeAt(side, low[0], low[1], low[2]);
            alongX[side] = slope(v, volumeAt(side, high[0], low[1], low[2]), high[0] - low[0]);
            alongY[side] = slope(v, volumeAt(side, low[0], high[1], low[2]), high[1] - low[1]);
            alongZ[side] = slope(v, volumeAt(side, low[0], low[1], high[2]), high[2] - low[2]);
        }
        for (std::uint32_t z = low[2]; z <= high[2]; ++z)
            for (std::uint32_t y = low[1]; y <= high[1]; ++y) {
                std::array<double, 4> row{};
                double first = 0, last = high[0] - low[0];
                for (std::size_t side = 0; side < 4; ++side) {
                    const double v = row[side] =
                        atLow[side] + (y - low[1]) * alongY[side] + (z - low[2]) * alongZ[side];
                    if (alongX[side] > 0)
                        first = std::max(first, (-unsure - v) / alongX[side]);
                    else if (alongX[side] < 0)
                        last = std::min(last, (v + unsure) / -alongX[side]);
                    else if (v < -unsure)
                        last = -1;
                }
                if (last < first)
                    continue;
                const auto end = static_cast<std::uint32_t>(last);
                for (auto x = static_cast<std::uint32_t>(first); x <= end; ++x) {
                    const std::uint32_t point = pointAt(low[0] + x, y, z);
                    double least = row[0] + x * alongX[0];
                    for (std::size_t side = 1; side < 4; ++side)
                        least = std::min(least, row[side] + x * alongX[side]);
                    if (least > unsure || (least >= -unsure && contains(t, placeOfPoint(point))))
                        visit(point);
                }
            }
    }
    /// Whether a place lies strictly inside the circumsphere, as well as doubles tell.
    bool inSphere(std::uint32_t t, const Place& place) const
    {
        std::array<std::array<double, 4>, 4> row{};
        for (std::size_t i = 0; i < 4; ++i) {
            double square = 0;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                row[i][axis] = places[corners[t][i]][axis] - place[axis];
                square += row[i][axis] * row[i][axis];
            }
            row[i][3] = square;
        }
        const auto minor = [&row](std::size_t i, std::size_t j, std::size_t k) {
            return row[i][0] * (row[j][1] * row[k][2] - row[j][2] * row[k][1]) -
                   row[i][1] * (row[j][0] * row[k][2] - row[j][2] * row[k][0]) +
                   row[i][2] * (row[j][0] * row[k][1] - row[j][1] * row[k][0]);
        };
        const double determinant = row[0][3] * minor(1, 2, 3) - row[1][3] * minor(0, 2, 3) +
                                   row[2][3] * minor(0, 1, 3) - row[3][3] * minor(0, 1, 2);
        return determinant > 0;
    }
};

namespace {

/// What is learnt within a piece.
struct PartModels {
    template <std::size_t... counts> struct Bits;
    template <std::size_t count> struct Bits<count> : std::array<BitModel, count> {
    };
    template <std::size_t count, std::size_t... counts> struct Bits<count, counts...>
        : std::array<Bits<counts...>, count> {
    };

    NumberModel groupSize, key, pointDelta, ownerStep, apexStep;
    Bits<2> freshKey, seedIsDue, hostIsSeed, hostIsFirst, hostOwned, otherIsInCavity, otherIsInGroup;
    Bits<4> moreSeeds;
    Bits<2, 3, 4, 4> dies;
    Bits<8> owner;
    Bits<2, 3, 2> isFilled;
    Bits<2, 3, 8> apex;
    Bits<2> moreTetrahedra;
    Bits<2, 4> orderIsNext;
    Bits<2, 2, 3, 2> turn;
    std::array<NumberModel, 3> coordinate;
    std::array<NumberModel, 2> decimal;
    Bits<16> digits;
    Bits<3> valueByKey;
    std::array<NumberModel, 2> value;
    Bits<2, 16, 3, 3> ownIsZero;
    std::array<std::array<NumberModel, 3>, 2> own;
};

/// Scratch memory for coding one group, reused for the next one.
struct GroupScratch {
    struct Face {
        Triangle corners{};           ///< (apex, corners) is positive
        std::uint32_t back = nowhere; ///< the tetrahedron on the other side: a new one by its place if isNew
        std::uint32_t backFace = 0;
        std::uint32_t hint = nowhere;  ///< a site that may be the apex
        std::uint32_t dying = nowhere; ///< what dies on this side
        std::uint32_t dyingFace = 0;
        bool isNew = false, closed = false, odd = false;
    };
    struct New {
        Tetrahedron sites{};
        std::array<std::uint32_t, 4> next{nowhere, nowhere, nowhere, nowhere};
        std::array<bool, 4> nextIsNew{};
        std::uint32_t dying = nowhere; ///< in whose place it comes, but for a corner ...
        std::uint32_t dyingCorner = 0; ///< ... which is this one of it
        std::uint8_t fronts = 15;      ///< as HistoryState's
        std::uint32_t actual = 0;      ///< in the encoder: its number
    };
    struct Outer {
        std::uint32_t inside, face; ///< of a tetrahedron that dies
    };
    struct EdgeLink {
        std::uint32_t face, before;
    };

    std::vector<std::uint32_t> dying;
    std::vector<std::uint32_t> owners; ///< of each: which of the group's sites is its destroyer
    std::vector<Outer> outers;
    std::vector<Face> faces;
    FlatIndex<SortedTriangle, TriangleHash> faceNumbers;
    FlatIndex<EdgeKey> edgeNumbers;
    std::vector<std::uint32_t> edgeHeads;
    std::vector<EdgeLink> edgeLinks;
    FlatIndex<std::uint32_t> cavity; ///< the corners of what dies
    std::vector<New> made;
    std::vector<std::vector<std::uint32_t>> stars;
    std::vector<std::uint32_t> numbers; ///< of what was made
    std::vector<std::uint32_t> parents; ///< of each of these, in the order of their numbers: New::dying
    std::vector<std::uint32_t> candidates;
    std::vector<std::uint32_t> ownedBegins; ///< for each site of the group: in ...
    std::vector<std::uint32_t> owned;       ///< ... the dying by their owners
    std::vector<std::uint32_t> inside;      ///< points in a tetrahedron
    // In the encoder:
    FlatIndex<SortedTriangle, TriangleHash> actualNumbers;
    std::vector<std::array<std::uint32_t, 2>> actualFaces; ///< 4 tetrahedra + face, by whether odd
    std::vector<std::uint8_t> actualUsed;
};

/// What the encoder writes, and the decoder does not know yet.
struct EncodedHistory {
    const Model* model = nullptr;
    std::span<const std::uint64_t> deathOffsets;
    std::span<const std::uint32_t> deaths;
};

/// Codes groups with either coder: with the encoder what it is told, with the decoder what comes. False where that is
/// no history.
template <class Coder> class GroupCoder {
    static constexpr bool encodes = std::is_same_v<Coder, RangeEncoder>;

public:
    GroupCoder(HistoryState& state, Coder& coder, const EncodedHistory& actual, HistoryCost& cost)
        : state_(state), arrays_(state.arrays), coder_(coder), encoded_(actual), cost_(cost)
    {
    }

    bool run(std::uint32_t end)
    {
        while (state_.siteCount() < end)
            if (!group(end) || isImpossible_ || isOverrun())
                return false;
        return true;
    }

private:
    /// Whether the decoder has come to the end of its bytes too early, beyond which anything may be read for ever.
    bool isOverrun() const
    {
        if constexpr (encodes)
            return false;
        else
            return coder_.overrun();
    }
    bool bit(BitModel& model, bool actual) { return codedBit(coder_, model, actual); }
    std::uint64_t number(NumberModel& model, std::uint64_t actual)
    {
        isImpossible_ |= encodes && actual == ~std::uint64_t(0);
        return model.code(coder_, actual);
    }
    /// Below 2^64, small ones shorter.
    std::uint64_t wideNumber(NumberModel& model, std::uint64_t actual)
    {
        constexpr std::uint64_t huge = std::uint64_t(1) << 62;
        const std::uint64_t coded = number(model, std::min(actual, huge));
        return coded < huge ? coded : rawBits(actual, 64);
    }
    /// Four bits that are learnt.
    unsigned codeDigits(unsigned actual)
    {
        unsigned node = 1;
        for (unsigned i = 4; i-- > 0;)
            node = node << 1 | (bit(models_.digits[node], (actual >> i & 1) != 0) ? 1u : 0u);
        return node & 15;
    }
    std::uint64_t rawBits(std::uint64_t actual, unsigned count)
    {
        if constexpr (encodes) {
            coder_.raw(actual, count);
            return actual;
        } else {
            return coder_.raw(count);
        }
    }
    /// One of `count` equally likely numbers, `count` not 0.
    std::uint64_t oneOf(std::uint64_t actual, std::uint64_t count)
    {
        isImpossible_ |= encodes && actual >= count;
        const unsigned bits = static_cast<unsigned>(std::bit_width(count)) - 1;
        const std::uint64_t shorter = (std::uint64_t(2) << bits) - count; // so many are a bit shorter
        if constexpr (encodes) {
            if (actual < shorter)
                coder_.raw(actual, bits);
            else { // in two parts, as they are read
                coder_.raw((actual + shorter) >> 1, bits);
                coder_.raw((actual + shorter) & 1, 1);
            }
            return actual;
        } else {
            const std::uint64_t high = coder_.raw(bits);
            return high < shorter ? high : (high << 1 | coder_.raw(1)) - shorter;
        }
    }
    void charge(std::uint64_t HistoryCost::*part)
    {
        if constexpr (encodes) {
            cost_.*part += coder_.size() - charged_;
            charged_ = coder_.size();
        }
    }

    bool group(std::uint32_t end);
    bool codeSize(std::uint32_t end);
    bool codeKey();
    void refillDue(double key);
    bool codeDying();
    struct Seed {
        std::uint32_t tetrahedron = nowhere;
        bool isDue = false;     ///< one of HistoryState::due
        bool holdsSite = false; ///< the group's only site lies in it
    };
    Seed trueSeed(bool isFirst);
    bool codeSeed(bool isFirst, std::uint32_t& seed);
    bool placeBySeed(std::uint32_t seed, bool holdsSite);
    bool walkFrom(std::uint32_t seed);
    bool codeDies(std::uint32_t t);
    bool isDying(std::uint32_t t) const { return state_.marks[t] == state_.mark + 1; }
    bool addDying(std::uint32_t t, std::uint32_t parent);
    std::uint32_t codeOwner(std::uint32_t t, std::uint32_t parent);
    std::uint32_t codeLocal(NumberModel& model, std::uint32_t actual, std::uint32_t near);
    bool fillCavity();
    bool readActual();
    bool codeFace(std::uint32_t face);
    bool codeApex(const GroupScratch::Face& face, std::size_t type, std::uint32_t actual, std::uint32_t& apex);
    bool addNew(const Tetrahedron& sites, std::uint32_t actual, std::uint32_t from);
    std::uint32_t pushFace(const GroupScratch::Face& face, const SortedTriangle& sorted);
    bool orderStars();
    bool turnCreatorFirst(GroupScratch::New& tetrahedron, std::uint32_t creator);
    std::size_t codeTurn(GroupScratch::New& tetrahedron, const std::array<std::size_t, 4>& corners, std::size_t actual);
    std::size_t nextAround(std::span<const std::uint32_t> star, std::size_t done);
    void link();
    bool codeSites();
    bool codePoint(std::uint32_t local);
    bool codePointIn(std::uint32_t host, std::uint32_t& point);
    Place middleOfNeighbours(std::uint32_t site) const;
    bool codeFreePoint(std::uint32_t local);
    void codePosition(std::uint32_t site, const Place& predicted);
    std::uint32_t hostOfFreeSite(std::uint32_t local);
    void sortByOwner();
    std::span<const std::uint32_t> hostsOf(std::uint32_t local, bool owned) const;
    std::optional<double> valueInHost(std::uint32_t site) const;
    double meanOfNeighbours(std::uint32_t site) const;
    void codeValue(std::uint32_t local);
    double unitOfVolume() const;
    void codeOwn();
    void codeOwnBound(std::uint32_t t, std::size_t kind, std::size_t size, std::uint32_t key, std::size_t& before);
    void finish();

    std::uint32_t truePoint(std::uint32_t local) const
    {
        return encodes ? encoded_.model->points()[first_ + local] : 0;
    }
    bool onLattice() const { return isOnLattice(state_.facts.domain); }
    bool placed(std::uint32_t site) const { return site < state_.places.size(); }

    HistoryState& state_;
    HistoryArrays& arrays_;
    Coder& coder_;
    const EncodedHistory& encoded_;
    HistoryCost& cost_;
    std::uint64_t charged_ = 0;
    PartModels models_;
    GroupScratch scratch_;

    // The group at hand:
    std::uint32_t first_ = 0; ///< its first site
    std::uint32_t count_ = 0;
    std::uint32_t base_ = 0; ///< its first tetrahedron
    float key_ = 0;
    std::vector<std::uint32_t> common_; ///< corners that all that dies has
    std::uint32_t host_ = nowhere;      ///< of the site that is placed: where it lies
    std::uint32_t used_ = 0;            ///< in the encoder: of its tetrahedra
    std::uint32_t asked_ = 0;           ///< of the star at hand: whose neighbours come next ...
    std::vector<std::uint32_t> around_; ///< ... and whose after that, the last one first
    std::uint64_t death_ = 0;           ///< likewise: the first that has not been coded
    std::uint32_t unused_ = 0;          ///< likewise: all before are
    bool placedEarly_ = false;          ///< the only site was, before what it destroys was known
    /// In the encoder: something was to be coded that has no code, so that the decoder would read something else.
    bool isImpossible_ = false;
};

template <class Coder> bool GroupCoder<Coder>::group(std::uint32_t end)
{
    first_ = state_.siteCount();
    base_ = state_.tetrahedronCount();
    host_ = nowhere;
    placedEarly_ = false;
    if (!codeSize(end) || !codeKey())
        return false;
    charge(&HistoryCost::accuracy);
    if (!codeDying())
        return false;
    charge(&HistoryCost::mesh);
    if (!fillCavity())
        return false;
    charge(&HistoryCost::mesh);
    if (!orderStars())
        return false;
    charge(&HistoryCost::order);
    link();
    sortByOwner();
    if (!codeSites())
        return false;
    codeOwn();
    charge(&HistoryCost::ownErrors);
    finish();
    return true;
}

template <class Coder> bool GroupCoder<Coder>::codeSize(std::uint32_t end)
{
    std::uint32_t actual = 0;
    if constexpr (encodes) {
        const auto goesOn = encoded_.model->groupGoesOn();
        while (first_ + actual + 1 < end && goesOn[first_ + actual] != 0)
            ++actual;
        if (goesOn[first_ + actual] != 0)
            return false;
    }
    const std::uint64_t more = number(models_.groupSize, actual);
    if (more >= end - first_)
        return false;
    count_ = static_cast<std::uint32_t>(more) + 1;
    return true;
}

/// A new key is that of the worst tetrahedron's own bounds, but for their rounding.
template <class Coder> bool GroupCoder<Coder>::codeKey()
{
    std::uint32_t actual = 0;
    if constexpr (encodes) {
        const auto keys = encoded_.model->runningKeys();
        actual = std::bit_cast<std::uint32_t>(keys[first_]);
        for (std::uint32_t i = 1; i < count_; ++i)
            if (std::bit_cast<std::uint32_t>(keys[first_ + i]) != actual)
                return false;
    }
    const std::uint32_t before = first_ == 0 ? 0 : std::bit_cast<std::uint32_t>(arrays_.runningKeys.back());
    if (first_ > 0 && !bit(models_.freshKey[0], actual != before)) {
        key_ = arrays_.runningKeys.back();
        return true;
    }
    float predicted = std::numeric_limits<float>::infinity();
    if (first_ > 0) {
        for (const std::uint32_t t : state_.due)
            state_.queue.emplace(state_.ownKey(t), t);
        state_.due.clear();
        while (!state_.queue.empty() && !state_.alive(state_.queue.top().second))
            state_.queue.pop();
        const double worst = state_.queue.empty() ? 0 : state_.queue.top().first;
        if (worst <= static_cast<double>(std::numeric_limits<float>::max()))
            predicted = static_cast<float>(worst);
        predicted = std::min(predicted, arrays_.runningKeys.back());
    }
    const auto bits = std::bit_cast<std::uint32_t>(predicted);
    const std::uint64_t coded = number(models_.key, zigzag(bits, actual, 32));
    // The predicted less what was coded.
    const auto difference = static_cast<std::uint32_t>(unzigzag(coded, 0, 32));
    key_ = std::bit_cast<float>(bits - difference);
    refillDue(static_cast<double>(key_));
    return true;
}

template <class Coder> void GroupCoder<Coder>::refillDue(double key)
{
    constexpr std::size_t most = 4096; // more of them tell nothing
    auto& queue = state_.queue;
    while (key > 0 && !queue.empty() && queue.top().first >= key && state_.due.size() < most) {
        if (state_.alive(queue.top().second))
            state_.due.push_back(queue.top().second);
        queue.pop();
    }
    std::ranges::sort(state_.due);
}

// What dies.

template <class Coder> bool GroupCoder<Coder>::codeDying()
{
    scratch_.dying.clear();
    scratch_.owners.clear();
    scratch_.outers.clear();
    common_.clear();
    state_.mark += 2;
    std::uint64_t actual = 0;
    if constexpr (encodes)
        actual = encoded_.deathOffsets[first_ + count_] - encoded_.deathOffsets[first_];
    for (std::size_t component = 0;; ++component) {
        if (!bit(models_.moreSeeds[std::min<std::size_t>(component, 3)], scratch_.dying.size() < actual))
            return true;
        std::uint32_t seed = nowhere;
        if (!codeSeed(component == 0, seed) || !walkFrom(seed))
            return false;
    }
}

/// The encoder's choice of one that dies.
template <class Coder> auto GroupCoder<Coder>::trueSeed(bool isFirst) -> Seed
{
    Seed best;
    if constexpr (encodes) {
        const bool mayHold = onLattice() && count_ == 1;
        const Place site = onLattice() ? state_.placeOfPoint(truePoint(0)) : Place{};
        const int highest = (state_.due.empty() ? 0 : 2) + (mayHold ? 1 : 0);
        int score = -1;
        if (isFirst)
            death_ = encoded_.deathOffsets[first_];
        const std::uint64_t end = encoded_.deathOffsets[first_ + count_];
        // One that comes later than what destroys it is part of no mesh.
        const auto exists = [this](std::uint32_t t) { return t < base_; };
        while (death_ < end && exists(encoded_.deaths[death_]) && isDying(encoded_.deaths[death_]))
            ++death_;
        for (std::uint64_t i = death_; i < end && score < highest; ++i) {
            const std::uint32_t t = encoded_.deaths[i];
            if (!exists(t))
                return {};
            if (isDying(t))
                continue;
            const Seed one{t, std::ranges::binary_search(state_.due, t), mayHold && state_.contains(t, site)};
            const int scoreOfOne = (one.isDue ? 2 : 0) + (one.holdsSite ? 1 : 0);
            if (scoreOfOne > score) {
                score = scoreOfOne;
                best = one;
            }
        }
    }
    return best;
}

/// One that dies: of those whose own bound is the reason for the group, if one of these does.
template <class Coder> bool GroupCoder<Coder>::codeSeed(bool isFirst, std::uint32_t& seed)
{
    const std::vector<std::uint32_t>& due = state_.due;
    const Seed actual = trueSeed(isFirst);
    if (encodes && actual.tetrahedron == nowhere)
        return false;
    if (!due.empty() && bit(models_.seedIsDue[isFirst ? 1 : 0], actual.isDue)) {
        const auto place = std::ranges::lower_bound(due, actual.tetrahedron) - due.begin();
        seed = due[oneOf(static_cast<std::uint64_t>(place), due.size())];
    } else {
        if (base_ == 0)
            return false;
        seed = static_cast<std::uint32_t>(oneOf(actual.tetrahedron, base_));
    }
    if (!state_.alive(seed) || isDying(seed))
        return false;
    return !isFirst || count_ > 1 || placeBySeed(seed, actual.holdsSite);
}

/// The place of a group's only site, where that tells what it destroys.
template <class Coder> bool GroupCoder<Coder>::placeBySeed(std::uint32_t seed, bool holdsSite)
{
    if (onLattice()) {
        if (!bit(models_.hostIsSeed[0], holdsSite))
            return true;
        charge(&HistoryCost::mesh);
        std::uint32_t point = truePoint(0);
        if (!codePointIn(seed, point))
            return false;
        host_ = seed;
        arrays_.points.push_back(point);
        state_.places.push_back(state_.placeOfPoint(point));
        placedEarly_ = true;
        charge(&HistoryCost::positions);
    } else if (state_.facts.delaunay) {
        charge(&HistoryCost::mesh);
        Place middle{};
        for (const std::uint32_t corner : state_.corners[seed])
            for (std::size_t axis = 0; axis < 3; ++axis)
                middle[axis] += state_.places[corner][axis] / 4;
        codePosition(first_, middle);
        placedEarly_ = true;
        charge(&HistoryCost::positions);
    }
    return true;
}

template <class Coder> bool GroupCoder<Coder>::walkFrom(std::uint32_t seed)
{
    if (count_ > 1)
        common_.clear();
    std::size_t at = scratch_.dying.size();
    if (!addDying(seed, nowhere))
        return false;
    for (; at < scratch_.dying.size(); ++at) {
        const std::uint32_t inside = scratch_.dying[at];
        bool atHull = false;
        for (std::uint32_t face = 0; face < 4; ++face) {
            const std::uint32_t other = state_.next[inside][face];
            if (other == nowhere) {
                atHull = true;
                continue;
            }
            if (isDying(other))
                continue;
            std::uint32_t& mark = state_.marks[other];
            if (mark != state_.mark && codeDies(other)) {
                if (!addDying(other, static_cast<std::uint32_t>(at)))
                    return false;
                continue;
            }
            mark = state_.mark;
            scratch_.outers.push_back({inside, face});
        }
        for (std::uint32_t face = 0; atHull && face < 4; ++face)
            if (state_.next[inside][face] == nowhere)
                scratch_.outers.push_back({inside, face});
    }
    return true;
}

/// Whether a neighbour of one that dies does, too.
template <class Coder> bool GroupCoder<Coder>::codeDies(std::uint32_t t)
{
    const auto dies = [&](std::uint32_t other) { return other != nowhere && isDying(other); };
    const auto beside = static_cast<std::size_t>(std::ranges::count_if(state_.next[t], dies)) - 1;
    const auto& corners = state_.corners[t];
    const auto shared = static_cast<std::size_t>(std::ranges::count_if(
        common_, [&](std::uint32_t site) { return std::ranges::find(corners, site) != corners.end(); }));
    const bool predicts = placedEarly_ && state_.facts.delaunay;
    const std::size_t told = predicts ? 1 + (state_.inSphere(t, state_.places[first_]) ? 1 : 0) : 0;
    bool actual = false;
    if constexpr (encodes) {
        const std::uint32_t destroyer = encoded_.model->destroyers()[t];
        actual = destroyer >= first_ && destroyer < first_ + count_;
    }
    return bit(
        models_.dies[count_ == 1 ? 0 : 1][told][std::min<std::size_t>(beside, 3)][std::min<std::size_t>(shared, 3)],
        actual);
}

template <class Coder> bool GroupCoder<Coder>::addDying(std::uint32_t t, std::uint32_t parent)
{
    const auto& corners = state_.corners[t];
    if (parent == nowhere && (scratch_.dying.empty() || count_ > 1))
        common_.assign(corners.begin(), corners.end());
    else
        std::erase_if(common_, [&](std::uint32_t site) { return std::ranges::find(corners, site) == corners.end(); });
    state_.marks[t] = state_.mark + 1;
    const std::uint32_t owner = codeOwner(t, parent);
    scratch_.dying.push_back(t);
    scratch_.owners.push_back(owner);
    return owner < count_;
}

template <class Coder> std::uint32_t GroupCoder<Coder>::codeOwner(std::uint32_t t, std::uint32_t parent)
{
    if (count_ == 1)
        return 0;
    std::uint32_t actual = 0;
    if constexpr (encodes)
        actual = encoded_.model->destroyers()[t] - first_;
    if (parent != nowhere && bit(models_.owner[0], scratch_.owners[parent] == actual))
        return scratch_.owners[parent];
    return codeLocal(models_.ownerStep, actual, parent != nowhere ? scratch_.owners[parent] : 0);
}

/// One of the group's sites, `near` being another one: they are in the order of their points, so that of many the
/// number is not far off.
template <class Coder>
std::uint32_t GroupCoder<Coder>::codeLocal(NumberModel& model, std::uint32_t actual, std::uint32_t near)
{
    constexpr std::uint32_t few = 16;
    if (count_ <= few)
        return static_cast<std::uint32_t>(oneOf(actual, count_));
    return static_cast<std::uint32_t>(unzigzag(number(model, zigzag(actual, near, 32)), near, 32));
}

// What fills the cavity.

/// The faces of the group's tetrahedra.
template <class Coder> bool GroupCoder<Coder>::readActual()
{
    if constexpr (encodes) {
        const Model& model = *encoded_.model;
        const std::uint64_t begin = model.starOffsets()[first_], end = model.starOffsets()[first_ + count_];
        if (begin != base_ || end < begin || end > model.tetrahedronCount())
            return false;
        scratch_.actualNumbers.clear(2 * (end - begin) + 8);
        scratch_.actualFaces.clear();
        scratch_.actualUsed.assign(end - begin, 0);
        used_ = 0;
        unused_ = 0;
        for (std::uint32_t local = 0; local < count_; ++local)
            for (std::uint64_t t = model.starOffsets()[first_ + local]; t < model.starOffsets()[first_ + local + 1];
                 ++t) {
                const auto& [a, b, c] = model.otherSites()[t];
                const Tetrahedron sites{first_ + local, a, b, c};
                if (t < begin || t >= end || std::max({a, b, c}) >= sites[0])
                    return false;
                for (std::uint32_t face = 0; face < 4; ++face) {
                    bool odd = false;
                    const SortedTriangle sorted = sortedTriangle(faceOf(sites, face), odd);
                    const std::uint32_t key = scratch_.actualNumbers.numberOf(sorted);
                    if (key == scratch_.actualFaces.size())
                        scratch_.actualFaces.push_back({nowhere, nowhere});
                    std::uint32_t& side = scratch_.actualFaces[key][odd ? 1 : 0];
                    if (side != nowhere)
                        return false;
                    side = static_cast<std::uint32_t>(4 * (t - begin) + face);
                }
            }
    }
    return true;
}

template <class Coder> bool GroupCoder<Coder>::fillCavity()
{
    if (!readActual())
        return false;
    scratch_.faces.clear();
    scratch_.faceNumbers.clear(3 * scratch_.outers.size());
    scratch_.edgeNumbers.clear();
    scratch_.edgeHeads.clear();
    scratch_.edgeLinks.clear();
    scratch_.cavity.clear();
    scratch_.made.clear();
    if (count_ > 1)
        for (const std::uint32_t t : scratch_.dying)
            for (const std::uint32_t corner : state_.corners[t])
                scratch_.cavity.numberOf(corner);
    std::uint32_t dyingPlace = 0;
    for (const auto& [inside, face] : scratch_.outers) {
        while (scratch_.dying[dyingPlace] != inside)
            ++dyingPlace;
        GroupScratch::Face open;
        open.corners = faceOf(state_.corners[inside], face);
        open.back = state_.next[inside][face];
        if (open.back != nowhere) {
            const auto& back = state_.next[open.back];
            open.backFace = static_cast<std::uint32_t>(std::ranges::find(back, inside) - back.begin());
            if (open.backFace == 4)
                return false;
        }
        open.hint = first_ + scratch_.owners[dyingPlace];
        open.dying = inside;
        open.dyingFace = face;
        const SortedTriangle sorted = sortedTriangle(open.corners, open.odd);
        if (pushFace(open, sorted) + 1 != scratch_.faces.size())
            return false;
    }
    std::uint32_t next = 0;
    for (;;) {
        for (; next < scratch_.faces.size(); ++next)
            if (!scratch_.faces[next].closed && !codeFace(next))
                return false;
        if (!bit(models_.moreTetrahedra[scratch_.dying.empty() ? 0 : 1], used_ < scratch_.actualUsed.size()))
            return true;
        Tetrahedron sites{};
        std::uint32_t actual = 0;
        if constexpr (encodes) {
            while (scratch_.actualUsed[unused_] != 0)
                ++unused_;
            actual = unused_;
            const auto offsets = encoded_.model->starOffsets().subspan(first_, count_ + std::size_t(1));
            const auto star = std::ranges::upper_bound(offsets, base_ + std::uint64_t(actual)) - offsets.begin() - 1;
            const auto& [a, b, c] = encoded_.model->otherSites()[base_ + std::uint64_t(actual)];
            sites = {first_ + static_cast<std::uint32_t>(star), a, b, c};
        }
        sites[0] = first_ + static_cast<std::uint32_t>(oneOf(sites[0] - first_, count_));
        for (std::size_t i = 1; i < 4; ++i)
            sites[i] = static_cast<std::uint32_t>(oneOf(sites[i], first_ + std::uint64_t(count_)));
        if (!addNew(sites, actual, nowhere))
            return false;
    }
}

template <class Coder>
std::uint32_t GroupCoder<Coder>::pushFace(const GroupScratch::Face& face, const SortedTriangle& sorted)
{
    const std::uint32_t key = scratch_.faceNumbers.numberOf(sorted);
    if (key < scratch_.faces.size())
        return key;
    scratch_.faces.push_back(face);
    if (count_ > 1)
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t edge =
                scratch_.edgeNumbers.numberOf(edgeKey(face.corners[i], face.corners[(i + 1) % 3]));
            if (edge == scratch_.edgeHeads.size())
                scratch_.edgeHeads.push_back(nowhere);
            scratch_.edgeLinks.push_back({key, scratch_.edgeHeads[edge]});
            scratch_.edgeHeads[edge] = static_cast<std::uint32_t>(scratch_.edgeLinks.size() - 1);
        }
    return key;
}

/// What lies on the open side of a face, if anything does.
template <class Coder> bool GroupCoder<Coder>::codeFace(std::uint32_t number)
{
    const GroupScratch::Face face = scratch_.faces[number];
    const std::size_t type = face.isNew ? 2 : face.back == nowhere ? 1 : 0;
    const std::size_t single = count_ == 1 ? 0 : 1;
    std::uint32_t actual = nowhere, apex = nowhere;
    if constexpr (encodes) {
        bool odd = false;
        const std::uint32_t key = scratch_.actualNumbers.find(sortedTriangle(face.corners, odd));
        actual = key == decltype(scratch_.actualNumbers)::none ? nowhere : scratch_.actualFaces[key][odd ? 1 : 0];
        if (actual != nowhere) {
            const std::uint64_t t = base_ + std::uint64_t(actual / 4);
            const auto offsets = encoded_.model->starOffsets().subspan(first_, count_ + std::size_t(1));
            const auto star = std::ranges::upper_bound(offsets, t) - offsets.begin() - 1;
            const auto& others = encoded_.model->otherSites()[t];
            apex = actual % 4 == 0 ? first_ + static_cast<std::uint32_t>(star) : others[actual % 4 - 1];
        }
    }
    const bool hasHull = scratch_.outers.empty()
                             ? true
                             : state_.next[scratch_.outers.back().inside][scratch_.outers.back().face] == nowhere;
    if (!bit(models_.isFilled[single][type][hasHull ? 1 : 0], actual != nowhere))
        return true;
    std::uint32_t coded = apex;
    if (!codeApex(face, type, apex, coded))
        return false;
    return addNew({coded, face.corners[0], face.corners[1], face.corners[2]}, actual / 4, number);
}

template <class Coder> bool GroupCoder<Coder>::codeApex(const GroupScratch::Face& face, std::size_t type,
                                                        std::uint32_t actual, std::uint32_t& apex)
{
    const std::size_t single = count_ == 1 ? 0 : 1;
    constexpr std::size_t most = 8;
    std::vector<std::uint32_t>& candidates = scratch_.candidates;
    candidates.clear();
    const auto offer = [&](std::uint32_t site) {
        if (site != nowhere && candidates.size() < most &&
            std::ranges::find(face.corners, site) == face.corners.end() &&
            std::ranges::find(candidates, site) == candidates.end())
            candidates.push_back(site);
    };
    offer(single == 0 ? first_ : face.hint);
    for (std::size_t i = 0; single == 1 && i < 3; ++i) {
        const std::uint32_t edge = scratch_.edgeNumbers.find(edgeKey(face.corners[i], face.corners[(i + 1) % 3]));
        for (std::uint32_t* link = &scratch_.edgeHeads[edge]; *link != nowhere && candidates.size() < most;) {
            GroupScratch::EdgeLink& at = scratch_.edgeLinks[*link];
            const GroupScratch::Face& other = scratch_.faces[at.face];
            if (other.closed) { // and stays so: nobody has to pass it again
                *link = at.before;
                continue;
            }
            for (const std::uint32_t corner : other.corners)
                offer(corner);
            link = &at.before;
        }
    }
    for (std::size_t rank = 0; rank < candidates.size(); ++rank)
        if (bit(models_.apex[single][type][rank], candidates[rank] == actual)) {
            apex = candidates[rank];
            return true;
        }
    const std::uint32_t place = encodes ? scratch_.cavity.find(actual) : 0;
    if (scratch_.cavity.size() > 0 &&
        bit(models_.otherIsInCavity[type == 2 ? 1 : 0], place != decltype(scratch_.cavity)::none)) {
        apex = scratch_.cavity.keys()[oneOf(place, scratch_.cavity.size())];
        return true;
    }
    if (first_ == 0 || bit(models_.otherIsInGroup[type == 2 ? 1 : 0], actual >= first_)) {
        const std::uint32_t latest = std::ranges::max(face.corners);
        const std::uint32_t near = latest >= first_ ? latest - first_ : face.hint != nowhere ? face.hint - first_ : 0;
        const std::uint32_t local = codeLocal(models_.apexStep, actual - first_, near);
        if (local >= count_)
            return false;
        apex = first_ + local;
    } else
        apex = static_cast<std::uint32_t>(oneOf(actual, first_));
    return true;
}

/// `from`: the face that it fills, or nowhere.
template <class Coder>
bool GroupCoder<Coder>::addNew(const Tetrahedron& sites, std::uint32_t actual, std::uint32_t from)
{
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t k = i + 1; k < 4; ++k)
            if (sites[i] == sites[k])
                return false;
    if (std::ranges::max(sites) < first_ || base_ + scratch_.made.size() >= state_.facts.tetrahedronCount)
        return false;
    if constexpr (encodes) {
        if (std::exchange(scratch_.actualUsed[actual], std::uint8_t(1)) != 0)
            return false;
        ++used_;
    }
    const auto place = static_cast<std::uint32_t>(scratch_.made.size());
    scratch_.made.emplace_back();
    scratch_.made.back().sites = sites;
    scratch_.made.back().actual = actual;
    const auto meet = [&](GroupScratch::Face& face, std::uint32_t own) {
        face.closed = true;
        GroupScratch::New& tetrahedron = scratch_.made[place];
        tetrahedron.next[own] = face.back;
        tetrahedron.nextIsNew[own] = face.isNew;
        if (face.isNew) {
            scratch_.made[face.back].next[face.backFace] = place;
            scratch_.made[face.back].nextIsNew[face.backFace] = true;
        }
    };
    if (from != nowhere) {
        scratch_.made.back().dying = scratch_.faces[from].dying;
        scratch_.made.back().dyingCorner = scratch_.faces[from].dyingFace;
        meet(scratch_.faces[from], 0);
    }
    for (std::uint32_t own = from != nowhere ? 1 : 0; own < 4; ++own) {
        const auto& [a, b, c] = faceOf(sites, own);
        GroupScratch::Face open;
        open.corners = {a, c, b};
        open.back = place;
        open.backFace = own;
        open.isNew = true;
        const SortedTriangle sorted = sortedTriangle(open.corners, open.odd);
        const std::size_t before = scratch_.faces.size();
        const std::uint32_t number = pushFace(open, sorted);
        if (number == before)
            continue;
        GroupScratch::Face& face = scratch_.faces[number];
        if (face.closed || face.odd == open.odd)
            return false;
        meet(face, own);
    }
    return true;
}

// Stars in their order.

template <class Coder> bool GroupCoder<Coder>::orderStars()
{
    if (scratch_.stars.size() < count_)
        scratch_.stars.resize(count_);
    for (std::uint32_t local = 0; local < count_; ++local)
        scratch_.stars[local].clear();
    for (std::uint32_t place = 0; place < scratch_.made.size(); ++place)
        scratch_.stars[std::ranges::max(scratch_.made[place].sites) - first_].push_back(place);
    scratch_.numbers.resize(scratch_.made.size());
    scratch_.parents.resize(scratch_.made.size());
    std::uint32_t number = base_;
    const std::size_t single = count_ == 1 ? 0 : 1;
    for (std::uint32_t local = 0; local < count_; ++local) {
        std::vector<std::uint32_t>& left = scratch_.stars[local];
        if constexpr (encodes)
            if (encoded_.model->starOffsets()[first_ + local] != number)
                return false;
        for (std::size_t done = 0; done < left.size(); ++done, ++number) {
            std::size_t actual = done;
            if constexpr (encodes)
                while (actual + 1 < left.size() && base_ + scratch_.made[left[actual]].actual != number)
                    ++actual;
            const std::size_t choices = left.size() - done;
            const std::size_t expected = nextAround(left, done);
            std::size_t chosen = expected;
            if (choices > 1 &&
                !bit(models_.orderIsNext[single][std::min<std::size_t>(std::bit_width(choices) - 1, 4) - 1],
                     actual == expected)) {
                chosen = done + oneOf(actual < expected ? actual - done : actual - done - 1, choices - 1);
                chosen += chosen >= expected ? 1 : 0;
            }
            // The others keep their order.
            std::rotate(left.begin() + static_cast<std::ptrdiff_t>(done),
                        left.begin() + static_cast<std::ptrdiff_t>(chosen),
                        left.begin() + static_cast<std::ptrdiff_t>(chosen) + 1);
            scratch_.numbers[left[done]] = number;
            scratch_.parents[number - base_] = scratch_.made[left[done]].dying;
            if (!turnCreatorFirst(scratch_.made[left[done]], first_ + local))
                return false;
        }
    }
    return true;
}

/// Which of a star's tetrahedra is likely to follow the first `done`. On a lattice it is the next one in order. The
/// builder of scattered points walks around the new point from tetrahedron to tetrahedron: it visits all neighbours of
/// one, and then those of the last one visited, so there it is the neighbour that this walk reaches next.
template <class Coder> std::size_t GroupCoder<Coder>::nextAround(std::span<const std::uint32_t> star, std::size_t done)
{
    if (onLattice() || !state_.facts.delaunay)
        return done;
    if (done == 0)
        return done;
    if (done == 1) {
        around_.clear();
        asked_ = star[0];
    } else {
        around_.push_back(star[done - 1]);
    }
    for (;;) {
        const GroupScratch::New& tetrahedron = scratch_.made[asked_];
        const auto front = static_cast<std::size_t>(std::countr_zero(tetrahedron.fronts));
        for (std::size_t corner = 0; corner < 4; ++corner) {
            const auto& others = cornersOfFace[front];
            const auto stored = static_cast<std::size_t>(std::ranges::find(others, corner) - others.begin());
            if (stored == 3 || !tetrahedron.nextIsNew[1 + stored])
                continue;
            const auto left = star.subspan(done);
            const auto found = std::ranges::find(left, tetrahedron.next[1 + stored]);
            if (found != left.end())
                return done + static_cast<std::size_t>(found - left.begin());
        }
        if (around_.empty())
            return done;
        asked_ = around_.back();
        around_.pop_back();
    }
}

/// The creator in front, the others in the order in which they are stored.
template <class Coder> bool GroupCoder<Coder>::turnCreatorFirst(GroupScratch::New& tetrahedron, std::uint32_t creator)
{
    std::array<std::size_t, 4> corners{0, 1, 2, 3};
    corners = withCornerFirst(
        corners, static_cast<std::size_t>(std::ranges::find(tetrahedron.sites, creator) - tetrahedron.sites.begin()));
    std::size_t turn = 0;
    if constexpr (encodes) {
        const auto& others = encoded_.model->otherSites()[base_ + std::uint64_t(tetrahedron.actual)];
        const auto site = [&](std::size_t i) { return tetrahedron.sites[corners[1 + i % 3]]; };
        while (turn < 3 && others[0] != site(turn))
            ++turn;
        if (turn == 3 || others[1] != site(turn + 1) || others[2] != site(turn + 2))
            return false;
    }
    turn = codeTurn(tetrahedron, corners, turn);
    const GroupScratch::New before = tetrahedron;
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t from = i == 0 ? corners[0] : corners[1 + (i - 1 + turn) % 3];
        tetrahedron.sites[i] = before.sites[from];
        tetrahedron.next[i] = before.next[from];
        tetrahedron.nextIsNew[i] = before.nextIsNew[from];
    }
    return true;
}

/// By how many places the three other corners are rotated against the face that the tetrahedron fills. A builder that
/// replaces one corner in place keeps the order of all four; a file, in which the creator comes first, keeps only the
/// order of the other three.
template <class Coder> std::size_t GroupCoder<Coder>::codeTurn(GroupScratch::New& tetrahedron,
                                                               const std::array<std::size_t, 4>& corners,
                                                               std::size_t actual)
{
    struct Guess {
        std::uint8_t parent = 0, own = 0; ///< the creators' places
        std::size_t turn = 0;
    };
    std::array<Guess, 4> guesses{};
    std::size_t count = 0, expected = 0;
    std::array<std::size_t, 3> votes{};
    if (state_.turnsInPlace() && tetrahedron.dying != nowhere) {
        const Tetrahedron& parent = state_.corners[tetrahedron.dying];
        for (std::uint8_t front = 0; front < 4; ++front) {
            if ((state_.fronts[tetrahedron.dying] >> front & 1) == 0)
                continue;
            Tetrahedron order{};
            order[front] = parent[0];
            for (std::size_t i = 0; i < 3; ++i)
                order[cornersOfFace[front][i]] = parent[1 + i];
            Guess guess{front, 0, 0};
            guess.own =
                static_cast<std::uint8_t>(std::ranges::find(order, parent[tetrahedron.dyingCorner]) - order.begin());
            const std::uint32_t second = order[cornersOfFace[guess.own][0]];
            while (guess.turn < 2 && tetrahedron.sites[corners[1 + guess.turn]] != second)
                ++guess.turn;
            ++votes[guess.turn];
            guesses[count++] = guess;
        }
        expected = static_cast<std::size_t>(std::ranges::max_element(votes) - votes.begin());
    }
    // Whether the corner that goes is one that all has that dies, as where an edge was collapsed.
    const bool isCommon =
        count > 0 &&
        std::ranges::find(common_, state_.corners[tetrahedron.dying][tetrahedron.dyingCorner]) != common_.end();
    const std::size_t sure = count == 0 ? 0 : votes[expected] == count ? 2 : 1;
    auto& models = models_.turn[count_ == 1 ? 0 : 1][isCommon ? 1 : 0][sure];
    const std::size_t off = (actual + 3 - expected) % 3;
    const std::size_t coded = bit(models[0], off != 0) ? bit(models[1], off == 2) ? 2 : 1 : 0;
    const std::size_t turn = (expected + coded) % 3;
    std::uint8_t parents = 0, fronts = 0;
    for (const Guess& guess : std::span(guesses).first(count))
        if (guess.turn == turn) {
            parents = static_cast<std::uint8_t>(parents | 1u << guess.parent);
            fronts = static_cast<std::uint8_t>(fronts | 1u << guess.own);
        }
    if (fronts != 0) {
        state_.fronts[tetrahedron.dying] = parents;
        tetrahedron.fronts = fronts;
    }
    return turn;
}

/// Puts the new tetrahedra in the place of those that die.
template <class Coder> void GroupCoder<Coder>::link()
{
    for (std::size_t i = 0; i < scratch_.dying.size(); ++i)
        arrays_.destroyers[scratch_.dying[i]] = first_ + scratch_.owners[i];
    for (const auto& [inside, face] : scratch_.outers)
        if (const std::uint32_t other = state_.next[inside][face]; other != nowhere)
            *std::ranges::find(state_.next[other], inside) = nowhere;
    const std::size_t count = scratch_.made.size();
    state_.corners.resize(base_ + count);
    state_.next.resize(base_ + count);
    state_.fronts.resize(base_ + count);
    state_.marks.resize(base_ + count);
    arrays_.otherSites.resize(base_ + count);
    arrays_.destroyers.resize(base_ + count, Model::never);
    for (std::size_t place = 0; place < count; ++place) {
        const GroupScratch::New& tetrahedron = scratch_.made[place];
        const std::uint32_t number = scratch_.numbers[place];
        state_.corners[number] = tetrahedron.sites;
        state_.fronts[number] = tetrahedron.fronts;
        arrays_.otherSites[number] = {tetrahedron.sites[1], tetrahedron.sites[2], tetrahedron.sites[3]};
        for (std::size_t i = 0; i < 4; ++i)
            state_.next[number][i] =
                tetrahedron.nextIsNew[i] ? scratch_.numbers[tetrahedron.next[i]] : tetrahedron.next[i];
    }
    for (std::size_t place = 0; place < count; ++place)
        for (std::size_t i = 0; i < 4; ++i) {
            const GroupScratch::New& tetrahedron = scratch_.made[place];
            if (tetrahedron.nextIsNew[i] || tetrahedron.next[i] == nowhere)
                continue;
            // The old one's face that has the same corners.
            const std::uint32_t other = tetrahedron.next[i];
            for (std::size_t k = 0; k < 4; ++k)
                if (std::ranges::find(tetrahedron.sites, state_.corners[other][k]) == tetrahedron.sites.end())
                    state_.next[other][k] = scratch_.numbers[place];
        }
    for (std::uint32_t local = 0; local < count_; ++local)
        arrays_.starOffsets.push_back(arrays_.starOffsets.back() + scratch_.stars[local].size());
    state_.living += count - scratch_.dying.size();
    std::erase_if(state_.due, [this](std::uint32_t t) { return !state_.alive(t); });
}

// The sites.

template <class Coder> bool GroupCoder<Coder>::codeSites()
{
    for (std::uint32_t local = 0; local < count_; ++local) {
        if (!(onLattice() ? codePoint(local) : codeFreePoint(local)))
            return false;
        if (state_.facts.domain == DomainClass::Curvilinear) {
            Place predicted{};
            std::array<double, 4> weights{};
            const bool interpolates =
                host_ != nowhere && state_.weightsAt(host_, state_.places[first_ + local], weights);
            const std::uint32_t site = first_ + local;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const auto coordinate = [&](std::uint32_t s) -> double {
                    return state_.facts.coordinateBytes == 4
                               ? static_cast<double>(state_.template coordinate<float>(s, axis))
                               : state_.template coordinate<double>(s, axis);
                };
                if (interpolates)
                    for (std::size_t i = 0; i < 4; ++i)
                        predicted[axis] += weights[i] * coordinate(state_.corners[host_][i]);
                else if (site > 0)
                    predicted[axis] = coordinate(site - 1);
            }
            codePosition(site, predicted);
        }
        charge(&HistoryCost::positions);
        codeValue(local);
        charge(&HistoryCost::values);
        host_ = nowhere;
    }
    return true;
}

/// The dying tetrahedra of which a site is the destroyer, or all of the group's.
template <class Coder> std::span<const std::uint32_t> GroupCoder<Coder>::hostsOf(std::uint32_t local, bool owned) const
{
    if (!owned)
        return scratch_.dying;
    return std::span(scratch_.owned)
        .subspan(scratch_.ownedBegins[local], scratch_.ownedBegins[local + 1] - scratch_.ownedBegins[local]);
}

template <class Coder> void GroupCoder<Coder>::sortByOwner()
{
    scratch_.ownedBegins.assign(count_ + std::size_t(1), 0);
    for (const std::uint32_t owner : scratch_.owners)
        ++scratch_.ownedBegins[owner];
    std::uint32_t sum = 0;
    for (std::uint32_t& begin : scratch_.ownedBegins)
        begin = sum += begin;
    scratch_.owned.resize(scratch_.dying.size());
    for (std::size_t i = scratch_.dying.size(); i-- > 0;)
        scratch_.owned[--scratch_.ownedBegins[scratch_.owners[i]]] = scratch_.dying[i];
}

template <class Coder> bool GroupCoder<Coder>::codePoint(std::uint32_t local)
{
    constexpr std::size_t mostHosts = 256;
    if (placedEarly_)
        return true;
    std::uint32_t point = truePoint(local);
    // Which of the tetrahedra that die it lies in, and which point in it.
    for (const bool owned : {true, false}) {
        if (!owned && (count_ == 1 || scratch_.dying.size() > mostHosts))
            break;
        const std::span<const std::uint32_t> hosts = hostsOf(local, owned);
        if (hosts.empty())
            continue;
        std::size_t actual = hosts.size();
        if constexpr (encodes) {
            const Place place = state_.placeOfPoint(point);
            actual = static_cast<std::size_t>(
                std::ranges::find_if(hosts, [&](std::uint32_t t) { return state_.contains(t, place); }) -
                hosts.begin());
        }
        if (!bit(models_.hostOwned[owned ? 1 : 0], actual < hosts.size()))
            continue;
        std::size_t chosen = 0;
        if (hosts.size() > 1 && !bit(models_.hostIsFirst[owned ? 1 : 0], actual == 0))
            chosen = 1 + oneOf(actual - 1, hosts.size() - 1);
        host_ = hosts[chosen];
        if (!codePointIn(host_, point))
            return false;
        arrays_.points.push_back(point);
        state_.places.push_back(state_.placeOfPoint(point));
        return true;
    }
    const std::uint32_t before = arrays_.points.empty() ? 0 : arrays_.points.back();
    point = static_cast<std::uint32_t>(unzigzag(number(models_.pointDelta, zigzag(point, before, 32)), before, 32));
    if (point >= state_.facts.lattice.pointCount())
        return false;
    state_.used[point] = true;
    arrays_.points.push_back(point);
    state_.places.push_back(state_.placeOfPoint(point));
    return true;
}

/// One of the points in a tetrahedron that are no sites yet; of a large one, a point of its box.
template <class Coder> bool GroupCoder<Coder>::codePointIn(std::uint32_t host, std::uint32_t& point)
{
    constexpr std::uint64_t mostLookedAt = 1 << 15;
    const auto& size = state_.facts.lattice.size;
    const auto coordinates = [&](std::uint32_t p) -> std::array<std::uint32_t, 3> {
        return {p % size[0], p / size[0] % size[1], p / size[0] / size[1]};
    };
    std::array<std::uint32_t, 3> low{nowhere, nowhere, nowhere}, high{};
    for (const std::uint32_t corner : state_.corners[host]) {
        const auto at = coordinates(arrays_.points[corner]);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], at[axis]);
            high[axis] = std::max(high[axis], at[axis]);
        }
    }
    std::uint64_t boxed = 1;
    for (std::size_t axis = 0; axis < 3; ++axis)
        boxed *= high[axis] - low[axis] + std::uint64_t(1);
    if (boxed > mostLookedAt) {
        auto at = coordinates(point);
        for (std::size_t axis = 0; axis < 3; ++axis)
            at[axis] = low[axis] + static_cast<std::uint32_t>(
                                       oneOf(at[axis] - low[axis], high[axis] - low[axis] + std::uint64_t(1)));
        point = (at[2] * size[1] + at[1]) * size[0] + at[0];
    } else {
        scratch_.inside.clear();
        state_.visitPointsIn(host, low, high, [&](std::uint32_t p) {
            if (!state_.used[p])
                scratch_.inside.push_back(p);
        });
        if (scratch_.inside.empty())
            return false;
        std::size_t actual = 0;
        if constexpr (encodes) {
            actual =
                static_cast<std::size_t>(std::ranges::lower_bound(scratch_.inside, point) - scratch_.inside.begin());
            if (actual == scratch_.inside.size() || scratch_.inside[actual] != point)
                return false;
        }
        point = scratch_.inside[oneOf(actual, scratch_.inside.size())];
    }
    state_.used[point] = true;
    return true;
}

/// Coordinates as they are stored, next to where they are expected; those that were written as decimals as these.
template <class Coder> void GroupCoder<Coder>::codePosition(std::uint32_t site, const Place& predicted)
{
    const auto code = [&]<class T>(T) {
        Place place{};
        const auto keep = [&](std::size_t axis, T coordinate) {
            place[axis] = static_cast<double>(coordinate);
            const auto* bytes = reinterpret_cast<const std::byte*>(&coordinate);
            arrays_.positions.insert(arrays_.positions.end(), bytes, bytes + sizeof coordinate);
        };
        for (std::size_t axis = 0; axis < 3; ++axis) {
            constexpr unsigned bits = 8 * sizeof(T);
            const std::uint64_t from = orderOf(nearestNumber<T>(predicted[axis]));
            T exact{};
            if constexpr (encodes) {
                if constexpr (sizeof(T) == 4)
                    exact = encoded_.model->floatPositions()[site][static_cast<int>(axis)];
                else
                    exact = encoded_.model->doublePositions()[site][static_cast<int>(axis)];
            }
            if (state_.facts.decimals) {
                const unsigned digits = codeDigits(encodes ? decimalsIn(exact) : 0);
                if (digits <= mostDecimals) {
                    const double unit = powerOfTen(digits);
                    const auto near = static_cast<std::uint64_t>(wholeUnits(predicted[axis], unit).value_or(0));
                    std::uint64_t units = 0;
                    if constexpr (encodes)
                        units = static_cast<std::uint64_t>(*wholeUnits(static_cast<double>(exact), unit));
                    units =
                        unzigzag(wideNumber(models_.decimal[digits > 4 ? 1 : 0], zigzag(units, near, 64)), near, 64);
                    keep(axis, nearestNumber<T>(static_cast<double>(static_cast<std::int64_t>(units)) / unit));
                    continue;
                }
            }
            const std::uint64_t coded = wideNumber(models_.coordinate[axis], zigzag(orderOf(exact), from, bits));
            keep(axis, numberOfOrder<T>(unzigzag(coded, from, bits)));
        }
        if (!onLattice())
            state_.places.push_back(place);
    };
    state_.facts.coordinateBytes == 4 ? code(float()) : code(double());
}

/// The middle of those that have a place.
template <class Coder> Place GroupCoder<Coder>::middleOfNeighbours(std::uint32_t site) const
{
    Place middle{};
    std::uint32_t neighbours = 0;
    for (std::uint64_t t = arrays_.starOffsets[site]; t < arrays_.starOffsets[site + std::size_t(1)]; ++t)
        for (const std::uint32_t other : arrays_.otherSites[t])
            if (placed(other)) {
                for (std::size_t axis = 0; axis < 3; ++axis)
                    middle[axis] += state_.places[other][axis];
                ++neighbours;
            }
    if (neighbours == 0)
        return site > 0 ? state_.places.back() : middle;
    for (double& coordinate : middle)
        coordinate /= neighbours;
    return middle;
}

/// Irregular and scattered data: where the site is and then which point it is.
template <class Coder> bool GroupCoder<Coder>::codeFreePoint(std::uint32_t local)
{
    const std::uint32_t site = first_ + local;
    if (!placedEarly_)
        codePosition(site, middleOfNeighbours(site));
    // Points that are near have numbers that are.
    std::uint32_t nearest = site > 0 ? site - 1 : nowhere;
    double least = std::numeric_limits<double>::infinity();
    for (std::uint64_t t = arrays_.starOffsets[site]; t < arrays_.starOffsets[site + std::size_t(1)]; ++t)
        for (const std::uint32_t other : arrays_.otherSites[t])
            if (other < site) {
                double square = 0;
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    const double along = state_.places[other][axis] - state_.places[site][axis];
                    square += along * along;
                }
                if (square < least) {
                    least = square;
                    nearest = other;
                }
            }
    const std::uint32_t from = nearest == nowhere ? 0 : arrays_.points[nearest];
    const std::uint64_t coded = number(models_.pointDelta, zigzag(truePoint(local), from, 32));
    arrays_.points.push_back(static_cast<std::uint32_t>(unzigzag(coded, from, 32)));
    host_ = hostOfFreeSite(local);
    return true;
}

/// Of the tetrahedra that the site destroys, the one that contains it or, if none does, the one nearest to containing
/// it.
template <class Coder> std::uint32_t GroupCoder<Coder>::hostOfFreeSite(std::uint32_t local)
{
    std::span<const std::uint32_t> hosts = hostsOf(local, true);
    if (hosts.empty())
        hosts = hostsOf(local, false);
    constexpr std::size_t mostLookedAt = 256;
    std::uint32_t best = nowhere;
    double largest = -std::numeric_limits<double>::infinity();
    for (const std::uint32_t t : hosts.first(std::min(hosts.size(), mostLookedAt))) {
        std::array<double, 4> weights{};
        if (!state_.weightsAt(t, state_.places[first_ + local], weights))
            continue;
        if (const double least = std::ranges::min(weights); least > largest) {
            largest = least;
            best = t;
        }
    }
    return best;
}

/// What the mesh has there; nothing where the site's host is not known, or flat.
template <class Coder> std::optional<double> GroupCoder<Coder>::valueInHost(std::uint32_t site) const
{
    std::array<double, 4> weights{};
    if (host_ == nowhere || !state_.weightsAt(host_, state_.places[site], weights))
        return {};
    double value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value += weights[i] * state_.value(state_.corners[host_][i]);
    return value;
}

/// Of those that came before it; of the last one if it has none.
template <class Coder> double GroupCoder<Coder>::meanOfNeighbours(std::uint32_t site) const
{
    double sum = 0;
    std::uint32_t neighbours = 0;
    for (std::uint64_t t = arrays_.starOffsets[site]; t < arrays_.starOffsets[site + std::size_t(1)]; ++t)
        for (const std::uint32_t other : arrays_.otherSites[t])
            if (other < site) {
                sum += state_.value(other);
                ++neighbours;
            }
    if (neighbours > 0)
        return sum / neighbours;
    return site > 0 ? state_.value(site - 1) : 0;
}

/// The value differs from the mesh's by the key where the site was the reason for it (S19).
template <class Coder> void GroupCoder<Coder>::codeValue(std::uint32_t local)
{
    const std::uint32_t site = first_ + local;
    const std::optional<double> interpolated = valueInHost(site);
    const double predicted = interpolated ? *interpolated : meanOfNeighbours(site);
    visitSampleType(state_.facts.sampleType, [&]<class T>() {
        constexpr unsigned bits = 8 * sizeof(T);
        T actual{};
        if constexpr (encodes)
            std::memcpy(&actual, encoded_.model->values().data() + site * sizeof(T), sizeof(T));
        const auto key = static_cast<double>(key_);
        const auto from = [&](double expected) { return orderOf(nearestNumber<T>(expected)); };
        const auto distance = [&](double expected) { return zigzag(orderOf(actual), from(expected), bits); };
        bool byKey = false, above = false;
        if (interpolated && key > 0 && std::isfinite(key)) {
            if constexpr (encodes) {
                above = distance(predicted + key) < distance(predicted - key);
                byKey = distance(above ? predicted + key : predicted - key) < distance(predicted);
            }
            byKey = bit(models_.valueByKey[0], byKey);
            if (byKey)
                above = bit(models_.valueByKey[1], above);
        }
        const double expected = !byKey ? predicted : above ? predicted + key : predicted - key;
        const std::uint64_t coded = wideNumber(models_.value[byKey ? 1 : 0], distance(expected));
        const T value = numberOfOrder<T>(unzigzag(coded, from(expected), bits));
        const auto* bytes = reinterpret_cast<const std::byte*>(&value);
        arrays_.values.insert(arrays_.values.end(), bytes, bytes + sizeof value);
    });
}

// The tetrahedra's own bounds.

/// A cell of the lattice, or else a share of the mean volume of what was made.
template <class Coder> double GroupCoder<Coder>::unitOfVolume() const
{
    if (onLattice()) {
        const auto& spacing = state_.facts.lattice.spacing;
        return spacing[0] * spacing[1] * spacing[2];
    }
    double sum = 0;
    for (std::uint32_t t = base_; t < state_.tetrahedronCount(); ++t)
        sum += std::abs(state_.volume(t));
    return sum / std::max<double>(1, static_cast<double>(scratch_.made.size())) / 64;
}

template <class Coder> void GroupCoder<Coder>::codeOwn()
{
    const bool warps = canWarp(state_.facts.domain);
    // Bounds are near that of the mesh, as a share of the range.
    const auto expected = [this](double whole) -> std::uint32_t {
        const double share = static_cast<double>(key_) / whole;
        return share > 0 && share < 1 ? halfRoundedUp(static_cast<float>(share)) : 0x3c00;
    };
    const std::array<std::uint32_t, 2> key{expected(state_.facts.extent),
                                           expected(state_.facts.diagonal * state_.facts.warpingWeight)};
    const double unit = unitOfVolume();
    std::array<std::size_t, 2> before{2, 2};
    for (std::uint32_t t = base_; t < state_.tetrahedronCount(); ++t) {
        int exponent = 0;
        const double share = std::abs(state_.volume(t)) / unit;
        if (share > 0 && share < 1e9)
            std::frexp(share + 0.25, &exponent);
        const auto size = static_cast<std::size_t>(std::clamp(exponent, 0, 15));
        for (std::size_t kind = 0; kind < (warps ? 2u : 1u); ++kind)
            codeOwnBound(t, kind, size, key[kind], before[kind]);
        if (const double bound = state_.ownKey(t); bound > 0)
            state_.queue.emplace(bound, t);
    }
}

/// `kind` 0: the error, 1: the warping; `before`: 0 if that of the last tetrahedron was zero, 1 if not, 2 for the
/// first.
template <class Coder> void GroupCoder<Coder>::codeOwnBound(std::uint32_t t, std::size_t kind, std::size_t size,
                                                            std::uint32_t key, std::size_t& before)
{
    std::vector<std::uint16_t>& own = kind == 0 ? arrays_.ownErrors : arrays_.ownWarpings;
    std::uint16_t actual = 0;
    if constexpr (encodes)
        actual = kind == 0 ? encoded_.model->ownErrors()[t] : encoded_.model->ownWarpings()[t];
    const std::uint32_t parent = scratch_.parents[t - base_];
    const std::size_t parentClass = parent == nowhere ? 2 : own[parent] == 0 ? 0 : 1;
    const bool isZero = bit(models_.ownIsZero[kind][size][before][parentClass], actual == 0);
    before = isZero ? 0 : 1;
    std::uint64_t half = 0;
    const std::uint32_t near = parentClass == 1 ? own[parent] : key;
    if (!isZero)
        half = unzigzag(number(models_.own[kind][parentClass], zigzag(actual, near, 16)), near, 16);
    own.push_back(static_cast<std::uint16_t>(half));
}

template <class Coder> void GroupCoder<Coder>::finish()
{
    for (std::uint32_t local = 0; local < count_; ++local) {
        arrays_.runningKeys.push_back(key_);
        arrays_.meshSizes.push_back(static_cast<std::uint32_t>(state_.living));
        arrays_.groupGoesOn.push_back(local + 1 < count_ ? 1 : 0);
    }
}

} // namespace

HistoryEncoder::HistoryEncoder(const Model& model, const HistoryFacts& facts)
    : model_(model), state_(std::make_unique<HistoryState>(facts)), deathOffsets_(model.siteCount() + std::size_t(1))
{
    const auto destroyers = model.destroyers();
    const auto dies = [&](std::uint64_t t) { return destroyers[t] < model.siteCount(); };
    for (std::uint64_t t = 0; t < destroyers.size(); ++t)
        if (dies(t))
            ++deathOffsets_[destroyers[t] + std::size_t(1)];
    for (std::size_t site = 0; site < model.siteCount(); ++site)
        deathOffsets_[site + 1] += deathOffsets_[site];
    deaths_.resize(deathOffsets_.back());
    std::vector<std::uint64_t> next = deathOffsets_;
    for (std::uint64_t t = 0; t < destroyers.size(); ++t)
        if (dies(t))
            deaths_[next[destroyers[t]]++] = static_cast<std::uint32_t>(t);
}

bool hasDecimals(const Model& model)
{
    // In bits: what decimals take within the bounding box, and what the numbers themselves take near others.
    const auto areShort = [&](const auto& positions) {
        double sum = 0;
        for (const auto& position : positions)
            for (const auto coordinate : {position[0], position[1], position[2]}) {
                const unsigned digits = decimalsIn(coordinate);
                const auto own = static_cast<double>(8 * sizeof coordinate - 12);
                sum += digits > mostDecimals ? 4 : std::log2(model.diagonal() * powerOfTen(digits) + 1) - 3 - own;
            }
        return sum < 0;
    };
    return model.floatPositions().empty() ? areShort(model.doublePositions()) : areShort(model.floatPositions());
}

HistoryEncoder::~HistoryEncoder() = default;

const HistoryArrays& HistoryEncoder::arrays() const noexcept
{
    return state_->arrays;
}

Result<std::vector<std::byte>> HistoryEncoder::encode(std::uint32_t end)
{
    RangeEncoder coder;
    const EncodedHistory actual{&model_, deathOffsets_, deaths_};
    GroupCoder<RangeEncoder> groups(*state_, coder, actual, cost_);
    if (!groups.run(end))
        return Error{
            ErrorKind::BadInput,
            Message::say("'%1' cannot be packed: its history is not that of a mesh. 'tan verify' gives details.",
                         model_.path().string())};
    return coder.finish();
}

HistoryDecoder::HistoryDecoder(const HistoryFacts& facts) : state_(std::make_unique<HistoryState>(facts)) {}

HistoryDecoder::~HistoryDecoder() = default;

const HistoryArrays& HistoryDecoder::arrays() const noexcept
{
    return state_->arrays;
}

bool HistoryDecoder::decode(std::span<const std::byte> bytes, std::uint32_t end)
{
    if (end > state_->facts.siteCount)
        return false;
    RangeDecoder coder(bytes);
    HistoryCost unused;
    const EncodedHistory none;
    return GroupCoder<RangeDecoder>(*state_, coder, none, unused).run(end);
}

} // namespace tetra
