// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/editor.h"
#include "plugins/api/value_facts_host.h"
#include "plugins/api/value_scale_host.h"
#include "ui/workbench/workbench.h"

#include <QPointer>

namespace tetra {

class ValuePick;

/// The window as an editor of parameters of the type `type` sees it: the workbench's session, whose undo stack takes
/// the edits, and the window's file dialogs, and what is picked in the picture. Outlived by the workbench.
class SessionEditorHost : public QObject, public EditorHost, public ValueScaleHost, public ValueFactsHost {
    Q_OBJECT
public:
    SessionEditorHost(Workbench& workbench, ValuePick& pick, std::string type, QObject* parent = nullptr);
    ~SessionEditorHost() override;

    std::vector<Parameter> parameters() const override;
    const ParameterValue& value(const std::string& id) const override;
    void setValue(const std::string& id, const ParameterValue& value) override;
    void setEdited(const std::string& id) override;
    bool hasModel() const override;
    ValueRange range() const override;
    double diagonal() const override;
    std::shared_ptr<const ValueHistogram> histogram() const override;
    std::shared_ptr<const ValueHistogram> logarithmicHistogram() const override;
    const std::vector<Isovalue>& isovalues() const override;
    void whenChanged(QObject* receiver, const std::function<void(EditorChange)>& call) override;
    void beginGesture() override;
    void endGesture() override;
    void addIsovalue(double value) override;
    void setIsovalue(std::size_t index, const Isovalue& isovalue) override;
    void removeIsovalue(std::size_t index) override;
    void loadText(QWidget* parent, const EditorFile& file,
                  const std::function<Status(const std::string& text)>& use) override;
    void saveText(QWidget* parent, const EditorFile& file,
                  const std::function<std::string(const std::string& name)>& make) override;
    void tell(const Message& message) override;
    std::optional<PickedValue> picked() const override;
    void forgetPicked() override;
    bool holdsLogarithms() const override;
    ValueFacts valueFacts() const override;
    bool showsIsovalues() const override;

private:
    const ParameterValues& defaults() const;

    Workbench& workbench_;
    Session& session_;
    QPointer<ValuePick> pick_; ///< goes with the window
    std::string type_;
    mutable ParameterValues given_; ///< what value() gave last
    mutable std::optional<ParameterValues> defaults_;
    mutable std::string defaultsOf_; ///< the mode
};

} // namespace tetra
