// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/parameter.h"

#include <QWidget>

#include <functional>
#include <map>

class QFormLayout;
class QLineEdit;

namespace tetra {

/// A value of a parameter as the user chooses it, in words.
struct ParameterChoice {
    ParameterValue value;
    QString label;
};
using ParameterChoices = std::map<std::string, std::vector<ParameterChoice>>; ///< by the parameter's id

/// A form made of parameter descriptions: a control fitting its type for each, named PREFIX.ID. Parameters that have
/// a panel or an editor of their own (isovalues, transfer functions, values of plugins' own types) are left out.
class ParameterForm : public QWidget {
    Q_OBJECT
public:
    explicit ParameterForm(const QString& prefix, QWidget* parent = nullptr);

    /// Begins anew, with the defaults. A parameter that has choices here is one of them, whatever its type.
    void setParameters(const std::vector<Parameter>& parameters, const ParameterChoices& choices = {});
    /// What the conditions of parameters may ask for beside the parameters. Those that do not matter are not shown.
    void setSurroundings(const ParameterValues& surroundings);
    ParameterValues values() const;
    /// Those of them that are shown.
    ParameterValues matteringValues() const;
    /// Shown in a line as long as it is empty: how its text is written.
    void setExample(const std::string& id, const QString& example);
    /// Of one; false if there is none.
    ParameterValue value(const std::string& id) const;
    /// Shows these; what is missing or of another type has its default. Tells nobody.
    void setValues(const ParameterValues& values);
    bool isEmpty() const noexcept { return fields_.empty(); }

signals:
    /// By the user, to something that can be used.
    void edited(const QString& id);

private:
    struct Field {
        Parameter parameter;
        QWidget* widget = nullptr;
        std::function<ParameterValue()> value;
        std::function<void(const ParameterValue&)> show;
    };
    void add(const Parameter& parameter, const std::vector<ParameterChoice>& choices);
    void tellEdits(const Parameter& parameter, QWidget* widget);
    void showMattering();
    void tellMistakes(QLineEdit& line, const Parameter& parameter);

    QString prefix_;
    QFormLayout* layout_;
    std::vector<Field> fields_;
    ParameterValues surroundings_;
};

} // namespace tetra
