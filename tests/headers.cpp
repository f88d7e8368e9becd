// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing but what CMake needs to precompile the headers that tests read first (tan_test_headers in CMakeLists.txt).
