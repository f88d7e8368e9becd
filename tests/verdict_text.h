// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/verify.h>

#include <QString>
#include <QStringList>

namespace tetra::testing {

/// All that a verification found, a line each, for the message of a failed test.
inline QString textOf(const Result<VerificationReport>& verdict)
{
    if (!verdict)
        return "Error: " + QString::fromStdString(verdict.error().text());
    QStringList texts;
    for (const std::string& text : verdict->failures)
        texts << QString::fromStdString(text);
    for (const LevelReport& level : verdict->levels)
        for (const std::string& text : level.failures)
            texts << QString("%1 %: %2").arg(level.asked.error).arg(QString::fromStdString(text));
    return texts.join('\n');
}

} // namespace tetra::testing
