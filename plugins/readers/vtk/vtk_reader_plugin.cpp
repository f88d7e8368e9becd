// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/vtk_reader.h"

#include <QObject>

/// The plugin's root object.
class VtkReaderPlugin : public QObject, public tetra::VtkReader {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID TAN_READER_INTERFACE FILE "vtk_reader.json")
    Q_INTERFACES(tetra::Reader)
};

#include "vtk_reader_plugin.moc"
