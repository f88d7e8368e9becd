// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/opening/import_question.h"
#include "ui/panels/import_form.h"
#include "ui/work/latest_answer.h"
#include "ui/workbench/workbench.h"

#include <QDialog>

class QComboBox;
class QGroupBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace tetra {

class CheckLabel;
class ImportRegion;
class ScaleInput;
class SlicePreview;

/// Asks how a dataset is to be read, and which part of it: fields made of what the file holds and its reader's
/// parameters, of raw files with a preview. The window behind it can be used meanwhile.
class ImportDialog : public QDialog {
    Q_OBJECT
public:
    /// `workbench` outlives it.
    explicit ImportDialog(Workbench& workbench, QWidget* parent = nullptr);

    /// Begins anew with this file, and shows itself.
    void ask(const ImportQuestion& question);
    void reject() override;

protected:
    bool event(QEvent* event) override;

private:
    void fillFields();
    void fillLayoutHelp();
    QLayout* makeFoot();
    void connectAll();

    void showReaders();
    void showForm();
    void alignLabels();
    void showSuggestions();
    void showContents(const Result<FileContents>& contents);
    void showLayout();
    void showProvenance();
    void showGrid();
    void showPart();
    void showReason(bool fits, const QString& reason);
    void showReading(bool reading);
    void changeReader();
    void takeSuggestion(int index);
    void valuesEdited();
    void read();
    bool isReading() const noexcept { return isReading_; }

    Workbench& workbench_;
    ImportQuestion question_;
    std::vector<Provided<Reader>> readers_;
    FileContents contents_;                 ///< with the values that are chosen
    std::optional<DatasetPart> wantedPart_; ///< until it is known what there is to take a part of
    ImportForm shownFields_;
    std::string formReader_; ///< whose they are
    std::uint64_t fileBytes_ = 0;
    bool withLayout_ = false; ///< the file does not tell its own
    bool fits_ = false;       ///< the layout that is filled in
    bool isReading_ = false;
    bool isFirstProbe_ = false; ///< of this reader: without values

    ImportProbe* probe_;
    QLabel* file_;
    CheckLabel* reason_;
    QComboBox* reader_;
    QLabel* readerLabel_ = nullptr;
    ParameterForm* form_;
    QWidget* fields_;
    QGroupBox* layoutHelp_;
    QComboBox* suggestions_;
    CheckLabel* sizeCheck_;
    SlicePreview* preview_;
    ImportRegion* region_;
    ScaleInput* scale_;
    QLabel* provenance_;
    QLabel* estimate_;
    QProgressBar* bar_;
    QPushButton* read_;
    QPushButton* cancel_;
    LatestAnswer<std::optional<BuildEstimate>> needs_; ///< of the build
};

} // namespace tetra
