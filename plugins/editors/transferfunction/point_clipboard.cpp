// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/editors/transferfunction/point_clipboard.h"

#include "plugins/widgets/curves/copying.h"

#include <QClipboard>
#include <QCoreApplication>
#include <QGuiApplication>

namespace tetra {
namespace {

constexpr double duplicateDistance = 0.05; ///< of what is seen

} // namespace

void copyPoints(const EditorState& state)
{
    if (!state.selection().empty())
        QGuiApplication::clipboard()->setText(
            QString::fromStdString(copyOfSelected(state.joinedFunction(), state.selection())));
}

void pastePoints(EditorState& state, std::optional<double> at)
{
    const std::string text = QGuiApplication::clipboard()->text().toStdString();
    if (const auto edited = pasted(state.joinedFunction(), text, at, state.limits()))
        state.apply(*edited);
    else
        state.host().tell(Message::say("The clipboard holds no points of a transfer function. Copy some here or in "
                                       "another window. %1",
                                       edited.error().message));
}

void duplicatePoints(EditorState& state)
{
    const TransferLimits seen = state.shown();
    state.apply(duplicated(state.joinedFunction(), state.selection(), duplicateDistance * (seen.largest - seen.least),
                           state.limits()));
}

} // namespace tetra
