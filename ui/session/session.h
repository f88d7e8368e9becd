// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/shown_mesh_text.h"

#include <tan/model.h>
#include <tan/query.h>
#include <tan/view.h>

#include <QUndoStack>

#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

namespace tetra {

/// The number of a gesture: edits of one gesture are one step to undo. Zero is no gesture.
using Gesture = std::uint64_t;

/// What is open and how it is seen: the logic between the model and the widgets, free of both. Every edit is one step
/// of the undo stack; edits between beginGesture() and endGesture() (a drag) are one step together. Without a model
/// there is nothing to edit.
class Session : public QObject {
    Q_OBJECT
public:
    explicit Session(QObject* parent = nullptr);

    const std::shared_ptr<const Model>& model() const noexcept { return model_; }
    const ViewValue& view() const noexcept { return view_; }
    QUndoStack& undoStack() noexcept { return undoStack_; }
    const QUndoStack& undoStack() const noexcept { return undoStack_; }
    /// The mesh at the chosen accuracy or budget, known without extracting it, but for focus, window and values; zeros
    /// without a model.
    MeshSize meshSize() const;
    /// The range of the model's values; empty without a model.
    ValueRange range() const;

    /// What there is to see of a model: the places farthest out, as of FieldExtent; none: all of it.
    using Object = std::vector<Eigen::Vector3d>;
    /// Shows `model` at an accuracy that is quick to draw, what there is to see of it whole and from the usual
    /// direction. What is the user's way of working and no part of a model stays: which annotations are shown and
    /// where, and how a drag turns the camera. The history of edits starts anew.
    void open(std::shared_ptr<const Model> model, std::vector<Isovalue> isovalues, Appearance appearance = {},
              Object object = {});
    /// Shows `model` as somebody has left it; what does not fit the model is brought into it. Without a camera what
    /// there is to see is shown whole, from the view's direction.
    void restore(std::shared_ptr<const Model> model, ViewValue view, bool hasCamera = true, Object object = {});
    /// The transfer function that the present model has in the mesh of a query while nobody has chosen one.
    using UsualTransfer = std::function<TransferFunction(const QueryState& query)>;
    /// One that is as this says follows every edit of the query from now on, so that it goes with the error that is
    /// shown; any other was chosen and stays.
    void setUsualTransfer(UsualTransfer usual) { usualTransfer_ = std::move(usual); }
    /// What a picture of a view of the present model frames; none: all of the model.
    using FramedObject = std::function<Object(const ViewValue& view)>;
    /// What fitCamera() frames from now on.
    void setFramedObject(FramedObject framed) { framedObject_ = std::move(framed); }
    /// `next` with that transfer function, if it has the usual one of `before` and another query.
    ViewValue following(const ViewValue& before, ViewValue next) const;
    /// Shows a model of the same dataset that has more sites, as the model is seen now: the history of edits goes on.
    /// Unless the view was restored, the accuracy follows what is quick to draw until the first edit; isovalues and
    /// transfer function become these until they are edited.
    void grow(std::shared_ptr<const Model> model, const std::vector<Isovalue>& isovalues, const Appearance& appearance,
              Object object = {});
    void close();
    /// Whether the model was opened as nobody had seen it before.
    bool isFirstLook() const noexcept { return model_ != nullptr && followsModel_; }
    /// The width / height of the picture. A camera that shows what there is to see whole, as the model was opened, goes
    /// on doing so until somebody moves it.
    void setShape(double aspectRatio);
    double shape() const noexcept { return shape_; }

    void beginGesture();
    void endGesture();
    /// Whether something is being dragged: pictures that follow count more than fine ones.
    bool inGesture() const noexcept { return gesture_ != 0; }
    /// The number of a gesture of a control of its own, such as a series of keys.
    Gesture newGesture() noexcept { return ++lastGesture_; }

    /// All of it as one step, named after what differs unless it is given a name. What is not in its range is brought
    /// into it, and what is not a number is left as it was; a transfer function that checkTransferFunction() refuses is
    /// not taken.
    void setView(ViewValue view, const QString& name = {}, Gesture gesture = 0);
    void setQuery(const QueryState& query);
    /// By error from now on; outside the focus, if there is one.
    void setError(double percent);
    /// By budget from now on; at least the coarsest mesh.
    void setBudget(std::uint64_t tetrahedra);
    void setByBudget(bool byBudget);
    void setWarping(const WarpingChoice& warping);
    void setFocus(const FocusState& focus);
    void setWindow(const WindowState& window);
    void setValueFilter(const ValueFilter& values);
    void setRange(const RangeState& range);
    /// The id of a renderer plugin.
    void setMode(const std::string& mode);
    void setTransfer(const TransferFunction& transfer);
    /// Of several: the one that all modes share, or a setting with this id.
    void setTransfer(const std::string& id, const TransferFunction& transfer);
    /// Of a renderer's parameter.
    void setSetting(const std::string& id, const ParameterValue& value);
    void setAnnotations(const AnnotationState& annotations);
    void setAnimation(const Animation& animation);
    void setCamera(const Camera& camera, Gesture gesture = 0);
    /// From the present direction: what is shown of the model, or its focus, in the middle of the picture, so that it
    /// is turned about that; of all of the model, the framed object. If that is what is seen already, all of it.
    void fitCamera();
    /// All of the model.
    void fitCameraToWhole();
    void setBackground(const std::optional<Colour>& background);
    void setLens(const LensState& lens, Gesture gesture = 0);
    /// At `value`, or in the middle of the widest range of values without one; in a colour that is not in use.
    void addIsovalue(std::optional<double> value = std::nullopt);
    /// Out of range indices are ignored.
    void removeIsovalue(int index);
    void setIsovalue(int index, const Isovalue& isovalue);

    /// What the last picture shows; nothing before the first.
    const std::optional<ShownMesh>& shown() const noexcept { return shown_; }
    /// Whether that is what is asked for now.
    bool showsQuery() const;
    void setShown(const ShownMesh& shown);

    /// Calls `call`, a function or a member of `receiver`, whenever one of these parts of the view has changed.
    template <class Receiver, class Call> void whenChanged(ViewParts parts, Receiver* receiver, Call call) const
    {
        if constexpr (std::is_member_function_pointer_v<Call>)
            whenChanged(parts, receiver, [receiver, call] { (receiver->*call)(); });
        else
            connect(this, &Session::viewChanged, receiver, [parts, call](ViewParts changed) {
                if (changed & parts)
                    call();
            });
    }

signals:
    /// Another model is open, or none; nothing is left of the view before.
    void modelChanged();
    void modelGrown();
    void viewChanged(tetra::ViewParts parts);
    void shownChanged();
    void gestureChanged(bool on);

private:
    class ChangeView;
    template <class Change> void edit(Change change);
    bool hasIsovalue(int index) const;
    Eigen::AlignedBox3d shownBounds() const;
    /// Whether one of these parts was edited, undone or not.
    bool edited(ViewParts parts) const;
    void start(std::shared_ptr<const Model> model, ViewValue view, bool hasCamera);
    void show(ViewValue view);

    std::shared_ptr<const Model> model_;
    ViewValue view_;
    UsualTransfer usualTransfer_;
    FramedObject framedObject_;
    std::optional<ShownMesh> shown_;
    QUndoStack undoStack_;
    bool followsModel_ = false; ///< what was not edited, as it was not chosen
    double shape_ = 1;
    Object object_;
    std::optional<Camera> fitted_; ///< to the shape; nothing if there is a chosen one from the start
    Gesture lastGesture_ = 0;
    Gesture gesture_ = 0;
};

} // namespace tetra
