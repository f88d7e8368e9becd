// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/accuracy_scale.h"

#include <tan/data.h>
#include <tan/model.h>
#include <tan/query.h>

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

namespace tetra {

/// A region that can be moved about in the picture.
using MovableRegion = std::variant<Box, Sphere>;

/// Where the mesh is to be more accurate than elsewhere (R25, C3): in regions; near the viewer; near the isovalues that
/// are shown; or where the transfer function is opaque. Both shapes of regions keep their size while another one is in
/// use.
struct FocusState {
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

/// The most regions of a focus.
inline constexpr std::size_t mostFocusRegions = 16;

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
struct QueryState {
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

/// Focus, window and values as they are offered at first, all off: in the middle of the domain, a quarter of its
/// extent.
QueryState startingQuery(const Model& model, double error);

/// Finite, within the domain and the range of the values, with sizes that can be seen; what is not a number is as it
/// was `before`.
QueryState corrected(QueryState query, const QueryState& before, const Model& model);

/// The error inside the focus: as chosen, but never more than outside, so that a focus is not coarser than what is
/// around it.
double focusErrorOf(const QueryState& query);

/// What to ask the model for; what the accuracy varies with is taken from `present`. By budget the errors keep their
/// proportion, but are smaller than the budget can allow, so that it makes them larger and is used up.
MeshQuery meshQuery(const QueryState& query, const Model& model, const PresentView& present = {});

/// The error that a uniform mesh reaches with at most so many tetrahedra, in %: known without extracting it.
double errorWithin(const Model& model, std::uint64_t budget);

/// The uniform mesh that the query asks for, known without extracting it; of a query that is not uniform the mesh of
/// the error outside the focus, without window and values.
MeshSize plannedSize(const QueryState& query, const Model& model);

/// A round number of tetrahedra, larger (steps > 0) or smaller.
std::uint64_t steppedBudget(std::uint64_t budget, int steps);

} // namespace tetra
