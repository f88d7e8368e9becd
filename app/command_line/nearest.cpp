// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/nearest.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace tetra {
namespace {

/// The Levenshtein distance, in which two neighbours that are exchanged count once: the commonest slip in typing.
std::size_t distance(std::string_view a, std::string_view b)
{
    std::vector<std::size_t> twoBefore, before, row(b.size() + 1); // distances of a prefix of a to all prefixes of b
    std::iota(row.begin(), row.end(), std::size_t(0));
    for (std::size_t i = 0; i < a.size(); ++i) {
        twoBefore = std::exchange(before, row);
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            row[j + 1] = std::min({before[j] + (a[i] == b[j] ? 0 : 1), row[j] + 1, before[j + 1] + 1});
            if (i > 0 && j > 0 && a[i] == b[j - 1] && a[i - 1] == b[j])
                row[j + 1] = std::min(row[j + 1], twoBefore[j - 1] + 1);
        }
    }
    return row.back();
}

} // namespace

std::optional<std::string> nearest(std::string_view word, std::span<const std::string> candidates)
{
    const auto best = std::ranges::min_element(candidates, {},
                                               [&](const std::string& candidate) { return distance(word, candidate); });
    if (best == candidates.end() || distance(word, *best) > std::max<std::size_t>(1, best->size() / 3))
        return std::nullopt;
    return *best;
}

} // namespace tetra
