// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/tool.h"

#include <Eigen/Core>

#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// Places that are measured: one, the two ends of a distance, or three of an angle, whose vertex is the second.
using Ruler = std::vector<Eigen::Vector3d>;

/// What the ruler keeps: "x,y,z x,y,z; x,y,z", a ruler between semicolons. With one at its end the last ruler is
/// complete, and the next click begins another.
struct Rulers {
    std::vector<Ruler> all;
    bool complete = false; ///< the last one gets no further place
    bool operator==(const Rulers&) const = default;
};

/// Without what is no ruler: numbers that are none, more than three places.
Rulers rulersFromText(std::string_view text);
std::string rulersToText(const Rulers& rulers);

/// In degrees, at the second of three places; 0 where one of the other two lies there.
double angleOf(const Ruler& ruler);

/// Clicks measure distances, and a third one the angle. A place is where something is seen, or else in the plane of the
/// picture through the camera's target.
class RulerTool : public Tool {
public:
    ToolLook look() const override;
    ToolDrawing drawing(const ToolSurroundings& surroundings) const override;
    ToolAnswer clicked(const ToolSurroundings& surroundings, const ToolPointer& pointer) const override;
    ToolAnswer moved(const ToolSurroundings& surroundings, const HandleMove& move) const override;
    std::vector<ToolReading> readings(const ToolSurroundings& surroundings) const override;
    std::vector<ToolCommand> commands(const ToolSurroundings& surroundings) const override;
    ToolAnswer commanded(const ToolSurroundings& surroundings, const std::string& id) const override;
};

} // namespace tetra
