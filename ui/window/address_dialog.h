// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/widgets/file_dialogs.h"

namespace tetra {

/// Asks for the address of a model on a server; lets the window work on. Only what is one can be chosen.
void askForAddress(QWidget* parent, const QString& name, const FileChosen& chosen);

} // namespace tetra
