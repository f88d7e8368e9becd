// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/gl/region_in_view.h"

#include <Eigen/LU>

#include <algorithm>
#include <variant>

namespace tetra {
namespace {

/// Layers of the fine volume in the border on either side. Blending cannot mix the two volumes, so they are drawn in
/// turn. As layers of one begin in the middle of those of the other, what comes too early makes up for what comes too
/// late.
constexpr int fineLayers = 2;

} // namespace

RegionInView regionInView(const FocusVolume& focus, const VolumeView& view)
{
    const Eigen::Matrix3d worldFromImage = view.imageFromWorld.leftCols<3>().inverse();
    Eigen::Vector3d centre, size;
    const Sphere* const ball = std::get_if<Sphere>(&focus.region);
    if (ball != nullptr) {
        centre = ball->centre;
        size.setConstant(std::max(0.0, ball->radius));
    } else {
        const Box& box = std::get<Box>(focus.region);
        centre = (box.least + box.largest) / 2;
        size = (box.largest - box.least).cwiseMax(0) / 2;
    }
    const Eigen::Vector3d fromImage = -(worldFromImage * view.imageFromWorld.col(3)) - centre;
    RegionInView region;
    region.ball = ball != nullptr;
    region.size = (size / view.unit).cast<float>();
    region.border = static_cast<float>(std::max(0.0, focus.border) / view.unit);
    region.fromImage = (fromImage / view.unit).cast<float>();
    region.worldFromImage = (worldFromImage / view.unit).cast<float>();
    return region;
}

std::vector<VolumePart> partsOf(const std::optional<RegionInView>& region)
{
    using Place = VolumePart::Place;
    if (!region)
        return {{Place::Whole}};
    std::vector<VolumePart> parts;
    const auto addLayer = [&](Place place, bool fine, float begin, float end) {
        const float first = std::max(0.0f, begin), last = std::min(1.0f, end);
        parts.push_back({place, fine, {first, last}});
    };
    const auto addBorder = [&](Place place) {
        for (int layer = 0; layer <= fineLayers && region->border > 0; ++layer) {
            const auto number = static_cast<float>(layer);
            addLayer(place, false, (number - 0.5f) / fineLayers, (number + 0.5f) / fineLayers);
            if (layer < fineLayers)
                addLayer(place, true, number / fineLayers, (number + 1) / fineLayers);
        }
    };
    parts.push_back({Place::Before});
    addBorder(Place::FrontBorder);
    parts.push_back({Place::Within, true});
    addBorder(Place::BackBorder);
    parts.push_back({Place::Behind});
    return parts;
}

void setRegion(const GlProgram& program, const std::optional<RegionInView>& region)
{
    const RegionInView& used = region ? *region : RegionInView{};
    program.set("ball", used.ball ? 1 : 0);
    program.set("regionSize", used.size);
    program.set("border", used.border);
    program.set("regionFromImage", used.fromImage);
    program.set("worldFromImage", used.worldFromImage);
}

void setPart(const GlProgram& program, const VolumePart& part)
{
    program.set("focusPart", static_cast<int>(part.place));
    program.set("fine", part.fine ? 1 : 0);
    program.set("borderShares", part.shares);
}

} // namespace tetra
