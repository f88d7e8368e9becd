// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/zarr/zarr_reader.h"

#include <QObject>

/// The plugin's root object.
class ZarrReaderPlugin : public QObject, public tetra::ZarrReader {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID TAN_READER_INTERFACE FILE "zarr_reader.json")
    Q_INTERFACES(tetra::Reader)
};

#include "zarr_reader_plugin.moc"
