// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/renderers/focus/focus_renderer.h"

#include <QObject>

/// The plugin's root object.
class FocusRendererPlugin : public QObject, public tetra::FocusRenderer {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID TAN_RENDERER_INTERFACE FILE "focus_renderer.json")
    Q_INTERFACES(tetra::Renderer)
};

#include "focus_renderer_plugin.moc"
