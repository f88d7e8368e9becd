// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/camera_controls.h"

#include <QCoreApplication>
#include <QKeyEvent>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tetra {
namespace {

class CameraTexts {
    Q_DECLARE_TR_FUNCTIONS(Camera)
};

constexpr double degreesPerPixel = 0.4;
constexpr double degreesPerKey = 5;
constexpr double finePart = 0.2;   ///< of a step, with Ctrl
constexpr double panPerKey = 0.05; ///< of the view's shorter side
constexpr double zoomPerNotch = 1.15;
constexpr double ballRadius = 0.4; ///< of the view's shorter side

/// From pixels, y down, to the picture before it was rolled, y up.
QPointF withoutRoll(const Camera& camera, QPointF pixels)
{
    const double roll = camera.roll * (std::numbers::pi / 180);
    return {pixels.x() * std::cos(roll) + pixels.y() * std::sin(roll),
            pixels.x() * std::sin(roll) - pixels.y() * std::cos(roll)};
}

/// The place on the trackball under the pointer, in the eye's directions.
Eigen::Vector3d onBall(QPointF pointer, QSizeF size)
{
    const double radius = ballRadius * std::max(1.0, std::min(size.width(), size.height()));
    const Eigen::Vector2d beside =
        Eigen::Vector2d(pointer.x() - size.width() / 2, size.height() / 2 - pointer.y()) / radius;
    const double squared = beside.squaredNorm();
    const double height = squared < 0.5 ? std::sqrt(1 - squared) : 0.5 / std::sqrt(squared);
    return {beside.x(), beside.y(), height};
}

Camera turnedByKey(const Camera& camera, double right, double up)
{
    if (!camera.trackball) {
        const QPointF level = withoutRoll(camera, {right, -up});
        return turned(camera, level.x(), level.y());
    }
    const double angle = std::hypot(right, up) * (std::numbers::pi / 180);
    const Eigen::Vector3d axis = Eigen::Vector3d(up, -right, 0).normalized();
    return rotated(camera, Eigen::AngleAxisd(angle, axis).toRotationMatrix());
}

} // namespace

Camera seenFrom(const Camera& camera, NamedView view)
{
    Camera result = camera;
    result.elevation = 0;
    switch (view) {
    case NamedView::Front: result.azimuth = 0; break;
    case NamedView::Right: result.azimuth = 90; break;
    case NamedView::Back: result.azimuth = 180; break;
    case NamedView::Left: result.azimuth = 270; break;
    case NamedView::Top:
        result.azimuth = 0;
        result.elevation = 90;
        break;
    case NamedView::Bottom:
        result.azimuth = 0;
        result.elevation = -90;
        break;
    case NamedView::Corner:
        result.azimuth = Camera{}.azimuth;
        result.elevation = Camera{}.elevation;
        break;
    }
    return result;
}

QString upAxisText(UpAxis up)
{
    const auto index = static_cast<int>(up);
    const QChar axis = QLatin1Char(static_cast<char>('x' + index / 2));
    return index % 2 == 0 ? CameraTexts::tr("%1 Up").arg(axis) : CameraTexts::tr("%1 Down").arg(axis);
}

Camera turnedByDrag(const Camera& camera, QPointF from, QPointF to, QSizeF size)
{
    if (camera.trackball)
        return rotated(camera,
                       Eigen::Quaterniond::FromTwoVectors(onBall(from, size), onBall(to, size)).toRotationMatrix());
    const QPointF level = withoutRoll(camera, to - from);
    return turned(camera, -level.x() * degreesPerPixel, -level.y() * degreesPerPixel);
}

Camera pannedByDrag(const Camera& camera, QPointF pixels, QSizeF size)
{
    const double shorter = std::max(1.0, std::min(size.width(), size.height()));
    return panned(camera, -pixels.x() / shorter, pixels.y() / shorter);
}

Camera zoomedByWheel(const Camera& camera, double angle)
{
    return zoomed(camera, std::pow(zoomPerNotch, -angle / 120));
}

Camera zoomedByPinch(const Camera& camera, double factor)
{
    return zoomed(camera, 1 / std::clamp(factor, 0.1, 10.0));
}

Camera between(const Camera& from, const Camera& to, double part)
{
    if (part >= 1)
        return to;
    const auto mixed = [part](double first, double second) { return first + part * (second - first); };
    Camera result = to;
    result.target = from.target + part * (to.target - from.target);
    result.distance = from.distance * std::pow(to.distance / from.distance, part);
    result.fieldOfView = mixed(from.fieldOfView, to.fieldOfView);
    if (from.up != to.up || from.roll != to.roll) {
        const Eigen::Quaterniond start(eyeAxes(from)), end(eyeAxes(to));
        return withEyeAxes(result, start.slerp(part, end).toRotationMatrix());
    }
    result.azimuth = from.azimuth + part * std::remainder(to.azimuth - from.azimuth, 360.0);
    result.elevation = mixed(from.elevation, to.elevation);
    return result;
}

std::optional<Camera> movedByKey(const Camera& camera, const QKeyEvent& event)
{
    const double step = event.modifiers().testFlag(Qt::ControlModifier) ? finePart : 1;
    const bool pan = event.modifiers().testFlag(Qt::ShiftModifier);
    const bool roll = event.modifiers().testFlag(Qt::AltModifier);
    const auto move = [&](double right, double up) -> std::optional<Camera> {
        if (roll)
            return right != 0 ? std::optional(rolled(camera, right * degreesPerKey * step)) : std::nullopt;
        return pan ? panned(camera, right * panPerKey * step, up * panPerKey * step)
                   : turnedByKey(camera, right * degreesPerKey * step, up * degreesPerKey * step);
    };
    switch (event.key()) {
    case Qt::Key_Left: return move(-1, 0);
    case Qt::Key_Right: return move(1, 0);
    case Qt::Key_Up: return move(0, 1);
    case Qt::Key_Down: return move(0, -1);
    case Qt::Key_Plus:
    case Qt::Key_Equal: return zoomed(camera, std::pow(zoomPerNotch, -step));
    case Qt::Key_Minus:
    case Qt::Key_Underscore: return zoomed(camera, std::pow(zoomPerNotch, step));
    default: return std::nullopt;
    }
}

} // namespace tetra
