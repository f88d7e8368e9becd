// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <QString>

#include <map>
#include <string>
#include <string_view>

namespace tetra {

/// In the user's language. The sentence is translated as a whole, then its arguments take their places; what is not a
/// sentence (a name, a number, what another program said) stays as it is, and so does what has no translation.
QString translatedMessage(const Message& message);

/// visibleText(): what a file says, such as the name of an array, or its own name.
QString shownText(const std::string& text);

/// A text that core or a plugin marked by Message::marked(), such as a parameter's label, in the user's language.
QString translatedText(std::string_view text);

/// Of a plugin's name or description, the one in the user's language; `others` are its translations by their codes.
QString inUsersLanguage(const std::string& english, const std::map<std::string, std::string>& others);

} // namespace tetra
