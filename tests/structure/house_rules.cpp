// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/structure/house_rules.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <initializer_list>
#include <optional>
#include <regex>
#include <string_view>

namespace tetra {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view licenceLine = "// SPDX-License-Identifier: GPL-3.0-or-later";

/// A folder and the other folders that its files may include.
struct Room {
    std::string_view folder;
    std::vector<std::string_view> mayInclude;
};

const std::vector<Room>& rooms()
{
    static const std::vector<Room> all = {
        {"core/base", {}},
        {"core/data", {"core/base"}},
        {"core/mesh", {"core/base"}},
        {"core/cells", {"core/base", "core/data", "core/mesh"}},
        {"core/transfer", {"core/base"}},
        {"core/model", {"core/base", "core/data", "core/mesh", "core/transfer"}},
        {"core/graphics", {"core/base", "core/mesh", "core/transfer"}},
        {"plugins/api", {"core"}},
        {"plugins/host", {"core", "plugins/api"}},
        {"plugins/builders", {"core", "plugins/api"}},
        {"plugins/renderers", {"core", "plugins/api"}},
        {"plugins/widgets", {"core"}},
        {"plugins/editors", {"core", "plugins/api", "plugins/widgets"}},
        {"plugins/readers", {"core", "plugins/api"}},
        {"plugins/writers", {"core", "plugins/api"}},
        {"ui", {"core", "plugins/api", "plugins/host", "plugins/widgets"}},
        {"app", {"core", "plugins/api", "plugins/host", "plugins/widgets", "ui"}},
        {"tests", {"core", "plugins", "ui", "app"}},
    };
    return all;
}

bool liesIn(std::string_view path, std::string_view folder)
{
    return path.size() > folder.size() && path.starts_with(folder) && path[folder.size()] == '/';
}

/// The folder inside which files may include each other: the room, or for a plugin its own folder inside the room.
std::string homeOf(std::string_view path, const Room& room)
{
    constexpr std::array<std::string_view, 5> kinds = {"plugins/builders", "plugins/renderers", "plugins/editors",
                                                       "plugins/readers", "plugins/writers"};
    if (std::ranges::find(kinds, room.folder) == kinds.end())
        return std::string(room.folder);
    const auto end = path.find('/', room.folder.size() + 1);
    return std::string(path.substr(0, end));
}

const Room* roomOf(std::string_view path)
{
    const auto room =
        std::ranges::find_if(rooms(), [&](const Room& candidate) { return liesIn(path, candidate.folder); });
    return room == rooms().end() ? nullptr : &*room;
}

struct Include {
    std::string name;
    bool quoted;
};

std::optional<Include> includeOf(const std::string& line)
{
    static const std::regex directive(R"(^\s*#\s*include\s*(["<])([^">]+)[">])");
    std::smatch match;
    if (!std::regex_search(line, match, directive))
        return std::nullopt;
    return Include{match[2], match[1] == "\""};
}

bool isAnyOf(std::string_view name, std::initializer_list<std::string_view> prefixes)
{
    return std::ranges::any_of(prefixes, [&](std::string_view prefix) { return name.starts_with(prefix); });
}

bool isQt(const std::string& name)
{
    static const std::regex header(R"(^(Qt?[A-Z]\w*(/\w+(\.h)?)?|Qt\w*/.*|q[a-z0-9_]+\.h)$)");
    return std::regex_match(name, header);
}

/// The breach of including `include` from the file `path`, as the end of a sentence that begins with the path.
std::optional<std::string> includeBreach(const std::string& path, const Include& include, const fs::path& root)
{
    const std::string& name = include.name;
    const bool isHeader = path.ends_with(".h");
    if (liesIn(path, "core") && isQt(name))
        return "core is free of Qt, yet it includes " + name;
    if (liesIn(path, "core") && isHeader && isAnyOf(name, {"GL/", "GLES", "EGL/", "KHR/"}))
        return "core's headers are free of OpenGL, yet it includes " + name;
    if (liesIn(path, "core") && isHeader && name.starts_with("CGAL/"))
        return "core's headers are free of CGAL, yet it includes " + name;
    if (!include.quoted || name.ends_with(".moc"))
        return std::nullopt;

    const Room* room = roomOf(path);
    const Room* target = roomOf(name);
    if (target == nullptr || !fs::exists(root / name))
        return "includes \"" + name + "\", which is no file of this repository by its path from the root";
    const bool atHome = liesIn(name, homeOf(path, *room));
    if (!atHome &&
        std::ranges::none_of(room->mayInclude, [&](std::string_view folder) { return liesIn(name, folder); }))
        return "may not include " + name;
    return std::nullopt;
}

/// Whether the line asks the C library for the text of an error, which is in the user's language.
bool asksForLocalText(const std::string& path, const std::string& line)
{
    static const std::regex call(R"(\bstrerror\w*\s*\(|\.message\()");
    return !liesIn(path, "tests") && path != "core/base/system_error.cpp" && std::regex_search(line, call);
}

void readFile(const fs::path& root, const std::string& path, std::vector<std::string>& breaches)
{
    const auto report = [&](const std::string& what) { breaches.push_back(path + ": " + what); };
    if (roomOf(path) == nullptr)
        return report("this folder has no rule; give it one in tests/structure/house_rules.cpp");

    std::ifstream file(root / path);
    std::string line;
    bool isFirst = true;
    bool hasPragma = false;
    while (std::getline(file, line)) {
        if (std::exchange(isFirst, false) && line != licenceLine)
            report("the first line is not \"" + std::string(licenceLine) + "\"");
        hasPragma |= line == "#pragma once";
        const auto include = includeOf(line);
        const auto breach = include ? includeBreach(path, *include, root) : std::nullopt;
        if (breach)
            report(*breach);
        if (asksForLocalText(path, line))
            report("the system's reason would be in the user's language; take systemErrorText()");
    }
    if (path.ends_with(".h") && !hasPragma)
        report("a header without #pragma once");
}

std::vector<std::string> sourcesUnder(const fs::path& root)
{
    std::vector<std::string> paths;
    for (const char* folder : {"app", "core", "plugins", "tests", "ui"}) {
        if (!fs::is_directory(root / folder))
            continue;
        for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
            const auto extension = entry.path().extension();
            if (entry.is_regular_file() && (extension == ".h" || extension == ".cpp"))
                paths.push_back(fs::relative(entry.path(), root).generic_string());
        }
    }
    std::ranges::sort(paths);
    return paths;
}

} // namespace

std::vector<std::string> houseBreaches(const fs::path& root)
{
    std::vector<std::string> breaches;
    for (const auto& path : sourcesUnder(root))
        readFile(root, path, breaches);
    return breaches;
}

} // namespace tetra
