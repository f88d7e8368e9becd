// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/sight/volume_slabs.h"

#include "core/graphics/volume/volume_mesh.h"
#include "core/mesh/topology.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace tetra {
namespace {

/// Passages whose ends are nearer to each other than this part of their length are those of two cells that the line
/// passes between, along their common face.
constexpr double samePassage = 1e-9;
constexpr std::size_t cellsPerCheck = 1 << 16; ///< for a cancellation

/// What a line has of a cell.
struct RayInterval {
    SightPart part;
    double valueAtStart = 0;
    double valueAtEnd = 0;
};

/// Coordinates in which the line is the third axis.
class LineFrame {
public:
    explicit LineFrame(const SightLine& line) : line_(line)
    {
        right_ = line.direction.unitOrthogonal();
        up_ = line.direction.cross(right_);
    }
    double right(const Eigen::Vector3d& place) const { return right_.dot(place - line_.origin); }
    double up(const Eigen::Vector3d& place) const { return up_.dot(place - line_.origin); }
    double along(const Eigen::Vector3d& place) const { return line_.direction.dot(place - line_.origin); }

private:
    const SightLine& line_;
    Eigen::Vector3d right_, up_;
};

using Four = std::array<double, 4>;

bool allOnOneSide(const Four& numbers)
{
    return std::ranges::all_of(numbers, [](double number) { return number > 0; }) ||
           std::ranges::all_of(numbers, [](double number) { return number < 0; });
}

/// Where the line passes through the faces of a cell that is seen along it. Nothing if it passes beside, or touches.
std::optional<RayInterval> passageOf(const Four& right, const Four& up, const Four& along, const Four& values)
{
    RayInterval passage{{SightPart{}.to, SightPart{}.from}, 0, 0};
    for (const auto& face : cornersOfFace) {
        std::array<double, 3> weights{};
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t next = face[(i + 1) % 3], last = face[(i + 2) % 3];
            weights[i] = right[next] * up[last] - right[last] * up[next];
        }
        const double sum = weights[0] + weights[1] + weights[2];
        if (sum == 0 || !std::ranges::all_of(weights, [sum](double weight) { return weight * sum >= 0; }))
            continue;
        double at = 0, value = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            at += weights[i] / sum * along[face[i]];
            value += weights[i] / sum * values[face[i]];
        }
        if (at < passage.part.from) {
            passage.part.from = at;
            passage.valueAtStart = value;
        }
        if (at > passage.part.to) {
            passage.part.to = at;
            passage.valueAtEnd = value;
        }
    }
    return passage.part.isEmpty() ? std::nullopt : std::optional(passage);
}

/// Within a part of the line alone.
std::optional<RayInterval> clippedInterval(const RayInterval& whole, const SightPart& part)
{
    RayInterval passage = whole;
    passage.part = common(whole.part, part);
    if (passage.part.isEmpty())
        return std::nullopt;
    const auto valueAt = [&whole](double t) {
        const double share = (t - whole.part.from) / (whole.part.to - whole.part.from);
        return std::lerp(whole.valueAtStart, whole.valueAtEnd, share);
    };
    passage.valueAtStart = valueAt(passage.part.from);
    passage.valueAtEnd = valueAt(passage.part.to);
    return passage;
}

std::vector<RayInterval> passagesAlong(const TetrahedralMesh& mesh, const SightLine& line, const SightPart& part,
                                       const Progress& progress)
{
    const LineFrame frame(line);
    std::vector<RayInterval> passages;
    for (std::size_t cell = 0; cell < mesh.tetrahedra.size(); ++cell) {
        if (cell % cellsPerCheck == 0 && progress.cancelled())
            break;
        const auto& corners = mesh.tetrahedra[cell];
        Four right{}, up{}, along{}, values{};
        for (std::size_t i = 0; i < 4; ++i)
            right[i] = frame.right(mesh.positions[corners[i]].cast<double>());
        if (allOnOneSide(right))
            continue;
        for (std::size_t i = 0; i < 4; ++i)
            up[i] = frame.up(mesh.positions[corners[i]].cast<double>());
        if (allOnOneSide(up))
            continue;
        for (std::size_t i = 0; i < 4; ++i) {
            along[i] = frame.along(mesh.positions[corners[i]].cast<double>());
            values[i] = mesh.values[corners[i]];
        }
        if (const auto whole = passageOf(right, up, along, values))
            if (const auto passage = clippedInterval(*whole, part))
                passages.push_back(*passage);
    }
    return passages;
}

bool isSameInterval(const RayInterval& one, const RayInterval& other)
{
    const double length = one.part.to - one.part.from;
    return std::abs(one.part.from - other.part.from) <= samePassage * length &&
           std::abs(one.part.to - other.part.to) <= samePassage * length;
}

double extinctionAt(const TransferSegment& segment, double value)
{
    return std::max(0.0, segment.atOrigin.extinction + (value - segment.origin) * segment.perValue.extinction);
}

/// One slab for each segment that the values of the passage lie in, in the order in which the line meets them.
void addSlabs(std::vector<SightSlab>& slabs, const RayInterval& passage, const std::vector<TransferSegment>& segments)
{
    const double rise = passage.valueAtEnd - passage.valueAtStart;
    const auto [least, largest] = std::minmax(passage.valueAtStart, passage.valueAtEnd);
    auto segment = std::ranges::upper_bound(segments, least, {}, &TransferSegment::begin) - segments.begin() - 1;
    const std::size_t first = slabs.size();
    for (; segment < std::ssize(segments) && segments[static_cast<std::size_t>(segment)].begin <= largest; ++segment) {
        const TransferSegment& here = segments[static_cast<std::size_t>(segment)];
        if (here.transparent())
            continue;
        const double low = std::max(least, here.begin), high = std::min(largest, here.end);
        const double start = rise < 0 ? high : low, end = rise < 0 ? low : high;
        SightPart part = passage.part;
        if (rise != 0) {
            const double length = part.to - part.from;
            part = {passage.part.from + (start - passage.valueAtStart) / rise * length,
                    passage.part.from + (end - passage.valueAtStart) / rise * length};
        }
        if (!part.isEmpty())
            slabs.push_back({part, start, end, extinctionAt(here, start), extinctionAt(here, end)});
    }
    if (rise < 0)
        std::reverse(slabs.begin() + static_cast<std::ptrdiff_t>(first), slabs.end());
}

} // namespace

std::vector<SightSlab> slabsAlong(const Volume& volume, const SightLine& line, const SightPart& part,
                                  const Progress& progress)
{
    if (part.isEmpty())
        return {};
    std::vector<RayInterval> passages = passagesAlong(*volume.mesh->mesh, line, part, progress);
    std::ranges::sort(passages, {}, [](const RayInterval& passage) { return passage.part.from; });
    const auto doubled = std::ranges::unique(passages, isSameInterval);
    passages.erase(doubled.begin(), doubled.end());
    std::vector<SightSlab> slabs;
    for (const RayInterval& passage : passages)
        addSlabs(slabs, passage, volume.transfer->segments);
    return slabs;
}

} // namespace tetra
