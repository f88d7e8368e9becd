// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/tool.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// Points with normal . x = offset; the normal has unit length. Of a clip plane the side that it points to is shown.
struct CutPlane {
    Eigen::Vector3d normal{0, 0, 1};
    double offset = 0;
};

/// Where the plane cuts a box, as a polygon of three to six corners in their order; empty if it does not.
std::vector<Eigen::Vector3d> cutOfBox(const CutPlane& plane, const Eigen::AlignedBox3d& box);

/// The place of the plane that is nearest to the middle of the box: where it is held.
Eigen::Vector3d centreOf(const CutPlane& plane, const Eigen::AlignedBox3d& box);

/// The signed axis that is nearest to a direction.
Eigen::Vector3d nearestAxis(const Eigen::Vector3d& direction);

/// How far along the line from + t normal the place lies that is nearest to a line of sight; 0 if one looks along it.
double alongNormal(const Eigen::Vector3d& from, const Eigen::Vector3d& normal, const ToolPointer& pointer);

/// The place of a sphere that is seen at the pointer, before its centre or behind; beside the sphere the nearest of its
/// places to the line of sight.
Eigen::Vector3d onSphere(const Eigen::Vector3d& centre, double radius, const ToolPointer& pointer, bool before);

/// Clip planes and slices of the rendering mode, moved and turned in the picture. The planes are those of the mode's
/// settings, as they can be typed in the panel Rendering; what the tool keeps is which one it holds: "clip 0",
/// "slices 2", or "clip! 0" where there are slices, too, and clip planes were chosen.
class PlaneTool : public Tool {
public:
    ToolLook look() const override;
    ToolDrawing drawing(const ToolSurroundings& surroundings) const override;
    ToolAnswer clicked(const ToolSurroundings& surroundings, const ToolPointer& pointer) const override;
    ToolAnswer moved(const ToolSurroundings& surroundings, const HandleMove& move) const override;
    std::vector<Parameter> parameters(const ToolSurroundings& surroundings) const override;
    ToolAnswer parameterSet(const ToolSurroundings& surroundings, const std::string& id,
                            const ParameterValue& value) const override;
    std::vector<ToolReading> readings(const ToolSurroundings& surroundings) const override;
    std::vector<ToolCommand> commands(const ToolSurroundings& surroundings) const override;
    ToolAnswer commanded(const ToolSurroundings& surroundings, const std::string& id) const override;
};

} // namespace tetra
