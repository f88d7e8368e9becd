// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/gl/clip_planes.h"

#include <string>
#include <vector>

namespace tetra {

Status checkClipPlanes(std::span<const ClipPlane> planes)
{
    if (planes.size() > largestClipPlaneCount)
        return Error{ErrorKind::OutOfResource, "OpenGL cuts scenes by at most " +
                                                   std::to_string(largestClipPlaneCount) +
                                                   " planes. Take fewer, or use the CPU back end."};
    return {};
}

void setCuts(const GlProgram& program, std::span<const ClipPlane> planes, const Eigen::Vector3d& origin)
{
    std::vector<Eigen::Vector4f> cuts;
    for (const ClipPlane& plane : planes) {
        const Eigen::Vector3f normal = plane.normal.cast<float>();
        cuts.emplace_back(normal.x(), normal.y(), normal.z(),
                          static_cast<float>(plane.normal.dot(origin) - plane.offset));
    }
    program.set("cutCount", static_cast<int>(cuts.size()));
    program.set("cuts", cuts);
}

} // namespace tetra
