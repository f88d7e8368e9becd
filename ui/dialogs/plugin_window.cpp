// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/plugin_window.h"

#include "ui/session/files.h"
#include "ui/session/message_text.h"
#include "ui/workbench/plugin_choice.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace tetra {
namespace {

QString qString(std::string_view utf8)
{
    return QString::fromUtf8(utf8.data(), static_cast<qsizetype>(utf8.size()));
}

constexpr int idRole = Qt::UserRole;

/// Those of other reasons come back by themselves once the reason is gone.
bool canBeChosen(const PluginStatus& plugin)
{
    return plugin.hasMetadata && plugin.state != PluginState::Refused;
}

QTreeWidgetItem* itemFor(const PluginStatus& plugin, const std::vector<std::string>& unwanted)
{
    const PluginMetadata& data = plugin.metadata;
    const QString name = plugin.hasMetadata ? inUsersLanguage(data.name, data.names) : qString(data.id);
    const QString kind = plugin.hasMetadata ? translatedMessage(pluginKindText(data.kind)) : QString();
    const QString version = plugin.hasMetadata ? qString(toText(data.version)) : QString();
    const QString state = translatedText(pluginStateName(plugin.state));
    auto* item =
        new QTreeWidgetItem({name, kind, version, state, translatedMessage(plugin.error), pathText(plugin.path)});
    item->setData(0, idRole, qString(data.id));
    if (canBeChosen(plugin))
        item->setCheckState(0, std::ranges::count(unwanted, data.id) > 0 ? Qt::Unchecked : Qt::Checked);
    item->setToolTip(0, inUsersLanguage(data.description, data.descriptions));
    item->setToolTip(4, translatedMessage(plugin.error));
    item->setToolTip(5, pathText(plugin.path));
    return item;
}

} // namespace

PluginWindow::PluginWindow(const PluginHost& host, QWidget* parent)
    : QDialog(parent), list_(new QTreeWidget), atNextStart_(new QLabel)
{
    setObjectName("pluginWindow");
    setWindowTitle(tr("Plugins"));
    resize(820, 420);
    list_->setObjectName("plugins.list");
    list_->setAccessibleName(tr("Plugins"));
    list_->setTextElideMode(Qt::ElideMiddle); // paths differ at their ends
    list_->setToolTip(tr("The plugins found, and why some are not used. Space turns a plugin on or off."));
    list_->setRootIsDecorated(false);
    list_->setAlternatingRowColors(true);
    list_->setHeaderLabels({tr("Plugin"), tr("Kind"), tr("Version"), tr("State"), tr("Reason"), tr("File")});
    const std::vector<std::string> unwanted = unwantedPlugins();
    for (const PluginStatus& plugin : host.plugins())
        list_->addTopLevelItem(itemFor(plugin, unwanted));
    for (int column = 0; column < 4; ++column)
        list_->resizeColumnToContents(column);
    connect(list_, &QTreeWidget::itemChanged, this, &PluginWindow::choose);
    QStringList folders;
    for (const auto& folder : host.folders())
        folders.append(pathText(folder));
    auto* where = new QLabel(tr("Searched in: %1").arg(folders.join(", ")));
    where->setWordWrap(true);
    where->setTextInteractionFlags(Qt::TextSelectableByMouse);
    atNextStart_->setObjectName("plugins.atNextStart");
    atNextStart_->setText(tr("Changes take effect when TAn is restarted."));
    atNextStart_->setWordWrap(true);
    atNextStart_->hide();
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    QPushButton* copy = buttons->addButton(tr("Cop&y"), QDialogButtonBox::ActionRole);
    copy->setObjectName("plugins.copy");
    copy->setToolTip(tr("Copy for a bug report"));
    connect(copy, &QPushButton::clicked, this,
            [report = pluginReport(host)] { QGuiApplication::clipboard()->setText(report); });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(list_);
    layout->addWidget(atNextStart_);
    layout->addWidget(where);
    layout->addWidget(buttons);
}

void PluginWindow::choose(QTreeWidgetItem* item)
{
    setPluginWanted(item->data(0, idRole).toString().toStdString(), item->checkState(0) == Qt::Checked);
    atNextStart_->show();
}

QStringList pluginErrors(const PluginHost& host)
{
    QStringList errors;
    for (const PluginStatus& plugin : host.plugins())
        if (plugin.state == PluginState::Refused)
            errors.append(pluginError(plugin));
    return errors;
}

QString pluginError(const PluginStatus& plugin)
{
    return PluginWindow::tr("The plugin %1 cannot be used. %2")
        .arg(qString(plugin.metadata.id), translatedMessage(plugin.error));
}

} // namespace tetra
