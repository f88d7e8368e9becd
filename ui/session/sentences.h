// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <QString>

#include <span>
#include <string>

namespace tetra {

/// What went wrong, or what a reader remarks, in the user's language. Core and plugins know English only, and put names
/// and numbers into their sentences; the sentences that users of the window meet are known here with a placeholder for
/// each, and so are those that can stand in such a place. What is not known stays as it is, part by part.
QString translatedSentence(const std::string& text);

/// The same of a message, whose sentence and arguments are known apart: nothing is guessed. Sentences that have no
/// translation of their own are looked for as above.
QString translatedMessage(const Message& message);

/// In English: what they are made of, "Cannot read '%1': %2".
std::span<const char* const> knownSentences();

} // namespace tetra
