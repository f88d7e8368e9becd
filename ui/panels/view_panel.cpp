// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/view_panel.h"

#include "plugins/widgets/colour_button.h"
#include "plugins/widgets/number_text.h"
#include "plugins/widgets/scrolled_column.h"
#include "plugins/widgets/value_box.h"
#include "ui/panels/annotation_rows.h"
#include "ui/session/files.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/file_dialogs.h"
#include "ui/widgets/vector_input.h"

#include <tan/render.h>

#include <QComboBox>
#include <QGridLayout>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>

#include <algorithm>
#include <array>

namespace tetra {
namespace {

constexpr double nearest = 0.01; ///< distances offered, in diagonals
constexpr double farthest = 100;

struct NamedButton {
    NamedView view;
    const char* name;
    const char* text;
};

constexpr std::array namedButtons{
    NamedButton{NamedView::Front, "front", QT_TRANSLATE_NOOP("tetra::ViewPanel", "Front")},
    NamedButton{NamedView::Left, "left", QT_TRANSLATE_NOOP("tetra::ViewPanel", "Left")},
    NamedButton{NamedView::Top, "top", QT_TRANSLATE_NOOP("tetra::ViewPanel", "Top")},
    NamedButton{NamedView::Corner, "corner", QT_TRANSLATE_NOOP("tetra::ViewPanel", "Corner")},
    NamedButton{NamedView::Back, "back", QT_TRANSLATE_NOOP("tetra::ViewPanel", "Back")},
    NamedButton{NamedView::Right, "right", QT_TRANSLATE_NOOP("tetra::ViewPanel", "Right")},
    NamedButton{NamedView::Bottom, "bottom", QT_TRANSLATE_NOOP("tetra::ViewPanel", "Bottom")},
};

void setUp(ValueBox& box, const char* name, const QString& text, const QString& suffix, const QString& toolTip)
{
    box.setObjectName(QString("view.") + name);
    box.setAccessibleName(text);
    box.setSuffix(suffix);
    box.setToolTip(toolTip);
}

void showNumber(ValueBox& box, double value)
{
    const QSignalBlocker blocker(box);
    box.setValue(value);
}

} // namespace

ViewPanel::ViewPanel(Workbench& workbench, Viewport& viewport, QWidget* parent)
    : QWidget(parent), workbench_(workbench), viewport_(viewport), azimuth_(new ValueBox), elevation_(new ValueBox),
      roll_(new ValueBox), up_(new QComboBox), distance_(new ValueBox), fieldOfView_(new ValueBox),
      projection_(new QComboBox), turning_(new QComboBox), background_(new ColourButton),
      usualBackground_(new QToolButton), load_(new QPushButton(tr("&Load Camera…"))),
      save_(new QPushButton(tr("Sa&ve Camera…")))
{
    setObjectName("view");
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins({});
    outer->addWidget(new ScrolledColumn(makeContent()));
    connectControls();
    showModel();
}

QWidget* ViewPanel::makeContent()
{
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    column->addLayout(makeNamedViews());
    auto* grid = new QGridLayout;
    addNumbers(*grid);
    column->addLayout(grid);
    column->addLayout(makeFiles());
    column->addSpacing(6);
    column->addWidget(new AnnotationRows(workbench_.session()));
    column->addStretch();
    return content;
}

void ViewPanel::addNumbers(QGridLayout& grid)
{
    const QString degrees = tr("°");
    setUp(*azimuth_, "azimuth", tr("Azimuth"), degrees, tr("Direction around the up axis, in degrees"));
    azimuth_->setValueRange(-180, 180);
    azimuth_->setWrapping(true);
    setUp(*elevation_, "elevation", tr("Elevation"), degrees,
          tr("Height above the plane perpendicular to the up axis, in degrees"));
    elevation_->setValueRange(-90, 90);
    setUp(*roll_, "roll", tr("Roll"), degrees, tr("Clockwise roll of the picture, in degrees"));
    roll_->setValueRange(-180, 180);
    roll_->setWrapping(true);
    up_->setObjectName("view.up");
    for (int axis = 0; axis < 6; ++axis)
        up_->addItem(upAxisText(static_cast<UpAxis>(axis)));
    up_->setAccessibleName(tr("Up axis"));
    up_->setToolTip(tr("Which axis of the data points up"));
    setUp(*distance_, "distance", tr("Distance"), {}, tr("From the camera to the target, in data units"));
    setUp(*fieldOfView_, "fieldOfView", tr("View angle"), degrees,
          tr("View angle along the shorter side of the picture, in degrees"));
    fieldOfView_->setValueRange(1, 170);
    for (ValueBox* box : {azimuth_, elevation_, roll_, fieldOfView_})
        box->setSingleStep(1);
    projection_->setObjectName("view.projection");
    projection_->addItems({tr("Perspective"), tr("Parallel")});
    projection_->setAccessibleName(tr("Projection"));
    projection_->setToolTip(tr("Perspective: distant parts look smaller (Ctrl+P)"));

    turning_->setObjectName("view.turning");
    turning_->addItems({tr("Turntable"), tr("Trackball")});
    turning_->setAccessibleName(tr("Dragging"));
    turning_->setToolTip(
        tr("Whether dragging turns the model around the up axis, or freely in any direction (Ctrl+T)"));

    // Four columns, so that the target's three numbers stand below two pairs.
    addAxisNames(grid, 0);
    target_ = new VectorInput("view.target", tr("Target"), tr("The camera's target, in data units"),
                              workbench_.session(), grid, 1, this);
    auto* pairs = new QGridLayout;
    const auto addPair = [pairs](int row, int column, const QString& text, QWidget* widget) {
        auto* label = new QLabel(text);
        label->setBuddy(widget);
        pairs->addWidget(label, row, column);
        pairs->addWidget(widget, row, column + 1);
    };
    addPair(0, 0, tr("A&zimuth"), azimuth_);
    addPair(0, 2, tr("E&levation"), elevation_);
    addPair(1, 0, tr("&Roll"), roll_);
    addPair(1, 2, tr("&Up axis"), up_);
    addPair(2, 0, tr("D&istance"), distance_);
    addPair(2, 2, tr("View &angle"), fieldOfView_);
    pairs->setColumnStretch(1, 1);
    pairs->setColumnStretch(3, 1);
    grid.addLayout(pairs, 2, 0, 1, 4);
    const auto addWide = [&grid](int row, const QString& text, QWidget* widget) {
        auto* label = new QLabel(text);
        label->setBuddy(widget);
        grid.addWidget(label, row, 0);
        grid.addWidget(widget, row, 1, 1, 3);
    };
    addWide(3, tr("Pro&jection"), projection_);
    addWide(4, tr("Dra&gging"), turning_);
}

QLayout* ViewPanel::makeNamedViews()
{
    auto* grid = new QGridLayout;
    grid->setSpacing(4);
    int index = 0;
    for (const auto& [view, name, text] : namedButtons) {
        auto* button = new QPushButton(tr(text));
        button->setObjectName(QString("view.from.") + name);
        button->setToolTip(tr("Look from this side"));
        connect(button, &QPushButton::clicked, &viewport_, [this, view = view] {
            workbench_.session().setCamera(seenFrom(workbench_.session().view().camera, view));
        });
        grid->addWidget(button, index / 4, index % 4);
        ++index;
    }
    auto* fit = new QPushButton(tr("Fit"));
    fit->setObjectName("view.fit");
    fit->setToolTip(tr("Frame what is shown, or the focus; press again for the whole domain (Home)"));
    connect(fit, &QPushButton::clicked, &workbench_.session(), &Session::fitCamera);
    grid->addWidget(fit, 1, 3);
    for (int i = 0; i < grid->count(); ++i)
        grid->itemAt(i)->widget()->setMinimumWidth(1); // as narrow as the panel
    return grid;
}

QLayout* ViewPanel::makeFiles()
{
    background_->setObjectName("view.background");
    background_->setToolTip(tr("Background colour, also in saved pictures"));
    background_->setAccessibleName(tr("Background colour"));
    usualBackground_->setObjectName("view.usualBackground");
    usualBackground_->setText(tr("Default"));
    usualBackground_->setToolTip(tr("The colour that fits the window, light or dark; dark behind a shaded volume"));
    load_->setObjectName("view.load");
    load_->setToolTip(tr("Load the camera from a JSON file"));
    save_->setObjectName("view.save");
    save_->setToolTip(tr("Save the camera as a JSON file, which “tan render --camera” also accepts"));
    auto* colour = new QHBoxLayout;
    auto* label = new QLabel(tr("Bac&kground"));
    label->setBuddy(background_);
    colour->addWidget(label);
    colour->addWidget(background_);
    colour->addWidget(usualBackground_);
    colour->addStretch();
    auto* files = new QHBoxLayout;
    files->addWidget(load_);
    files->addWidget(save_);
    files->addStretch();
    auto* rows = new QVBoxLayout;
    rows->addLayout(colour);
    rows->addLayout(files);
    return rows;
}

/// Applies a change to the camera that is in use.
template <class Change> void ViewPanel::edit(Change change)
{
    Camera camera = viewport_.camera();
    change(camera);
    viewport_.setCamera(camera);
    showCamera();
}

void ViewPanel::connectControls()
{
    const auto connectBox = [this](ValueBox* box, double Camera::*member) {
        connect(box, &QDoubleSpinBox::valueChanged, this,
                [this, member](double value) { edit([=](Camera& camera) { camera.*member = value; }); });
    };
    connectBox(azimuth_, &Camera::azimuth);
    connectBox(elevation_, &Camera::elevation);
    connectBox(roll_, &Camera::roll);
    connectBox(distance_, &Camera::distance);
    connectBox(fieldOfView_, &Camera::fieldOfView);
    connect(target_, &VectorInput::edited, this,
            [this](const Eigen::Vector3d& target) { edit([&target](Camera& camera) { camera.target = target; }); });
    connect(projection_, &QComboBox::activated, this,
            [this](int index) { edit([index](Camera& camera) { camera.perspective = index == 0; }); });
    connect(up_, &QComboBox::activated, this, [this](int index) {
        workbench_.session().setCamera(upright(viewport_.camera(), static_cast<UpAxis>(index)));
    });
    connect(turning_, &QComboBox::activated, this,
            [this](int index) { edit([index](Camera& camera) { camera.trackball = index == 1; }); });
    connect(background_, &ColourButton::colourChosen, this,
            [this](const QColor& colour) { workbench_.session().setBackground(colourOf(colour)); });
    connect(usualBackground_, &QToolButton::clicked, this,
            [this] { workbench_.session().setBackground(std::nullopt); });
    connect(load_, &QPushButton::clicked, this, [this] {
        askForTextFile(this, "cameraDialog", tr("Load Camera"), tr("Cameras (*.json)"),
                       [this](const QString& path) { load(path); });
    });
    connect(save_, &QPushButton::clicked, this, [this] {
        askForTextTarget(this, "cameraSaveDialog", tr("Save Camera"), tr("Cameras (*.json)"),
                         workbench_.opening().proposedPath("-camera.json"), [this](const QString& path) {
                             workbench_.exporting().saveText(filePath(path), cameraToText(viewport_.camera()));
                         });
    });
    connect(&viewport_, &Viewport::cameraChanged, this, &ViewPanel::showCamera);
    connect(&viewport_, &Viewport::backgroundChanged, this, &ViewPanel::showCamera);
    connect(&workbench_.session(), &Session::modelChanged, this, &ViewPanel::showModel);
}

void ViewPanel::load(const QString& path)
{
    workbench_.exporting().loadText(filePath(path), [this](const std::string& text) -> Status {
        Session& session = workbench_.session();
        if (!session.model())
            return {};
        const auto camera = cameraFromText(text, session.model()->description().bounds, session.shape());
        if (!camera)
            return camera.error();
        session.setCamera(*camera);
        return {};
    });
}

void ViewPanel::showModel()
{
    setEnabled(workbench_.session().model() != nullptr);
    if (const auto& model = workbench_.session().model()) {
        const Eigen::AlignedBox3d& bounds = model->description().bounds;
        const double diagonal = bounds.diagonal().norm() > 0 ? bounds.diagonal().norm() : 1;
        const Eigen::Vector3d room = Eigen::Vector3d::Constant(diagonal);
        const QSignalBlocker blocker(distance_);
        distance_->setValueRange(nearest * diagonal, farthest * diagonal);
        distance_->setDecimals(std::max(distance_->decimals(), decimalsFor(diagonal)));
        distance_->setSingleStep(diagonal / 20);
        target_->setRange(bounds.center() - room, bounds.center() + room);
    }
    showCamera();
}

void ViewPanel::showCamera()
{
    const Camera& camera = viewport_.camera();
    showNumber(*azimuth_, camera.azimuth);
    showNumber(*elevation_, camera.elevation);
    showNumber(*roll_, camera.roll);
    up_->setCurrentIndex(static_cast<int>(camera.up));
    showNumber(*distance_, camera.distance);
    showNumber(*fieldOfView_, camera.fieldOfView);
    target_->setValue(camera.target);
    projection_->setCurrentIndex(camera.perspective ? 0 : 1);
    turning_->setCurrentIndex(camera.trackball ? 1 : 0);
    background_->setColour(qtColour(viewport_.background()));
    usualBackground_->setEnabled(workbench_.session().view().background.has_value());
}

} // namespace tetra
