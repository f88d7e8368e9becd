// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/api/editor.h"
#include "plugins/api/plugin.h"
#include "plugins/editors/transferfunction/transfer_panel.h"

/// The plugin's root object.
class TransferFunctionEditorPlugin : public tetra::Editor {
public:
    QWidget* makeWidget(tetra::EditorHost& host) const override { return new tetra::TransferPanel(host); }
};

TAN_PLUGIN(TransferFunctionEditorPlugin, tetra::Editor)
