// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/view.h>

#include <QSize>
#include <QWidget>

#include <array>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QSpinBox;

namespace tetra {

/// How a picture or the frames of a film are to be.
struct PictureSettings {
    QSize size;          ///< pixels
    int dotsPerInch = 0; ///< 0: none is told
    bool transparent = false;
    AnnotationState annotations;
};

/// Whether a picture may be printed, and says at which resolution.
enum class PictureUse { Print, Screen };

/// Asks for the size, the background and the annotations of pictures. Width and height follow each other unless the
/// user lets them go. What was chosen last is remembered. Its controls are NAME.preset, .width, .height,
/// .keepProportions, .transparent, .annotation.ID, and for print .printWidth, .printHeight and .dpi.
class PictureForm : public QWidget {
    Q_OBJECT
public:
    /// `name` is also where in the settings it remembers.
    explicit PictureForm(const QString& name, PictureUse use = PictureUse::Print, QWidget* parent = nullptr);

    /// The size of the view, in pixels of the screen, and its annotations: what is seen is what is offered first.
    void setView(QSize pixels, const AnnotationState& annotations);
    PictureSettings settings() const;
    void remember() const;

signals:
    void changed();

private:
    void addSize(QFormLayout& form);
    void addPrint(QFormLayout& form);
    void addBackground(QFormLayout& form);
    void addAnnotations(QFormLayout& form);
    void choosePreset();
    void keepProportions(QSpinBox& edited);
    void choosePixels(QSpinBox& edited);
    void showPrintSize();
    void choosePrintSize(QDoubleSpinBox& edited);
    void chooseResolution();

    QSize view_{1024, 768};
    AnnotationState annotations_;
    QComboBox* preset_;
    QSpinBox* width_;
    QSpinBox* height_;
    QCheckBox* keepProportions_;
    double widthPerHeight_ = 1; ///< that is kept
    QSpinBox* dpi_ = nullptr;   ///< for print only, as are the next three
    QDoubleSpinBox* printWidth_ = nullptr;
    QDoubleSpinBox* printHeight_ = nullptr;
    bool keepsPrintSize_ = false; ///< the size was chosen in centimetres: another resolution changes the pixels
    QCheckBox* transparent_;
    std::array<QCheckBox*, annotationCount> shown_{};
};

} // namespace tetra
