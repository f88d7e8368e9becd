// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/workbench/workbench.h"

#include <QDialog>

class QCheckBox;
class QPushButton;

namespace tetra {

class KeepSession;
class PictureForm;
class Viewport;

/// Asks how a picture of what is seen is to be, and saves or copies it. Stands beside the window, which works on. Named
/// pictureOptions, with picture.* of PictureForm, picture.metadata, .save, .copy and .close.
class PictureDialog : public QDialog {
    Q_OBJECT
public:
    /// Everything outlives it.
    PictureDialog(Workbench& workbench, Viewport& viewport, const KeepSession& session, QWidget* parent);

    /// Brings it up for what is seen now.
    void ask();

private:
    QWidget* makeButtons();
    PictureOrder order(const std::filesystem::path& target) const;
    void save();
    void copy();

    Workbench& workbench_;
    Viewport& viewport_;
    const KeepSession& session_;
    PictureForm* form_;
    QCheckBox* metadata_;
    QPushButton* save_ = nullptr;
};

} // namespace tetra
