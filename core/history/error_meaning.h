// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/history/query_words.h"

#include <tan/base.h>
#include <tan/model.h>
#include <tan/query.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace tetra {

/// What the number called the error of a mesh compares a sample with (C12). Whoever shows such a number says it in
/// these words, and in no others.
enum class ErrorMeaning : std::uint8_t {
    Only,    ///< there is one error: nothing is warped, or samples are compared where they lie
    InGrid,  ///< of curvilinear grids: with the mesh at the sample's indices; at its place it may be off by more
    InSpace, ///< of curvilinear grids: at its indices and at its place, where one looks; the number bounds both
};

/// Of what a model guarantees of the meshes of an accuracy or a budget. O(parameters).
TAN_INTERNAL ErrorMeaning errorMeaning(const ModelDescription& model);
/// Of what it guarantees of the mesh that answers a query: accuracies that differ from place to place are kept by what
/// tetrahedra say of themselves, which is the error in the grid.
TAN_INTERNAL ErrorMeaning errorMeaning(const ModelDescription& model, const MeshQuery& query);

// The words of each meaning, by its number.

/// In JSON and the facts of files: wordOf() and choiceOf() (core/history/query_words.h).
inline constexpr std::array errorKindWords = {"samples", "grid", "space"};

/// What such a number is called before it stands, "error in the grid 1 %", as a word in a sentence.
inline constexpr std::array errorNames = {Message::marked("error"), Message::marked("error in the grid"),
                                          Message::marked("error in space")};
/// Of several.
inline constexpr std::array errorsNames = {Message::marked("errors"), Message::marked("errors in the grid"),
                                           Message::marked("errors in space")};
/// Where the name stands apart: as a label, or the head of a column.
inline constexpr std::array errorLabels = {Message::marked("Error"), Message::marked("Error in the grid"),
                                           Message::marked("Error in space")};
/// What is beside "Error:"; nothing where there is one only.
inline constexpr std::array errorPlaces = {MarkedText{""}, Message::marked("in the grid; in space it may be larger"),
                                           Message::marked("in the grid and in space")};
/// What is promised, in a sentence; nothing where there is one only.
inline constexpr std::array errorPromises = {
    MarkedText{""},
    Message::marked(
        "The guarantee is for the error in the grid; the error in space, at the place where you look, may be larger."),
    Message::marked("The error in the grid and the error in space, at the place where you look, are both guaranteed at "
                    "every accuracy; in a focus or a field, the error in the grid alone.")};
/// How the error in space becomes known where it is not.
inline constexpr MarkedText errorInSpaceAdvice = Message::marked("'tan verify' measures the error in space.");

/// One of the above.
template <std::size_t count>
constexpr MarkedText textFor(const std::array<MarkedText, count>& texts, ErrorMeaning meaning)
{
    return texts[static_cast<std::size_t>(meaning)];
}

/// Adds to the facts of a file (pairs of a name and a number or a text) which error its numbers are, where there are
/// two, and the largest one in space, in %, if it was measured.
template <class Facts> void addErrorKind(Facts& facts, ErrorMeaning meaning, const std::optional<double>& errorInSpace)
{
    if (meaning != ErrorMeaning::Only)
        facts.emplace_back("error_kind", wordOf(errorKindWords, meaning));
    if (errorInSpace)
        facts.emplace_back("error_in_space", *errorInSpace);
}

} // namespace tetra
