// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/arguments.h"
#include "core/packed/packed_mesh.h"
#include "plugins/api/written_content.h"

#include <tan/base.h>

#include <QJsonObject>

#include <string>

namespace tetra {

/// A mesh that `tan serve` found, and what it tells of it.
struct ServerMesh {
    UnpackedMesh content;
    QJsonObject figures; ///< as figuresOf() gives them
    MeshFacts facts;     ///< as meshFacts()
    bool overlaps = false;

    /// The name of the model's dataset, one of the facts.
    std::string source() const;
};

/// The address of a mesh: of the model, http://HOST/NAME.tan, with those of the arguments that are queryOptions() as
/// the query.
std::string meshAddress(const std::string& model, const Arguments& arguments);

/// Asks a server for a mesh and takes it apart. Errors: those of fetchOnce(), what the server says in place of a mesh,
/// and BadInput for an answer that is none.
Result<ServerMesh> meshAtServer(const std::string& address, const std::string& token, const Progress& progress = {});

/// A token: the first line of a file, of visible characters. Errors: WrongUsage.
Result<std::string> tokenIn(const std::string& file);

} // namespace tetra
