// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace tetra {

/// The settings of the folder where models go that are unpacked or fetched: which it is, and how much it may take; and
/// a button that clears it. Parts are named cache.folder, .choose, .limit, .used and .clear.
class CacheDialog : public QDialog {
    Q_OBJECT
public:
    explicit CacheDialog(QWidget* parent);

    void accept() override;

private:
    void chooseFolder();
    void clear();
    void showUsed();

    QLineEdit* folder_;
    QSpinBox* limit_;
    QLabel* used_;
    QPushButton* clear_;
};

} // namespace tetra
