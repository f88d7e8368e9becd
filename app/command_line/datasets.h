// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/subcommand.h"
#include "plugins/api/reader.h"
#include "plugins/host/import_options.h"

#include <tan/data.h>
#include <tan/model.h>

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace tetra {

/// Adds --reader, --region, --stride, --scale and the parameters of all readers.
void addImportOptions(Syntax& syntax, PluginHost& host);

/// What these options say of how to open `path`; options of other readers are refused. With `model`, what they do not
/// say is as it was when that model was built, as far as it is the same reader's.
Result<ImportOptions> importOptions(const Invocation& invocation, const std::filesystem::path& path,
                                    const ModelDescription* model = nullptr);

/// What a dataset is, or the one that a model was built from.
struct DatasetSummary {
    DomainClass domain = DomainClass::RegularLattice;
    Lattice lattice;
    Eigen::AlignedBox3d bounds;
    SampleType type = SampleType::UInt8;
    ValueRange range;
    std::optional<std::uint64_t> cells{}; ///< of grids their cells, of irregular data the tetrahedra if they are known
    std::optional<bool> convex{};         ///< Dataset::convex, of a dataset that is a grid or a mesh
    std::string space{};                  ///< Dataset::space
    std::string lengthUnit{};             ///< Dataset::lengthUnit
};

DatasetSummary summaryOf(const Dataset& dataset);
DatasetSummary summaryOf(const Model& model);
/// Of a model of which no more is read: the tetrahedra of irregular data are not known.
DatasetSummary summaryOf(const ModelDescription& description);

/// "kind", "points", "range", "type" and "bounds"; "cells" if they are known; of grids also "size", of lattices
/// "spacing" and "origin" and, if it does not lie along x, y and z, the "directions" of its axes; "space" and
/// "unit" if the file says them; of other grids and meshes "convex".
JsonObject datasetFigures(const DatasetSummary& summary);
/// The same for people, a line.
std::string datasetText(const DatasetSummary& summary);

/// Faulty cells, "left out" or as who lists them says: "faulty_cells", the first ten thousand, "faulty_cell_count", and
/// a few lines of the text. Nothing if there are none.
void addFaultyCells(std::span<const FaultyCell> cells, std::string_view where, Outcome& outcome);
/// Those that were taken out of the mesh.
void addFaultyCells(const Dataset& dataset, Outcome& outcome);
/// Those that a model lists. Errors: a damaged file.
Status addFaultyCells(const Model& model, Outcome& outcome);
/// What was taken of a file and what it said and was not used: "taken", an object by takenPartName(), "guesses", those
/// of its names that the file does not confirm, "unused", sentences, and lines of the text; without them the objects
/// are empty and the text says nothing.
void addProvenance(std::span<const Taken> taken, std::span<const Message> leftOut, Outcome& outcome);
/// What a file offers: "arrays", "steps", "blocks", "series", "channels", and lines of the text where there is a
/// choice.
void addContents(const FileContents& contents, Outcome& outcome);
/// What reading the dataset changed: "remarks", and a line of the text each; and addFaultyCells().
void addRemarks(const Dataset& dataset, Outcome& outcome);

} // namespace tetra
