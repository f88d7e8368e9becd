// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/render.h>

#include <QPointF>
#include <QSizeF>
#include <QString>

#include <optional>

class QKeyEvent;

namespace tetra {

/// The directions from which a domain is looked at by name.
enum class NamedView { Front, Back, Left, Right, Top, Bottom, Corner };

/// `camera` with the direction of `view`; what it looks at, and from how far, stays.
Camera seenFrom(const Camera& camera, NamedView view);

/// "z Up", "z Down" and so on, for menus and lists.
QString upAxisText(UpAxis up);

/// What a drag does in a view of `size` (all in the widget's units): the object follows the pointer. A trackball is
/// turned as if the pointer held it; beside it, a drag around it rolls it (G. Bell's virtual trackball: a sphere that
/// goes over into a hyperboloid).
Camera turnedByDrag(const Camera& camera, QPointF from, QPointF to, QSizeF size);
Camera pannedByDrag(const Camera& camera, QPointF pixels, QSizeF size);
/// `angle` as QWheelEvent gives it, in eighths of a degree: one notch is 120.
Camera zoomedByWheel(const Camera& camera, double angle);

/// `factor` as QNativeGestureEvent and QPinchGesture give it: above 1 where the fingers part.
Camera zoomedByPinch(const Camera& camera, double factor);

/// The camera on its way from one to the other, by the shorter turn, the horizon level if both have the same; `part` in
/// [0, 1].
Camera between(const Camera& from, const Camera& to, double part);

/// What a key does: arrows turn (finer with Ctrl, pan with Shift, roll with Alt), + and - zoom. Nothing for other keys.
std::optional<Camera> movedByKey(const Camera& camera, const QKeyEvent& event);

} // namespace tetra
