// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/picking/picking.h"

#include "core/mesh/topology.h"
#include "core/render/focus_weight.h"
#include "core/render/picking/sampled_pieces.h"
#include "core/render/samples/sampled_field.h"
#include "core/render/volume/volume_mesh.h"

#include <tan/render.h>

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <tuple>

namespace tetra {

namespace {

/// A piece of a line of sight in which value and extinction go in a straight line from one end to the other: what a ray
/// has of a cell and of a segment of the transfer function.
struct PickingSlab {
    PickingInterval part;
    double valueAtStart = 0;
    double valueAtEnd = 0;
    double extinctionAtStart = 0; ///< per unit of length of the dataset
    double extinctionAtEnd = 0;
};

constexpr PickingInterval emptyPart{1, 0};

/// Where the line has normal . place >= offset.
PickingInterval partBeyond(const PickingRay& line, const Eigen::Vector3d& normal, double offset)
{
    const double slope = normal.dot(line.direction);
    const double missing = offset - normal.dot(line.origin);
    if (slope == 0)
        return missing <= 0 ? PickingInterval{} : emptyPart;
    PickingInterval part;
    (slope > 0 ? part.from : part.to) = missing / slope;
    return part;
}

/// The intersection of two intervals.
PickingInterval commonPart(const PickingInterval& one, const PickingInterval& other)
{
    return {std::max(one.from, other.from), std::min(one.to, other.to)};
}

/// What is before the eye and left by the clip planes.
PickingInterval shownPart(const PickingRay& line, std::span<const ClipPlane> planes)
{
    PickingInterval part;
    part.from = line.nearest;
    for (const ClipPlane& plane : planes)
        part = commonPart(part, partBeyond(line, plane.normal, plane.offset));
    return part;
}

} // namespace

PickingInterval partWithin(const PickingRay& line, const Box& box)
{
    PickingInterval part;
    for (int axis = 0; axis < 3; ++axis) {
        const Eigen::Vector3d normal = Eigen::Vector3d::Unit(axis);
        part = commonPart(part, partBeyond(line, normal, box.least[axis]));
        part = commonPart(part, partBeyond(line, -normal, -box.largest[axis]));
    }
    return part;
}

PickingInterval partWithin(const PickingRay& line, const Sphere& sphere)
{
    const Eigen::Vector3d toCentre = sphere.centre - line.origin;
    const double middle = toCentre.dot(line.direction);
    const double squaredHalf = sphere.radius * sphere.radius - (toCentre - middle * line.direction).squaredNorm();
    if (!(squaredHalf > 0))
        return emptyPart;
    return {middle - std::sqrt(squaredHalf), middle + std::sqrt(squaredHalf)};
}

namespace {

/// Crossings of one surface that are nearer to each other than this part of their distance are one, on an edge.
constexpr double sameCrossing = 1e-9;

/// Where a line passes through a triangle.
struct TriangleCrossing {
    double at;   ///< of PickingRay
    double u, v; ///< weights of the second and the third corner
    bool front;  ///< the line comes from where the corners are seen counterclockwise
};

/// From either side (Möller and Trumbore).
std::optional<TriangleCrossing> crossing(const PickingRay& line, const std::array<Eigen::Vector3d, 3>& corners)
{
    const Eigen::Vector3d one = corners[1] - corners[0];
    const Eigen::Vector3d other = corners[2] - corners[0];
    const Eigen::Vector3d across = line.direction.cross(other);
    const double volume = one.dot(across);
    if (volume == 0)
        return std::nullopt;
    const Eigen::Vector3d from = line.origin - corners[0];
    const double u = from.dot(across) / volume;
    const Eigen::Vector3d beside = from.cross(one);
    const double v = line.direction.dot(beside) / volume;
    if (u < 0 || v < 0 || u + v > 1)
        return std::nullopt;
    return TriangleCrossing{other.dot(beside) / volume, u, v, volume > 0};
}

std::optional<double> valueAtCrossing(const Drawable& drawable, const TriangleMesh& mesh,
                                      const std::array<std::uint32_t, 3>& triangle, const TriangleCrossing& met)
{
    if (drawable.value || mesh.values.empty())
        return drawable.value;
    const double first = mesh.values[triangle[0]];
    return first + met.u * (mesh.values[triangle[1]] - first) + met.v * (mesh.values[triangle[2]] - first);
}

bool isSame(const SurfaceCrossing& one, const SurfaceCrossing& other)
{
    return one.surface == other.surface &&
           std::abs(one.at - other.at) <= sameCrossing * std::max(std::abs(one.at), std::abs(other.at));
}

} // namespace

std::vector<SurfaceCrossing> surfaceCrossings(const Scene& scene, const PickingRay& line, const PickingInterval& part)
{
    std::vector<SurfaceCrossing> crossings;
    for (const Drawable& drawable : scene.drawables) {
        const auto* surface = std::get_if<Surface>(&drawable.shape);
        if (surface == nullptr || !surface->mesh || drawable.overlay)
            continue;
        const TriangleMesh& mesh = *surface->mesh;
        for (const auto& triangle : mesh.triangles) {
            const auto corner = [&](std::size_t i) -> Eigen::Vector3d { return mesh.positions[triangle[i]]; };
            const auto met = crossing(line, {corner(0), corner(1), corner(2)});
            if (met && part.contains(met->at) && !(met->front && surface->backFacesOnly))
                crossings.push_back({met->at, &drawable, valueAtCrossing(drawable, mesh, triangle, *met)});
        }
    }
    // A pointer into the list of drawables is a place in their order.
    std::ranges::sort(crossings, {}, [](const SurfaceCrossing& one) { return std::tuple(one.surface, one.at); });
    const auto doubled = std::ranges::unique(crossings, isSame);
    crossings.erase(doubled.begin(), doubled.end());
    std::ranges::stable_sort(crossings, {}, &SurfaceCrossing::at);
    return crossings;
}

namespace {

/// Intervals whose ends are nearer to each other than this part of their length are those of two cells that the line
/// passes between, along their common face.
constexpr double sameInterval = 1e-9;
constexpr std::size_t cellsPerCheck = 1 << 16; ///< for a cancellation

/// What a line has of a cell.
struct RayInterval {
    PickingInterval part;
    double valueAtStart = 0;
    double valueAtEnd = 0;
    std::size_t cell = 0;
};

/// Coordinates in which the line is the third axis.
class LineFrame {
public:
    explicit LineFrame(const PickingRay& line) : line_(line)
    {
        right_ = line.direction.unitOrthogonal();
        up_ = line.direction.cross(right_);
    }
    double right(const Eigen::Vector3d& place) const { return right_.dot(place - line_.origin); }
    double up(const Eigen::Vector3d& place) const { return up_.dot(place - line_.origin); }
    double along(const Eigen::Vector3d& place) const { return line_.direction.dot(place - line_.origin); }

private:
    const PickingRay& line_;
    Eigen::Vector3d right_, up_;
};

using Four = std::array<double, 4>;

bool allOnOneSide(const Four& numbers)
{
    return std::ranges::all_of(numbers, [](double number) { return number > 0; }) ||
           std::ranges::all_of(numbers, [](double number) { return number < 0; });
}

/// Where the line passes through the faces of a cell that is seen along it. Nothing if it passes beside, or touches.
std::optional<RayInterval> intervalOf(const Four& right, const Four& up, const Four& along, const Four& values)
{
    RayInterval interval{{PickingInterval{}.to, PickingInterval{}.from}};
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
        if (at < interval.part.from) {
            interval.part.from = at;
            interval.valueAtStart = value;
        }
        if (at > interval.part.to) {
            interval.part.to = at;
            interval.valueAtEnd = value;
        }
    }
    return interval.part.isEmpty() ? std::nullopt : std::optional(interval);
}

/// Within a part of the line alone.
std::optional<RayInterval> clippedInterval(const RayInterval& whole, const PickingInterval& part)
{
    RayInterval interval = whole;
    interval.part = commonPart(whole.part, part);
    if (interval.part.isEmpty())
        return std::nullopt;
    const auto valueAt = [&whole](double t) {
        const double share = (t - whole.part.from) / (whole.part.to - whole.part.from);
        return std::lerp(whole.valueAtStart, whole.valueAtEnd, share);
    };
    interval.valueAtStart = valueAt(interval.part.from);
    interval.valueAtEnd = valueAt(interval.part.to);
    return interval;
}

std::vector<RayInterval> intervalsAlong(const TetrahedralMesh& mesh, const PickingRay& line,
                                        const PickingInterval& part, const Progress& progress)
{
    const LineFrame frame(line);
    std::vector<RayInterval> intervals;
    for (std::size_t cell = 0; cell < mesh.tetrahedra.size(); ++cell) {
        if (cell % cellsPerCheck == 0 && progress.cancelled())
            break;
        const auto& corners = mesh.tetrahedra[cell];
        Four right{}, up{}, along{}, values{};
        for (std::size_t i = 0; i < 4; ++i)
            right[i] = frame.right(mesh.positions[corners[i]]);
        if (allOnOneSide(right))
            continue;
        for (std::size_t i = 0; i < 4; ++i)
            up[i] = frame.up(mesh.positions[corners[i]]);
        if (allOnOneSide(up))
            continue;
        for (std::size_t i = 0; i < 4; ++i) {
            along[i] = frame.along(mesh.positions[corners[i]]);
            values[i] = mesh.values[corners[i]];
        }
        if (const auto whole = intervalOf(right, up, along, values))
            if (const auto interval = clippedInterval(*whole, part)) {
                intervals.push_back(*interval);
                intervals.back().cell = cell;
            }
    }
    return intervals;
}

bool isSameInterval(const RayInterval& one, const RayInterval& other)
{
    const double length = one.part.to - one.part.from;
    return std::abs(one.part.from - other.part.from) <= sameInterval * length &&
           std::abs(one.part.to - other.part.to) <= sameInterval * length;
}

double extinctionAt(const TransferSegment& segment, double value)
{
    return std::max(0.0, segment.atOrigin.extinction + (value - segment.origin) * segment.perValue.extinction);
}

/// One slab for each segment that the values of the interval lie in, in the order in which the line meets them.
void addSlabs(std::vector<PickingSlab>& slabs, const RayInterval& interval,
              const std::vector<TransferSegment>& segments)
{
    const double rise = interval.valueAtEnd - interval.valueAtStart;
    const auto [least, largest] = std::minmax(interval.valueAtStart, interval.valueAtEnd);
    auto segment = std::ranges::upper_bound(segments, least, {}, &TransferSegment::begin) - segments.begin() - 1;
    const std::size_t first = slabs.size();
    for (; segment < std::ssize(segments) && segments[static_cast<std::size_t>(segment)].begin <= largest; ++segment) {
        const TransferSegment& here = segments[static_cast<std::size_t>(segment)];
        if (here.transparent())
            continue;
        const double low = std::max(least, here.begin), high = std::min(largest, here.end);
        const double start = rise < 0 ? high : low, end = rise < 0 ? low : high;
        PickingInterval part = interval.part;
        if (rise != 0) {
            const double length = part.to - part.from;
            part = {interval.part.from + (start - interval.valueAtStart) / rise * length,
                    interval.part.from + (end - interval.valueAtStart) / rise * length};
        }
        if (!part.isEmpty())
            slabs.push_back({part, start, end, extinctionAt(here, start), extinctionAt(here, end)});
    }
    if (rise < 0)
        std::reverse(slabs.begin() + static_cast<std::ptrdiff_t>(first), slabs.end());
}

/// The cells along a line within `part`, the nearest first. O(cells), and a logarithm for each that is met. What was
/// found so far if cancelled.
std::vector<RayInterval> orderedIntervals(const TetrahedralMesh& mesh, const PickingRay& line,
                                          const PickingInterval& part, const Progress& progress)
{
    if (part.isEmpty())
        return {};
    std::vector<RayInterval> intervals = intervalsAlong(mesh, line, part, progress);
    std::ranges::sort(intervals, {}, [](const RayInterval& interval) { return interval.part.from; });
    const auto doubled = std::ranges::unique(intervals, isSameInterval);
    intervals.erase(doubled.begin(), doubled.end());
    return intervals;
}

/// All of a volume within `part`, the nearest first, those that nothing is seen of left out.
std::vector<PickingSlab> slabsAlong(const Volume& volume, const PickingRay& line, const PickingInterval& part,
                                    const Progress& progress)
{
    std::vector<PickingSlab> slabs;
    for (const RayInterval& interval : orderedIntervals(*volume.mesh->mesh, line, part, progress))
        addSlabs(slabs, interval, volume.transfer->segments);
    return slabs;
}

/// The same of samples.
std::vector<PickingSlab> slabsAlong(const SampledVolume& samples, const PickingRay& line, const PickingInterval& part)
{
    std::vector<PickingSlab> slabs;
    for (const SampledPiece& piece : sampledPieces(*samples.samples, line, part))
        addSlabs(slabs, {piece.part, piece.valueAtStart, piece.valueAtEnd}, samples.transfer->segments);
    return slabs;
}

/// The magnitude of the field's gradient in a cell; 0 in a flat one.
double gradientOf(const TetrahedralMesh& mesh, std::size_t cell)
{
    const auto& corners = mesh.tetrahedra[cell];
    Eigen::Matrix3d edges;
    Eigen::Vector3d rises;
    for (int i = 0; i < 3; ++i) {
        const std::uint32_t corner = corners[static_cast<std::size_t>(i) + 1];
        edges.row(i) = (mesh.positions[corner] - mesh.positions[corners[0]]).transpose();
        rises[i] = double(mesh.values[corner]) - mesh.values[corners[0]];
    }
    const double volume = edges.determinant();
    return volume != 0 ? (edges.inverse() * rises).norm() : 0;
}

/// How much light each interval takes by the volume's optical model.
std::vector<double> opacitiesOf(const Volume& volume, const std::vector<RayInterval>& intervals)
{
    std::array<std::vector<float>, 8> numbers; // entry, exit, length, gradient, and what is asked for
    for (std::vector<float>& each : numbers)
        each.resize(intervals.size());
    auto& [entry, exit, length, gradient, red, green, blue, transmittance] = numbers;
    for (std::size_t i = 0; i < intervals.size(); ++i) {
        const RayInterval& interval = intervals[i];
        entry[i] = static_cast<float>(interval.valueAtStart);
        exit[i] = static_cast<float>(interval.valueAtEnd);
        length[i] = static_cast<float>(interval.part.to - interval.part.from);
        gradient[i] = static_cast<float>(gradientOf(*volume.mesh->mesh, interval.cell));
    }
    if (!intervals.empty())
        volume.model->evaluate({intervals.size(), entry.data(), exit.data(), length.data(), gradient.data(), red.data(),
                                green.data(), blue.data(), transmittance.data()});
    std::vector<double> opacities;
    for (std::size_t i = 0; i < intervals.size(); ++i) {
        const bool isShown = volume.transfer->classes[intervals[i].cell].visible();
        opacities.push_back(isShown ? std::clamp(1.0 - transmittance[i], 0.0, 1.0) : 0);
    }
    return opacities;
}

/// At which end of a piece its value has the larger opacity; of equal ones where the value is larger.
bool countsMoreAtStart(const Volume& volume, const RayInterval& piece)
{
    std::vector<RayInterval> ends{piece, piece};
    ends[0].valueAtEnd = piece.valueAtStart;
    ends[1].valueAtStart = piece.valueAtEnd;
    const std::vector<double> opacities = opacitiesOf(volume, ends);
    return opacities[0] != opacities[1] ? opacities[0] > opacities[1] : piece.valueAtStart > piece.valueAtEnd;
}

/// Less of the light cannot be told from none.
constexpr double leastShare = 1.0 / 255;

/// What is left of the light on its way, and who has taken most so far.
class RayTransmittance {
public:
    /// `volume`: the id of the one that slabs are of.
    RayTransmittance(const PickingRay& line, std::string volume) : line_(line) { volume_.drawable = std::move(volume); }

    void passSurface(const SurfaceCrossing& crossing)
    {
        const auto& surface = std::get<Surface>(crossing.surface->shape);
        const double opacity = opacityAt(surface.opacity, surface.share.get(), line_.at(crossing.at));
        if (light_ * opacity > surface_.share)
            surface_ = {line_.at(crossing.at), crossing.surface->id, crossing.value, light_ * opacity};
        light_ *= 1 - opacity;
    }

    void passSlab(const PickingSlab& slab)
    {
        const double length = slab.part.to - slab.part.from;
        const double rise = (slab.extinctionAtEnd - slab.extinctionAtStart) / length;
        compare(slab, 0, rise);
        compare(slab, length, rise);
        // The derivative of what is taken, (rise - extinction^2) e^-depth, is zero where the extinction is its root.
        if (rise > 0)
            if (const double within = (std::sqrt(rise) - slab.extinctionAtStart) / rise; within > 0 && within < length)
                compare(slab, within, rise);
        const double opacity = -std::expm1(-(slab.extinctionAtStart + slab.extinctionAtEnd) / 2 * length);
        volume_.share += light_ * opacity;
        light_ *= 1 - opacity;
    }

    /// A piece by an optical model that is put over what lies behind; it is seen in its middle.
    void passPiece(const RayInterval& piece, double opacity)
    {
        const double taken = light_ * opacity;
        if (const double density = taken / (piece.part.to - piece.part.from); density > mostTaken_) {
            mostTaken_ = density;
            volume_.place = line_.at((piece.part.from + piece.part.to) / 2);
            volume_.value = (piece.valueAtStart + piece.valueAtEnd) / 2;
        }
        volume_.share += taken;
        light_ *= 1 - opacity;
    }

    /// All pieces by a model of another combination, before everything else: the one that counts most is seen, at that
    /// of its ends which counts more.
    void passTogether(const Volume& volume, const std::vector<RayInterval>& pieces,
                      const std::vector<double>& opacities, double opaque)
    {
        const OpticalModel& model = *volume.model;
        double most = 0;
        const RayInterval* counts = nullptr;
        for (std::size_t i = 0; i < pieces.size() && pieces[i].part.from < opaque; ++i) {
            if (opacities[i] > most) {
                most = opacities[i];
                counts = &pieces[i];
            }
            volume_.share = model.combiner == Combiner::Sum ? std::min(1.0, volume_.share + opacities[i]) : most;
        }
        if (counts != nullptr) {
            const bool atStart = countsMoreAtStart(volume, *counts);
            volume_.place = line_.at(atStart ? counts->part.from : counts->part.to);
            volume_.value = atStart ? counts->valueAtStart : counts->valueAtEnd;
            if (model.lightOfRay)
                volume_.share = std::clamp(model.lightOfRay(static_cast<float>(volume_.share))[3], 0.0f, 1.0f);
        }
        light_ = 1 - volume_.share;
    }

    std::optional<SeenPlace> mostSeen() const
    {
        const SeenPlace& most = surface_.share >= volume_.share ? surface_ : volume_;
        return most.share >= leastShare ? std::optional(most) : std::nullopt;
    }

private:
    void compare(const PickingSlab& slab, double within, double rise)
    {
        const double depth = within * (slab.extinctionAtStart + rise * within / 2);
        const double taken = light_ * (slab.extinctionAtStart + rise * within) * std::exp(-depth);
        if (!(taken > mostTaken_))
            return;
        mostTaken_ = taken;
        volume_.place = line_.at(slab.part.from + within);
        volume_.value = std::lerp(slab.valueAtStart, slab.valueAtEnd, within / (slab.part.to - slab.part.from));
    }

    const PickingRay& line_;
    double light_ = 1;
    double mostTaken_ = 0; ///< on a unit of length
    SeenPlace surface_;
    SeenPlace volume_; ///< its share is that of all slabs so far
};

/// Where the fine volume counts for at least a half, the nearest first.
std::vector<PickingInterval> partsInFocus(const FocusVolume& focus, const PickingRay& line)
{
    std::vector<PickingInterval> all;
    for (const FocusRegion& region : focus.regions) {
        const double margin = region.border / 2;
        PickingInterval part;
        if (const auto* sphere = std::get_if<Sphere>(&region.shape)) {
            part = partWithin(line, Sphere{sphere->centre, sphere->radius + margin});
        } else {
            const Box& box = std::get<Box>(region.shape);
            const Eigen::Vector3d more = Eigen::Vector3d::Constant(margin);
            part = partWithin(line, Box{box.least - more, box.largest + more});
        }
        if (!part.isEmpty())
            all.push_back(part);
    }
    std::ranges::sort(all, {}, &PickingInterval::from);
    std::vector<PickingInterval> parts;
    for (const PickingInterval& part : all)
        if (!parts.empty() && part.from <= parts.back().to)
            parts.back().to = std::max(parts.back().to, part.to);
        else
            parts.push_back(part);
    return parts;
}

/// The volume of a scene, the blend, or the samples.
const Drawable* volumeDrawable(const Scene& scene)
{
    const auto found = std::ranges::find_if(scene.drawables, [](const Drawable& drawable) {
        return std::holds_alternative<Volume>(drawable.shape) || std::holds_alternative<FocusVolume>(drawable.shape) ||
               std::holds_alternative<SampledVolume>(drawable.shape);
    });
    return found != scene.drawables.end() ? &*found : nullptr;
}

std::vector<PickingSlab> slabsOf(const Scene& scene, const PickingRay& line, const PickingInterval& shown,
                                 const Progress& progress)
{
    const Volume* volume = volumeOf(scene);
    const FocusVolume* focus = focusOf(scene);
    if (const SampledVolume* samples = samplesOf(scene); samples != nullptr)
        return slabsAlong(*samples, line, shown);
    if (volume == nullptr)
        return {};
    std::vector<PickingSlab> slabs;
    double from = shown.from;
    const auto add = [&](const Volume& of, double to) {
        std::ranges::copy(slabsAlong(of, line, commonPart(shown, {from, to}), progress), std::back_inserter(slabs));
        from = to;
    };
    if (focus != nullptr)
        for (const PickingInterval& part : partsInFocus(*focus, line)) {
            add(*volume, part.from);
            add(focus->fine, part.to);
        }
    add(*volume, shown.to);
    return slabs;
}

/// What is seen of a scene whose volume has an optical model. A piece that a surface cuts counts as a whole where its
/// middle is.
std::optional<SeenPlace> seenByModel(const Volume& volume, const PickingRay& line, const PickingInterval& shown,
                                     const std::vector<SurfaceCrossing>& crossings, RayTransmittance& transmittance,
                                     const Progress& progress)
{
    const auto pieces = orderedIntervals(*volume.mesh->mesh, line, shown, progress);
    if (progress.cancelled())
        return std::nullopt;
    const auto opacities = opacitiesOf(volume, pieces);
    const bool isOver = volume.model->combiner == Combiner::Over;
    if (!isOver) {
        const auto opaque = std::ranges::find_if(crossings, [](const SurfaceCrossing& crossing) {
            return std::get<Surface>(crossing.surface->shape).opacity >= 1;
        });
        transmittance.passTogether(volume, pieces, opacities, opaque != crossings.end() ? opaque->at : shown.to);
    }
    std::size_t next = 0;
    const auto passPiecesBefore = [&](double place) {
        for (; isOver && next < pieces.size() && (pieces[next].part.from + pieces[next].part.to) / 2 <= place; ++next)
            transmittance.passPiece(pieces[next], opacities[next]);
    };
    for (const SurfaceCrossing& crossing : crossings) {
        passPiecesBefore(crossing.at);
        transmittance.passSurface(crossing);
    }
    passPiecesBefore(shown.to);
    return transmittance.mostSeen();
}

/// What of a slab lies before a place, and what is left of it behind.
PickingSlab takeBefore(PickingSlab& slab, double place)
{
    const double share = (place - slab.part.from) / (slab.part.to - slab.part.from);
    PickingSlab before = slab;
    before.part.to = slab.part.from = place;
    before.valueAtEnd = slab.valueAtStart = std::lerp(slab.valueAtStart, slab.valueAtEnd, share);
    before.extinctionAtEnd = slab.extinctionAtStart = std::lerp(slab.extinctionAtStart, slab.extinctionAtEnd, share);
    return before;
}

} // namespace

std::optional<SeenPlace> seenPlace(const Scene& scene, const PickingRay& line, const Progress& progress)
{
    const PickingInterval shown = shownPart(line, scene.clipPlanes);
    if (shown.isEmpty() || !checkVolumes(scene))
        return std::nullopt;
    const std::vector<SurfaceCrossing> crossings = surfaceCrossings(scene, line, shown);
    const Drawable* volume = volumeDrawable(scene);
    RayTransmittance transmittance(line, volume != nullptr ? volume->id : std::string());
    if (const Volume* seen = volumeOf(scene); seen != nullptr && seen->model)
        return seenByModel(*seen, line, shown, crossings, transmittance, progress);
    std::vector<PickingSlab> slabs = slabsOf(scene, line, shown, progress);
    if (progress.cancelled())
        return std::nullopt;
    std::size_t next = 0;
    const auto passSlabsBefore = [&](double place) {
        for (; next < slabs.size() && slabs[next].part.to <= place; ++next)
            transmittance.passSlab(slabs[next]);
        if (next < slabs.size() && slabs[next].part.from < place)
            transmittance.passSlab(takeBefore(slabs[next], place));
    };
    for (const SurfaceCrossing& crossing : crossings) {
        passSlabsBefore(crossing.at);
        transmittance.passSurface(crossing);
    }
    passSlabsBefore(shown.to);
    return transmittance.mostSeen();
}

} // namespace tetra
