// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/plain_texts.h"

#include <QApplication>
#include <QEvent>
#include <QLabel>

namespace tetra {
namespace {

/// Sees every label before it is shown for the first time; tool tips are labels, too.
class PlainTexts : public QObject {
public:
    using QObject::QObject;

    bool eventFilter(QObject* watched, QEvent* event) override
    {
        if (event->type() == QEvent::Polish)
            if (auto* const label = qobject_cast<QLabel*>(watched); label && label->textFormat() == Qt::AutoText)
                label->setTextFormat(Qt::PlainText);
        return false;
    }
};

} // namespace

void showTextsPlainly(QApplication& application)
{
    application.installEventFilter(new PlainTexts(&application));
}

} // namespace tetra
