// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/plot3d/plot3d_names.h"

#include <tan/base.h>

#include <initializer_list>
#include <string>

namespace tetra {

namespace {

using Path = std::filesystem::path;

/// `file` with the last `from` of its stem replaced, in the same or the other case, keeping its extension.
void addWithStemEnd(const Path& file, const std::string& from, const std::string& to, std::vector<Path>& names)
{
    const std::string stem = file.stem().string();
    if (stem.size() > from.size() && stem.ends_with(from))
        names.push_back(file.parent_path() /
                        (stem.substr(0, stem.size() - from.size()) + to + file.extension().string()));
}

void addWithExtensions(const Path& file, std::initializer_list<const char*> extensions, std::vector<Path>& names)
{
    for (const char* extension : extensions) {
        Path name = file;
        name.replace_extension(extension);
        if (name != file)
            names.push_back(name);
    }
}

} // namespace

std::vector<Path> solutionNames(const Path& grid)
{
    std::vector<Path> names;
    addWithStemEnd(grid, "xyz", "q", names);
    addWithStemEnd(grid, "XYZ", "Q", names);
    addWithStemEnd(grid, "grid", "q", names);
    addWithStemEnd(grid, "x", "q", names);
    addWithExtensions(grid, {".q", ".Q", ".qsol", ".sol"}, names);
    return names;
}

std::vector<Path> gridNames(const Path& solution)
{
    std::vector<Path> names;
    addWithStemEnd(solution, "q", "xyz", names);
    addWithStemEnd(solution, "Q", "XYZ", names);
    addWithStemEnd(solution, "q", "grid", names);
    addWithStemEnd(solution, "q", "x", names);
    addWithExtensions(solution, {".xyz", ".XYZ", ".x", ".X", ".g", ".grd", ".p3d"}, names);
    return names;
}

bool isSolutionName(const Path& path)
{
    const std::string stem = path.stem().string(), ending = fileEnding(path);
    return ending == ".q" || ending == ".qsol" || ending == ".sol" || stem.ends_with('q') || stem.ends_with('Q');
}

Path firstExisting(const std::vector<Path>& names)
{
    for (const Path& name : names) {
        std::error_code problem;
        if (std::filesystem::is_regular_file(name, problem))
            return name;
    }
    return {};
}

} // namespace tetra
