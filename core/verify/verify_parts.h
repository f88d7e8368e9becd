// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/verify/cell_check.h"

#include <tan/base.h>
#include <tan/data.h>
#include <tan/model.h>
#include <tan/verify.h>

#include <string>
#include <vector>

namespace tetra {

/// The parts of verify(). Each appends to `failures` what it found, and gives an Error only if it was cancelled.

/// Checksums, padding, reserved fields: every byte of the file has the value that it was written with.
Status verifyBytes(const Model& model, std::vector<std::string>& failures, const Progress& progress);

/// The sites of the first mesh: the leading ones of infinite running key.
std::uint32_t initialSiteCount(const Model& model);

/// The dataset as the model has it: itself; the points of a grid or an irregular mesh in a model of points; the
/// Delaunay mesh of points in a model of an irregular mesh (FORMAT.md); a lattice where writePlaced() put it, if the
/// mesh was made with its spacing. An Error only if cancelled.
Result<Dataset> takenByModel(const Model& model, const Dataset& dataset, const Progress& progress);

/// That the model is one of this dataset: lattice, type, range, hash. `taken` is what takenByModel() gave. False if not
/// even the lattice or the type fit, so that nothing can be compared.
bool verifySource(const Model& model, const Dataset& dataset, const Dataset& taken, std::vector<std::string>& failures);

/// That the domain of a dataset that the model takes as points is their convex hull: a rectilinear grid, or a mesh
/// whose boundary has all initial sites on its inner side. For sites that are points of the dataset.
void verifyConvex(const Model& model, const Dataset& dataset, std::vector<std::string>& failures);

/// Where the sites lie, after checking that they are distinct points of the lattice, the corners among the
/// initial ones, with the samples of the original; and that the running keys do not increase. Empty if a site is no
/// point.
std::vector<LatticePoint> verifySites(const Model& model, const Dataset& original, std::vector<std::string>& failures);

/// The history as a whole: creators are the latest sites, destroyers come later, mesh sizes follow, every tetrahedron
/// that ever lived is positive. Of lattices, every group fills exactly the volume that it empties; of other data, every
/// site lies where its point lies. `usable` becomes false if indices are so wrong that they cannot be followed.
Status verifyHistory(const Model& model, const Original& original, const std::vector<LatticePoint>& places,
                     std::vector<std::string>& failures, bool& usable, const Progress& progress);

/// That batches and groups are as FORMAT.md defines them: in canonical order, groups within batches, and no tetrahedron
/// that reaches from one group to another of its batch or dies in the batch that made it. For a history whose indices
/// can be followed.
Status verifyGroups(const Model& model, std::vector<std::string>& failures, const Progress& progress);

/// Of histories that are not Delaunay: the tetrahedra that a group makes stand on faces of those that it destroys and
/// on no others, so that a closed set, which has those, has a mesh. For a history whose indices can be followed.
Status verifyClosure(const Model& model, std::vector<std::string>& failures, const Progress& progress);

/// The sections that follow from the others and the dataset (core/history/derived_sections.h), as far as the file has
/// them: batch ends and what their meshes keep, the level index, blocks and faults. For a history whose indices can be
/// followed.
Status verifyDerived(const Model& model, const Original& original, const std::vector<LatticePoint>& places,
                     std::vector<std::string>& failures, const Progress& progress);

/// The weights that the model's parameters name, for the original's samples. What cannot be read is a failure.
Result<Weights> weightsOf(const Model& model, const Dataset& original, std::vector<std::string>& failures,
                          const Progress& progress);

} // namespace tetra
