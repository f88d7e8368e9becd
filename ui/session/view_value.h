// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/animation/animation.h"
#include "ui/session/appearance.h"
#include "ui/session/lens.h"
#include "ui/session/query_state.h"

#include <QFlags>

#include <array>
#include <cstddef>
#include <optional>
#include <variant>

namespace tetra {

/// What can be written over a picture.
enum class AnnotationKind { ColourBar, Axes, ScaleBar, Title, Accuracy };
inline constexpr std::size_t annotationCount = 5;
/// As files and object names call them, in the order of AnnotationKind.
inline constexpr std::array<const char*, annotationCount> annotationNames{"colourBar", "axes", "scaleBar", "title",
                                                                          "accuracy"};

enum class Corner { TopLeft, TopRight, BottomLeft, BottomRight };
inline constexpr std::array<const char*, 4> cornerNames{"topLeft", "topRight", "bottomLeft", "bottomRight"};

struct AnnotationPlace {
    bool shown = false;
    Corner corner = Corner::TopLeft;
    bool operator==(const AnnotationPlace&) const = default;
};

/// Values at the ends of the colour bar.
struct BarEnds {
    double least = 0;
    double largest = 1;
    bool operator==(const BarEnds&) const = default;
};

/// Whether a bar can go from one to the other: two finite numbers, in their order.
bool isUsable(const BarEnds& ends);

/// Which annotations are shown, and in which corner of the picture: a value.
struct AnnotationState {
    std::array<AnnotationPlace, annotationCount> places{{{true, Corner::TopRight},
                                                         {true, Corner::BottomLeft},
                                                         {false, Corner::BottomRight},
                                                         {false, Corner::TopLeft},
                                                         {false, Corner::TopLeft}}};
    std::optional<BarEnds> barEnds{}; ///< usable ones; none: those of the data's values
    bool operator==(const AnnotationState&) const = default;

    AnnotationPlace& operator[](AnnotationKind kind) { return places[static_cast<std::size_t>(kind)]; }
    const AnnotationPlace& operator[](AnnotationKind kind) const { return places[static_cast<std::size_t>(kind)]; }
};

/// How a model is looked at, all of it: a value. Session shows it and makes its changes undoable, files keep it
/// (view_json.h), pictures and films are made of it (view_picture.h).
struct ViewValue {
    QueryState query{};      ///< which mesh of the model
    Appearance appearance{}; ///< how that is drawn
    std::vector<Isovalue> isovalues{};
    AnnotationState annotations{}; ///< what is written over the picture
    Animation animation{};         ///< the film
    Camera camera{};
    std::optional<Colour> background{}; ///< none: the one that fits the desktop's colours
    LensState lens{};                   ///< over the picture
    bool operator==(const ViewValue&) const = default;
};

/// The parts of a view that edits tell apart.
enum class ViewPart {
    Query = 1,
    Mode = 2,
    Transfer = 4,
    Settings = 8,
    Isovalues = 16,
    Annotations = 32,
    Animation = 64,
    Camera = 128,
    Background = 256,
    Lens = 512,
    Appearance = Mode | Transfer | Settings,
    Scene = Query | Appearance | Isovalues, ///< what the scene is made of
};
Q_DECLARE_FLAGS(ViewParts, ViewPart)
Q_DECLARE_OPERATORS_FOR_FLAGS(ViewParts)

ViewParts differingParts(const ViewValue& one, const ViewValue& other);

/// Some parts of a view, and no more: what a long history of edits keeps of each.
class PartialView {
public:
    PartialView(const ViewValue& view, ViewParts parts);
    ViewValue putInto(ViewValue view) const;
    ViewParts parts() const;
    /// Adds the parts of `others` that it lacks.
    void complete(const PartialView& others);
    bool operator==(const PartialView&) const = default;

private:
    /// Each part is of a type of its own, in the order of ViewPart.
    using Part = std::variant<QueryState, std::string, TransferFunction, ParameterValues, std::vector<Isovalue>,
                              AnnotationState, Animation, Camera, std::optional<Colour>, LensState>;
    std::vector<Part> parts_; ///< in that order
};

/// What of a view error fields can depend on: where the eye is, the isovalues that are shown, and the opacities.
PresentView presentView(const ViewValue& view);

/// What of a view can move in a film.
FilmFrame frameOf(const ViewValue& view);
/// The view with what a frame of a film shows.
ViewValue withFrame(ViewValue view, const FilmFrame& frame);
/// What is seen at a frame of the view's film; a turntable starts from the view.
ViewValue viewAtFrame(const ViewValue& view, int frame);

} // namespace tetra
