// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/structure/house_rules.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <initializer_list>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <string_view>
#include <utility>

namespace tetra {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view licenceLine = "// SPDX-License-Identifier: GPL-3.0-or-later";

/// A folder, without those of its sub-folders that are rooms themselves, and what else its files may include: rooms, or
/// folders with all rooms in them. A room may include only what stands before it, so that all arrows point one way. The
/// headers of the face, and the entrance of the window, are rooms of their own.
struct Room {
    std::string_view folder;
    std::vector<std::string_view> mayInclude;
};

constexpr std::string_view faceFolder = "core/include/";
constexpr std::string_view tanBase = "core/include/tan/base.h", tanMesh = "core/include/tan/mesh.h",
                           tanData = "core/include/tan/data.h", tanModel = "core/include/tan/model.h",
                           tanQuery = "core/include/tan/query.h", tanBuild = "core/include/tan/build.h",
                           tanVerify = "core/include/tan/verify.h", tanTransfer = "core/include/tan/transfer.h",
                           tanOpen = "core/include/tan/open.h", tanRender = "core/include/tan/render.h",
                           tanPacked = "core/include/tan/packed.h", tanVersion = "core/include/tan/version.h",
                           tanZones = "core/include/tan/zones.h", tanParameter = "core/include/tan/parameter.h",
                           tanView = "core/include/tan/view.h", tanPicture = "core/include/tan/picture.h",
                           tanNames = "core/include/tan/fwd.h", tanWhole = "core/include/tan/tan.h";

const std::vector<Room>& rooms()
{
    static const std::vector<Room> all = {
        {tanBase, {}},
        {tanMesh, {tanBase}},
        {tanData, {tanBase}},
        {tanTransfer, {tanBase}},
        {tanModel, {tanBase, tanData}},
        {tanQuery, {tanBase, tanMesh, tanData, tanModel}},
        {tanBuild, {tanBase, tanData}},
        {tanOpen, {tanBase, tanModel, tanQuery}},
        {tanVerify, {tanBase, tanData, tanModel, tanQuery}},
        {tanRender, {tanBase, tanMesh, tanTransfer}},
        {tanPacked, {tanBase, tanModel}},
        {tanVersion, {tanBase}},
        {tanZones, {tanBase, tanData}},
        {tanParameter, {tanBase, tanTransfer, tanRender}},
        {tanView, {tanBase, tanMesh, tanData, tanModel, tanQuery, tanTransfer, tanRender, tanParameter}},
        {tanPicture, {tanBase, tanModel, tanParameter, tanRender, tanView}},
        {tanNames, {}},
        {tanWhole,
         {tanBase, tanBuild, tanData, tanNames, tanMesh, tanModel, tanOpen, tanPacked, tanParameter, tanPicture,
          tanQuery, tanRender, tanTransfer, tanVerify, tanVersion, tanView, tanZones}},
        {"core/base", {tanBase}},
        {"core/version", {tanBase, tanVersion}},
        {"core/remote", {tanBase, tanVersion, "core/base"}},
        {"core/geometry", {tanBase, "core/base"}},
        {"core/mesh", {tanBase, tanMesh, "core/base", "core/geometry"}},
        {"core/data", {tanBase, tanData, tanBuild, "core/base", "core/geometry", "core/mesh"}},
        {"core/data/cells", {tanBase, tanData, tanZones, "core/base", "core/geometry", "core/mesh", "core/data"}},
        {"core/refine", {tanBase, tanBuild, "core/base", "core/mesh"}},
        {"core/refine/lattice", {tanBase, tanBuild, "core/base", "core/mesh", "core/refine"}},
        {"core/refine/curvilinear",
         {tanBase, tanBuild, "core/base", "core/geometry", "core/mesh", "core/refine", "core/refine/lattice"}},
        {"core/refine/free", {tanBase, tanBuild, "core/base", "core/mesh", "core/refine"}},
        {"core/refine/insertion", {tanBase, "core/base", "core/refine/lattice", "core/refine/curvilinear"}},
        {"core/decimate", {tanBase, tanBuild, "core/base", "core/geometry", "core/mesh"}},
        {"core/transfer", {tanBase, tanTransfer, "core/base"}},
        {"core/transfer/import", {tanBase, tanTransfer, "core/base", "core/transfer"}},
        {"core/history",
         {tanBase, tanData, tanModel, tanQuery, tanBuild, "core/base", "core/geometry", "core/mesh", "core/data"}},
        {"core/history/blocks",
         {tanBase, tanModel, "core/base", "core/refine/lattice", "core/refine/curvilinear", "core/history"}},
        {"core/history/query",
         {tanBase, tanMesh, tanData, tanModel, tanQuery, "core/base", "core/geometry", "core/mesh", "core/data",
          "core/refine", "core/refine/lattice", "core/refine/insertion", "core/history"}},
        {"core/build",
         {tanBase, tanData, tanBuild, tanVersion, "core/base", "core/geometry", "core/data", "core/refine/lattice",
          "core/refine/curvilinear", "core/refine/free", "core/decimate", "core/history", "core/history/blocks"}},
        {"core/packed",
         {tanBase, tanMesh, tanData, tanModel, tanBuild, tanPacked, "core/base", "core/mesh", "core/data",
          "core/refine", "core/refine/lattice", "core/refine/curvilinear", "core/refine/insertion", "core/history",
          "core/build"}},
        {"core/verify",
         {tanBase, tanData, tanModel, tanQuery, tanVerify, "core/base", "core/geometry", "core/mesh", "core/data",
          "core/history", "core/history/query"}},
        {"core/serve",
         {tanBase, tanModel, tanQuery, tanPacked, tanOpen, "core/base", "core/remote", "core/data", "core/history",
          "core/packed", "core/verify"}},
        {"core/opening",
         {tanBase, tanModel, tanQuery, tanPacked, tanOpen, "core/base", "core/history", "core/build", "core/packed",
          "core/remote", "core/serve"}},
        {"core/render",
         {tanBase, tanMesh, tanTransfer, tanRender, "core/base", "core/geometry", "core/mesh", "core/transfer"}},
        {"core/render/isosurface", {tanBase, tanMesh, tanRender, "core/base", "core/mesh", "core/render"}},
        {"core/render/order", {tanBase, tanMesh, tanRender, "core/base", "core/geometry", "core/mesh", "core/render"}},
        {"core/render/samples", {tanBase, tanData, tanTransfer, tanRender, "core/base"}},
        {"core/render/volume",
         {tanBase, tanMesh, tanData, tanTransfer, tanRender, "core/base", "core/mesh", "core/transfer", "core/render",
          "core/render/order", "core/render/samples"}},
        {"core/render/cpu", {tanBase, tanRender, "core/base", "core/render", "core/render/volume"}},
        {"core/render/gl", {tanBase, tanRender, "core/base", "core/render", "core/render/volume"}},
        {"core/render/picking",
         {tanBase, tanMesh, tanRender, "core/base", "core/mesh", "core/render", "core/render/samples",
          "core/render/volume"}},
        {"core/view",
         {tanBase, tanMesh, tanData, tanModel, tanQuery, tanTransfer, tanRender, tanParameter, tanView, "core/base",
          "core/history", "core/transfer"}},
        {"core/picture/drawing", {tanBase, tanRender, "core/base"}},
        {"core/picture/annotations",
         {tanBase, tanData, tanModel, tanTransfer, tanRender, tanParameter, tanView, "core/base", "core/data",
          "core/render/picking", "core/view", "core/picture/drawing"}},
        {"plugins/api", {"core/include"}},
        {"plugins/samples", {"core/include", "core/base"}},
        {"plugins/host",
         {"core/include", "core/base", "core/mesh", "core/data", "core/history", "core/build", "plugins/api"}},
        {"plugins/host/parts",
         {"core/include", "core/base", "core/data", "core/history/blocks", "core/build", "plugins/api",
          "plugins/host"}},
        {"core/picture",
         {"core/include", "core/base", "core/mesh", "core/data", "core/history", "core/verify", "core/render",
          "core/render/isosurface", "core/render/volume", "core/view", "plugins/api", "plugins/host",
          "core/picture/drawing", "core/picture/annotations"}},
        {"plugins/builders", {"core/include", "plugins/api"}},
        {"plugins/renderers", {"core/include", "plugins/api"}},
        {"plugins/widgets", {"core/include"}},
        {"plugins/editors", {"core/include", "plugins/api", "plugins/widgets"}},
        {"plugins/process", {"core/include", "plugins/api"}},
        {"plugins/readers", {"core/include", "plugins/api", "plugins/process"}},
        {"plugins/readers/lattice/headers", {"core/include"}},
        {"plugins/readers/lattice/stored", {"core/include", "plugins/api", "plugins/readers/lattice/headers"}},
        {"plugins/readers/lattice/arrays",
         {"core/include", "plugins/api", "plugins/readers/lattice/headers", "plugins/readers/lattice/stored"}},
        {"plugins/readers/lattice/text",
         {"core/include", "plugins/api", "plugins/readers/lattice/headers", "plugins/readers/lattice/stored"}},
        {"plugins/readers/lattice/nrrd",
         {"core/include", "plugins/api", "plugins/readers/lattice/headers", "plugins/readers/lattice/stored"}},
        {"plugins/readers/lattice/nifti",
         {"core/include", "plugins/api", "plugins/readers/lattice/headers", "plugins/readers/lattice/stored"}},
        {"plugins/readers/lattice/metaimage",
         {"core/include", "plugins/api", "plugins/readers/lattice/headers", "plugins/readers/lattice/stored"}},
        {"plugins/readers/lattice/mrc",
         {"core/include", "plugins/api", "plugins/readers/lattice/headers", "plugins/readers/lattice/stored"}},
        {"plugins/readers/lattice/raw",
         {"core/include", "plugins/api", "plugins/readers/lattice/headers", "plugins/readers/lattice/stored",
          "plugins/readers/lattice/nrrd"}},
        {"plugins/readers/lattice",
         {"core/include", "plugins/api", "plugins/readers/lattice/headers", "plugins/readers/lattice/stored",
          "plugins/readers/lattice/arrays", "plugins/readers/lattice/text", "plugins/readers/lattice/nrrd",
          "plugins/readers/lattice/nifti", "plugins/readers/lattice/metaimage", "plugins/readers/lattice/mrc",
          "plugins/readers/lattice/raw"}},
        {"plugins/tools", {"core/include", "plugins/api"}},
        {"plugins/writers", {"core/include", "plugins/api"}},
        {"ui/work", {"core"}},
        {"ui/animation", {"core"}},
        {"ui/session", {"core", "plugins/api", "plugins/host", "plugins/widgets"}},
        {"ui/scenes", {"core", "plugins/api", "plugins/host", "ui/work", "ui/animation", "ui/session"}},
        {"ui/opening",
         {"core", "plugins/api", "plugins/samples", "plugins/host", "plugins/widgets", "ui/work", "ui/session",
          "ui/scenes"}},
        {"ui/workbench", {"core", "plugins/api", "plugins/host", "ui/work", "ui/session", "ui/scenes", "ui/opening"}},
        {"ui/widgets", {"core", "plugins/widgets", "ui/session", "ui/opening"}},
        {"ui/viewport",
         {"core", "plugins/api", "plugins/widgets", "ui/work", "ui/animation", "ui/session", "ui/scenes", "ui/opening",
          "ui/workbench", "ui/widgets"}},
        {"ui/panels",
         {"core", "plugins/api", "plugins/host", "plugins/widgets", "ui/work", "ui/animation", "ui/session",
          "ui/scenes", "ui/opening", "ui/workbench", "ui/widgets", "ui/viewport"}},
        {"ui/dialogs",
         {"core", "plugins/api", "plugins/host", "plugins/widgets", "ui/work", "ui/session", "ui/scenes", "ui/opening",
          "ui/workbench", "ui/widgets", "ui/viewport", "ui/panels"}},
        {"ui/tools",
         {"core", "plugins/api", "plugins/host", "plugins/widgets", "ui/session", "ui/scenes", "ui/opening",
          "ui/workbench", "ui/widgets", "ui/viewport", "ui/panels"}},
        {"ui/window",
         {"core", "plugins/api", "plugins/host", "plugins/widgets", "ui/work", "ui/animation", "ui/session",
          "ui/scenes", "ui/opening", "ui/workbench", "ui/widgets", "ui/viewport", "ui/panels", "ui/dialogs",
          "ui/tools"}},
        {"ui/desktop.h", {}},
        {"ui/desktop.cpp",
         {"core", "plugins/widgets", "ui/work", "ui/session", "ui/scenes", "ui/opening", "ui/workbench", "ui/widgets",
          "ui/window", "ui/desktop.h"}},
        {"app",
         {"core", "plugins/api", "plugins/samples", "plugins/host", "plugins/host/parts", "plugins/widgets", "ui"}},
        {"tests", {"core", "plugins", "ui", "app"}},
    };
    return all;
}

/// A folder of more sources than this (a header and its source counted once) is a heap, not a room.
constexpr std::size_t mostUnits = 25;

bool liesIn(std::string_view path, std::string_view folder)
{
    return path.size() > folder.size() && path.starts_with(folder) && path[folder.size()] == '/';
}

const Room* roomOf(std::string_view path)
{
    const Room* found = nullptr;
    for (const Room& room : rooms())
        if ((path == room.folder || liesIn(path, room.folder)) &&
            (found == nullptr || room.folder.size() > found->folder.size()))
            found = &room;
    return found;
}

/// The folder inside which files may include each other: the room, or for a plugin its own folder inside the room.
std::string homeOf(std::string_view path, const Room& room)
{
    constexpr std::array<std::string_view, 6> kinds = {"plugins/builders", "plugins/renderers", "plugins/editors",
                                                       "plugins/readers",  "plugins/tools",     "plugins/writers"};
    if (std::ranges::find(kinds, room.folder) == kinds.end())
        return std::string(room.folder);
    const auto end = path.find('/', room.folder.size() + 1);
    return std::string(path.substr(0, end));
}

/// Whether `folder` stands for `room`: it is that one, or is no room and holds it.
bool standsFor(std::string_view folder, const Room& room)
{
    const bool isRoom = std::ranges::any_of(rooms(), [&](const Room& other) { return other.folder == folder; });
    return folder == room.folder || (!isRoom && liesIn(room.folder, folder));
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

/// Editors and their widgets, with what makes an editor one; and programs that read files beside plugins.
bool mayUseQt(std::string_view path)
{
    return path == "plugins/api/editor.h" || path.find("/helper/") != std::string_view::npos ||
           liesIn(path, "plugins/editors") || liesIn(path, "plugins/widgets") ||
           !(liesIn(path, "core") || liesIn(path, "plugins"));
}

/// The breach of including `include` from the file `path`, as the end of a sentence that begins with the path.
std::optional<std::string> includeBreach(const std::string& path, const Include& include, const fs::path& root)
{
    const std::string& name = include.name;
    const bool isHeader = path.ends_with(".h");
    if (!mayUseQt(path) && isQt(name))
        return (liesIn(path, "core") ? "core is" : "plugins but editors are") +
               (" free of Qt, yet it includes " + name);
    if (liesIn(path, "app") && isQt(name))
        return "the programs are free of Qt, yet it includes " + name;
    if (liesIn(path, "core") && isHeader && isAnyOf(name, {"GL/", "GLES", "EGL/", "KHR/"}))
        return "core's headers are free of OpenGL, yet it includes " + name;
    if (liesIn(path, "core") && isHeader && name.starts_with("CGAL/"))
        return "core's headers are free of CGAL, yet it includes " + name;
    if (!liesIn(path, "core/picture/drawing") && isAnyOf(name, {"ft2build.h", "hb", "fontconfig/", "fribidi"}))
        return "texts of pictures are the matter of core/picture/drawing, yet it includes " + name;
    const bool isFace = !include.quoted && name.starts_with("tan/");
    if (!(include.quoted || isFace) || name.ends_with(".moc"))
        return std::nullopt;

    const std::string file = isFace ? std::string(faceFolder) + name : name;
    const Room* room = roomOf(path);
    const Room* target = roomOf(file);
    if (target == nullptr || !fs::exists(root / file))
        return "includes \"" + name + "\", which is no file of this repository by its path from the root";
    const bool atHome = room == target && liesIn(file, homeOf(path, *room));
    if (!atHome &&
        std::ranges::none_of(room->mayInclude, [&](std::string_view folder) { return standsFor(folder, *target); }))
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

/// Where texts for developers name a source that is not there.
void readText(const fs::path& root, const fs::path& text, std::vector<std::string>& breaches)
{
    static const std::regex source(R"((^|[^/\w.-])((app|core|plugins|tests|ui)/[\w/]+\.(h|cpp))\b)");
    std::ifstream file(text);
    std::string line;
    while (std::getline(file, line))
        for (std::sregex_iterator named(line.begin(), line.end(), source), end; named != end; ++named)
            if (!fs::exists(root / (*named)[2].str()))
                breaches.push_back(fs::relative(text, root).generic_string() + ": names " + (*named)[2].str() +
                                   ", which is not there");
}

void readTexts(const fs::path& root, std::vector<std::string>& breaches)
{
    for (const char* folder : {".", "docs/user", "docs/developer", "docs/lab", "core", "core/history", "ui"})
        if (fs::is_directory(root / folder))
            for (const auto& entry : fs::directory_iterator((root / folder).lexically_normal()))
                if (entry.path().extension() == ".md")
                    readText(root, entry.path(), breaches);
}

/// The breach of a folder that holds so many units.
std::optional<std::string> unitBreach(const Heaps& heaps, const std::string& folder, std::size_t units)
{
    const auto heap = heaps.find(folder);
    const std::size_t most = heap == heaps.end() ? mostUnits : heap->second;
    if (units > most)
        return std::to_string(units) + " units, more than " + std::to_string(most) +
               "; divide the folder, or join what is one idea";
    if (heap != heaps.end() && units < most)
        return std::to_string(units) + " units; let its number among the heaps of tests/structure/house_rules.cpp " +
               "fall from " + std::to_string(most) + (units <= mostUnits ? ", that is, take its line away" : "");
    return std::nullopt;
}

} // namespace

Heaps heapsOfThisTree()
{
    return {{"app/command_line", 37}, {"core/base", 26}, {"plugins/host", 26}, {"tests/fuzz", 27}, {"tests/ui", 69}};
}

std::vector<std::string> houseBreaches(const fs::path& root, const Heaps& heaps)
{
    std::vector<std::string> breaches;
    readTexts(root, breaches);
    std::map<std::string, std::set<std::string>> unitsOf;
    for (const auto& path : sourcesUnder(root)) {
        readFile(root, path, breaches);
        unitsOf[fs::path(path).parent_path()].insert(fs::path(path).stem());
    }
    for (const auto& [folder, units] : unitsOf)
        if (const auto breach = unitBreach(heaps, folder, units.size()))
            breaches.push_back(folder + ": " + *breach);
    return breaches;
}

std::vector<std::string> arrowsBack()
{
    std::vector<std::string> found;
    for (auto room = rooms().begin(); room != rooms().end(); ++room)
        for (auto later = room; later != rooms().end(); ++later)
            for (const std::string_view folder : room->mayInclude)
                if (standsFor(folder, *later))
                    found.push_back(std::string(room->folder) + " may include " + std::string(later->folder));
    return found;
}

} // namespace tetra
