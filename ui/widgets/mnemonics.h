// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QMenu;
class QMenuBar;
class QWidget;

namespace tetra {

/// Gives each entry of the menu that has no key of its own yet one that no other has: a letter of its text, a first
/// letter of a word if there is one left. For texts that are not known beforehand: titles, names of plugins.
void giveMnemonics(QMenu& menu);

/// The same for buttons and for labels with a buddy in a panel: keys that the menu bar or another control of the panel
/// has are replaced. Nobody but the reader of the text needs to know the letter.
void separateMnemonics(QWidget& panel, const QMenuBar& bar);

/// A text of an action, menu or label without the mark of its key.
QString withoutMnemonic(const QString& text);

} // namespace tetra
