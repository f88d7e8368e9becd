// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/transfer/transfer_import.h"
#include "plugins/api/editor.h"

#include <QWidget>

class QCheckBox;
class QGridLayout;
class QPushButton;
class QToolButton;

namespace tetra {

class ColourButton;
class TransferCanvas;
class ValueBox;

/// The editor of the transfer function (R18): the plot, and in numbers the point that is selected in it. Holds nothing
/// but the selection; every edit is a function of core/transfer.
class TransferPanel : public QWidget {
    Q_OBJECT
public:
    explicit TransferPanel(EditorHost& host, QWidget* parent = nullptr);

private:
    void nameControls();
    void addNumbers(QGridLayout& grid);
    QWidget* makeTools();
    void fillPresets();
    void fillEdits();
    void connectControls();
    const TransferFunction& function() const;
    void addPoint();
    Status load(const std::string& text);
    void offerChoice(std::vector<ImportedTransfer> imported);
    void save();
    void saveForParaview();
    void showModel();
    void showFunction();

    EditorHost& host_;
    TransferCanvas* canvas_;
    ValueBox* value_;
    ValueBox* opacity_;
    ColourButton* colour_;
    QCheckBox* step_;
    QPushButton* add_;
    QPushButton* remove_;
    ValueBox* unitDistance_;
    QCheckBox* logarithmic_;
    QToolButton* presets_;
    QToolButton* edits_;
    QToolButton* load_;
    QToolButton* save_;
};

} // namespace tetra
