// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/editor_page.h"

#include "plugins/api/editor.h"
#include "plugins/host/plugin_call.h"
#include "plugins/widgets/scrolled_column.h"
#include "ui/panels/session_editor_host.h"
#include "ui/session/message_text.h"

#include <QCoreApplication>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>

namespace tetra {
namespace {

class EditorPage {
    Q_DECLARE_TR_FUNCTIONS(EditorPage)
};

QWidget* makeReasonPage(const std::string& id, const Message& reason)
{
    auto* text =
        new QLabel(EditorPage::tr("The editor cannot be used. %1").arg(translatedMessage(reason)) + "\n\n" +
                   EditorPage::tr("Help › Plugins lists all plugins and the folders that are searched for them."));
    text->setObjectName(QString::fromStdString(id) + ".missing");
    text->setWordWrap(true);
    text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    text->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    text->setMargin(9);
    return new ScrolledColumn(text);
}

QString hintOf(const Workbench& workbench, bool canBeEdited)
{
    const std::string& id = workbench.session().view().appearance.mode;
    const auto& modes = workbench.scenes().modes();
    const auto mode = std::ranges::find(modes, id, &Provided<Renderer>::id);
    const QString name = mode != modes.end() ? inUsersLanguage(mode->name, mode->names) : QString::fromStdString(id);
    return canBeEdited ? EditorPage::tr("The mode %1 does not use a transfer function. Changes appear in other modes.")
                             .arg(name)
                       : EditorPage::tr("The mode %1 has nothing to edit here. Choose another mode.").arg(name);
}

/// The editor below its hint, which is seen only where it is needed.
QWidget* makePage(Workbench& workbench, SessionEditorHost& host, const std::string& id, const std::string& type,
                  QWidget* editor)
{
    auto* page = new QWidget;
    auto* hint = new QLabel;
    hint->setObjectName(QString::fromStdString(id) + ".hint");
    hint->setWordWrap(true);
    hint->setMargin(9);
    hint->setForegroundRole(QPalette::PlaceholderText);
    // The editor may enable and disable itself: this is around it.
    auto* frame = new QWidget;
    auto* inner = new QVBoxLayout(frame);
    inner->setContentsMargins({});
    inner->addWidget(editor);
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins({});
    column->setSpacing(0);
    column->addWidget(hint);
    column->addWidget(frame, 1);
    const bool isAlwaysThere = type == parameterTypeName(TransferFunction());
    const auto follow = [&workbench, &host, hint, frame, isAlwaysThere] {
        const bool isLacking = host.hasModel() && host.parameters().empty();
        hint->setVisible(isLacking);
        if (isLacking)
            hint->setText(hintOf(workbench, isAlwaysThere));
        frame->setEnabled(!isLacking || isAlwaysThere);
    };
    host.whenChanged(page, [follow](EditorChange change) {
        if (change == EditorChange::Model || change == EditorChange::Value)
            follow();
    });
    follow();
    return page;
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
    return *widget != nullptr ? makePage(workbench, *host, id, type, *widget)
                              : makeReasonPage(id, Message::say("It returned no widget. Please tell its author."));
}

} // namespace tetra
