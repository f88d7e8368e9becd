// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/session.h"

#include <QWidget>

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace tetra {

class IsovalueRow;

/// The list of isovalues (R19).
class IsovaluePanel : public QWidget {
    Q_OBJECT
public:
    explicit IsovaluePanel(Session& session, QWidget* parent = nullptr);

private:
    void showModel();
    void follow();
    void keepRows(std::size_t count);

    Session& session_;
    QVBoxLayout* rowsLayout_;
    std::vector<IsovalueRow*> rows_;
    QLabel* hint_;
    QPushButton* add_;
};

} // namespace tetra
