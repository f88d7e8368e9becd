// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/system_error.h"

#include <cstring>
#include <system_error>

namespace tetra {

std::string systemErrorText(int error)
{
#if defined(__GLIBC__)
    const char* const text = ::strerrordesc_np(error);
    return text != nullptr ? text : "system error " + std::to_string(error);
#else
    return std::generic_category().message(error);
#endif
}

} // namespace tetra
