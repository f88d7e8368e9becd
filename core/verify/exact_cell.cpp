// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verify/exact_cell.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace tetra {

namespace {

/// A whole number of any length.
class BigInteger {
public:
    BigInteger() = default;
    /// `mantissa` * 2^shift.
    BigInteger(std::int64_t mantissa, int shift) : negative_(mantissa < 0)
    {
        auto magnitude = static_cast<std::uint64_t>(negative_ ? -mantissa : mantissa);
        digits_.assign(static_cast<std::size_t>(shift / digitBits), 0);
        const auto within = static_cast<unsigned>(shift % digitBits);
        const unsigned __int128 shifted = static_cast<unsigned __int128>(magnitude) << within;
        for (int digit = 0; digit < 3; ++digit)
            digits_.push_back(static_cast<std::uint32_t>(shifted >> (digitBits * digit)));
        trim();
    }

    int sign() const { return digits_.empty() ? 0 : negative_ ? -1 : 1; }

    friend BigInteger operator-(const BigInteger& a, const BigInteger& b)
    {
        BigInteger minusB = b;
        minusB.negative_ = !b.negative_;
        return a + minusB;
    }
    friend BigInteger operator+(const BigInteger& a, const BigInteger& b)
    {
        if (a.negative_ == b.negative_)
            return BigInteger(sum(a.digits_, b.digits_), a.negative_);
        if (less(a.digits_, b.digits_))
            return BigInteger(difference(b.digits_, a.digits_), b.negative_);
        return BigInteger(difference(a.digits_, b.digits_), a.negative_);
    }
    friend BigInteger operator*(const BigInteger& a, const BigInteger& b)
    {
        std::vector<std::uint32_t> product(a.digits_.size() + b.digits_.size(), 0);
        for (std::size_t i = 0; i < a.digits_.size(); ++i) {
            std::uint64_t carry = 0;
            for (std::size_t j = 0; j < b.digits_.size(); ++j) {
                carry += product[i + j] + std::uint64_t(a.digits_[i]) * b.digits_[j];
                product[i + j] = static_cast<std::uint32_t>(carry);
                carry >>= digitBits;
            }
            product[i + b.digits_.size()] = static_cast<std::uint32_t>(carry);
        }
        return BigInteger(std::move(product), a.negative_ != b.negative_);
    }

private:
    static constexpr int digitBits = 32;
    using Digits = std::vector<std::uint32_t>; ///< the lowest first, the highest not zero

    BigInteger(Digits digits, bool negative) : digits_(std::move(digits)), negative_(negative) { trim(); }
    void trim()
    {
        while (!digits_.empty() && digits_.back() == 0)
            digits_.pop_back();
    }
    static bool less(const Digits& a, const Digits& b)
    {
        if (a.size() != b.size())
            return a.size() < b.size();
        return std::lexicographical_compare(a.rbegin(), a.rend(), b.rbegin(), b.rend());
    }
    static Digits sum(const Digits& a, const Digits& b)
    {
        Digits digits;
        std::uint64_t carry = 0;
        for (std::size_t i = 0; i < std::max(a.size(), b.size()) || carry != 0; ++i) {
            carry += (i < a.size() ? a[i] : 0ull) + (i < b.size() ? b[i] : 0ull);
            digits.push_back(static_cast<std::uint32_t>(carry));
            carry >>= digitBits;
        }
        return digits;
    }
    /// a - b; a is not less.
    static Digits difference(const Digits& a, const Digits& b)
    {
        Digits digits;
        std::int64_t borrow = 0;
        for (std::size_t i = 0; i < a.size(); ++i) {
            const std::int64_t digit = std::int64_t(a[i]) - (i < b.size() ? std::int64_t(b[i]) : 0) - borrow;
            borrow = digit < 0 ? 1 : 0;
            digits.push_back(static_cast<std::uint32_t>(digit));
        }
        return digits;
    }

    Digits digits_;
    bool negative_ = false;
};

using VolumeCorners = std::array<Eigen::Vector3d, 4>;

/// The coordinates as whole numbers of the smallest unit that any of them needs.
std::array<std::array<BigInteger, 3>, 4> inWholeUnits(const VolumeCorners& corners)
{
    constexpr int mantissaBits = std::numeric_limits<double>::digits;
    int smallest = std::numeric_limits<int>::max();
    for (const Eigen::Vector3d& corner : corners)
        for (const double coordinate : corner)
            if (int exponent = 0; coordinate != 0) {
                std::frexp(coordinate, &exponent);
                smallest = std::min(smallest, exponent - mantissaBits);
            }
    std::array<std::array<BigInteger, 3>, 4> whole;
    for (std::size_t corner = 0; corner < 4; ++corner)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double coordinate = corners[corner][static_cast<Eigen::Index>(axis)];
            if (coordinate == 0)
                continue;
            int exponent = 0;
            const double fraction = std::frexp(coordinate, &exponent);
            whole[corner][axis] = BigInteger(static_cast<std::int64_t>(std::ldexp(fraction, mantissaBits)),
                                             exponent - mantissaBits - smallest);
        }
    return whole;
}

int exactSign(const VolumeCorners& corners)
{
    const auto p = inWholeUnits(corners);
    std::array<std::array<BigInteger, 3>, 3> edge;
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t axis = 0; axis < 3; ++axis)
            edge[row][axis] = p[row + 1][axis] - p[0][axis];
    const auto minor = [&](std::size_t x, std::size_t y) { return edge[1][x] * edge[2][y] - edge[1][y] * edge[2][x]; };
    return (edge[0][0] * minor(1, 2) - edge[0][1] * minor(0, 2) + edge[0][2] * minor(0, 1)).sign();
}

/// Whether two of the points are one, or all lie in one plane along the axes: what is flat is mostly so.
bool isPlainlyFlat(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                   const Eigen::Vector3d& d)
{
    for (int axis = 0; axis < 3; ++axis)
        if (a[axis] == b[axis] && a[axis] == c[axis] && a[axis] == d[axis])
            return true;
    return a == b || a == c || a == d || b == c || b == d || c == d;
}

/// In 128 bits, where all differences are exact and whole numbers of less than 40 bits in a common unit, as they are of
/// points that are near each other and were floats.
std::optional<int> signInWholeNumbers(const VolumeCorners& corners)
{
    constexpr int mostBits = 40;
    constexpr int mantissaBits = std::numeric_limits<double>::digits;
    std::array<double, 9> edges{};
    int largest = std::numeric_limits<int>::min();
    int smallest = std::numeric_limits<int>::max();
    for (std::size_t row = 0; row < 3; ++row)
        for (int axis = 0; axis < 3; ++axis) {
            const double from = corners[0][axis], to = corners[row + 1][axis];
            const double edge = to - from;
            const double back = to - edge;
            if ((to - (edge + back)) + (back - from) != 0 || !std::isfinite(edge))
                return {};
            edges[3 * row + static_cast<std::size_t>(axis)] = edge;
            if (edge == 0)
                continue;
            int exponent = 0;
            const auto mantissa =
                static_cast<std::int64_t>(std::ldexp(std::frexp(std::abs(edge), &exponent), mantissaBits));
            largest = std::max(largest, exponent);
            smallest = std::min(smallest, exponent - mantissaBits + std::countr_zero(std::uint64_t(mantissa)));
        }
    if (largest == std::numeric_limits<int>::min())
        return 0;
    if (largest - smallest > mostBits)
        return {};
    std::array<__int128, 9> e{};
    std::ranges::transform(edges, e.begin(),
                           [&](double edge) { return static_cast<std::int64_t>(std::ldexp(edge, -smallest)); });
    const __int128 volume =
        e[0] * (e[4] * e[8] - e[5] * e[7]) - e[1] * (e[3] * e[8] - e[5] * e[6]) + e[2] * (e[3] * e[7] - e[4] * e[6]);
    return volume > 0 ? 1 : volume < 0 ? -1 : 0;
}

} // namespace

int volumeSign(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& d)
{
    const Eigen::Vector3d u = b - a;
    const Eigen::Vector3d v = c - a;
    const Eigen::Vector3d w = d - a;
    if (isPlainlyFlat(a, b, c, d))
        return 0;
    const double volume = u.dot(v.cross(w));
    // Each of the six products is wrong by less than 8 units of rounding of its size.
    const Eigen::Vector3d x = v.cwiseAbs();
    const Eigen::Vector3d y = w.cwiseAbs();
    const double size = u.cwiseAbs().dot(
        Eigen::Vector3d(x[1] * y[2] + x[2] * y[1], x[2] * y[0] + x[0] * y[2], x[0] * y[1] + x[1] * y[0]));
    const double doubt = 0x1p-48 * size;
    // Far from underflow, where the bound would not hold.
    if (doubt > 1e-290 && std::isfinite(size) && std::abs(volume) > doubt)
        return volume > 0 ? 1 : -1;
    const std::optional<int> sign = signInWholeNumbers({a, b, c, d});
    return sign ? *sign : exactSign({a, b, c, d});
}

} // namespace tetra
