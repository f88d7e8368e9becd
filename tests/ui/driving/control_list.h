// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>

class QAction;
class QWidget;

namespace tetra {

/// Whatever of `root` somebody can use by mouse or keys, seen or not: without the parts of Qt's own compound widgets,
/// which their owner speaks for, and what only scrolls.
QList<QWidget*> controlsOf(const QWidget& root);

/// The actions of `root` that do something: no separators, no menus, none that Qt's widgets have for themselves.
QList<QAction*> commandsOf(const QWidget& root);

} // namespace tetra
