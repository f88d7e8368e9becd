// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/solid_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace tetra {
namespace {

enum Side { Above, Below, Open };

} // namespace

SolidDialog::SolidDialog(QWidget* parent)
    : QDialog(parent), side_(new QComboBox), largestPart_(new QCheckBox(tr("&Largest part only"))),
      deviation_(new QCheckBox(tr("&Measure the deviation")))
{
    setObjectName("solidOptions");
    setWindowTitle(tr("Save Solids"));
    auto* explanation = new QLabel(tr("The displayed isosurfaces are closed where they meet the boundary of the mesh, "
                                      "so that each is the surface of a solid, as 3D printing requires."));
    explanation->setWordWrap(true);
    side_->setObjectName("solid.side");
    side_->addItems({tr("Values above the isovalue"), tr("Values below the isovalue"), tr("None: leave them open")});
    side_->setToolTip(tr("Where the solid lies: on which side of the isosurface"));
    largestPart_->setObjectName("solid.largestPart");
    largestPart_->setToolTip(tr("Save only the part of each surface with the largest area"));
    deviation_->setObjectName("solid.deviation");
    deviation_->setToolTip(tr("Also measure how far the surfaces are from those of the finest mesh; this takes as long "
                              "as showing the model at error 0"));
    auto* form = new QFormLayout;
    form->addRow(tr("S&olid:"), side_);
    form->addRow(largestPart_);
    form->addRow(deviation_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(explanation);
    layout->addLayout(form);
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

SurfaceMaking SolidDialog::making() const
{
    SurfaceMaking making{.largestPart = largestPart_->isChecked()};
    if (side_->currentIndex() != Open)
        making.solid = side_->currentIndex() == Above ? SolidSide::Above : SolidSide::Below;
    return making;
}

bool SolidDialog::measuresDeviation() const
{
    return deviation_->isChecked();
}

} // namespace tetra
