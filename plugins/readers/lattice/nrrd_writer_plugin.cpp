// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/nrrd_writer.h"

#include <QObject>

/// The plugin's root object.
class NrrdWriterPlugin : public QObject, public tetra::NrrdWriter {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID TAN_WRITER_INTERFACE FILE "nrrd_writer.json")
    Q_INTERFACES(tetra::Writer)
};

#include "nrrd_writer_plugin.moc"
