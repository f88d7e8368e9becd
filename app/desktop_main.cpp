// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/desktop.h"

int main(int argc, char** argv)
{
    return tetra::runDesktop(argc, argv);
}
