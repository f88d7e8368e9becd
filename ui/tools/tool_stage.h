// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/tool.h"
#include "plugins/host/plugin_host.h"
#include "ui/viewport/view_projection.h"
#include "ui/workbench/workbench.h"

#include <QSizeF>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tetra {

/// What a tool is asked with, held: surroundings that refer to it are good as long as it is there and is not changed.
class ToolStage {
public:
    /// `parameters`: of the rendering mode, those that matter. There must be a model.
    ToolStage(std::string tool, const Session& session, std::vector<Parameter> parameters);

    ToolSurroundings surroundings(const Camera& camera, QSizeF size) const;
    /// What an answer that was given in these surroundings makes of the present view: what it leaves as it is in them
    /// is as it is now. Nothing if it changes nothing.
    std::optional<ViewValue> after(const ToolAnswer& answer, const ViewValue& present) const;
    /// The present view with all as it was in these surroundings, but for the camera.
    ViewValue before(const ViewValue& present) const;
    const ViewValue& view() const noexcept { return view_; }

private:
    std::string tool_;
    std::shared_ptr<const Model> model_;
    ViewValue view_;
    std::string value_;
    std::vector<Parameter> parameters_;
};

/// What is pointed at in a picture, where nobody has looked yet: the place lies in the plane of the picture through the
/// camera's target.
ToolPointer pointerAt(const ViewProjection& projection, const Camera& camera, QPointF pixel);
/// The same with what is seen there.
ToolPointer withSeen(ToolPointer pointer, const SeenThere& seen);
/// Where the line of sight through a pixel meets the plane of the picture through a place.
Eigen::Vector3d inPlaneThrough(const Eigen::Vector3d& place, const ViewProjection& projection, QPointF pixel);

} // namespace tetra
