// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/accuracy_keys.h"

#include "core/view/accuracy_scale.h"

#include <Qt>

namespace tetra {

std::optional<double> accuracyByKey(double percent, int key)
{
    constexpr int page = 5;
    switch (key) {
    case Qt::Key_Left:
    case Qt::Key_Down: return steppedAccuracy(percent, -1);
    case Qt::Key_Right:
    case Qt::Key_Up: return steppedAccuracy(percent, 1);
    case Qt::Key_PageDown: return steppedAccuracy(percent, -page);
    case Qt::Key_PageUp: return steppedAccuracy(percent, page);
    case Qt::Key_Home: return coarsestOnScale;
    case Qt::Key_End: return 0;
    default: return std::nullopt;
    }
}

} // namespace tetra
