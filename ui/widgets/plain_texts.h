// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QApplication;

namespace tetra {

/// From now on all labels, message boxes and tool tips show their texts as they are. Qt would take what looks like HTML
/// for it, and many a text is a file's, a server's or a plugin's: its pictures would be loaded and its links shown.
/// A label that is meant to be HTML says so (Qt::RichText).
void showTextsPlainly(QApplication& application);

} // namespace tetra
