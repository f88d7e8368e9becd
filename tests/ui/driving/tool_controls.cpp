// SPDX-License-Identifier: GPL-3.0-or-later
// How the actions of the menu Tools and the controls of the dock of the chosen tool are driven (D17).
#include "tests/ui/driving/driver.h"
#include "ui/tools/tool_desk.h"

#include <tan/render.h>

#include <QClipboard>
#include <QGuiApplication>

namespace tetra {
namespace {

ToolDesk& deskOf(const DrivenWindow& window)
{
    return window.find<ToolDesk>("viewport.toolDesk");
}

Driver choosing(const char* tool)
{
    return showing(QString("action.tool.") + tool,
                   [tool](const DrivenWindow& window) { return deskOf(window).chosen() == tool; });
}

/// With a tool that keeps something, and clip planes.
Driver::Step withTool(const char* tool, const std::string& value, const std::string& clip,
                      const char* mode = "isosurface")
{
    return [=](DrivenWindow& window) {
        window.choose(mode);
        ViewValue view = window.session().view();
        view.tools[tool] = value;
        view.appearance.settings["clip"] = clip;
        window.session().setView(view);
        deskOf(window).choose(tool);
        window.raise("dock.tools");
    };
}

Driver ruler(const QString& command, const std::string& after)
{
    return edit(
        "tool.ruler.command." + command,
        [after](ViewValue& view, const DrivenWindow&) {
            view.tools.erase("ruler");
            if (!after.empty())
                view.tools["ruler"] = after;
        },
        withTool("ruler", "0,0,0 3,0,0", ""));
}

/// The first plane becomes this one, whose normal may be of any length, but for rounding; the tool holds it.
Driver::Change clipBecomes(const std::function<ClipPlane(const ClipPlane& before)>& change)
{
    return [change](ViewValue& view, const DrivenWindow& window) {
        const auto firstOf = [](const ViewValue& of) {
            const auto planes = parseClipPlanes(std::get<std::string>(of.appearance.settings.at("clip")));
            ClipPlane plane = planes && !planes->empty() ? planes->front() : ClipPlane{};
            plane.offset /= plane.normal.norm();
            plane.normal.normalize();
            return plane;
        };
        ClipPlane should = change(firstOf(view));
        should.offset /= should.normal.norm();
        should.normal.normalize();
        const ClipPlane is = firstOf(window.now());
        const bool isThere = (is.normal - should.normal).norm() < 1e-9 && std::abs(is.offset - should.offset) < 1e-9;
        view.appearance.settings["clip"] =
            isThere ? window.now().appearance.settings.at("clip") : clipPlanesText(std::array{should});
        view.tools["plane"] = "clip 0";
    };
}

Driver plane(const QString& control, const std::function<ClipPlane(const ClipPlane& before)>& change)
{
    return edit("tool.plane." + control, clipBecomes(change), withTool("plane", "clip 0", "1,2,2,9"));
}

/// About the place of the plane that is nearest to the middle of the domain.
ClipPlane turnedTo(const Eigen::Vector3d& normal, const ClipPlane& before, const Eigen::Vector3d& middle)
{
    const Eigen::Vector3d centre = middle + before.normal * (before.offset - before.normal.dot(middle));
    return {normal, normal.dot(centre)};
}

/// Of the sample that all windows of these tests show.
Eigen::Vector3d middleOfSample()
{
    return Eigen::Vector3d::Constant(4.5);
}

Drivers planeControls()
{
    Drivers drivers{
        edit(
            "tool.plane.kind", [](ViewValue& view, const DrivenWindow&) { view.tools["plane"] = "clip! 0"; },
            withTool("plane", "slices 0", "", "slice")),
        edit(
            "tool.plane.number", [](ViewValue& view, const DrivenWindow&) { view.tools["plane"] = "clip 0"; },
            withTool("plane", "clip 1", "1,0,0,4;0,1,0,4")),
        plane("offset",
              [](const ClipPlane& before) {
                  return ClipPlane{before.normal, before.offset + 0.1};
              }),
        plane("command.flip",
              [](const ClipPlane& before) {
                  return ClipPlane{-before.normal, -before.offset};
              }),
        plane("command.align",
              [](const ClipPlane& before) { return turnedTo(Eigen::Vector3d::UnitY(), before, middleOfSample()); }),
        edit(
            "tool.plane.command.remove",
            [](ViewValue& view, const DrivenWindow&) {
                view.appearance.settings["clip"] = std::string("0,1,0,4");
                view.tools["plane"] = "clip 0";
            },
            withTool("plane", "clip 0", "1,0,0,4;0,1,0,4")),
        edit(
            "tool.plane.command.add",
            [](ViewValue& view, const DrivenWindow&) { // one looks along -z, somewhat to the left and down
                view.appearance.settings["clip"] = std::string("0,0,-1,-4.5");
                view.tools["plane"] = "clip 0";
            },
            withTool("plane", "clip 0", "")),
    };
    for (int axis = 0; axis < 3; ++axis)
        drivers.push_back(plane(QString("normal.") + QChar('x' + axis), [axis](const ClipPlane& before) {
            Eigen::Vector3d normal = before.normal;
            normal[axis] += 0.1;
            return turnedTo(normal.normalized(), before, middleOfSample());
        }));
    return drivers;
}

} // namespace

Drivers toolCommands()
{
    return {choosing("ruler"), choosing("plane")};
}

Drivers toolControls()
{
    const Drivers rulers{
        ruler("new", "0,0,0 3,0,0;"), ruler("remove", ""), ruler("clear", ""),
        showing(
            "tool.copy",
            [](const DrivenWindow&) { return QGuiApplication::clipboard()->text() == "Ruler 1\t3 units of the file"; },
            withTool("ruler", "0,0,0 3,0,0", ""))};
    return allOf({rulers, planeControls()});
}

} // namespace tetra
