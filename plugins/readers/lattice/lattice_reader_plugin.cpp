// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/lattice_reader.h"

#include <QObject>

/// The plugin's root object.
class LatticeReaderPlugin : public QObject, public tetra::LatticeReader {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID TAN_READER_INTERFACE FILE "lattice_reader.json")
    Q_INTERFACES(tetra::Reader)
};

#include "lattice_reader_plugin.moc"
