// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/editors/transferfunction/editor_state.h"

#include <QMenu>

#include <functional>

namespace tetra {

/// What can be done to the selected points and to all; each action is one undo step, and those that need a selection
/// are there only with one.
class EditMenu : public QMenu {
    Q_OBJECT
public:
    /// `state` outlives it.
    explicit EditMenu(EditorState& state, QWidget* parent = nullptr);
    /// Where the next isovalue, peak or pasted point goes; none: the middle of what is seen.
    void setPlace(std::optional<double> value) { place_ = value; }
    /// After another selection or another picked value.
    void enableWhatIsPossible();

signals:
    /// Of what is selected.
    void colourWanted();

private:
    using Change = std::function<EditedSelection(const JoinedFunction&, const TransferSelection&)>;

    QAction* add(QMenu& menu, const char* name, const QString& text, const std::function<void()>& run);
    /// Greyed out with fewer selected points than `points`.
    void addEdit(QMenu& menu, const char* name, const QString& text, std::size_t points, const Change& change);
    void addWhole();
    void addRescaling();
    void addSelecting();
    void addArranging();
    void addAligning();
    void addGroups();
    void addRules();
    void addMaskAndIsovalues();
    void addPicked();
    double place() const;

    EditorState& state_;
    std::optional<double> place_;
    struct Needing {
        QAction* action;
        std::size_t points;
    };
    std::vector<Needing> needing_;
    std::vector<QAction*> needingPicked_;
    QAction* colour_ = nullptr;
    QMenu* rescaling_ = nullptr;
    QAction* mask_ = nullptr;
};

/// A mask around the selected points, or if there are not two of them around most of what is seen; or none any more.
void setMasked(EditorState& state, bool on);

} // namespace tetra
