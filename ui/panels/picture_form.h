// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/view_value.h"

#include <QSize>
#include <QWidget>

#include <array>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QSpinBox;

namespace tetra {

/// How a picture or the frames of a film are to be.
struct PictureSettings {
    QSize size; ///< pixels
    int dotsPerInch = 0;
    bool transparent = false;
    AnnotationState annotations;
};

/// Asks for the size, the background and the annotations of pictures. What was chosen last is remembered. Its controls
/// are NAME.preset, .width, .height, .dpi, .printSize, .transparent and .annotation.ID.
class PictureForm : public QWidget {
    Q_OBJECT
public:
    /// `name` is also where in the settings it remembers.
    explicit PictureForm(const QString& name, QWidget* parent = nullptr);

    /// The size of the view, in pixels of the screen, and its annotations: what is seen is what is offered first.
    void setView(QSize pixels, const AnnotationState& annotations);
    PictureSettings settings() const;
    void remember() const;

signals:
    void changed();

private:
    void addSize(QFormLayout& form);
    void addAnnotations(QFormLayout& form);
    void choosePreset();
    void showPrintSize();

    QSize view_{1024, 768};
    AnnotationState annotations_;
    QComboBox* preset_;
    QSpinBox* width_;
    QSpinBox* height_;
    QSpinBox* dpi_;
    QLabel* printSize_;
    QCheckBox* transparent_;
    std::array<QCheckBox*, annotationCount> shown_{};
};

} // namespace tetra
