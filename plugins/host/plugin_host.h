// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/builder.h"
#include "plugins/api/reader.h"
#include "plugins/api/renderer.h"
#include "plugins/api/tool.h"
#include "plugins/api/writer.h"
#include "plugins/host/compatibility.h"
#include "plugins/host/plugin_guards.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <type_traits>
#include <vector>

namespace tetra {

enum class PluginState {
    Found,    ///< fits, and is loaded when first used
    Loaded,   ///< in use
    Disabled, ///< not to be used: the user said so
    Refused,  ///< cannot be used; the error says why and what to do
};

/// "found", "loaded", "disabled", "refused".
std::string_view pluginStateName(PluginState state) noexcept;

/// A plugin as it stands now.
struct PluginStatus {
    std::filesystem::path path;
    PluginMetadata metadata; ///< the id is the file's name if the file's metadata cannot be read
    bool hasMetadata = false;
    PluginState state = PluginState::Found;
    Message error; ///< why it is disabled or refused, and the remedy
};

/// A loaded plugin. Of all but editors it is a guard, which lets no exception through (plugin_guards.h): it lives as
/// long as its host, and what it gives away (parameters, sessions) is not used longer.
template <class Interface> struct Provided {
    std::string id;
    std::string name;
    const Interface* plugin = nullptr;
    std::map<std::string, std::string> names{}; ///< the name in other languages, by their codes
};

struct PluginHostOptions {
    std::vector<std::filesystem::path> folders; ///< the first one wins
    std::vector<std::string> disabled{};        ///< ids
    /// One of the folders, of which nothing is loaded where others could have put it (plugin_folders.h).
    std::filesystem::path ownFolder{};
    HostBuild build = thisBuild();
};

/// Finds plugins, checks them by their metadata, and loads them when they are first used. Whatever lies in the folders,
/// making a host succeeds: what cannot be used is listed with its reason. Safe to use from any thread.
///
/// Plugins are never unloaded: values that they made (a dataset's samples, a scene) may need their code.
class PluginHost {
public:
    explicit PluginHost(PluginHostOptions options);
    ~PluginHost();
    PluginHost(const PluginHost&) = delete;
    PluginHost& operator=(const PluginHost&) = delete;

    /// With the folders and the disabled plugins of plugin_folders.h, as seen from the running program.
    static std::unique_ptr<PluginHost> standard();
    /// The same for programs of others: as seen from this library.
    static std::unique_ptr<PluginHost> ofLibrary();

    const std::vector<std::filesystem::path>& folders() const noexcept { return options_.folders; }
    /// All that was found, by kind and id.
    std::vector<PluginStatus> plugins() const;

    /// All usable plugins of a kind, by id; loads them. One that cannot be loaded is missing here, and whenFailing()
    /// says why.
    std::vector<Provided<Builder>> builders() { return all<Builder>(PluginKind::Builder); }
    std::vector<Provided<Renderer>> renderers() { return all<Renderer>(PluginKind::Renderer); }
    std::vector<Provided<Reader>> readers() { return all<Reader>(PluginKind::Reader); }
    std::vector<Provided<Writer>> writers() { return all<Writer>(PluginKind::Writer); }
    std::vector<Provided<Editor>> editors() { return all<Editor>(PluginKind::Editor); }
    std::vector<Provided<Tool>> tools() { return all<Tool>(PluginKind::Tool); }

    /// One plugin; loads it. The error says why it cannot be had, or which ones there are.
    Result<Provided<Builder>> builder(const std::string& id) { return one<Builder>(PluginKind::Builder, id); }
    Result<Provided<Renderer>> renderer(const std::string& id) { return one<Renderer>(PluginKind::Renderer, id); }
    Result<Provided<Editor>> editor(const std::string& id) { return one<Editor>(PluginKind::Editor, id); }
    Result<Provided<Reader>> reader(const std::string& id) { return one<Reader>(PluginKind::Reader, id); }
    Result<Provided<Tool>> tool(const std::string& id) { return one<Tool>(PluginKind::Tool, id); }

    /// `tell` hears of each failure that the caller is not given as an error: of a plugin that turns out to be unusable
    /// when all of its kind are loaded, and of one that throws where it has no Result to give. From any thread, so that
    /// it may only pass it on, and must not call the host; it is not called any more once another one is given. None:
    /// nobody hears of it.
    void whenFailing(std::function<void(const Error&)> tell);

    /// Why plugins of this kind are missing, a line each; empty if none is.
    Message explainMissing(PluginKind kind) const;

    /// An error (OutOfResource) if there were not enough memory or open files to find or load all plugins: then what
    /// seems to be missing, a renderer or an option, may only be missing now.
    Status complete() const;

private:
    struct Entry;
    struct Loaded {
        const PluginMetadata* metadata;
        const PluginGuard* guard;
    };

    void find();
    void disable();
    void refuseDuplicates();
    void resolveDependencies();
    Entry* usable(const std::string& id) const;
    Message whyNotUsed(const std::string& id) const;
    std::vector<std::string> usableIds(PluginKind kind) const;
    Result<Loaded> instance(PluginKind kind, const std::string& id);
    Status load(Entry& entry);
    Status open(Entry& entry);
    Error notLoaded(const Entry& entry);
    Error lacking(const Message& reason);
    void tell(const Error& error) const;
    Status loadRequired(const Entry& entry);

    template <class Interface> Result<Provided<Interface>> one(PluginKind kind, const std::string& id)
    {
        const auto loaded = instance(kind, id);
        if (!loaded)
            return loaded.error();
        return Provided<Interface>{id, loaded->metadata->name, face<Interface>(*loaded), loaded->metadata->names};
    }
    template <class Interface> static const Interface* face(const Loaded& loaded)
    {
        if constexpr (std::is_same_v<Interface, Editor>)
            return std::get<const Editor*>(*loaded.guard);
        else
            return std::get<std::unique_ptr<const Interface>>(*loaded.guard).get();
    }
    template <class Interface> std::vector<Provided<Interface>> all(PluginKind kind)
    {
        std::vector<Provided<Interface>> found;
        for (const std::string& id : usableIds(kind)) {
            if (auto provided = one<Interface>(kind, id))
                found.push_back(*std::move(provided));
            else
                tell(provided.error());
        }
        return found;
    }

    PluginHostOptions options_;
    mutable std::mutex mutex_; ///< guards the next two after construction
    std::vector<std::unique_ptr<Entry>> entries_;
    Status complete_;
    mutable std::mutex telling_; ///< guards the next one, also while it is called
    std::function<void(const Error&)> tell_;
};

} // namespace tetra
