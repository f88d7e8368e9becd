// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/renderers/isosurface/isosurface_renderer.h"

#include <QObject>

/// The plugin's root object.
class IsosurfaceRendererPlugin : public QObject, public tetra::IsosurfaceRenderer {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID TAN_RENDERER_INTERFACE FILE "isosurface_renderer.json")
    Q_INTERFACES(tetra::Renderer)
};

#include "isosurface_renderer_plugin.moc"
