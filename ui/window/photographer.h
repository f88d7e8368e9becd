// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/window/main_window.h"

#include <QDir>
#include <QTemporaryDir>

namespace tetra {

/// Opens a window on a sample and takes pictures of it: of the start, of each panel with what it can show, of each
/// dialog. Colours and language are those of the program.
class Photographer {
public:
    /// Files go to `folder` and begin with `prefix`.
    Photographer(PluginHost& host, QDir folder, QString prefix);

    /// False if something could not be opened or saved.
    bool takeAll();

private:
    bool settled() const;
    void takeMessages();
    void takePanels();
    void takePanel(const QString& dock, const QString& name);
    void takeWholePanel(const QString& dock, const QString& name, const QSize& size);
    void takePanelsAtWork();
    void takeDialogs();
    void takeQuestions();
    /// What an action or another control opens.
    void takeDialog(const QString& dialog, const QString& name);
    void takeImports();
    void take(const QString& name, QWidget& widget);
    QObject* find(const QString& name) const { return window_.findChild<QObject*>(name); }
    void trigger(const QString& action) const;

    QDir folder_;
    QString prefix_;
    QTemporaryDir views_; ///< the sample is seen as at first
    mutable Workbench workbench_;
    MainWindow window_;
    bool isWhole_ = true;
};

} // namespace tetra
