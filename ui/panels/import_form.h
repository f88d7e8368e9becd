// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/reader.h"
#include "ui/panels/parameter_form.h"

namespace tetra {

/// The parameters of a reader that make a difference for one file, with what there is to choose from.
struct ImportForm {
    std::vector<Parameter> parameters;
    ParameterChoices choices;

    /// Whether both have the same fields: then they need not be made anew.
    bool looksLike(const ImportForm& other) const;
};

/// Whether the parameters describe a layout that the file does not tell: those called "size" and "skip" are there, and
/// nothing is known of the file without them. `contents`: what a probe without values gave.
bool needsLayout(const std::vector<Parameter>& parameters, const FileContents& contents);

/// The arrays of the file are the choices of the parameter "array", their components those of "component", time steps
/// those of "time", blocks those of "part", "block" or "grid"; what has nothing to choose from is left out, as are the
/// layout, the place and the axes of a file that tells them. `values`: what is chosen so far. A file of which nothing
/// is known has all parameters.
ImportForm importForm(const std::vector<Parameter>& parameters, const FileContents& contents,
                      const ParameterValues& values, bool withLayout);

} // namespace tetra
