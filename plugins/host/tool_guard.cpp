// SPDX-License-Identifier: GPL-3.0-or-later
// A tool as the program calls it (plugin_guards.h).
#include "core/base/text.h"
#include "plugins/host/plugin_call.h"
#include "plugins/host/plugin_guards.h"

#include <algorithm>
#include <set>

namespace tetra {
namespace {

constexpr double largestToolSize = 1000; ///< pixels, of lines and discs

/// Nothing of what cannot be seen, so that whoever paints needs no such questions.
ToolDrawing drawable(ToolDrawing drawing)
{
    const auto isNowhere = [](const Eigen::Vector3d& place) { return !place.allFinite(); };
    const auto isSize = [](double size) { return size > 0 && size <= largestToolSize; };
    std::erase_if(drawing.lines, [&](const ToolLine& line) {
        return line.points.size() < 2 || !isSize(line.width) || std::ranges::any_of(line.points, isNowhere);
    });
    std::erase_if(drawing.points,
                  [&](const ToolPoint& point) { return isNowhere(point.place) || !isSize(point.radius); });
    std::erase_if(drawing.texts, [&](const ToolText& text) { return text.text.empty() || isNowhere(text.place); });
    std::set<std::string> ids;
    std::erase_if(drawing.handles, [&](const ToolHandle& handle) {
        return handle.id.empty() || isNowhere(handle.place) || !ids.insert(handle.id).second;
    });
    return drawing;
}

class GuardedTool : public Tool {
public:
    GuardedTool(const Tool& plugin, GuardTarget target) : plugin_(plugin), target_(std::move(target)) {}

    ToolLook look() const override
    {
        return callOr(ToolLook(), [&] { return plugin_.look(); });
    }
    ToolNeeds needs() const override
    {
        return callOr(ToolNeeds(), [&] { return plugin_.needs(); });
    }
    ToolDrawing drawing(const ToolSurroundings& surroundings) const override
    {
        return drawable(callOr(ToolDrawing(), [&] { return plugin_.drawing(surroundings); }));
    }
    ToolAnswer clicked(const ToolSurroundings& surroundings, const ToolPointer& pointer) const override
    {
        return answer([&] { return plugin_.clicked(surroundings, pointer); });
    }
    ToolAnswer moved(const ToolSurroundings& surroundings, const HandleMove& move) const override
    {
        return answer([&] { return plugin_.moved(surroundings, move); });
    }
    ToolAnswer pressed(const ToolSurroundings& surroundings, const ToolKey& key) const override
    {
        return answer([&] { return plugin_.pressed(surroundings, key); }, {.taken = false});
    }
    std::vector<Parameter> parameters(const ToolSurroundings& surroundings) const override
    {
        auto all = callOr(std::vector<Parameter>(), [&] { return plugin_.parameters(surroundings); });
        for (Parameter& parameter : all)
            if (parameter.mistake)
                parameter.mistake = [target = target_, mistake = parameter.mistake](const std::string& text) {
                    return callPluginOr(Message(), target.id, target.tell, [&] { return mistake(text); });
                };
        return all;
    }
    ToolAnswer parameterSet(const ToolSurroundings& surroundings, const std::string& id,
                            const ParameterValue& value) const override
    {
        return answer([&] { return plugin_.parameterSet(surroundings, id, value); });
    }
    std::vector<ToolReading> readings(const ToolSurroundings& surroundings) const override
    {
        return callOr(std::vector<ToolReading>(), [&] { return plugin_.readings(surroundings); });
    }
    std::vector<ToolCommand> commands(const ToolSurroundings& surroundings) const override
    {
        return callOr(std::vector<ToolCommand>(), [&] { return plugin_.commands(surroundings); });
    }
    ToolAnswer commanded(const ToolSurroundings& surroundings, const std::string& id) const override
    {
        return answer([&] { return plugin_.commanded(surroundings, id); });
    }

private:
    template <class Value, class Work> Value callOr(Value fallback, Work&& work) const
    {
        return callPluginOr(std::move(fallback), target_.id, target_.tell, std::forward<Work>(work));
    }

    /// What is no text would not come back from a session as it was.
    bool canBeKept(const std::string& text) const
    {
        const bool isText = utf8Bytes(text) == text.size() && text.find('\0') == std::string::npos;
        if (isText && text.size() <= mostToolBytes)
            return true;
        target_.tell(brokenPlugin(target_.id, isText ? Message::say("what it keeps is too long")
                                                     : Message::say("what it keeps is no text")));
        return false;
    }

    template <class Work> ToolAnswer answer(Work&& work, ToolAnswer otherwise = {}) const
    {
        ToolAnswer given = callOr(std::move(otherwise), std::forward<Work>(work));
        if (given.value && !canBeKept(*given.value))
            given.value.reset();
        if (given.view)
            std::erase_if(given.view->tools, [&](const auto& tool) { return !canBeKept(tool.second); });
        return given;
    }

    const Tool& plugin_;
    GuardTarget target_;
};

} // namespace

std::unique_ptr<const Tool> guarded(const Tool& plugin, GuardTarget target)
{
    return std::make_unique<GuardedTool>(plugin, std::move(target));
}

} // namespace tetra
