// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/bench/bench_report.h"
#include "tests/bench/rendering_scenes.h"

#include <vector>

namespace tetra {

/// Pictures of the CPU back end on one thread, each beside one of the volume alone: with isosurfaces in it, with a clip
/// plane, lit, with depth. The visibility order is made beforehand.
std::vector<BenchCase> hybridCases(const RenderingScene& scene, int size);

/// The same scenes by OpenGL without a window while the camera turns, reading back included, each beside the CPU back
/// end on all threads; how far the last pictures differ. None where the machine has no OpenGL, which stderr is told.
std::vector<BenchCase> glCases(const RenderingScene& scene, int size);

} // namespace tetra
