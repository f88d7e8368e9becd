// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/import_dialog.h"

#include "plugins/widgets/number_text.h"
#include "plugins/widgets/scrolled_column.h"
#include "ui/opening/import_texts.h"
#include "ui/panels/import_region.h"
#include "ui/panels/slice_preview.h"
#include "ui/session/files.h"
#include "ui/session/message_text.h"
#include "ui/widgets/check_label.h"
#include "ui/widgets/first_focus.h"
#include "ui/widgets/scale_input.h"

#include <QComboBox>
#include <QEvent>
#include <QFileInfo>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>

#include <algorithm>
#include <cmath>
#include <utility>

namespace tetra {
namespace {

constexpr int importBarSteps = 1000;
constexpr int fieldsWidth = 420;

QLabel* wrapped(const char* name)
{
    auto* label = new QLabel;
    label->setObjectName(name);
    label->setWordWrap(true);
    return label;
}

} // namespace

ImportDialog::ImportDialog(Workbench& workbench, QWidget* parent)
    : QDialog(parent), workbench_(workbench), probe_(new ImportProbe(workbench.host(), this)),
      file_(wrapped("import.file")), reason_(new CheckLabel("import.reason")), reader_(new QComboBox),
      form_(new ParameterForm("import.option")), fields_(new QWidget), layoutHelp_(new QGroupBox(tr("Size check"))),
      suggestions_(new QComboBox), sizeCheck_(new CheckLabel("import.sizeCheck")), preview_(new SlicePreview),
      region_(new ImportRegion), scale_(new ScaleInput("import.scale")), provenance_(new QLabel),
      estimate_(wrapped("import.estimate")), bar_(new QProgressBar), read_(new QPushButton(tr("&Read"))),
      cancel_(new QPushButton(tr("Cancel")))
{
    setObjectName("importDialog");
    fillFields();
    fillLayoutHelp();
    auto* columns = new QHBoxLayout;
    columns->addWidget(new ScrolledColumn(fields_), 1);
    columns->addWidget(layoutHelp_, 1);
    auto* layout = new QVBoxLayout(this);
    QFont bold = file_->font();
    bold.setBold(true);
    file_->setFont(bold);
    layout->addWidget(file_);
    layout->addLayout(columns, 1);
    layout->addLayout(makeFoot());
    connectAll();
}

void ImportDialog::fillFields()
{
    reader_->setObjectName("import.reader");
    reader_->setAccessibleName(tr("Reader"));
    reader_->setSizeAdjustPolicy(QComboBox::AdjustToContents);        // whole names, also in large letters,
    reader_->setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Fixed); // and never less
    reader_->setToolTip(tr("Reader used for this file"));
    auto* readerRow = new QFormLayout;
    readerLabel_ = new QLabel(tr("R&eader"));
    readerLabel_->setBuddy(reader_);
    readerRow->addRow(readerLabel_, reader_);
    auto* values = new QGroupBox(tr("Import options"));
    auto* valueLayout = new QVBoxLayout(values);
    valueLayout->addLayout(readerRow);
    valueLayout->addWidget(form_);
    valueLayout->addWidget(scale_);
    provenance_->setObjectName("import.provenance");
    provenance_->setWordWrap(true);
    provenance_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    provenance_->setToolTip(tr("What these options take from the file, and what else it states that is not used"));
    valueLayout->addWidget(provenance_);
    auto* part = new QGroupBox(tr("Subset"));
    auto* partLayout = new QVBoxLayout(part);
    partLayout->addWidget(region_);
    auto* layout = new QVBoxLayout(fields_);
    layout->setContentsMargins({});
    layout->addWidget(values);
    layout->addWidget(part);
    layout->addStretch();
    layout->addStrut(fieldsWidth); // at least; a minimum of the widget would be one for what needs more, too
}

void ImportDialog::fillLayoutHelp()
{
    suggestions_->setObjectName("import.suggestions");
    suggestions_->setAccessibleName(tr("Matching layouts"));
    suggestions_->setToolTip(tr("Sizes and types that fit the file exactly, the most likely first"));
    auto* row = new QFormLayout;
    row->addRow(tr("&Suggestion"), suggestions_);
    auto* layout = new QVBoxLayout(layoutHelp_);
    layout->addLayout(row);
    layout->addWidget(sizeCheck_);
    layout->addWidget(preview_, 1);
}

QLayout* ImportDialog::makeFoot()
{
    estimate_->setForegroundRole(QPalette::PlaceholderText);
    estimate_->setToolTip(tr("An upper bound; a model with less detail takes less."));
    bar_->setObjectName("import.progress");
    bar_->setAccessibleName(tr("Progress of reading"));
    bar_->setRange(0, importBarSteps);
    bar_->hide();
    read_->setObjectName("import.read");
    read_->setToolTip(tr("Open with these options"));
    read_->setDefault(true);
    cancel_->setObjectName("import.cancel");
    cancel_->setToolTip(tr("Stops reading, or closes this window"));
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(bar_, 1);
    buttons->addStretch();
    buttons->addWidget(read_);
    buttons->addWidget(cancel_);
    auto* layout = new QVBoxLayout;
    layout->addWidget(reason_);
    layout->addWidget(estimate_);
    layout->addLayout(buttons);
    return layout;
}

void ImportDialog::connectAll()
{
    connect(reader_, &QComboBox::activated, this, &ImportDialog::changeReader);
    connect(form_, &ParameterForm::edited, this, &ImportDialog::valuesEdited);
    connect(suggestions_, &QComboBox::activated, this, &ImportDialog::takeSuggestion);
    connect(region_, &ImportRegion::edited, this, &ImportDialog::showPart);
    connect(scale_, &ScaleInput::edited, this, &ImportDialog::showPart);
    connect(probe_, &ImportProbe::probed, this, &ImportDialog::showContents);
    connect(read_, &QPushButton::clicked, this, &ImportDialog::read);
    connect(cancel_, &QPushButton::clicked, this, &ImportDialog::reject);
    connect(this, &QDialog::finished, preview_, [this] { preview_->setSamples({}, std::nullopt); });
    connect(&workbench_.opening().reading().task(), &LongTask::progressed, this, [this](const TaskProgress& progress) {
        bar_->setValue(static_cast<int>(std::lround(progress.fraction * importBarSteps)));
    });
    connect(&workbench_.opening().reading().task(), &LongTask::started, this, [this] {
        if (isReading()) // another file took its place
            showReading(false);
    });
    connect(&workbench_.opening().datasets(), &DatasetOpening::datasetOpened, this, [this] {
        if (isReading()) {
            showReading(false);
            question_.unpacked.reset();
            accept();
        }
    });
    connect(&workbench_.opening().datasets(), &DatasetOpening::importFailed, this, [this](const QString& reason) {
        showReading(false);
        showReason(false, reason);
    });
}

void ImportDialog::ask(const ImportQuestion& question)
{
    question_ = question;
    contents_ = question.contents;
    fileBytes_ = static_cast<std::uint64_t>(QFileInfo(pathText(question.samples)).size());
    withLayout_ = needsLayout(question.reader.plugin->parameters(), contents_);
    const QString name = shownText(question.path.filename().string());
    setWindowTitle(tr("Import %1").arg(name));
    file_->setText(tr("%1, %2 bytes").arg(name, countText(fileBytes_)));
    file_->setToolTip(shownText(question.path.string()));
    showReading(false);
    showReaders();
    showProvenance();
    showReason(true, {});
    if (withLayout_ && question_.options.values.empty() && !contents_.suggestions.empty())
        question_.options.values = contents_.suggestions.front();
    formReader_.clear();
    form_->setParameters({});
    showForm();
    form_->setValues(question_.options.values);
    showSuggestions();
    wantedPart_ = question_.options.part;
    scale_->setScale(question_.options.scale);
    region_->setSpace();
    region_->setPart({});
    showGrid();
    valuesEdited();
    layoutHelp_->setVisible(withLayout_);
    resize(withLayout_ ? QSize(900, 620) : QSize(520, 480));
    show();
    focusFirst(*this, *read_);
    raise();
    activateWindow();
}

void ImportDialog::showReaders()
{
    readers_ = workbench_.host().readers();
    reader_->clear();
    for (const Provided<Reader>& reader : readers_) {
        reader_->addItem(inUsersLanguage(reader.name, reader.names));
        if (reader.id == question_.reader.id)
            reader_->setCurrentIndex(reader_->count() - 1);
    }
}

/// Another one knows other things of the file.
void ImportDialog::changeReader()
{
    question_.reader = readers_[static_cast<std::size_t>(reader_->currentIndex())];
    question_.options = {};
    contents_ = {};
    isFirstProbe_ = true;
    showReason(true, {});
    showForm();
    probe_->request(question_.path, {.reader = question_.reader.id});
}

/// The fields of what can be chosen now; what was filled in stays.
void ImportDialog::showForm()
{
    const ParameterValues before = form_->values();
    ImportForm fields = importForm(question_.reader.plugin->parameters(), contents_, before, withLayout_);
    if (formReader_ == question_.reader.id && fields.looksLike(shownFields_))
        return; // who is filling them in keeps the keyboard
    shownFields_ = std::move(fields);
    formReader_ = question_.reader.id;
    form_->setParameters(shownFields_.parameters, shownFields_.choices);
    form_->setValues(before);
    alignLabels();
    // While a size is typed it is seen what it means.
    if (auto* size = findChild<QLineEdit*>("import.option.size"))
        connect(size, &QLineEdit::textChanged, this, &ImportDialog::showLayout);
}

/// The reader's field stands above the others.
void ImportDialog::alignLabels()
{
    std::vector<QLabel*> labels = {readerLabel_};
    for (QLabel* label : form_->findChildren<QLabel*>())
        if (label->buddy() != nullptr)
            labels.push_back(label);
    const auto widest = std::ranges::max(labels, {}, [](const QLabel* label) { return label->sizeHint().width(); });
    for (QLabel* label : labels)
        label->setMinimumWidth(widest->sizeHint().width());
}

void ImportDialog::showSuggestions()
{
    suggestions_->clear();
    for (const ParameterValues& suggestion : contents_.suggestions)
        suggestions_->addItem(suggestionText(suggestion));
    suggestions_->setEnabled(suggestions_->count() > 0);
    if (suggestions_->count() == 0)
        suggestions_->addItem(tr("None found"));
}

void ImportDialog::takeSuggestion(int index)
{
    if (index < 0 || static_cast<std::size_t>(index) >= question_.contents.suggestions.size())
        return;
    ParameterValues taken = form_->values();
    for (const auto& [id, value] : question_.contents.suggestions[static_cast<std::size_t>(index)])
        taken[id] = value;
    form_->setValues(taken);
    valuesEdited();
}

void ImportDialog::valuesEdited()
{
    showReason(true, {}); // what was said of other values
    if (withLayout_)
        showLayout();
    probe_->request(question_.path, {.reader = question_.reader.id, .values = form_->values()});
}

void ImportDialog::showContents(const Result<FileContents>& contents)
{
    if (std::exchange(isFirstProbe_, false) && contents) {
        question_.contents = *contents;
        withLayout_ = needsLayout(question_.reader.plugin->parameters(), *contents);
        layoutHelp_->setVisible(withLayout_);
        contents_ = *contents;
        showProvenance();
        showSuggestions();
        showForm();
        return valuesEdited();
    }
    if (!contents && !withLayout_ && !isReading()) // of a layout the check of its size says it better
        showReason(false, translatedMessage(contents.error().message));
    if (!contents)
        return;
    contents_ = *contents;
    if (!withLayout_)
        showForm();
    showProvenance();
    showGrid();
}

void ImportDialog::showLayout()
{
    const auto samples = storedSamplesOf(form_->values());
    preview_->setSamples(question_.samples, samples);
    const ImportCheck check =
        samples ? checkRawSize(*samples, fileBytes_)
                : ImportCheck{false, tr("Enter the number of points along x, y and z, as in 64x64x32.")};
    sizeCheck_->showCheck(check.fits, check.text);
    fits_ = check.fits;
    if (samples && check.fits) {
        contents_.domain = DomainClass::RegularLattice;
        contents_.lattice.size = samples->size;
        contents_.points = contents_.lattice.pointCount();
        contents_.type = samples->type;
        showGrid();
    }
    showPart();
}

void ImportDialog::showProvenance()
{
    const QStringList lines = provenanceLines(contents_.taken, contents_.leftOut);
    provenance_->setText(lines.join('\n'));
    provenance_->setVisible(!lines.isEmpty());
}

/// The region's fields, of the kind of data that the file holds.
void ImportDialog::showGrid()
{
    const bool isGrid = contents_.points > 0 && (contents_.domain == DomainClass::RegularLattice ||
                                                 contents_.domain == DomainClass::Curvilinear);
    if (isGrid)
        region_->setGrid(contents_.lattice);
    else
        region_->setSpace();
    const bool isKnown =
        isGrid || contents_.domain == DomainClass::Scattered || contents_.domain == DomainClass::Irregular;
    if (const auto part = isKnown ? std::exchange(wantedPart_, std::nullopt) : std::nullopt)
        region_->setPart(*part);
    showPart();
}

void ImportDialog::showPart()
{
    const bool isLaidOut = !withLayout_ || fits_;
    read_->setEnabled(!isReading() && region_->isUsable() && isLaidOut && scale_->scale());
    region_->setEnabled(isLaidOut);
    const std::uint64_t points = isLaidOut ? region_->points().value_or(contents_.points) : 0;
    needs_.forget();
    if (points == 0)
        return estimate_->hide();
    constexpr double tetrahedraAPoint = 5.5; // of meshes whose cells are not known
    const auto expected = static_cast<std::uint64_t>(tetrahedraAPoint * static_cast<double>(points));
    const BuildSize size{.domain = contents_.domain.value_or(DomainClass::RegularLattice),
                         .points = points,
                         .tetrahedra = std::max(contents_.cells, expected),
                         .type = contents_.type.value_or(SampleType::Float32)};
    needs_.ask(
        *this,
        [&host = workbench_.host(), size](const std::stop_token&) {
            return quickestEstimate(host, size, usableThreads());
        },
        [this, size](const std::optional<BuildEstimate>& estimate) {
            estimate_->setText(estimate ? estimateText(size, *estimate) : QString());
            estimate_->setVisible(estimate.has_value());
        });
}

void ImportDialog::showReason(bool fits, const QString& reason)
{
    reason_->showCheck(fits, reason);
    reason_->setVisible(!reason.isEmpty());
}

void ImportDialog::showReading(bool reading)
{
    isReading_ = reading;
    fields_->setEnabled(!reading);
    layoutHelp_->setEnabled(!reading);
    bar_->setValue(0);
    bar_->setVisible(reading);
    showPart();
}

void ImportDialog::read()
{
    showReason(true, {});
    workbench_.opening().datasets().importDataset(question_.path, {.reader = question_.reader.id,
                                                                   .values = form_->values(),
                                                                   .part = region_->part(),
                                                                   .scale = scale_->scale().value_or(ValueScale{})});
    showReading(true);
}

void ImportDialog::reject()
{
    if (isReading()) {
        workbench_.opening().reading().cancel(); // ends with importFailed()
        return;
    }
    question_.unpacked.reset();
    QDialog::reject();
}

/// A text that has become longer, as that of an estimate that comes later, has room once all layouts know of it.
bool ImportDialog::event(QEvent* event)
{
    const bool known = QDialog::event(event);
    if (event->type() == QEvent::LayoutRequest && layout() != nullptr)
        resize(width(), std::max(height(), layout()->totalHeightForWidth(width())));
    return known;
}

} // namespace tetra
