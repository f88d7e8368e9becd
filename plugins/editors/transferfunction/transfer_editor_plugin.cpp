// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/api/editor.h"
#include "plugins/editors/transferfunction/transfer_panel.h"

#include <QObject>

/// The plugin's root object.
class TransferFunctionEditorPlugin : public QObject, public tetra::Editor {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID TAN_EDITOR_INTERFACE FILE "transfer_editor.json")
    Q_INTERFACES(tetra::Editor)
public:
    QWidget* makeWidget(tetra::EditorHost& host) const override { return new tetra::TransferPanel(host); }
};

#include "transfer_editor_plugin.moc"
