// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/isovalue_panel.h"

#include "plugins/widgets/icons.h"
#include "ui/panels/isovalue_row.h"

#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

namespace tetra {

IsovaluePanel::IsovaluePanel(Session& session, QWidget* parent)
    : QWidget(parent), session_(session), rowsLayout_(new QVBoxLayout), hint_(new QLabel),
      add_(new QPushButton(glyphIcon(Glyph::Add), tr("&Add Isovalue")))
{
    setObjectName("isovalues");
    hint_->setObjectName("isovalues.hint");
    hint_->setText(tr("No isovalue: there is nothing to draw but the outline."));
    hint_->setWordWrap(true);
    hint_->setForegroundRole(QPalette::PlaceholderText);
    add_->setObjectName("isovalues.add");
    add_->setToolTip(tr("Add an isosurface at another value (Ctrl+I)"));
    connect(add_, &QPushButton::clicked, this, [this] {
        session_.addIsovalue();
        rows_.back()->focusValue();
    });

    auto* content = new QWidget;
    auto* contentLayout = new QVBoxLayout(content);
    contentLayout->setContentsMargins(0, 0, 0, 0);
    rowsLayout_->setSpacing(0);
    contentLayout->addLayout(rowsLayout_);
    contentLayout->addWidget(hint_);
    contentLayout->addStretch();
    auto* scroll = new QScrollArea;
    scroll->setWidget(content);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(scroll, 1);
    layout->addWidget(add_);

    const ViewState* view = &session_.view();
    connect(&session_, &Session::modelChanged, this, &IsovaluePanel::rebuild);
    connect(view, &ViewState::isovalueInserted, this, &IsovaluePanel::insertRow);
    connect(view, &ViewState::isovalueRemoved, this, &IsovaluePanel::removeRow);
    connect(view, &ViewState::isovalueChanged, this,
            [this](int index) { rows_[static_cast<std::size_t>(index)]->refresh(); });
    rebuild();
}

void IsovaluePanel::rebuild()
{
    while (!rows_.empty())
        removeRow(static_cast<int>(rows_.size()) - 1);
    for (int index = 0; index < session_.view().isovalueCount(); ++index)
        insertRow(index);
    setEnabled(session_.model() != nullptr);
    hint_->setVisible(session_.model() != nullptr && rows_.empty());
}

void IsovaluePanel::insertRow(int index)
{
    auto* row = new IsovalueRow(session_, index);
    rows_.insert(rows_.begin() + index, row);
    rowsLayout_->insertWidget(index, row);
    renumber();
}

void IsovaluePanel::removeRow(int index)
{
    IsovalueRow* row = rows_[static_cast<std::size_t>(index)];
    rows_.erase(rows_.begin() + index);
    rowsLayout_->removeWidget(row);
    row->setParent(nullptr);
    row->deleteLater(); // later: it may be in the middle of telling that its button was clicked
    renumber();
}

void IsovaluePanel::renumber()
{
    for (int index = 0; index < std::min(static_cast<int>(rows_.size()), session_.view().isovalueCount()); ++index)
        rows_[static_cast<std::size_t>(index)]->setIndex(index);
    hint_->setVisible(rows_.empty());
}

} // namespace tetra
