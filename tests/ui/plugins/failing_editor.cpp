// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/api/editor.h"
#include "plugins/api/plugin.h"

#include <stdexcept>

/// Throws in place of making a widget.
class FailingEditor : public tetra::Editor {
public:
    QWidget* makeWidget(tetra::EditorHost&) const override { throw std::runtime_error("no paper left"); }
};

TAN_PLUGIN(FailingEditor, tetra::Editor)
