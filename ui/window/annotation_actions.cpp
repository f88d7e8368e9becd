// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/annotation_actions.h"

#include "ui/panels/annotation_rows.h"

#include <QAction>
#include <QMenu>

namespace tetra {

AnnotationActions::AnnotationActions(Session& session, QMenu& menu, QObject* parent)
    : QObject(parent), session_(session), menu_(menu)
{
    for (std::size_t i = 0; i < annotationCount; ++i) {
        const auto kind = static_cast<AnnotationKind>(i);
        QAction* action = menu_.addAction(annotationText(kind, true));
        action->setObjectName(QString("action.annotation.") + annotationNames[i]);
        action->setCheckable(true);
        action->setShortcut(QKeySequence(QString("Ctrl+Alt+%1").arg(i + 1)));
        action->setToolTip(annotationExplanation(kind));
        connect(action, &QAction::triggered, this, [this, kind](bool on) {
            AnnotationState state = session_.view().annotations;
            state[kind].shown = on;
            session_.setAnnotations(state);
        });
        actions_[i] = action;
    }
    connect(&session_, &Session::modelChanged, this, &AnnotationActions::follow);
    session_.whenChanged(ViewPart::Annotations, this, &AnnotationActions::follow);
    follow();
}

void AnnotationActions::follow()
{
    for (std::size_t i = 0; i < annotationCount; ++i)
        actions_[i]->setChecked(session_.view().annotations.places[i].shown);
    menu_.setEnabled(session_.model() != nullptr);
}

} // namespace tetra
