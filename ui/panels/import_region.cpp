// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/import_region.h"

#include "plugins/widgets/value_box.h"
#include "ui/opening/import_texts.h"
#include "ui/widgets/check_label.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>

#include <algorithm>

namespace tetra {
namespace {

constexpr std::array axisNames{"x", "y", "z"};

int pointOf(double number, int last)
{
    return static_cast<int>(std::clamp(number, 0.0, static_cast<double>(last)));
}

} // namespace

ImportRegion::ImportRegion(QWidget* parent)
    : QWidget(parent), count_(new CheckLabel("import.region.count")), reset_(new QPushButton(tr("&All Points"))),
      inBox_(new QCheckBox(tr("Only a &box in space")))
{
    setObjectName("import.region");
    reset_->setObjectName("import.region.reset");
    reset_->setToolTip(tr("Takes every point of the dataset"));
    grid_ = makeGrid();
    space_ = makeSpace();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins({});
    layout->addWidget(grid_);
    layout->addWidget(space_);
    space_->hide();
    connect(reset_, &QPushButton::clicked, this, [this] {
        reset();
        emit edited();
    });
}

QSpinBox* ImportRegion::makeBox(const QString& name, const QString& accessibleName, const QString& toolTip)
{
    auto* box = new QSpinBox;
    box->setObjectName("import.region." + name);
    box->setAccessibleName(accessibleName);
    box->setToolTip(toolTip);
    box->setAlignment(Qt::AlignRight);
    box->setMinimumWidth(64);
    connect(box, &QSpinBox::valueChanged, this, [this] {
        showCount();
        emit edited();
    });
    return box;
}

QWidget* ImportRegion::makeGrid()
{
    auto* widget = new QWidget;
    auto* grid = new QGridLayout(widget);
    grid->setContentsMargins({});
    grid->addWidget(new QLabel(tr("First")), 0, 1);
    grid->addWidget(new QLabel(tr("Last")), 0, 2);
    grid->addWidget(new QLabel(tr("Stride")), 0, 3);
    for (int axis = 0; axis < 3; ++axis) {
        const QString name = axisNames[static_cast<std::size_t>(axis)];
        grid->addWidget(new QLabel(name), axis + 1, 0);
        Axis& boxes = axes_[static_cast<std::size_t>(axis)];
        boxes.first =
            makeBox("first." + name, tr("First point along %1").arg(name), tr("First point taken, counted from 0"));
        boxes.last =
            makeBox("last." + name, tr("Last point along %1").arg(name), tr("Last point taken, counted from 0"));
        boxes.stride = makeBox("stride." + name, tr("Stride along %1").arg(name), tr("Keep every n-th point"));
        grid->addWidget(boxes.first, axis + 1, 1);
        grid->addWidget(boxes.last, axis + 1, 2);
        grid->addWidget(boxes.stride, axis + 1, 3);
    }
    grid->addWidget(reset_, 1, 4);
    grid->addWidget(count_, 4, 0, 1, 5);
    grid->setColumnStretch(5, 1);
    return widget;
}

QWidget* ImportRegion::makeSpace()
{
    auto* widget = new QWidget;
    auto* grid = new QGridLayout(widget);
    grid->setContentsMargins({});
    inBox_->setObjectName("import.region.inBox");
    inBox_->setToolTip(tr("Takes only what lies in a box; for irregular meshes, whole tetrahedra"));
    grid->addWidget(inBox_, 0, 0, 1, 4);
    for (int axis = 0; axis < 3; ++axis)
        grid->addWidget(new QLabel(axisNames[static_cast<std::size_t>(axis)]), 1, axis + 1, Qt::AlignHCenter);
    for (int corner = 0; corner < 2; ++corner) {
        grid->addWidget(new QLabel(corner == 0 ? tr("From") : tr("To")), 2 + corner, 0);
        for (int axis = 0; axis < 3; ++axis) {
            const QString name = axisNames[static_cast<std::size_t>(axis)];
            auto* box = new ValueBox;
            box->setObjectName((corner == 0 ? "import.region.from." : "import.region.to.") + name);
            box->setAccessibleName(corner == 0 ? tr("From %1").arg(name) : tr("To %1").arg(name));
            box->setToolTip(tr("A corner of the box, in the coordinates of the data"));
            box->setValueRange(-1e12, 1e12);
            box->setEnabled(false);
            connect(inBox_, &QCheckBox::toggled, box, &QWidget::setEnabled);
            connect(box, &ValueBox::valueChanged, this, &ImportRegion::edited);
            grid->addWidget(box, 2 + corner, axis + 1);
            corners_[static_cast<std::size_t>(3 * corner + axis)] = box;
        }
    }
    connect(inBox_, &QCheckBox::clicked, this, &ImportRegion::edited);
    return widget;
}

void ImportRegion::setGrid(const Lattice& lattice)
{
    const DatasetPart before = part();
    const bool isSame = lattice_ && lattice_->size == lattice.size;
    lattice_ = lattice;
    grid_->show();
    space_->hide();
    if (isSame)
        return;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int last = static_cast<int>(std::min<std::uint32_t>(lattice.size[axis] - 1, 1 << 30));
        const QSignalBlocker first(axes_[axis].first);
        const QSignalBlocker end(axes_[axis].last);
        const QSignalBlocker stride(axes_[axis].stride);
        axes_[axis].first->setRange(0, last - 1);
        axes_[axis].last->setRange(1, last);
        axes_[axis].stride->setRange(1, last);
    }
    reset();
    if (partOfLattice(lattice, before))
        setPart(before);
}

void ImportRegion::setSpace()
{
    lattice_.reset();
    grid_->hide();
    space_->show();
}

void ImportRegion::reset()
{
    setPart({});
}

void ImportRegion::setPart(const DatasetPart& part)
{
    if (!isGrid()) {
        inBox_->setChecked(part.region.has_value());
        for (std::size_t i = 0; part.region && i < 6; ++i)
            corners_[i]->setValue(i < 3 ? part.region->min()[static_cast<int>(i)]
                                        : part.region->max()[static_cast<int>(i - 3)]);
        return;
    }
    for (std::size_t a = 0; a < 3; ++a) {
        const auto axis = static_cast<int>(a);
        const QSignalBlocker first(axes_[a].first);
        const QSignalBlocker last(axes_[a].last);
        const QSignalBlocker stride(axes_[a].stride);
        const int end = axes_[a].last->maximum();
        axes_[a].first->setValue(part.region ? pointOf(part.region->min()[axis], end) : 0);
        axes_[a].last->setValue(part.region ? pointOf(part.region->max()[axis], end) : end);
        axes_[a].stride->setValue(static_cast<int>(part.stride[a]));
    }
    showCount();
}

DatasetPart ImportRegion::part() const
{
    DatasetPart part;
    if (!isGrid()) {
        if (inBox_->isChecked())
            part.region =
                Eigen::AlignedBox3d(Eigen::Vector3d(corners_[0]->value(), corners_[1]->value(), corners_[2]->value()),
                                    Eigen::Vector3d(corners_[3]->value(), corners_[4]->value(), corners_[5]->value()));
        return part;
    }
    Eigen::Vector3d first;
    Eigen::Vector3d last;
    bool isAll = true;
    for (std::size_t a = 0; a < 3; ++a) {
        const auto axis = static_cast<int>(a);
        first[axis] = axes_[a].first->value();
        last[axis] = axes_[a].last->value();
        isAll = isAll && axes_[a].first->value() == 0 && axes_[a].last->value() == axes_[a].last->maximum();
        part.stride[a] = static_cast<std::uint32_t>(axes_[a].stride->value());
    }
    if (!isAll)
        part.region = Eigen::AlignedBox3d(first, last);
    return part;
}

std::optional<std::uint64_t> ImportRegion::points() const
{
    const auto taken = isGrid() ? partOfLattice(*lattice_, part()) : Result<Lattice>(Error{});
    return taken ? std::optional(taken->pointCount()) : std::nullopt;
}

bool ImportRegion::isUsable() const
{
    const DatasetPart taken = part();
    if (isGrid())
        return partOfLattice(*lattice_, taken).ok();
    return !taken.region || (taken.region->min().array() <= taken.region->max().array()).all();
}

void ImportRegion::showCount()
{
    if (!isGrid())
        return;
    const ImportCheck check = countPart(*lattice_, part());
    count_->showCheck(check.fits, check.text);
    reset_->setEnabled(!part().isWhole());
}

} // namespace tetra
