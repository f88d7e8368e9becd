// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/plot3d/plot3d_reader.h"

#include <QObject>

/// The plugin's root object.
class Plot3dReaderPlugin : public QObject, public tetra::Plot3dReader {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID TAN_READER_INTERFACE FILE "plot3d_reader.json")
    Q_INTERFACES(tetra::Reader)
};

#include "plot3d_reader_plugin.moc"
