// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QMenu;

namespace tetra {

/// Gives each entry of the menu that has no key of its own yet one that no other has: a letter of its text, a first
/// letter of a word if there is one left. For texts that are not known beforehand: titles, names of plugins.
void giveMnemonics(QMenu& menu);

/// A text of an action, menu or label without the mark of its key.
QString withoutMnemonic(const QString& text);

} // namespace tetra
