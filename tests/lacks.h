// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTest>

namespace tetra {

/// Notes that a test lacks something that every complete machine has: the datasets of ../shared/data, or what
/// ./dev test installs. Its program then ends with 77, which tells ctest that it was skipped; where the datasets are
/// there, it fails (test_program.cpp). TAN_MAY_SKIP=1 or 0 in the environment decides it otherwise.
void noteLack(const char* what);

} // namespace tetra

/// Ends a test function, or a row of it, that lacks `what`, a literal. What depends on the user's rights, on the
/// processor or on programs that nobody has to install is a plain QSKIP.
#define QSKIP_WITHOUT(what)                                                                                            \
    do {                                                                                                               \
        tetra::noteLack(what);                                                                                         \
        QSKIP("skipped: no " what);                                                                                    \
    } while (false)
