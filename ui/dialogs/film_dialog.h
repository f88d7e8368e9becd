// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/workbench/workbench.h"

#include <QDialog>

class QComboBox;
class QLineEdit;
class QProgressBar;
class QPushButton;

namespace tetra {

class PictureForm;
class Viewport;

/// Asks how the session's film is to be written, says how long that will take, and writes it. Stands beside the window,
/// which works on. Named filmOptions, with film.* of PictureForm, film.format, .target, .browse, .summary, .hint,
/// .progress, .remaining, .save, .cancel and .close.
class FilmDialog : public QDialog {
    Q_OBJECT
public:
    /// Both outlive it.
    FilmDialog(Workbench& workbench, Viewport& viewport, QWidget* parent);

    void ask();

protected:
    bool event(QEvent* event) override;

private:
    void addTarget(QLayout& layout);
    void addProgress(QLayout& layout);
    QWidget* makeButtons();
    void connectControls();
    FilmOrder order() const;
    void chooseFormat();
    void browse();
    void tryOnePicture();
    void showSummary();
    void lookAtTarget();
    void showTarget();
    void showProgress(const TaskProgress& progress);
    void showRunning();
    void save();

    Workbench& workbench_;
    Viewport& viewport_;
    QString encoder_;
    PictureForm* form_;
    QComboBox* format_;
    QLineEdit* target_;
    QPushButton* browse_;
    QLabel* hint_;
    QLabel* summary_;
    QProgressBar* progress_;
    QLabel* remaining_;
    QPushButton* save_;
    QPushButton* cancel_;
    int frames_ = 0;             ///< of the film that is being written
    double secondsPerPixel_ = 0; ///< of a picture, as measured; 0 before that
    std::size_t inTheWay_ = 0;   ///< files of the film's name
    LongTask trial_;
    LongTask looking_; ///< for them
};

} // namespace tetra
