// SPDX-License-Identifier: GPL-3.0-or-later
// What VTK's reader would do with the files of a case and nobody may ask of it: wait at a pipe for somebody who writes,
// read a device without end, or read, by #include, what lies elsewhere. It opens all files in the folders of its times
// and meshes.
#include "plugins/readers/vtk/checks/format_checks.h"

#include <zlib.h>

#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view blanksInFoam = " \t\r\n";
constexpr std::size_t mostLooked = std::size_t(2) << 20; ///< in front and at the end, where files have words
constexpr std::size_t longestName = 4096;

class FoamCheck {
public:
    explicit FoamCheck(fs::path folder) : folder_(std::move(folder)) {}

    Result<CheckedFile> run()
    {
        constexpr std::size_t most = 100'000;
        addCase(folder_);
        for (std::size_t at = 0; at < std::min(waiting_.size(), most); ++at)
            if (const Status fine = look(fs::path(waiting_[at])); !fine)
                return fine.error();
        return checked_;
    }

private:
    /// The folders of times, and of meshes: of the case itself, of its regions and of its processors. What else lies in
    /// a case, such as its controls, VTK does not open.
    void addCase(const fs::path& folder)
    {
        std::error_code ignored;
        for (const fs::path& path : pathsIn(folder, ignored)) {
            const std::string name = path.filename().string();
            if (parseNumber<double>(name))
                waiting_.push_back(path);
            else if (folder == folder_ && name.starts_with("processor"))
                addCase(path);
        }
        waiting_.push_back(folder / "constant/polyMesh");
        for (const fs::path& region : pathsIn(folder / "constant", ignored))
            waiting_.push_back(region / "polyMesh");
    }

    Status look(const fs::path& path)
    {
        std::error_code ignored;
        const fs::file_status status = fs::status(path, ignored); // of what a link leads to
        if (fs::is_directory(status)) {
            if (looked_.insert(fs::canonical(path, ignored)).second) // links may go round
                for (fs::path& inner : pathsIn(path, ignored))
                    waiting_.push_back(std::move(inner));
            return {};
        }
        if (!fs::exists(status))
            return {};
        const auto file = MappedFile::open(path);
        if (!file) // what may not be read, VTK passes over; at what is no regular file it waits
            return fs::is_regular_file(status) ? Status() : file.error();
        checked_.bytes = boundedSum(checked_.bytes, (*file)->bytes().size());
        const std::string_view text(reinterpret_cast<const char*>((*file)->bytes().data()), (*file)->bytes().size());
        if (path.extension() == ".gz")
            return lookForIncludes(path, unpackedFront(path));
        if (text.size() <= 2 * mostLooked)
            return lookForIncludes(path, text);
        const Status front = lookForIncludes(path, text.substr(0, mostLooked));
        return front ? lookForIncludes(path, text.substr(text.size() - mostLooked)) : front;
    }

    static std::string unpackedFront(const fs::path& path)
    {
        const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(path.c_str(), "rb"), gzclose);
        std::string text(mostLooked, '\0');
        const int got = file != nullptr ? gzread(file.get(), text.data(), static_cast<unsigned>(text.size())) : 0;
        text.resize(static_cast<std::size_t>(std::max(got, 0)));
        return text;
    }

    Status lookForIncludes(const fs::path& path, std::string_view text)
    {
        constexpr std::string_view word = "include";
        for (auto at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
            const std::string_view before = text.substr(0, at);
            const bool isDirective = before.ends_with('#') || before.ends_with("#s");
            const auto line = before.substr(before.find_last_of("\r\n") + 1);
            const bool isComment =
                line.find("//") != std::string_view::npos && line.find('"') == std::string_view::npos;
            if (!isDirective || isComment)
                continue;
            // The rest of the directive, as in #includeIfPresent, and the name.
            std::string_view rest = text.substr(std::min(text.find_first_of(" \t\r\n\"/", at), text.size()));
            rest.remove_prefix(std::min(rest.find_first_not_of(blanksInFoam), rest.size()));
            const bool isQuoted = rest.starts_with('"');
            rest.remove_prefix(isQuoted ? 1 : 0);
            const auto end = isQuoted ? rest.find('"') : rest.find_first_of(" \t\r\n;");
            if (const Status fine = checkIncluded(path, std::string(rest.substr(0, std::min(end, longestName)))); !fine)
                return fine;
        }
        return {};
    }

    static Error outside(const std::string& name)
    {
        return {ErrorKind::BadInput, Message::say("it refers to the file '%1', which is not in its folder or below it. "
                                                  "Put it there, and correct its name.",
                                                  printable(name))};
    }

    /// VTK puts the values of variables of the environment and the user's folder into names.
    Status checkIncluded(const fs::path& path, std::string name)
    {
        constexpr std::string_view ofCase = "$FOAM_CASE/";
        fs::path from = path.parent_path();
        if (name.starts_with(ofCase)) {
            name.erase(0, ofCase.size());
            from = folder_;
        }
        if (name.empty())
            return {};
        if (name.find_first_of("$~") != std::string::npos) // who knows where that is
            return outside(name);
        const auto file = fileBelow(folder_, from, name);
        if (!file)
            return file.error();
        std::error_code ignored;
        if (const auto status = fs::status(*file, ignored); fs::exists(status) && !fs::is_regular_file(status))
            return MappedFile::open(*file).error();
        return {};
    }

    fs::path folder_;
    std::vector<fs::path> waiting_;
    std::set<fs::path> looked_;
    CheckedFile checked_;
};

} // namespace

Result<CheckedFile> checkFoam(const fs::path& opened)
{
    const bool isControl = opened.filename() == "controlDict";
    return FoamCheck(isControl ? opened.parent_path().parent_path() : opened.parent_path()).run();
}

} // namespace tetra
