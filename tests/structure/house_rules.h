// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace tetra {

/// Reads every .h and .cpp under app, core, plugins, tests and ui of `root` and says, one sentence a breach and in the
/// order of the paths, where they break the rules of the house:
/// - who may include whom (core <- plugins/api <- plugins/*; core, plugins/api, plugins/host <- ui <- app; core <-
///   plugins/widgets <- plugins/editors, ui; no plugin includes another; inside core as the table of the source says);
/// - a folder holds 25 units at most, a header and its source being one, but for the `heaps`, which hold just as many
/// as
///   stands there: none may grow, and when one has become smaller its number falls with it, or its line goes;
/// - own headers are included by their path from the root and exist;
/// - core includes no Qt, and its headers neither OpenGL nor CGAL; of plugins only editors include Qt, and of the
/// command
///   line only what draws;
/// - what the system says of an error comes from systemErrorText(), which is English in every locale;
/// - sources that the texts for developers name are there;
/// - the first line is the licence's SPDX line, and headers have `#pragma once`.
using Heaps = std::map<std::string, std::size_t>;
Heaps heapsOfThisTree();
std::vector<std::string> houseBreaches(const std::filesystem::path& root, const Heaps& heaps);

/// Where those rules themselves let a folder include one that stands after it, so that arrows could go both ways.
std::vector<std::string> arrowsBack();

} // namespace tetra
