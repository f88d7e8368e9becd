// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace tetra {

/// The first page of the manual that belongs to the program in `programFolder`, as installed or as built; empty if it
/// is not there.
QString manualPage(const QString& programFolder);

/// Shows the manual in the user's web browser. Returns nothing, or why that is impossible and what to do, for the user.
QString openManual(const QString& programFolder);

} // namespace tetra
