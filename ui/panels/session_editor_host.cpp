// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/session_editor_host.h"

#include "ui/session/message_text.h"
#include "ui/session/target_path.h"
#include "ui/viewport/value_pick.h"
#include "ui/widgets/file_dialogs.h"

#include <QFileInfo>

namespace tetra {

SessionEditorHost::SessionEditorHost(Workbench& workbench, ValuePick& pick, QObject* parent)
    : QObject(parent), workbench_(workbench), session_(workbench.session()), pick_(&pick)
{
}

SessionEditorHost::~SessionEditorHost() = default;

bool SessionEditorHost::hasModel() const
{
    return session_.model() != nullptr;
}

ValueRange SessionEditorHost::range() const
{
    return session_.range();
}

double SessionEditorHost::diagonal() const
{
    return session_.model() ? session_.model()->diagonal() : 0;
}

std::shared_ptr<const ValueHistogram> SessionEditorHost::histogram() const
{
    return session_.shown() ? session_.shown()->histogram : nullptr;
}

std::shared_ptr<const ValueHistogram> SessionEditorHost::logarithmicHistogram() const
{
    return session_.shown() ? session_.shown()->logarithmicHistogram : nullptr;
}

const TransferFunction& SessionEditorHost::function() const
{
    return session_.view().look().transfer;
}

const std::vector<Isovalue>& SessionEditorHost::isovalues() const
{
    return session_.view().isovalues();
}

void SessionEditorHost::whenChanged(QObject* receiver, const std::function<void(EditorChange)>& call)
{
    const auto tells = [call](EditorChange change) { return [call, change] { call(change); }; };
    const ViewState& view = session_.view();
    connect(&session_, &Session::modelChanged, receiver, tells(EditorChange::Model));
    connect(&session_, &Session::shownChanged, receiver, tells(EditorChange::Mesh));
    connect(&view, &ViewState::lookChanged, receiver, tells(EditorChange::Function));
    connect(&view, &ViewState::isovalueInserted, receiver, tells(EditorChange::Isovalues));
    connect(&view, &ViewState::isovalueRemoved, receiver, tells(EditorChange::Isovalues));
    connect(&view, &ViewState::isovalueChanged, receiver, tells(EditorChange::Isovalues));
    connect(pick_, &ValuePick::pickedChanged, receiver, tells(EditorChange::Picked));
}

void SessionEditorHost::beginGesture()
{
    session_.beginGesture();
}

void SessionEditorHost::endGesture()
{
    session_.endGesture();
}

void SessionEditorHost::setFunction(const TransferFunction& function)
{
    session_.setTransfer(function);
}

void SessionEditorHost::addIsovalue(double value)
{
    session_.addIsovalue(value);
}

void SessionEditorHost::setIsovalue(std::size_t index, const Isovalue& isovalue)
{
    session_.setIsovalue(static_cast<int>(index), isovalue);
}

void SessionEditorHost::removeIsovalue(std::size_t index)
{
    session_.removeIsovalue(static_cast<int>(index));
}

void SessionEditorHost::loadText(QWidget* parent, const EditorFile& file,
                                 const std::function<Status(const std::string& text)>& use)
{
    askForTextFile(parent, file.dialog, file.title, file.filter,
                   [this, use](const QString& path) { workbench_.loadText(filePath(path), use); });
}

void SessionEditorHost::saveText(QWidget* parent, const EditorFile& file,
                                 const std::function<std::string(const std::string& name)>& make)
{
    if (!hasModel())
        return;
    askForTextTarget(parent, file.dialog, file.title, file.filter, workbench_.proposedPath(file.ending),
                     [this, make](const QString& path) {
                         workbench_.saveText(filePath(path), make(QFileInfo(path).completeBaseName().toStdString()));
                     });
}

void SessionEditorHost::tell(const Message& message)
{
    emit workbench_.failed(translatedMessage(message));
}

std::optional<PickedValue> SessionEditorHost::picked() const
{
    return pick_ ? pick_->picked() : std::nullopt;
}

void SessionEditorHost::forgetPicked()
{
    if (pick_)
        pick_->forget();
}

} // namespace tetra
