// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/decimation/collapse_log.h"

#include <algorithm>
#include <limits>

namespace tetra {

namespace {

constexpr std::uint32_t none = CollapseLog::none;

/// Numbers sites and tetrahedra in the order of the history and hands them to a sink.
class Emission {
public:
    Emission(std::span<const std::uint32_t> points, std::uint32_t collapseCount, std::uint64_t tetrahedronCount,
             HistorySink& sink)
        : sink_(sink), points_(points), siteOfPoint_(points.size(), none), latestOfCollapse_(collapseCount, none)
    {
        next_.reserve(tetrahedronCount);
    }

    std::uint32_t siteOf(std::uint32_t point) const { return siteOfPoint_[point]; }
    void number(std::uint32_t point) { siteOfPoint_[point] = siteCount_++; }

    /// A tetrahedron of the step to come.
    void add(const std::array<std::uint32_t, 3>& others, float error, float warping, std::uint32_t madeBy)
    {
        star_.push_back({{siteOf(others[0]), siteOf(others[1]), siteOf(others[2])}, error, warping});
        next_.push_back(none);
        if (madeBy == none)
            return;
        next_.back() = latestOfCollapse_[madeBy];
        latestOfCollapse_[madeBy] = static_cast<std::uint32_t>(next_.size() - 1);
    }

    /// The step that ends with what was added; it undoes `collapse`, or none.
    Status step(std::uint32_t point, float keyBefore, std::uint32_t collapse)
    {
        destroyed_.clear();
        for (std::uint32_t i = collapse == none ? none : latestOfCollapse_[collapse]; i != none; i = next_[i])
            destroyed_.push_back(i);
        std::ranges::reverse(destroyed_);
        Status status = sink_.add({points_[point], keyBefore, star_, destroyed_});
        star_.clear();
        return status;
    }

private:
    HistorySink& sink_;
    std::span<const std::uint32_t> points_;
    std::uint32_t siteCount_ = 0;
    std::vector<std::uint32_t> siteOfPoint_;
    /// By collapse, the latest tetrahedron of the history that it made, and for each the one before: what the vertex
    /// split that undoes it destroys.
    std::vector<std::uint32_t> latestOfCollapse_;
    std::vector<std::uint32_t> next_;
    std::vector<HistoryTetrahedron> star_;
    std::vector<std::uint32_t> destroyed_;
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
            // An even permutation brings the latest to the front.
            constexpr std::uint8_t order[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
            const CollapseLog::Coarsest& tetrahedron = coarsest[next->number];
            std::array<std::uint32_t, 3> others{};
            for (std::size_t i = 0; i < 3; ++i)
                others[i] = tetrahedron.vertices[order[next->latest][i]];
            emission.add(others, tetrahedron.error, tetrahedron.warping, tetrahedron.madeBy);
        }
        if (Status status = emission.step(points[site], std::numeric_limits<float>::infinity(), none); !status)
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

void CollapseLog::add(std::uint32_t vertex, float keyAfter, std::span<const Tetrahedron> star)
{
    collapses_.push_back({vertex, keyAfter, tetrahedra_.size()});
    tetrahedra_.insert(tetrahedra_.end(), star.begin(), star.end());
}

Status CollapseLog::emit(std::span<const std::uint32_t> points, std::span<const Coarsest> coarsest, float finalKey,
                         HistorySink& sink, const Progress& progress) const
{
    std::vector<std::uint8_t> removed(points.size(), 0);
    for (const Collapse& collapse : collapses_)
        removed[collapse.vertex] = 1;
    Emission emission(points, collapseCount(), tetrahedra_.size() + coarsest.size(), sink);
    if (Status status = emitCoarsest(coarsest, removed, emission); !status)
        return status;
    std::uint64_t end = tetrahedra_.size();
    for (std::uint32_t number = collapseCount(); number-- > 0;) {
        const Collapse& collapse = collapses_[number];
        emission.number(collapse.vertex);
        for (std::uint64_t i = collapse.firstTetrahedron; i < end; ++i)
            emission.add(tetrahedra_[i].others, tetrahedra_[i].error, tetrahedra_[i].warping, tetrahedra_[i].madeBy);
        end = collapse.firstTetrahedron;
        if (Status status = emission.step(collapse.vertex, collapse.keyAfter, number); !status)
            return status;
        if (number % 4096 != 0)
            continue;
        if (progress.cancelled())
            return cancelledError("The decimation");
        progress.report(1 - static_cast<double>(number) / collapseCount(), "Writing the history");
    }
    return sink.finish(finalKey);
}

} // namespace tetra
