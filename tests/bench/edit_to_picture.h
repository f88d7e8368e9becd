// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/host/plugin_host.h"
#include "tests/bench/bench_report.h"

#include <filesystem>

namespace tetra {

/// How long a person waits from an edit of the transfer function to the first picture that shows it, in the window with
/// the CPU back end and a volume: while a point is dragged (R23), and for edits one at a time. Needs a QApplication.
std::vector<BenchCase> editToPicture(PluginHost& host, const std::filesystem::path& model, const QString& name);

} // namespace tetra
