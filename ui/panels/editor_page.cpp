// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/editor_page.h"

#include "plugins/host/plugin_call.h"
#include "plugins/widgets/scrolled_column.h"
#include "ui/panels/session_editor_host.h"
#include "ui/session/message_text.h"

#include <QCoreApplication>
#include <QLabel>
#include <QVBoxLayout>

namespace tetra {
namespace {

class EditorPage {
    Q_DECLARE_TR_FUNCTIONS(EditorPage)
};

QWidget* makeReasonPage(const std::string& id, const Message& reason)
{
    auto* text = new QLabel(EditorPage::tr("The editor cannot be used. %1").arg(translatedMessage(reason)) + "\n\n" +
                            EditorPage::tr("Help › Plugins lists all plugins and where they are looked for."));
    text->setObjectName(QString::fromStdString(id) + ".missing");
    text->setWordWrap(true);
    text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    text->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    text->setMargin(9);
    return new ScrolledColumn(text);
}

} // namespace

QWidget* makeEditorPage(Workbench& workbench, ValuePick& pick, const std::string& id, const std::string& type)
{
    const auto editor = workbench.host().editor(id);
    if (!editor)
        return makeReasonPage(id, editor.error().message);
    auto* host = new SessionEditorHost(workbench, pick, type, &workbench);
    const auto widget = callPlugin(id, [&]() -> Result<QWidget*> { return editor->plugin->makeWidget(*host); });
    if (!widget)
        return makeReasonPage(id, widget.error().message);
    return *widget != nullptr ? *widget
                              : makeReasonPage(id, Message::say("It returned no widget. Please tell its author."));
}

} // namespace tetra
