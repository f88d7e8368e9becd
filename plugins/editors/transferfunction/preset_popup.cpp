// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/editors/transferfunction/preset_popup.h"

#include "plugins/editors/transferfunction/own_presets.h"

#include <QAction>
#include <QBoxLayout>
#include <QComboBox>
#include <QCoreApplication>
#include <QInputDialog>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScreen>
#include <QScrollBar>

#include <algorithm>
#include <system_error>

namespace tetra {
namespace {

constexpr QSize previewSize(72, 18);
constexpr QSize popupSize(340, 360);
constexpr int widestList = 600; ///< names of the user's own may be long

} // namespace

PresetPopup::PresetPopup(EditorState& state, QWidget* parent)
    : QFrame(parent, Qt::Popup), state_(state), search_(new QLineEdit), part_(new QComboBox), list_(new QListWidget),
      nothing_(new QLabel), save_(new QPushButton(tr("&Save as preset…"))), delete_(new QPushButton(tr("&Delete")))
{
    setObjectName("transfer.presetPopup");
    setFrameStyle(QFrame::StyledPanel | QFrame::Raised);
    search_->setObjectName("transfer.presetPopup.search");
    search_->setPlaceholderText(tr("Search: bone, lung, metal, plasma…"));
    search_->setAccessibleName(tr("Search for a preset"));
    search_->setToolTip(search_->accessibleName());
    search_->setClearButtonEnabled(true);
    search_->installEventFilter(this);
    part_->setObjectName("transfer.presetPopup.part");
    part_->setAccessibleName(tr("Parts of a preset to apply"));
    part_->setToolTip(part_->accessibleName());
    part_->addItems({tr("Colours and opacities"), tr("Colours alone"), tr("Opacities alone")});
    list_->setObjectName("transfer.presetPopup.list");
    list_->setAccessibleName(tr("Presets"));
    list_->setIconSize(previewSize);
    list_->setUniformItemSizes(true);
    nothing_->setObjectName("transfer.presetPopup.nothing");
    nothing_->setTextFormat(Qt::PlainText);
    nothing_->setWordWrap(true);
    nothing_->setAlignment(Qt::AlignCenter);
    nothing_->setForegroundRole(QPalette::PlaceholderText);
    (new QVBoxLayout(list_->viewport()))->addWidget(nothing_);
    save_->setObjectName("transfer.presetPopup.save");
    save_->setToolTip(tr("Keep the current transfer function for this and other models"));
    delete_->setObjectName("transfer.presetPopup.delete");
    delete_->setToolTip(tr("Delete the selected preset, if it is one of your own"));
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(save_);
    buttons->addStretch();
    buttons->addWidget(delete_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 6, 6, 6);
    column->addWidget(search_);
    column->addWidget(part_);
    column->addWidget(list_);
    column->addLayout(buttons);
    connect(search_, &QLineEdit::textChanged, this, &PresetPopup::narrow);
    connect(search_, &QLineEdit::returnPressed, this, [this] { take(list_->currentItem()); });
    connect(part_, &QComboBox::currentIndexChanged, this, &PresetPopup::narrow);
    connect(list_, &QListWidget::itemClicked, this, &PresetPopup::take);
    connect(list_, &QListWidget::itemActivated, this, &PresetPopup::take);
    connect(list_, &QListWidget::currentItemChanged, this, &PresetPopup::enableWhatIsPossible);
    connect(save_, &QPushButton::clicked, this, &PresetPopup::askForName);
    connect(delete_, &QPushButton::clicked, this, &PresetPopup::remove);
    addActions();
    fill();
    readOwn([] { return Status(); });
}

void PresetPopup::readOwn(const std::function<Status()>& change)
{
    const auto read = [this, change, number = ++newest_] {
        const Status changed = change();
        QMetaObject::invokeMethod(
            this,
            [this, changed, presets = ownPresets(), number] {
                if (!changed)
                    state_.host().tell(changed.error().message);
                if (number != newest_)
                    return;
                own_ = presets;
                fill();
            },
            Qt::QueuedConnection);
    };
    try {
        files_ = std::jthread([read, before = std::move(files_)]() mutable {
            if (before.joinable())
                before.join();
            read();
        });
    } catch (const std::system_error&) {
        read(); // after the one before, which has ended by now
    }
}

/// Of the supplied ones made once: they stay what they are.
QIcon PresetPopup::iconOf(const Preset& preset)
{
    if (preset.isOwn)
        return presetIcon(preset, previewSize);
    const auto [known, isNew] = icons_.try_emplace(preset.id);
    if (isNew)
        known->second = presetIcon(preset, previewSize);
    return known->second;
}

/// The supplied presets as commands.
void PresetPopup::addActions()
{
    for (const Preset& preset : suppliedPresets()) {
        auto* action = new QAction(iconOf(preset), preset.name, this);
        action->setObjectName("transfer." + preset.id);
        connect(action, &QAction::triggered, this, [this, preset] { apply(preset, PresetPart::Both); });
    }
}

/// The one that is chosen stays chosen.
void PresetPopup::fill()
{
    const QVariant chosen = list_->currentItem() != nullptr ? list_->currentItem()->data(Qt::UserRole) : QVariant();
    presets_ = own_;
    std::ranges::move(suppliedPresets(), std::back_inserter(presets_));
    list_->clear();
    for (const Preset& preset : presets_) {
        auto* item = new QListWidgetItem(iconOf(preset), preset.name, list_);
        item->setData(Qt::UserRole, preset.id);
        item->setToolTip(preset.isOwn          ? tr("Your own preset")
                         : preset.isHounsfield ? tr("Values in Hounsfield units (HU)")
                                               : preset.source);
    }
    const int widest =
        list_->sizeHintForColumn(0) + list_->verticalScrollBar()->sizeHint().width() + 2 * list_->frameWidth();
    list_->setMinimumWidth(std::min(widest, widestList));
    narrow();
    for (int row = 0; row < list_->count(); ++row)
        if (list_->item(row)->data(Qt::UserRole) == chosen && !list_->item(row)->isHidden())
            list_->setCurrentRow(row);
}

/// Shows what is meant by the text, and has what is to be taken.
void PresetPopup::narrow()
{
    QListWidgetItem* first = nullptr;
    for (int row = 0; row < list_->count(); ++row) {
        QListWidgetItem* item = list_->item(row);
        const Preset& preset = *presetOf(item);
        const bool fits = isMeant(preset, search_->text()) && (part() != PresetPart::Opacities || preset.hasOpacities);
        item->setHidden(!fits);
        if (fits && first == nullptr)
            first = item;
    }
    list_->setCurrentItem(first);
    tellWhatIsFound(first != nullptr);
    enableWhatIsPossible();
}

void PresetPopup::tellWhatIsFound(bool any)
{
    const QString text =
        part() == PresetPart::Opacities ? tr("No preset with opacities matches “%1”.") : tr("No preset matches “%1”.");
    nothing_->setText(any ? QString() : text.arg(search_->text()));
    nothing_->setVisible(!any);
    list_->setAccessibleDescription(nothing_->text());
}

void PresetPopup::showAt(const QWidget& button)
{
    search_->clear();
    readOwn([] { return Status(); });
    narrow();
    const QRect screen = button.screen()->availableGeometry();
    const QSize size = popupSize.expandedTo(minimumSizeHint());
    const QPoint below = button.mapToGlobal(QPoint(0, button.height()));
    const QPoint above = button.mapToGlobal(QPoint(0, -size.height()));
    QPoint place = below.y() + size.height() <= screen.bottom() ? below : above;
    place.setX(std::clamp(place.x(), screen.left(), std::max(screen.left(), screen.right() - size.width())));
    place.setY(std::clamp(place.y(), screen.top(), std::max(screen.top(), screen.bottom() - size.height())));
    setGeometry({place, size});
    show();
    search_->setFocus();
}

/// From the search the arrow keys go through the list.
bool PresetPopup::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == search_ && event->type() == QEvent::KeyPress) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->key() == Qt::Key_Down || key->key() == Qt::Key_Up) {
            QCoreApplication::sendEvent(list_, event);
            return true;
        }
    }
    return QFrame::eventFilter(watched, event);
}

const Preset* PresetPopup::presetOf(const QListWidgetItem* item) const
{
    const int row = item != nullptr ? list_->row(item) : -1;
    return row >= 0 ? &presets_[static_cast<std::size_t>(row)] : nullptr;
}

PresetPart PresetPopup::part() const
{
    return static_cast<PresetPart>(part_->currentIndex());
}

void PresetPopup::take(const QListWidgetItem* item)
{
    const Preset* preset = presetOf(item);
    if (preset == nullptr || item->isHidden())
        return;
    hide();
    apply(*preset, part());
}

void PresetPopup::apply(const Preset& preset, PresetPart part)
{
    const TransferLimits range = state_.range();
    const HounsfieldUnits units = hounsfieldUnits(state_.valueFacts(), range);
    const TransferFunction made = withPreset(state_.function(), preset, part, rangeOf(preset, units, range), //
                                             state_.host().diagonal());
    state_.setFunction(made);
    if (const auto assumed = assumptionOf(preset, units, range))
        state_.host().tell(*assumed);
}

void PresetPopup::askForName()
{
    auto* dialog = new QInputDialog(parentWidget());
    dialog->setObjectName("transfer.presetName");
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Save as Preset"));
    dialog->setLabelText(tr("Name of the preset:"));
    dialog->setWhatsThis(save_->toolTip());
    connect(dialog, &QInputDialog::textValueSelected, this, &PresetPopup::save);
    hide();
    dialog->open();
}

void PresetPopup::save(const QString& name)
{
    const TransferLimits range = state_.range();
    if (name.trimmed().isEmpty() || !(range.least < range.largest))
        return;
    readOwn([name = name.trimmed(), preset = tetra::presetOf(state_.function(), range, state_.host().diagonal())] {
        return saveOwnPreset(name, preset);
    });
}

void PresetPopup::remove()
{
    const Preset* preset = presetOf(list_->currentItem());
    if (preset == nullptr || !preset->isOwn)
        return;
    readOwn([name = preset->name] { return deleteOwnPreset(name); });
}

void PresetPopup::enableWhatIsPossible()
{
    const Preset* preset = presetOf(list_->currentItem());
    delete_->setEnabled(preset != nullptr && preset->isOwn);
}

} // namespace tetra
