// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/picking/picking.h"
#include "ui/work/latest_job.h"

#include <tan/render.h>

#include <functional>
#include <memory>
#include <optional>

namespace tetra {

/// What is seen along a line of sight, looked for in a worker: O(triangles) and tetrahedra of the scene, too long for
/// the GUI thread. One line at a time; the newest takes the place of the one before. Nothing is found where nothing is
/// seen, and where the memory is too small to look.
class ScenePick : public QObject {
    Q_OBJECT
public:
    using Found = std::function<void(const std::optional<SeenPlace>&)>;

    using QObject::QObject;

    /// `found` is called in this thread, unless another line is asked about before, or forget() is called.
    void find(std::shared_ptr<const Scene> scene, const PickingRay& line, Found found);
    void forget();
    bool busy() const noexcept { return newest_ != done_; }

private:
    quint64 newest_ = 0; ///< of the numbers of what was looked for
    quint64 done_ = 0;   ///< the newest that is done with
    LatestJob job_;
};

/// The scene without what is no surface: lines, and volumes, which have no place that one could point at.
std::shared_ptr<const Scene> surfacesOf(const Scene& scene);

} // namespace tetra
