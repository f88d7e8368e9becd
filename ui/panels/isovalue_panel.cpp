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

    connect(&session_, &Session::modelChanged, this, &IsovaluePanel::showModel);
    session_.whenChanged(ViewPart::Isovalues, this, &IsovaluePanel::follow);
    showModel();
}

/// Rows anew: they know the range of the values.
void IsovaluePanel::showModel()
{
    setEnabled(session_.model() != nullptr);
    keepRows(0);
    follow();
}

void IsovaluePanel::follow()
{
    const std::size_t count = session_.view().isovalues.size();
    keepRows(count);
    for (IsovalueRow* row : rows_)
        row->refresh();
    while (rows_.size() < count) {
        rows_.push_back(new IsovalueRow(session_, static_cast<int>(rows_.size())));
        rowsLayout_->addWidget(rows_.back());
    }
    hint_->setVisible(session_.model() != nullptr && rows_.empty());
}

void IsovaluePanel::keepRows(std::size_t count)
{
    for (; rows_.size() > count; rows_.pop_back()) {
        rowsLayout_->removeWidget(rows_.back());
        rows_.back()->setParent(nullptr);
        rows_.back()->deleteLater(); // later: it may be in the middle of telling that its button was clicked
    }
}

} // namespace tetra
