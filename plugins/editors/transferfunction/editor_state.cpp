// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/editors/transferfunction/editor_state.h"

#include "plugins/api/value_scale_host.h"
#include "plugins/widgets/curves/whole_function.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tetra {
namespace {

/// The least part of an axis that may fill the plot.
constexpr double leastPart = 1e-6;

/// The values in the middle between two on an axis.
double middleOf(double one, double other, ValueAxis axis)
{
    return valueOnAxis(std::midpoint(placeOnAxis(one, axis), placeOnAxis(other, axis)), axis);
}

/// Moved and cut so that it lies within `whole`; places on an axis.
TransferLimits within(const TransferLimits& part, const TransferLimits& whole)
{
    const double extent = whole.largest - whole.least;
    const double size = std::clamp(part.largest - part.least, leastPart * extent, extent);
    const double least = std::clamp(part.least, whole.least, whole.largest - size);
    return {least, std::min(least + size, whole.largest)};
}

} // namespace

EditorState::EditorState(EditorHost& host, QObject* parent) : QObject(parent), host_(host) {}

void EditorState::edit(const std::string& id)
{
    wanted_ = id;
    host_.setEdited(id);
    followFunctions();
}

void EditorState::followFunctions()
{
    functions_ = host_.parameters();
    const auto isThere = [this](const std::string& id) {
        return std::ranges::find(functions_, id, &Parameter::id) != functions_.end();
    };
    std::string edited = isThere(wanted_) ? wanted_ : transferId;
    if (!functions_.empty() && !isThere(edited))
        edited = functions_.front().id;
    if (edited == edited_)
        return;
    edited_ = std::move(edited);
    current_ = {};
    selection_.clear();
    setView(view_); // cut to what there is to see of this one
    emit editedChanged();
}

const TransferFunction& EditorState::function() const
{
    static const TransferFunction none;
    const auto* function = std::get_if<TransferFunction>(&host_.value(edited_));
    return function != nullptr ? *function : none;
}

const JoinedFunction& EditorState::joinedFunction() const
{
    if (lastSeen_ != function()) {
        lastSeen_ = function();
        joined_ = joined(lastSeen_);
    }
    return joined_;
}

TransferLimits EditorState::range() const
{
    return {host_.range().minimum, host_.range().maximum};
}

TransferLimits EditorState::limits() const
{
    TransferLimits limits = range();
    if (const auto extent = extentOf(function())) {
        limits.least = std::min(limits.least, extent->least);
        limits.largest = std::max(limits.largest, extent->largest);
    }
    return limits;
}

bool EditorState::ofLogarithms() const
{
    const auto* host = dynamic_cast<const ValueScaleHost*>(&host_);
    return host != nullptr && host->holdsLogarithms();
}

ValueFacts EditorState::valueFacts() const
{
    const auto* host = dynamic_cast<const ValueFactsHost*>(&host_);
    return host != nullptr ? host->valueFacts() : ValueFacts();
}

bool EditorState::showsIsovalues() const
{
    const auto* host = dynamic_cast<const ValueFactsHost*>(&host_);
    return host == nullptr || host->showsIsovalues();
}

ValueAxis EditorState::valueAxis() const
{
    return hasPlaces(limits(), view_.valueAxis) && !ofLogarithms() ? view_.valueAxis : ValueAxis::Linear;
}

std::optional<std::size_t> EditorState::currentPoint() const
{
    return current_.kind == EditorItem::Kind::Point ? std::optional(current_.index) : std::nullopt;
}

std::vector<EditorItem> EditorState::items() const
{
    std::vector<EditorItem> items;
    for (std::size_t i = 0; i < joinedFunction().points.size(); ++i)
        items.push_back({EditorItem::Kind::Point, i});
    for (std::size_t i = 0; i < host_.isovalues().size(); ++i)
        items.push_back({EditorItem::Kind::Isovalue, i});
    if (function().mask) {
        items.push_back({EditorItem::Kind::MaskLeast});
        items.push_back({EditorItem::Kind::MaskLargest});
    }
    return items;
}

std::optional<double> EditorState::valueOf(const EditorItem& item) const
{
    const auto valueAt = [&item](const auto& values) {
        return item.index < values.size() ? std::optional(values[item.index].value) : std::nullopt;
    };
    const auto& mask = function().mask;
    switch (item.kind) {
    case EditorItem::Kind::None: break;
    case EditorItem::Kind::Point: return valueAt(joinedFunction().points);
    case EditorItem::Kind::Isovalue: return valueAt(host_.isovalues());
    case EditorItem::Kind::MaskLeast: return mask ? std::optional(mask->least) : std::nullopt;
    case EditorItem::Kind::MaskLargest: return mask ? std::optional(mask->largest) : std::nullopt;
    }
    return std::nullopt;
}

void EditorState::select(TransferSelection selection)
{
    const auto point = currentPoint();
    selection_ = selectionOf(joinedFunction(), std::move(selection));
    if (!point || std::ranges::find(selection_, *point) == selection_.end())
        current_ = selection_.empty() ? EditorItem{} : EditorItem{EditorItem::Kind::Point, selection_.front()};
    emit selectionChanged();
}

void EditorState::setCurrent(const EditorItem& item)
{
    current_ = item;
    selection_.clear();
    if (item.kind == EditorItem::Kind::Point)
        selection_.push_back(item.index);
    forgetWhatIsGone();
}

void EditorState::addToSelection(std::size_t point)
{
    current_ = {EditorItem::Kind::Point, point};
    TransferSelection selection = selection_;
    selection.push_back(point);
    select(std::move(selection));
}

void EditorState::forgetWhatIsGone()
{
    selection_ = selectionOf(joinedFunction(), std::move(selection_));
    const auto all = items();
    if (std::ranges::find(all, current_) == all.end())
        current_ = selection_.empty() ? EditorItem{} : EditorItem{EditorItem::Kind::Point, selection_.front()};
    emit selectionChanged();
}

void EditorState::apply(const EditedSelection& edited)
{
    if (edited.function != joinedFunction())
        setFunction(separated(edited.function));
    select(edited.selection);
}

void EditorState::setCurrentValue(double value)
{
    const TransferMask mask = function().mask.value_or(TransferMask{});
    switch (current_.kind) {
    case EditorItem::Kind::None: return;
    case EditorItem::Kind::Point: {
        const double from = joinedFunction().points[current_.index].value;
        const double first = joinedFunction().points[selection_.front()].value;
        return apply(withValue(joinedFunction(), selection_, first + value - from, rule_, limits()));
    }
    case EditorItem::Kind::Isovalue: {
        Isovalue isovalue = host_.isovalues()[current_.index];
        isovalue.value = value;
        return host_.setIsovalue(current_.index, isovalue);
    }
    case EditorItem::Kind::MaskLeast:
        return setFunction(withMask(function(), {std::min(value, mask.largest), mask.largest}));
    case EditorItem::Kind::MaskLargest:
        return setFunction(withMask(function(), {mask.least, std::max(value, mask.least)}));
    }
}

void EditorState::removeCurrent()
{
    switch (current_.kind) {
    case EditorItem::Kind::None: return;
    case EditorItem::Kind::Point: return apply(withoutSelected(joinedFunction(), selection_));
    case EditorItem::Kind::Isovalue: return host_.removeIsovalue(current_.index);
    case EditorItem::Kind::MaskLeast:
    case EditorItem::Kind::MaskLargest: return setFunction(withoutMask(function()));
    }
}

void EditorState::setView(const EditorView& view)
{
    view_ = view;
    view_.heights = within(view.heights, {0, 1});
    if (view.values) {
        const TransferLimits places = placesOnAxis(limits(), valueAxis());
        const auto placeOf = [&](double value) {
            return hasPlaces({value, value}, valueAxis()) ? placeOnAxis(value, valueAxis()) : places.least;
        };
        const TransferLimits seen = within({placeOf(view.values->least), placeOf(view.values->largest)}, places);
        const bool isAll = seen.least <= places.least && seen.largest >= places.largest;
        view_.values = isAll ? std::nullopt : std::optional(valuesOnAxis(seen, valueAxis()));
    }
    emit viewChanged();
}

void EditorState::setRule(NeighbourRule rule)
{
    rule_ = rule;
}

std::optional<double> pickedValue(const EditorState& state)
{
    const auto picked = state.host().picked();
    return picked ? std::optional(picked->value) : std::nullopt;
}

std::optional<EditedPoint> withSeenPoint(const JoinedFunction& function, double value)
{
    constexpr float opacity = 0.4F;
    auto added = withPoint(function, value);
    if (!added || !function.points.empty())
        return added;
    const Colour colour = distinctColour(2); // stands out from light grounds and from dark ones
    added->function.points.front().colour = {colour.red, colour.green, colour.blue};
    added->function.points.front().opacity = opacity;
    return added;
}

void addPoint(EditorState& state, std::optional<double> value)
{
    const auto [least, largest] = state.shown();
    const auto& points = state.joinedFunction().points;
    if (const auto point = state.currentPoint(); point && !value) {
        const double from = points[*point].value;
        const auto next = std::ranges::upper_bound(points, from, {}, &TransferPoint::value);
        value = middleOf(from, next != points.end() ? next->value : largest, state.valueAxis());
    }
    if (const auto added =
            withSeenPoint(state.joinedFunction(), value.value_or(middleOf(least, largest, state.valueAxis()))))
        state.apply({added->function, {added->point}});
}

double opacityOf(const TransferFunction& function, double value)
{
    return -std::expm1(-evaluateUnmasked(function, value).extinction * function.unitDistance);
}

} // namespace tetra
