// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/editors/transferfunction/edit_menu.h"

#include "plugins/editors/transferfunction/point_clipboard.h"
#include "plugins/editors/transferfunction/rescale_dialog.h"
#include "plugins/widgets/curves/arranging.h"
#include "plugins/widgets/curves/reshaping.h"
#include "plugins/widgets/curves/whole_function.h"

#include <QActionGroup>

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

constexpr double opacityFactor = 1.25;
constexpr double widening = 1.25;
constexpr double peakWidth = 0.1;   ///< of what is seen
constexpr double peakOpacity = 0.5; ///< at least
constexpr double maskInset = 0.1;   ///< of what is seen

} // namespace

EditMenu::EditMenu(EditorState& state, QWidget* parent) : QMenu(parent), state_(state)
{
    setObjectName("transfer.editMenu");
    setToolTipsVisible(true);
    addWhole();
    addRescaling();
    addSeparator();
    addSelecting();
    addSeparator();
    addArranging();
    addAligning();
    addGroups();
    addRules();
    addSeparator();
    addMaskAndIsovalues();
    addPicked();
    connect(&state, &EditorState::selectionChanged, this, &EditMenu::enableWhatIsPossible);
    enableWhatIsPossible();
}

QAction* EditMenu::add(QMenu& menu, const char* name, const QString& text, const std::function<void()>& run)
{
    QAction* action = menu.addAction(text);
    action->setObjectName(QString("transfer.change.") + name);
    connect(action, &QAction::triggered, this, run);
    return action;
}

void EditMenu::addEdit(QMenu& menu, const char* name, const QString& text, std::size_t points, const Change& change)
{
    QAction* action =
        add(menu, name, text, [this, change] { state_.apply(change(state_.joinedFunction(), state_.selection())); });
    needing_.push_back({action, points});
}

void EditMenu::addWhole()
{
    const auto whole = [this](const char* name, const QString& text, auto change) {
        add(*this, name, text, [this, change] { state_.setFunction(change(state_.function())); });
    };
    whole("denser", tr("&More opaque"),
          [](const TransferFunction& old) { return withScaledOpacity(old, opacityFactor); });
    whole("thinner", tr("&Less opaque"),
          [](const TransferFunction& old) { return withScaledOpacity(old, 1 / opacityFactor); });
    whole("mirror", tr("Swap &ends"), [this](const TransferFunction& old) { return mirrored(old, state_.range()); });
    const auto wider = [](const TransferFunction& old, double factor) {
        const auto extent = extentOf(old);
        return extent ? widened(old, (extent->least + extent->largest) / 2, factor) : old;
    };
    whole("widen", tr("&Wider"), [wider](const TransferFunction& old) { return wider(old, widening); });
    whole("narrow", tr("Na&rrower"), [wider](const TransferFunction& old) { return wider(old, 1 / widening); });
}

void EditMenu::addRescaling()
{
    rescaling_ = addMenu(tr("Rescale"));
    rescaling_->setObjectName("transfer.rescaleMenu");
    const auto spread = [this](const char* name, const QString& text, const std::function<void()>& run) {
        add(*rescaling_, name, text, run);
    };
    spread("spread", tr("To the values of the &data"),
           [this] { state_.setFunction(spreadOver(state_.function(), state_.range())); });
    spread("spread.shown", tr("To the values &shown in the plot"),
           [this] { state_.setFunction(spreadOver(state_.function(), state_.shown())); });
    spread("spread.numbers", tr("To &numbers…"), [this] { askForRange(state_, parentWidget()); });
}

/// The canvas has these keys while it is in use; here they are only shown.
void EditMenu::addSelecting()
{
    const auto keys = [](QAction* action, const QKeySequence& sequence) {
        action->setShortcut(sequence);
        action->setShortcutContext(Qt::WidgetShortcut);
        return action;
    };
    keys(add(*this, "selectAll", tr("Select &all points"),
             [this] { state_.select(allPoints(state_.joinedFunction())); }),
         QKeySequence::SelectAll);
    needing_.push_back({keys(add(*this, "copy", tr("&Copy points"), [this] { copyPoints(state_); }), //
                             QKeySequence::Copy),
                        1});
    keys(add(*this, "paste", tr("&Paste points"), [this] { pastePoints(state_, place_); }), QKeySequence::Paste);
    needing_.push_back({keys(add(*this, "duplicate", tr("D&uplicate points"), [this] { duplicatePoints(state_); }),
                             Qt::CTRL | Qt::Key_D),
                        1});
    needing_.push_back(
        {keys(add(*this, "delete", tr("&Remove points"),
                  [this] { state_.apply(withoutSelected(state_.joinedFunction(), state_.selection())); }),
              QKeySequence::Delete),
         1});
    colour_ = keys(add(*this, "colour", tr("Colour…"), [this] { emit colourWanted(); }), Qt::Key_C);
}

void EditMenu::addArranging()
{
    using Function = JoinedFunction;
    using Selection = TransferSelection;
    addEdit(*this, "distribute", tr("&Distribute values evenly"), 3,
            [this](const Function& f, const Selection& s) { return distributeValues(f, s, state_.limits()); });
    addEdit(*this, "flip", tr("&Flip left to right"), 2,
            [this](const Function& f, const Selection& s) { return flipValues(f, s, state_.limits()); });
    addEdit(*this, "invert", tr("&Invert opacities"), 1, &invertOpacities);
    addEdit(*this, "ramp", tr("Ramp from first to last"), 2, &rampOpacities);
    addEdit(*this, "logarithm", tr("Follow the logarit&hm of the value"), 2,
            [](const Function& f, const Selection& s) { return withLogarithmicCourse(f, s, {}); });
    addEdit(*this, "simplify", tr("&Simplify: fewer points, same look"), 3,
            [](const Function& f, const Selection& s) { return simplified(f, s, {}); });
    add(*this, "peak", tr("Add a pea&k"), [this] {
        const TransferLimits seen = state_.shown();
        const double opacity = std::max(peakOpacity, opacityOf(state_.function(), place()));
        state_.apply(withPeak(state_.joinedFunction(), {place(), peakWidth * (seen.largest - seen.least), opacity},
                              state_.limits()));
    });
}

void EditMenu::addAligning()
{
    QMenu& menu = *addMenu(tr("Ali&gn"));
    const auto align = [&](const char* name, const QString& text, Alignment alignment) {
        addEdit(menu, name, text, 2, [alignment](const JoinedFunction& f, const TransferSelection& s) {
            return alignOpacities(f, s, alignment);
        });
    };
    align("align.first", tr("Opacities to the &first"), Alignment::First);
    align("align.mean", tr("Opacities to the &mean"), Alignment::Mean);
    align("align.least", tr("Opacities to the &least"), Alignment::Least);
    align("align.largest", tr("Opacities to the l&argest"), Alignment::Largest);
    menu.addSeparator();
    addEdit(menu, "align.values", tr("&Values of two neighbours: a step"), 2,
            [](const JoinedFunction& f, const TransferSelection& s) { return alignValues(f, s, Alignment::Mean); });
}

void EditMenu::addGroups()
{
    QMenu& assign = *addMenu(tr("Make a gr&oup"));
    QMenu& select = *addMenu(tr("Select a group"));
    for (int group = 0; group <= largestTransferGroup; ++group) {
        const QByteArray number = QByteArray::number(group);
        const QString name = tr("Group &%1").arg(group) + '\t';
        const QKeySequence keys(Qt::CTRL | static_cast<Qt::Key>(Qt::Key_0 + group));
        addEdit(assign, "group.assign." + number, name + keys.toString(QKeySequence::NativeText), 1,
                [group](const JoinedFunction& f, const TransferSelection& s) { return withGroup(f, s, group); });
        add(select, "group.select." + number, name + number,
            [this, group] { state_.select(pointsOfGroup(state_.joinedFunction(), group)); });
    }
    addEdit(assign, "group.none", tr("&No group"), 1,
            [](const JoinedFunction& f, const TransferSelection& s) { return withGroup(f, s, std::nullopt); });
}

void EditMenu::addRules()
{
    QMenu& menu = *addMenu(tr("When points meet neighbouri&ng points"));
    auto* group = new QActionGroup(&menu);
    const auto rule = [&](const char* name, const QString& text, NeighbourRule kind) {
        QAction* action = add(menu, name, text, [this, kind] { state_.setRule(kind); });
        action->setCheckable(true);
        action->setChecked(state_.rule() == kind);
        group->addAction(action);
    };
    rule("rule.stop", tr("&Stop"), NeighbourRule::Stop);
    rule("rule.push", tr("&Push them along"), NeighbourRule::Push);
    rule("rule.pass", tr("Move p&ast them"), NeighbourRule::Pass);
}

void EditMenu::addMaskAndIsovalues()
{
    mask_ = add(*this, "mask", tr("Mas&k: show some values only"), [this] { setMasked(state_, mask_->isChecked()); });
    mask_->setCheckable(true);
    add(*this, "addIsovalue", tr("Add an iso&value"), [this] { state_.host().addIsovalue(place()); });
}

/// What is done at the value that is picked in the picture.
void EditMenu::addPicked()
{
    QMenu& menu = *addMenu(tr("From &the picked value"));
    const auto here = [&](const char* name, const QString& text, const std::function<void(double)>& run) {
        QAction* action = add(menu, name, text, [this, run] {
            if (const auto value = pickedValue(state_))
                run(*value);
        });
        needingPicked_.push_back(action);
        return action;
    };
    QAction* point = here("picked.point", tr("Add a &point"), [this](double value) { addPoint(state_, value); });
    point->setShortcut(Qt::Key_Insert); // the plot has the key; here it is only shown
    point->setShortcutContext(Qt::WidgetShortcut);
    here("picked.isovalue", tr("Add an &isovalue"), [this](double value) { state_.host().addIsovalue(value); });
    here("picked.forget", tr("Cl&ear mark"), [this](double) { state_.host().forgetPicked(); });
}

double EditMenu::place() const
{
    const TransferLimits seen = state_.shown();
    return place_.value_or(state_.valueOf(state_.current()).value_or((seen.least + seen.largest) / 2));
}

void EditMenu::enableWhatIsPossible()
{
    for (const Needing& needing : needing_)
        needing.action->setEnabled(state_.selection().size() >= needing.points);
    for (QAction* action : needingPicked_)
        action->setEnabled(pickedValue(state_).has_value());
    colour_->setEnabled(!state_.selection().empty() || state_.current().kind == EditorItem::Kind::Isovalue);
    const auto extent = extentOf(state_.function());
    rescaling_->setEnabled(extent && extent->least < extent->largest);
    mask_->setChecked(state_.joinedFunction().mask.has_value());
}

void setMasked(EditorState& state, bool on)
{
    const auto& points = state.joinedFunction().points;
    const TransferSelection& selection = state.selection();
    const TransferLimits seen = state.shown();
    const double inset = maskInset * (seen.largest - seen.least);
    TransferMask mask{seen.least + inset, seen.largest - inset};
    if (selection.size() >= 2)
        mask = {points[selection.front()].value, points[selection.back()].value};
    state.setFunction(on ? withMask(state.function(), mask) : withoutMask(state.function()));
}

} // namespace tetra
