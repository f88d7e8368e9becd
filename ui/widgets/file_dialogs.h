// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

#include <functional>

class QWidget;

namespace tetra {

using FileChosen = std::function<void(const QString& path)>;

/// Dialogs that let the window work on; `chosen` is called if the user chooses. Their object name is `name`.
void askForFile(QWidget* parent, const QString& name, const QStringList& filters, const FileChosen& chosen);
void askForPictureFile(QWidget* parent, const QString& name, const QString& proposed, const FileChosen& chosen);
/// A file of one of several kinds, "STL files (*.stl)" ...: at first the one that has the ending of the proposed name.
void askForTargetFile(QWidget* parent, const QString& name, const QString& title, const QStringList& filters,
                      const QString& proposed, const FileChosen& chosen);
void askForStatisticsFile(QWidget* parent, const QString& name, const QString& proposed, const FileChosen& chosen);
/// Files of whatever kind: `title` and `filter` say which. `folder`: where to look first; empty: where the user was
/// last.
void askForTextFile(QWidget* parent, const QString& name, const QString& title, const QString& filter,
                    const FileChosen& chosen, const QString& folder = {});
void askForTextTarget(QWidget* parent, const QString& name, const QString& title, const QString& filter,
                      const QString& proposed, const FileChosen& chosen);

} // namespace tetra
