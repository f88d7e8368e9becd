// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/server/server_mesh.h"

#include "app/command_line/query_options.h"
#include "core/remote/fetch.h"
#include "core/remote/percent_encoding.h"
#include "core/remote/remote_file.h"

#include <QJsonArray>
#include <QJsonDocument>

#include <algorithm>
#include <fstream>

namespace tetra {
namespace {

constexpr std::uint64_t mostMeshBytes = std::uint64_t(8) << 30;
constexpr std::size_t leastTokenSize = 16;

QJsonObject jsonOf(std::string_view text)
{
    return QJsonDocument::fromJson(QByteArray(text.data(), static_cast<qsizetype>(text.size()))).object();
}

/// What a server that sends no mesh says.
Error saidInstead(const std::string& address, const FetchedAnswer& answer)
{
    const std::string_view text(reinterpret_cast<const char*>(answer.content.data()), answer.content.size());
    const std::string said = jsonOf(text)["error"].toString().left(1000).toStdString();
    const ErrorKind kind = answer.status == 400                           ? ErrorKind::WrongUsage
                           : answer.status == 413 || answer.status >= 503 ? ErrorKind::OutOfResource
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
    const auto answer = fetchOnce(address, token, mostMeshBytes, progress.part(0, fetchedAt));
    if (!answer)
        return answer.error();
    if (answer->status != 200 || answer->contentType != packedMeshType)
        return saidInstead(address, *answer);
    auto unpacked = unpackMesh(answer->content, std::uint64_t(1) << 30, progress.part(fetchedAt, 1));
    if (!unpacked)
        return unpacked.error();
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
    std::ifstream stream(file);
    if (!stream)
        return Error{ErrorKind::WrongUsage,
                     Message::say("The token's file '%1' cannot be read. Check its name and permissions.", file)};
    std::string token;
    std::getline(stream, token);
    const bool isVisible = std::ranges::all_of(token, [](char c) { return c > ' ' && c < 0x7f; });
    if (stream.bad() || token.size() < leastTokenSize || !isVisible)
        return Error{ErrorKind::WrongUsage,
                     Message::say("'%1' holds no token: its first line has to be at least %2 letters, digits or signs "
                                  "without blanks, such as 'openssl rand -hex 24' writes.",
                                  file, leastTokenSize)};
    return token;
}

} // namespace tetra
