// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/builders/decimation/decimation_builder.h"

#include <QObject>

/// The plugin's root object.
class DecimationBuilderPlugin : public QObject, public tetra::DecimationBuilder {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID TAN_BUILDER_INTERFACE FILE "decimation_builder.json")
    Q_INTERFACES(tetra::Builder)
};

#include "decimation_builder_plugin.moc"
