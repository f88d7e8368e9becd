// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/motion.h"

#include <QSettings>
#include <QStyle>
#include <QWidget>

namespace tetra {
namespace {

constexpr const char* motionKey = "reducedMotion";

} // namespace

bool mayGlide(const QWidget& widget)
{
    // This hint is zero where the desktop's own setting says that nothing should move.
    return !motionReduced() && widget.style()->styleHint(QStyle::SH_Widget_Animation_Duration, nullptr, &widget) > 0;
}

bool motionReduced()
{
    return QSettings().value(motionKey, false).toBool();
}

void setMotionReduced(bool reduced)
{
    QSettings().setValue(motionKey, reduced);
}

} // namespace tetra
