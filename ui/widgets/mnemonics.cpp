// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/mnemonics.h"

#include <QAbstractButton>
#include <QAction>
#include <QKeySequence>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QSet>

namespace tetra {
namespace {

/// Where in the text a key is that is not taken: first at the start of a word, then anywhere.
std::optional<qsizetype> placeOfKey(const QString& text, const QSet<QChar>& taken)
{
    for (const bool atStarts : {true, false})
        for (qsizetype index = 0; index < text.size(); ++index) {
            const bool isStart = index == 0 || !text[index - 1].isLetterOrNumber();
            if (text[index].isLetterOrNumber() && (isStart || !atStarts) && !taken.contains(text[index].toUpper()))
                return index;
        }
    return std::nullopt;
}

QChar keyOf(const QString& text)
{
    static const QRegularExpression mnemonic("&([^&])");
    const QRegularExpressionMatch match = mnemonic.match(QString(text).remove("&&"));
    return match.hasMatch() ? match.captured(1).front().toUpper() : QChar();
}

} // namespace

void giveMnemonics(QMenu& menu)
{
    QSet<QChar> taken;
    const QList<QAction*> actions = menu.actions();
    for (const QAction* action : actions)
        if (const QChar key = keyOf(action->text()); !key.isNull())
            taken.insert(key);
    for (QAction* action : actions) {
        if (action->isSeparator() || !keyOf(action->text()).isNull())
            continue;
        QString text = action->text();
        if (const auto place = placeOfKey(text, taken)) {
            taken.insert(text[*place].toUpper());
            action->setText(text.insert(*place, '&'));
        }
    }
}

void separateMnemonics(QWidget& panel, const QMenuBar& bar)
{
    QSet<QChar> taken;
    for (const QAction* action : bar.actions())
        taken.insert(keyOf(action->text()));
    const auto separate = [&taken](auto& widget) {
        const QChar key = keyOf(widget.text());
        if (key.isNull())
            return;
        QString text = widget.text();
        if (taken.contains(key)) {
            text = withoutMnemonic(text);
            const auto place = placeOfKey(text, taken);
            widget.setText(place ? QString(text).insert(*place, '&') : text);
        }
        taken.insert(keyOf(widget.text()));
    };
    for (QLabel* label : panel.findChildren<QLabel*>())
        if (label->buddy() != nullptr)
            separate(*label);
    for (QAbstractButton* button : panel.findChildren<QAbstractButton*>())
        separate(*button);
}

QString withoutMnemonic(const QString& text)
{
    static const QRegularExpression mark("&(.)");
    return QString(text).replace(mark, "\\1");
}

} // namespace tetra
