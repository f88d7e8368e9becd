// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/bench/rendering_scenes.h"

#include <QStringList>

#include <map>

namespace tetra {

/// Median seconds a frame of each of VTK's volume mappers, by name: in a process of its own, on `threads` cores, by the
/// Python packages of VTK and under Xvfb. Empty, with a word on stderr, where these are not installed.
std::map<QString, double> timeVtk(const RenderingScene& scene, int size, int threads, const QString& pictureFolder);

/// Median seconds of VTK's vtkContour3DLinearGrid with merged points and normals, without and with its scalar tree,
/// which does not count; in a process of its own likewise.
std::map<QString, double> timeVtkContour(const TetrahedralMesh& mesh, double isovalue, int runs, int threads);

} // namespace tetra
