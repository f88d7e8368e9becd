// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/host/plugin_host.h"

#include <tan/base.h>
#include <tan/data.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace tetra {

/// What the writer of a file has to say of it, in sentences for the user (OutputFile::remark()).
using FileRemarks = std::vector<Message>;
/// Where a file goes.
struct Destination {
    std::filesystem::path path; ///< its name; of a stream what messages call it, with the ending of the format
    int stream = -1;            ///< an open descriptor that it goes into, and nowhere else; -1: none

    Destination(std::filesystem::path name, int descriptor = -1) // NOLINT(google-explicit-constructor): a name is one
        : path(std::move(name)), stream(descriptor)
    {
    }
};

/// Files of datasets, meshes and surfaces, by the writer plugin that writes such content under the ending of the file's
/// name. A file appears whole or not at all (what went into a stream stays there); the memory that writing needs does
/// not depend on what is written (but finding the boundary of a mesh takes some). `values` may hold that writer's
/// parameters and no others.
///
/// Errors: WrongUsage (no writer has the ending, and which endings there are; parameters or arrays that do not fit),
/// OutOfResource (more than the format can number), CannotWrite, Cancelled. Call from a worker thread; safe from any.
Result<FileRemarks> saveDataset(PluginHost& host, const Dataset& dataset, const std::filesystem::path& path,
                                const ParameterValues& values = {}, const Progress& progress = {});
/// In a format for surfaces alone, the boundary of the mesh with the vertices' first array of floats.
Result<FileRemarks> saveMesh(PluginHost& host, const MeshContent& mesh, const Destination& to,
                             const ParameterValues& values = {}, const Progress& progress = {});
Result<FileRemarks> saveSurface(PluginHost& host, const SurfaceContent& surface, const Destination& to,
                                const ParameterValues& values = {}, const Progress& progress = {});

/// Whether there is a writer for such a file, and the values are among its parameters: for asking before what is to be
/// written is made. The error is that of saving it.
Status checkWritable(PluginHost& host, WrittenContent content, const std::filesystem::path& path,
                     const ParameterValues& values = {});

/// Whether the ending is that of a format for surfaces alone, in which a mesh can only be given by its boundary.
bool isSurfaceFileOnly(PluginHost& host, const std::filesystem::path& path);

/// All kinds of files of this content, by name, each kind once. Of meshes without those for surfaces alone.
std::vector<FileFormat> writableFormats(PluginHost& host, WrittenContent content);
/// Their endings, sorted: ".nrrd", ".vtu" ...; of meshes with those that hold their boundary.
std::vector<std::string> writableEndings(PluginHost& host, WrittenContent content);
/// What the user may choose of writers of this content.
std::vector<Parameter> writerParameters(PluginHost& host, WrittenContent content);

} // namespace tetra
