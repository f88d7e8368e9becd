// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/sentences.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <algorithm>
#include <vector>

namespace tetra {
namespace {

constexpr const char* context = "Sentence";

const QRegularExpression& placeholder()
{
    static const QRegularExpression found("%([1-9])");
    return found;
}

/// How a sentence is told apart from others, and what differs in it is found.
struct Pattern {
    const char* source;
    QRegularExpression text;
    std::vector<bool> isName; ///< of each placeholder: it stands in quotes, and is nobody's language
    qsizetype fixedLength = 0;
};

/// Placeholders come in the order of their numbers. A sentence that begins with one and a blank begins with a number.
Pattern patternOf(const char* source)
{
    Pattern pattern{source, {}, {}, 0};
    const QString text = QString::fromUtf8(source);
    QString expression;
    qsizetype end = 0;
    for (auto matches = placeholder().globalMatch(text); matches.hasNext();) {
        const auto match = matches.next();
        const qsizetype start = match.capturedStart();
        expression += QRegularExpression::escape(text.mid(end, start - end));
        expression += start == 0 && text.mid(match.capturedEnd(), 1) == " " ? "([0-9]+)" : "(.+)";
        pattern.isName.push_back(start > 0 && QString("'\"").contains(text[start - 1]));
        pattern.fixedLength += start - end;
        end = match.capturedEnd();
    }
    pattern.fixedLength += text.size() - end;
    pattern.text.setPattern(
        QRegularExpression::anchoredPattern(expression + QRegularExpression::escape(text.mid(end))));
    return pattern;
}

/// Those that say most come first: what fits them may fit a more general one, too.
const std::vector<Pattern>& patterns()
{
    static const std::vector<Pattern> all = [] {
        std::vector<Pattern> made;
        for (const char* source : knownSentences())
            made.push_back(patternOf(source));
        std::ranges::stable_sort(made, std::ranges::greater{}, &Pattern::fixedLength);
        return made;
    }();
    return all;
}

QString translatedLine(const QString& line);

/// Texts of plugins have no names in them, and single words may be names. Several are lists of kinds of files, as in
/// "Raw volume (*.raw), TIFF stack (*.tif)".
QString pluginTexts(const QString& text)
{
    static const QRegularExpression betweenFilters("(?<=\\)), ");
    if (!text.contains(' '))
        return text;
    QStringList parts = text.split(betweenFilters);
    std::ranges::transform(parts, parts.begin(), [](const QString& part) {
        return QCoreApplication::translate("Plugin", part.toUtf8().constData());
    });
    return parts.join(", ");
}

/// `translation` with what was found in the place of its placeholders; what is a sentence itself is translated, too.
QString filled(const QString& translation, const Pattern& pattern, const QRegularExpressionMatch& found)
{
    QString result;
    qsizetype end = 0;
    for (auto matches = placeholder().globalMatch(translation); matches.hasNext();) {
        const auto match = matches.next();
        const int number = match.captured(1).toInt();
        const QString text = found.captured(number);
        const bool isName = pattern.isName[static_cast<std::size_t>(number - 1)];
        result += translation.mid(end, match.capturedStart() - end) + (isName ? text : translatedLine(text));
        end = match.capturedEnd();
    }
    return result + translation.mid(end);
}

QString translatedLine(const QString& line)
{
    for (const Pattern& pattern : patterns())
        if (const auto found = pattern.text.match(line); found.hasMatch())
            return filled(QCoreApplication::translate(context, pattern.source), pattern, found);
    return pluginTexts(line);
}

/// Whether a place of a sentence stands in quotes: what is there is a name, and nobody's language.
bool isNamed(const QString& sentence, int number)
{
    const qsizetype place = sentence.indexOf('%' + QString::number(number));
    return place > 0 && QString("'\"").contains(sentence[place - 1]);
}

} // namespace

QString translatedMessage(const Message& message)
{
    const QString sentence = QString::fromStdString(message.sentence());
    const QString translation = QCoreApplication::translate(context, message.sentence().c_str());
    if (sentence.isEmpty() || translation == sentence)
        return translatedSentence(message.text());
    QString result;
    qsizetype end = 0;
    for (auto matches = placeholder().globalMatch(translation); matches.hasNext();) {
        const auto match = matches.next();
        const int number = match.captured(1).toInt();
        if (static_cast<std::size_t>(number) > message.arguments().size())
            continue;
        const Message& argument = message.arguments()[static_cast<std::size_t>(number - 1)];
        result += translation.mid(end, match.capturedStart() - end);
        result += isNamed(sentence, number) ? QString::fromStdString(argument.text()) : translatedMessage(argument);
        end = match.capturedEnd();
    }
    return result + translation.mid(end);
}

QString translatedSentence(const std::string& text)
{
    QStringList lines = QString::fromStdString(text).split('\n');
    std::ranges::transform(lines, lines.begin(), translatedLine);
    return lines.join('\n');
}

} // namespace tetra
