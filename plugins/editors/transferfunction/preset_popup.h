// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/editors/transferfunction/editor_state.h"
#include "plugins/editors/transferfunction/preset.h"

#include <tan/base.h>

#include <QFrame>

#include <functional>
#include <map>
#include <thread>

class QComboBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QListWidgetItem;
class QPushButton;

namespace tetra {

/// Transfer functions to begin with, with previews: narrowed down by typing, taken whole or only the colours or
/// opacities of; the function as it is can be saved among them. The user's own ones are read and written in a worker.
class PresetPopup : public QFrame {
    Q_OBJECT
public:
    /// `state` outlives it.
    explicit PresetPopup(EditorState& state, QWidget* parent = nullptr);
    /// Below a button, or above it where there is no room.
    void showAt(const QWidget& button);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void addActions();
    QIcon iconOf(const Preset& preset);
    /// Reads the user's own presets, once `change` has changed them.
    void readOwn(const std::function<Status()>& change);
    void fill();
    void narrow();
    void tellWhatIsFound(bool any);
    void take(const QListWidgetItem* item);
    void apply(const Preset& preset, PresetPart part);
    void askForName();
    void save(const QString& name);
    void remove();
    PresetPart part() const;
    const Preset* presetOf(const QListWidgetItem* item) const;
    void enableWhatIsPossible();

    EditorState& state_;
    std::vector<Preset> own_;        ///< as they were read last
    quint64 newest_ = 0;             ///< of the numbers of what is read
    std::vector<Preset> presets_;    ///< those and the supplied ones
    std::map<QString, QIcon> icons_; ///< of the supplied ones, by their ids
    QLineEdit* search_;
    QComboBox* part_;
    QListWidget* list_;
    QLabel* nothing_; ///< in the list, where it is empty
    QPushButton* save_;
    QPushButton* delete_;
    std::jthread files_; ///< waits for the one before: who reads the folder sees what was saved before
};

} // namespace tetra
