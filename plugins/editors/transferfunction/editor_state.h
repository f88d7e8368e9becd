// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/editor.h"
#include "plugins/api/scene_parameters.h"
#include "plugins/api/value_facts_host.h"
#include "plugins/widgets/curves/axes.h"
#include "plugins/widgets/curves/joined_function.h"
#include "plugins/widgets/curves/moving.h"
#include "plugins/widgets/curves/selection.h"

#include <QObject>

namespace tetra {

/// What one key or number box is about: the point that was selected last, an isovalue, or an end of the mask.
struct EditorItem {
    enum class Kind { None, Point, Isovalue, MaskLeast, MaskLargest };
    Kind kind = Kind::None;
    std::size_t index = 0; ///< of points and isovalues
    bool operator==(const EditorItem&) const = default;
};

/// How the plot is looked at.
struct EditorView {
    std::optional<TransferLimits> values{}; ///< that are seen; none: all
    TransferLimits heights{};               ///< of the axis of opacities, in [0, 1]
    OpacityAxis axis = OpacityAxis::SquareRoot;
    ValueAxis valueAxis = ValueAxis::Linear; ///< that is wanted; see EditorState::valueAxis()
    bool logarithmicCounts = true;           ///< rare values are to be seen, too
};

/// What the parts of the editor share besides the function, which is the window's: which one that is, the selected
/// points, how the plot is looked at, and what happens to neighbours. None of it is undone.
class EditorState : public QObject {
    Q_OBJECT
public:
    /// `host` outlives it.
    explicit EditorState(EditorHost& host, QObject* parent = nullptr);

    EditorHost& host() const noexcept { return host_; }
    /// Those that the present rendering mode has.
    const std::vector<Parameter>& functions() const noexcept { return functions_; }
    /// The id of the one that is edited; where there is none, that of the one that all modes share.
    const std::string& edited() const noexcept { return edited_; }
    /// Edits this one from now on, wherever a mode has it.
    void edit(const std::string& id);
    /// After another model or mode. If another function is edited then, nothing of it is selected.
    void followFunctions();
    const TransferFunction& function() const;
    void setFunction(const TransferFunction& function) { host_.setValue(edited_, function); }
    /// The same with its curves as one, whose points are shown and edited.
    const JoinedFunction& joinedFunction() const;
    /// Of the data.
    TransferLimits range() const;
    /// Of the data and of what of the function reaches beyond: nothing acts unseen.
    TransferLimits limits() const;
    /// The values at the left and the right edge of the plot.
    TransferLimits shown() const { return view_.values.value_or(limits()); }
    /// Whether the values are logarithms, which people read and type as what they are of.
    bool ofLogarithms() const;
    /// What the data say of them; nothing in a window that does not know.
    ValueFacts valueFacts() const;
    /// Whether what is drawn has the isovalues' surfaces.
    bool showsIsovalues() const;
    /// Linear as long as some value has no place on the one that is wanted, and of logarithms.
    ValueAxis valueAxis() const;

    const TransferSelection& selection() const noexcept { return selection_; }
    EditorItem current() const noexcept { return current_; }
    std::optional<std::size_t> currentPoint() const;
    /// All the items in the order in which Tab goes through them.
    std::vector<EditorItem> items() const;
    /// Nothing for an item that is gone, as the current one is for a moment when another model comes.
    std::optional<double> valueOf(const EditorItem& item) const;

    /// The points, and the first of them as the current one unless one of them is that.
    void select(TransferSelection selection);
    /// One point alone, or something that is no point.
    void setCurrent(const EditorItem& item);
    /// Leaves the selection, and makes the point current.
    void addToSelection(std::size_t point);
    /// Of indices that are gone; after the function or the isovalues have changed.
    void forgetWhatIsGone();
    /// One edit, which keeps or moves the selection.
    void apply(const EditedSelection& edited);
    /// The current item moved to a value; several selected points go along.
    void setCurrentValue(double value);
    /// Takes away the selected points, or the isovalue or the mask that is the current item.
    void removeCurrent();

    const EditorView& view() const noexcept { return view_; }
    /// Cut to what there is to see.
    void setView(const EditorView& view);
    void setRule(NeighbourRule rule);
    NeighbourRule rule() const noexcept { return rule_; }

signals:
    /// Another function is edited.
    void editedChanged();
    void selectionChanged();
    void viewChanged();

private:
    EditorHost& host_;
    std::vector<Parameter> functions_;
    std::string wanted_ = transferId; ///< to be edited, if the mode has it
    std::string edited_ = transferId;
    mutable TransferFunction lastSeen_; ///< of which joined_ was made
    mutable JoinedFunction joined_;
    TransferSelection selection_;
    EditorItem current_;
    EditorView view_;
    NeighbourRule rule_ = NeighbourRule::Stop;
};

/// What is picked in the picture, if anything is.
std::optional<double> pickedValue(const EditorState& state);

/// A point more on the curve; where there is no curve yet, in a colour and of an opacity that can be seen.
std::optional<EditedPoint> withSeenPoint(const JoinedFunction& function, double value);

/// A point more on the curve, selected: at `value`, or halfway from the current point to the next, or in the middle of
/// what is seen.
void addPoint(EditorState& state, std::optional<double> value);

/// Of the function at a value, whatever the mask: in [0, 1] of the unit distance.
double opacityOf(const TransferFunction& function, double value);

} // namespace tetra
