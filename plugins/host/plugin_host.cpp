// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/plugin_host.h"

#include "core/base/folder.h"
#include "core/base/system_error.h"
#include "plugins/host/dependency_order.h"
#include "plugins/host/plugin_file.h"
#include "plugins/host/plugin_folders.h"

#include <algorithm>
#include <exception>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include <dlfcn.h>

namespace tetra {

namespace fs = std::filesystem;

struct PluginHost::Entry {
    PluginStatus status;
    PluginGuard guard; ///< of a plugin that is in use

    bool usable() const { return status.state == PluginState::Found || status.state == PluginState::Loaded; }
    void refuse(Message error)
    {
        status.state = PluginState::Refused;
        status.error = std::move(error);
    }
};

namespace {

/// Whether a file is called as shared libraries are, "libmine.so" or "libmine.so.1.2".
bool isCalledLibrary(const fs::path& path)
{
    const std::string name = path.filename().string();
    const std::size_t ending = name.rfind(".so");
    return ending != std::string::npos && ending > 0 &&
           name.find_first_not_of(".0123456789", ending + 3) == std::string::npos &&
           (ending + 3 == name.size() || name[ending + 3] == '.');
}

/// The shared libraries directly in `folder`, by name; none if it cannot be read.
std::vector<fs::path> librariesIn(const fs::path& folder, std::error_code& problem)
{
    std::vector<fs::path> paths = pathsIn(folder, problem);
    std::erase_if(paths, [](const fs::path& path) {
        std::error_code ignored;
        return fs::is_directory(path, ignored) || !isCalledLibrary(path);
    });
    std::ranges::sort(paths);
    return paths;
}

/// What a library says of itself, and whether it fits. Only a lack of resources is an error: nothing is known then.
Result<PluginStatus> inspect(const fs::path& path, const HostBuild& build)
{
    PluginStatus status;
    status.path = path;
    status.metadata.id = path.stem().string();
    const auto refuse = [&](Message error) {
        status.state = PluginState::Refused;
        status.error = std::move(error);
        return status;
    };

    const auto text = pluginText(path);
    if (!text && text.error().kind == ErrorKind::OutOfResource)
        return text.error();
    if (!text)
        return refuse(text.error().message);
    auto metadata = parsePluginMetadata(*text);
    if (!metadata)
        return refuse(metadata.error().message);
    status.metadata = *std::move(metadata);
    status.hasMetadata = true;
    if (const Status compatible = checkCompatible(status.metadata, build); !compatible)
        return refuse(compatible.error().message);
    return status;
}

/// Of a library in the user's own folder, DATA/tan/plugins.
Message whyNotTrusted(const fs::path& library)
{
    const fs::path plugins = library.parent_path();
    for (const fs::path& place : {plugins.parent_path(), plugins, library})
        if (Message why = whyOthersMayWrite(place); !why.empty())
            return why;
    return {};
}

std::string joined(const std::vector<std::string>& ids)
{
    std::string text;
    for (const std::string& id : ids)
        text += (text.empty() ? "" : ", ") + id;
    return text;
}

} // namespace

std::string_view pluginStateName(PluginState state) noexcept
{
    constexpr MarkedText names[] = {Message::marked("found"), Message::marked("loaded"), Message::marked("disabled"),
                                    Message::marked("refused")};
    return names[static_cast<std::size_t>(state)];
}

PluginHost::PluginHost(PluginHostOptions options) : options_(std::move(options))
{
    find();
    disable();
    refuseDuplicates();
    resolveDependencies();
    std::ranges::stable_sort(entries_, [](const auto& a, const auto& b) {
        const auto key = [](const Entry& entry) {
            return std::tie(entry.status.metadata.kind, entry.status.metadata.id);
        };
        return key(*a) < key(*b);
    });
}

PluginHost::~PluginHost() = default;

namespace {

std::unique_ptr<PluginHost> hostOf(std::vector<fs::path> folders)
{
    std::error_code problem;
    const fs::path own = fs::weakly_canonical(userPluginFolder(), problem); // as it stands among the folders
    return std::make_unique<PluginHost>(
        PluginHostOptions{.folders = std::move(folders), .disabled = disabledPlugins(), .ownFolder = own});
}

} // namespace

std::unique_ptr<PluginHost> PluginHost::standard()
{
    std::error_code problem;
    return hostOf(pluginFolders(fs::read_symlink("/proc/self/exe", problem).parent_path()));
}

std::unique_ptr<PluginHost> PluginHost::ofLibrary()
{
    return hostOf(pluginFoldersOfLibrary());
}

std::vector<PluginStatus> PluginHost::plugins() const
{
    const std::lock_guard lock(mutex_);
    std::vector<PluginStatus> all;
    all.reserve(entries_.size());
    for (const auto& entry : entries_)
        all.push_back(entry->status);
    return all;
}

Message PluginHost::explainMissing(PluginKind kind) const
{
    Message text;
    for (const PluginStatus& plugin : plugins())
        if (!plugin.error.empty() && (plugin.metadata.kind == kind || !plugin.hasMetadata))
            text = Message::say("%1\nThe plugin %2 (%3) is not used. %4", text, plugin.metadata.id,
                                plugin.path.string(), plugin.error);
    return text;
}

void PluginHost::whenFailing(std::function<void(const Error&)> tell)
{
    const std::lock_guard lock(telling_);
    tell_ = std::move(tell);
}

void PluginHost::tell(const Error& error) const
{
    const std::lock_guard lock(telling_);
    if (tell_)
        tell_(error);
}

void PluginHost::find()
{
    std::set<fs::path> seen; // one file is one plugin, by however many links and folders it is reached
    for (const fs::path& folder : options_.folders) {
        std::error_code problem;
        for (const fs::path& path : librariesIn(folder, problem)) {
            std::error_code ignored;
            if (!seen.insert(fs::weakly_canonical(path, ignored)).second)
                continue;
            auto status = inspect(path, options_.build);
            entries_.push_back(std::make_unique<Entry>());
            if (status) {
                entries_.back()->status = *std::move(status);
            } else {
                complete_ = status.error();
                entries_.back()->status.path = path;
                entries_.back()->status.metadata.id = path.stem().string();
                entries_.back()->refuse(status.error().message);
            }
            if (folder == options_.ownFolder && entries_.back()->usable())
                if (Message why = whyNotTrusted(path); !why.empty())
                    entries_.back()->refuse(std::move(why));
        }
        if (isLackOfResources(problem.value()))
            lacking(Message::say("%1.", systemErrorText(problem.value())));
    }
}

Status PluginHost::complete() const
{
    const std::lock_guard lock(mutex_);
    return complete_;
}

/// Notes it for complete().
Error PluginHost::lacking(const Message& reason)
{
    Error error{ErrorKind::OutOfResource,
                Message::say("Not all plugins can be loaded now: %1 %2", reason, resourceRemedy)};
    complete_ = error;
    return error;
}

void PluginHost::disable()
{
    for (const auto& entry : entries_)
        if (entry->usable() && std::ranges::count(options_.disabled, entry->status.metadata.id) > 0) {
            entry->status.state = PluginState::Disabled;
            entry->status.error = Message::say("It is disabled by the settings or by %1.", "TAN_PLUGIN_DISABLE");
        }
}

void PluginHost::refuseDuplicates()
{
    std::map<std::string, const Entry*> first;
    for (const auto& entry : entries_) {
        if (!entry->usable())
            continue;
        const auto [found, isNew] = first.emplace(entry->status.metadata.id, entry.get());
        if (!isNew)
            entry->refuse(Message::say("Another plugin has the same id and was found first: %1. Remove one of the two.",
                                       found->second->status.path.string()));
    }
}

void PluginHost::resolveDependencies()
{
    std::vector<Entry*> candidates;
    std::vector<Dependent> dependents;
    for (const auto& entry : entries_)
        if (entry->usable()) {
            candidates.push_back(entry.get());
            dependents.push_back({entry->status.metadata.id, entry->status.metadata.requiredIds});
        }
    const DependencyOrder order = dependencyOrder(dependents);
    for (std::size_t index = 0; index < candidates.size(); ++index)
        if (!order.errors[index].empty())
            candidates[index]->refuse(order.errors[index]);
}

PluginHost::Entry* PluginHost::usable(const std::string& id) const
{
    const auto found = std::ranges::find_if(
        entries_, [&](const auto& entry) { return entry->usable() && entry->status.metadata.id == id; });
    return found == entries_.end() ? nullptr : found->get();
}

Message PluginHost::whyNotUsed(const std::string& id) const
{
    for (const auto& entry : entries_)
        if (entry->status.metadata.id == id && !entry->status.error.empty())
            return entry->status.error;
    return {};
}

std::vector<std::string> PluginHost::usableIds(PluginKind kind) const
{
    const std::lock_guard lock(mutex_);
    std::vector<std::string> ids;
    for (const auto& entry : entries_)
        if (entry->usable() && entry->status.metadata.kind == kind)
            ids.push_back(entry->status.metadata.id);
    return ids;
}

Result<PluginHost::Loaded> PluginHost::instance(PluginKind kind, const std::string& id)
{
    const Message kindName = pluginKindText(kind);
    {
        const std::lock_guard lock(mutex_);
        Entry* entry = usable(id);
        if (entry != nullptr && entry->status.metadata.kind == kind) {
            if (const Status loaded = load(*entry); !loaded)
                return loaded.error();
            return Loaded{&entry->status.metadata, &entry->guard};
        }
        if (const Message reason = whyNotUsed(id); !reason.empty())
            return Error{ErrorKind::WrongUsage, Message::say("The %1 \"%2\" cannot be used. %3", kindName, id, reason)};
    }
    const auto ids = usableIds(kind);
    return Error{ErrorKind::WrongUsage, Message::say("There is no %1 \"%2\". %3", kindName, id,
                                                     ids.empty() ? Message::say("None is installed.")
                                                                 : Message::say("Available: %1.", joined(ids)))};
}

Status PluginHost::loadRequired(const Entry& entry)
{
    for (const std::string& id : entry.status.metadata.requiredIds) {
        Entry* required = usable(id);
        const Status loaded = required != nullptr ? load(*required) : Error{ErrorKind::BadInput, whyNotUsed(id)};
        if (!loaded && loaded.error().kind == ErrorKind::OutOfResource)
            return loaded;
        if (!loaded)
            return Error{ErrorKind::BadInput, Message::say("It needs the plugin \"%1\", which cannot be used: %2", id,
                                                           loaded.error().message)};
    }
    return {};
}

/// Loads what it requires first; there are no circles, they were refused before. Whatever fails, the entry is refused,
/// but if it is only for a lack of resources.
Status PluginHost::load(Entry& entry)
{
    if (entry.status.state == PluginState::Loaded)
        return {};
    Status loaded = loadRequired(entry);
    if (loaded)
        loaded = open(entry);
    if (loaded || loaded.error().kind == ErrorKind::OutOfResource)
        return loaded;
    entry.refuse(loaded.error().message);
    return Error{ErrorKind::BadInput,
                 Message::say("The plugin \"%1\" cannot be used. %2", entry.status.metadata.id, entry.status.error)};
}

/// Why the system does not load a library.
Error PluginHost::notLoaded(const Entry& entry)
{
    const char* const told = ::dlerror();
    const std::string reason = told != nullptr ? told : "";
    if (namesLackOfResources(reason))
        return lacking(Message(reason + "."));
    if (const auto text = pluginText(entry.status.path); !text && text.error().kind == ErrorKind::OutOfResource) {
        complete_ = text.error();
        return text.error();
    }
    return {ErrorKind::BadInput, explainLoadError(reason, entry.status.metadata.remedy)};
}

/// Libraries stay loaded, those too that turn out to be no good: their code may have begun to do something.
Status PluginHost::open(Entry& entry)
{
    const auto bad = [](Message text) { return Error{ErrorKind::BadInput, std::move(text)}; };
    const std::string interface(pluginInterface(entry.status.metadata.kind));
    const void* object = nullptr;
    try {
        // Every symbol is looked up now, so that a missing one is an error here and not a crash later.
        void* const library = ::dlopen(fs::absolute(entry.status.path).c_str(), RTLD_NOW | RTLD_LOCAL);
        if (library == nullptr)
            return notLoaded(entry);
        void* const entrance = ::dlsym(library, "tanPlugin");
        if (entrance == nullptr)
            return bad(Message::say("It has no function %1, so it is not a complete plugin. Install it again, or ask "
                                    "its author for a complete one.",
                                    "tanPlugin"));
        object = reinterpret_cast<const void* (*)(const char*)>(entrance)(interface.c_str());
    } catch (const std::exception& problem) {
        if (const auto lack = lackOfResources(problem))
            return *lack;
        return bad(Message::say("It failed to start: %1. Install it again.", problem.what()));
    } catch (...) {
        return bad(Message::say("It failed to start, without giving a reason. Install it again."));
    }
    if (object == nullptr)
        return bad(
            Message::say("Its metadata call it a %1, but it does not implement %2. Ask the plugin's author for a "
                         "fixed version.",
                         pluginKindText(entry.status.metadata.kind), interface));
    GuardTarget target{entry.status.metadata.id, [this](const Error& error) { tell(error); }};
    switch (entry.status.metadata.kind) {
    case PluginKind::Builder: entry.guard = guarded(*static_cast<const Builder*>(object), std::move(target)); break;
    case PluginKind::Reader: entry.guard = guarded(*static_cast<const Reader*>(object), std::move(target)); break;
    case PluginKind::Writer: entry.guard = guarded(*static_cast<const Writer*>(object), std::move(target)); break;
    case PluginKind::Renderer: entry.guard = guarded(*static_cast<const Renderer*>(object), std::move(target)); break;
    case PluginKind::Editor: entry.guard = static_cast<const Editor*>(object); break;
    case PluginKind::Tool: entry.guard = guarded(*static_cast<const Tool*>(object), std::move(target)); break;
    }
    entry.status.state = PluginState::Loaded;
    return {};
}

} // namespace tetra
