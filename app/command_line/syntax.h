// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace tetra {

/// An option of a subcommand, as data: the parser and the help read it.
struct Option {
    std::string name;        ///< without the dashes
    std::string placeholder; ///< what its value is called in the help; empty for an option without a value
    std::string explanation; ///< one sentence
    std::string byDefault{}; ///< shown in the help; empty if there is none
    char letter = 0;         ///< short form, 'o' for -o
    bool repeatable = false;
    bool required = false;
    bool ofPlugin = false; ///< made from a parameter of a plugin
};

/// A word that is no option, such as a file.
struct Positional {
    std::string name;
    std::string explanation;
    bool required = true;
};

struct Example {
    std::string command;
    std::string explanation;
};

/// All that can be said to a subcommand.
struct Syntax {
    std::string purpose;     ///< one line
    std::string explanation; ///< a paragraph or two
    std::vector<Positional> positionals;
    std::vector<Option> options;
    std::vector<std::string> usualSwitches{}; ///< of "--no-NAME": NAME, which says what is done anyway
    std::vector<Example> examples;
    std::vector<int> exitCodes{0, 2, 3, 4, 130}; ///< those that can occur
    bool resultMayBeOutput = false; ///< '-o -' is standard output, which then holds the result and nothing else
};

} // namespace tetra
