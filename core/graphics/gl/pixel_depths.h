// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/gl/sample_view.h"

#include <span>
#include <vector>

namespace tetra {

/// Picture::depth from the depths of samples as OpenGL has them: in [0, 1], rows upwards, 1 for nothing. Changes them.
std::vector<float> pixelDepths(std::span<float> samples, const SampleView& view, int samplesPerAxis);

} // namespace tetra
