// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/serve/http_server.h"
#include "core/serve/served_folder.h"

#include <tan/model.h>

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace tetra {

struct ModelServerLimits {
    std::uint64_t tetrahedra = 5'000'000;      ///< of a mesh, before window and values choose from it
    std::chrono::milliseconds time{60'000};    ///< for a mesh to be found and packed
    std::chrono::milliseconds waiting{30'000}; ///< for the meshes before it
    int meshes = 2;                            ///< that are worked on at once
    std::size_t models = 8;                    ///< that are kept open
    std::size_t listed = 10'000;
};

/// Whether an address or a name is that of this machine for itself.
bool isLoopback(std::string_view address);
/// Whether a text is the origin of a page as a browser names it: "https://viewer.example" or "http://localhost:3000".
bool isOrigin(std::string_view text);

/// Who is answered.
struct ServedTo {
    /// With a token every request must bring it (Authorization: Bearer ...); without one, the host that it asks for
    /// must be this machine: a page of the web that a browser shows could ask for the others under a name of its own.
    std::string token{};
    /// The origins whose pages may read what a browser is answered (CORS), each isOrigin().
    std::vector<std::string> origins{};
};

/// What `tan serve` answers (docs/user/command-line.md): `/` is a list of the folder's models, `/NAME.tan` a file or a
/// range of it, `/NAME.tan?error=1&...` a mesh of it, packed (core/packed/PACKED_MESH.md), `/NAME.tan?about` and
/// `/NAME.tan?sizes` what whoever leaves a model here wants to know of it. No answer says where the folder lies. From
/// any number of threads.
class ModelServer {
public:
    ModelServer(ServedFolder folder, ServedTo whom, ModelServerLimits limits);

    ServedAnswer answer(const ServedRequest& request);
    /// Whether an answer takes more than a few accesses to a disk.
    static bool takesLong(const ServedRequest& request);
    /// Both, as long as this exists.
    HttpServer::Handler handler();

private:
    struct OpenModel {
        std::string name;
        std::string tag;
        std::shared_ptr<const Model> model;
    };
    class Turn;

    ServedAnswer answerWhoMay(const ServedRequest& request);
    std::optional<ServedAnswer> refusalOf(const ServedRequest& request) const;
    bool isFromKnownOrigin(const ServedRequest& request) const;
    ServedAnswer list(const ServedRequest& request) const;
    ServedAnswer fileAnswer(const ServedRequest& request, const ServedFile& file) const;
    ServedAnswer aboutAnswer(const ServedRequest& request, const ServedFile& file) const;
    ServedAnswer sizesAnswer(const ServedRequest& request, const ServedFile& file);
    ServedAnswer inTurn(const ServedRequest& request, const ServedFile& file,
                        const std::function<Result<ServedAnswer>(const Progress& progress)>& work);
    ServedAnswer meshAnswer(const ServedRequest& request, const ServedFile& file, std::string_view query);
    Result<std::shared_ptr<const Model>> modelOf(const ServedFile& file, const Progress& progress);

    const ServedFolder folder_;
    const ServedTo whom_;
    const ModelServerLimits limits_;
    std::mutex mutex_; ///< of what follows
    std::condition_variable turnOver_;
    int working_ = 0;
    std::list<OpenModel> models_; ///< the last used one first
};

} // namespace tetra
