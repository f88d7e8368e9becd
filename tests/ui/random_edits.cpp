// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/random_edits.h"

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
constexpr int mostIsovalues = 4;
constexpr std::size_t mostKeys = 6; ///< of a film

TransferSelection anySelection(const JoinedFunction& function, std::mt19937& random)
{
    TransferSelection selection;
    for (std::size_t i = 0; i < function.points.size(); ++i)
        if (random() % 2 == 0)
            selection.push_back(i);
    return selection;
}

} // namespace

RandomEdits::RandomEdits(Session& session, Viewport& viewport, std::vector<std::string> modes, unsigned seed)
    : session_(session), viewport_(viewport), modes_(std::move(modes)), random_(seed)
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
    switch (below(12)) {
    case 0: return editQuery();
    case 1: return editLook();
    case 2: return editIsovalues();
    case 3: return dragOrNot();
    case 4: return editAnnotations();
    case 5: return editAnimation();
    case 6: return editCamera();
    case 7: return editBackground();
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
    const TransferFunction whole = session_.view().look().transfer;
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
    FocusState focus = session_.view().query().focus;
    focus.shape = static_cast<FocusState::Shape>(below(3));
    const Eigen::AlignedBox3d bounds = session_.model()->description().bounds;
    for (int axis = 0; axis < 3; ++axis) {
        focus.centre[axis] = number(bounds.min()[axis], bounds.max()[axis]);
        focus.size[axis] = number(0, 1) * bounds.sizes()[axis];
    }
    focus.radius = number(0, 0.5) * bounds.diagonal().norm();
    focus.error = number(0, 5);
    focus.falloff = number(0, 0.5) * bounds.diagonal().norm();
    return focus;
}

WindowState RandomEdits::anyWindow()
{
    WindowState window = session_.view().query().window;
    window.enabled = !window.enabled;
    window.window.border = static_cast<WindowBorder>(below(3));
    for (int axis = 0; axis < 3; ++axis)
        window.window.box.least[axis] += number(-1, 1);
    return window;
}

void RandomEdits::editQuery()
{
    switch (below(7)) {
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
    default: return session_.setMode(modes_[below(modes_.size())]);
    }
}

void RandomEdits::editIsovalues()
{
    const int count = session_.view().isovalueCount();
    if (count > mostIsovalues)
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
    AnnotationState annotations = session_.view().annotations();
    AnnotationPlace& place = annotations.places[below(annotationCount)];
    place.shown = below(2) == 0;
    place.corner = static_cast<Corner>(below(cornerNames.size()));
    session_.setAnnotations(annotations);
}

void RandomEdits::editAnimation()
{
    session_.setAnimation(anyAnimation());
}

Animation RandomEdits::anyAnimation()
{
    Animation animation = session_.view().animation();
    const int key = static_cast<int>(below(mostKeys)) - 1;
    const Moment moment = momentOf(session_, viewport_);
    const FilmFrame frame{moment.camera,      moment.look.transfer,  moment.isovalues,
                          moment.query.error, moment.query.byBudget, moment.query.budget};
    switch (below(8)) {
    case 0: animation.kind = static_cast<Animation::Kind>(below(2)); return animation;
    case 1: animation.framesPerSecond = number(-1, 200); return animation;
    case 2:
        animation.turntable = {static_cast<Turntable::Axis>(below(2)), number(-720, 720), static_cast<int>(below(300))};
        return animation;
    case 3: return withoutKey(animation, key);
    case 4: return withKeyAt(animation, key, number(-1, 20));
    case 5: return withKeyMoved(animation, key, below(2) == 0 ? 1 : -1);
    default: return animation.keys.size() < mostKeys ? withKey(animation, frame) : withoutKey(animation, 0);
    }
}

void RandomEdits::editCamera()
{
    const Camera camera = viewport_.camera();
    const auto any = [this](double least, double largest) {
        return std::uniform_real_distribution<double>(least, largest)(random_);
    };
    switch (below(10)) {
    case 0: return viewport_.setCamera(turned(camera, any(-90, 90), any(-90, 90)));
    case 1: return viewport_.setCamera(zoomed(camera, any(0.8, 1.25)));
    case 2: return viewport_.setCamera(panned(camera, any(-0.1, 0.1), any(-0.1, 0.1)));
    case 3: return viewport_.glideTo(rolled(camera, 90));
    case 4: return viewport_.glideTo(upright(camera, static_cast<UpAxis>(below(6))));
    case 5: return viewport_.seeFrom(static_cast<NamedView>(below(7)));
    case 6: return viewport_.setPerspective(!camera.perspective);
    case 7: return viewport_.fit(session_.model()->description().bounds);
    default: break;
    }
    Camera other = camera;
    other.fieldOfView = any(1, 170);
    other.trackball = !other.trackball;
    viewport_.setCamera(other);
}

void RandomEdits::editBackground()
{
    const auto channel = [this] { return std::uniform_real_distribution<float>(0, 1)(random_); };
    viewport_.setBackground(below(3) == 0 ? std::nullopt : std::optional(Colour{channel(), channel(), channel()}));
}

} // namespace tetra
