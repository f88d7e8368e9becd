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
