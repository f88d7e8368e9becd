// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/api/editor.h"

#include <QObject>

#include <stdexcept>

/// Throws in place of making a widget.
class FailingEditor : public QObject, public tetra::Editor {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID TAN_EDITOR_INTERFACE FILE "failing_editor.json")
    Q_INTERFACES(tetra::Editor)

public:
    QWidget* makeWidget(tetra::EditorHost&) const override { throw std::runtime_error("no paper left"); }
};

#include "failing_editor.moc"
