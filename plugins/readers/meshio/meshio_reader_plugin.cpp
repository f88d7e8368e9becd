// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/meshio/meshio_reader.h"

#include <QObject>

/// The plugin's root object.
class MeshioReaderPlugin : public QObject, public tetra::MeshioReader {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID TAN_READER_INTERFACE FILE "meshio_reader.json")
    Q_INTERFACES(tetra::Reader)
};

#include "meshio_reader_plugin.moc"
