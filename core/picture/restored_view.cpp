// SPDX-License-Identifier: GPL-3.0-or-later
// A look goes from one model to another: the next time step, the same data built anew, or quite different ones. What is
// a share or a percentage fits any model. Places fit a model of the same domain, and elsewhere as far as they lie in
// the domain; a camera keeps its direction. Values stay what they are, as comparing models needs, and only what no
// value of the model can be is left out. Whatever is left out is told.
#include "core/picture/restored_view.h"

#include "core/base/text.h"
#include "core/picture/view_picture.h"
#include "core/view/appearance.h"
#include "core/view/view_value.h"
#include "plugins/api/scene_parameters.h"
#include "plugins/api/slice_parameters.h"

#include <algorithm>
#include <utility>
#include <variant>

namespace tetra {
namespace {

using Differences = std::vector<SessionDifference>;

constexpr double mostOfRange = 0.5;

bool liesIn(const MovableRegion& region, const Eigen::AlignedBox3d& bounds)
{
    if (const auto* sphere = std::get_if<Sphere>(&region))
        return bounds.contains(sphere->centre);
    const Box& box = std::get<Box>(region);
    return bounds.contains(box.least) && bounds.contains(box.largest);
}

Message cameraText(bool lacksDirections)
{
    return lacksDirections ? Message::say("The model is placed by the directions of its data, but its view was saved "
                                          "without them, because TAn up to version 0.1 read such data differently: its "
                                          "places were other ones. The camera shows all of it; choose regions again.")
                           : Message::say("The domain is different, so the camera keeps its direction and shows all of "
                                          "the model.");
}

/// Takes planes in the coordinates of another domain out of the settings. Whether there were any.
bool dropPlanes(const std::string& id, ViewValue& view)
{
    const auto setting = view.appearance.settings.find(id);
    if (setting == view.appearance.settings.end())
        return false;
    const auto* planes = std::get_if<std::string>(&setting->second);
    const bool isAny = planes == nullptr || !planes->empty();
    view.appearance.settings.erase(setting);
    return isAny;
}

/// From another domain.
void fitPlaces(SessionDocument& kept, const ViewValue& start, const Model& model, Differences& differences)
{
    const bool isElsewhere = lacksDirections(kept, model);
    const auto fits = [&](const MovableRegion& region) {
        return !isElsewhere && liesIn(region, model.description().bounds);
    };
    ViewValue& view = kept.view;
    if (kept.hasCamera)
        differences.push_back({"camera", cameraText(isElsewhere)});
    kept.hasCamera = false;
    const FocusState& focus = view.query.focus;
    if (!std::ranges::all_of(focus.regions(), fits)) {
        differences.push_back({"focus", Message::say("The focus is off: it is not within the domain.")});
        view.query.focus = start.query.focus;
    } else if (!focus.isOn()) {
        view.query.focus = start.query.focus;
    }
    if (!fits(view.query.window.window.box)) {
        if (view.query.window.enabled)
            differences.push_back({"window", Message::say("The crop box is off: it is not within the domain.")});
        view.query.window = start.query.window;
    }
    if (dropPlanes(clipId, view))
        differences.push_back({"clip", Message::say("Nothing is clipped: the clip planes are for another domain.")});
    if (dropPlanes(slicesId, view))
        differences.push_back(
            {"slices", Message::say("The slices have their default position: the saved ones are for another domain.")});
    if (!view.tools.empty()) {
        differences.push_back(
            {"tools", Message::say("What tools have in the picture is left out: it is for another domain.")});
        view.tools.clear();
    }
    if (!view.animation.keys.empty()) {
        differences.push_back(
            {"animation", Message::say("The film has no key frames: their cameras are for another domain.")});
        view.animation = {};
    }
}

bool overlap(const TransferFunction& transfer, const ValueRange& range)
{
    return !transfer.opacities.empty() && transfer.opacities.front().value <= range.maximum &&
           transfer.opacities.back().value >= range.minimum;
}

Message noneWithin(const ValueRange& range)
{
    return Message::say(
        "None of the isovalues lies within the model's values, %1 to %2, so the default ones are shown.",
        formatNumber(range.minimum), formatNumber(range.maximum));
}

/// The values of one range, spread over another one.
struct SpreadValues {
    ValueRange from;
    ValueRange to;

    double factor() const { return from.extent() > 0 ? to.extent() / from.extent() : 1; }
    void spread(double& value) const { value = to.minimum + (value - from.minimum) * factor(); }
    void spread(TransferFunction& function) const
    {
        for (ColourPoint& point : function.colours)
            spread(point.value);
        for (OpacityPoint& point : function.opacities)
            spread(point.value);
        if (function.mask) {
            spread(function.mask->least);
            spread(function.mask->largest);
        }
    }
    void spread(std::vector<Isovalue>& isovalues) const
    {
        for (Isovalue& isovalue : isovalues)
            spread(isovalue.value);
    }
};

/// A look at other values, such as the pressure in place of the speed: what is said of those is not said of these, and
/// what was a share of their range is the same share of this one.
void fitOtherValues(SessionDocument& kept, const Model& model, Differences& differences)
{
    ViewValue& view = kept.view;
    const ValueRange& range = model.description().range;
    const SpreadValues values{kept.range.value_or(range), range};
    values.spread(view.isovalues);
    values.spread(view.appearance.transfer);
    view.appearance.settings.erase(fullGradientId);
    for (auto& [id, setting] : view.appearance.settings)
        if (auto* function = std::get_if<TransferFunction>(&setting))
            values.spread(*function);
        else if (auto* isovalues = std::get_if<std::vector<Isovalue>>(&setting))
            values.spread(*isovalues);
    values.spread(view.query.values.least);
    values.spread(view.query.values.largest);
    view.query.focus.valueFalloff *= values.factor();
    for (KeyFrame& key : view.animation.keys) {
        values.spread(key.frame.isovalues);
        values.spread(key.frame.transfer);
    }
    view.annotations = ofOtherData(std::move(view.annotations));
    kept.range = range;
    differences.push_back(
        {"annotations",
         Message::say("The look is one of '%1', and these values are '%2': title and names are left out, "
                      "and colours and isovalues are spread over the range of these.",
                      visibleText(kept.valueName), visibleText(model.description().valueName))});
}

/// From another range.
void fitIsovalues(ViewValue& view, const ValueRange& range, Differences& differences)
{
    const auto isOutside = [&range](const Isovalue& isovalue) {
        return isovalue.value < range.minimum || isovalue.value > range.maximum;
    };
    const auto outside = std::ranges::count_if(view.isovalues, isOutside);
    if (outside == 0)
        return;
    const bool isAll = outside == std::ssize(view.isovalues);
    const std::string from = formatNumber(range.minimum), to = formatNumber(range.maximum);
    if (isAll) {
        // Another value's surface in its place would be taken for it.
        differences.push_back(
            {"isovalues", Message::say("None of the isovalues lies within the model's values, %1 to %2, so their "
                                       "surfaces are empty.",
                                       from, to)});
        view.isovalues.clear();
    } else {
        differences.push_back({"isovalues", Message::say("%1 of %2 isovalues are left out: they are not within the "
                                                         "model's values, %3 to %4.",
                                                         outside, view.isovalues.size(), from, to)});
        std::erase_if(view.isovalues, isOutside);
    }
}

/// A renderer's own isovalues, which come back as it has them by default.
void fitOwnIsovalues(Appearance& appearance, const ValueRange& range, Differences& differences)
{
    const auto isOutside = [&range](const Isovalue& isovalue) {
        return isovalue.value < range.minimum || isovalue.value > range.maximum;
    };
    const auto lost = std::erase_if(appearance.settings, [&](const auto& setting) {
        const auto* isovalues = std::get_if<std::vector<Isovalue>>(&setting.second);
        return isovalues != nullptr && !isovalues->empty() && std::ranges::all_of(*isovalues, isOutside);
    });
    if (lost > 0 && std::ranges::find(differences, "isovalues", &SessionDifference::part) == differences.end())
        differences.push_back({"isovalues", noneWithin(range)});
}

void fitTransfer(Appearance& appearance, const ViewValue& start, const ValueRange& range, Differences& differences)
{
    const auto tell = [&differences] {
        if (std::ranges::find(differences, "transfer", &SessionDifference::part) == differences.end())
            differences.push_back({"transfer", Message::say("The transfer function has no point within the model's "
                                                            "values, so the default one is shown.")});
    };
    if (!appearance.transfer.opacities.empty() && !overlap(appearance.transfer, range)) {
        tell();
        appearance.transfer = start.appearance.transfer;
    }
    std::erase_if(appearance.settings, [&](const auto& setting) {
        const auto* transfer = std::get_if<TransferFunction>(&setting.second);
        const bool isOutside = transfer != nullptr && !overlap(*transfer, range);
        if (isOutside)
            tell();
        return isOutside;
    });
}

void fitValues(ViewValue& view, const ViewValue& start, const ValueRange& range, Differences& differences)
{
    fitIsovalues(view, range, differences);
    fitOwnIsovalues(view.appearance, range, differences);
    fitTransfer(view.appearance, start, range, differences);
    const ValueFilter& values = view.query.values;
    if (values.enabled && (values.least > range.maximum || values.largest < range.minimum))
        differences.push_back(
            {"values", Message::say("All values are shown: the model has none of the selected ones.")});
    else if (values.enabled)
        return;
    view.query.values = start.query.values;
}

/// Whether how a model was seen says something of the one in its place.
bool isStillOfUse(const SessionDocument& kept, const Model& model)
{
    if (!isOfSameDomain(kept, model))
        return false;
    if (isOfSameRange(kept, model))
        return true;
    const ValueRange& range = model.description().range;
    const double common = std::min(kept.range->maximum, range.maximum) - std::max(kept.range->minimum, range.minimum);
    return common >= mostOfRange * std::max(kept.range->extent(), range.extent());
}

void dropPlacesAndValues(SessionDocument& kept, const ViewValue& start)
{
    ViewValue& view = kept.view;
    view.query.focus = start.query.focus;
    view.query.window = start.query.window;
    view.query.values = start.query.values;
    view.query.range = start.query.range;
    view.appearance.transfer = {};
    view.appearance.settings.erase(clipId);
    view.appearance.settings.erase(slicesId);
    view.tools.clear();
    std::erase_if(view.appearance.settings,
                  [](const auto& setting) { return std::holds_alternative<TransferFunction>(setting.second); });
    view.isovalues = start.isovalues;
    view.annotations = ofOtherData(std::move(view.annotations));
    view.animation = {};
    view.bookmarks.clear();
    const bool trackball = view.camera.trackball;
    view.camera = start.camera;
    view.camera.trackball = trackball;
    kept.hasCamera = false;
    kept.bounds = {};
    kept.range.reset();
}

/// The appearance of the session, where it says one that is known here; else how the model is seen at first. What
/// settings the session does not have are the renderers' own defaults: how it was seen when it was saved.
Appearance known(Appearance appearance, const std::vector<Provided<Renderer>>& modes, const Appearance& start,
                 Differences& differences)
{
    if (rendererOf(modes, appearance.mode) == nullptr) {
        if (!appearance.mode.empty())
            differences.push_back({"mode", Message::say("There is no rendering mode '%1' here, so the model is shown "
                                                        "as '%2'. It may belong to a plugin that is not installed.",
                                                        appearance.mode, start.mode)});
        appearance.mode = start.mode;
    }
    if (appearance.transfer.opacities.empty())
        appearance.transfer = start.transfer;
    return appearance;
}

/// Each as a view of its own; that some are not what they were is told once for all.
void fitBookmarks(SessionDocument& kept, const std::vector<Provided<Renderer>>& modes, const Model& model,
                  const FieldExtent& field, Differences& differences)
{
    std::size_t changed = 0;
    for (Bookmark& bookmark : kept.view.bookmarks) {
        SessionDocument own;
        own.identity = kept.identity;
        own.bounds = kept.bounds;
        own.withDirections = kept.withDirections;
        own.range = kept.range;
        own.valueName = kept.valueName;
        own.view = std::move(bookmark.view);
        own.hasCamera = true;
        RestoredView restored = restoredView(std::move(own), modes, model, field);
        bookmark.view = std::move(restored.document.view);
        if (!restored.document.hasCamera)
            bookmark.view.camera =
                framed(bookmark.view, field.bounds,
                       framedObject(field, rendererOf(modes, bookmark.view.appearance.mode), bookmark.view), 1);
        changed += restored.differences.empty() ? 0 : 1;
    }
    if (changed > 0)
        differences.push_back({"bookmarks", Message::say("%1 of %2 bookmarks cannot be shown as they were saved.",
                                                         changed, kept.view.bookmarks.size())});
}

} // namespace

RestoredView restoredView(SessionDocument kept, const std::vector<Provided<Renderer>>& modes, const Model& model,
                          const FieldExtent& field)
{
    ViewValue start = startingView(modes, model, field);
    start.appearance.transfer = usualTransfer(modes, model, field, corrected(kept.view.query, start.query, model));
    const ValueRange& range = model.description().range;
    RestoredView restored;
    fitBookmarks(kept, modes, model, field, restored.differences); // by what is known of the session's model
    if (isOfOtherValues(kept, model))
        fitOtherValues(kept, model, restored.differences);
    if (!isOfSameDomain(kept, model))
        fitPlaces(kept, start, model, restored.differences);
    if (!isOfSameRange(kept, model))
        fitValues(kept.view, start, range, restored.differences);
    kept.view.appearance = known(std::move(kept.view.appearance), modes, start.appearance, restored.differences);
    FocusState& focus = kept.view.query.focus; // earlier versions wrote no lengths for these
    focus.distance = focus.distance > 0 ? focus.distance : start.query.focus.distance;
    focus.valueFalloff = focus.valueFalloff > 0 ? focus.valueFalloff : start.query.focus.valueFalloff;
    kept.view.query = corrected(kept.view.query, start.query, model);
    for (Isovalue& isovalue : kept.view.isovalues)
        isovalue = corrected(isovalue, range);
    restored.document = std::move(kept);
    return restored;
}

std::optional<SessionDifference> differentModel(const SessionDocument& document, const Model& model)
{
    if (document.identity == 0 || document.identity == modelIdentity(model))
        return std::nullopt;
    return SessionDifference{
        "model", Message::say("The model '%1' has changed since the session was saved: it was rebuilt or replaced.",
                              model.path().string())};
}

RestoredView lastView(SessionDocument kept, const std::vector<Provided<Renderer>>& modes, const Model& model,
                      const FieldExtent& field)
{
    Differences differences;
    if (lacksDirections(kept, model))
        differences.push_back({"camera", cameraText(true)});
    if (!isStillOfUse(kept, model))
        dropPlacesAndValues(kept, startingView(modes, model, field));
    return {restoredView(std::move(kept), modes, model, field).document, differences};
}

} // namespace tetra
