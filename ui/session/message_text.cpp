// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/message_text.h"

#include "core/base/text.h"

#include <QCoreApplication>

namespace tetra {
namespace {

/// lupdate calls the context of Message::say() and Message::marked() so, depending on whether the source is inside of
/// the namespace or only uses it.
constexpr const char* contexts[] = {"tetra::Message", "Message"};

QString translated(const std::string& sentence)
{
    const QString english = QString::fromStdString(sentence);
    for (const char* context : contexts)
        if (QString text = QCoreApplication::translate(context, sentence.c_str()); text != english)
            return text;
    return english;
}

} // namespace

QString translatedMessage(const Message& message)
{
    if (message.sentence().empty())
        return shownText(message.text());
    const QString sentence = translated(message.sentence());
    const auto& arguments = message.arguments();
    QString result;
    for (qsizetype i = 0; i < sentence.size(); ++i) {
        const auto place = sentence[i] == '%' && i + 1 < sentence.size()
                               ? static_cast<std::size_t>(sentence[i + 1].unicode() - u'1')
                               : arguments.size();
        if (place < arguments.size()) {
            result += translatedMessage(arguments[place]);
            ++i;
        } else {
            result += sentence[i];
        }
    }
    return result;
}

QString shownText(const std::string& text)
{
    return QString::fromStdString(visibleText(text));
}

QString translatedText(std::string_view text)
{
    return text.empty() ? QString() : translated(std::string(text));
}

QString inUsersLanguage(const std::string& english, const std::map<std::string, std::string>& others)
{
    const QString code = QCoreApplication::translate("Language", "en"); // translated by that of the language
    const auto found = others.find(code.toStdString());
    return shownText(found == others.end() || found->second.empty() ? english : found->second);
}

QStringList provenanceLines(std::span<const Taken> taken, std::span<const Message> leftOut)
{
    QStringList lines;
    for (const Taken& one : taken) {
        const QString line = translatedMessage(takenText(one));
        lines << line.left(1).toUpper() + line.mid(1);
    }
    for (const Message& one : leftOut)
        lines << translatedMessage(one);
    return lines;
}

} // namespace tetra
