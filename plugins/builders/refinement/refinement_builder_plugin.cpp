// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/builders/refinement/refinement_builder.h"

#include <QObject>

/// The plugin's root object.
class RefinementBuilderPlugin : public QObject, public tetra::RefinementBuilder {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID TAN_BUILDER_INTERFACE FILE "refinement_builder.json")
    Q_INTERFACES(tetra::Builder)
};

#include "refinement_builder_plugin.moc"
