// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/session_editor_host.h"

#include "core/data/value_scale.h"
#include "core/picture/annotations/annotation_content.h"
#include "core/view/appearance.h"
#include "plugins/api/scene_parameters.h"
#include "ui/session/files.h"
#include "ui/session/message_text.h"
#include "ui/viewport/value_pick.h"
#include "ui/widgets/file_dialogs.h"

#include <QFileInfo>

#include <algorithm>

namespace tetra {

SessionEditorHost::SessionEditorHost(Workbench& workbench, ValuePick& pick, std::string type, QObject* parent)
    : QObject(parent), workbench_(workbench), session_(workbench.session()), pick_(&pick), type_(std::move(type))
{
    // Before the editor hears of it.
    connect(&session_, &Session::modelChanged, this, [this] { defaults_.reset(); });
    connect(&session_, &Session::modelGrown, this, [this] { defaults_.reset(); });
}

SessionEditorHost::~SessionEditorHost() = default;

std::vector<Parameter> SessionEditorHost::parameters() const
{
    auto parameters = workbench_.scenes().matteringParameters();
    std::erase_if(parameters,
                  [&](const Parameter& parameter) { return parameterTypeName(parameter.defaultValue) != type_; });
    for (Parameter& parameter : parameters) {
        parameter.label = translatedText(parameter.label).toStdString();
        parameter.explanation = translatedText(parameter.explanation).toStdString();
    }
    return parameters;
}

/// Of the mode's parameters, asked for once: an editor asks for a value at every point that it paints.
const ParameterValues& SessionEditorHost::defaults() const
{
    const std::string& mode = session_.view().appearance.mode;
    if (!defaults_ || defaultsOf_ != mode) {
        defaults_.emplace();
        defaultsOf_ = mode;
        for (const Parameter& parameter : workbench_.scenes().renderingParameters())
            defaults_->emplace(parameter.id, parameter.defaultValue);
    }
    return *defaults_;
}

/// The transfer function and the isovalues, which all modes share; other values are settings.
const ParameterValue& SessionEditorHost::value(const std::string& id) const
{
    const Appearance& appearance = session_.view().appearance;
    ParameterValue& given = given_[id];
    if (id == isovaluesId) {
        const auto* isovalues = std::get_if<std::vector<Isovalue>>(&given);
        if (isovalues == nullptr || *isovalues != session_.view().isovalues)
            given = session_.view().isovalues;
        return given;
    }
    if (id == transferId) {
        const auto* function = std::get_if<TransferFunction>(&given);
        if (function == nullptr || *function != appearance.transfer)
            given = appearance.transfer;
        return given;
    }
    const auto usual = defaults().find(id);
    if (usual == defaults().end())
        return given;
    const auto chosen = appearance.settings.find(id);
    const bool isChosen = chosen != appearance.settings.end() && haveOneType(chosen->second, usual->second);
    if (const ParameterValue& value = isChosen ? chosen->second : usual->second; given != value)
        given = value;
    return given;
}

void SessionEditorHost::setValue(const std::string& id, const ParameterValue& value)
{
    const auto* function = std::get_if<TransferFunction>(&value);
    if (function != nullptr && id == transferId)
        return session_.setTransfer(*function);
    if (const auto* isovalues = std::get_if<std::vector<Isovalue>>(&value); isovalues != nullptr && id == isovaluesId) {
        ViewValue view = session_.view();
        view.isovalues = *isovalues;
        return session_.setView(std::move(view));
    }
    const auto all = workbench_.scenes().renderingParameters();
    const auto parameter = std::ranges::find(all, id, &Parameter::id);
    if (parameter == all.end() || !haveOneType(parameter->defaultValue, value))
        return;
    const auto* own = std::get_if<OwnValue>(&value);
    const bool isRefused = own != nullptr && parameter->mistake && !parameter->mistake(own->text).empty();
    if (!isRefused && (function == nullptr || checkTransferFunction(*function)))
        session_.setSetting(id, value);
}

void SessionEditorHost::setEdited(const std::string& id)
{
    if (type_ == parameterTypeName(TransferFunction()))
        workbench_.scenes().editTransfer(id);
}

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

const std::vector<Isovalue>& SessionEditorHost::isovalues() const
{
    return session_.view().isovalues;
}

void SessionEditorHost::whenChanged(QObject* receiver, const std::function<void(EditorChange)>& call)
{
    const auto tells = [call](EditorChange change) { return [call, change] { call(change); }; };
    connect(&session_, &Session::modelChanged, receiver, tells(EditorChange::Model));
    connect(&session_, &Session::modelGrown, receiver, tells(EditorChange::Value)); // defaults fit the model
    connect(&session_, &Session::shownChanged, receiver, tells(EditorChange::Mesh));
    const bool editsIsovalues = type_ == parameterTypeName(std::vector<Isovalue>());
    session_.whenChanged(editsIsovalues ? ViewPart::Appearance | ViewPart::Isovalues : ViewParts(ViewPart::Appearance),
                         receiver, tells(EditorChange::Value));
    session_.whenChanged(ViewPart::Isovalues, receiver, tells(EditorChange::Isovalues));
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
                   [this, use](const QString& path) { workbench_.exporting().loadText(filePath(path), use); });
}

void SessionEditorHost::saveText(QWidget* parent, const EditorFile& file,
                                 const std::function<std::string(const std::string& name)>& make)
{
    if (!hasModel())
        return;
    askForTextTarget(parent, file.dialog, file.title, file.filter, workbench_.opening().proposedPath(file.ending),
                     [this, make](const QString& path) {
                         workbench_.exporting().saveText(filePath(path),
                                                         make(QFileInfo(path).completeBaseName().toStdString()));
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

bool SessionEditorHost::holdsLogarithms() const
{
    return session_.model() && tetra::holdsLogarithms(session_.model()->description().parameters);
}

ValueFacts SessionEditorHost::valueFacts() const
{
    if (!session_.model())
        return {};
    const ModelDescription& model = session_.model()->description();
    return {usualUnit(model), model.sampleType};
}

bool SessionEditorHost::showsIsovalues() const
{
    return std::ranges::any_of(workbench_.scenes().matteringParameters(), [](const Parameter& parameter) {
        return parameterTypeName(parameter.defaultValue) == parameterTypeName(std::vector<Isovalue>());
    });
}

void SessionEditorHost::forgetPicked()
{
    if (pick_)
        pick_->forget();
}

} // namespace tetra
