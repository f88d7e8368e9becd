// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/plugin_folders.h"
#include "ui/desktop.h"

int main(int argc, char** argv)
{
    tetra::ignoreRelativeFolders();
    return tetra::runDesktop(argc, argv);
}
