// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/fuzzy_match.h"

#include <QStringList>

#include <algorithm>
#include <vector>

namespace tetra {
namespace {

constexpr int forLetter = 1;
constexpr int forNeighbour = 4;  ///< a letter right after the one before
constexpr int forWordStart = 6;  ///< a letter that begins a word of the text
constexpr int forBeginning = 20; ///< a word of the text begins with that of the query
constexpr int none = -1;

/// Small letters without their accents.
QString folded(const QString& text)
{
    QString result;
    for (const QChar letter : text.normalized(QString::NormalizationForm_D).toCaseFolded())
        if (letter.category() != QChar::Mark_NonSpacing)
            result.append(letter);
    return result;
}

bool beginsWord(const QString& text, qsizetype index)
{
    return text[index].isLetterOrNumber() && (index == 0 || !text[index - 1].isLetterOrNumber());
}

bool hasBeginning(const QString& word, const QString& text)
{
    for (qsizetype place = text.indexOf(word); place >= 0; place = text.indexOf(word, place + 1))
        if (beginsWord(text, place))
            return true;
    return false;
}

/// The best way to find the word's letters in the text, in order: best[i] is that of those so far that ends at letter
/// i of the text.
std::optional<int> matchWord(const QString& word, const QString& text)
{
    std::vector<int> best(static_cast<std::size_t>(text.size()), none);
    for (qsizetype letter = 0; letter < word.size(); ++letter) {
        std::vector<int> next(best.size(), none);
        int before = letter == 0 ? 0 : none; // the best that ends before the letter before
        for (qsizetype place = 0; place < text.size(); ++place) {
            const auto index = static_cast<std::size_t>(place);
            if (text[place] == word[letter]) {
                const int earned = forLetter + (beginsWord(text, place) ? forWordStart : 0);
                if (before != none)
                    next[index] = before + earned;
                if (letter > 0 && place > 0 && best[index - 1] != none)
                    next[index] = std::max(next[index], best[index - 1] + earned + forNeighbour);
            }
            if (letter > 0 && place > 0)
                before = std::max(before, best[index - 1]);
        }
        best = std::move(next);
    }
    const auto found = std::ranges::max_element(best);
    if (found == best.end() || *found == none)
        return std::nullopt;
    return *found + (hasBeginning(word, text) ? forBeginning : 0);
}

} // namespace

std::optional<int> fuzzyMatch(const QString& query, const QString& text)
{
    const QString where = folded(text);
    int sum = 0;
    for (const QString& word : folded(query).split(' ', Qt::SkipEmptyParts)) {
        const auto matched = matchWord(word, where);
        if (!matched)
            return std::nullopt;
        sum += *matched;
    }
    return sum;
}

} // namespace tetra
