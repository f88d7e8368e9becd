// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/sight/seen_place.h"

#include "core/graphics/sight/surface_crossings.h"
#include "core/graphics/sight/volume_slabs.h"

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

/// Less of the light cannot be told from none.
constexpr double leastShare = 1.0 / 255;

/// What is left of the light on its way, and who has taken most so far.
class LightOnItsWay {
public:
    explicit LightOnItsWay(const SightLine& line) : line_(line) {}

    void passSurface(const SurfaceCrossing& crossing, double opacity)
    {
        if (light_ * opacity > surface_.share)
            surface_ = {line_.at(crossing.at), crossing.surface, crossing.value, light_ * opacity};
        light_ *= 1 - opacity;
    }

    void passSlab(const SightSlab& slab)
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

    std::optional<SeenPlace> mostSeen() const
    {
        const SeenPlace& most = surface_.share >= volume_.share ? surface_ : volume_;
        return most.share >= leastShare ? std::optional(most) : std::nullopt;
    }

private:
    void compare(const SightSlab& slab, double within, double rise)
    {
        const double depth = within * (slab.extinctionAtStart + rise * within / 2);
        const double taken = light_ * (slab.extinctionAtStart + rise * within) * std::exp(-depth);
        if (!(taken > mostTaken_))
            return;
        mostTaken_ = taken;
        volume_.place = line_.at(slab.part.from + within);
        volume_.value = std::lerp(slab.valueAtStart, slab.valueAtEnd, within / (slab.part.to - slab.part.from));
    }

    const SightLine& line_;
    double light_ = 1;
    double mostTaken_ = 0; ///< on a unit of length
    SeenPlace surface_;
    SeenPlace volume_; ///< its share is that of all slabs so far
};

/// Where the fine volume counts for at least a half.
SightPart partInFocus(const FocusVolume& focus, const SightLine& line)
{
    const double margin = focus.border / 2;
    if (const auto* sphere = std::get_if<Sphere>(&focus.region))
        return partWithin(line, Sphere{sphere->centre, sphere->radius + margin});
    const Box& box = std::get<Box>(focus.region);
    const Eigen::Vector3d more = Eigen::Vector3d::Constant(margin);
    return partWithin(line, Box{box.least - more, box.largest + more});
}

std::vector<SightSlab> slabsOf(const Scene& scene, const SightLine& line, const SightPart& shown,
                               const Progress& progress)
{
    if (!scene.volume)
        return {};
    const SightPart focused = scene.focus ? partInFocus(*scene.focus, line) : SightPart{1, 0};
    if (focused.isEmpty())
        return slabsAlong(*scene.volume, line, shown, progress);
    const SightPart before{shown.from, std::min(shown.to, focused.from)};
    const SightPart behind{std::max(shown.from, focused.to), shown.to};
    std::vector<SightSlab> slabs = slabsAlong(*scene.volume, line, before, progress);
    std::ranges::copy(slabsAlong(scene.focus->fine, line, common(shown, focused), progress), std::back_inserter(slabs));
    std::ranges::copy(slabsAlong(*scene.volume, line, behind, progress), std::back_inserter(slabs));
    return slabs;
}

/// What of a slab lies before a place, and what is left of it behind.
SightSlab takeBefore(SightSlab& slab, double place)
{
    const double share = (place - slab.part.from) / (slab.part.to - slab.part.from);
    SightSlab before = slab;
    before.part.to = slab.part.from = place;
    before.valueAtEnd = slab.valueAtStart = std::lerp(slab.valueAtStart, slab.valueAtEnd, share);
    before.extinctionAtEnd = slab.extinctionAtStart = std::lerp(slab.extinctionAtStart, slab.extinctionAtEnd, share);
    return before;
}

} // namespace

std::optional<SeenPlace> seenPlace(const Scene& scene, const SightLine& line, const Progress& progress)
{
    const SightPart shown = shownPart(line, scene.clipPlanes);
    if (shown.isEmpty())
        return std::nullopt;
    const std::vector<SurfaceCrossing> crossings = surfaceCrossings(scene.surfaces, line, shown);
    std::vector<SightSlab> slabs = slabsOf(scene, line, shown, progress);
    if (progress.cancelled())
        return std::nullopt;
    LightOnItsWay light(line);
    std::size_t next = 0;
    const auto passSlabsBefore = [&](double place) {
        for (; next < slabs.size() && slabs[next].part.to <= place; ++next)
            light.passSlab(slabs[next]);
        if (next < slabs.size() && slabs[next].part.from < place)
            light.passSlab(takeBefore(slabs[next], place));
    };
    for (const SurfaceCrossing& crossing : crossings) {
        passSlabsBefore(crossing.at);
        light.passSurface(crossing, scene.surfaces[crossing.surface].opacity);
    }
    passSlabsBefore(shown.to);
    return light.mostSeen();
}

} // namespace tetra
