// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/query.h>

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tetra {

/// What is asked of a model at a server in place of a mesh, as the query of its URL.
inline constexpr std::string_view sizesQuestion = "sizes";
inline constexpr std::string_view aboutQuestion = "about";

/// A MeshQuery in words, "error" and "1", one text for the query of a URL, which the client writes and the server
/// reads, and for the options of a command line (docs/user/command-line.md, `tan serve` and `tan extract`). The words:
///
///     error, warping            the largest error in %, the largest warping; a number or "none"
///     focus                     box:x0,y0,z0,x1,y1,z1 or sphere:x,y,z,r, any number of them
///     focus-error, focus-warping, falloff
///     field, warping-field      in place of these, a text as parseErrorField()
///     budget                    a number of tetrahedra
///     method                    one of methodWords
///     range, births, deaths     two numbers each, in place of one mesh
///     window, border, values    which part of the mesh; any number of values
class TAN_INTERNAL QueryWords {
public:
    using Word = std::pair<std::string, std::string>;

    QueryWords() = default;
    explicit QueryWords(std::vector<Word> words) : words_(std::move(words)) {}

    /// The words for a query. With `warps` the data warp. Errors: WrongUsage for what cannot be said: a range of
    /// accuracies whose warpings follow no rule, and more text than a request may have.
    static Result<QueryWords> of(const MeshQuery& query, bool warps);

    /// From "error=1&window=0,0,0,9,9,9", percent-encoded, and back. Besides the words above a URL may say empty=yes.
    /// Errors (WrongUsage): wrong encoding, words that are not known or come twice.
    static Result<QueryWords> fromUrl(std::string_view text);
    std::string toUrl() const;

    /// What they ask for; fields take what they leave out from `present`. Messages name a word with `prefix` before it.
    /// Errors (WrongUsage): values that do not fit, and words that do not go together.
    Result<MeshQuery> query(std::string_view prefix = {}, const PresentView& present = {}) const;

    bool has(std::string_view name) const;
    /// The first one's.
    std::optional<std::string> value(std::string_view name) const;
    std::vector<std::string> values(std::string_view name) const;

private:
    std::vector<Word> words_;
};

} // namespace tetra
