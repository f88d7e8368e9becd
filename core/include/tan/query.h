// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// tan/query.h: meshes out of a model, each with a known error.
///
/// A MeshQuery says how accurate the mesh has to be, everywhere or by place and value, how large it may become, and
/// what part of it is wanted. A MeshExtractor answers query after query to one model.
///
/// ~~~{.cpp}
/// /// The mesh of a model whose error is nowhere above 1 % of the value range.
/// tetra::Result<std::shared_ptr<const tetra::ExtractedMesh>>
/// meshOfOnePercent(std::shared_ptr<const tetra::Model> model)
/// {
///     tetra::MeshQuery query;
///     query.error = 1;
///     return tetra::MeshExtractor(std::move(model)).extract(query);
/// }
///
/// /// Fine in a ball, 0.2 %, coarse elsewhere, 5 %; the whole mesh has at most 100,000 tetrahedra.
/// tetra::MeshQuery ballInFocus(const Eigen::Vector3d& centre, double radius)
/// {
///     tetra::MeshQuery query;
///     query.error = tetra::SpaceRamp{tetra::Sphere{centre, radius}, 0.2, 5, radius};
///     query.budget = 100000;
///     return query;
/// }
///
/// /// How many tetrahedra of the coarsest mesh touch site 0, without memory for the mesh.
/// tetra::Result<int> tetrahedraAtFirstSite(const tetra::Model& model)
/// {
///     int count = 0;
///     const auto visit = [&](std::span<const std::array<std::uint32_t, 4>> tetrahedra) {
///         for (const auto& sites : tetrahedra)
///             count += std::ranges::count(sites, 0u) > 0;
///     };
///     const std::uint32_t coarsest = tetra::meshSizeAt(model, {tetra::anyError, tetra::anyWarping}).sites;
///     if (const tetra::Status visited = tetra::forEachTetrahedron(model, coarsest, visit); !visited)
///         return visited.error();
///     return count;
/// }
/// ~~~

#include <tan/base.h>
#include <tan/data.h>
#include <tan/mesh.h>
#include <tan/model.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tetra {

/// The largest error and the largest warping there can be: as a limit they demand nothing.
inline constexpr double anyError = 100;
inline constexpr double anyWarping = 100;

/// The accuracy pair of a query (R14, R7, C1), in the units that people see: two limits, each by itself. Convex models
/// have no warping.
struct Accuracy {
    double error = 0;            ///< % of the value range
    double warping = anyWarping; ///< % of the bounding box's diagonal
};

/// The size of a mesh, known without extracting it (R26).
struct MeshSize {
    std::uint32_t sites = 0;
    std::uint64_t tetrahedra = 0;
    /// Bounds, each by itself, in % of the value range and of the diagonal (0 without warping). In files that do not
    /// tell the two apart, what the running key of this mesh says of both.
    double error = 0;
    double warping = 0;
};

/// The first mesh at least as accurate as asked (first passage, S1), as a prefix of the sites: O(log sites), and where
/// the ratio of the two limits is not that of the build O(batches) besides. If the model is not that accurate, its most
/// accurate mesh, as a rule the whole. Of a damaged file the result is unspecified, and Model::checkIntact() says so
/// afterwards.
///
/// A history is ordered by the larger of error and weighted warping, so both fall together, and a prefix that keeps one
/// small limit keeps a small one of the other as well. A MeshExtractor finds smaller meshes for such pairs.
TAN_API MeshSize meshSizeAt(const Model& model, const Accuracy& accuracy);

/// The same for the mesh of the first `sites` sites, which end a batch.
TAN_API MeshSize meshSizeOf(const Model& model, std::uint32_t sites);

/// The finest uniform mesh that is no finer than asked and comes before the first one with more than `budget`
/// tetrahedra. Reads the sizes of the meshes up to there. Error: WrongUsage if even the coarsest mesh has more.
TAN_API Result<MeshSize> meshSizeWithin(const Model& model, const Accuracy& asked, std::uint64_t budget);

/// Extracts the mesh of the first `sites` sites (R14, R15): vertex v of the mesh is site v. The last of them must end
/// its group (Model::groupGoesOn()), as it does for every meshSizeAt(). Reads the prefix of the file that those sites
/// created and nothing else; O(tetrahedra that they created). The buffers of `reuse`, if any, are used again. Errors: a
/// damaged or inconsistent file, sites that have no mesh, cancelled.
TAN_API Result<TetrahedralMesh> extractPrefix(const Model& model, std::uint32_t sites, const Progress& progress = {},
                                              TetrahedralMesh reuse = {});

/// Calls `visit` with the tetrahedra of that same mesh, some thousand at a time in the order of the file, without
/// memory for all of them. Each has its four sites, all below `sites`, in the orientation that extractPrefix() gives;
/// Model::position() and Model::values() say where they lie and what they are worth. `visit` may copy from the span and
/// must not keep it. What was visited is a whole, sound mesh only if no error comes back. Errors: as extractPrefix().
TAN_API Status
forEachTetrahedron(const Model& model, std::uint32_t sites,
                   const std::function<void(std::span<const std::array<std::uint32_t, 4>> tetrahedra)>& visit,
                   const Progress& progress = {});

/// The sizes of a model's meshes at several accuracies, as a file for other programs: one line a level with a line of
/// names before it, numbers independent of the locale, errors and warpings in % of the value range and of the diagonal.
TAN_API std::string levelsAsCsv(const Model& model, std::span<const Accuracy> levels);

/// The same as one JSON object, with where the model is from: "model", "source", "builder", "sites", "tetrahedra",
/// "bytes", and "levels", a list of "error", "warping", "sites", "tetrahedra", "reached" and "reached_warping".
TAN_API std::string levelsAsJson(const Model& model, std::span<const Accuracy> levels);

/// CSV or JSON, as the ending of the file's name says; nothing is written. Errors: WrongUsage for any other ending.
TAN_API Result<std::string> levelsAsText(const std::filesystem::path& path, const Model& model,
                                         std::span<const Accuracy> levels);

/// The distance of a place from a region; 0 within.
TAN_API double distanceTo(const Region& region, const Eigen::Vector3d& place);

/// `inner` within the region, `outer` from `falloff` away, and linear in the distance between the two. A falloff of 0
/// is a sharp border.
struct SpaceRamp {
    Region region;
    double inner = 0;
    double outer = 0;
    double falloff = 0;
    bool operator==(const SpaceRamp&) const = default;
};

/// Linear between knots (value, error) of increasing value, constant before the first and after the last. Two knots of
/// one value are a step, at which the smaller error holds.
struct ValueRamp {
    std::vector<std::array<double, 2>> knots;
    bool operator==(const ValueRamp&) const = default;
};

/// How large the error of a mesh may be at a place where the data have a value (R25, B2): an expression in numbers,
/// ramps in space and ramps over values. In % of the value range, or of the diagonal if it is a warping that is
/// bounded. An immutable value, cheap to copy; safe to read from any number of threads.
class TAN_API ErrorField {
public:
    // Arguments are normalised: swapped corners of a box, normals (and their offsets) that are not of unit length,
    // knots that are not sorted. NaN counts as 0; knots whose value is NaN are dropped.

    /// The same everywhere.
    ErrorField(double percent = 0); // NOLINT(google-explicit-constructor): a number is a field
    ErrorField(SpaceRamp ramp);     // NOLINT(google-explicit-constructor)
    ErrorField(ValueRamp ramp);     // NOLINT(google-explicit-constructor)

    /// `inner` at the isovalues, `outer` from `falloff` (in units of the values, positive) away.
    static ErrorField nearValues(std::span<const double> isovalues, double inner, double outer, double falloff);
    /// `inner` where the opacity, given by knots (value, opacity in [0, 1]), is 1, `outer` where it is 0, linear
    /// between.
    static ErrorField byOpacity(std::span<const std::array<double, 2>> opacity, double inner, double outer);

    friend TAN_API ErrorField operator+(const ErrorField& first, const ErrorField& second);
    friend TAN_API ErrorField operator*(const ErrorField& first, const ErrorField& second);
    friend TAN_API ErrorField smallerOf(const ErrorField& first, const ErrorField& second);
    friend TAN_API ErrorField largerOf(const ErrorField& first, const ErrorField& second);

    /// Whether the field is a constant by construction, made of numbers alone; then bounds() gives the number, twice.
    bool isConstant() const noexcept;
    /// Whether it does not depend on the value, or not on the place.
    bool dependsOnValue() const noexcept;
    bool dependsOnPlace() const noexcept;
    /// The ramp, if the field is one in space and nothing else.
    const SpaceRamp* asSpaceRamp() const noexcept;

    /// Negative numbers count as 0, here and in what follows.
    double at(const Eigen::Vector3d& place, double value) const;
    /// Bounds on the field over all places and values (for a constant, the constant twice).
    ValueRange bounds() const;
    /// A lower bound of the field over the convex hull of the corners, extended by `margin`, for values in `values`.
    /// Tight for a single ramp in space of falloff 0 whose inner error is the smaller one: `outer` unless hull and
    /// region meet. O(1) for each ramp; the bounding box is looked at first.
    double leastIn(const std::array<Eigen::Vector3d, 4>& corners, double margin, const ValueRange& values) const;

    /// Equal by form.
    bool operator==(const ErrorField& other) const;

    struct Node; ///< of the expression; for its text form
    const Node& root() const noexcept { return *root_; }

private:
    explicit ErrorField(std::shared_ptr<const Node> root) : root_(std::move(root)) {}
    std::shared_ptr<const Node> root_;
};

enum class FieldOperation { Sum, Product, Smaller, Larger };
struct ErrorField::Node {
    struct Pair {
        FieldOperation operation;
        ErrorField first;
        ErrorField second;
        bool operator==(const Pair&) const = default;
    };
    std::variant<double, SpaceRamp, ValueRamp, Pair> content;
};

/// What of a picture error fields can depend on (C3).
struct PresentView {
    std::optional<Eigen::Vector3d> eye{};         ///< where the camera is
    std::vector<double> isovalues{};              ///< that are shown
    std::vector<std::array<double, 2>> opacity{}; ///< of the transfer function, as for ErrorField::byOpacity()
};

/// Error fields as text (B2), for command lines, sessions and fields of forms. A number is a field, and so are
///
///     box(x,y,z, X,Y,Z; inner, outer, falloff)           two opposite corners
///     sphere(x,y,z, radius; inner, outer, falloff)
///     halfspace(a,b,c, d; inner, outer, falloff)         a x + b y + c z <= d
///     camera(x,y,z; inner, outer, distance)              a sphere of radius 0: `outer` from that distance away
///     values(value:error, value:error, ...)              linear between
///     isovalues(value, value, ...; inner, outer, falloff)
///     opacity(value:opacity, ...; inner, outer)          the opacity of a transfer function
///     sum(a, b, ...)  product(a, b, ...)  min(a, b, ...)  max(a, b, ...)     of two fields or more
///
/// A falloff that is left out is 0: a sharp border. camera(; ...), isovalues(; ...) and opacity(; ...) without what
/// comes before the semicolon take it from `present`, if that has it. Blanks may stand between any two words or signs;
/// numbers have a decimal point under every locale, and "inf" is one. At most 1000 fields are combined, nested 100
/// deep. Errors (WrongUsage) name the place, counted in characters from 1, and what is expected there.
TAN_API Result<ErrorField> parseErrorField(std::string_view text, const PresentView& present = {});

/// The inverse of parseErrorField(), with the shortest numbers; isovalues() and opacity() become values(). The field
/// must be of finite regions, and of the size that can be parsed.
TAN_API std::string toText(const ErrorField& field);

/// What becomes of the tetrahedra at the border of a window (S17).
enum class WindowBorder {
    Intersecting, ///< all that have a point in common with the window: it is covered, the border is ragged
    Contained,    ///< only those that lie in it whole
    Clipped,      ///< the mesh cut off at the window: conforming, filling exactly what of the domain lies in it
};

struct Window {
    Box box;
    WindowBorder border = WindowBorder::Intersecting;
    bool operator==(const Window&) const = default;
};

/// How a mesh of varying accuracy is found, or of two limits in another ratio than the build's.
enum class VariableMethod {
    Automatic, ///< of the two, where both are possible, the one that is predicted to give the smaller mesh
    ClosedSet, ///< the smallest closed set of the history's sites: always right, tight for graded fields
    Insertion, ///< sites of the focus inserted into the coarse mesh, tight for a sharp focus: of regular and
               ///< curvilinear data, refined without weights, whose model holds all samples; else WrongUsage
};

/// When errors are scaled, for a budget or because the model ends, errors below this count as this: scaling 0 would
/// change nothing.
inline constexpr double leastScaledPercent = 0.001;

/// What a mesh of this scale (ExtractedMesh::scale) keeps where `asked` was asked for, in the same percent.
constexpr double keptPercent(double asked, double scale)
{
    return scale > 1 ? scale * (asked > leastScaledPercent ? asked : leastScaledPercent) : asked;
}

/// Tetrahedra of many meshes at once (R14): all that are alive in the mesh of some accuracy between two. They overlap,
/// so together they are no mesh, unless what is chosen of them is alive at one and the same error.
struct LifeRange {
    Accuracy one; ///< the ends, which belong to it, in any order
    Accuracy other;
    /// Of these only the ones that are born within and die within so many percent (R17), as ExtractedMesh::birthErrors
    /// and deathErrors: births.minimum < birth <= births.maximum, deaths.minimum <= death <= deaths.maximum. What is
    /// alive at an error e has births {e, infinity} and deaths {0, e}.
    ValueRange births{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    ValueRange deaths{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
};
TAN_API bool operator==(const LifeRange& first, const LifeRange& second);

/// A question to a model, as a value (R14, R17, R25, B1). Everything can be combined: accuracy or field or budget
/// choose a conforming mesh of the whole domain, or a range of accuracies many of them; then values and window choose
/// from the tetrahedra.
struct MeshQuery {
    ErrorField error = 0.0;          ///< at most this at each sample, % of the value range
    ErrorField warping = anyWarping; ///< likewise, % of the diagonal: curvilinear and irregular data only
    /// At most so many tetrahedra in the whole mesh: error and warping are multiplied by the smallest factor, at least
    /// 1, that satisfies it (keptPercent()), ramps as a whole. A budget only coarsens: to fill it, ask for a smaller
    /// error than it allows. With insertion the factor is approximate and may leave a tenth of the budget unused.
    std::optional<std::uint64_t> budget{};
    /// Only tetrahedra that can contain a value of one of these ranges, ends included. Empty: all.
    std::vector<ValueRange> values{};
    std::optional<Window> window{};
    VariableMethod method = VariableMethod::Automatic;
    /// In place of error, warping, budget and method. Goes with values, and with windows that do not cut: what is cut
    /// has no life of its own.
    std::optional<LifeRange> range{};
};

TAN_API bool operator==(const MeshQuery& first, const MeshQuery& second);

/// What a query gives. Immutable once it is handed out, as std::shared_ptr<const ExtractedMesh>.
struct ExtractedMesh {
    static constexpr std::uint32_t noSite = 0xffffffff;

    TetrahedralMesh mesh;
    /// The model's site that each vertex is; noSite for vertices made by clipping, and for points of the dataset that
    /// are no sites of the model.
    Buffer<std::uint32_t> sites;
    /// Empty, or for each vertex that is no site its point of the dataset; noSite for all others.
    Buffer<std::uint32_t> points;
    /// What was chosen before values and window.
    std::uint32_t wholeSites = 0;
    std::uint64_t wholeTetrahedra = 0;
    /// What of that is in the mesh, whole or in part: a tetrahedron that a window has cut into pieces counts once, and
    /// the vertices that cutting made do not.
    std::uint32_t keptSites = 0;
    std::uint64_t keptTetrahedra = 0;
    /// The mesh is known to keep keptPercent(asked, scale) everywhere: 1, or more if the budget did not allow it or the
    /// model has nothing finer.
    double scale = 1;
    /// The largest error and warping that the mesh really has anywhere, before values and window choose from it: bounds
    /// as the model tells them, at most what it keeps. Nothing where points were inserted, and of a range.
    std::optional<Accuracy> reached{};
    VariableMethod method = VariableMethod::ClosedSet; ///< that was used; a uniform mesh is a closed set, too
    /// Of a range of accuracies, for each tetrahedron: the error from which it lives and the one from which it does not
    /// any more, in % of the value range. It is in the mesh of an error e if death <= e < birth; the first ones have
    /// the birth infinity, the last ones the death 0. Empty for one mesh.
    Buffer<float> birthErrors{};
    Buffer<float> deathErrors{};
    /// Whether tetrahedra may lie over each other: no error is in the lives of all.
    bool overlaps = false;
};

/// The mesh alone, for what draws it or goes through it; it keeps the whole result.
inline std::shared_ptr<const TetrahedralMesh> meshOf(const std::shared_ptr<const ExtractedMesh>& extracted)
{
    return {extracted, &extracted->mesh};
}

/// WrongUsage, with what to change, for a query that makes no sense for the model: NaN, an inverted box or range, a
/// budget of zero, a method that cannot be used.
TAN_API Status checkQuery(const Model& model, const MeshQuery& query);

/// ExtractedMesh::scale of a uniform mesh.
TAN_API double scaleReached(const MeshSize& size, const Accuracy& asked);

/// A query with a focus as two queries of one resolution each, to be blended when they are drawn (R24), where the query
/// itself asks for one conforming mesh (R25).
struct TwoResolutions {
    MeshQuery outside;                ///< of the whole domain
    MeshQuery inside;                 ///< of a window that holds all that is nearer to a region than its border
    std::vector<FocusRegion> regions; ///< their borders are the falloffs

    bool operator==(const TwoResolutions&) const = default;
};

/// Nothing unless the error is a ramp around a box or a ball, or the smallest of several such ramps that are the same
/// far away; nor if there is a budget, which could not be divided between the two meshes.
TAN_API std::optional<TwoResolutions> twoResolutions(const MeshQuery& query);

/// Answers query after query to one model. Caches what variable queries need: positions and values of the sites, and
/// links of the part of the history that was visited, never more than 8 bytes a tetrahedron of that. A uniform mesh is
/// kept, too, and so are the tetrahedra of a range of accuracies, so that another window, other values or other lives
/// cost only the filter. Used from one thread at a time.
/// Results outlive it. If nobody else holds the last result, its memory is used again. With insertion, a mesh may hold
/// sites that an earlier, overlapping focus left: it keeps what was asked for, and is larger; a new extractor begins
/// afresh.
class TAN_API MeshExtractor {
public:
    explicit MeshExtractor(std::shared_ptr<const Model> model);
    ~MeshExtractor();
    MeshExtractor(MeshExtractor&&) noexcept;
    MeshExtractor& operator=(MeshExtractor&&) noexcept;

    const std::shared_ptr<const Model>& model() const noexcept;

    /// The mesh that the query asks for. Checks all that it reads of the file; of files older than format 1.3, call
    /// Model::confirm() before a result is published. O(tetrahedra created by the sites of the prefix) for a uniform
    /// mesh, O(part of the history that is visited) otherwise. Errors: WrongUsage (a query that makes no sense, or a
    /// budget that even the coarsest mesh exceeds, with what to change), a damaged file, out of memory, cancelled.
    /// After an error the next query starts afresh.
    Result<std::shared_ptr<const ExtractedMesh>> extract(const MeshQuery& query, const Progress& progress = {});

private:
    class Work;
    std::unique_ptr<Work> work_;
};

} // namespace tetra
