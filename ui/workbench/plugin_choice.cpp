// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workbench/plugin_choice.h"

#include "plugins/host/file_saving.h"
#include "plugins/host/plugin_folders.h"
#include "ui/session/files.h"
#include "ui/session/message_text.h"

#include <QCoreApplication>
#include <QSettings>
#include <QStringList>

#include <algorithm>

namespace tetra {
namespace {

constexpr const char* disabledPluginsKey = "plugins/disabled";

QString asQString(std::string_view utf8)
{
    return QString::fromUtf8(utf8.data(), static_cast<qsizetype>(utf8.size()));
}

class PluginChoice {
    Q_DECLARE_TR_FUNCTIONS(PluginChoice)
};

QString filterOf(const FileFormat& format)
{
    QStringList patterns;
    for (const std::string& ending : format.endings)
        patterns.append("*" + asQString(ending));
    return translatedText(format.name) + " (" + patterns.join(' ') + ")";
}

} // namespace

std::vector<std::string> unwantedPlugins()
{
    std::vector<std::string> ids;
    for (const QString& id : QSettings().value(disabledPluginsKey).toStringList())
        ids.push_back(id.toStdString());
    return ids;
}

void setPluginWanted(const std::string& id, bool wanted)
{
    QSettings settings;
    QStringList ids = settings.value(disabledPluginsKey).toStringList();
    ids.removeAll(asQString(id));
    if (!wanted)
        ids.append(asQString(id));
    settings.setValue(disabledPluginsKey, ids);
}

std::unique_ptr<PluginHost> wantedPlugins()
{
    PluginHostOptions options{.folders = pluginFolders(filePath(QCoreApplication::applicationDirPath())),
                              .disabled = disabledPlugins()};
    for (std::string& id : unwantedPlugins())
        options.disabled.push_back(std::move(id));
    options.build.qt = parseVersion(qVersion()).value_or(Version{}); // which editors need
    return std::make_unique<PluginHost>(std::move(options));
}

QString pluginReport(const PluginHost& host)
{
    QString report;
    for (const PluginStatus& plugin : host.plugins()) {
        const PluginMetadata& data = plugin.metadata;
        QStringList line{asQString(data.name), asQString(data.id)};
        if (plugin.hasMetadata)
            line << asQString(pluginKindName(data.kind)) << asQString(toText(data.version))
                 << asQString(data.interface);
        line << asQString(pluginStateName(plugin.state)) << pathText(plugin.path) << asQString(plugin.error.text());
        report += line.join('\t') + '\n';
    }
    for (const auto& folder : host.folders())
        report += pathText(folder) + '\n';
    return report;
}

QStringList fileFilters(PluginHost& host, WrittenContent content)
{
    QStringList filters;
    std::vector<std::string> endings;
    for (const FileFormat& format : writableFormats(host, content)) {
        filters.append(filterOf(format));
        endings.insert(endings.end(), format.endings.begin(), format.endings.end());
    }
    if (content != WrittenContent::Mesh)
        return filters;
    for (const FileFormat& format : writableFormats(host, WrittenContent::Surface))
        if (std::ranges::find(endings, format.endings.front()) == endings.end())
            filters.append(PluginChoice::tr("Boundary: %1").arg(filterOf(format)));
    return filters;
}

} // namespace tetra
