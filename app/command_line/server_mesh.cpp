// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/server_mesh.h"

#include "core/base/mapped_file.h"
#include "core/base/text.h"
#include "core/opening/served_model.h"
#include "core/remote/address.h"
#include "core/remote/remote_file.h"

#include <QJsonArray>
#include <QJsonDocument>

#include <algorithm>

namespace tetra {
namespace {

constexpr std::size_t leastTokenSize = 16, mostTokenSize = 1024;

QJsonObject jsonOf(std::string_view text)
{
    return QJsonDocument::fromJson(QByteArray(text.data(), static_cast<qsizetype>(text.size()))).object();
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
                                                       "Ask for a larger window or more values.",
                                                       shownAddress(model))};
    ServerMesh mesh;
    mesh.content = std::move(*unpacked);
    const QJsonObject told = jsonOf(mesh.content.facts);
    mesh.figures = told["figures"].toObject();
    mesh.overlaps = told["overlaps"].toBool();
    for (const QJsonValue entry : told["facts"].toArray()) {
        const QJsonArray fact = entry.toArray();
        const std::string name = printable(fact[0].toString().toStdString());
        if (fact[1].isDouble())
            mesh.facts.emplace_back(name, fact[1].toDouble());
        else if (fact[1].isString())
            mesh.facts.emplace_back(name, fact[1].toString().left(4096).toStdString());
    }
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
                     Message::say("'%1' does not hold a token: its first line has to be %2 to %3 letters, digits or "
                                  "signs without blanks, such as 'openssl rand -hex 24' writes.",
                                  file, leastTokenSize, mostTokenSize)};
    return token;
}

} // namespace tetra
