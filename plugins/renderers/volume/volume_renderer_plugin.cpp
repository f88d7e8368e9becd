// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/renderers/volume/volume_renderer.h"

#include <QObject>

/// The plugin's root object.
class VolumeRendererPlugin : public QObject, public tetra::VolumeRenderer {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID TAN_RENDERER_INTERFACE FILE "volume_renderer.json")
    Q_INTERFACES(tetra::Renderer)
};

#include "volume_renderer_plugin.moc"
