// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/renderers/hybrid/hybrid_renderer.h"

#include <QObject>

/// The plugin's root object.
class HybridRendererPlugin : public QObject, public tetra::HybridRenderer {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID TAN_RENDERER_INTERFACE FILE "hybrid_renderer.json")
    Q_INTERFACES(tetra::Renderer)
};

#include "hybrid_renderer_plugin.moc"
