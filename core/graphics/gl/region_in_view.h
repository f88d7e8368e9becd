// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/gl/gl_program.h"
#include "core/graphics/scene.h"
#include "core/graphics/volume/volume_view.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace tetra {

/// The region of a focus as focus.frag wants it: lengths in units of w (VolumeView), places from its middle.
struct RegionInView {
    bool ball = false;
    Eigen::Vector3f size{0, 0, 0}; ///< half of a box; of a ball the radius, in each coordinate
    float border = 0;
    Eigen::Vector3f fromImage{0, 0, 0}; ///< where the image (0, 0, 0) is
    Eigen::Matrix3f worldFromImage = Eigen::Matrix3f::Identity();
};

RegionInView regionInView(const FocusVolume& focus, const VolumeView& view);

/// A part of each ray, of one of the two volumes. The numbers of places are those of focus.frag.
struct VolumePart {
    enum class Place { Whole, Before, FrontBorder, Within, BackBorder, Behind };
    Place place = Place::Whole;
    bool fine = false;
    Eigen::Vector2f shares{0, 1}; ///< of the way through the border on one side, where the part begins and ends
};

/// What a volume with a focus, or without, is drawn in, front to back.
std::vector<VolumePart> partsOf(const std::optional<RegionInView>& region);

/// Sets the uniforms of focus.frag in the program in use.
void setRegion(const GlProgram& program, const std::optional<RegionInView>& region);
void setPart(const GlProgram& program, const VolumePart& part);

} // namespace tetra
