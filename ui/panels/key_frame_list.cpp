// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/key_frame_list.h"

#include "core/view/animation.h"
#include "plugins/widgets/number_text.h"
#include "ui/session/session.h"

#include <QGridLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLocale>
#include <QTableWidget>
#include <QToolButton>

namespace tetra {
namespace {

QString timeText(double seconds)
{
    return QLocale().toString(seconds, 'f', 2);
}

QString describe(const FilmFrame& frame)
{
    const QLocale locale;
    const QString view =
        KeyFrameList::tr("%1°, %2° at %3")
            .arg(locale.toString(frame.camera.azimuth, 'f', 0), locale.toString(frame.camera.elevation, 'f', 0),
                 locale.toString(frame.camera.distance, 'g', 3));
    return frame.byBudget ? KeyFrameList::tr("%1, %2 tetrahedra").arg(view, countText(frame.budget))
                          : KeyFrameList::tr("%1, error %2").arg(view, percentText(frame.error));
}

} // namespace

KeyFrameList::KeyFrameList(Session& session, QWidget* parent)
    : QWidget(parent), session_(session), table_(new QTableWidget(0, 2))
{
    table_->setObjectName("animation.keys");
    table_->setAccessibleName(tr("Key frames"));
    table_->setToolTip(tr("Enter shows a key frame, Delete removes it, Alt with an arrow moves it"));
    table_->setHorizontalHeaderLabels({tr("Time (s)"), tr("View")});
    table_->horizontalHeaderItem(1)->setToolTip(
        tr("Azimuth and elevation, distance in the units of the data, accuracy"));
    table_->horizontalHeader()->resizeSection(0, 70);
    table_->horizontalHeader()->setStretchLastSection(true);
    table_->verticalHeader()->hide();
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setTabKeyNavigation(false);
    table_->setMinimumHeight(66);
    table_->installEventFilter(this);
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins({});
    grid->addWidget(table_, 0, 0, 1, 3);
    const auto place = [grid](QToolButton* button, int row, int column) { grid->addWidget(button, row, column); };
    place(
        addButton("add", tr("&Add View"), tr("Add the current view as the next key frame"), &KeyFrameList::addPresent),
        1, 0);
    ofKeys_ = {addButton("update", tr("&Replace"), tr("Replace this key frame with the current view"),
                         &KeyFrameList::replaceByPresent),
               addButton("show", tr("S&how"), tr("Show this key frame (Enter)"), &KeyFrameList::showKey),
               addButton("remove", tr("Re&move"), tr("Remove this key frame (Delete)"), &KeyFrameList::remove),
               addButton("up", tr("&Earlier"), tr("Swap with the previous key frame (Alt+Up)"), &KeyFrameList::up),
               addButton("down", tr("La&ter"), tr("Swap with the next key frame (Alt+Down)"), &KeyFrameList::down)};
    for (std::size_t i = 0; i < ofKeys_.size(); ++i)
        place(ofKeys_[i], 1 + static_cast<int>(i + 1) / 3, static_cast<int>(i + 1) % 3);
    connect(table_, &QTableWidget::cellChanged, this, [this](int row, int) { setTime(row); });
    connect(table_, &QTableWidget::cellDoubleClicked, this, [this](int, int column) {
        if (column == 1)
            showKey();
    });
    connect(table_, &QTableWidget::itemSelectionChanged, this, &KeyFrameList::enableButtons);
    session_.whenChanged(ViewPart::Animation, this, &KeyFrameList::fill);
    connect(&session_, &Session::modelChanged, this, &KeyFrameList::fill);
    fill();
}

QToolButton* KeyFrameList::addButton(const char* name, const QString& text, const QString& toolTip,
                                     void (KeyFrameList::*clicked)())
{
    auto* button = new QToolButton;
    button->setObjectName(QString("animation.keys.") + name);
    button->setText(text);
    button->setToolTip(toolTip);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(button, &QToolButton::clicked, this, clicked);
    return button;
}

bool KeyFrameList::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() != QEvent::KeyPress)
        return QWidget::eventFilter(watched, event);
    const auto& key = *static_cast<QKeyEvent*>(event);
    const bool alt = key.modifiers().testFlag(Qt::AltModifier);
    if (key.key() == Qt::Key_Delete)
        remove();
    else if (key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter)
        showKey();
    else if (alt && (key.key() == Qt::Key_Up || key.key() == Qt::Key_Down))
        move(key.key() == Qt::Key_Up ? -1 : 1);
    else
        return QWidget::eventFilter(watched, event);
    return true;
}

void KeyFrameList::fill()
{
    const int selected = current();
    filling_ = true;
    const auto& keys = session_.view().animation.keys;
    table_->setRowCount(static_cast<int>(keys.size()));
    for (int row = 0; row < table_->rowCount(); ++row) {
        const KeyFrame& key = keys[static_cast<std::size_t>(row)];
        table_->setItem(row, 0, new QTableWidgetItem(timeText(key.time)));
        auto* description = new QTableWidgetItem(describe(key.frame));
        description->setFlags(description->flags() & ~Qt::ItemIsEditable);
        table_->setItem(row, 1, description);
    }
    filling_ = false;
    select(std::min(selected, table_->rowCount() - 1));
    enableButtons();
}

void KeyFrameList::enableButtons()
{
    for (QToolButton* button : ofKeys_)
        button->setEnabled(current() >= 0);
}

int KeyFrameList::current() const
{
    const auto rows = table_->selectionModel()->selectedRows();
    return rows.isEmpty() ? -1 : rows.first().row();
}

void KeyFrameList::select(int index)
{
    if (index >= 0)
        table_->setCurrentCell(index, 1);
}

void KeyFrameList::addPresent()
{
    session_.setAnimation(withKey(session_.view().animation, frameOf(session_.view())));
    select(table_->rowCount() - 1);
}

void KeyFrameList::replaceByPresent()
{
    const ViewValue& view = session_.view();
    if (current() < 0)
        return;
    Animation animation = view.animation;
    animation.keys[static_cast<std::size_t>(current())].frame = frameOf(view);
    session_.setAnimation(animation);
}

void KeyFrameList::showKey()
{
    if (current() < 0)
        return;
    const FilmFrame& frame = session_.view().animation.keys[static_cast<std::size_t>(current())].frame;
    session_.setView(withFrame(session_.view(), frame), tr("Show Key Frame"));
}

void KeyFrameList::remove()
{
    if (current() >= 0)
        session_.setAnimation(withoutKey(session_.view().animation, current()));
}

void KeyFrameList::move(int steps)
{
    const int from = current();
    const int to = from + steps;
    if (from < 0 || to < 0 || to >= table_->rowCount())
        return;
    session_.setAnimation(withKeyMoved(session_.view().animation, from, steps));
    select(to);
}

/// What is no time changes nothing.
void KeyFrameList::setTime(int row)
{
    if (filling_)
        return;
    bool good = false;
    const double time = QLocale().toDouble(table_->item(row, 0)->text(), &good);
    const Animation& animation = session_.view().animation;
    const Animation edited = good ? withKeyAt(animation, row, time) : animation;
    session_.setAnimation(edited);
    // In its own time: the editor is still open.
    QMetaObject::invokeMethod(this, &KeyFrameList::fill, Qt::QueuedConnection);
}

} // namespace tetra
