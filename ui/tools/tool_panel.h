// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/tool_desk.h"

#include <QWidget>

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace tetra {

class ParameterForm;

/// What there is to choose and to read of the chosen tool: a form, tool.ID.PARAMETER; what it measures, tool.readings,
/// with a button that copies it, tool.copy; and its commands, tool.ID.command.COMMAND. Without a tool a hint.
class ToolPanel : public QWidget {
    Q_OBJECT
public:
    /// `desk` outlives it.
    explicit ToolPanel(ToolDesk& desk, QWidget* parent = nullptr);

    /// A line for each reading, its label and its text with a tabulator between them.
    QString readingsText() const;

private:
    void makeContent();
    void makeControls();
    void makeButtons(const std::vector<ToolCommand>& commands);
    void show();
    void fill(const std::vector<Parameter>& parameters, const std::vector<ToolCommand>& commands);

    ToolDesk& desk_;
    QWidget* content_ = nullptr;
    QLabel* about_ = nullptr;
    ParameterForm* form_ = nullptr; ///< none without a tool, as the following
    QLabel* readings_ = nullptr;
    QPushButton* copy_ = nullptr;
    QVBoxLayout* buttons_ = nullptr;
    std::vector<std::string> shownParameters_; ///< their ids, and what can be chosen of them
    std::vector<std::string> shownCommands_;   ///< their ids
};

} // namespace tetra
