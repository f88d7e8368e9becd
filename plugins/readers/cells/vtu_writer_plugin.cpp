// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/cells/vtu_writer.h"

#include <QObject>

/// The plugin's root object.
class VtuWriterPlugin : public QObject, public tetra::VtuWriter {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID TAN_WRITER_INTERFACE FILE "vtu_writer.json")
    Q_INTERFACES(tetra::Writer)
};

#include "vtu_writer_plugin.moc"
