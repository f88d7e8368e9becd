// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/build.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace tetra {

/// The whole history in memory.
struct RecordedHistory : HistorySink {
    struct Tetrahedron {
        std::array<std::uint32_t, 4> sites;
        float error;
        std::uint32_t destroyer = 0xffffffff;
        float warping = 0;
    };
    HistoryTraits traits;
    std::vector<std::uint64_t> points;
    std::vector<float> runningKeys;
    std::vector<Tetrahedron> tetrahedra;
    float finalKey = -1;
    std::size_t failAfter = std::numeric_limits<std::size_t>::max();

    Status begin(const HistoryTraits& given) override
    {
        traits = given;
        return {};
    }
    Status add(const HistoryStep& step) override
    {
        if (points.size() == failAfter)
            return Error{ErrorKind::CannotWrite, "the disk is full"};
        const std::uint32_t site = static_cast<std::uint32_t>(points.size());
        points.push_back(step.point);
        runningKeys.push_back(runningKeys.empty() ? step.keyBefore : std::min(runningKeys.back(), step.keyBefore));
        for (const std::uint32_t destroyed : step.destroyed)
            tetrahedra[destroyed].destroyer = site;
        for (const HistoryTetrahedron& born : step.star)
            tetrahedra.push_back(
                {{site, born.sites[0], born.sites[1], born.sites[2]}, born.error, 0xffffffff, born.warping});
        return {};
    }
    Status finish(float error) override
    {
        finalKey = error;
        return {};
    }
    bool alive(const Tetrahedron& tetrahedron, std::size_t sites) const
    {
        return tetrahedron.sites[0] < sites && tetrahedron.destroyer >= sites;
    }
    /// The sites of the first mesh whose error was at most `error`.
    std::size_t sitesAt(double error) const
    {
        return static_cast<std::size_t>(std::ranges::find_if(runningKeys, [&](float e) { return e <= error; }) -
                                        runningKeys.begin());
    }
};

} // namespace tetra
