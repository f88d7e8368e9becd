// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/netcdf/netcdf_reader.h"

#include <QObject>

/// The plugin's root object.
class NetCdfReaderPlugin : public QObject, public tetra::NetCdfReader {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID TAN_READER_INTERFACE FILE "netcdf_reader.json")
    Q_INTERFACES(tetra::Reader)
};

#include "netcdf_reader_plugin.moc"
