// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/gl/mesh_order.h"

#include "core/graphics/volume/order_drift.h"

namespace tetra {

bool MeshOrder::fits(const VolumeMesh& mesh, const Camera& camera, const VolumeView& view, double tolerance) const
{
    if (!view_)
        return false;
    const double drift = orderDrift(mesh.bounds, camera_, camera);
    if (drift <= tolerance && (tolerance > 0 || mesh.convex))
        return true;
    // The gaps of a domain that is not convex are in the order as the samples of one picture meet them.
    return drift == 0 && view.imageFromWorld == view_->imageFromWorld && view.width == view_->width &&
           view.height == view_->height;
}

Result<bool> MeshOrder::fit(const VolumeMesh& mesh, const Camera& camera, const VolumeOptions& options,
                            double tolerance, const Progress& progress)
{
    const VolumeView view = makeVolumeView(camera, options.width, options.height, mesh.bounds);
    if (fits(mesh, camera, view, tolerance))
        return false;
    Result<VisibilityOrder> order = orderForCamera(mesh, camera, options, progress);
    if (!order)
        return order.error();
    order_ = std::move(*order);
    camera_ = camera;
    view_ = view;
    return true;
}

} // namespace tetra
