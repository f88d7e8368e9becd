// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/editors/transferfunction/editor_state.h"

#include <tan/transfer.h>

#include <QWidget>

class QAction;
class QBoxLayout;
class QCheckBox;
class QComboBox;
class QLabel;
class QMenu;
class QPushButton;
class QToolButton;

namespace tetra {

class EditMenu;
class PointNumbers;
class PointTable;
class PresetPopup;
class TransferCanvas;

/// The editor of the transfer function (R18): the plot, in numbers what is selected in it, a table of all points, and
/// menus. Every edit is a function of core/transfer.
class TransferPanel : public QWidget {
    Q_OBJECT
public:
    /// `host` outlives it.
    explicit TransferPanel(EditorHost& host, QWidget* parent = nullptr);

private:
    void nameControls();
    void layOutChooser();
    QBoxLayout* makeTools();
    QBoxLayout* makeReadOutRow();
    void addPointTools();
    void fillViewMenu();
    void addValueAxes(QMenu& menu);
    void setValueAxis(ValueAxis axis);
    void connectControls();
    void setStep(bool on);
    Status load(const std::string& text);
    void take(const ImportedTransfer& imported);
    void offerChoice(std::vector<ImportedTransfer> imported);
    void save();
    void saveForParaview();
    void showModel();
    void showChooser();
    void showFunction();
    void showSelection();
    void showReadOut();
    void showPicked();
    void openEditMenu(QPoint place);

    EditorHost& host_;
    EditorState state_;
    QComboBox* chooser_; ///< of the function that is edited
    QWidget* chooserRow_;
    TransferCanvas* canvas_;
    QLabel* readOut_;
    PointNumbers* numbers_;
    EditMenu* editMenu_;
    PresetPopup* presetPopup_;
    PointTable* table_;
    QPushButton* add_;
    QPushButton* remove_;
    QCheckBox* step_;
    QCheckBox* logarithmic_;
    QToolButton* presets_;
    QToolButton* edits_;
    QToolButton* view_;
    QToolButton* mask_;
    QToolButton* showTable_;
    QToolButton* load_;
    QToolButton* save_;
};

} // namespace tetra
