// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/view_commands.h"

namespace tetra {

ChangeQuery::ChangeQuery(ViewState& state, const QueryState& after, Gesture gesture)
    : QUndoCommand(nameOf(state.query(), after)), state_(state), before_(state.query()), after_(after),
      gesture_(gesture)
{
}

QString ChangeQuery::nameOf(const QueryState& before, const QueryState& after)
{
    if (before.focus != after.focus)
        return tr("Change Focus");
    if (before.window != after.window)
        return tr("Change Window");
    if (before.values != after.values)
        return tr("Change Values");
    return after.byBudget ? tr("Change Budget") : tr("Change Accuracy");
}

bool ChangeQuery::mergeWith(const QUndoCommand* next)
{
    const auto& other = *static_cast<const ChangeQuery*>(next);
    if (gesture_ == 0 || other.gesture_ != gesture_)
        return false;
    after_ = other.after_;
    setObsolete(after_ == before_);
    return true;
}

LookParts LookParts::difference(const Look& look, const Look& other)
{
    LookParts parts;
    if (look.mode != other.mode)
        parts.mode = look.mode;
    if (look.transfer != other.transfer)
        parts.transfer = look.transfer;
    if (look.settings != other.settings)
        parts.settings = look.settings;
    return parts;
}

Look LookParts::putInto(Look look) const
{
    look.mode = mode.value_or(std::move(look.mode));
    look.transfer = transfer.value_or(std::move(look.transfer));
    look.settings = settings.value_or(std::move(look.settings));
    return look;
}

void LookParts::complete(const LookParts& others)
{
    mode = mode ? mode : others.mode;
    transfer = transfer ? transfer : others.transfer;
    settings = settings ? settings : others.settings;
}

ChangeLook::ChangeLook(ViewState& state, const Look& after, Gesture gesture)
    : QUndoCommand(nameOf(state.look(), after)), state_(state), before_(LookParts::difference(state.look(), after)),
      after_(LookParts::difference(after, state.look())), gesture_(gesture)
{
}

QString ChangeLook::nameOf(const Look& before, const Look& after)
{
    if (before.mode != after.mode)
        return tr("Change Rendering Mode");
    if (before.transfer != after.transfer)
        return tr("Change Transfer Function");
    return tr("Change Rendering");
}

bool ChangeLook::mergeWith(const QUndoCommand* next)
{
    const auto& other = *static_cast<const ChangeLook*>(next);
    if (gesture_ == 0 || other.gesture_ != gesture_)
        return false;
    LookParts later = other.after_;
    later.complete(after_);
    after_ = std::move(later);
    before_.complete(other.before_);
    setObsolete(after_ == before_);
    return true;
}

ChangeAnnotations::ChangeAnnotations(ViewState& state, const AnnotationState& after)
    : QUndoCommand(tr("Change Annotations")), state_(state), before_(state.annotations()), after_(after)
{
}

ChangeAnimation::ChangeAnimation(ViewState& state, Animation after, Gesture gesture)
    : QUndoCommand(tr("Change Animation")), state_(state), before_(state.animation()), after_(std::move(after)),
      gesture_(gesture)
{
}

bool ChangeAnimation::mergeWith(const QUndoCommand* next)
{
    const auto& other = *static_cast<const ChangeAnimation*>(next);
    if (gesture_ == 0 || other.gesture_ != gesture_)
        return false;
    after_ = other.after_;
    setObsolete(after_ == before_);
    return true;
}

ChangeIsovalue::ChangeIsovalue(ViewState& state, int index, const Isovalue& isovalue, Gesture gesture)
    : QUndoCommand(tr("Change Isovalue")), state_(state), index_(index),
      before_(state.isovalues()[static_cast<std::size_t>(index)]), after_(isovalue), gesture_(gesture)
{
}

bool ChangeIsovalue::mergeWith(const QUndoCommand* next)
{
    const auto& other = *static_cast<const ChangeIsovalue*>(next);
    if (gesture_ == 0 || other.gesture_ != gesture_ || other.index_ != index_)
        return false;
    after_ = other.after_;
    setObsolete(after_ == before_);
    return true;
}

AddIsovalue::AddIsovalue(ViewState& state, const Isovalue& isovalue)
    : QUndoCommand(tr("Add Isovalue")), state_(state), index_(state.isovalueCount()), isovalue_(isovalue)
{
}

RemoveIsovalue::RemoveIsovalue(ViewState& state, int index)
    : QUndoCommand(tr("Remove Isovalue")), state_(state), index_(index),
      isovalue_(state.isovalues()[static_cast<std::size_t>(index)])
{
}

} // namespace tetra
