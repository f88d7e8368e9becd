// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/parameter.h"

#include <QWidget>

#include <functional>

class QFormLayout;
class QLineEdit;

namespace tetra {

/// A form made of parameter descriptions: a control fitting its type for each, named PREFIX.ID. Parameters that a form
/// cannot hold (lists of isovalues) are left out.
class ParameterForm : public QWidget {
    Q_OBJECT
public:
    explicit ParameterForm(const QString& prefix, QWidget* parent = nullptr);

    /// Begins anew, with the defaults.
    void setParameters(const std::vector<Parameter>& parameters);
    ParameterValues values() const;
    bool isEmpty() const noexcept { return fields_.empty(); }

private:
    struct Field {
        std::string id;
        std::function<ParameterValue()> value;
    };
    void add(const Parameter& parameter);
    void tellMistakes(QLineEdit& line, const Parameter& parameter);

    QString prefix_;
    QFormLayout* layout_;
    std::vector<Field> fields_;
};

} // namespace tetra
