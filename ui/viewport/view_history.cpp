// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/view_history.h"

#include "ui/session/view_commands.h"
#include "ui/viewport/viewport.h"

#include <QUndoStack>

namespace tetra {
namespace {

class ChangeView : public QUndoCommand {
    Q_DECLARE_TR_FUNCTIONS(ChangeView)
public:
    ChangeView(ViewHistory& history, const ViewChoice& before, const ViewChoice& after, Gesture gesture)
        : QUndoCommand(before.camera == after.camera ? tr("Change Background") : tr("Move Camera")), history_(history),
          before_(before), after_(after), gesture_(gesture)
    {
    }
    int id() const override { return static_cast<int>(CommandId::ChangeView); }
    void redo() override { history_.show(after_); }
    void undo() override { history_.show(before_); }
    bool mergeWith(const QUndoCommand* next) override
    {
        const auto& other = *static_cast<const ChangeView*>(next);
        if (other.gesture_ != gesture_ || text() != other.text())
            return false;
        after_ = other.after_;
        setObsolete(after_ == before_);
        return true;
    }

private:
    ViewHistory& history_;
    ViewChoice before_;
    ViewChoice after_;
    Gesture gesture_;
};

} // namespace

ViewHistory::ViewHistory(Viewport& viewport, QUndoStack& stack, QObject* parent)
    : QObject(parent), viewport_(viewport), stack_(stack), last_(chosen())
{
    connect(&viewport, &Viewport::started, this, [this] { last_ = chosen(); });
    connect(&viewport, &Viewport::cameraChanged, this, &ViewHistory::follow);
    connect(&viewport, &Viewport::backgroundChanged, this, &ViewHistory::follow);
}

void ViewHistory::show(const ViewChoice& view)
{
    last_ = view;
    viewport_.glideTo(view.camera);
    viewport_.setBackground(view.background);
}

ViewChoice ViewHistory::chosen() const
{
    return {viewport_.camera(), viewport_.chosenBackground()};
}

void ViewHistory::follow()
{
    const ViewChoice now = chosen();
    if (now == last_)
        return;
    const ViewChoice before = last_;
    last_ = now;
    stack_.push(new ChangeView(*this, before, now, viewport_.gesture()));
}

} // namespace tetra
