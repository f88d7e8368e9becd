// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/camera_controls.h"

#include <QKeyEvent>

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

constexpr double degreesPerPixel = 0.4;
constexpr double degreesPerKey = 5;
constexpr double finePart = 0.2;   ///< of a step, with Ctrl
constexpr double panPerKey = 0.05; ///< of the view's shorter side
constexpr double zoomPerNotch = 1.15;

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

Camera turnedByDrag(const Camera& camera, QPointF pixels)
{
    return turned(camera, -pixels.x() * degreesPerPixel, pixels.y() * degreesPerPixel);
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
    result.azimuth = from.azimuth + part * std::remainder(to.azimuth - from.azimuth, 360.0);
    result.elevation = mixed(from.elevation, to.elevation);
    result.fieldOfView = mixed(from.fieldOfView, to.fieldOfView);
    return result;
}

std::optional<Camera> movedByKey(const Camera& camera, const QKeyEvent& event)
{
    const double step = event.modifiers().testFlag(Qt::ControlModifier) ? finePart : 1;
    const bool pan = event.modifiers().testFlag(Qt::ShiftModifier);
    const auto move = [&](double right, double up) {
        return pan ? panned(camera, right * panPerKey * step, up * panPerKey * step)
                   : turned(camera, right * degreesPerKey * step, up * degreesPerKey * step);
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
