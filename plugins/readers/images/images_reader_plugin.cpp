// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/images/images_reader.h"

#include <QObject>

/// The plugin's root object.
class ImagesReaderPlugin : public QObject, public tetra::ImagesReader {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID TAN_READER_INTERFACE FILE "images_reader.json")
    Q_INTERFACES(tetra::Reader)
};

#include "images_reader_plugin.moc"
