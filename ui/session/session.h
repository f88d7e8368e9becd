// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/shown_mesh.h"
#include "ui/session/view_commands.h"
#include "ui/session/view_state.h"

#include <tan/model.h>
#include <tan/query.h>

#include <QUndoStack>

#include <functional>
#include <memory>
#include <optional>

namespace tetra {

/// What is open and what is seen of it: the logic between the model and the widgets, free of both. Every edit is one
/// step of the undo stack; edits between beginGesture() and endGesture() (a drag) are one step together.
class Session : public QObject {
    Q_OBJECT
public:
    explicit Session(QObject* parent = nullptr);

    const std::shared_ptr<const Model>& model() const noexcept { return model_; }
    const ViewState& view() const noexcept { return view_; }
    QUndoStack& undoStack() noexcept { return undoStack_; }
    const QUndoStack& undoStack() const noexcept { return undoStack_; }
    /// The mesh at the chosen accuracy or budget, known without extracting it, but for focus, window and values; zeros
    /// without a model.
    MeshSize meshSize() const;
    /// The range of the model's values; empty without a model.
    ValueRange range() const;

    /// Shows `model` at an accuracy that is quick to draw. The history of edits starts anew.
    void open(std::shared_ptr<const Model> model, std::vector<Isovalue> isovalues, Look look = {});
    /// Shows `model` as somebody has left it; what of the query does not fit the model is brought into it.
    void open(std::shared_ptr<const Model> model, std::vector<Isovalue> isovalues, Look look, const QueryState& query);
    /// Shows a model of the same dataset that has more sites, as the model is seen now: the history of edits goes on.
    /// Unless somebody left it as it is, the accuracy follows what is quick to draw as long as nothing was edited, and
    /// isovalues and transfer function become these as long as they were not.
    void grow(std::shared_ptr<const Model> model, const std::vector<Isovalue>& isovalues, const Look& look);
    void close();

    void beginGesture();
    void endGesture();
    /// Whether something is being dragged: pictures that follow count more than fine ones.
    bool inGesture() const noexcept { return gesture_ != 0; }
    /// By error from now on; outside the focus, if there is one. Clamped to [0, 100] %.
    void setError(double percent);
    /// By budget from now on; at least the coarsest mesh.
    void setBudget(std::uint64_t tetrahedra);
    void setByBudget(bool byBudget);
    /// Any part of it. What is no error, place, size or value in the model is brought into it, see corrected().
    void setQuery(const QueryState& query);
    void setFocus(const FocusState& focus);
    void setWindow(const WindowState& window);
    void setValueFilter(const ValueFilter& values);
    /// The id of a renderer plugin.
    void setMode(const std::string& mode);
    /// One that checkTransferFunction() refuses changes nothing.
    void setTransfer(const TransferFunction& transfer);
    /// Of a renderer's parameter.
    void setSetting(const std::string& id, const ParameterValue& value);
    void setAnnotations(const AnnotationState& annotations);
    /// What is not in its range is brought into it, see corrected().
    void setAnimation(const Animation& animation);
    /// All of that at once: as many steps as there are differences.
    void setAll(const QueryState& query, const Look& look, const std::vector<Isovalue>& isovalues,
                const AnnotationState& annotations, const Animation& animation);
    /// As a session has left it: no edit.
    void restore(const AnnotationState& annotations, const Animation& animation);
    /// At `value`, or in the middle of the widest range of values without one; in a colour that is not in use.
    void addIsovalue(std::optional<double> value = std::nullopt);
    /// Out of range indices are ignored.
    void removeIsovalue(int index);
    /// The value is clamped to the model's range, the opacity to [0.01, 1]; what is not a number stays as it is.
    void setIsovalue(int index, Isovalue isovalue);

    /// What the last picture shows; nothing before the first.
    const std::optional<ShownMesh>& shown() const noexcept { return shown_; }
    /// Whether that is what is asked for now.
    bool showsQuery() const;
    void setShown(const ShownMesh& shown);

signals:
    void modelChanged();
    void modelGrown();
    void shownChanged();
    void gestureChanged(bool on);

private:
    bool hasIsovalue(int index) const;
    /// Whether the stack has steps that `what` is true of.
    bool edited(const std::function<bool(const QUndoCommand& step)>& what) const;
    void setLook(const Look& look);

    std::shared_ptr<const Model> model_;
    ViewState view_;
    std::optional<ShownMesh> shown_;
    QUndoStack undoStack_;
    bool followsModel_ = false; ///< what was not edited, as it was not chosen
    Gesture lastGesture_ = 0;
    Gesture gesture_ = 0;
};

} // namespace tetra
