// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/output_file.h"
#include "plugins/api/parameter.h"
#include "plugins/api/written_content.h"

#include <tan/base.h>
#include <tan/data.h>

#include <string>
#include <vector>

namespace tetra {

/// What a file is made of.
enum class WrittenContent {
    Dataset, ///< samples and where they are: 'tan sample'
    Mesh,    ///< tetrahedra of a model: 'tan extract', File > Save Mesh
    Surface, ///< triangles: 'tan isosurface', File > Save Surfaces; and the boundary of a mesh
};

/// A kind of file, and what a writer makes such files of.
struct FileFormat {
    WrittenContent content = WrittenContent::Surface;
    std::string name{};                 ///< for people: "PLY files"
    std::vector<std::string> endings{}; ///< in small letters with the dot: {".ply"}; the first is the usual one
};

/// Writes files of some formats. Which writer is asked follows from the content and the file name's ending; of several
/// the one that is found first (by the id). A mesh whose ending stands for surfaces alone is written by its boundary.
/// A failure is an Error that names the file (OutputFile::target()), what is wrong and what to do. Runs on a worker
/// thread; safe to call from any.
class Writer {
public:
    virtual ~Writer() = default;
    /// All kinds of files that it writes.
    virtual std::vector<FileFormat> formats() const = 0;
    /// What the user may choose, the same for all its formats.
    virtual std::vector<Parameter> parameters() const { return {}; }

    /// Those of the three that formats() speaks of. What is given is consistent: each array has its length, each number
    /// of a vertex a vertex.
    virtual Status writeDataset(const Dataset& /*dataset*/, OutputFile& file, const ParameterValues& /*values*/) const
    {
        return writesNone(file);
    }
    virtual Status writeMesh(const MeshContent& /*mesh*/, OutputFile& file, const ParameterValues& /*values*/) const
    {
        return writesNone(file);
    }
    virtual Status writeSurface(const SurfaceContent& /*surface*/, OutputFile& file,
                                const ParameterValues& /*values*/) const
    {
        return writesNone(file);
    }

private:
    static Status writesNone(const OutputFile& file)
    {
        return Error{
            ErrorKind::WrongUsage,
            Message::say("The plugin that writes '%1' announces something that it cannot write. Tell its author.",
                         file.target().string())};
    }
};

} // namespace tetra
