// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/builder.h"
#include "plugins/host/interrupted_build.h"
#include "ui/work/latest_answer.h"
#include "ui/workbench/target_look.h"
#include "ui/workbench/workbench.h"

#include <QWidget>

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

class QButtonGroup;
class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QStackedWidget;

namespace tetra {

class ParameterForm;

/// What is asked of a builder before it builds. It outlives the question.
struct BuildQuestion {
    const Builder* builder = nullptr;
    std::shared_ptr<const Dataset> dataset;
    BuildSize size{};
    ParameterValues values{};
    std::vector<ParameterValues> others{}; ///< each in place of those values
};

/// What it says to that.
struct BuildOutlook {
    std::optional<BuildEstimate> estimate{};
    std::vector<std::optional<BuildEstimate>> others{}; ///< with the other values
    bool resumes = false;
};

/// Asks in this thread; an outside plugin may take its time.
BuildOutlook outlookOf(const BuildQuestion& question);

/// Where a model is built of a dataset. What is there already where the model is to be, and what a builder says of the
/// build, a worker finds out; until both are known nothing is built and nothing deleted.
class BuildPanel : public QWidget {
    Q_OBJECT
public:
    using Ask = std::function<BuildOutlook(const BuildQuestion&)>;
    /// `look`: how files are looked for; `ask`: how builders are asked.
    explicit BuildPanel(Workbench& workbench, TargetLook::Look look = &lookAtTarget, Ask ask = &outlookOf,
                        QWidget* parent = nullptr);
    /// Whether it is still to be found out what is there already, or what the builder says.
    bool looking() const noexcept { return look_->running() || outlook_.isWaiting(); }

signals:
    /// The build is to be stopped, and what is finished kept.
    void keepWanted();
    /// The model that is there already is to be opened.
    void openWanted(const QString& path);

private:
    QWidget* makeNothingPage();
    QWidget* makeBuildPage();
    QWidget* makeDetails();
    QLayout* makeTargetRow();
    QWidget* makeResume();
    QWidget* makeInterrupted();
    QWidget* makeProgress();
    void connectWorkbench();

    void showDataset();
    /// `detail`: what is kept, if it is none of the choices what fits the size of the dataset.
    void showBuilder(int detail);
    void chooseDetail(int index);
    void showDetail();
    void askBuilder(const Builder& builder, const std::shared_ptr<const Dataset>& dataset);
    void showOutlook(const BuildOutlook& outlook);
    void beginLook(bool takesUp);
    void showTarget();
    void offerExisting(bool offers);
    void whenLooked(const std::function<void()>& then);
    void goOn();
    /// Shows the builder and the options of an interrupted build of these data, as it goes on with no others.
    void takeUpInterrupted();
    void showInterrupted();
    void beginAnew();
    void showRunning(bool running);
    void showProgress(const TaskProgress& progress);
    void browse();
    void build();
    void showStopping(BuildEnd end);

    Workbench& workbench_;
    TargetLook* look_;
    Ask ask_;
    bool takesUp_ = false;       ///< an interrupted build, if the look finds one
    std::function<void()> then_; ///< what the user has asked for meanwhile
    QStackedWidget* pages_;
    QWidget* nothingPage_;
    QLabel* name_;
    QLabel* facts_;
    QPushButton* differently_ = nullptr;
    QLabel* estimate_ = nullptr;
    QWidget* details_ = nullptr;
    QButtonGroup* detail_ = nullptr; ///< by the number of the choice; none is checked if the options say otherwise
    std::array<QLabel*, 3> detailSizes_{}; ///< what each choice takes
    QComboBox* builder_;
    QLabel* reason_;
    ParameterForm* options_;
    QLineEdit* target_;
    QPushButton* browse_;
    QLabel* targetHint_;
    QCheckBox* resume_;
    QWidget* interrupted_; ///< what is said of a build that was interrupted
    QLabel* interruptedText_;
    QPushButton* beginAnew_;
    QPushButton* openExisting_ = nullptr; ///< comes before the one that would replace that model
    QPushButton* build_;
    QWidget* inputs_;
    QWidget* buildPage_;
    QWidget* progress_;
    QProgressBar* bar_;
    QLabel* activity_;
    QPushButton* pause_;
    QPushButton* keep_;
    QPushButton* cancel_;
    LatestAnswer<BuildOutlook> outlook_;
};

} // namespace tetra
