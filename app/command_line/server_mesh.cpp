// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/server_mesh.h"

#include "core/base/mapped_file.h"
#include "core/base/text.h"
#include "core/opening/served_model.h"
#include "core/remote/address.h"
#include "core/remote/remote_file.h"

#include <algorithm>

namespace tetra {
namespace {

constexpr std::size_t leastTokenSize = 16, mostTokenSize = 1024;

constexpr std::size_t mostFactBytes = 4096;

/// As much of the front of a text (UTF-8) as a fact takes, without half of a character at its end.
std::string frontOf(const std::string& text)
{
    std::size_t end = std::min(text.size(), mostFactBytes);
    while (end > 0 && end < text.size() && (static_cast<unsigned char>(text[end]) & 0xc0U) == 0x80)
        --end;
    return text.substr(0, end);
}

/// A name and its number or text, as one entry of "facts"; nothing where it is another thing.
void addFact(const JsonValue& entry, MeshFacts& facts)
{
    const JsonArray* const pair = entry.array();
    if (pair == nullptr || pair->size() < 2 || (*pair)[0].string() == nullptr)
        return;
    const std::string name = printable(*(*pair)[0].string());
    if (const auto number = (*pair)[1].numberAs<double>())
        facts.emplace_back(name, *number);
    else if (const std::string* const text = (*pair)[1].string())
        facts.emplace_back(name, frontOf(*text));
}

} // namespace

std::string ServerMesh::fact(std::string_view name) const
{
    const auto found = std::ranges::find(facts, name, &MeshFacts::value_type::first);
    return found == facts.end() ? "" : factText(found->second);
}

Result<ServerMesh> meshAtServer(const std::string& model, const QueryWords& words, const std::string& token,
                                const Progress& progress)
{
    auto unpacked = servedMesh(model, words.toUrl(), token, progress);
    if (!unpacked)
        return unpacked.error();
    if (unpacked->mesh.tetrahedra.empty())
        return Error{ErrorKind::BadInput, Message::say("'%1' sends a mesh without tetrahedra, so nothing was written. "
                                                       "Choose a larger crop box or more values.",
                                                       shownAddress(model))};
    ServerMesh mesh;
    mesh.content = std::move(*unpacked);
    const auto parsed = parseJson(mesh.content.facts);
    const JsonValue told = parsed ? *parsed : JsonValue();
    if (const JsonValue* const figures = told.find("figures"); figures != nullptr && figures->object() != nullptr)
        mesh.figures = *figures->object();
    const JsonValue* const overlaps = told.find("overlaps");
    const bool* const doOverlap = overlaps != nullptr ? std::get_if<bool>(&overlaps->content) : nullptr;
    mesh.overlaps = doOverlap != nullptr && *doOverlap;
    if (const JsonValue* const facts = told.find("facts"); facts != nullptr && facts->array() != nullptr)
        for (const JsonValue& entry : *facts->array())
            addFact(entry, mesh.facts);
    return mesh;
}

Result<std::string> tokenIn(const std::string& file)
{
    constexpr std::size_t mostBytes = 64 << 10;
    const auto text = wholeText(file, mostBytes);
    if (!text)
        return Error{ErrorKind::WrongUsage, Message::say("The token's file cannot be read. %1", text.error().message)};
    std::string token = text->substr(0, text->find('\n'));
    if (token.ends_with('\r')) // written by an editor of another system
        token.pop_back();
    const bool isVisible = std::ranges::all_of(token, [](char c) { return c > ' ' && c < 0x7f; });
    if (token.size() < leastTokenSize || token.size() > mostTokenSize || !isVisible)
        return Error{ErrorKind::WrongUsage,
                     Message::say("'%1' does not hold a token: its first line must be %2 to %3 letters, digits or "
                                  "signs without spaces, such as 'openssl rand -hex 24' writes.",
                                  file, leastTokenSize, mostTokenSize)};
    return token;
}

} // namespace tetra
