// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/plugin_choice.h"

#include "plugins/host/plugin_folders.h"
#include "ui/session/target_path.h"

#include <QCoreApplication>
#include <QSettings>
#include <QStringList>

namespace tetra {
namespace {

constexpr const char* key = "plugins/disabled";

QString text(std::string_view utf8)
{
    return QString::fromUtf8(utf8.data(), static_cast<qsizetype>(utf8.size()));
}

} // namespace

std::vector<std::string> unwantedPlugins()
{
    std::vector<std::string> ids;
    for (const QString& id : QSettings().value(key).toStringList())
        ids.push_back(id.toStdString());
    return ids;
}

void setPluginWanted(const std::string& id, bool wanted)
{
    QSettings settings;
    QStringList ids = settings.value(key).toStringList();
    ids.removeAll(text(id));
    if (!wanted)
        ids.append(text(id));
    settings.setValue(key, ids);
}

std::unique_ptr<PluginHost> wantedPlugins()
{
    PluginHostOptions options{.folders = pluginFolders(filePath(QCoreApplication::applicationDirPath())),
                              .disabled = disabledPlugins()};
    for (std::string& id : unwantedPlugins())
        options.disabled.push_back(std::move(id));
    return std::make_unique<PluginHost>(std::move(options));
}

QString pluginReport(const PluginHost& host)
{
    QString report;
    for (const PluginStatus& plugin : host.plugins()) {
        const PluginMetadata& data = plugin.metadata;
        QStringList line{text(data.name), text(data.id)};
        if (plugin.hasMetadata)
            line << text(pluginKindName(data.kind)) << text(toText(data.version)) << text(data.interface);
        line << text(pluginStateName(plugin.state)) << pathText(plugin.path) << text(plugin.error);
        report += line.join('\t') + '\n';
    }
    for (const auto& folder : host.folders())
        report += pathText(folder) + '\n';
    return report;
}

} // namespace tetra
