// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/plugin_window.h"

#include "ui/session/plugin_texts.h"
#include "ui/session/target_path.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace tetra {
namespace {

QString text(std::string_view utf8)
{
    return QString::fromUtf8(utf8.data(), static_cast<qsizetype>(utf8.size()));
}

QTreeWidgetItem* itemFor(const PluginStatus& plugin)
{
    const QString name = plugin.hasMetadata ? pluginText(plugin.metadata.name) : text(plugin.metadata.id);
    const QString kind = plugin.hasMetadata ? pluginText(std::string(pluginKindName(plugin.metadata.kind))) : QString();
    const QString state = pluginText(std::string(pluginStateName(plugin.state)));
    auto* item = new QTreeWidgetItem({name, kind, state, text(plugin.error)});
    const QString description = pluginText(plugin.metadata.description);
    item->setToolTip(0, description.isEmpty() ? pathText(plugin.path) : description + "\n" + pathText(plugin.path));
    item->setToolTip(3, text(plugin.error));
    return item;
}

} // namespace

PluginWindow::PluginWindow(const PluginHost& host, QWidget* parent) : QDialog(parent)
{
    setObjectName("pluginWindow");
    setWindowTitle(tr("Plugins"));
    resize(640, 320);
    auto* list = new QTreeWidget;
    list->setObjectName("plugins.list");
    list->setRootIsDecorated(false);
    list->setAlternatingRowColors(true);
    list->setHeaderLabels({tr("Plugin"), tr("Kind"), tr("State"), tr("Reason")});
    for (const PluginStatus& plugin : host.plugins())
        list->addTopLevelItem(itemFor(plugin));
    for (int column = 0; column < 3; ++column)
        list->resizeColumnToContents(column);
    QStringList folders;
    for (const auto& folder : host.folders())
        folders.append(pathText(folder));
    auto* where = new QLabel(tr("Looked for in: %1").arg(folders.join(", ")));
    where->setWordWrap(true);
    where->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(list);
    layout->addWidget(where);
    layout->addWidget(buttons);
}

QStringList pluginErrors(const PluginHost& host)
{
    QStringList errors;
    for (const PluginStatus& plugin : host.plugins())
        if (plugin.state == PluginState::Refused)
            errors.append(
                PluginWindow::tr("The plugin %1 cannot be used. %2").arg(text(plugin.metadata.id), text(plugin.error)));
    return errors;
}

} // namespace tetra
