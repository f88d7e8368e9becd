// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/tool_stage.h"
#include "ui/viewport/scene_pick.h"
#include "ui/viewport/viewport.h"

#include <QObject>

#include <deque>

namespace tetra {

/// The tools of plugins at work in the viewport: which one is chosen, what becomes of pointer and keys, and what they
/// show. Knows no painting. Each answer of a tool is a step to undo, and so are all moves of one drag together, or all
/// of a key that is held; a drag that Escape ends is none.
class ToolDesk : public QObject {
    Q_OBJECT
public:
    /// Workbench and viewport outlive it. Loads the tools.
    ToolDesk(Workbench& workbench, Viewport& viewport, QObject* parent);

    const std::vector<Provided<Tool>>& tools() const noexcept { return tools_; }
    /// The id of the one that gets the events; empty if none does, as without a model.
    const std::string& chosen() const noexcept { return chosen_; }
    void choose(const std::string& id);
    /// The handle that takes the arrow keys; empty if none does.
    const std::string& selected() const noexcept { return selected_; }
    const std::string& hovered() const noexcept { return hovered_; }
    bool dragging() const noexcept { return drag_.has_value(); }
    /// Whether something is still being looked for that was pointed at.
    bool seeking() const noexcept { return seeking_ || !wanted_.empty(); }

    /// Of the chosen tool: what its panel has. Empty without one.
    std::vector<Parameter> parameters() const;
    std::vector<ToolReading> readings() const;
    std::vector<ToolCommand> commands() const;
    void setParameter(const std::string& id, const ParameterValue& value);
    void command(const std::string& id);

    /// What is shown: of the chosen tool all, of the others what they keep.
    std::vector<ToolDrawing> drawings() const;

    // From the viewport; true if nobody else is to get the event.
    bool press(QPointF pixel, Qt::KeyboardModifiers modifiers);
    bool move(QPointF pixel, Qt::KeyboardModifiers modifiers, bool buttonDown);
    bool release(QPointF pixel, Qt::KeyboardModifiers modifiers);
    void leave();
    /// The window has lost the keys: a drag ends where it is.
    void letGo();
    bool keyPress(const QKeyEvent& event);
    bool keyRelease(const QKeyEvent& event);
    /// Whether the chosen tool has the key, which then is no shortcut of the window.
    bool hasKey(const QKeyEvent& event) const;

signals:
    void chosenChanged();
    /// What is shown, or what the panel has.
    void changed();

private:
    struct Drag {
        ToolStage start;
        ToolHandle handle;
        QPointF beside;     ///< where it was grabbed, from where it is seen
        QPointF pressed;    ///< where it was grabbed
        bool moved = false; ///< farther than a hand moves while it clicks
    };
    /// A place that is to be looked at, and what for.
    struct Wanted {
        enum class Purpose { Hover, Move, LastMove, Click };
        Purpose purpose = Purpose::Hover;
        QPointF pixel;
        Qt::KeyboardModifiers modifiers;
    };

    const Tool* tool() const;
    bool isAtWork() const { return tool() != nullptr && session_.model() != nullptr; }
    const std::vector<Parameter>& parametersOfMode() const;
    ToolStage stage() const;
    ToolSurroundings surroundings(const ToolStage& stage) const;
    ToolDrawing drawing() const;
    std::optional<ToolHandle> handleAt(QPointF pixel) const;
    std::optional<ToolHandle> handleOf(const std::string& id) const;
    void take(const ToolStage& stage, const ToolAnswer& answer);
    ToolPointer pointerAt(QPointF pixel, Qt::KeyboardModifiers modifiers) const;
    void seek(const Wanted& wanted);
    void seekNext();
    void found(const Wanted& wanted, const std::optional<SeenPlace>& seen);
    void moveHandle(const ToolPointer& pointer, QPointF pixel);
    void endDrag();
    void cancelDrag();
    void endSeries();
    /// Selects a handle and tells screen readers its name; empty: none.
    void select(const std::string& handle);
    void forgetPlaces();
    void selectNext();
    bool moveByKey(const QKeyEvent& event);
    bool ownKey(const QKeyEvent& event);
    void follow();
    void followModel();

    Workbench& workbench_;
    Session& session_;
    Viewport& viewport_;
    std::vector<Provided<Tool>> tools_;
    mutable std::optional<std::vector<Parameter>> ofMode_; ///< asked for once, as drawing needs them often
    std::string chosen_;
    std::string selected_, hovered_;
    std::optional<Drag> drag_;
    bool cancelled_ = false;         ///< a drag was, and its button is still down
    bool series_ = false;            ///< of arrow keys
    std::optional<QPointF> pressed_; ///< the button, there, and not moved since
    std::optional<ToolPointer> pointer_;
    std::deque<Wanted> wanted_; ///< after the one that is looked for
    bool seeking_ = false;
    ScenePick seen_;
};

} // namespace tetra
