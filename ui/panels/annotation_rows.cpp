// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/annotation_rows.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QGridLayout>

namespace tetra {
namespace {

class AnnotationRowTexts {
    Q_DECLARE_TR_FUNCTIONS(Annotations)
};

} // namespace

QString annotationText(AnnotationKind kind, bool mnemonic)
{
    QString text;
    switch (kind) {
    case AnnotationKind::ColourBar: text = AnnotationRowTexts::tr("Colour &bar"); break;
    case AnnotationKind::Axes: text = AnnotationRowTexts::tr("A&xes"); break;
    case AnnotationKind::ScaleBar: text = AnnotationRowTexts::tr("&Scale bar"); break;
    case AnnotationKind::Title: text = AnnotationRowTexts::tr("&Title"); break;
    case AnnotationKind::Accuracy: text = AnnotationRowTexts::tr("A&ccuracy"); break;
    }
    return mnemonic ? text : text.remove('&');
}

QString annotationExplanation(AnnotationKind kind)
{
    switch (kind) {
    case AnnotationKind::ColourBar:
        return AnnotationRowTexts::tr(
            "Values and their colours, in the units of the data; right their opacity, with marks at the "
            "isovalues");
    case AnnotationKind::Axes: return AnnotationRowTexts::tr("The directions of x, y and z");
    case AnnotationKind::ScaleBar:
        return AnnotationRowTexts::tr(
            "A length in the units of the data; in perspective that of things as far away as the target");
    case AnnotationKind::Title: return AnnotationRowTexts::tr("The name of the model");
    case AnnotationKind::Accuracy:
        return AnnotationRowTexts::tr("The error that what is shown keeps, in % of the value range");
    }
    return {};
}

AnnotationRows::AnnotationRows(Session& session, QWidget* parent) : QWidget(parent), session_(session)
{
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins({});
    grid->setVerticalSpacing(4);
    grid->setColumnStretch(1, 1);
    for (std::size_t i = 0; i < annotationCount; ++i) {
        const auto kind = static_cast<AnnotationKind>(i);
        const QString name = QString("view.annotation.") + annotationNames[i];
        shown_[i] = new QCheckBox(annotationText(kind));
        shown_[i]->setObjectName(name);
        shown_[i]->setToolTip(annotationExplanation(kind));
        corners_[i] = new QComboBox;
        corners_[i]->setObjectName(name + ".corner");
        corners_[i]->addItems({tr("Top left"), tr("Top right"), tr("Bottom left"), tr("Bottom right")});
        corners_[i]->setToolTip(tr("Corner of the picture"));
        corners_[i]->setAccessibleName(tr("%1: corner").arg(annotationText(kind)));
        const int row = static_cast<int>(i);
        grid->addWidget(shown_[i], row, 0);
        grid->addWidget(corners_[i], row, 1);
        connect(shown_[i], &QCheckBox::clicked, this, [this, i] { edit(i); });
        connect(corners_[i], &QComboBox::activated, this, [this, i] { edit(i); });
    }
    const auto follow = [this] { show(session_.view().annotations); };
    connect(&session_, &Session::modelChanged, this, follow);
    session_.whenChanged(ViewPart::Annotations, this, follow);
    show(session_.view().annotations);
}

void AnnotationRows::show(const AnnotationState& state)
{
    for (std::size_t i = 0; i < annotationCount; ++i) {
        shown_[i]->setChecked(state.places[i].shown);
        corners_[i]->setCurrentIndex(static_cast<int>(state.places[i].corner));
        corners_[i]->setEnabled(state.places[i].shown);
    }
}

void AnnotationRows::edit(std::size_t index)
{
    AnnotationState state = session_.view().annotations;
    state.places[index] = {shown_[index]->isChecked(), static_cast<Corner>(corners_[index]->currentIndex())};
    session_.setAnnotations(state);
}

} // namespace tetra
