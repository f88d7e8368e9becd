// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/data/value_scale.h"

#include <QWidget>

#include <optional>

class QComboBox;
class QLineEdit;

namespace tetra {

/// Whether the values of a dataset are taken as they are or as their logarithms, and with these what smaller values are
/// taken as. Its fields are named NAME and NAME.from.
class ScaleInput : public QWidget {
    Q_OBJECT
public:
    explicit ScaleInput(const QString& name, QWidget* parent = nullptr);

    /// Shows it; tells nobody.
    void setScale(const ValueScale& scale);
    /// Nothing while what is typed is no positive number.
    std::optional<ValueScale> scale() const;

signals:
    /// By the user.
    void edited();

private:
    QComboBox* kind_;
    QLineEdit* from_;
};

} // namespace tetra
