// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/exact_orientation.h"

#include <cmath>
#include <cstddef>

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

int exactSign(const Point& a, const Point& b, const Point& c, const Point& d)
{
    ExactSum sum;
    sum.addDeterminant(b, c, d, 1);
    sum.addDeterminant(a, c, d, -1);
    sum.addDeterminant(a, b, d, 1);
    sum.addDeterminant(a, b, c, -1);
    return sum.sign();
}

/// Whether the subtraction rounded nothing.
bool isExactDifference(double minuend, double subtrahend, double difference)
{
    const double part = minuend - difference;
    return (minuend - (difference + part)) + (part - subtrahend) == 0;
}

bool areExactOffsets(const Point& from, const Point& to, const Point& offset)
{
    for (std::size_t k = 0; k < 3; ++k) {
        if (!isExactDifference(to[k], from[k], offset[k]))
            return false;
    }
    return true;
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
    if (magnitude == 0)
        return 0; // a difference is zero only of equal numbers: the four lie in a plane across an axis
    // Coordinates of single precision mostly have exact differences: a quarter of the products.
    if (areExactOffsets(a, b, u) && areExactOffsets(a, c, v) && areExactOffsets(a, d, w)) {
        ExactSum sum;
        sum.addDeterminant(u, v, w, 1);
        return sum.sign();
    }
    return exactSign(a, b, c, d);
}

} // namespace tetra
