// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/render.h>

#include <QImage>

namespace tetra {

/// The same pixels as Qt's image; null if memory is short. O(pixels).
QImage imageOf(const Picture& picture);

} // namespace tetra
