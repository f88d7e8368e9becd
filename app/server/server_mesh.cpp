// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/server/server_mesh.h"

#include "app/command_line/query_options.h"
#include "core/base/mapped_file.h"
#include "core/remote/fetch.h"
#include "core/remote/percent_encoding.h"
#include "core/remote/remote_file.h"

#include <QJsonArray>
#include <QJsonDocument>

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

constexpr std::size_t leastTokenSize = 16, mostTokenSize = 1024;

QJsonObject jsonOf(std::string_view text)
{
    return QJsonDocument::fromJson(QByteArray(text.data(), static_cast<qsizetype>(text.size()))).object();
}

bool isFinite(const TetrahedralMesh& mesh)
{
    return std::ranges::all_of(mesh.positions, [](const auto& place) { return place.allFinite(); }) &&
           std::ranges::all_of(mesh.values, [](float value) { return std::isfinite(value); });
}

/// What a server that sends no mesh says.
Error saidInstead(const std::string& address, const FetchedAnswer& answer)
{
    const std::string_view text(reinterpret_cast<const char*>(answer.content.data()), answer.content.size());
    const std::string said = jsonOf(text)["error"].toString().left(1000).toStdString();
    const ErrorKind kind = answer.status == 400 ? ErrorKind::WrongUsage
                           : answer.status == 413 || answer.status == 429 || answer.status >= 503
                               ? ErrorKind::OutOfResource
                               : ErrorKind::BadInput;
    if (answer.status == 200 || said.empty())
        return {
            ErrorKind::BadInput,
            Message::say("'%1' sends no mesh (status %2). Only 'tan serve' finds meshes; a model on any other server "
                         "is read without '--at-server'.",
                         shownAddress(address), answer.status)};
    constexpr int unauthorized = 401;
    if (answer.status == unauthorized)
        return {ErrorKind::WrongUsage,
                Message::say("The server of '%1' answers only those who have its token. Give the one that whoever runs "
                             "it has set; on the command line by '--token-file'.",
                             shownAddress(address))};
    return {kind, Message::say("The server of '%1' says: %2", shownAddress(address), said)};
}

} // namespace

std::string ServerMesh::source() const
{
    const auto found = std::ranges::find(facts, "source", &MeshFacts::value_type::first);
    return found == facts.end() ? "" : factText(found->second);
}

std::string meshAddress(const std::string& model, const Arguments& arguments)
{
    std::string address = model + "?";
    for (const Option& option : queryOptions())
        for (const std::string& value : arguments.values(option.name)) {
            if (!address.ends_with('?'))
                address += '&';
            address += option.name + "=" + percentEncoded(value);
        }
    return address;
}

Result<ServerMesh> meshAtServer(const std::string& address, const std::string& token, const Progress& progress)
{
    constexpr double fetchedAt = 0.7;
    const auto answer = fetchOnce(address, token, limitsOfMesh(packedMeshType), progress.part(0, fetchedAt));
    if (!answer)
        return answer.error();
    if (answer->status != 200 || answer->contentType != packedMeshType)
        return saidInstead(address, *answer);
    auto unpacked = unpackMesh(answer->content, std::uint64_t(1) << 30, progress.part(fetchedAt, 1));
    if (!unpacked)
        return unpacked.error();
    if (unpacked->mesh.tetrahedra.empty() || !isFinite(unpacked->mesh))
        return Error{ErrorKind::BadInput,
                     Message::say("'%1' sends a mesh without tetrahedra, or with numbers that are not finite. Nothing "
                                  "was written.",
                                  shownAddress(address))};
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
