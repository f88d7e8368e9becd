// SPDX-License-Identifier: GPL-3.0-or-later
// A session and its model are moved together, or one of them alone. The session's two names of the model find it where
// the model has stayed, and where both keep their places to each other. For all else the model is looked for by the end
// of its path, "m.tan", "data/m.tan" and so on, in the session's folder and in each one above that: a project that was
// moved as a whole has it there. What is found there by its name alone may be any model, so it has to be the same one.
#include "core/picture/session_model.h"

#include <tan/open.h>
#include <tan/packed.h>

#include <array>
#include <cstring>
#include <fstream>

namespace tetra {
namespace {

constexpr int mostFoldersUp = 8;
constexpr int mostNames = 4; ///< of the end of a path

/// Of a packed model it is not known before that is unpacked.
bool mayBe(const std::filesystem::path& model, std::uint64_t identity)
{
    std::error_code problem;
    if (!std::filesystem::is_regular_file(model, problem))
        return false;
    if (identity == 0 || isPacked(model))
        return true;
    std::array<char, headerChecksumOffset + sizeof identity> header{};
    std::ifstream file(model, std::ios::binary);
    std::uint64_t found = 0;
    if (!file.read(header.data(), header.size()))
        return false;
    std::memcpy(&found, header.data() + headerChecksumOffset, sizeof found);
    return found == identity;
}

/// The names that a path ends in, the shortest end first.
std::vector<std::filesystem::path> endsOf(const std::filesystem::path& path)
{
    std::vector<std::filesystem::path> ends;
    std::filesystem::path end;
    for (std::filesystem::path rest = path; rest.has_filename() && std::ssize(ends) < mostNames;
         rest = rest.parent_path()) {
        end = end.empty() ? rest.filename() : rest.filename() / end;
        ends.push_back(end);
    }
    return ends;
}

} // namespace

std::optional<std::filesystem::path> sessionModel(const SessionDocument& document, const std::filesystem::path& session)
{
    if (isAddress(document.model.string()))
        return document.model;
    // Both keep their places to each other more often than another model comes to an old place.
    std::vector<std::filesystem::path> told{document.model};
    if (!document.relativeModel.empty())
        told.insert(told.begin(), document.relativeModel);
    if (!document.absoluteModel.empty())
        told.push_back(document.absoluteModel);
    for (const std::filesystem::path& model : told)
        if (mayBe(model, document.identity))
            return model;
    std::error_code problem;
    std::filesystem::path folder = std::filesystem::absolute(session, problem).parent_path();
    const auto ends = endsOf(document.absoluteModel.empty() ? document.model : document.absoluteModel);
    for (int up = 0; up < mostFoldersUp; ++up, folder = folder.parent_path())
        for (const std::filesystem::path& end : ends)
            if (document.identity != 0 && mayBe(folder / end, document.identity))
                return folder / end;
    for (const std::filesystem::path& model : told)
        if (std::filesystem::is_regular_file(model, problem))
            return model; // built anew
    return std::nullopt;
}

} // namespace tetra
