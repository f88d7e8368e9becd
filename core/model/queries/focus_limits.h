// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/data/lattice.h"
#include "core/mesh/sample_scan.h"
#include "core/model/queries/error_field.h"

#include <array>
#include <cstdint>
#include <vector>

namespace tetra {

/// A ramp in space at the points of a lattice, in units of the values: exactly what ErrorField::at() says there.
class FocusLimits final : public ErrorLimits {
public:
    FocusLimits(const SpaceRamp& ramp, const Lattice& lattice, double valueExtent);

    double at(const std::array<std::uint32_t, 3>& point) const override
    {
        if (!quick_)
            return fieldAt(point);
        return inside_[0][point[0]] && inside_[1][point[1]] && inside_[2][point[2]] ? least : most;
    }
    /// Whether a site should be a vertex before anything is looked at: the mesh before it was not good enough here or,
    /// of a box, one step away. Without what lies next to a border more would have to be repaired, which takes longer.
    bool askFor(const std::array<std::uint32_t, 3>& point, double runningError) const
    {
        if (!quick_) {
            const double limit = fieldAt(point);
            return limit < most && runningError > limit;
        }
        bool near = true;
        for (std::size_t axis = 0; axis < 3; ++axis)
            near &= static_cast<std::int32_t>(point[axis]) >= firstAsked[axis] &&
                    static_cast<std::int32_t>(point[axis]) <= lastAsked[axis];
        return near && runningError > least;
    }
    /// All such sites lie between these two.
    std::array<std::int32_t, 3> firstAsked{0, 0, 0};
    std::array<std::int32_t, 3> lastAsked{-1, -1, -1};
    /// Whether a limit below the largest can hold in a cube of points: false only if not.
    bool mayHoldIn(const std::array<std::uint32_t, 3>& first, std::uint32_t edge) const;
    /// Whether the limits are the least in a box of points and the largest in all others.
    bool isBox() const noexcept { return quick_; }

private:
    double fieldAt(const std::array<std::uint32_t, 3>& point) const;
    void findRange();

    ErrorField field_;
    Lattice lattice_;
    double extent_ = 0;
    bool quick_ = false;
    std::array<std::vector<char>, 3> inside_; ///< along each axis, if quick
};

} // namespace tetra
