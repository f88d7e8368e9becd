// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace tetra {

class Session;

/// Adds a bookmark of what is seen, with a name that no other has; nothing without a model, or if there are too many.
/// Its name.
QString addBookmark(Session& session);

/// Shows a bookmark, as one step to undo; nothing if there is none of this number.
void showBookmark(Session& session, int index);

} // namespace tetra
