// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/transfer/default_transfer_functions.h"

#include <cmath>
#include <span>

namespace tetra {
namespace {

/// Over values in [0, 1]; spreads them over the range.
TransferFunction spread(std::span<const TransferPoint> points, double smallest, double largest, double unitDistance)
{
    TransferFunction function;
    function.unitDistance = unitDistance;
    if (!(smallest < largest) || !std::isfinite(smallest) || !std::isfinite(largest)) {
        TransferPoint middle = points[points.size() / 2];
        middle.value = std::isfinite(smallest) ? smallest : 0;
        function.points.push_back(middle);
        return function;
    }
    for (TransferPoint point : points) {
        point.value = std::lerp(smallest, largest, point.value);
        function.points.push_back(point);
    }
    return function;
}

} // namespace

TransferFunction sequentialTransferFunction(double smallest, double largest, double unitDistance)
{
    constexpr TransferPoint viridis[] = {
        {0, {0.267f, 0.005f, 0.329f}, 0},        {0.125, {0.278f, 0.176f, 0.482f}, 0.01f},
        {0.25, {0.231f, 0.322f, 0.545f}, 0.03f}, {0.375, {0.173f, 0.447f, 0.557f}, 0.06f},
        {0.5, {0.129f, 0.569f, 0.549f}, 0.1f},   {0.625, {0.157f, 0.682f, 0.502f}, 0.18f},
        {0.75, {0.361f, 0.784f, 0.388f}, 0.3f},  {0.875, {0.675f, 0.863f, 0.196f}, 0.5f},
        {1, {0.992f, 0.906f, 0.145f}, 0.8f},
    };
    return spread(viridis, smallest, largest, unitDistance);
}

TransferFunction divergingTransferFunction(double smallest, double largest, double unitDistance)
{
    constexpr TransferPoint blueToOrange[] = {
        {0, {0.000f, 0.447f, 0.698f}, 0.6f},     {0.25, {0.400f, 0.680f, 0.850f}, 0.15f},
        {0.45, {0.950f, 0.950f, 0.930f}, 0.01f}, {0.5, {0.960f, 0.950f, 0.920f}, 0},
        {0.55, {0.970f, 0.940f, 0.900f}, 0.01f}, {0.75, {0.930f, 0.630f, 0.380f}, 0.15f},
        {1, {0.835f, 0.369f, 0.000f}, 0.6f},
    };
    return spread(blueToOrange, smallest, largest, unitDistance);
}

} // namespace tetra
