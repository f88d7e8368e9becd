// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/host/plugin_host.h"

#include <QLocale>
#include <QString>

#include <memory>
#include <span>
#include <vector>

class QTranslator;

namespace tetra {

/// A language that the program speaks.
struct Language {
    const char* code; ///< ISO 639
    const char* name; ///< in that language
};

std::span<const Language> languages();

/// The code of the language that the user chose; empty: that of the system.
QString chosenLanguage();
/// Holds from the next start on.
void chooseLanguage(const QString& code);

/// Whose texts are shown. Numbers are written as the system has it in any case.
QLocale textLocale();

/// The translations that plugins bring: beside the library of each, a file that is called like it, with the language:
/// "mine_de.qm" beside "mine.so". Of plugins that cannot be used, too, which are listed; none for those without a file.
std::vector<std::unique_ptr<QTranslator>> pluginTranslators(const PluginHost& host, const QLocale& locale);

/// Installs `translators`, behind `ours`, so that no plugin changes what the program says itself.
void installBehind(const std::vector<std::unique_ptr<QTranslator>>& translators, QTranslator& ours);

} // namespace tetra
