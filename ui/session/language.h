// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QString>

#include <span>

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

} // namespace tetra
