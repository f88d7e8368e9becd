// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/host/plugin_host.h"

#include <QDialog>

namespace tetra {

/// Lists the plugins that were found, with their state and, for those that cannot be used, the reason and the remedy.
class PluginWindow : public QDialog {
    Q_OBJECT
public:
    explicit PluginWindow(const PluginHost& host, QWidget* parent = nullptr);
};

/// The plugins that cannot be used, as messages for the user.
QStringList pluginErrors(const PluginHost& host);

} // namespace tetra
