// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/focus_panel.h"

#include "plugins/widgets/gesture_watcher.h"
#include "plugins/widgets/icons.h"
#include "plugins/widgets/number_text.h"
#include "plugins/widgets/scrolled_column.h"
#include "plugins/widgets/value_box.h"
#include "ui/panels/accuracy_inputs.h"
#include "ui/panels/lens_inputs.h"
#include "ui/widgets/checked_button.h"
#include "ui/widgets/value_slider.h"
#include "ui/widgets/vector_input.h"

#include <tan/view.h>

#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace tetra {
namespace {

constexpr int labelColumn = 0;
constexpr int inputColumn = 1;
constexpr int inputColumns = 3;

QLabel* dimLabel(const char* name)
{
    auto* label = new QLabel;
    label->setObjectName(name);
    label->setWordWrap(true);
    label->setForegroundRole(QPalette::PlaceholderText);
    return label;
}

void addRow(QGridLayout& grid, int row, QLabel* label, QWidget* input)
{
    grid.addWidget(label, row, labelColumn);
    grid.addWidget(input, row, inputColumn, 1, inputColumns);
    label->setBuddy(input);
}

} // namespace

FocusPanel::FocusPanel(Session& session, QWidget* parent)
    : QWidget(parent), session_(session), settings_(new QWidget), buttons_(new QWidget), regions_(new QComboBox),
      add_(new QPushButton(tr("A&dd"))), remove_(new QPushButton(tr("Remo&ve"))),
      radiusLabel_(new QLabel(tr("Rad&ius"))), radius_(new ValueSlider("focus.radius", session)),
      error_(new AccuracySlider), errorBox_(new AccuracyBox), falloffLabel_(new QLabel(tr("Fa&ll-off"))),
      falloff_(new ValueSlider("focus.falloff", session)), distanceLabel_(new QLabel(tr("Dis&tance"))),
      distance_(new ValueSlider("focus.distance", session)), valueFalloffLabel_(new QLabel(tr("Value ran&ge"))),
      valueFalloff_(new ValueSlider("focus.valueFalloff", session)), clamped_(dimLabel("focus.clamped")),
      outside_(dimLabel("focus.outside")), expectation_(dimLabel("focus.expectation")), hint_(dimLabel("focus.hint"))
{
    setObjectName("focus");
    hint_->setText(tr("Where the mesh is more accurate than elsewhere. Choose a box or a sphere, then drag its handles "
                      "in the picture; double-click a surface to move it there. Or let the error grow with the "
                      "distance from the viewer or from the isovalues, or where little is visible."));
    auto* settings = new QVBoxLayout(settings_);
    settings->setContentsMargins({});
    settings->addLayout(makeInputs());
    settings->addWidget(clamped_);
    settings->addWidget(outside_);
    settings->addWidget(expectation_);
    auto* ofRegions = new QVBoxLayout(buttons_);
    ofRegions->setContentsMargins({});
    ofRegions->addLayout(makeRegions());
    ofRegions->addLayout(makeButtons());
    settings->addWidget(buttons_);

    auto* content = new QWidget;
    auto* layout = new QVBoxLayout(content);
    layout->addWidget(new QLabel(tr("Accuracy varies with")));
    layout->addLayout(makeShapes());
    layout->addWidget(hint_);
    layout->addWidget(settings_);
    layout->addSpacing(6);
    layout->addWidget(new LensInputs(session_));
    layout->addStretch();
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins({});
    outer->addWidget(new ScrolledColumn(content));

    connectInputs();
    connect(&session_, &Session::modelChanged, this, &FocusPanel::showModel);
    connect(&session_, &Session::modelGrown, this, &FocusPanel::showFocus);
    session_.whenChanged(ViewPart::Query, this, &FocusPanel::showFocus);
    session_.whenChanged(ViewPart::Isovalues, this, &FocusPanel::showExpectation);
    connect(&session_, &Session::shownChanged, this, &FocusPanel::showExpectation);
    showModel();
}

/// Applies a change to the focus and shows what the session made of it.
template <class Change> void FocusPanel::edit(Change change)
{
    FocusState changed = focus();
    change(changed);
    session_.setFocus(changed);
    showFocus();
}

QLayout* FocusPanel::makeShapes()
{
    struct Entry {
        const char* name;
        QString text;
        QString toolTip;
        std::optional<Glyph> glyph;
    };
    const std::array<Entry, 6> entries{{
        {"focus.none", tr("None"), tr("The same error everywhere"), std::nullopt},
        {"focus.box", tr("Box"), tr("A box with its own error (B)"), Glyph::Box},
        {"focus.sphere", tr("Sphere"), tr("A sphere with its own error (F)"), Glyph::Sphere},
        {"focus.view", tr("Viewer"),
         tr("The error grows with the distance from the viewer. While you move the camera, the mesh stays as it is."),
         std::nullopt},
        {"focus.isovalues", tr("Isovalues"), tr("The error grows with the distance from the displayed isovalues"),
         std::nullopt},
        {"focus.opacity", tr("Opacity"), tr("The error is smaller where the transfer function is more opaque"),
         std::nullopt},
    }};
    auto* rows = new QGridLayout;
    rows->setSpacing(2);
    constexpr int inRow = 3;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        auto* button = new QToolButton;
        button->setObjectName(entries[i].name);
        button->setText(entries[i].text);
        button->setToolTip(entries[i].toolTip);
        if (entries[i].glyph)
            button->setIcon(glyphIcon(*entries[i].glyph));
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        button->setCheckable(true);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        connect(button, &QToolButton::clicked, this,
                [this, i] { edit([i](FocusState& changed) { changed.shape = static_cast<FocusState::Shape>(i); }); });
        rows->addWidget(button, static_cast<int>(i) / inRow, static_cast<int>(i) % inRow);
        shapes_[i] = button;
    }
    return rows;
}

/// Several regions, of which one is edited.
QLayout* FocusPanel::makeRegions()
{
    regions_->setObjectName("focus.region");
    regions_->setAccessibleName(tr("Region"));
    regions_->setToolTip(tr("Selected region. All regions share one error and fall-off."));
    add_->setObjectName("focus.add");
    add_->setToolTip(tr("Add another region of the same size"));
    remove_->setObjectName("focus.remove");
    remove_->setToolTip(tr("Remove this region"));
    connect(regions_, &QComboBox::activated, this, [this](int index) {
        edit([index](FocusState& changed) { changed = changed.selected(static_cast<std::uint32_t>(index)); });
    });
    connect(add_, &QPushButton::clicked, this,
            [this] { edit([](FocusState& changed) { changed = changed.added(); }); });
    connect(remove_, &QPushButton::clicked, this,
            [this] { edit([](FocusState& changed) { changed = changed.removed(); }); });
    auto* row = new QHBoxLayout;
    row->addWidget(regions_, 1);
    row->addWidget(add_);
    row->addWidget(remove_);
    return row;
}

QLayout* FocusPanel::makeInputs()
{
    auto* grid = new QGridLayout;
    addAxisNames(*grid, 0);
    for (int column = 0; column < grid->columnCount(); ++column)
        if (const QLayoutItem* item = grid->itemAtPosition(0, column); item != nullptr && item->widget() != nullptr)
            axisNames_.push_back(item->widget());
    centre_ = new VectorInput("focus.centre", tr("&Centre"), tr("Centre of the focus, in the coordinates of the data"),
                              session_, *grid, 1, this);
    size_ = new VectorInput("focus.size", tr("&Size"), tr("Edges of the box, in data units"), session_, *grid, 2, this);
    radius_->setTexts(tr("Radius of the sphere"), tr("Radius of the sphere, in data units"));
    falloff_->setTexts(tr("Fall-off"), tr("The distance over which the error grows from its value in the focus to that "
                                          "outside, in data units; 0 gives a sharp border"));
    distance_->setTexts(tr("Distance"), tr("The distance over which the error grows from its value inside, at the part "
                                           "of the data nearest to the viewer, to that outside, in data units"));
    valueFalloff_->setTexts(tr("Range of values"), tr("The difference from an isovalue over which the error grows from "
                                                      "its value inside to that outside, in the units of the values"));
    error_->setObjectName("focus.error.slider");
    errorBox_->setObjectName("focus.error.box");
    for (QWidget* input : std::initializer_list<QWidget*>{error_, errorBox_}) {
        input->setAccessibleName(tr("Error in the focus"));
        input->setToolTip(tr("Error in the focus, in percent of the value range"));
        new GestureWatcher(input, session_);
    }
    auto* errors = new QWidget;
    auto* row = new QHBoxLayout(errors);
    row->setContentsMargins({});
    row->addWidget(error_, 1);
    row->addWidget(errorBox_);
    errors->setFocusProxy(errorBox_);
    addRow(*grid, 3, radiusLabel_, radius_);
    addRow(*grid, 4, new QLabel(tr("Error i&nside")), errors);
    addRow(*grid, 5, falloffLabel_, falloff_);
    addRow(*grid, 6, distanceLabel_, distance_);
    addRow(*grid, 7, valueFalloffLabel_, valueFalloff_);
    return grid;
}

void FocusPanel::connectInputs()
{
    connect(centre_, &VectorInput::edited, this, [this](const Eigen::Vector3d& centre) {
        edit([&centre](FocusState& changed) { changed.centre = centre; });
    });
    connect(size_, &VectorInput::edited, this,
            [this](const Eigen::Vector3d& size) { edit([&size](FocusState& changed) { changed.size = size; }); });
    connect(radius_, &ValueSlider::edited, this,
            [this](double radius) { edit([radius](FocusState& changed) { changed.radius = radius; }); });
    const auto choose = [this](double percent) { edit([percent](FocusState& changed) { changed.error = percent; }); };
    connect(error_, &AccuracySlider::chosen, this, choose);
    connect(errorBox_, &AccuracyBox::chosen, this, choose);
    connect(falloff_, &ValueSlider::edited, this,
            [this](double length) { edit([length](FocusState& changed) { changed.falloff = length; }); });
    connect(distance_, &ValueSlider::edited, this,
            [this](double length) { edit([length](FocusState& changed) { changed.distance = length; }); });
    connect(valueFalloff_, &ValueSlider::edited, this,
            [this](double values) { edit([values](FocusState& changed) { changed.valueFalloff = values; }); });
}

QLayout* FocusPanel::makeButtons()
{
    auto* centre = new QPushButton(tr("&Move to Centre of View"));
    centre->setObjectName("focus.toView");
    centre->setToolTip(tr("Move the focus to the camera's target (C)"));
    connect(centre, &QPushButton::clicked, this, &FocusPanel::centreWanted);
    auto* reset = new QPushButton(tr("Reset"));
    reset->setObjectName("focus.reset");
    reset->setToolTip(tr("Reset position, size, error and fall-off"));
    connect(reset, &QPushButton::clicked, this, [this] {
        const FocusState first = startingQuery(*session_.model(), session_.view().query.error).focus;
        edit([&first](FocusState& changed) {
            const FocusState::Shape shape = changed.shape;
            changed = first;
            changed.shape = shape;
        });
    });
    auto* row = new QHBoxLayout;
    row->addWidget(centre, 1);
    row->addWidget(reset);
    return row;
}

void FocusPanel::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        showFocus();
}

void FocusPanel::showModel()
{
    setEnabled(session_.model() != nullptr);
    if (const auto& model = session_.model()) {
        const Eigen::AlignedBox3d& bounds = model->description().bounds;
        centre_->setRange(bounds.min(), bounds.max());
        size_->setRange(Eigen::Vector3d::Zero(), 2 * bounds.sizes());
        radius_->setRange(0, model->diagonal() / 2);
        falloff_->setRange(0, model->diagonal() / 2);
        distance_->setRange(0, model->diagonal());
        valueFalloff_->setRange(0, model->description().range.extent());
    }
    const std::initializer_list<QWidget*> boxes{radius_->box(), errorBox_, falloff_->box(), distance_->box(),
                                                valueFalloff_->box()};
    int width = 0;
    for (const QWidget* box : boxes)
        width = std::max(width, box->sizeHint().width());
    for (QWidget* box : boxes)
        box->setFixedWidth(width);
    showFocus();
}

void FocusPanel::showFocus()
{
    const FocusState& shown = focus();
    for (std::size_t i = 0; i < shapes_.size(); ++i)
        showChecked(*shapes_[i], i == static_cast<std::size_t>(shown.shape));
    settings_->setVisible(shown.isOn());
    hint_->setVisible(!shown.isOn());
    const auto onlyFor = [](bool shows, std::initializer_list<QWidget*> widgets) {
        for (QWidget* widget : widgets)
            widget->setVisible(shows);
    };
    for (QWidget* name : axisNames_)
        name->setVisible(shown.isRegion());
    centre_->setVisible(shown.isRegion());
    size_->setVisible(shown.shape == FocusState::Shape::Box);
    onlyFor(shown.shape == FocusState::Shape::Sphere, {radiusLabel_, radius_});
    onlyFor(shown.isRegion(), {falloffLabel_, falloff_, buttons_});
    onlyFor(shown.shape == FocusState::Shape::View, {distanceLabel_, distance_});
    onlyFor(shown.shape == FocusState::Shape::Isovalues, {valueFalloffLabel_, valueFalloff_});
    showRegions();
    centre_->setValue(shown.centre);
    size_->setValue(shown.size);
    radius_->setValue(shown.radius);
    error_->setAccuracy(shown.error);
    errorBox_->setAccuracy(shown.error);
    falloff_->setValue(shown.falloff);
    distance_->setValue(shown.distance);
    valueFalloff_->setValue(shown.valueFalloff);
    showExpectation();
}

void FocusPanel::showRegions()
{
    const std::vector<MovableRegion> regions = focus().regions();
    regions_->clear();
    for (std::size_t i = 0; i < regions.size(); ++i)
        regions_->addItem((std::holds_alternative<Sphere>(regions[i]) ? tr("%1: sphere") : tr("%1: box"))
                              .arg(static_cast<qulonglong>(i + 1)));
    regions_->setCurrentIndex(static_cast<int>(focus().number));
    add_->setEnabled(regions.size() < mostFocusRegions);
}

/// What is known before anything is extracted: the mesh lies between the uniform ones of the two errors.
void FocusPanel::showExpectation()
{
    outside_->clear();
    expectation_->clear();
    const auto& model = session_.model();
    const QueryState& query = session_.view().query;
    const double inner = focusErrorOf(query);
    clamped_->setVisible(query.focus.isOn() && inner < query.focus.error);
    if (!model || !query.focus.isOn())
        return;
    clamped_->setText(
        query.byBudget ? tr("A focus is never coarser than its surroundings, so it gets the same error.")
                       : tr("A focus is never coarser than its surroundings, so it gets %1.").arg(percentText(inner)));
    if (query.byBudget) {
        outside_->setText(tr("With the budget, the error outside is %1 times the error inside.")
                              .arg(QLocale().toString(query.error / std::max(inner, 1e-3), 'g', 3)));
        return;
    }
    if (query.focus.shape == FocusState::Shape::Isovalues && session_.view().isovalues.empty()) {
        outside_->setText(tr("There is no isovalue, so the error is %1 everywhere.").arg(percentText(query.error)));
        return;
    }
    outside_->setText(tr("Outside %1, as chosen under Accuracy.").arg(percentText(query.error)));
    const std::uint64_t inside = meshSizeAt(*model, query.warping.with(inner)).tetrahedra;
    const std::uint64_t outside = meshSizeAt(*model, query.warping.with(query.error)).tetrahedra;
    const QString least = countText(std::min(inside, outside)), most = countText(std::max(inside, outside));
    // Of the whole domain, as the two others are, whatever the window and the range of values leave of it.
    const bool isKnown = session_.showsQuery() && !session_.shown()->isBlended;
    expectation_->setText(isKnown ? tr("%1 tetrahedra; %2 without the focus and with its error everywhere %3.")
                                        .arg(countText(session_.shown()->wholeTetrahedra), least, most)
                                  : tr("Between %1 and %2 tetrahedra.").arg(least, most));
}

} // namespace tetra
