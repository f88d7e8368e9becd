// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/orientation.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <optional>

namespace tetra {

namespace {

using SpacePoint = std::array<double, 3>;

/// A sum of doubles without rounding: its terms do not overlap and grow in size, so that the last has the sum's sign.
class ExactSum {
public:
    void add(double term)
    {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            const double sum = term + terms_[i];
            const double part = sum - term;
            const double lost = (term - (sum - part)) + (terms_[i] - part);
            if (lost != 0)
                terms_[kept++] = lost;
            term = sum;
        }
        if (term != 0)
            terms_[kept++] = term;
        count_ = kept;
    }
    void addProduct(double x, double y)
    {
        const double product = x * y;
        add(std::fma(x, y, -product));
        add(product);
    }
    void addProduct(double x, double y, double z)
    {
        const double high = x * y;
        const double low = std::fma(x, y, -high);
        addProduct(low, z);
        addProduct(high, z);
    }
    /// Adds or subtracts det(u, v, w).
    void addDeterminant(const SpacePoint& u, const SpacePoint& v, const SpacePoint& w, double sign)
    {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t next = (k + 1) % 3, last = (k + 2) % 3;
            addProduct(sign * u[k], v[next], w[last]);
            addProduct(-sign * u[k], v[last], w[next]);
        }
    }
    int sign() const { return count_ == 0 ? 0 : terms_[count_ - 1] > 0 ? 1 : -1; }

private:
    /// 24 products of four terms each.
    std::array<double, 96> terms_{};
    std::size_t count_ = 0;
};

/// A double as mantissa * 2^exponent, the mantissa odd or 0.
struct NumberParts {
    std::int64_t mantissa;
    int exponent;
};

NumberParts splitNumber(double number)
{
    constexpr int mantissaBits = 52, bias = 1075;
    const auto bits = std::bit_cast<std::uint64_t>(number);
    const int stored = static_cast<int>(bits >> mantissaBits & 0x7ff);
    auto mantissa = static_cast<std::int64_t>(bits & ((std::uint64_t(1) << mantissaBits) - 1));
    if (stored != 0)
        mantissa |= std::int64_t(1) << mantissaBits;
    if (mantissa == 0)
        return {0, 0};
    const int zeros = std::countr_zero(static_cast<std::uint64_t>(mantissa));
    return {(number < 0 ? -mantissa : mantissa) >> zeros, std::max(stored, 1) - bias + zeros};
}

/// The sign of det(b - a, c - a, d - a) by integers of 128 bits, where the differences are whole multiples below 2^41
/// of one power of two, as those of floats and of points in a plane along the axes mostly are.
std::optional<int> integerSign(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c, const SpacePoint& d)
{
    constexpr int mostBits = 41;
    std::array<std::array<NumberParts, 3>, 3> parts{};
    int lowest = std::numeric_limits<int>::max(), highest = std::numeric_limits<int>::min();
    const std::array<const SpacePoint*, 3> others = {&b, &c, &d};
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t k = 0; k < 3; ++k) {
            const double to = (*others[row])[k], from = a[k];
            const double difference = to - from;
            const double kept = to - difference;
            if (to - (difference + kept) + (kept - from) != 0)
                return std::nullopt;
            const NumberParts part = parts[row][k] = splitNumber(difference);
            if (part.mantissa == 0)
                continue;
            lowest = std::min(lowest, part.exponent);
            const auto size = static_cast<std::uint64_t>(std::abs(part.mantissa));
            highest = std::max(highest, part.exponent + static_cast<int>(std::bit_width(size)));
        }
    if (highest > lowest && highest - lowest > mostBits)
        return std::nullopt;
    std::array<std::array<__int128, 3>, 3> m{};
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t k = 0; k < 3; ++k)
            if (const NumberParts part = parts[row][k]; part.mantissa != 0)
                m[row][k] = static_cast<__int128>(part.mantissa) * (std::int64_t(1) << (part.exponent - lowest));
    const __int128 determinant = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) +
                                 m[0][1] * (m[1][2] * m[2][0] - m[1][0] * m[2][2]) +
                                 m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    return determinant > 0 ? 1 : determinant < 0 ? -1 : 0;
}

int exactSign(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c, const SpacePoint& d)
{
    ExactSum sum;
    sum.addDeterminant(b, c, d, 1);
    sum.addDeterminant(a, c, d, -1);
    sum.addDeterminant(a, b, d, 1);
    sum.addDeterminant(a, b, c, -1);
    return sum.sign();
}

/// What is left of a difference when it is rounded.
double lostOf(double minuend, double subtrahend, double difference)
{
    const double part = minuend - difference;
    return (minuend - (difference + part)) + (part - subtrahend);
}

bool areExactOffsets(const SpacePoint& from, const SpacePoint& to, const SpacePoint& offset)
{
    for (std::size_t k = 0; k < 3; ++k) {
        if (lostOf(to[k], from[k], offset[k]) != 0)
            return false;
    }
    return true;
}

SpacePoint offsetOf(const SpacePoint& from, const SpacePoint& to)
{
    return {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
}

/// The sign of det(u, v, w) if rounding cannot have changed it; 0 only of what has a zero in every product. The vectors
/// may be rounded differences.
std::optional<int> roundedSign(const SpacePoint& u, const SpacePoint& v, const SpacePoint& w)
{
    double determinant = 0;
    double magnitude = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3, last = (k + 2) % 3;
        const double plus = v[next] * w[last], minus = v[last] * w[next];
        determinant += u[k] * (plus - minus);
        magnitude += std::abs(u[k]) * (std::abs(plus) + std::abs(minus));
    }
    // Shewchuk's bound is 7.8e-16 times the magnitude.
    if (std::abs(determinant) > 1e-15 * magnitude)
        return determinant > 0 ? 1 : -1;
    if (magnitude == 0)
        return 0; // a difference is zero only of equal numbers: the four lie in a plane across an axis
    return std::nullopt;
}

/// The cross product, if nothing is rounded in it.
std::optional<SpacePoint> exactNormal(const SpacePoint& u, const SpacePoint& v)
{
    SpacePoint normal{};
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3, last = (k + 2) % 3;
        const double plus = u[next] * v[last], minus = u[last] * v[next];
        normal[k] = plus - minus;
        if (std::fma(u[next], v[last], -plus) != 0 || std::fma(u[last], v[next], -minus) != 0 ||
            lostOf(plus, minus, normal[k]) != 0)
            return std::nullopt;
    }
    return normal;
}

/// The sign of normal . (to - from).
int heightSign(const SpacePoint& normal, const SpacePoint& from, const SpacePoint& to)
{
    ExactSum sum;
    for (std::size_t k = 0; k < 3; ++k) {
        const double offset = to[k] - from[k];
        sum.addProduct(normal[k], offset);
        if (const double lost = lostOf(to[k], from[k], offset); lost != 0)
            sum.addProduct(normal[k], lost);
    }
    return sum.sign();
}

} // namespace

int orientationSign(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c, const SpacePoint& d)
{
    const SpacePoint u = offsetOf(a, b), v = offsetOf(a, c), w = offsetOf(a, d);
    if (const auto sign = roundedSign(u, v, w))
        return *sign;
    if (a == b || a == c || a == d || b == c || b == d || c == d)
        return 0;
    if (const auto sign = integerSign(a, b, c, d))
        return *sign;
    // Coordinates of single precision mostly have exact differences, and few enough bits for the normal.
    if (areExactOffsets(a, b, u) && areExactOffsets(a, c, v)) {
        if (const auto normal = exactNormal(u, v))
            return heightSign(*normal, a, d);
        if (areExactOffsets(a, d, w)) {
            ExactSum sum;
            sum.addDeterminant(u, v, w, 1);
            return sum.sign();
        }
    }
    return exactSign(a, b, c, d);
}

int directionSign(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c, const SpacePoint& direction)
{
    const SpacePoint u = offsetOf(a, b), v = offsetOf(a, c);
    if (const auto sign = roundedSign(u, v, direction))
        return *sign;
    ExactSum sum;
    if (areExactOffsets(a, b, u) && areExactOffsets(a, c, v)) {
        if (const auto normal = exactNormal(u, v))
            return heightSign(*normal, {0, 0, 0}, direction);
        sum.addDeterminant(u, v, direction, 1);
    } else {
        sum.addDeterminant(b, c, direction, 1);
        sum.addDeterminant(b, a, direction, -1);
        sum.addDeterminant(a, c, direction, -1);
    }
    return sum.sign();
}

} // namespace tetra
