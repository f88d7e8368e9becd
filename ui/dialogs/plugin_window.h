// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/host/plugin_host.h"

#include <QDialog>

class QLabel;
class QTreeWidget;
class QTreeWidgetItem;

namespace tetra {

/// Lists the plugins that were found, with their state and, for those that cannot be used, the reason and the remedy.
/// They can be switched on and off there.
class PluginWindow : public QDialog {
    Q_OBJECT
public:
    explicit PluginWindow(const PluginHost& host, QWidget* parent = nullptr);

private:
    void choose(QTreeWidgetItem* item);

    QTreeWidget* list_;
    QLabel* atNextStart_;
};

/// The plugins that cannot be used, as messages for the user.
QStringList pluginErrors(const PluginHost& host);
QString pluginError(const PluginStatus& plugin);

} // namespace tetra
