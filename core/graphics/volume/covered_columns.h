// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/simd.h"
#include "core/graphics/volume/cell_setup.h"

#include <algorithm>

namespace tetra {

/// The columns of blocks that a wide cell covers in each row of them. A sample is covered if all bounds of fronts lie
/// above all bounds of backs there; each such pair is a half-plane, and there are four at most.
class CoveredColumns {
public:
    CoveredColumns() = default;
    TETRA_SIMD_INLINE explicit CoveredColumns(const CellSetup& cell)
    {
        const bool oneFront = cell.functions[1].c == farBound;
        const bool oneBack = cell.functions[4].c == -farBound;
        for (int i = 0; i < 4; ++i) {
            const AffineFunction& front = cell.functions[oneFront ? 0 : oneBack ? i % 3 : i / 2];
            const AffineFunction& back = cell.functions[3 + (oneFront ? i % 3 : oneBack ? 0 : i % 2)];
            perX_[i] = front.a - back.a;
            perY_[i] = front.b - back.b;
            atOrigin_[i] = front.c - back.c;
        }
        const Int4 rising = perX_ > 0.0f;
        const Int4 falling = perX_ < 0.0f;
        // Where a half-plane has no end on a side, this puts it far away.
        const Float4 reciprocal = -1.0f / (rising | falling ? perX_ : Float4{} + 1.0f);
        toLeft_ = rising ? reciprocal : Float4{};
        toRight_ = falling ? reciprocal : Float4{};
        leftEnd_ = rising ? Float4{} - margin : Float4{} - farAway;
        rightEnd_ = falling ? Float4{} + margin : Float4{} + farAway;
    }

    /// Narrows [left, right) for a row of blocks.
    TETRA_SIMD_INLINE void narrow(int row, int& left, int& right) const
    {
        const Float4 top = atOrigin_ + perY_ * static_cast<float>(row * blockHeight);
        const Float4 bottom = top + perY_ * (blockHeight - 1);
        const Float4 highest = top > bottom ? top : bottom;
        const Float4 from = highest * toLeft_ + leftEnd_;
        const Float4 to = highest * toRight_ + rightEnd_;
        const float first = std::max(std::max(from[0], from[1]), std::max(from[2], from[3]));
        const float last = std::min(std::min(to[0], to[1]), std::min(to[2], to[3]));
        left = std::max(left, static_cast<int>(std::clamp(first, 0.0f, farAway)) / blockWidth);
        right = std::min(right, (static_cast<int>(std::clamp(last, -1.0f, farAway) + 1) + blockWidth - 1) / blockWidth);
    }

private:
    static constexpr float margin = 0.05f;
    static constexpr float farAway = 1e6f;
    Float4 perX_, perY_, atOrigin_;
    Float4 toLeft_, toRight_, leftEnd_, rightEnd_;
};

} // namespace tetra
