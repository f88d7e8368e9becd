// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/ui/window_fixture.h"

class QDockWidget;
class QToolButton;

namespace tetra {

/// A window with a small model and a dataset open, for tests that do one thing after the other in it and go back to the
/// beginning in between.
class DrivenWindow : public WindowFixture {
public:
    /// `volume`: the file of a dataset.
    DrivenWindow(QString model, QString volume);

    /// Closes what is open beside the window and brings back what was there at first: the model and the dataset, one
    /// isovalue, no edits, nothing selected, all docks in their places.
    void startAnew();
    /// Keeps what is there now as what was there before.
    void remember();
    const ViewValue& before() const noexcept { return before_; }
    /// When the model had just been opened.
    const ViewValue& atFirst() const noexcept { return atFirst_; }
    const ViewValue& now() const { return session().view(); }
    int undoSteps() const { return session().undoStack().index(); }
    int stepsBefore() const noexcept { return stepsBefore_; }

    Session& session() const { return workbench.session(); }
    void trigger(const QString& action) const { find<QAction>(action).trigger(); }
    /// Gives the keys to a control of the window, and presses one.
    void press(const QString& control, Qt::Key key, Qt::KeyboardModifiers modifiers = {}) const;
    void raise(const QString& dock) const;
    void choose(const QString& mode) const { trigger("action.mode." + mode); }
    /// Another point of the transfer function, in the middle of the values, with no other near: it is selected.
    void addTransferPoint() const;
    /// Where that is among the function's points.
    std::size_t addedPoint() const;
    void waitForPicture() const;
    bool isOpen(const QString& widget) const;
    /// Ends all dialogs and popups.
    void closeDialogs() const;

private:
    void openAnew();
    void resetLayout();
    double middleOfRange() const;

    QString model_;
    QString volume_;
    ViewValue before_;
    ViewValue atFirst_;
    std::shared_ptr<const Model> opened_;
    int stepsBefore_ = 0;
};

/// Opens the button's menu by the keyboard, chooses its action of this name and ends it.
void chooseInMenu(QToolButton& button, const QString& action);

} // namespace tetra
