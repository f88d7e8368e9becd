// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/word_match.h"

#include <QStringList>

#include <algorithm>

namespace tetra {
namespace {

constexpr int forBeginning = 1; ///< a word of the text begins with that of the query
constexpr int forWhole = 4;     ///< and is no longer
constexpr int forOwnName = 8;   ///< and belongs to the name itself, not to what leads there
constexpr int forFirst = 2;     ///< and is the first of the name

/// Small letters without their accents.
QString folded(const QString& text)
{
    QString result;
    for (const QChar letter : text.normalized(QString::NormalizationForm_D).toCaseFolded())
        if (letter.category() != QChar::Mark_NonSpacing)
            result.append(letter);
    return result;
}

/// What begins with no letter, as "%" does, may stand anywhere.
bool beginsWord(const QString& text, qsizetype place)
{
    return place == 0 || !text[place].isLetterOrNumber() || !text[place - 1].isLetterOrNumber();
}

/// "0" is not all of "0.5".
bool endsWord(const QString& text, qsizetype end)
{
    if (end == text.size())
        return true;
    const bool goesOn = end + 1 < text.size() && text[end].isPunct() && text[end + 1].isLetterOrNumber();
    return !text[end].isLetterOrNumber() && !goesOn;
}

/// The best place of a word of the query; nothing if there is none.
std::optional<int> bestPlace(const QString& word, const QString& text, qsizetype ownStart)
{
    std::optional<int> best;
    for (qsizetype place = text.indexOf(word); place >= 0; place = text.indexOf(word, place + 1)) {
        if (!beginsWord(text, place))
            continue;
        const int earned = forBeginning + (endsWord(text, place + word.size()) ? forWhole : 0) +
                           (place >= ownStart ? forOwnName : 0) + (place == ownStart ? forFirst : 0);
        best = std::max(best.value_or(earned), earned);
    }
    return best;
}

} // namespace

std::optional<int> wordMatch(const QString& query, const QString& text, qsizetype ownStart)
{
    const QString way = folded(text.left(ownStart)), where = way + folded(text.mid(ownStart));
    int sum = 0;
    for (const QString& word : folded(query).split(' ', Qt::SkipEmptyParts)) {
        const auto found = bestPlace(word, where, way.size());
        if (!found)
            return std::nullopt;
        sum += *found;
    }
    return sum;
}

} // namespace tetra
