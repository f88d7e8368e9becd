// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/cells/cells_reader.h"

#include <QObject>

/// The plugin's root object.
class CellsReaderPlugin : public QObject, public tetra::CellsReader {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID TAN_READER_INTERFACE FILE "cells_reader.json")
    Q_INTERFACES(tetra::Reader)
};

#include "cells_reader_plugin.moc"
