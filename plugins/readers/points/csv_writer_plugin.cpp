// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/points/csv_writer.h"

#include <QObject>

/// The plugin's root object.
class CsvWriterPlugin : public QObject, public tetra::CsvWriter {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID TAN_WRITER_INTERFACE FILE "csv_writer.json")
    Q_INTERFACES(tetra::Writer)
};

#include "csv_writer_plugin.moc"
