// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/simd.h"
#include "core/packed/free_points.h"
#include "core/packed/number_order.h"
#include "core/packed/range_coder.h"

#include <tan/data.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>
#include <variant>
#include <vector>

namespace tetra {

/// What the chunks of a replayed model are coded with (FORMAT.md, "Packed form"). Each chunk begins with new ones.

/// How many free points lie between one site of a step and the next.
class GapCoder {
public:
    /// `mean`: the step's free points divided by its sites.
    template <class Coder> std::uint64_t code(Coder& coder, std::uint64_t mean, std::uint64_t gap)
    {
        const auto size = static_cast<std::size_t>(std::bit_width(mean));
        const std::size_t lately = before_ * 4 < mean ? 0 : before_ < mean ? 1 : before_ < 3 * mean ? 2 : 3;
        gap = models_[size * classes + lately].code(coder, gap);
        before_ = (before_ + gap + 1) / 2;
        return gap;
    }

private:
    static constexpr std::size_t classes = 4;
    std::vector<NumberModel> models_ = std::vector<NumberModel>(34 * classes);
    std::uint64_t before_ = 0; ///< lately, on average
};

/// Takes points of a step out of the free ones, from `place` on. False if there are none.
TETRA_SIMD_INLINE bool takePoints(RangeDecoder& coder, GapCoder& gaps, std::uint64_t mean, FreePoints& free,
                                  std::uint64_t& place, std::span<std::uint32_t> points)
{
    for (std::uint32_t& point : points) {
        const std::uint64_t found = free.next(place, gaps.code(coder, mean, 0));
        if (found >= free.size() || coder.overrun())
            return false;
        free.remove(found);
        point = static_cast<std::uint32_t>(found);
        place = found + 1;
    }
    return true;
}

/// The value of a sample of which something is expected. Lossless for every value and whatever is expected.
template <class T> class ValueCoder {
public:
    template <class Coder> T code(Coder& coder, double expected, T value)
    {
        if constexpr (std::is_integral_v<T>)
            return codeInteger(coder, expected, value);
        else
            return codeFloat(coder, expected, value);
    }

private:
    /// Integers that are off by fewer bits than this: there it tells which side of the expectation they are on.
    static constexpr std::size_t leaningSizes = 5;

    struct Context {
        BitModel isNext;
        BitModel isBeyond;
        std::array<NumberModel, 2> distances;
    };

    /// The signed number of steps from what is expected.
    template <class Coder> std::int64_t codeSteps(Coder& coder, Context& context, std::int64_t steps)
    {
        if (!codedBit(coder, context.isNext, steps != 0))
            return 0;
        const bool negative = codedBit(coder, context.isBeyond, steps < 0);
        const auto size = negative ? 0 - static_cast<std::uint64_t>(steps) : static_cast<std::uint64_t>(steps);
        const std::uint64_t coded = context.distances[negative ? 1 : 0].code(coder, size - 1) + 1;
        return static_cast<std::int64_t>(negative ? 0 - coded : coded);
    }

    template <class Coder> T codeInteger(Coder& coder, double expected, T value)
    {
        constexpr auto least = static_cast<double>(std::numeric_limits<T>::min()),
                       most = static_cast<double>(std::numeric_limits<T>::max());
        const double bounded = expected >= least && expected <= most ? expected : expected > most ? most : least;
        const double nearest = std::floor(bounded + 0.5);
        const double off = bounded - nearest;
        // A value on the side to which the expectation leans is nearer: there steps are positive.
        const bool leansDown = off < 0;
        const auto nearestInteger = static_cast<std::int64_t>(nearest);
        const auto size = static_cast<std::size_t>(std::bit_width(static_cast<std::uint64_t>(spread_) >> 8));
        const std::size_t leaning =
            size < leaningSizes ? std::min<std::size_t>(static_cast<std::size_t>(std::abs(off) * 16), 7) : 0;
        Context& context = contexts_[size < leaningSizes ? size * 8 + leaning : leaningSizes * 7 + size];
        const std::int64_t away = static_cast<std::int64_t>(value) - nearestInteger;
        // Damaged bytes may give any number, the one without an absolute value, too.
        const std::int64_t steps = codeSteps(coder, context, leansDown ? -away : away);
        const auto upwards = static_cast<std::uint64_t>(steps);
        const std::uint64_t distance = std::min(steps < 0 ? 0 - upwards : upwards, std::uint64_t(1) << 33);
        spread_ += (static_cast<std::int64_t>(distance) * 256 - spread_) / 16;
        return static_cast<T>(static_cast<std::uint64_t>(nearestInteger) + (leansDown ? 0 - upwards : upwards));
    }

    /// A double's exponent as its bits have it.
    static int exponentOf(double value) { return static_cast<int>(std::bit_cast<std::uint64_t>(value) >> 52 & 0x7ff); }

    template <class Coder> T codeFloat(Coder& coder, double expected, T value)
    {
        const T rounded = static_cast<T>(expected);
        const int digits = (expectedExponent_ >> 4) - exponentOf(static_cast<double>(rounded));
        Context& context = contexts_[static_cast<std::size_t>(std::clamp(digits + 32, 0, 47))];
        using Steps = std::conditional_t<sizeof(T) == 8, std::int64_t, std::int32_t>;
        const auto away = static_cast<Steps>(orderOf(value) - orderOf(rounded));
        const std::int64_t steps = codeSteps(coder, context, away);
        const T result = numberOfOrder<T>(orderOf(rounded) + static_cast<std::uint64_t>(steps));
        if (steps != 0) {
            const int exponent = exponentOf(static_cast<double>(result) - static_cast<double>(rounded));
            expectedExponent_ += (exponent * 16 - expectedExponent_) / 8;
        }
        return result;
    }

    std::vector<Context> contexts_ = std::vector<Context>(72);
    std::int64_t spread_ = 256;        ///< of integers: steps on average, in 256ths
    int expectedExponent_ = 1023 * 16; ///< of floats: of the difference, in 16ths
};

/// Codes samples of points, whatever their type is, against what is expected of them.
class SampleCoder {
public:
    explicit SampleCoder(SampleType type) : type_(type)
    {
        visitSampleType(type, [this]<class T>() { coder_.emplace<ValueCoder<T>>(); });
    }

    /// `samples`: of the points' lattice or box. An encoder takes them from there, a decoder puts them there.
    template <class Coder>
    void code(Coder& coder, std::byte* samples, std::span<const std::uint32_t> points, const double* expected)
    {
        visitSampleType(type_, [&]<class T>() {
            auto& values = std::get<ValueCoder<T>>(coder_);
            T* const of = reinterpret_cast<T*>(samples);
            for (std::size_t i = 0; i < points.size(); ++i)
                of[points[i]] = values.code(coder, expected[i], of[points[i]]);
        });
    }

private:
    SampleType type_;
    std::variant<ValueCoder<std::uint8_t>, ValueCoder<std::int8_t>, ValueCoder<std::uint16_t>, ValueCoder<std::int16_t>,
                 ValueCoder<std::uint32_t>, ValueCoder<std::int32_t>, ValueCoder<float>, ValueCoder<double>>
        coder_;
};

} // namespace tetra
