// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/plugin_texts.h"

#include <QCoreApplication>

namespace tetra {

QString pluginText(const std::string& text)
{
    return text.empty() ? QString() : QCoreApplication::translate("Plugin", text.c_str());
}

} // namespace tetra
