// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimate/collapse_log.h"

#include "core/mesh/topology.h"

#include <tan/base.h>

#include <algorithm>
#include <limits>
#include <ranges>

namespace tetra {

namespace {

constexpr std::uint32_t noVertex = CollapseLog::none;

/// Numbers sites and tetrahedra in the order of the history and hands them to a sink.
class Emission {
public:
    /// `madeCounts`: for each collapse how many tetrahedra it made.
    template <class Counts> Emission(std::span<const std::uint32_t> points, const Counts& madeCounts, HistorySink& sink)
        : sink_(sink), points_(points), siteOfPoint_(points.size(), noVertex)
    {
        nextMade_.reserve(madeCounts.size());
        std::uint32_t total = 0;
        for (const std::uint32_t count : madeCounts) {
            nextMade_.push_back(total);
            total += count;
        }
        made_.resize(total);
    }

    std::uint32_t siteOf(std::uint32_t point) const { return siteOfPoint_[point]; }
    void number(std::uint32_t point) { siteOfPoint_[point] = siteCount_++; }

    /// Ask for what add() needs of a tetrahedron, the second some time after the first.
    void prefetch(const std::array<std::uint32_t, 3>& others, std::uint32_t madeBy) const
    {
        for (const std::uint32_t other : others)
            __builtin_prefetch(&siteOfPoint_[other]);
        if (madeBy != noVertex)
            __builtin_prefetch(&nextMade_[madeBy]);
    }
    void prefetchMade(std::uint32_t madeBy) const
    {
        if (madeBy != noVertex)
            __builtin_prefetch(&made_[nextMade_[madeBy]]);
    }

    /// A tetrahedron of the step to come.
    void add(const std::array<std::uint32_t, 3>& others, float error, float warping, std::uint32_t madeBy)
    {
        star_.push_back({{siteOf(others[0]), siteOf(others[1]), siteOf(others[2])}, error, warping});
        if (madeBy != noVertex)
            made_[nextMade_[madeBy]++] = tetrahedronCount_;
        ++tetrahedronCount_;
    }

    /// The step that ends with what was added; it destroys the `madeCount` tetrahedra that `collapse`, which it undoes,
    /// made. All of them have been added.
    Status step(std::uint32_t point, float keyBefore, std::uint32_t collapse, std::uint32_t madeCount)
    {
        const std::span<const std::uint32_t> destroyed =
            madeCount == 0 ? std::span<const std::uint32_t>()
                           : std::span(made_).subspan(nextMade_[collapse] - madeCount, madeCount);
        Status status = sink_.add({points_[point], keyBefore, star_, destroyed});
        star_.clear();
        return status;
    }

private:
    HistorySink& sink_;
    std::span<const std::uint32_t> points_;
    std::uint32_t siteCount_ = 0;
    std::uint32_t tetrahedronCount_ = 0;
    std::vector<std::uint32_t> siteOfPoint_;
    /// The tetrahedra of the history that each collapse made, side by side: what the vertex split that undoes it
    /// destroys; and for each collapse the place for its next one.
    Buffer<std::uint32_t> made_;
    std::vector<std::uint32_t> nextMade_;
    std::vector<HistoryTetrahedron> star_;
};

/// The coarsest mesh, each tetrahedron with the latest of its sites.
Status emitCoarsest(std::span<const CollapseLog::Coarsest> coarsest, std::span<const std::uint8_t> removed,
                    Emission& emission)
{
    std::vector<std::uint32_t> points;
    for (std::uint32_t point = 0; point < removed.size(); ++point)
        if (removed[point] == 0) {
            emission.number(point);
            points.push_back(point);
        }
    struct Born {
        std::uint32_t creator;
        std::uint32_t number;
        std::size_t latest;
    };
    std::vector<Born> born;
    for (std::uint32_t number = 0; number < coarsest.size(); ++number) {
        const auto& vertices = coarsest[number].vertices;
        const auto siteOf = [&emission](std::uint32_t point) { return emission.siteOf(point); };
        const auto latest = static_cast<std::size_t>(std::ranges::max_element(vertices, {}, siteOf) - vertices.begin());
        born.push_back({siteOf(vertices[latest]), number, latest});
    }
    std::ranges::stable_sort(born, {}, &Born::creator);
    auto next = born.begin();
    for (std::uint32_t site = 0; site < points.size(); ++site) {
        for (; next != born.end() && next->creator == site; ++next) {
            const CollapseLog::Coarsest& tetrahedron = coarsest[next->number];
            std::array<std::uint32_t, 3> others{};
            for (std::size_t i = 0; i < 3; ++i)
                others[i] = tetrahedron.vertices[cornersOfFace[next->latest][i]];
            emission.add(others, tetrahedron.error, tetrahedron.warping, tetrahedron.madeBy);
        }
        if (Status status = emission.step(points[site], std::numeric_limits<float>::infinity(), noVertex, 0); !status)
            return status;
    }
    return {};
}

} // namespace

void CollapseLog::reserve(std::uint64_t collapses, std::uint64_t tetrahedra)
{
    collapses_.reserve(collapses);
    tetrahedra_.reserve(tetrahedra);
}

void CollapseLog::add(std::uint32_t vertex, float keyAfter, std::span<const Tetrahedron> star, std::uint32_t madeCount)
{
    collapses_.push_back({vertex, keyAfter, static_cast<std::uint32_t>(star.size()), madeCount});
    tetrahedra_.insert(tetrahedra_.end(), star.begin(), star.end());
}

std::vector<std::uint8_t> CollapseLog::removed(std::size_t points) const
{
    std::vector<std::uint8_t> removed(points, 0);
    for (const Collapse& collapse : collapses_)
        removed[collapse.vertex] = 1;
    return removed;
}

Status CollapseLog::handCoarsest(std::span<const std::uint32_t> points, std::vector<Coarsest> coarsest, float key,
                                 HistorySink& sink) const
{
    for (Coarsest& tetrahedron : coarsest)
        tetrahedron.madeBy = none; // nothing that follows destroys it
    Emission emission(points, std::span<const std::uint32_t>(), sink);
    if (Status status = emitCoarsest(coarsest, removed(points.size()), emission); !status)
        return status;
    return sink.finish(key);
}

Status CollapseLog::replay(std::span<const std::uint32_t> points, std::span<const Coarsest> coarsest, float finalKey,
                           HistorySink& sink, const Progress& progress) const
{
    std::uint64_t made = 0;
    for (const Collapse& collapse : collapses_)
        made += collapse.madeCount;
    if (std::max<std::uint64_t>(made, tetrahedra_.size() + coarsest.size()) >= none)
        return Error{ErrorKind::OutOfResource,
                     Message::say("The history has more than 4 billion tetrahedra. Decimate a part of the mesh.")};
    Emission emission(points, std::views::transform(collapses_, &Collapse::madeCount), sink);
    if (Status status = emitCoarsest(coarsest, removed(points.size()), emission); !status)
        return status;
    // What is added lies all over the memory, and is asked for about so many tetrahedra ahead.
    constexpr std::size_t ahead = 96, madeAhead = 48;
    const std::span<const Tetrahedron> tetrahedra = tetrahedra_;
    std::size_t first = tetrahedra.size();
    for (std::uint32_t number = collapseCount(); number-- > 0;) {
        const Collapse& collapse = collapses_[number];
        emission.number(collapse.vertex);
        first -= collapse.starSize;
        for (std::size_t i = first; i < first + collapse.starSize; ++i) {
            if (i >= ahead)
                emission.prefetch(tetrahedra[i - ahead].others, tetrahedra[i - ahead].madeBy);
            if (i >= madeAhead)
                emission.prefetchMade(tetrahedra[i - madeAhead].madeBy);
            emission.add(tetrahedra[i].others, tetrahedra[i].error, tetrahedra[i].warping, tetrahedra[i].madeBy);
        }
        if (Status status = emission.step(collapse.vertex, collapse.keyAfter, number, collapse.madeCount); !status)
            return status;
        if (number % 4096 != 0)
            continue;
        if (progress.cancelled())
            return cancelledError(Message::marked("The decimation"));
        progress.report(1 - static_cast<double>(number) / collapseCount(), Message::marked("Writing the history"));
    }
    return sink.finish(finalKey);
}

} // namespace tetra
