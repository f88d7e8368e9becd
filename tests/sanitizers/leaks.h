// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#if defined(__SANITIZE_ADDRESS__)

/// For the address sanitizer alone, to be included by a program's main source. The drivers of OpenGL are unloaded
/// before leaks are looked for, which then are nobody's: here all libraries stay. Takes the place of the system's
/// function.
extern "C" int dlclose(void* /*library*/) noexcept
{
    return 0;
}

/// Libraries, not ours, that keep some memory to the end: those of Mesa's OpenGL and of the session bus. Those of other
/// programs: leaks.supp.
extern "C" const char* __lsan_default_suppressions()
{
    return "leak:_dri.so\n"
           "leak:libGLX_mesa.so\n"
           "leak:libdbus-1.so\n";
}

#endif
