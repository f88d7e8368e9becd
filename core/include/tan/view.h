// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// tan/view.h: how a model is looked at, all of it, as a value; the mesh that a view asks for, its film, and its text.
///
/// A ViewValue says which mesh of a model is seen, how it is drawn, from where, what is written over the picture, and
/// which film is made of it. It is for any model: corrected() brings its query to one. All here are values, and
/// functions without side effects: any thread may call them.
///
/// ~~~{.cpp}
/// /// A view as a text: of a mesh of 2 %, finer in a ball, with one surface, seen from high above.
/// std::string viewOfBall(const tetra::Model& model, const tetra::Sphere& ball, double isovalue)
/// {
///     tetra::ViewValue view;
///     view.query = tetra::startingQuery(model, 2);
///     view.query.focus.shape = tetra::FocusState::Shape::Sphere;
///     view.query.focus = view.query.focus.movedTo(ball);
///     tetra::Isovalue surface;
///     surface.value = isovalue;
///     view.isovalues = {surface};
///     view.camera.elevation = 60;
///     view.camera = tetra::fitted(view.camera, model.description().bounds);
///     return tetra::viewToText(view);
/// }
///
/// /// The mesh that a view shows of a model.
/// tetra::Result<std::shared_ptr<const tetra::ExtractedMesh>> meshInView(std::string_view text,
///                                                                       std::shared_ptr<const tetra::Model> model)
/// {
///     const auto view = tetra::viewFromText(text);
///     if (!view)
///         return view.error();
///     const tetra::QueryState query = tetra::corrected(view->query, tetra::startingQuery(*model, 1), *model);
///     const tetra::MeshQuery asked = tetra::meshQuery(query, *model, tetra::presentView(*view));
///     return tetra::MeshExtractor(std::move(model)).extract(asked);
/// }
/// ~~~

#include <tan/base.h>
#include <tan/data.h>
#include <tan/mesh.h>
#include <tan/model.h>
#include <tan/parameter.h>
#include <tan/query.h>
#include <tan/render.h>
#include <tan/transfer.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tetra {

/// How the warping of curvilinear and irregular data is limited beside the error (C1).
enum class WarpingLimit { AsError, Own, None };
struct TAN_API WarpingChoice {
    WarpingLimit limit = WarpingLimit::AsError;
    double percent = 1; ///< of the diagonal, if Own
    bool operator==(const WarpingChoice&) const = default;

    /// This error in % of the value range, and the warping by it or as chosen.
    Accuracy with(double error) const;
};

/// A region that can be moved about in the picture.
using MovableRegion = std::variant<Box, Sphere>;

/// Where the mesh is to be more accurate than elsewhere (R25, C3): in regions; near the viewer; near the isovalues that
/// are shown; or where the transfer function is opaque. Both shapes of regions keep their size while another one is in
/// use. Lengths in the units of the dataset.
struct TAN_API FocusState {
    enum class Shape { None, Box, Sphere, View, Isovalues, Opacity };
    Shape shape = Shape::None;
    Eigen::Vector3d centre{0, 0, 0};
    Eigen::Vector3d size{0, 0, 0};       ///< lengths of the box's edges
    double radius = 0;                   ///< of the sphere
    double error = 0.5;                  ///< inside, %; see focusErrorOf()
    double falloff = 0;                  ///< the length over which the error grows to that outside
    double distance = 0;                 ///< View: that length, from the part of the domain that is nearest to the eye
    double valueFalloff = 0;             ///< Isovalues: the same in units of the values
    std::vector<MovableRegion> others{}; ///< further regions of the same error and fall-off ...
    std::uint32_t number = 0;            ///< ... among which the one above has this number
    bool operator==(const FocusState&) const = default;

    bool isOn() const noexcept { return shape != Shape::None; }
    bool isRegion() const noexcept { return shape == Shape::Box || shape == Shape::Sphere; }
    /// All regions, in the order of their numbers; of other shapes none.
    std::vector<MovableRegion> regions() const;
    /// Another one of them in place of the one above.
    FocusState selected(std::uint32_t other) const;
    /// With a further region, beside the one above, which it then is.
    FocusState added() const;
    /// Without the one above; without any if it was the last.
    FocusState removed() const;
    /// The box if there is none.
    MovableRegion region() const;
    /// Moved and sized as `region`; its shape does not change.
    FocusState movedTo(const MovableRegion& region) const;
};

/// The most regions of a focus.
inline constexpr std::size_t mostFocusRegions = 16;

/// The part of the domain that is shown (S17).
struct WindowState {
    bool enabled = false;
    Window window;
    bool operator==(const WindowState&) const = default;
};

/// The values that are shown.
struct ValueFilter {
    bool enabled = false;
    double least = 0;
    double largest = 0;
    bool operator==(const ValueFilter&) const = default;
};

/// Tetrahedra of many meshes in place of one (R14, C2): what lived between two errors. Errors in %; 100 is no limit.
struct RangeState {
    bool enabled = false;
    double fine = 1; ///< the ends
    double coarse = 10;
    double bornAbove = 0; ///< of these, only what is born at such errors ...
    double bornTo = 100;
    double diedFrom = 0; ///< ... and is replaced at such
    double diedTo = 100;
    bool operator==(const RangeState&) const = default;
};

/// The regions that a query can have.
enum class RegionKind { None, Focus, Window };

/// Which mesh of a model is seen: a value. Percentages are of the value range, those of warpings of the diagonal.
struct TAN_API QueryState {
    double error = 1; ///< %; with a focus that outside of it
    bool byBudget = false;
    std::uint64_t budget = 300'000; ///< tetrahedra, if byBudget: then the errors say how they relate to each other
    FocusState focus;
    WindowState window;
    ValueFilter values;
    WarpingChoice warping{};
    RangeState range{}; ///< in place of error, budget and focus
    bool operator==(const QueryState&) const = default;

    /// Whether the mesh is a prefix of the model's sites and all of it, so that its size is known beforehand.
    bool isUniform() const noexcept { return !focus.isOn() && !window.enabled && !values.enabled && !range.enabled; }
    bool has(RegionKind kind) const noexcept;
    /// Where the region is, or would be.
    MovableRegion place(RegionKind kind) const;
    QueryState moved(RegionKind kind, const MovableRegion& place) const;
    QueryState without(RegionKind kind) const;
};

/// An error (%) to begin with: 1 % if its mesh is quick to extract and to draw. Else the most accurate round number
/// from 2 % upwards whose mesh can still be worked with: what a coarser one shows is more often its error than the
/// data. Where the domain has a shape of its own, which a mesh simplifies as well, the error is as small as 0.1 % if
/// that mesh is small. A few meshSizeAt().
TAN_API double startingError(const Model& model);

/// Focus, window and values as they are offered at first, all off: in the middle of the domain, a quarter of its
/// extent.
TAN_API QueryState startingQuery(const Model& model, double error);

/// Finite, within the domain and the range of the values, with sizes that can be seen; what is not a number is as it
/// was `before`.
TAN_API QueryState corrected(QueryState query, const QueryState& before, const Model& model);

/// The error inside the focus: as chosen, but never more than outside, so that a focus is not coarser than what is
/// around it.
TAN_API double focusErrorOf(const QueryState& query);

/// What to ask the model for; what the accuracy varies with is taken from `present`. By budget the errors keep their
/// proportion, but are smaller than the budget can allow, so that it makes them larger and is used up.
TAN_API MeshQuery meshQuery(const QueryState& query, const Model& model, const PresentView& present = {});

/// The error that a uniform mesh reaches with at most so many tetrahedra, in %: known without extracting it.
TAN_API double errorWithin(const Model& model, std::uint64_t budget);

/// The uniform mesh that the query asks for, known without extracting it; of a query that is not uniform the mesh of
/// the error outside the focus, without window and values.
TAN_API MeshSize plannedSize(const QueryState& query, const Model& model);

/// How a mesh is drawn (R27), apart from isovalues and camera: a value. All but the mode is shared by the modes, so
/// that it stays when another one takes over.
struct Appearance {
    std::string mode{}; ///< id of a renderer plugin
    TransferFunction transfer{};
    ParameterValues settings{}; ///< of the renderers' other parameters
    bool operator==(const Appearance&) const = default;
};

/// What can be written over a picture.
enum class AnnotationKind { ColourBar, Axes, ScaleBar, Title, Accuracy, BoxAxes };
inline constexpr std::size_t annotationCount = 6;
/// As files and object names call them, in the order of AnnotationKind.
inline constexpr std::array<const char*, annotationCount> annotationNames{"colourBar", "axes",     "scaleBar",
                                                                          "title",     "accuracy", "boxAxes"};
/// Whether it stands in a corner of the picture: the axes with numbers lie along the edges of the data's box.
constexpr bool isInCorner(AnnotationKind kind)
{
    return kind != AnnotationKind::BoxAxes;
}

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
TAN_API bool isUsable(const BarEnds& ends);

/// How the numbers of an annotation are written.
struct NumberFormat {
    enum class Style { Automatic, Plain, Powers };
    Style style = Style::Automatic; ///< as each needs it; plain; or in powers of ten
    int decimals = 2;               ///< behind the decimal point, 0 to mostDecimals, unless it is automatic
    bool operator==(const NumberFormat&) const = default;
};
inline constexpr int mostDecimals = 12;
/// As files call them, in the order of NumberFormat::Style.
inline constexpr std::array<const char*, 3> numberStyleNames{"automatic", "plain", "powers"};

/// How large the texts of annotations are, in the units of the picture; all else about them grows alike.
inline constexpr double usualTextSize = 12;
inline constexpr double smallestTextSize = 6;
inline constexpr double largestTextSize = 48;

/// Which annotations are shown, and in which corner of the picture: a value. Texts are UTF-8.
struct AnnotationState {
    std::array<AnnotationPlace, annotationCount> places{{{true, Corner::TopRight},
                                                         {true, Corner::BottomLeft},
                                                         {false, Corner::BottomRight},
                                                         {false, Corner::TopLeft},
                                                         {false, Corner::TopLeft},
                                                         {false, Corner::TopLeft}}};
    std::optional<BarEnds> barEnds{}; ///< usable ones; none: those of the data's values
    std::string title{};              ///< empty: the model's name
    std::string quantity{};           ///< what the colour bar shows; empty: the name of the data's values
    std::string unit{};               ///< of that, in brackets behind it; empty: that of the data
    NumberFormat numbers{};           ///< of the colour bar
    NumberFormat lengths{};           ///< of the scale bar and of the axes with numbers
    double textSize = usualTextSize;  ///< within its limits
    bool boldText = false;            ///< all of it, not the title alone
    bool operator==(const AnnotationState&) const = default;

    AnnotationPlace& operator[](AnnotationKind kind) { return places[static_cast<std::size_t>(kind)]; }
    const AnnotationPlace& operator[](AnnotationKind kind) const { return places[static_cast<std::size_t>(kind)]; }
};

/// A lens over the picture (C5; "magnify" in 5.1 of the paper): what lies under its middle, enlarged, and of a mesh
/// that is finer there. It lies in the picture, not in space: the camera moves beneath it.
struct LensState {
    enum class Shape { None, Circle, Square };
    Shape shape = Shape::None;
    double x = 0.5;           ///< of the middle, as a share of the picture's width from the left ...
    double y = 0.5;           ///< ... and of its height from above
    double radius = 0.25;     ///< half of a side, as a share of the picture's shorter side
    double magnification = 3; ///< as far as the enlarged picture is none that back ends refuse
    double error = 0.25;      ///< of the mesh in it, % of the value range, where that is smaller than outside
    bool operator==(const LensState&) const = default;

    bool isOn() const noexcept { return shape != Shape::None; }
};

inline constexpr std::array<const char*, 3> lensShapeNames{"none", "circle", "square"};
inline constexpr double leastMagnification = 1;
inline constexpr double largestMagnification = 16;
inline constexpr double leastLensRadius = 0.05;
inline constexpr double largestLensRadius = 0.5;

/// Within these limits and within the picture; what is not a number is as it was `before`.
TAN_API LensState corrected(LensState lens, const LensState& before);

/// What the tools of plugins keep in a view, each by the id of its plugin: texts that they alone understand, not large,
/// as each step of undo keeps them. They stay whether or not the plugin is there.
using ToolValues = std::map<std::string, std::string>;

/// What of a view can move in a film.
struct FilmFrame {
    Camera camera;
    TransferFunction transfer;
    std::vector<Isovalue> isovalues;
    double error = 1; ///< as in QueryState, with the next two
    bool byBudget = false;
    std::uint64_t budget = 300'000;
    bool operator==(const FilmFrame&) const = default;
};

struct KeyFrame {
    double time = 0; ///< seconds
    FilmFrame frame;
    bool operator==(const KeyFrame&) const = default;
};

/// A film of the camera moving around its target.
struct Turntable {
    /// Round the up axis; or up and down, around the horizontal one, and back: the camera does not go over a pole,
    /// where what is seen would turn upside down.
    enum class Axis { Vertical, Horizontal };
    Axis axis = Axis::Vertical;
    double degrees = 360; ///< to turn by; up and down: from the lowest to the highest place
    int frames = 120;
    bool operator==(const Turntable&) const = default;
};

/// A film of the model: a value. Frames are numbered from 0.
struct Animation {
    enum class Kind { Turntable, KeyFrames };
    Kind kind = Kind::Turntable;
    double framesPerSecond = 30;
    Turntable turntable;
    std::vector<KeyFrame> keys; ///< in the order of their times, which differ by leastKeyDistance or more
    bool operator==(const Animation&) const = default;
};

inline constexpr int mostFrames = 100'000;
inline constexpr double leastKeyDistance = 0.01; ///< seconds
inline constexpr double longestFilm = 3600;      ///< seconds

/// None for fewer than two keys.
TAN_API int frameCount(const Animation& animation);
/// Seconds.
TAN_API double durationOf(const Animation& animation);
/// What the frame shows; `start` is the present view, from which a turntable starts. Cameras go a smooth path, values
/// are linear between their keys. O(keys).
TAN_API FilmFrame frameOf(const Animation& animation, const FilmFrame& start, int frame);

/// With numbers in their ranges, keys in order and apart.
TAN_API Animation corrected(Animation animation);
/// With a key after the last one, a usual time later; the first is at zero.
TAN_API Animation withKey(Animation animation, const FilmFrame& frame);

struct Bookmark;

/// How a model is looked at, all of it: a value. TAn's window makes its changes undoable, sessions keep it, pictures
/// and films are made of it.
struct ViewValue {
    QueryState query{};      ///< which mesh of the model
    Appearance appearance{}; ///< how that is drawn
    std::vector<Isovalue> isovalues{};
    AnnotationState annotations{}; ///< what is written over the picture
    Animation animation{};         ///< the film
    Camera camera{};
    std::optional<Colour> background{}; ///< none: the one that fits the desktop's colours
    LensState lens{};                   ///< over the picture
    ToolValues tools{};                 ///< an empty text is as good as none, and is not kept
    std::vector<Bookmark> bookmarks{};  ///< other views of the model, which are kept beside this one
    bool operator==(const ViewValue&) const = default;
};

/// A view with a name, to come back to. It has neither a film nor bookmarks of its own.
struct Bookmark {
    std::string name; ///< UTF-8, not empty
    ViewValue view;
    bool operator==(const Bookmark&) const = default;
};

inline constexpr std::size_t mostBookmarks = 100;

/// With a bookmark of what is seen, in the place of the one of that name if there is one, else behind the others; the
/// same if there are too many already.
TAN_API ViewValue withBookmark(ViewValue view, const std::string& name);
/// What the bookmark shows, with the film and the bookmarks of `view`.
TAN_API ViewValue atBookmark(const ViewValue& view, const Bookmark& bookmark);

/// The parts of a view that edits tell apart.
enum class ViewPart : std::uint32_t {
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
    Tools = 1024,
    Bookmarks = 2048,
    Appearance = Mode | Transfer | Settings,
    Scene = Query | Appearance | Isovalues, ///< what the scene is made of
};

/// A set of parts: true unless it is empty.
class ViewParts {
public:
    constexpr ViewParts() = default;
    constexpr ViewParts(ViewPart part) // NOLINT(google-explicit-constructor): a part is a set of one
        : bits_(static_cast<std::uint32_t>(part))
    {
    }
    constexpr explicit operator bool() const noexcept { return bits_ != 0; }
    constexpr bool operator==(const ViewParts&) const = default;

    constexpr ViewParts& operator|=(ViewParts others) noexcept
    {
        bits_ |= others.bits_;
        return *this;
    }
    constexpr ViewParts& operator&=(ViewParts others) noexcept
    {
        bits_ &= others.bits_;
        return *this;
    }
    constexpr ViewParts operator~() const noexcept
    {
        ViewParts others;
        others.bits_ = ~bits_;
        return others;
    }

private:
    std::uint32_t bits_ = 0;
};
constexpr ViewParts operator|(ViewParts one, ViewParts other) noexcept
{
    return one |= other;
}
constexpr ViewParts operator&(ViewParts one, ViewParts other) noexcept
{
    return one &= other;
}
constexpr ViewParts operator|(ViewPart one, ViewPart other) noexcept
{
    return ViewParts(one) | ViewParts(other);
}
constexpr ViewParts operator&(ViewPart one, ViewPart other) noexcept
{
    return ViewParts(one) & ViewParts(other);
}

TAN_API ViewParts differingParts(const ViewValue& one, const ViewValue& other);

/// What of a view error fields can depend on: where the eye is, the isovalues that are shown, and the opacities.
TAN_API PresentView presentView(const ViewValue& view);

/// What of a view can move in a film.
TAN_API FilmFrame frameOf(const ViewValue& view);
/// The view with what a frame of a film shows.
TAN_API ViewValue withFrame(ViewValue view, const FilmFrame& frame);
/// What is seen at a frame of the view's film; a turntable starts from the view.
TAN_API ViewValue viewAtFrame(const ViewValue& view, int frame);

/// A view as a JSON text, the one form that sessions, views that are kept, and pictures have of it:
///
///     {"mesh": {"error": 1, "focus": {...}, ...}, "look": {"mode": "volume", "transfer": {...}, "settings": {...}},
///      "isovalues": [...], "annotations": {"axes": {"shown": true, "corner": "bottomLeft"}, ...,
///      "titleText": "Skull", "quantity": "Density", "unit": "HU", "numbers": {"style": "plain", "decimals": 1},
///      "lengths": {"style": "plain", "decimals": 0}, "textSize": 16, "boldText": true},
///      "animation": {...}, "camera": {...}, "background": [0, 0, 0.5],
///      "lens": {"shape": "circle", "x": 0.5, "y": 0.5, "radius": 0.25, "magnification": 3, "error": 0.25},
///      "tools": {"ruler": "..."}, "views": [{"name": "From the left", "mesh": {...}, ...}]}
///
/// Cameras and transfer functions are in the forms that their own files have. Settings keep their type:
/// {"integer": 3}, {"number": 0.5}, true, "text". A background that nobody chose is left out, and so are tools that
/// keep nothing, and "views", the bookmarks, if there are none. Members are in the order of their names, numbers the
/// shortest that are read as the same again, whatever the locale. Of annotations, texts that are those of the data and
/// how numbers and texts look are left out where they are as usual.
TAN_API std::string viewToText(const ViewValue& view);

/// What the text leaves open is as in `usual`; of a camera, what fits a box of side 1. Members that are not known are
/// passed over: newer programs write them, and a session is the text of its view, too. Numbers are as they are written:
/// corrected() brings those of a query to a model. Errors (BadInput): no JSON, or a member of another type, which is
/// named ("mesh.focus.radius").
TAN_API Result<ViewValue> viewFromText(std::string_view text, const ViewValue& usual = {});

} // namespace tetra
