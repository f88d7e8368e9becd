// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/parameter.h"

#include <tan/base.h>
#include <tan/data.h>

#include <optional>
#include <span>

namespace tetra {

/// An array of a file that could be the scalar of a dataset.
struct FileArray {
    std::string name;
    int components = 1; ///< above 1: one of them or the magnitude is taken
    bool perCell = false;
    std::optional<ValueRange> range{}; ///< if it is known without reading the array
    std::string unit{};                ///< of its values, as the file says
};

/// What a file holds, as far as that is known without loading it. Empty lists: nothing to choose.
struct FileContents {
    std::optional<DomainClass> domain{};
    Lattice lattice{};                ///< of grids its size, of a regular lattice also spacing and origin
    std::uint64_t points = 0;         ///< 0: not known beforehand
    std::uint64_t cells = 0;          ///< of irregular meshes; 0: not known beforehand
    std::optional<SampleType> type{}; ///< of the samples that would be read
    std::vector<FileArray> arrays{};
    std::vector<double> timeSteps{};
    std::vector<std::string> blocks{};
    std::vector<std::string> series{};   ///< of pictures that lie in one folder
    std::vector<std::string> channels{}; ///< of a picture that has several
    std::vector<Taken> taken{};          ///< what read() would take by the same values, as far as it shows
    std::vector<Message> leftOut{};      ///< what the file says and read() would not use
    /// Of the reader's parameters those for what other files tell and this one does not: "spacing", "unit".
    std::vector<std::string> untold{};
    /// Values of the reader's parameters that would fit a file that does not say how it is to be read, the likeliest
    /// first.
    std::vector<ParameterValues> suggestions{};
};

/// Reads files of some formats into datasets. Never crashes on bad input: every refusal is an Error that says what is
/// wrong in the file and what to do, "it is empty. Copy it again."; the program adds which file that is, unless the
/// error says that its text names a file (Error::file), which may be another one. Runs on a worker thread; safe to call
/// from any.
class Reader {
public:
    virtual ~Reader() = default;
    /// Name filters for the open dialog: {"NRRD volume (*.nrrd *.nhdr)", ...}.
    virtual std::vector<std::string> nameFilters() const = 0;
    /// 0 cannot, 1 certain; from the name and the first bytes (up to 4096) of the file.
    virtual double score(const std::filesystem::path& path, std::span<const std::byte> firstBytes) const = 0;
    /// What must be known besides the file (a raw file's size and sample type).
    virtual std::vector<Parameter> parameters() const = 0;
    /// What Source leaves empty, the name, the path or the hash, the program fills in. Source::taken names every choice
    /// among what the file offers, with what the file does not say as a guess, and Source::leftOut what it says and is
    /// not used: nothing is dropped without a word. A grid may have values that are
    /// not finite and cells that are blanked out (Dataset::cells): the program makes holes of them, withHoles().
    virtual Result<Dataset> read(const std::filesystem::path& path, const ParameterValues& values,
                                 const Progress& progress) const = 0;
    /// read() for somebody who takes only `region` of data that are no grid: what lies beyond has to be there, but need
    /// not be sound (CellComplex::region). For a reader of cells; others read all, as here.
    virtual Result<Dataset> readAround(const Eigen::AlignedBox3d& /*region*/, const std::filesystem::path& path,
                                       const ParameterValues& values, const Progress& progress) const
    {
        return read(path, values, progress);
    }
    /// The names that another file may have which read() opens beside `path`, the likeliest first, whether or not they
    /// exist: if the one that does is packed by gzip, the program unpacks it and gives read() both in another folder.
    virtual std::vector<std::filesystem::path> companions(const std::filesystem::path& /*path*/,
                                                          const ParameterValues& /*values*/) const
    {
        return {};
    }
    /// What there is to choose from, quickly: headers and names, not the samples. `values` as far as they are known
    /// (the layout of a raw file); its refusals are those of read() as far as they show.
    virtual Result<FileContents> probe(const std::filesystem::path& /*path*/, const ParameterValues& /*values*/,
                                       const Progress& /*progress*/) const
    {
        return FileContents{};
    }
};

} // namespace tetra
