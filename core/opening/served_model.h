// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/history/whole_elsewhere.h"
#include "core/packed/packed_mesh.h"
#include "core/remote/fetch.h"

#include <tan/base.h>
#include <tan/model.h>
#include <tan/open.h>
#include <tan/query.h>

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace tetra {

/// What a server says of a model that it has.
struct ServerOffer {
    bool wantsToken = false;  ///< without one, or with this one, it says nothing more
    bool findsMeshes = false; ///< it is `tan serve`: the model can be left there
    ModelForm form = ModelForm::Explicit;
    std::uint64_t fileBytes = 0;
    std::uint64_t unpackedBytes = 0;
    std::uint32_t sites = 0;
};

/// Asks a server what it offers; `address` as isAddress(), either form. A server that is none of ours finds no meshes.
/// Errors: it cannot be reached, has no such model, or says what no model is; cancelled.
TAN_INTERNAL Result<ServerOffer> askServer(const std::string& address, const std::string& token,
                                           const Progress& progress = {});

/// Asks `tan serve` for the mesh that words of a URL ask for (QueryWords), and takes it apart. Errors: those of
/// fetchOnce(), what the server says in place of a mesh, and BadInput for an answer that is not one.
TAN_INTERNAL Result<UnpackedMesh> servedMesh(const std::string& address, const std::string& question,
                                             const std::string& token, const Progress& progress = {});

/// A model at `tan serve`, which finds its meshes; all questions go over one connection.
class TAN_INTERNAL ServedModel final : public WholeElsewhere {
public:
    /// Asks for its sizes, for which the server opens it. Errors: those of fetchOnce(); what the server says; BadInput
    /// for numbers that no model has.
    static Result<std::shared_ptr<const ServedModel>> ask(const std::string& address, const std::string& token,
                                                          const Progress& progress);

    /// Errors besides: BadInput if the model on the server is another one by now.
    Result<std::shared_ptr<const ExtractedMesh>> extract(const MeshQuery& query,
                                                         const Progress& progress) const override;

    /// As it was told.
    ServedModel(std::string address, std::string token, std::string tag, bool warps, WholeSizes sizes,
                std::unique_ptr<ServerConnection> connection);

private:
    std::string address_;
    std::string token_;
    std::string tag_; ///< of the file's state
    bool warps_;
    std::unique_ptr<ServerConnection> connection_;
};

/// Whether an error says that a server wants a token, or another one.
TAN_INTERNAL bool wantsToken(const Error& error);

} // namespace tetra
