// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/exact_orientation.h"

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

using Point = std::array<double, 3>;

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
    void addProduct(double x, double y, double z)
    {
        const double high = x * y;
        const double low = std::fma(x, y, -high);
        for (const double factor : {low, high}) {
            const double product = factor * z;
            add(std::fma(factor, z, -product));
            add(product);
        }
    }
    /// Adds or subtracts det(u, v, w).
    void addDeterminant(const Point& u, const Point& v, const Point& w, double sign)
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
struct Parts {
    std::int64_t mantissa;
    int exponent;
};

Parts partsOf(double number)
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
std::optional<int> integerSign(const Point& a, const Point& b, const Point& c, const Point& d)
{
    constexpr int mostBits = 41;
    std::array<std::array<Parts, 3>, 3> parts{};
    int lowest = std::numeric_limits<int>::max(), highest = std::numeric_limits<int>::min();
    const std::array<const Point*, 3> others = {&b, &c, &d};
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t k = 0; k < 3; ++k) {
            const double to = (*others[row])[k], from = a[k];
            const double difference = to - from;
            const double kept = to - difference;
            if (to - (difference + kept) + (kept - from) != 0)
                return std::nullopt;
            const Parts part = parts[row][k] = partsOf(difference);
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
            if (const Parts part = parts[row][k]; part.mantissa != 0)
                m[row][k] = static_cast<__int128>(part.mantissa) * (std::int64_t(1) << (part.exponent - lowest));
    const __int128 determinant = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) +
                                 m[0][1] * (m[1][2] * m[2][0] - m[1][0] * m[2][2]) +
                                 m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    return determinant > 0 ? 1 : determinant < 0 ? -1 : 0;
}

int exactSign(const Point& a, const Point& b, const Point& c, const Point& d)
{
    ExactSum sum;
    sum.addDeterminant(b, c, d, 1);
    sum.addDeterminant(a, c, d, -1);
    sum.addDeterminant(a, b, d, 1);
    sum.addDeterminant(a, b, c, -1);
    return sum.sign();
}

} // namespace

int orientationSign(const Point& a, const Point& b, const Point& c, const Point& d)
{
    const Point u{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    const Point v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    const Point w{d[0] - a[0], d[1] - a[1], d[2] - a[2]};
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
    if (a == b || a == c || a == d || b == c || b == d || c == d)
        return 0;
    if (const auto sign = integerSign(a, b, c, d))
        return *sign;
    return exactSign(a, b, c, d);
}

} // namespace tetra
