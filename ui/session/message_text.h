// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/data.h>

#include <QString>
#include <QStringList>

#include <map>
#include <span>
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

/// A line for each thing that was taken of a file, "Array: temperature (a guess)", and a sentence for each that the
/// file says and that was not used, in the user's language.
QStringList provenanceLines(std::span<const Taken> taken, std::span<const Message> leftOut);

} // namespace tetra
