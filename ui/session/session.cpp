// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/session.h"

#include "ui/session/accuracy_scale.h"
#include "ui/session/isovalue_defaults.h"

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

/// Of a step, or of one that it consists of.
bool isTrueOfStep(const QUndoCommand& step, const std::function<bool(const QUndoCommand& step)>& what)
{
    bool found = what(step);
    for (int child = 0; child < step.childCount(); ++child)
        found = found || isTrueOfStep(*step.child(child), what);
    return found;
}

bool changesMoreThanTheView(const QUndoCommand& step)
{
    return step.childCount() == 0 && step.id() != static_cast<int>(CommandId::ChangeView);
}

bool changesTransfer(const QUndoCommand& step)
{
    const auto* look = dynamic_cast<const ChangeLook*>(&step);
    return look != nullptr && look->changesTransfer();
}

bool changesIsovalues(const QUndoCommand& step)
{
    return dynamic_cast<const ChangeIsovalue*>(&step) != nullptr ||
           dynamic_cast<const AddIsovalue*>(&step) != nullptr || dynamic_cast<const RemoveIsovalue*>(&step) != nullptr;
}

} // namespace

Session::Session(QObject* parent) : QObject(parent) {}

MeshSize Session::meshSize() const
{
    return model_ ? plannedSize(view_.query(), *model_) : MeshSize{};
}

ValueRange Session::range() const
{
    return model_ ? model_->description().range : ValueRange{};
}

void Session::open(std::shared_ptr<const Model> model, std::vector<Isovalue> isovalues, Look look)
{
    const QueryState query = startingQuery(*model, startingError(*model));
    open(std::move(model), std::move(isovalues), std::move(look), query);
    followsModel_ = true;
}

void Session::open(std::shared_ptr<const Model> model, std::vector<Isovalue> isovalues, Look look,
                   const QueryState& query)
{
    model_ = std::move(model);
    followsModel_ = false;
    undoStack_.clear();
    shown_.reset();
    for (Isovalue& isovalue : isovalues)
        isovalue = tetra::corrected(isovalue, range());
    view_.reset(corrected(query, startingQuery(*model_, startingError(*model_)), *model_), std::move(isovalues),
                std::move(look));
    emit modelChanged();
}

void Session::grow(std::shared_ptr<const Model> model, const std::vector<Isovalue>& isovalues, const Look& look)
{
    model_ = std::move(model);
    shown_.reset();
    emit modelGrown();
    if (!followsModel_)
        return;
    if (!edited(changesMoreThanTheView))
        view_.setQuery(startingQuery(*model_, startingError(*model_)));
    if (look.transfer != view_.look().transfer && !edited(changesTransfer)) {
        Look fitting = view_.look();
        fitting.transfer = look.transfer;
        view_.setLook(fitting);
    }
    if (isovalues.size() == view_.isovalues().size() && !edited(changesIsovalues))
        for (std::size_t index = 0; index < isovalues.size(); ++index)
            if (isovalues[index] != view_.isovalues()[index])
                view_.setIsovalue(static_cast<int>(index), isovalues[index]);
}

bool Session::edited(const std::function<bool(const QUndoCommand& step)>& what) const
{
    for (int index = 0; index < undoStack_.count(); ++index)
        if (isTrueOfStep(*undoStack_.command(index), what))
            return true;
    return false;
}

void Session::close()
{
    model_.reset();
    undoStack_.clear();
    shown_.reset();
    view_.reset({}, {}, {});
    emit modelChanged();
}

void Session::beginGesture()
{
    gesture_ = ++lastGesture_;
    emit gestureChanged(true);
}

void Session::endGesture()
{
    if (gesture_ == 0)
        return;
    gesture_ = 0;
    emit gestureChanged(false);
}

void Session::setError(double percent)
{
    QueryState query = view_.query();
    query.error = percent;
    query.byBudget = false;
    setQuery(query);
}

void Session::setBudget(std::uint64_t tetrahedra)
{
    QueryState query = view_.query();
    query.budget = tetrahedra;
    query.byBudget = true;
    setQuery(query);
}

void Session::setByBudget(bool byBudget)
{
    QueryState query = view_.query();
    query.byBudget = byBudget;
    setQuery(query);
}

void Session::setFocus(const FocusState& focus)
{
    QueryState query = view_.query();
    query.focus = focus;
    setQuery(query);
}

void Session::setWindow(const WindowState& window)
{
    QueryState query = view_.query();
    query.window = window;
    setQuery(query);
}

void Session::setValueFilter(const ValueFilter& values)
{
    QueryState query = view_.query();
    query.values = values;
    setQuery(query);
}

void Session::setQuery(const QueryState& query)
{
    if (!model_)
        return;
    const QueryState after = corrected(query, view_.query(), *model_);
    if (after != view_.query())
        undoStack_.push(new ChangeQuery(view_, after, gesture_));
}

void Session::setMode(const std::string& mode)
{
    Look look = view_.look();
    look.mode = mode;
    setLook(look);
}

void Session::setTransfer(const TransferFunction& transfer)
{
    if (!checkTransferFunction(transfer))
        return;
    Look look = view_.look();
    look.transfer = transfer;
    setLook(look);
}

void Session::setSetting(const std::string& id, const ParameterValue& value)
{
    Look look = view_.look();
    look.settings[id] = value;
    setLook(look);
}

void Session::setAnnotations(const AnnotationState& annotations)
{
    if (model_ && annotations != view_.annotations())
        undoStack_.push(new ChangeAnnotations(view_, annotations));
}

void Session::setAnimation(const Animation& animation)
{
    const Animation after = corrected(animation);
    if (model_ && after != view_.animation())
        undoStack_.push(new ChangeAnimation(view_, after, gesture_));
}

void Session::setAll(const QueryState& query, const Look& look, const std::vector<Isovalue>& isovalues,
                     const AnnotationState& annotations, const Animation& animation)
{
    setQuery(query);
    setLook(look);
    if (model_ && isovalues != view_.isovalues()) {
        while (view_.isovalueCount() > 0)
            removeIsovalue(view_.isovalueCount() - 1);
        for (const Isovalue& isovalue : isovalues)
            undoStack_.push(new AddIsovalue(view_, isovalue));
    }
    setAnnotations(annotations);
    setAnimation(animation);
}

void Session::restore(const AnnotationState& annotations, const Animation& animation)
{
    view_.setAnnotations(annotations);
    view_.setAnimation(corrected(animation));
}

void Session::setLook(const Look& look)
{
    if (model_ && look != view_.look())
        undoStack_.push(new ChangeLook(view_, look, gesture_));
}

bool Session::showsQuery() const
{
    return shown_ && model_ && shown_->query == meshQuery(view_.query(), *model_);
}

void Session::setShown(const ShownMesh& shown)
{
    shown_ = shown;
    emit shownChanged();
}

void Session::addIsovalue(std::optional<double> value)
{
    if (!model_)
        return;
    Isovalue isovalue = nextIsovalue(view_.isovalues(), range());
    if (value && std::isfinite(*value))
        isovalue.value = std::clamp(*value, range().minimum, range().maximum);
    undoStack_.push(new AddIsovalue(view_, isovalue));
}

void Session::removeIsovalue(int index)
{
    if (hasIsovalue(index))
        undoStack_.push(new RemoveIsovalue(view_, index));
}

void Session::setIsovalue(int index, Isovalue isovalue)
{
    if (!hasIsovalue(index))
        return;
    const Isovalue& before = view_.isovalues()[static_cast<std::size_t>(index)];
    isovalue.value = std::isfinite(isovalue.value) ? isovalue.value : before.value;
    isovalue.opacity = std::isfinite(isovalue.opacity) ? isovalue.opacity : before.opacity;
    isovalue = tetra::corrected(isovalue, range());
    if (isovalue != before)
        undoStack_.push(new ChangeIsovalue(view_, index, isovalue, gesture_));
}

bool Session::hasIsovalue(int index) const
{
    return model_ && index >= 0 && index < view_.isovalueCount();
}

} // namespace tetra
