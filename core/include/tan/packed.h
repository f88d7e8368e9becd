// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// tan/packed.h: models packed for archives and for the way over a network, in files of their own (FORMAT.md, "Packed
/// form").
///
/// A packed model takes 1 to 4 bytes a site in place of 300 if its history follows from its samples or sites, else 12
/// to 50, the most where positions and values are doubles of which all bits tell something; and gives the model back
/// byte for byte. It is made to be read from its front: it has *levels*, each a conforming mesh of a stated error, the
/// coarse ones first, and whoever has the file's first PackedLevel::bytes can make that mesh.
///
/// ~~~{.cpp}
/// /// Packs a model, and says what it takes of the room.
/// tetra::Result<std::string> packed(const std::filesystem::path& model, const std::filesystem::path& output)
/// {
///     const auto opened = tetra::Model::open(model);
///     if (!opened)
///         return opened.error();
///     const auto report = tetra::packModel(**opened, output);
///     if (!report)
///         return report.error();
///     return std::to_string(report->fileBytes) + " bytes in place of " + std::to_string((*opened)->fileSize());
/// }
///
/// /// The coarsest mesh of a packed model that keeps an error, % of the value range, as a model of its own.
/// tetra::Status preview(const std::filesystem::path& packed, double error, const std::filesystem::path& output)
/// {
///     const auto opened = tetra::PackedModel::open(packed);
///     if (!opened)
///         return opened.error();
///     std::size_t level = 0;
///     while (level + 1 < (*opened)->levels().size() && (*opened)->levels()[level].error > error)
///         ++level;
///     return tetra::unpackPrefix(**opened, level, output);
/// }
/// ~~~

#include <tan/base.h>
#include <tan/model.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace tetra {

struct ByteSource;
class PackedFile;

/// How a model is packed.
enum class PackMethod : std::uint32_t {
    /// Of lattices by refinement, whose samples are known: the samples, in the order in which they became sites.
    /// Unpacking builds the model again from them, and proves by its checksums that it is the same.
    Replayed = 1,
    /// Of all others. Where refining with the sites alone makes the same history again (lattices and curvilinear grids
    /// as a whole, without weights and by the normalised selection), the sites and what they do not tell of the own
    /// errors; else each array of the file by itself.
    StoredByParts = 2
};

/// A mesh that the beginning of a packed file makes. Its bounds are claimed by the model (StoredByParts), or measured
/// (Replayed): without weights then, which are at most 1, so that the weighted error is no larger.
struct PackedLevel {
    double error = 0;        ///< bound, % of the value range
    double warping = 0;      ///< bound, % of the diagonal; 0 where there is none
    std::uint32_t sites = 0; ///< of the mesh
    std::uint64_t bytes = 0; ///< of the file, from its first one on
};

/// An opened packed model. Immutable, from any thread; what reads it further takes the file's bytes when it needs them.
class TAN_API PackedModel {
public:
    /// Reads the front: header, text and levels. Errors: no file, no packed model, damaged, made by a later version.
    static Result<std::shared_ptr<const PackedModel>> open(const std::filesystem::path& path);
    /// Likewise of a file that lies elsewhere; `name` is what messages call it. Errors: the source's, too.
    TAN_INTERNAL static Result<std::shared_ptr<const PackedModel>>
    open(ByteSource source, const std::filesystem::path& name, const Progress& progress = {});
    ~PackedModel();
    PackedModel(const PackedModel&) = delete;
    PackedModel& operator=(const PackedModel&) = delete;

    /// What messages call it.
    const std::filesystem::path& path() const noexcept;
    std::uint64_t fileSize() const noexcept;
    PackMethod method() const noexcept;
    // Of the model that was packed.
    const ModelDescription& description() const noexcept;
    std::uint32_t siteCount() const noexcept;
    std::uint64_t tetrahedronCount() const noexcept;
    std::uint64_t unpackedBytes() const noexcept; ///< of its file
    /// At least one. Sites rise, bytes do not fall, errors do not rise. The last one of a StoredByParts model is the
    /// model itself. Those of a Replayed one are meshes of about as many points for an error, but other ones; the last
    /// is fine enough that the rest of the samples takes few bits: half of the least difference of integers, a
    /// ten-thousandth of the range, or the error at which the model was stopped.
    std::span<const PackedLevel> levels() const noexcept { return levels_; }

    /// For those who unpack it.
    const PackedFile& file() const noexcept { return *file_; }

private:
    explicit PackedModel(std::unique_ptr<const PackedFile> file);

    std::unique_ptr<const PackedFile> file_;
    std::vector<PackedLevel> levels_;
};

/// Whether a file is a packed model, whole or damaged. Reads its first 16 KiB at most; false if it cannot be read.
TAN_API bool isPacked(const std::filesystem::path& path);

/// What a packed file holds, in bytes.
struct PackReport {
    PackMethod method = PackMethod::Replayed;
    std::uint64_t fileBytes = 0;
    std::uint64_t positions = 0; ///< which points the sites are, and of grids where they lie
    std::uint64_t values = 0;    ///< the sites' samples
    std::uint64_t accuracy = 0;  ///< running keys, stated errors
    std::uint64_t ownErrors = 0; ///< of tetrahedra, with own warpings
    std::uint64_t other = 0;     ///< everything else, samples that are no sites included
};

/// Packs a model into `output`, atomically; a model or packed model that was there is replaced at the end, any other
/// file is not (WrongUsage). Takes about three times as long as building the model took, and of memory 600 bytes a site
/// of a lattice of one block; of one in blocks, those of as many regions of some 64^3 points as there are threads.
/// While it works it needs room for the unpacked model beside `output`. Errors: a damaged model, no room, not enough
/// memory, cancelled. Uses all threads for models in blocks; call it from a worker thread.
TAN_API Result<PackReport> packModel(const Model& model, const std::filesystem::path& output,
                                     const Progress& progress = {});

struct UnpackReport {
    /// The sections (FORMAT.md) that are not byte for byte what they were, because another version of the builder
    /// derived them anew; empty if the file is the one that was packed.
    std::vector<std::string> derived;
};

/// Makes the model again at `output`, treated as by packModel(), in somewhat more time and memory than building it
/// takes. Errors: damaged bytes, no room, not enough memory, the source's, cancelled.
TAN_API Result<UnpackReport> unpackModel(const PackedModel& packed, const std::filesystem::path& output,
                                         const Progress& progress = {});

/// Makes a model of its own, at `output`, out of the file's beginning: levels()[0] to levels()[level] are its meshes.
/// It has the description of the whole model, and no samples but its sites'. Nothing behind that level is read. Errors:
/// WrongUsage, there is no such level; as unpackModel().
TAN_API Status unpackPrefix(const PackedModel& packed, std::size_t level, const std::filesystem::path& output,
                            const Progress& progress = {});

} // namespace tetra
