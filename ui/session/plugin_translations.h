// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/host/plugin_host.h"

#include <QLocale>

#include <memory>
#include <vector>

class QTranslator;

namespace tetra {

/// The translations that plugins bring: beside the library of each, a file that is called like it, with the language:
/// "mine_de.qm" beside "mine.so". Of plugins that cannot be used, too, which are listed; none for those without a file.
std::vector<std::unique_ptr<QTranslator>> pluginTranslators(const PluginHost& host, const QLocale& locale);

/// Installs `translators`, behind `ours`, so that no plugin changes what the program says itself.
void installBehind(const std::vector<std::unique_ptr<QTranslator>>& translators, QTranslator& ours);

} // namespace tetra
