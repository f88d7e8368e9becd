// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/tool.h"

#include <Eigen/Geometry>

#include <string>
#include <utility>
#include <vector>

namespace tetra::testing {

/// A view with one tool in it, and what becomes of it, as the program does that.
struct ToolFixture {
    const Tool& tool;
    std::string id;
    ViewValue view{};
    ModelDescription model{};
    std::vector<Parameter> parameters{};
    std::string handle{};
    ToolNumbers numbers{};
    std::vector<std::string> names{}; ///< of the steps

    std::string value() const
    {
        const auto found = view.tools.find(id);
        return found != view.tools.end() ? found->second : std::string();
    }
    /// Calls `ask` with the surroundings.
    template <class Ask> auto with(Ask ask) const
    {
        const std::string kept = value();
        ToolSurroundings surroundings{
            .view = view, .model = model, .value = kept, .parameters = parameters, .camera = view.camera};
        surroundings.chosen = true;
        surroundings.handle = handle;
        surroundings.number = numbers;
        return ask(surroundings);
    }
    void take(const ToolAnswer& answer)
    {
        if (answer.handle)
            handle = *answer.handle;
        if (!answer.view && !answer.value)
            return;
        view = answer.view.value_or(view);
        if (answer.value)
            view.tools[id] = *answer.value;
        names.push_back(answer.name.text());
    }
    ToolDrawing drawing() const
    {
        return with([this](const ToolSurroundings& surroundings) { return tool.drawing(surroundings); });
    }
    std::vector<ToolReading> readings() const
    {
        return with([this](const ToolSurroundings& surroundings) { return tool.readings(surroundings); });
    }
    void click(const ToolPointer& pointer)
    {
        take(with([&](const ToolSurroundings& surroundings) { return tool.clicked(surroundings, pointer); }));
    }
    void move(const HandleMove& move)
    {
        take(with([&](const ToolSurroundings& surroundings) { return tool.moved(surroundings, move); }));
    }
    void set(const std::string& parameter, const ParameterValue& to)
    {
        take(
            with([&](const ToolSurroundings& surroundings) { return tool.parameterSet(surroundings, parameter, to); }));
    }
    bool isEnabled(const std::string& command) const
    {
        return with([&](const ToolSurroundings& surroundings) {
            for (const ToolCommand& each : tool.commands(surroundings))
                if (each.id == command)
                    return each.enabled;
            return false;
        });
    }
    void command(const std::string& command)
    {
        take(with([&](const ToolSurroundings& surroundings) { return tool.commanded(surroundings, command); }));
    }
};

/// Something is seen there.
inline ToolPointer seenAt(const Eigen::Vector3d& place)
{
    ToolPointer pointer;
    pointer.place = place;
    pointer.seen = SeenThere{place, "isosurface-1", 3.0};
    return pointer;
}

} // namespace tetra::testing
