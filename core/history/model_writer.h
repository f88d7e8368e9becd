// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/scratch_file.h"

#include <tan/base.h>
#include <tan/build.h>
#include <tan/data.h>
#include <tan/model.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

namespace tetra {

/// How much the arrays of a model hold.
struct ModelCounts {
    std::uint64_t sites = 0;
    std::uint64_t tetrahedra = 0; ///< all that ever lived
};

/// The bytes of the arrays that every model of a regular lattice has.
std::uint64_t arrayBytes(const ModelCounts& counts, SampleType type) noexcept;

/// Whether a model keeps all samples of its dataset of `points` points, with their positions of `positionBytes` each
/// (0: a regular lattice): if they take at most an eighth of the other arrays. A model of a few sites of a huge dataset
/// does not, nor one of scattered points (FORMAT.md).
bool keepsSamples(DomainClass domain, SampleType type, std::size_t positionBytes, std::uint64_t points,
                  const ModelCounts& counts) noexcept;

/// Hands the samples' bytes to `write`, a piece at a time: they may lie in a file larger than memory.
Status writeSamples(const ScalarField& samples, const std::function<Status(std::span<const std::byte>)>& write);

/// An array that only grows at its end and is read once, from its beginning: in a spool file but for its last chunk of
/// 16 Ki elements. Growing may throw std::bad_alloc; a file that cannot be written shows in the file's status() and in
/// forEachChunk().
template <class T> class SpooledArray {
    static_assert(std::is_trivially_copyable_v<T>);

public:
    /// `file` outlives the array; several arrays share it.
    explicit SpooledArray(SpoolFile& file) : file_(file) {}

    std::uint64_t size() const noexcept { return offsets_.size() * chunkSize + last_.size(); }

    void push_back(const T& element)
    {
        if (last_.size() == chunkSize)
            spool();
        last_.push_back(element);
    }

    /// Calls visit(std::span<const T>), which gives a Status, for all elements in order; ends with its first error.
    template <class Visit> Status forEachChunk(Visit&& visit) const
    {
        if (!file_.status())
            return file_.status();
        std::vector<T> chunk(offsets_.empty() ? 0 : chunkSize);
        for (const std::uint64_t offset : offsets_) {
            if (const Status read = file_.read(offset, std::as_writable_bytes(std::span(chunk))); !read)
                return read;
            if (const Status visited = visit(std::span<const T>(chunk)); !visited)
                return visited;
        }
        return visit(std::span<const T>(last_));
    }

private:
    static constexpr std::size_t chunkSize = std::size_t(1) << 14;

    void spool()
    {
        if (const Result<std::uint64_t> offset = file_.append(std::as_bytes(std::span(last_))))
            offsets_.push_back(*offset);
        last_.clear();
    }

    SpoolFile& file_;
    std::vector<std::uint64_t> offsets_;
    std::vector<T> last_;
};

/// The bytes of a position in a model of the dataset: none for a regular lattice, floats if they hold each coordinate
/// exactly, else doubles.
std::size_t positionBytes(const Dataset& dataset);

/// Writes a history into a `.tan` file while it is made. Nothing appears under `path` before finish() has succeeded:
/// the file is written beside it, synced and renamed; destroying an unfinished writer removes what it wrote. Steps
/// are put together into batches and groups on the way (FORMAT.md). Memory: about 8 bytes a tetrahedron and 4 a site,
/// and one batch whole; all else waits on the disk.
class TAN_INTERNAL ModelWriter : public HistorySink {
public:
    /// `description` needs builder and parameters; the rest is taken from `dataset`. The unfinished file lies in
    /// `workFolder`, on the same disk; without one beside `path`.
    static Result<std::unique_ptr<ModelWriter>> create(const std::filesystem::path& path, const Dataset& dataset,
                                                       ModelDescription description,
                                                       const std::filesystem::path& workFolder = {});
    /// In place of finish(), at any time: completes the file with the sites before the batch that is not complete yet,
    /// a mesh of known error. Error: no batch is complete.
    virtual Status finishEarly() = 0;
    /// Handed over so far.
    virtual std::uint32_t siteCount() const noexcept = 0;
    /// In the file so far, without those of the batch that is not complete yet.
    virtual std::uint64_t tetrahedronCount() const noexcept = 0;
};

} // namespace tetra
