// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/subcommand.h"
#include "core/serve/mesh_facts.h"

#include <tan/query.h>
#include <tan/transfer.h>

#include <ostream>
#include <span>
#include <string>

namespace tetra {

/// What was read of a model, unless its file is damaged: then that, also in place of an error, which may have come of
/// it. Comes before anything is said or written of what was read.
template <class Value> Result<Value> confirmed(const Model& model, Result<Value> read, const Progress& progress)
{
    const bool cancelled = !read && read.error().kind == ErrorKind::Cancelled;
    const Status right = cancelled ? Status() : model.confirm(progress.withCallback({}));
    return right ? std::move(read) : Result<Value>(right.error());
}

/// ", with errors of up to 1.68 %", in the words for that error: what meshFigures() tell that the mesh reaches; nothing
/// where they do not.
std::string reachedText(const JsonObject& figures);

/// Says of which of these values the data have none, whose surfaces are empty: that is usual among the files of a
/// series, and no mistake.
void tellEmptySurfaces(std::span<const double> isovalues, const ValueRange& range, Outcome& outcome);

/// Says what of a picture its mesh's error alone may have made, and by which options it would not: at once, and among
/// the "remarks" of the figures.
void warnOfErrors(std::span<const ErrorRemark> remarks, const ModelDescription& model, std::ostream& messages,
                  JsonObject& figures);

} // namespace tetra
