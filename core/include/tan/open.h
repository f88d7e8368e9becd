// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// tan/open.h: models in either form, as they are or packed (tan/packed.h), from this disk or a server.
///
/// Model::open() maps a `.tan` file of this disk, whole. What is packed or lies on a server is first unpacked or
/// fetched into a cache folder, as far as it is wanted: a model that keeps an accuracy is the beginning of the file,
/// and takes a small part of it. What is there from before is used again as long as the file is the same: a file of
/// this disk by device, inode, size and times, one on a server by the address and what the server says of its state
/// (ETag or Last-Modified). What has no such mark is kept for nobody. Where the cache folder cannot be used, what is
/// unpacked or fetched lies among the system's temporary files for as long as it is open.
///
/// ~~~{.cpp}
/// /// The mesh of an error, % of the value range, of a model that lies anywhere.
/// tetra::Result<tetra::TetrahedralMesh> meshFrom(const std::string& place, double error)
/// {
///     const tetra::Accuracy accuracy{.error = error, .warping = tetra::anyWarping};
///     const auto found = tetra::openModel(place, {.accuracy = accuracy});
///     if (!found)
///         return found.error();
///     return tetra::extractPrefix(*found->model, tetra::meshSizeAt(*found->model, accuracy).sites);
/// }
/// ~~~

#include <tan/base.h>
#include <tan/model.h>
#include <tan/query.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// Whether this is the address of a file on a server: it begins with http:// or https://, or with tan+ before these,
/// which leaves the model there.
TAN_API bool isAddress(std::string_view place) noexcept;

/// Whether a place is the address of a model that is left at its server (R28; the paper's 5.1): tan+http:// or
/// tan+https://. openModel() then gives a model of which only the beginning is here: `tan serve`, which has it, is
/// asked for each mesh that a MeshExtractor extracts, and sends it packed. All else that takes a place reads the file.
TAN_API bool isLeftAtServer(std::string_view place) noexcept;

/// The address of the same model that is left at its server, or with false fetched from there; a path stays what it is.
TAN_API std::string placeOf(std::string_view place, bool leftAtServer);

enum class ModelForm { Explicit, Packed };

/// A mesh that the beginning of a model's file makes.
struct LevelInFile {
    double error = 0;        ///< bound, % of the value range
    double warping = 0;      ///< bound, % of the diagonal; 0 where there is none
    std::uint32_t sites = 0; ///< of the mesh
    std::uint64_t bytes = 0; ///< of the file that are read for it
};

/// What the front of a model's file tells.
struct ModelFacts {
    ModelForm form = ModelForm::Explicit;
    std::uint64_t fileBytes = 0;
    std::uint64_t unpackedBytes = 0; ///< of an explicit file the same
    ModelDescription description;
    std::uint32_t sites = 0;
    std::uint64_t tetrahedra = 0;    ///< of the history
    std::vector<LevelInFile> levels; ///< coarse first, the last one the whole; explicit files older than 1.3: only that
};

/// Reads as little as it takes: of a server one or two requests. `place`: a path or an address. Errors: no file, no
/// model, damaged, made by a later version; the server's; cancelled. `token`: as OpenOptions has it.
TAN_API Result<ModelFacts> modelFacts(const std::string& place, const Progress& progress = {},
                                      const std::string& token = {});

/// A model that was found, or its beginning.
struct FoundModel {
    std::shared_ptr<const Model> model; ///< path() is the place that was asked for
    bool isWhole = true;
    std::uint32_t sitesOfWhole = 0;
    std::uint64_t readBytes = 0; ///< of the file, for this much of the model
    std::uint64_t fileBytes = 0;
};

struct OpenOptions {
    /// If given, reads only as much as this accuracy needs from a packed model or one on a server; an ordinary model
    /// file on this disk is always opened whole.
    std::optional<Accuracy> accuracy{};
    /// The most bytes to read from a file on a server; its coarsest mesh is read even if that takes more.
    std::uint64_t mostBytes = std::numeric_limits<std::uint64_t>::max();
    /// The cache: a folder of its own, created if it does not exist; by default $XDG_CACHE_HOME/tan. `cacheBytes`
    /// limits the size of its files; by default $TAN_CACHE_MB megabytes, or else 8 GiB.
    std::filesystem::path cacheFolder{};
    std::uint64_t cacheBytes = 0;
    /// Reads the named file itself, neither from the cache nor into it: for statements about the file, such as a proof,
    /// or for a copy.
    bool afresh = false;
    /// For a server that requires a token: sent to the server of the address, and to no other. It is written nowhere; a
    /// model that is left at its server keeps it in memory.
    std::string token{};
    /// Called with each coarser mesh on the way, the first one as soon as possible, each several times as large as the
    /// one before. Called by the thread that opens the model, which waits until it returns.
    std::function<void(const FoundModel&)> grown{};
};

/// Opens a model of this disk or a server, in either form. A damaged or changed file gives no mesh that is not its own:
/// what is read is checked by its checksums. From any number of threads and programs with one cache folder; call it
/// from a worker thread. Errors: as modelFacts(); no room in the cache folder, not enough memory, cancelled.
TAN_API Result<FoundModel> openModel(const std::string& place, const OpenOptions& options = {},
                                     const Progress& progress = {});

/// What a copy holds.
struct CopyReport {
    std::uint32_t sites = 0;
    std::uint32_t sitesOfWhole = 0;
    std::uint64_t tetrahedra = 0; ///< of its history
    std::uint64_t fileBytes = 0;
    /// The sections (FORMAT.md) of an unpacked model that another version derived anew; empty if it is byte for byte
    /// the one that was packed.
    std::vector<std::string> derived;
};

/// Writes a model that lies anywhere, in either form, as an explicit file of this disk: all of it, or its beginning
/// that keeps an accuracy. `output` appears whole or not at all, and replaces a model that was there. Errors: as
/// openModel(); the output is another file, or cannot be written. `token`: as OpenOptions has it.
TAN_API Result<CopyReport> copyModel(const std::string& place, const std::optional<Accuracy>& accuracy,
                                     const std::filesystem::path& output, const Progress& progress = {},
                                     const std::string& token = {});

} // namespace tetra
