// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace tetra {

/// The files opened last, and the addresses, newest first, at most ten, kept in the user's settings; files that are
/// gone are left out, and those of samples, which lie where no user looks.
QStringList recentFiles();
void addRecentFile(const QString& path);
void forgetRecentFiles();

} // namespace tetra
