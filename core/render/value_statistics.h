// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/tetrahedral_mesh.h"
#include "core/transfer/value_histogram.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace tetra {

/// How much lies in each of some equal parts of a range, of intervals of constant density. O(1) for each interval:
/// whole parts are counted by where the density begins and ends, the two at the ends directly.
class IntervalSums {
public:
    explicit IntervalSums(std::size_t parts) : amounts_(parts), steps_(parts + 1) {}

    /// `amount`, spread over [begin, end] in parts from 0; what lies outside is left out.
    void add(double begin, double end, double amount)
    {
        const auto count = static_cast<double>(amounts_.size());
        if (!(end >= 0 && begin <= count))
            return;
        if (end - begin < leastExtent) {
            amounts_[partOf(begin)] += amount;
            return;
        }
        const double density = amount / (end - begin);
        begin = std::max(begin, 0.0);
        end = std::min(end, count);
        const std::size_t first = partOf(begin), last = partOf(end);
        if (first == last) {
            amounts_[first] += density * (end - begin);
            return;
        }
        amounts_[first] += density * (static_cast<double>(first + 1) - begin);
        amounts_[last] += density * (end - static_cast<double>(last));
        steps_[first + 1] += density;
        steps_[last] -= density;
    }

    std::vector<double> amounts() const
    {
        std::vector<double> result = amounts_;
        double density = 0;
        for (std::size_t part = 0; part < result.size(); ++part)
            result[part] = std::max(0.0, result[part] + (density += steps_[part]));
        return result;
    }

private:
    static constexpr double leastExtent = 1e-6;

    std::size_t partOf(double place) const
    {
        return std::min(static_cast<std::size_t>(std::max(place, 0.0)), amounts_.size() - 1);
    }

    std::vector<double> amounts_;
    std::vector<double> steps_;
};

/// A value within [least, largest] whose isosurface shows where the data have a surface: as the skin of a head or the
/// walls of a casting, rather than noise or scraps. Of all isosurfaces it is the one for which a product of two
/// functions of the contour spectrum is largest: the total gradient on it, which grows with its size, and a power
/// of the mean gradient, which tells a boundary between two materials from noise within one. (C. Bajaj, V. Pascucci, D.
/// Schikore: The contour spectrum, IEEE Visualization 1997.) Nothing where no value differs. The same for the same mesh
/// on every machine and any number of threads, but for rounding. O(cells).
std::optional<double> surfaceValue(const TetrahedralMesh& mesh, double least, double largest);

/// How the values of a mesh share its volume, which does not depend on where its cells are small: the counts are parts
/// of 2^32 of the volume. In a cell all values between its smallest and its largest count alike. Cells that are not
/// finite and values outside of [least, largest] are not counted. No counts if the range is empty or not finite, or
/// there is no volume. O(cells + parts).
ValueHistogram volumeHistogram(const TetrahedralMesh& mesh, double least, double largest, int parts);

} // namespace tetra
