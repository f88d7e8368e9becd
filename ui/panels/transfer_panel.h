// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/transfer/transfer_import.h"
#include "ui/session/workbench.h"

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
    explicit TransferPanel(Workbench& workbench, QWidget* parent = nullptr);

private:
    void nameControls();
    void addNumbers(QGridLayout& grid);
    QWidget* makeTools();
    void fillPresets();
    void fillEdits();
    void connectControls();
    const TransferFunction& function() const;
    void addPoint();
    void load(const QString& path);
    void offerChoice(std::vector<ImportedTransfer> imported);
    void save(const QString& path);
    void saveForParaview(const QString& path);
    void showModel();
    void showFunction();

    Workbench& workbench_;
    Session& session_;
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
