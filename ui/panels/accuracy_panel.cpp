// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/accuracy_panel.h"

#include "ui/panels/accuracy_curve.h"
#include "ui/panels/accuracy_inputs.h"
#include "ui/session/number_text.h"
#include "ui/widgets/gesture_watcher.h"

#include <QEvent>
#include <QGridLayout>
#include <QGuiApplication>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

namespace tetra {
namespace {

QLabel* numberLabel(const char* name)
{
    auto* label = new QLabel;
    label->setObjectName(name);
    label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

QString shareText(double part, double whole)
{
    return whole > 0 ? AccuracyPanel::tr("%1 of all").arg(percentText(100 * part / whole)) : QString();
}

/// Some styles hardly show that a button is down, least of all in dark colours.
void showChecked(QToolButton& button, bool checked)
{
    QPalette palette; // what is not set comes from the parent
    if (checked) {
        palette.setColor(QPalette::Button, QGuiApplication::palette().color(QPalette::Highlight));
        palette.setColor(QPalette::ButtonText, QGuiApplication::palette().color(QPalette::HighlightedText));
    }
    button.setPalette(palette);
    button.setChecked(checked);
}

} // namespace

AccuracyPanel::AccuracyPanel(Session& session, QWidget* parent)
    : QWidget(parent), session_(session), curve_(new AccuracyCurve), slider_(new AccuracySlider), box_(new AccuracyBox),
      inUnits_(new QLabel), sites_(numberLabel("accuracy.sites")), siteShare_(numberLabel("accuracy.siteShare")),
      tetrahedra_(numberLabel("accuracy.tetrahedra")), tetrahedronShare_(numberLabel("accuracy.tetrahedronShare")),
      limit_(new QLabel)
{
    setObjectName("accuracy");
    inUnits_->setObjectName("accuracy.inUnits");
    inUnits_->setToolTip(
        tr("What the percentage means in units of the data. Of curvilinear data it holds for the error "
           "and for the warping: the distance of the mesh from the grid, in percent of the diagonal "
           "of the box around it."));
    limit_->setObjectName("accuracy.limit");
    limit_->setWordWrap(true);

    auto* alongAxis = new QHBoxLayout;
    alongAxis->setContentsMargins(curve_->leftMargin() - slider_->handleInset(), 0,
                                  curve_->rightMargin() - slider_->handleInset(), 0);
    alongAxis->addWidget(slider_);
    auto* label = new QLabel(tr("&Error"));
    label->setBuddy(box_);
    auto* number = new QHBoxLayout;
    number->addWidget(label);
    number->addWidget(box_);
    number->addWidget(inUnits_, 1);

    auto* layout = new QVBoxLayout(this);
    layout->addWidget(curve_, 1);
    layout->addLayout(alongAxis);
    layout->addLayout(makePresets());
    layout->addLayout(number);
    layout->addLayout(makeNumbers());
    layout->addWidget(limit_);
    layout->addStretch();

    const auto choose = [this](double percent) { session_.setError(percent); };
    connect(curve_, &AccuracyCurve::chosen, this, choose);
    connect(slider_, &AccuracySlider::chosen, this, choose);
    connect(box_, &AccuracyBox::chosen, this, choose);
    for (QWidget* input : std::initializer_list<QWidget*>{curve_, slider_, box_})
        new GestureWatcher(input, session_);
    connect(&session_, &Session::modelChanged, this, &AccuracyPanel::showModel);
    connect(&session_, &Session::modelGrown, this, &AccuracyPanel::showModel);
    connect(&session_.view(), &ViewState::errorChanged, this, &AccuracyPanel::showAccuracy);
    showModel();
}

QLayout* AccuracyPanel::makePresets()
{
    auto* row = new QHBoxLayout;
    row->setSpacing(2);
    for (const double percent : accuracyPresets) {
        auto* button = new QToolButton;
        button->setObjectName("accuracy.preset." + QString::number(percent));
        button->setText(QLocale().toString(percent, 'g', 3));
        button->setCheckable(true);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        const QString name =
            percent > 0 ? tr("Error of %1 of the value range").arg(percentText(percent)) : tr("Every sample exact");
        button->setToolTip(name);
        button->setAccessibleName(name);
        connect(button, &QToolButton::clicked, this, [this, percent] {
            session_.setError(percent);
            showAccuracy();
        });
        row->addWidget(button);
        presets_.push_back(button);
    }
    return row;
}

QLayout* AccuracyPanel::makeNumbers()
{
    auto* grid = new QGridLayout;
    grid->setColumnStretch(2, 1);
    grid->setHorizontalSpacing(12);
    grid->addWidget(new QLabel(tr("Sites")), 0, 0);
    grid->addWidget(sites_, 0, 1);
    grid->addWidget(siteShare_, 0, 2);
    grid->addWidget(new QLabel(tr("Tetrahedra")), 1, 0);
    grid->addWidget(tetrahedra_, 1, 1);
    grid->addWidget(tetrahedronShare_, 1, 2);
    return grid;
}

void AccuracyPanel::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        showAccuracy();
}

void AccuracyPanel::showModel()
{
    const auto& model = session_.model();
    setEnabled(model != nullptr);
    curve_->setCurve(model ? sitesAgainstError(*model) : std::vector<CurvePoint>{});
    const double end = model ? 100 * model->finalError() / session_.range().extent() : 0;
    limit_->setText(end > 0
                        ? tr("This model was built down to an error of %1; it has nothing finer.").arg(percentText(end))
                        : QString());
    limit_->setVisible(end > 0);
    showAccuracy();
}

void AccuracyPanel::showAccuracy()
{
    const double error = session_.view().error();
    const MeshSize size = session_.meshSize();
    slider_->setAccuracy(error);
    box_->setAccuracy(error);
    curve_->setMarked({error, size.sites});
    for (std::size_t i = 0; i < presets_.size(); ++i)
        showChecked(*presets_[i], session_.model() && accuracyPresets[i] == error);
    const auto& model = session_.model();
    if (!model) {
        for (QLabel* label : {inUnits_, sites_, siteShare_, tetrahedra_, tetrahedronShare_})
            label->clear();
        return;
    }
    const double extent = session_.range().extent();
    const QString byError = QLocale().toString(error / 100 * extent, 'g', 3);
    if (model->description().warpingWeight > 0)
        inUnits_->setText(tr("of the range, ± %1; warping %2")
                              .arg(byError, QLocale().toString(error / 100 * model->diagonal(), 'g', 3)));
    else
        inUnits_->setText(tr("of the range, ± %1").arg(byError));
    sites_->setText(countText(size.sites));
    siteShare_->setText(shareText(size.sites, model->siteCount()));
    tetrahedra_->setText(countText(size.tetrahedra));
    tetrahedronShare_->setText(shareText(static_cast<double>(size.tetrahedra),
                                         static_cast<double>(meshSizeAt(*model, bothWithin(0)).tetrahedra)));
}

} // namespace tetra
