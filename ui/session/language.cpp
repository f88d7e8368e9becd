// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/language.h"

#include <QSettings>

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

} // namespace tetra
