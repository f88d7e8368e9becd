// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/points/point_reader.h"

#include <QObject>

/// The plugin's root object.
class PointReaderPlugin : public QObject, public tetra::PointReader {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID TAN_READER_INTERFACE FILE "point_reader.json")
    Q_INTERFACES(tetra::Reader)
};

#include "point_reader_plugin.moc"
