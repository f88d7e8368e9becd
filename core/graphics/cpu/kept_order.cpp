// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/cpu/kept_order.h"

#include "core/graphics/volume/order_drift.h"
#include "core/graphics/volume/volume_renderer.h"

namespace tetra {

bool KeptOrder::fits(const Request& request) const
{
    if (request.mesh->mesh->tetrahedra.size() != order_.cells.size() || mesh_.lock() != request.mesh)
        return false;
    const bool sameSamples = pictureSize_ == Eigen::Vector2i(request.whole.width, request.whole.height) &&
                             part_ == request.part && camera_ == request.camera;
    if (sameSamples)
        return true;
    const SampleRectangle whole{0, 0, pictureSize_.x(), pictureSize_.y()};
    if (!request.mesh->convex && (request.tolerance <= 0 || part_ != whole))
        return false;
    return orderDrift(request.mesh->bounds, camera_, request.camera) <= request.tolerance;
}

Status KeptOrder::prepare(const Request& request, const Progress& progress)
{
    reused_ = fits(request);
    if (reused_)
        return {};
    mesh_.reset();
    auto order = orderForView(*request.mesh, partOf(request.whole, request.part), progress);
    if (!order)
        return order.error();
    order_ = std::move(order).value();
    mesh_ = request.mesh;
    camera_ = request.camera;
    pictureSize_ = {request.whole.width, request.whole.height};
    part_ = request.part;
    return {};
}

} // namespace tetra
