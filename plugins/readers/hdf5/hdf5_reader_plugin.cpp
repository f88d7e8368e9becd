// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/hdf5/hdf5_reader.h"

#include <QObject>

/// The plugin's root object.
class Hdf5ReaderPlugin : public QObject, public tetra::Hdf5Reader {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID TAN_READER_INTERFACE FILE "hdf5_reader.json")
    Q_INTERFACES(tetra::Reader)
};

#include "hdf5_reader_plugin.moc"
