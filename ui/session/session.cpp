// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/session.h"

#include "core/view/appearance.h"
#include "core/view/view_value.h"
#include "plugins/api/scene_parameters.h"

#include <tan/view.h>

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

namespace tetra {
namespace {

double numberOr(double value, double otherwise)
{
    return std::isfinite(value) ? value : otherwise;
}

/// As a file of it may be.
Camera corrected(Camera camera, const Camera& before)
{
    struct Limits {
        double Camera::*member;
        double least, largest;
    };
    for (const auto& [member, least, largest] :
         {Limits{&Camera::distance, 1e-30, 1e30}, Limits{&Camera::azimuth, -1e6, 1e6}, Limits{&Camera::roll, -1e6, 1e6},
          Limits{&Camera::elevation, -90, 90}, Limits{&Camera::fieldOfView, 1, 170}})
        camera.*member = std::clamp(numberOr(camera.*member, before.*member), least, largest);
    for (int axis = 0; axis < 3; ++axis)
        camera.target[axis] = numberOr(camera.target[axis], before.target[axis]);
    return camera;
}

Isovalue corrected(Isovalue isovalue, const Isovalue& before, const ValueRange& range)
{
    isovalue.value = numberOr(isovalue.value, before.value);
    isovalue.opacity = static_cast<float>(numberOr(isovalue.opacity, before.opacity));
    return corrected(isovalue, range);
}

std::optional<Colour> corrected(std::optional<Colour> colour)
{
    if (colour)
        for (float Colour::*channel : {&Colour::red, &Colour::green, &Colour::blue})
            (*colour).*channel = std::clamp(static_cast<float>(numberOr((*colour).*channel, 0)), 0.0F, 1.0F);
    return colour;
}

Eigen::AlignedBox3d boundsOf(const FocusState& focus)
{
    Eigen::AlignedBox3d bounds;
    for (const MovableRegion& region : focus.regions())
        if (const auto* sphere = std::get_if<Sphere>(&region)) {
            bounds.extend(sphere->centre - Eigen::Vector3d::Constant(sphere->radius));
            bounds.extend(sphere->centre + Eigen::Vector3d::Constant(sphere->radius));
        } else {
            bounds.extend(std::get<Box>(region).least);
            bounds.extend(std::get<Box>(region).largest);
        }
    return bounds;
}

/// Whether a renderer's own transfer function is among what differs.
bool changesTransfer(const ParameterValues& before, const ParameterValues& after)
{
    return std::ranges::any_of(after, [&before](const auto& setting) {
        const auto was = before.find(setting.first);
        return std::holds_alternative<TransferFunction>(setting.second) &&
               (was == before.end() || was->second != setting.second);
    });
}

/// What is as it was `before` is right.
ViewValue corrected(ViewValue view, const ViewValue& before, const Model& model)
{
    const ViewParts edited = differingParts(view, before);
    if (edited & ViewPart::Query)
        view.query = corrected(view.query, before.query, model);
    if (edited & ViewPart::Transfer && !checkTransferFunction(view.appearance.transfer))
        view.appearance.transfer = before.appearance.transfer;
    for (std::size_t i = 0; edited & ViewPart::Isovalues && i < view.isovalues.size(); ++i)
        view.isovalues[i] = corrected(view.isovalues[i], i < before.isovalues.size() ? before.isovalues[i] : Isovalue(),
                                      model.description().range);
    if (view.annotations.barEnds && !isUsable(*view.annotations.barEnds))
        view.annotations.barEnds = before.annotations.barEnds;
    if (edited & ViewPart::Animation)
        view.animation = corrected(std::move(view.animation));
    if (edited & ViewPart::Camera)
        view.camera = corrected(view.camera, before.camera);
    view.background = corrected(view.background);
    if (edited & ViewPart::Lens)
        view.lens = corrected(view.lens, before.lens);
    std::erase_if(view.tools, [](const auto& tool) { return tool.second.empty(); });
    return view;
}

} // namespace

/// An edit: what it has changed, as it was and as it became. Not all of that has somebody chosen: what follows from the
/// rest is changed and undone with it.
class Session::ChangeView : public QUndoCommand {
    Q_DECLARE_TR_FUNCTIONS(ChangeView)
public:
    ChangeView(Session& session, const ViewValue& after, ViewParts chosen, const QString& name, Gesture gesture)
        : QUndoCommand(name.isEmpty() ? nameOf(session.view_, after, chosen) : name), session_(session),
          chosen_(chosen), before_(session.view_, differingParts(session.view_, after)), after_(after, before_.parts()),
          gesture_(gesture)
    {
    }
    int id() const override { return 1; } // there is no other command
    void redo() override { session_.show(after_.putInto(session_.view_)); }
    void undo() override { session_.show(before_.putInto(session_.view_)); }
    bool mergeWith(const QUndoCommand* next) override
    {
        const auto& other = *static_cast<const ChangeView*>(next);
        if (gesture_ == 0 || other.gesture_ != gesture_)
            return false;
        PartialView later = other.after_;
        later.complete(after_);
        after_ = std::move(later);
        before_.complete(other.before_);
        chosen_ |= other.chosen_;
        setObsolete(after_ == before_);
        return true;
    }
    ViewParts chosen() const { return chosen_; }

private:
    static QString nameOf(const ViewValue& before, const ViewValue& after, ViewParts parts);

    Session& session_;
    ViewParts chosen_;
    PartialView before_;
    PartialView after_;
    Gesture gesture_;
};

QString Session::ChangeView::nameOf(const ViewValue& before, const ViewValue& after, ViewParts parts)
{
    if (parts & ViewPart::Query) {
        if (before.query.focus != after.query.focus)
            return tr("Change Focus");
        if (before.query.window != after.query.window)
            return tr("Change Crop Box");
        if (before.query.values != after.query.values)
            return tr("Change Values");
        if (before.query.range != after.query.range)
            return tr("Change Range");
        if (before.query.warping != after.query.warping)
            return tr("Change Warping");
        return after.query.byBudget ? tr("Change Budget") : tr("Change Accuracy");
    }
    if (parts & ViewPart::Mode)
        return tr("Change Rendering Mode");
    if (parts & ViewPart::Transfer)
        return tr("Change Transfer Function");
    if (parts & ViewPart::Settings)
        return changesTransfer(before.appearance.settings, after.appearance.settings) ? tr("Change Transfer Function")
                                                                                      : tr("Change Rendering");
    if (parts & ViewPart::Isovalues) {
        if (before.isovalues.size() == after.isovalues.size())
            return tr("Change Isovalue");
        return before.isovalues.size() < after.isovalues.size() ? tr("Add Isovalue") : tr("Remove Isovalue");
    }
    if (parts & ViewPart::Annotations)
        return tr("Change Annotations");
    if (parts & ViewPart::Animation)
        return tr("Change Animation");
    if (parts & ViewPart::Camera)
        return tr("Move Camera");
    if (parts & ViewPart::Lens)
        return tr("Change Lens");
    if (parts & ViewPart::Bookmarks)
        return tr("Change Bookmarks");
    return parts & ViewPart::Tools ? tr("Change Tool") : tr("Change Background");
}

Session::Session(QObject* parent) : QObject(parent) {}

MeshSize Session::meshSize() const
{
    return model_ ? plannedSize(view_.query, *model_) : MeshSize{};
}

ValueRange Session::range() const
{
    return model_ ? model_->description().range : ValueRange{};
}

void Session::open(std::shared_ptr<const Model> model, std::vector<Isovalue> isovalues, Appearance appearance,
                   Object object)
{
    ViewValue view{.query = startingQuery(*model, startingError(*model)),
                   .appearance = std::move(appearance),
                   .isovalues = std::move(isovalues),
                   .annotations = ofOtherData(view_.annotations),
                   .camera = usualCamera(model->description())};
    view.camera.trackball = view_.camera.trackball;
    followsModel_ = true;
    object_ = std::move(object);
    start(std::move(model), std::move(view), false);
}

void Session::restore(std::shared_ptr<const Model> model, ViewValue view, bool hasCamera, Object object)
{
    followsModel_ = false;
    object_ = std::move(object);
    start(std::move(model), std::move(view), hasCamera);
}

void Session::start(std::shared_ptr<const Model> model, ViewValue view, bool hasCamera)
{
    model_ = std::move(model);
    undoStack_.clear();
    shown_.reset();
    fitted_.reset();
    if (!hasCamera) {
        view.camera = framed(view, model_->description().bounds, object_, shape_);
        fitted_ = view.camera;
    }
    const ViewValue usual{
        .query = startingQuery(*model_, startingError(*model_)), .appearance = view.appearance, .camera = view.camera};
    view_ = corrected(std::move(view), usual, *model_);
    emit modelChanged();
}

void Session::grow(std::shared_ptr<const Model> model, const std::vector<Isovalue>& isovalues,
                   const Appearance& appearance, Object object)
{
    model_ = std::move(model);
    object_ = std::move(object);
    shown_.reset();
    emit modelGrown();
    if (!followsModel_)
        return;
    ViewValue fitting = view_;
    if (!edited(~(ViewPart::Camera | ViewPart::Background | ViewPart::Tools | ViewPart::Bookmarks)))
        fitting.query = startingQuery(*model_, startingError(*model_));
    if (!edited(ViewPart::Transfer))
        fitting.appearance.transfer = usualTransfer_ ? usualTransfer_(fitting.query) : appearance.transfer;
    if (isovalues.size() == view_.isovalues.size() && !edited(ViewPart::Isovalues))
        fitting.isovalues = isovalues;
    if (fitted_ == view_.camera) {
        fitting.camera = framed(fitting, model_->description().bounds, object_, shape_);
        fitted_ = fitting.camera;
    }
    show(std::move(fitting));
}

bool Session::edited(ViewParts parts) const
{
    for (int index = 0; index < undoStack_.count(); ++index)
        if (static_cast<const ChangeView*>(undoStack_.command(index))->chosen() & parts)
            return true;
    return false;
}

void Session::close()
{
    model_.reset();
    undoStack_.clear();
    shown_.reset();
    fitted_.reset();
    object_.clear();
    view_ = {.annotations = ofOtherData(view_.annotations), .camera = {.trackball = view_.camera.trackball}};
    emit modelChanged();
}

void Session::setShape(double aspectRatio)
{
    shape_ = aspectRatio;
    if (!model_ || fitted_ != view_.camera)
        return;
    ViewValue view = view_;
    view.camera = framed(view, model_->description().bounds, object_, shape_);
    fitted_ = view.camera;
    show(std::move(view));
}

void Session::beginGesture()
{
    gesture_ = newGesture();
    emit gestureChanged(true);
}

void Session::endGesture()
{
    if (gesture_ == 0)
        return;
    gesture_ = 0;
    emit gestureChanged(false);
}

ViewValue Session::following(const ViewValue& before, ViewValue next) const
{
    const TransferFunction& transfer = before.appearance.transfer;
    if (usualTransfer_ && model_ && next.query != before.query && next.appearance.transfer == transfer &&
        transfer == usualTransfer_(before.query))
        next.appearance.transfer = usualTransfer_(next.query);
    return next;
}

void Session::show(ViewValue view)
{
    const ViewParts parts = differingParts(view_, view);
    view_ = std::move(view);
    if (parts)
        emit viewChanged(parts);
}

void Session::setView(ViewValue view, const QString& name, Gesture gesture)
{
    if (!model_)
        return;
    view = corrected(std::move(view), view_, *model_);
    const ViewParts chosen = differingParts(view_, view);
    if (chosen)
        undoStack_.push(
            new ChangeView(*this, following(view_, std::move(view)), chosen, name, gesture != 0 ? gesture : gesture_));
}

template <class Change> void Session::edit(Change change)
{
    ViewValue view = view_;
    change(view);
    setView(std::move(view));
}

void Session::setQuery(const QueryState& query)
{
    edit([&](ViewValue& view) { view.query = query; });
}

void Session::setError(double percent)
{
    edit([=](ViewValue& view) {
        view.query.error = percent;
        view.query.byBudget = false;
    });
}

void Session::setBudget(std::uint64_t tetrahedra)
{
    edit([=](ViewValue& view) {
        view.query.budget = tetrahedra;
        view.query.byBudget = true;
    });
}

void Session::setByBudget(bool byBudget)
{
    edit([=](ViewValue& view) { view.query.byBudget = byBudget; });
}

void Session::setWarping(const WarpingChoice& warping)
{
    edit([&](ViewValue& view) { view.query.warping = warping; });
}

void Session::setFocus(const FocusState& focus)
{
    edit([&](ViewValue& view) { view.query.focus = focus; });
}

void Session::setWindow(const WindowState& window)
{
    edit([&](ViewValue& view) { view.query.window = window; });
}

void Session::setValueFilter(const ValueFilter& values)
{
    edit([&](ViewValue& view) { view.query.values = values; });
}

void Session::setRange(const RangeState& range)
{
    edit([&](ViewValue& view) { view.query.range = range; });
}

void Session::setMode(const std::string& mode)
{
    edit([&](ViewValue& view) { view.appearance.mode = mode; });
}

void Session::setTransfer(const TransferFunction& transfer)
{
    edit([&](ViewValue& view) { view.appearance.transfer = transfer; });
}

void Session::setTransfer(const std::string& id, const TransferFunction& transfer)
{
    if (id == transferId)
        setTransfer(transfer);
    else if (checkTransferFunction(transfer))
        setSetting(id, transfer);
}

void Session::setSetting(const std::string& id, const ParameterValue& value)
{
    edit([&](ViewValue& view) { view.appearance.settings[id] = value; });
}

void Session::setAnnotations(const AnnotationState& annotations)
{
    edit([&](ViewValue& view) { view.annotations = annotations; });
}

void Session::setAnimation(const Animation& animation)
{
    edit([&](ViewValue& view) { view.animation = animation; });
}

void Session::setCamera(const Camera& camera, Gesture gesture)
{
    ViewValue view = view_;
    view.camera = camera;
    setView(std::move(view), {}, gesture);
}

/// The part of the domain that is of interest: what window and values leave, or else the regions of the focus.
Eigen::AlignedBox3d Session::shownBounds() const
{
    const Eigen::AlignedBox3d& whole = model_->description().bounds;
    const QueryState& query = view_.query;
    Eigen::AlignedBox3d part = whole;
    if (query.window.enabled)
        part = part.intersection({query.window.window.box.least, query.window.window.box.largest});
    if (query.values.enabled && showsQuery() && !shown_->bounds.isEmpty())
        part = part.intersection(shown_->bounds);
    if (!query.window.enabled && !query.values.enabled && query.focus.isRegion())
        part = boundsOf(query.focus).intersection(whole);
    return part.isEmpty() ? whole : part;
}

void Session::fitCamera()
{
    if (!model_)
        return;
    const Eigen::AlignedBox3d shown = shownBounds(), &whole = model_->description().bounds;
    const bool isWhole = shown.min() == whole.min() && shown.max() == whole.max();
    const Camera camera = isWhole ? framed(view_, whole, framedObject_ ? framedObject_(view_) : object_, shape_)
                                  : fitted(view_.camera, shown, shape_);
    if (camera == view_.camera)
        return fitCameraToWhole();
    setCamera(camera);
}

void Session::fitCameraToWhole()
{
    if (model_)
        setCamera(fittedToBox(view_, model_->description().bounds, shape_));
}

void Session::setBackground(const std::optional<Colour>& background)
{
    edit([&](ViewValue& view) { view.background = background; });
}

void Session::setLens(const LensState& lens, Gesture gesture)
{
    ViewValue view = view_;
    view.lens = lens;
    setView(std::move(view), {}, gesture);
}

void Session::addIsovalue(std::optional<double> value)
{
    if (!model_)
        return;
    Isovalue isovalue = nextIsovalue(view_.isovalues, range());
    if (value && std::isfinite(*value))
        isovalue.value = *value;
    edit([&](ViewValue& view) { view.isovalues.push_back(isovalue); });
}

void Session::removeIsovalue(int index)
{
    if (hasIsovalue(index))
        edit([=](ViewValue& view) { view.isovalues.erase(view.isovalues.begin() + index); });
}

void Session::setIsovalue(int index, const Isovalue& isovalue)
{
    if (hasIsovalue(index))
        edit([&](ViewValue& view) { view.isovalues[static_cast<std::size_t>(index)] = isovalue; });
}

bool Session::hasIsovalue(int index) const
{
    return model_ && index >= 0 && index < std::ssize(view_.isovalues);
}

bool Session::showsQuery() const
{
    return shown_ && model_ && shown_->query == meshQuery(view_.query, *model_, presentView(view_));
}

void Session::setShown(const ShownMesh& shown)
{
    shown_ = shown;
    emit shownChanged();
}

} // namespace tetra
