// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/session.h"

#include "ui/session/accuracy_scale.h"
#include "ui/session/isovalue_defaults.h"

#include <algorithm>

namespace tetra {
namespace {

/// Opacities below this cannot be seen, and a surface that cannot be seen is hidden, not transparent.
constexpr float leastOpacity = 0.01F;

} // namespace

Session::Session(QObject* parent) : QObject(parent) {}

MeshSize Session::meshSize() const
{
    return model_ ? meshSizeAt(*model_, bothWithin(view_.error())) : MeshSize{};
}

ValueRange Session::range() const
{
    return model_ ? model_->description().range : ValueRange{};
}

void Session::open(std::shared_ptr<const Model> model, std::vector<Isovalue> isovalues)
{
    model_ = std::move(model);
    undoStack_.clear();
    view_.reset(startingError(*model_), std::move(isovalues));
    emit modelChanged();
}

void Session::grow(std::shared_ptr<const Model> model)
{
    model_ = std::move(model);
    emit modelGrown();
    if (undoStack_.count() == 0)
        view_.setError(startingError(*model_));
}

void Session::close()
{
    model_.reset();
    undoStack_.clear();
    view_.reset(view_.error(), {});
    emit modelChanged();
}

void Session::beginGesture()
{
    gesture_ = ++lastGesture_;
}

void Session::endGesture()
{
    gesture_ = 0;
}

void Session::setError(double percent)
{
    percent = std::clamp(percent, 0.0, 100.0);
    if (model_ && percent != view_.error())
        undoStack_.push(new ChangeError(view_, percent, gesture_));
}

void Session::addIsovalue(std::optional<double> value)
{
    if (!model_)
        return;
    Isovalue isovalue = nextIsovalue(view_.isovalues(), range());
    if (value)
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
    isovalue.value = std::clamp(isovalue.value, range().minimum, range().maximum);
    isovalue.opacity = std::clamp(isovalue.opacity, leastOpacity, 1.0F);
    if (isovalue != view_.isovalues()[static_cast<std::size_t>(index)])
        undoStack_.push(new ChangeIsovalue(view_, index, isovalue, gesture_));
}

bool Session::hasIsovalue(int index) const
{
    return model_ && index >= 0 && index < view_.isovalueCount();
}

} // namespace tetra
