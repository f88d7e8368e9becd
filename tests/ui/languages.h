// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/language.h"

#include <QCoreApplication>
#include <QTest>
#include <QTranslator>

namespace tetra {

/// Adds a row of test data for each language of the program, its code.
inline void addLanguageRows()
{
    QTest::addColumn<QString>("language");
    for (const Language& language : languages())
        QTest::newRow(language.code) << QString(language.code);
}

/// The program speaks this language as long as it lives.
class Speaking {
public:
    explicit Speaking(const QString& language)
    {
        if (translator_.load(QLocale(language), "tan", "_", ":/i18n"))
            QCoreApplication::installTranslator(&translator_);
    }
    ~Speaking() { QCoreApplication::removeTranslator(&translator_); }
    Speaking(const Speaking&) = delete;
    Speaking& operator=(const Speaking&) = delete;

private:
    QTranslator translator_;
};

} // namespace tetra
