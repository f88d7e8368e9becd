// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/volume/volume_view.h"

namespace tetra {

VolumeView makeVolumeView(const Camera& camera, int width, int height, const Eigen::AlignedBox3d& bounds)
{
    const Eigen::Matrix4d view = viewMatrix(camera);
    const Eigen::Matrix4d projection = projectionMatrix(camera, double(width) / height, bounds);
    VolumeView result;
    result.width = width;
    result.height = height;
    result.centre = {width / 2.0, height / 2.0};
    result.perspective = camera.perspective;
    result.unit = camera.distance;
    result.eye = camera.perspective ? eyePosition(camera) : Eigen::Vector3d(view.block<1, 3>(2, 0).transpose());

    const Eigen::Vector2d scale(projection(0, 0) * width / 2, projection(1, 1) * height / 2);
    const double lengths = camera.perspective ? camera.distance : 1;
    result.imageFromWorld.row(0) = view.row(0) * (scale.x() / lengths);
    result.imageFromWorld.row(1) = view.row(1) * (-scale.y() / lengths);
    result.imageFromWorld.row(2) = view.row(2) * (-1 / camera.distance);
    if (camera.perspective) {
        result.samplesPerSlope = scale;
        // projection(2, 2) = -(f + n) / (f - n) and projection(2, 3) = -2 f n / (f - n).
        result.nearest = projection(2, 3) / (projection(2, 2) - 1) / camera.distance;
    }
    return result;
}

VolumeView partOf(const VolumeView& whole, const SampleRectangle& part)
{
    VolumeView result = whole;
    result.width = part.width();
    result.height = part.height();
    result.centre -= Eigen::Vector2d(part.left, part.top);
    return result;
}

} // namespace tetra
