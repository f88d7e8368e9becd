// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/plot3d/plot3d_writer.h"

#include <QObject>

/// The plugin's root object.
class Plot3dWriterPlugin : public QObject, public tetra::Plot3dWriter {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID TAN_WRITER_INTERFACE FILE "plot3d_writer.json")
    Q_INTERFACES(tetra::Writer)
};

#include "plot3d_writer_plugin.moc"
