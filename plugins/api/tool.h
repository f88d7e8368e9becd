// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/metadata.h"
#include "plugins/api/parameter.h"

#include <tan/base.h>
#include <tan/model.h>
#include <tan/render.h>
#include <tan/view.h>

#include <Eigen/Core>

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace tetra {

class Tool;
template <> inline constexpr std::string_view interfaceId<Tool> = "org.tan.Tool/1";

/// What is seen at a place of the picture.
struct SeenThere {
    Eigen::Vector3d place{0, 0, 0};
    std::string drawable{};        ///< its id in the scene
    std::optional<double> value{}; ///< of the field there, in its units, if the drawable tells
    bool operator==(const SeenThere&) const = default;
};

/// A place of the picture that was pointed at, in the coordinates of the dataset.
struct ToolPointer {
    Eigen::Vector2d pixel{0, 0}; ///< x to the right and y down, from the picture's upper left corner
    /// What is seen there lies on the line origin + t direction, in perspective with t > 0.
    Eigen::Vector3d origin{0, 0, 0};
    Eigen::Vector3d direction{0, 0, 1}; ///< of unit length, away from the viewer
    std::optional<SeenThere> seen{};    ///< nothing where nothing is seen, or where nobody has looked
    /// The place that is seen, else where the line meets the plane of the picture through the camera's target.
    Eigen::Vector3d place{0, 0, 0};
    bool shift = false; ///< the keys that are held
    bool control = false;
};

/// Writes a number with so many digits as the user's language does: "12,5".
using ToolNumbers = std::function<std::string(double number, int digits)>;

/// What a tool finds whenever it is asked for something; refers to what lives as long as the call.
struct ToolSurroundings {
    const ViewValue& view;         ///< how the model is looked at, all of it
    const ModelDescription& model; ///< its box, its units, its values
    const std::string& value;      ///< what the tool keeps: view.tools[id]; empty if it keeps nothing
    /// Those of the rendering mode that matter as they are set: whether it has clip planes, say.
    const std::vector<Parameter>& parameters;
    Camera camera{};      ///< that is looked through; not the view's while the picture glides there
    double width = 1;     ///< of the picture, in pixels
    double height = 1;    ///< likewise
    bool chosen = false;  ///< it gets the events; else it is asked what its value shows in a picture
    std::string handle{}; ///< the selected one of ToolDrawing::handles, by its id; empty if none is
    /// Where the pointer is, if the tool asks for it (ToolNeeds) and the pointer is over the picture.
    std::optional<ToolPointer> pointer{};
    ToolNumbers number{}; ///< for texts and readings; null: nobody reads them
};

/// What becomes of an event.
struct ToolAnswer {
    /// How the model is to be looked at then: `value` for what the tool keeps, or all of the view. It is brought into
    /// the limits that a view has. Without both nothing changes.
    std::optional<std::string> value{};
    std::optional<ViewValue> view{};
    Message name{}; ///< of the step of undo, "Move Ruler"; if it has none, it is named after what differs
    std::optional<std::string> handle{}; ///< to be selected
    bool taken = true;                   ///< a key: if not, the camera gets it
};

/// A line over the picture, through places of the dataset; what hides it in the scene does not hide it here.
struct ToolLine {
    std::vector<Eigen::Vector3d> points;
    bool closed = false; ///< from the last point to the first, too
    bool dashed = false;
    double width = 2;               ///< pixels
    std::optional<Colour> colour{}; ///< none: that of the annotations
};

/// A small disc.
struct ToolPoint {
    Eigen::Vector3d place{0, 0, 0};
    double radius = 3; ///< pixels
    std::optional<Colour> colour{};
};

/// Beside a place of the dataset.
struct ToolText {
    Eigen::Vector3d place{0, 0, 0};
    Message text{};
};

/// What a tool is grabbed by. The program finds it under the pointer, drags it, and moves it by keys.
struct ToolHandle {
    std::string id; ///< no other handle of the drawing has it
    Eigen::Vector3d place{0, 0, 0};
    Message name{};      ///< what is moved by it: "End of ruler 1"; for those who hear it
    bool seeks = false;  ///< ToolPointer::seen is looked for while it is dragged: the drag waits for that
    bool square = false; ///< else round
};

/// What a tool shows: a value, painted over the picture in the look of the annotations. Asked for while the tool is
/// chosen, and otherwise if it keeps something; then without its handles, as in pictures that are saved.
struct ToolDrawing {
    std::vector<ToolLine> lines{};
    std::vector<ToolPoint> points{};
    std::vector<ToolText> texts{};
    std::vector<ToolHandle> handles{};
};

/// A handle that is being moved.
struct HandleMove {
    std::string handle{};
    Eigen::Vector3d from{0, 0, 0}; ///< where it was when it was grabbed
    Eigen::Vector3d to{0, 0, 0}; ///< moved with the pointer in the plane of the picture through that; by keys one step
    ToolPointer pointer{};       ///< by keys: a pointer at `to`, where nobody has looked
    bool byKeys = false;
};

/// A key that neither moves a handle nor selects one.
struct ToolKey {
    std::string key{}; ///< "Delete", "Escape", "Backspace"; else what it writes, as a capital: "N"
    bool shift = false;
    bool control = false;
};

/// A button of the tool's panel, and a key while the tool is chosen.
struct ToolCommand {
    std::string id; ///< stable
    MarkedText text{""};
    MarkedText explanation{""};
    std::string key{}; ///< as ToolKey has it; may be empty
    bool enabled = true;
};

/// A line of the tool's panel that is only read, and can be copied: what was measured.
struct ToolReading {
    Message label{};
    Message text{};
};

struct ToolNeeds {
    bool pointer = false; ///< ToolSurroundings::pointer, with what is seen there, and a new drawing after each move
};

/// How the tool is offered, beside name and description of the metadata.
struct ToolLook {
    std::string shortcut{}; ///< "M"; not taken where the window has it already
    /// The icon: lines on a square of 24 units, x to the right and y down, drawn in the colour of texts.
    std::vector<std::vector<std::array<double, 2>>> icon{};
};

/// Something to do in the picture: measure, cut, point at ... One tool at a time is chosen; it gets what is clicked and
/// dragged in the picture, before the camera does. It holds nothing itself: what it keeps is a text in the view, so
/// that each change is a step to undo and is saved with the session, and all else is asked for by these functions of
/// the surroundings. Quick; called from any thread. What it throws is told, and counts as no answer.
class Tool {
public:
    virtual ~Tool() = default;

    virtual ToolLook look() const { return {}; }
    virtual ToolNeeds needs() const { return {}; }

    virtual ToolDrawing drawing(const ToolSurroundings& surroundings) const = 0;
    /// A click in the picture, not on a handle. By the keyboard: the space bar, at the pointer or else in the middle.
    virtual ToolAnswer clicked(const ToolSurroundings& surroundings, const ToolPointer& pointer) const = 0;
    /// All moves of one drag are one step to undo, and each goes from where the drag began: `surroundings` are those of
    /// the beginning, but for the camera. Escape takes it back.
    virtual ToolAnswer moved(const ToolSurroundings& surroundings, const HandleMove& move) const = 0;
    /// Keys of commands() do not come here.
    virtual ToolAnswer pressed(const ToolSurroundings&, const ToolKey&) const { return {.taken = false}; }

    /// The panel: a form of these parameters, whose default values are the present ones; ids may be those of others, as
    /// they are the tool's own.
    virtual std::vector<Parameter> parameters(const ToolSurroundings&) const { return {}; }
    virtual ToolAnswer parameterSet(const ToolSurroundings&, const std::string& /*id*/, const ParameterValue&) const
    {
        return {};
    }
    virtual std::vector<ToolReading> readings(const ToolSurroundings&) const { return {}; }
    virtual std::vector<ToolCommand> commands(const ToolSurroundings&) const { return {}; }
    virtual ToolAnswer commanded(const ToolSurroundings&, const std::string& /*id*/) const { return {}; }
};

} // namespace tetra
