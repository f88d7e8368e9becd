// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/language.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QSettings>
#include <QTranslator>

#include <array>

namespace tetra {
namespace {

constexpr const char* languageKey = "language";
constexpr std::array known{Language{"en", "English"}, Language{"de", "Deutsch"}, Language{"it", "Italiano"}};

} // namespace

std::span<const Language> languages()
{
    return known;
}

QString chosenLanguage()
{
    return QSettings().value(languageKey).toString();
}

void chooseLanguage(const QString& code)
{
    QSettings().setValue(languageKey, code);
}

QLocale textLocale()
{
    const QString code = chosenLanguage();
    return code.isEmpty() ? QLocale() : QLocale(code);
}

std::vector<std::unique_ptr<QTranslator>> pluginTranslators(const PluginHost& host, const QLocale& locale)
{
    std::vector<std::unique_ptr<QTranslator>> translators;
    for (const PluginStatus& plugin : host.plugins()) {
        const QFileInfo library(QFile::decodeName(plugin.path.c_str()));
        auto translator = std::make_unique<QTranslator>();
        if (translator->load(locale, library.completeBaseName(), "_", library.path()))
            translators.push_back(std::move(translator));
    }
    return translators;
}

/// The translator that was installed last is asked first.
void installBehind(const std::vector<std::unique_ptr<QTranslator>>& translators, QTranslator& ours)
{
    if (translators.empty())
        return;
    const bool isInstalled = QCoreApplication::removeTranslator(&ours);
    for (const auto& translator : translators)
        QCoreApplication::installTranslator(translator.get());
    if (isInstalled)
        QCoreApplication::installTranslator(&ours);
}

} // namespace tetra
