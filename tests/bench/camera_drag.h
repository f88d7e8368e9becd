// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/host/plugin_host.h"
#include "tests/bench/bench_report.h"

#include <filesystem>

namespace tetra {

/// What a move of a camera drag costs the window before it draws, with its undo step. Needs a QApplication.
BenchCase cameraDrag(PluginHost& host, const std::filesystem::path& model, const QString& name);

} // namespace tetra
