// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/random_edits.h"

#include "core/view/animation.h"
#include "plugins/widgets/curves/arranging.h"
#include "plugins/widgets/curves/copying.h"
#include "plugins/widgets/curves/moving.h"
#include "plugins/widgets/curves/reshaping.h"
#include "plugins/widgets/curves/whole_function.h"

#include <tan/transfer.h>

#include <cmath>
#include <limits>

namespace tetra {
namespace {

constexpr std::size_t mostPoints = 40; ///< a person's function
constexpr std::size_t mostIsovalues = 4;
constexpr std::size_t mostKeys = 6;
constexpr std::size_t mostBookmarksKept = 3;

TransferSelection anySelection(const JoinedFunction& function, std::mt19937& random)
{
    TransferSelection selection;
    for (std::size_t i = 0; i < function.points.size(); ++i)
        if (random() % 2 == 0)
            selection.push_back(i);
    return selection;
}

} // namespace

RandomEdits::RandomEdits(Session& session, std::vector<std::string> modes, unsigned seed)
    : session_(session), modes_(std::move(modes)), random_(seed), series_(session.newGesture())
{
}

double RandomEdits::number(double least, double largest)
{
    switch (below(60)) {
    case 0: return std::numeric_limits<double>::quiet_NaN();
    case 1: return -std::numeric_limits<double>::infinity();
    case 2: return 1e300;
    default: return std::uniform_real_distribution<double>(least, largest)(random_);
    }
}

double RandomEdits::value()
{
    const ValueRange range = session_.range();
    return number(range.minimum - 0.1 * range.extent(), range.maximum + 0.1 * range.extent());
}

void RandomEdits::editOnce()
{
    switch (below(15)) {
    case 14: return editBookmarks();
    case 13: return editTools();
    case 12:
        return session_.setLens({static_cast<LensState::Shape>(below(3)), number(-0.1, 1.1), number(-0.1, 1.1),
                                 number(0, 0.6), number(0, 20), number(-1, 110)});
    case 0: return editQuery();
    case 1: return editLook();
    case 2: return editIsovalues();
    case 3: return editAnnotations();
    case 4: return editAnimation();
    case 5: return editCamera();
    case 6: return session_.setBackground(anyBackground());
    case 7: return dragOrNot();
    default: return editTransfer();
    }
}

void RandomEdits::finish()
{
    session_.endGesture();
}

void RandomEdits::dragOrNot()
{
    if (session_.inGesture())
        session_.endGesture();
    else
        session_.beginGesture();
}

void RandomEdits::editTransfer()
{
    const ValueRange range = session_.range();
    const TransferLimits limits{range.minimum, range.maximum};
    const TransferFunction whole = session_.view().appearance.transfer;
    const JoinedFunction now = joined(whole);
    const TransferSelection some = anySelection(now, random_);
    const auto rule = static_cast<NeighbourRule>(below(3));
    const auto alignment = static_cast<Alignment>(below(4));
    const double by = number(-0.2, 0.2) * range.extent();
    const auto setWhole = [this](const TransferFunction& function) { session_.setTransfer(function); };
    const auto set = [this](const JoinedFunction& function) { session_.setTransfer(separated(function)); };
    if (now.points.size() > mostPoints) {
        const JoinedFunction simple = simplified(now, allPoints(now), {0.2, 0.2}).function;
        return simple.points.size() > mostPoints
                   ? setWhole(sequentialTransferFunction(limits.least, limits.largest, now.unitDistance))
                   : set(simple);
    }
    switch (below(20)) {
    case 0: return set(withPoint(now, value()).value_or(EditedPoint{now, 0}).function);
    case 1: return set(withoutSelected(now, {below(8)}).function);
    case 2: return set(alignOpacities(now, some, alignment).function);
    case 3: return set(alignValues(now, some, alignment).function);
    case 4: return set(distributeValues(now, some, limits).function);
    case 5: return set(flipValues(now, some, limits).function);
    case 6: return set(invertOpacities(now, some).function);
    case 7: return set(rampOpacities(now, some).function);
    case 8: return set(withPeak(now, {value(), number(0, 0.3) * range.extent(), number(0, 1)}, limits).function);
    case 9: return set(duplicated(now, {below(8)}, by, limits).function);
    case 10: return setWhole(shifted(whole, by));
    case 11: return setWhole(widened(whole, value(), number(0.5, 2)));
    case 12: return setWhole(withMask(whole, {value(), value()}));
    case 13: return setWhole(withoutMask(whole));
    case 14: return set(withGroup(now, some, static_cast<int>(below(12)) - 1).function);
    case 15: return setWhole(withColourMap(whole, colourMaps()[below(colourMaps().size())], limits));
    case 16: return setWhole(withUnitDistance(whole, number(0.5, 2) * now.unitDistance));
    case 17:
        return setWhole({{{value(), {1, 0, 0}}, {value(), {}}},
                         {{value(), static_cast<float>(number(-0.5, 1.5))}, {value(), 1}},
                         number(-1, 9)});
    default:
        return set(moveSelected(now, some, {by, number(-0.2, 0.2), OpacityAxis::Logarithmic}, rule, limits).function);
    }
}

FocusState RandomEdits::anyFocus()
{
    FocusState focus = session_.view().query.focus;
    focus.shape = static_cast<FocusState::Shape>(below(6));
    const Eigen::AlignedBox3d bounds = session_.model()->description().bounds;
    for (int axis = 0; axis < 3; ++axis) {
        focus.centre[axis] = number(bounds.min()[axis], bounds.max()[axis]);
        focus.size[axis] = number(0, 1) * bounds.sizes()[axis];
    }
    focus.radius = number(0, 0.5) * bounds.diagonal().norm();
    focus.error = number(0, 5);
    focus.falloff = number(0, 0.5) * bounds.diagonal().norm();
    focus.distance = number(-0.1, 1.1) * bounds.diagonal().norm();
    focus.valueFalloff = value();
    switch (below(4)) {
    case 0: return focus.added();
    case 1: return focus.removed();
    case 2: return focus.selected(below(3));
    default: break;
    }
    return focus;
}

WindowState RandomEdits::anyWindow()
{
    WindowState window = session_.view().query.window;
    window.enabled = !window.enabled;
    window.window.border = static_cast<WindowBorder>(below(3));
    for (int axis = 0; axis < 3; ++axis)
        window.window.box.least[axis] += number(-1, 1);
    return window;
}

void RandomEdits::editQuery()
{
    switch (below(9)) {
    case 8:
        return session_.setRange({session_.view().appearance.mode == "isosurface" && below(2) == 0, number(-1, 30),
                                  number(0, 120), number(0, 30), number(0, 120), number(0, 30), number(0, 120)});
    case 7: return session_.setWarping({static_cast<WarpingLimit>(below(3)), number(-1, 120)});
    case 0: return session_.setBudget(below(200'000));
    case 1: return session_.setByBudget(below(2) == 0);
    case 2: return session_.setFocus(anyFocus());
    case 3: return session_.setWindow(anyWindow());
    case 4: return session_.setValueFilter({below(2) == 0, value(), value()});
    case 5: return session_.setQuery({number(0, 5), false, 0, anyFocus(), anyWindow(), {}});
    default: return session_.setError(number(-1, 20));
    }
}

void RandomEdits::editLook()
{
    switch (below(5)) {
    case 0: return session_.setSetting("shaded", below(2) == 0);
    case 1: return session_.setSetting("outline", below(2) == 0);
    case 2: return session_.setSetting("outline", std::string("of another type"));
    case 3: return session_.setSetting("clip", std::string(below(2) == 0 ? "" : "1,0,0,4"));
    default: // volumes of a range are refused
        return session_.setMode(session_.view().query.range.enabled ? "isosurface" : modes_[below(modes_.size())]);
    }
}

void RandomEdits::editIsovalues()
{
    if (session_.view().isovalues.size() > mostIsovalues)
        return session_.removeIsovalue(static_cast<int>(below(mostIsovalues)));
    switch (below(5)) {
    case 0: return session_.addIsovalue();
    case 1: return session_.addIsovalue(value());
    case 2: return session_.removeIsovalue(static_cast<int>(below(6)) - 1);
    default: break;
    }
    Isovalue isovalue;
    isovalue.value = value();
    isovalue.opacity = static_cast<float>(number(0, 1));
    isovalue.visible = below(3) != 0;
    session_.setIsovalue(static_cast<int>(below(6)) - 1, isovalue);
}

void RandomEdits::editAnnotations()
{
    AnnotationState annotations = session_.view().annotations;
    annotations.places[below(annotationCount)] = {below(2) == 0, static_cast<Corner>(below(4))};
    annotations.barEnds.reset();
    if (below(3) == 0)
        annotations.barEnds = BarEnds{number(-5, -1), number(1, 5)};
    annotations.quantity = below(2) == 0 ? "Density" : "";
    annotations.numbers.decimals = static_cast<int>(below(mostDecimals));
    annotations.lengths.style = static_cast<NumberFormat::Style>(below(3));
    annotations.textSize = smallestTextSize + static_cast<double>(below(40));
    annotations.boldText = below(2) == 0;
    session_.setAnnotations(annotations);
}

void RandomEdits::editAnimation()
{
    Animation animation = session_.view().animation;
    const auto key = static_cast<int>(below(mostKeys));
    if (animation.keys.size() > mostKeys)
        return session_.setAnimation(withoutKey(animation, key));
    switch (below(8)) {
    case 0: animation.kind = static_cast<Animation::Kind>(below(2)); break;
    case 1: animation.framesPerSecond = number(0, 130); break;
    case 2:
        animation.turntable = {static_cast<Turntable::Axis>(below(2)), number(-400, 400), static_cast<int>(below(500))};
        break;
    case 3: animation = withKeyAt(animation, key, number(0, 10)); break;
    case 4: animation = withKeyMoved(animation, key, below(2) == 0 ? 1 : -1); break;
    case 5: animation = withoutKey(animation, key); break;
    case 6:
        if (!animation.keys.empty())
            return session_.setView(withFrame(session_.view(), animation.keys[below(animation.keys.size())].frame),
                                    "Show Key Frame");
        break;
    default: animation = withKey(animation, frameOf(session_.view())); break;
    }
    session_.setAnimation(animation);
}

/// Also of a plugin that is not there, and what is as good as nothing.
void RandomEdits::editTools()
{
    ViewValue view = session_.view();
    const char* const ids[] = {"ruler", "plane", "example.gone"};
    std::string& text = view.tools[ids[below(3)]];
    switch (below(4)) {
    case 0: text.clear(); break;
    case 1: text = "1,2,3 4,5,6; " + std::to_string(below(100)); break;
    default: text += "x \"ü\" "; break;
    }
    if (text.size() > 60)
        text.clear();
    session_.setView(std::move(view));
}

void RandomEdits::editBookmarks()
{
    ViewValue view = session_.view();
    const std::size_t number = below(mostBookmarksKept);
    const bool isThere = number < view.bookmarks.size();
    switch (below(4)) {
    case 0:
        if (isThere)
            view.bookmarks.erase(view.bookmarks.begin() + static_cast<std::ptrdiff_t>(number));
        break;
    case 1:
        if (isThere)
            view = atBookmark(view, Bookmark(view.bookmarks[number]));
        break;
    default: view = withBookmark(view, "\"ü\" " + std::to_string(number));
    }
    session_.setView(std::move(view));
}

/// Some of them a series of keys.
void RandomEdits::editCamera()
{
    Camera camera = session_.view().camera;
    const Eigen::AlignedBox3d bounds = session_.model()->description().bounds;
    if (below(3) == 0)
        series_ = session_.newGesture();
    switch (below(7)) {
    case 0: return session_.fitCamera();
    case 1: return session_.setCamera(upright(camera, static_cast<UpAxis>(below(6))));
    case 2: camera.perspective = !camera.perspective; break;
    case 3: camera.trackball = !camera.trackball; break;
    case 4:
        camera.target = {number(bounds.min().x(), bounds.max().x()), number(-9, 9), number(-9, 9)};
        camera.distance = number(0.1, 2 * bounds.diagonal().norm());
        camera.fieldOfView = number(-10, 200);
        camera.elevation = number(-100, 100);
        break;
    default: return session_.setCamera(turned(camera, number(-90, 90), number(-40, 40)), series_);
    }
    session_.setCamera(camera);
}

std::optional<Colour> RandomEdits::anyBackground()
{
    if (below(3) == 0)
        return std::nullopt;
    return Colour{static_cast<float>(number(-0.2, 1.2)), static_cast<float>(number(0, 1)), 0.5F};
}

} // namespace tetra
