// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/renderer_guard.h"

#include "plugins/host/plugin_call.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

namespace tetra {
namespace {

/// What is known of the field where there is nothing but its mesh.
FieldExtent extentOf(const RendererMeshes& meshes)
{
    FieldExtent field{{}, meshes.bounds, {}};
    if (meshes.mesh && !meshes.mesh->values.empty()) {
        const auto [smallest, largest] = std::ranges::minmax(meshes.mesh->values);
        field.range = {smallest, largest};
    }
    return field;
}

bool hasType(const Parameter& parameter, const ParameterValues& values)
{
    const auto found = values.find(parameter.id);
    return found != values.end() && haveOneType(found->second, parameter.defaultValue);
}

Status checkChoice(const Parameter& parameter, const ParameterValue& value)
{
    const auto* text = std::get_if<std::string>(&value);
    if (text == nullptr || parameter.choices.empty() || std::ranges::count(parameter.choices, *text) > 0)
        return {};
    std::string choices;
    for (const std::string& choice : parameter.choices)
        choices += (choices.empty() ? "" : ", ") + choice;
    return Error{ErrorKind::WrongUsage,
                 Message::say("'%1' is no choice for '%2'. There is: %3.", *text, parameter.id, choices)};
}

Status checkScene(const std::string& id, const Scene* scene)
{
    const auto mistake = [&](const Message& what) {
        return Error{ErrorKind::BadInput,
                     Message::say("The plugin '%1' made a scene that cannot be shown: %2 This is a mistake in the "
                                  "plugin; tell its author.",
                                  id, what)};
    };
    if (scene == nullptr)
        return mistake(Message::say("there is none."));
    std::set<std::string> ids;
    for (const Drawable& drawable : scene->drawables) {
        if (drawable.id.empty())
            return mistake(Message::say("a drawable has no name."));
        if (!ids.insert(drawable.id).second)
            return mistake(Message::say("two drawables are called '%1'.", drawable.id));
    }
    return {};
}

class GuardedSession final : public RendererSession {
public:
    GuardedSession(std::string id, const Renderer& plugin, const RendererMeshes& meshes)
        : id_(std::move(id)), plugin_(plugin), meshes_(meshes)
    {
    }

    Result<std::shared_ptr<const Scene>> prepare(const RendererView& view, const Progress& progress) override
    {
        using Scenes = Result<std::shared_ptr<const Scene>>;
        return callPlugin(id_, [&]() -> Scenes {
            RendererView whole = view;
            if (Status complete = completeValues(whole.values); !complete)
                return complete.error();
            if (!session_)
                session_ = plugin_.open(meshes_);
            if (!session_)
                return checkScene(id_, nullptr).error();
            Scenes scene = session_->prepare(whole, progress);
            if (!scene)
                return scene;
            if (Status good = checkScene(id_, scene->get()); !good)
                return good.error();
            return scene;
        });
    }

private:
    Status completeValues(ParameterValues& values)
    {
        if (!parameters_)
            parameters_ = plugin_.parameters(extentOf(meshes_));
        for (const Parameter& parameter : *parameters_) {
            if (!hasType(parameter, values))
                values[parameter.id] = parameter.defaultValue;
            if (Status good = checkChoice(parameter, values[parameter.id]); !good)
                return good;
        }
        return {};
    }

    std::string id_;
    const Renderer& plugin_;
    RendererMeshes meshes_;
    std::optional<std::vector<Parameter>> parameters_; ///< for the mesh
    std::unique_ptr<RendererSession> session_;         ///< of the plugin, once there is something to do
};

class GuardedRenderer final : public Renderer {
public:
    GuardedRenderer(std::string id, const Renderer& plugin) : id_(std::move(id)), plugin_(plugin) {}

    /// None if the plugin throws: its next scene tells why.
    std::vector<Parameter> parameters(const FieldExtent& field) const override
    {
        const auto parameters =
            callPlugin(id_, [&]() -> Result<std::vector<Parameter>> { return plugin_.parameters(field); });
        return parameters ? *parameters : std::vector<Parameter>();
    }

    RendererNeeds needs() const override
    {
        const auto needs = callPlugin(id_, [&]() -> Result<RendererNeeds> { return plugin_.needs(); });
        return needs ? *needs : RendererNeeds();
    }

    std::unique_ptr<RendererSession> open(const RendererMeshes& meshes) const override
    {
        return std::make_unique<GuardedSession>(id_, plugin_, meshes);
    }

private:
    std::string id_;
    const Renderer& plugin_;
};

} // namespace

std::unique_ptr<Renderer> guardedRenderer(std::string id, const Renderer& plugin)
{
    return std::make_unique<GuardedRenderer>(std::move(id), plugin);
}

} // namespace tetra
