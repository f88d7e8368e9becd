// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/hint_grid.h"

namespace tetra {

HintGrid::HintGrid(const BlockDivision& division, std::uint32_t edge) : dividesBlocks_(division.count() > 1)
{
    std::uint32_t stride = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        Axis& along = axes_[axis];
        along.stride = stride;
        const std::uint32_t points = division.size()[axis];
        std::uint32_t first = 0;
        for (std::uint32_t point = 0; point < points; ++point) {
            const bool last = point == points - 1;
            const bool border = division.isBorder(axis, point);
            const std::uint32_t cellBefore =
                along.blocks.empty() ? 0 : static_cast<std::uint32_t>(along.blocks.size() - 1);
            if (border && point > 0)
                for (std::size_t cell = along.blocks.size(); cell-- > 0 && along.blocks[cell].last < 0;)
                    along.blocks[cell].last = static_cast<std::int32_t>(point);
            if (border)
                first = last ? first : point;
            if (!last && (point - first) % edge == 0)
                along.blocks.push_back({static_cast<std::int32_t>(first), -1});
            along.cells.push_back(static_cast<std::uint32_t>(along.blocks.size() - 1) * stride);
            along.cellsBelow.push_back(border && !last ? cellBefore * stride : along.cells.back());
        }
        stride *= static_cast<std::uint32_t>(along.blocks.size());
    }
    hints_.assign(stride, none);
}

std::uint32_t HintGrid::cellsOf(const std::array<std::uint32_t, 3>& point,
                                std::array<std::uint32_t, 8>& cells) const noexcept
{
    cells[0] = 0;
    std::uint32_t count = 1;
    for (std::size_t axis = 3; axis-- > 0;) {
        const std::uint32_t above = axes_[axis].cells[point[axis]];
        const std::uint32_t below = axes_[axis].cellsBelow[point[axis]];
        const std::uint32_t before = count;
        if (above != below) {
            // Before each other cell the one of the block below, so that they rise.
            for (std::uint32_t i = before; i-- > 0;) {
                cells[2 * i + 1] = cells[i] + above;
                cells[2 * i] = cells[i] + below;
            }
            count *= 2;
        } else {
            for (std::uint32_t i = 0; i < before; ++i)
                cells[i] += above;
        }
    }
    return count;
}

std::array<HintGrid::Bounds, 3> HintGrid::blockOf(std::uint32_t cell) const noexcept
{
    std::array<Bounds, 3> bounds;
    for (std::size_t axis = 3; axis-- > 0;) {
        bounds[axis] = axes_[axis].blocks[cell / axes_[axis].stride];
        cell %= axes_[axis].stride;
    }
    return bounds;
}

void HintGrid::spread()
{
    const auto copyWithin = [this](std::size_t axis, std::uint32_t from, std::uint32_t to) {
        const Axis& along = axes_[axis];
        const auto count = static_cast<std::uint32_t>(along.blocks.size());
        if (hints_[to] == none &&
            along.blocks[from / along.stride % count].first == along.blocks[to / along.stride % count].first)
            hints_[to] = hints_[from];
    };
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::uint32_t stride = axes_[axis].stride;
        const auto count = static_cast<std::uint32_t>(axes_[axis].blocks.size());
        for (std::uint32_t cell = 0; cell < cellCount(); ++cell)
            if (cell / stride % count > 0)
                copyWithin(axis, cell - stride, cell);
        for (std::uint32_t cell = cellCount(); cell-- > 0;)
            if (cell / stride % count + 1 < count)
                copyWithin(axis, cell + stride, cell);
    }
}

} // namespace tetra
