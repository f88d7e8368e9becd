// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace tetra {

/// What a number of errno means, in English under every locale, without a full stop: "No such file or directory". The
/// C library's own texts would come in the user's language, in the middle of an English sentence that nobody could
/// translate any more.
std::string systemErrorText(int error);

} // namespace tetra
