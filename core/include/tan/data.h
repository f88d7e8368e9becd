// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// tan/data.h: the dataset that a model is built from: points with one scalar each (the reference model, 2.3).
///
/// A dataset is a value: made once and not modified afterwards, cheap to copy, safe to read from any thread. The
/// library reads no files: TAn's readers are plugins, and a program that has its arrays in memory makes datasets of
/// them: latticeDataset(), curvilinearDataset(), scatteredDataset() and irregularDataset() check what they are given,
/// so that what they return can be relied on. A Dataset that is filled by hand is not checked.
///
/// ~~~{.cpp}
/// /// A ball in a box of 33 x 33 x 33 points, a tenth of a unit apart: the distance from the middle.
/// tetra::Result<tetra::Dataset> ball()
/// {
///     tetra::Lattice lattice;
///     lattice.size = {33, 33, 33};
///     lattice.spacing = {0.1, 0.1, 0.1};
///     const Eigen::Vector3d middle = lattice.bounds().center();
///     std::vector<float> samples(lattice.pointCount());
///     for (std::uint32_t k = 0; k < lattice.size[2]; ++k)
///         for (std::uint32_t j = 0; j < lattice.size[1]; ++j)
///             for (std::uint32_t i = 0; i < lattice.size[0]; ++i)
///                 samples[lattice.index(i, j, k)] = float((lattice.position(i, j, k) - middle).norm());
///     return tetra::latticeDataset(lattice, tetra::ScalarField::of(std::move(samples)), "ball");
/// }
/// ~~~

#include <tan/base.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace tetra {

class MappedFile;

/// A regular grid of points in its *frame*: point (i, j, k) lies at origin + directions * (spacing * (i, j, k)), as in
/// ITK and VTK. The first index runs fastest. Every axis has at least two points and a positive finite spacing, and no
/// direction lies in the plane of the others (readers and latticeDataset() refuse anything else).
///
/// Linear interpolation is the same in every frame, so a mesh of the lattice is made by the indices alone: which
/// tetrahedra are best tells the spacing. The frame says where it lies in the world, and is used where places leave or
/// enter: positions of meshes, bounds, regions.
struct Lattice {
    std::array<std::uint32_t, 3> size{2, 2, 2};
    Eigen::Vector3d spacing{1, 1, 1}; ///< lengths of a step of each index
    Eigen::Vector3d origin{0, 0, 0};
    /// The unit vectors along which i, j and k run, as columns: those of the world, or mirrored, exchanged, turned or
    /// sheared.
    Eigen::Matrix3d directions = Eigen::Matrix3d::Identity();

    std::uint64_t pointCount() const noexcept { return std::uint64_t(size[0]) * size[1] * size[2]; }
    std::uint64_t cellCount() const noexcept { return std::uint64_t(size[0] - 1) * (size[1] - 1) * (size[2] - 1); }

    std::uint64_t index(std::uint32_t i, std::uint32_t j, std::uint32_t k) const noexcept
    {
        return (std::uint64_t(k) * size[1] + j) * size[0] + i;
    }
    std::array<std::uint32_t, 3> coordinates(std::uint64_t index) const noexcept
    {
        return {static_cast<std::uint32_t>(index % size[0]), static_cast<std::uint32_t>(index / size[0] % size[1]),
                static_cast<std::uint32_t>(index / size[0] / size[1])};
    }
    /// Whether i, j and k run along x, y and z of the world.
    bool isAlongAxes() const { return directions == Eigen::Matrix3d::Identity(); }
    /// Whether what is positive by the indices is negative in the world.
    bool isLeftHanded() const { return directions.determinant() < 0; }
    Eigen::Vector3d position(std::uint32_t i, std::uint32_t j, std::uint32_t k) const
    {
        return origin + step(Eigen::Vector3d(i, j, k));
    }
    /// How far so many steps of the three indices lead. The sums are those of LatticePoints, to the last bit; zeros of
    /// directions along the axes add nothing.
    Eigen::Vector3d step(const Eigen::Vector3d& indices) const
    {
        const Eigen::Vector3d along = spacing.cwiseProduct(indices);
        return directions.col(0) * along[0] + directions.col(1) * along[1] + directions.col(2) * along[2];
    }
    /// The indices, with fractions, of a place in the world.
    Eigen::Vector3d indicesAt(const Eigen::Vector3d& place) const
    {
        return (directions.inverse() * (place - origin)).cwiseQuotient(spacing);
    }
    /// Of its eight corners, in the world.
    Eigen::AlignedBox3d bounds() const
    {
        Eigen::AlignedBox3d box;
        for (const std::uint32_t i : {0u, size[0] - 1})
            for (const std::uint32_t j : {0u, size[1] - 1})
                for (const std::uint32_t k : {0u, size[2] - 1})
                    box.extend(position(i, j, k));
        return box;
    }
};

/// What kind of domain the points of a dataset lie in (R1). The numbers are part of the `.tan` format.
enum class DomainClass : std::uint32_t { RegularLattice = 0, Curvilinear = 1, Irregular = 2, Scattered = 3 };

/// In words for the user: "curvilinear".
constexpr MarkedText domainClassText(DomainClass domain) noexcept
{
    constexpr MarkedText names[] = {Message::marked("regular"), Message::marked("curvilinear"),
                                    Message::marked("irregular"), Message::marked("scattered")};
    return names[static_cast<std::uint32_t>(domain)];
}

/// The same as a name, which stays.
constexpr std::string_view domainClassName(DomainClass domain) noexcept
{
    return domainClassText(domain);
}

/// Whether the points are those of a lattice of computational space.
constexpr bool isOnLattice(DomainClass domain) noexcept
{
    return domain == DomainClass::RegularLattice || domain == DomainClass::Curvilinear;
}

/// Whether a coarser mesh may occupy another region of space than the data do (R4).
constexpr bool canWarp(DomainClass domain) noexcept
{
    return domain == DomainClass::Curvilinear || domain == DomainClass::Irregular;
}

/// The type of a sample as it stands in a file and in memory. The numbers are part of the `.tan` format.
enum class SampleType : std::uint8_t {
    UInt8 = 0,
    Int8 = 1,
    UInt16 = 2,
    Int16 = 3,
    UInt32 = 4,
    Int32 = 5,
    Float32 = 6,
    Float64 = 7
};

constexpr std::size_t sampleSize(SampleType type) noexcept
{
    constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[static_cast<std::size_t>(type)];
}

constexpr bool isInteger(SampleType type) noexcept
{
    return type < SampleType::Float32;
}

/// The name that NRRD and the command line use: "uint8", "int16", "float", "double" ...
constexpr std::string_view sampleTypeName(SampleType type) noexcept
{
    constexpr std::string_view names[] = {"uint8", "int8", "uint16", "int16", "uint32", "int32", "float", "double"};
    return names[static_cast<std::size_t>(type)];
}

/// Calls `function.operator()<T>()` with the C++ type of `type` and returns what it returns.
template <class Function> decltype(auto) visitSampleType(SampleType type, Function&& function)
{
    switch (type) {
    case SampleType::UInt8: return function.template operator()<std::uint8_t>();
    case SampleType::Int8: return function.template operator()<std::int8_t>();
    case SampleType::UInt16: return function.template operator()<std::uint16_t>();
    case SampleType::Int16: return function.template operator()<std::int16_t>();
    case SampleType::UInt32: return function.template operator()<std::uint32_t>();
    case SampleType::Int32: return function.template operator()<std::int32_t>();
    case SampleType::Float32: return function.template operator()<float>();
    case SampleType::Float64: break;
    }
    return function.template operator()<double>();
}

/// The SampleType of a C++ type.
template <class T> constexpr SampleType sampleTypeOf() noexcept
{
    constexpr bool whole = std::is_integral_v<T>, negative = std::is_signed_v<T>;
    static_assert(whole ? !std::is_same_v<T, bool> && sizeof(T) <= 4
                        : std::is_same_v<T, float> || std::is_same_v<T, double>,
                  "samples are integers of 8 to 32 bits, floats or doubles");
    if constexpr (!whole)
        return sizeof(T) == 4 ? SampleType::Float32 : SampleType::Float64;
    else if constexpr (sizeof(T) == 1)
        return negative ? SampleType::Int8 : SampleType::UInt8;
    else if constexpr (sizeof(T) == 2)
        return negative ? SampleType::Int16 : SampleType::UInt16;
    else
        return negative ? SampleType::Int32 : SampleType::UInt32;
}

/// Memory for `count` samples of `type`, to be filled and handed to a ScalarField. Refused without allocating anything
/// if it is more than the physical memory of the machine, or than 2^64 bytes.
TAN_API Result<std::shared_ptr<std::byte>> allocateSamples(SampleType type, std::uint64_t count);

/// The smallest and the largest value of a field; errors in percent refer to `extent()` (R7).
struct ValueRange {
    double minimum = 0;
    double maximum = 0;
    double extent() const noexcept { return maximum - minimum; }
};

/// Samples of one type, shared and never changed: copying copies a pointer. Native byte order, naturally aligned.
/// Safe to read from any number of threads.
class TAN_API ScalarField {
public:
    ScalarField() = default;
    /// `samples` holds at least `count` samples of `type` and keeps what it points into (an array, a mapped file)
    /// alive.
    ScalarField(SampleType type, std::uint64_t count, std::shared_ptr<const std::byte> samples);
    /// As the constructor, but cancellable: for samples that are slow to scan, such as those of a mapped file. Errors:
    /// cancelled.
    static Result<ScalarField> scanned(SampleType type, std::uint64_t count, std::shared_ptr<const std::byte> samples,
                                       const Progress& progress);

    /// As the constructor, for finite samples of a known range: none of them is read.
    static ScalarField ofKnownRange(SampleType type, std::uint64_t count, std::shared_ptr<const std::byte> samples,
                                    const ValueRange& range);

    /// Takes an array over.
    template <class T> static ScalarField of(std::vector<T> samples)
    {
        const auto kept = std::make_shared<const std::vector<T>>(std::move(samples));
        return ScalarField(sampleTypeOf<T>(), kept->size(), {kept, reinterpret_cast<const std::byte*>(kept->data())});
    }

    /// Copies samples that stay the caller's. Those that need no copy are handed to the constructor.
    template <class T> static ScalarField copyOf(std::span<const T> samples)
    {
        return of(std::vector<T>(samples.begin(), samples.end()));
    }

    SampleType type() const noexcept { return type_; }
    std::uint64_t count() const noexcept { return count_; }
    std::span<const std::byte> bytes() const noexcept { return {samples_.get(), count_ * sampleSize(type_)}; }

    /// The samples as T, which must be the type's own C++ type.
    template <class T> std::span<const T> as() const noexcept
    {
        assert(sizeof(T) == sampleSize(type_));
        return {reinterpret_cast<const T*>(samples_.get()), count_};
    }
    /// Any sample as a double, exactly. For a few values; loops over many use as<T>().
    double at(std::uint64_t index) const;
    /// Smallest and largest value, found once at construction.
    ValueRange range() const noexcept { return range_; }
    /// The number of samples that are NaN or infinite; they are left out of range().
    std::uint64_t notFiniteCount() const noexcept { return notFinite_; }

private:
    /// False when cancelled.
    bool findRange(const Progress& progress);

    SampleType type_ = SampleType::UInt8;
    std::uint64_t count_ = 0;
    std::uint64_t notFinite_ = 0;
    ValueRange range_;
    std::shared_ptr<const std::byte> samples_;
};

/// What a reader takes of a file that offers several, or that does not say how it is meant.
enum class TakenPart : std::uint8_t {
    Array,     ///< of values: an array, a column, a variable
    Component, ///< of an array with several: the number of one, a magnitude
    Places,    ///< the columns, or the arrays, of the positions
    Block,     ///< a part, a zone, a piece, a level
    Series,    ///< of a folder of pictures
    Channel,
    TimeStep,
    Frame, ///< which of the places that a header gives a lattice
    Unit,  ///< of the values
    Fill   ///< the numbers that stand for no value
};

/// In words for the user: "time step".
TAN_API MarkedText takenPartText(TakenPart part) noexcept;

/// The same as a name, which stays: in models, in JSON.
TAN_API std::string_view takenPartName(TakenPart part) noexcept;

/// One choice of a reader (D3): what it took, in the file's words or as the option takes it that asks for another one.
struct Taken {
    TakenPart part = TakenPart::Array;
    Message what;         ///< "temperature", "2 of 5, time 0.5"
    bool guessed = false; ///< the file does not say that it is this one: another may be meant
    bool operator==(const Taken&) const = default;
};

/// "time step: 2 of 5", "array: temperature (a guess)".
TAN_API Message takenText(const Taken& taken);

/// Where a dataset came from: kept in every model built from it.
struct Source {
    std::string name;               ///< what the user calls it: the file's name, or a sample's
    std::filesystem::path path;     ///< empty when it was never a file
    std::uint64_t hash = 0;         ///< XXH3 of the samples' bytes in memory order, followed by the positions and the
                                    ///< tetrahedra, if there are any
    std::string valueName{};        ///< what the file calls the values: an array, a column; empty if it does not say
    std::vector<Taken> taken{};     ///< each part at most once, in the order of TakenPart
    std::vector<Message> leftOut{}; ///< what the file says and was not used, in sentences: "It holds 20 volumes ..."
};

/// Where each point lies, all finite; shared and never changed.
using PointPositions = std::shared_ptr<const std::vector<Eigen::Vector3d>>;

/// The tetrahedra of an irregular mesh, by numbers of points, positive: (b-a) . ((c-a) x (d-a)) > 0; shared and never
/// changed.
using PointTetrahedra = std::shared_ptr<const std::vector<std::array<std::uint32_t, 4>>>;

/// Source::hash of such values, positions and tetrahedra.
TAN_API std::uint64_t contentHash(const ScalarField& values, const PointPositions& positions,
                                  const PointTetrahedra& tetrahedra = nullptr);

/// Whether a cell of a grid is part of the domain.
enum class GridCell : std::uint8_t {
    Kept,
    Blanked,   ///< the file hides it
    NotFinite, ///< it has a value of its own, which is no finite number
};

/// Why a cell of a file is no part of the mesh that was read from it. In texts for the user: cellFaultText().
enum class CellFault : std::uint8_t {
    NotFinite,   ///< a value that is not finite
    NoVolume,    ///< no volume, or a repeated corner
    Warped,      ///< too warped to be cut into tetrahedra without a new point
    Duplicate,   ///< there twice, in whole or in part
    CrowdedFace, ///< more than two cells at one of its faces
    Folded,      ///< inverted: on the same side of a face as its neighbour
    Overlap      ///< overlaps others in another way
};

/// "it overlaps others".
TAN_API MarkedText cellFaultText(CellFault fault) noexcept;

/// A cell that was taken out of a mesh and left a hole (C10).
struct FaultyCell {
    std::uint64_t cell = 0; ///< its number in the file, from 0; over all its pieces
    CellFault fault = CellFault::NotFinite;
    /// Where its corners lie: those of a tetrahedron, pyramid, prism or hexahedron, numbered as in VTK. Empty where
    /// that is not known, and for cells that are holes by their value.
    std::vector<Eigen::Vector3d> corners{};
    bool operator==(const FaultyCell&) const = default;
};

/// The edges between the corners of such a cell; none without corners.
TAN_API std::vector<std::array<Eigen::Vector3d, 2>> edgesOf(const FaultyCell& cell);

/// The reference model (2.3): points with one scalar each. Immutable, cheap to copy.
///
/// Regular: the lattice and its frame say where the points lie. Curvilinear (and rectilinear): the lattice is the
/// computational space, with spacing 1 and origin 0, and `positions` the physical one. Scattered: `positions` alone;
/// the lattice's size is {points, 1, 1} and says nothing more. Irregular: as scattered, and `tetrahedra` fill the
/// domain: a conforming mesh that uses every point, of one or more components, whose boundary is a manifold.
struct TAN_API Dataset {
    DomainClass domain = DomainClass::RegularLattice;
    Lattice lattice;
    PointPositions positions = nullptr; ///< one per point, in the order of the values; null for a regular lattice
    ScalarField values;                 ///< one sample per point, all finite (but see withHoles())
    Source source;
    std::vector<Message> remarks{}; ///< changes made while reading, in sentences for the user
    /// The file whose bytes the values are; null if they are in memory.
    std::shared_ptr<const MappedFile> mappedFile = nullptr;
    PointTetrahedra tetrahedra = nullptr; ///< of irregular data, else null
    /// Of a grid that withHoles() is still to finish: a GridCell for each cell, the first index running fastest. Else
    /// null.
    std::shared_ptr<const std::vector<GridCell>> cells = nullptr;
    /// Of irregular data: the cells that were taken out, each once, ascending; null if there are none.
    std::shared_ptr<const std::vector<FaultyCell>> faultyCells = nullptr;
    /// Of grids and irregular data: hasConvexDomain(), for those who read or make them.
    bool convex = false;
    /// Which way x, y and z of the world grow, as the file says, by three letters: "RAS" is to the right, to the front
    /// (anterior) and to the head (superior) of a patient, "LPS" to the left, to the back and to the head. Empty where
    /// it does not say.
    std::string space{};
    std::string lengthUnit{}; ///< of positions, as the file says, such as "mm"; empty where it does not

    std::uint64_t pointCount() const noexcept { return values.count(); }
    Eigen::Vector3d position(std::uint64_t point) const
    {
        if (positions)
            return (*positions)[point];
        const auto place = lattice.coordinates(point);
        return lattice.position(place[0], place[1], place[2]);
    }
    /// Of all points in physical space. O(1) for a regular lattice, else O(points).
    Eigen::AlignedBox3d bounds() const;
    /// An error naming the mapped file if it was truncated or modified: values read since then may be wrong. Call this
    /// after computing a result and before using it. One system call.
    Status checkIntact() const;
};

// Datasets of arrays in memory. `name` is what the user calls the data; models keep it, and the hash of all values and
// positions, by which verify() knows the data again. Errors (BadInput) say what is wrong with the arrays. May throw
// std::bad_alloc. Safe from any thread.

/// A regular lattice; the first index of `values` runs fastest. Refused unless there is exactly one finite value per
/// point; fewer than two points along an axis, a spacing that is not positive, directions that are not of unit length
/// or lie in a plane. O(points).
TAN_API Result<Dataset> latticeDataset(const Lattice& lattice, ScalarField values, std::string name);

/// A curvilinear (or rectilinear) grid of `size` points, the first index running fastest, each in its place. Cells may
/// be degenerate, folded or left-handed (BuildReport counts them), but not all of them flat. O(points), on all threads.
TAN_API Result<Dataset> curvilinearDataset(const std::array<std::uint32_t, 3>& size,
                                           std::vector<Eigen::Vector3d> positions, ScalarField values,
                                           std::string name);

/// Points without cells. Those whose value is not finite are left out, coincident ones merged, with the mean of their
/// values; Dataset::remarks says so. Refused unless there is exactly one value per point; positions that are not
/// finite; no points. O(n log n).
TAN_API Result<Dataset> scatteredDataset(std::vector<Eigen::Vector3d> positions, std::vector<double> values,
                                         std::string name);

/// Whether data are of the paper's class *convex* although a grid or cells are given (R1): a curvilinear grid that is
/// *rectilinear*, each coordinate depending on one index alone, growing or falling with it; and an irregular mesh that
/// fills the convex hull of its points: of one component, without holes, no edge of its boundary bent inwards. Exact;
/// only for coordinates that were rounded, as of a box at an angle, a boundary is still convex if none of its vertices
/// is more than a millionth of the bounds' diagonal outside the plane of one of its faces. Other data: true. O(points)
/// and O(tetrahedra), more if coordinates were rounded. May throw std::bad_alloc.
TAN_API bool hasConvexDomain(const Dataset& dataset);

/// The points of a dataset of convex domain as scattered ones: their domain is their convex hull. The source stays.
TAN_API Dataset asPoints(const Dataset& dataset);

/// Scattered points as an irregular mesh: the Delaunay tetrahedra of all of them, which fill their convex hull, with
/// ties decided symbolically, so that they depend on the points alone. The source stays. Errors (BadInput): fewer than
/// four points, all of them in one plane; cancelled. O(n log n) as a rule; some 500 bytes a point while it works. May
/// throw std::bad_alloc.
TAN_API Result<Dataset> tetrahedrized(const Dataset& points, const Progress& progress = {});

/// A curvilinear grid as the irregular mesh that its cells make: each is cut into tetrahedra, points on one place are
/// one, cells without volume are left out. The source stays. All samples are in it, each once and unchanged; a grid of
/// which that cannot be is refused. Errors (BadInput): cells that are folded, overlap or cannot be cut, points on one
/// place that have different values, points of cells without volume alone; not enough memory (OutOfResource);
/// cancelled. The same mesh every time. One thread, some 1 kB a cell while it works.
TAN_API Result<Dataset> asMesh(const Dataset& grid, const Progress& progress = {});

/// Why a curvilinear grid is not taken asMesh() unless that is asked for: it has more than five million points, a cell
/// of it is folded or cannot be cut, or two of its points lie on one place and have different values. Success if none
/// of that is so; then asMesh() refuses it only if it meets itself. O(points), on all threads; where the first cut of a
/// cell has a tetrahedron that is turned over or nearly flat, as slow as asMesh().
TAN_API Status checkAsMesh(const Dataset& grid);

/// The shape of a cell as files have it; corners are numbered as in VTK. Quadratic cells carry their nodes of order two
/// after the corners.
enum class CellShape : std::uint8_t {
    Tetrahedron,
    Pyramid,
    Prism,
    Hexahedron,
    Voxel, ///< a hexahedron along the axes, corners x fastest
    QuadraticTetrahedron,
    QuadraticPyramid,
    QuadraticPrism,
    QuadraticHexahedron,
    TriquadraticHexahedron,
    Polyhedron, ///< its corners are its faces: of each the number of its points, then these, in any orientation
    Flat ///< vertices, lines, triangles, quadrilaterals: without volume: left out, and reported in Dataset::remarks
};

/// Cells of mixed shapes over points, as read from a file, not yet validated.
struct CellComplex {
    std::vector<Eigen::Vector3d> positions;
    std::vector<CellShape> shapes;
    std::vector<std::uint64_t> offsets; ///< the corners of cell c are corners[offsets[c]] up to corners[offsets[c + 1]]
    std::vector<std::uint64_t> corners; ///< numbers of positions
    std::vector<std::uint8_t> blanked;  ///< one per cell, nonzero: the cell is a hole; empty if there are none
    /// All that will be taken: only what lies in it has to be sound, and is looked at. What lies beyond stays as it is.
    std::optional<Eigen::AlignedBox3d> region{};
    /// The largest share of the cells, or of their volume, that may be taken out because they are faulty.
    double mostFaulty = 0.001;
    /// Whether a polyhedron that no tetrahedra between its own points fill gets a point in its middle.
    bool addsCentres = false;
};

/// Values for the points of a complex, or for its cells.
struct ComplexValues {
    std::vector<double> values;
    bool perCell = false;                  ///< averaged onto the points; Dataset::remarks says so
    SampleType type = SampleType::Float32; ///< the type in which the dataset stores the values
};

/// The irregular dataset that such cells make (R1, S6, S20), a mesh that covers its domain once: every cell is cut into
/// tetrahedra, quadratic ones through all their nodes, polyhedra between their points; cells blanked or with a value
/// that is not finite are holes. Harmless defects are repaired and listed in `remarks`: points on one place (the mean
/// of their values), points that no cell uses, cells with a repeated corner, without volume, numbered the other way
/// round or duplicated. Cells that overlap others, also by lying on the same side of a face, are taken out, which
/// `faultyCells` lists, if they are at most `mostFaulty` of the cells or of the volume (C10). The boundary may touch
/// itself. Refused with a count and an example: more faulty cells than that, polyhedra without a cut among them,
/// numbers of points out of range, nothing left. Of a complex with a region the judgement is about what lies in it, and
/// the mesh sound there. One thread, about 300 bytes a tetrahedron, and 100 more where cells overlap; safe from any
/// thread.
TAN_API Result<Dataset> irregularDataset(const CellComplex& complex, const ComplexValues& values, const Source& source,
                                         const Progress& progress = {});

/// Whether a grid has holes: cells that are no part of it, or points whose value is not finite. O(1).
TAN_API bool hasHoles(const Dataset& grid) noexcept;

/// What such a grid is, as readers give it to the program (S6, S20): the irregular dataset of its other cells as
/// hexahedra, with a remark on what was left out; any other dataset as it is. Its positions count where a cell uses
/// them. Errors: those of irregularDataset(); no cell is left (BadInput); more memory than there is, told beforehand
/// (OutOfResource); cancelled. One thread, about 1 KB a cell that is left; safe from any thread.
TAN_API Result<Dataset> withHoles(const Dataset& grid, const Progress& progress = {});

/// The weight beyond the reach of a term, unless the term says otherwise.
constexpr double defaultWeightFloor = 0.1;
constexpr double smallestWeightFloor = 1e-6;

/// A place that matters: weight 1 in the box, which may be a single point, falling linearly to `floor` at the distance
/// `reach` from it and beyond. Units of the positions.
struct SpaceWeight {
    Eigen::AlignedBox3d box;
    double reach = 0; ///< 0: `floor` everywhere outside
    double floor = defaultWeightFloor;
};

/// A value that matters: weight 1 for points that have it, falling linearly to `floor` at the difference `reach` and
/// beyond. Units of the values.
struct ValueWeight {
    double value = 0;
    double reach = 0;
    double floor = defaultWeightFloor;
};

/// How much the error at each point counts (R6, 2.3): a mesh's weighted error is the largest weight * |value -
/// interpolation| over the points. The weight of a point is the *largest* of its terms' weights, so that terms add
/// requirements and never cancel each other. Without terms every weight is 1.
struct TAN_API Weighting {
    std::vector<SpaceWeight> places;
    std::vector<ValueWeight> values;

    bool empty() const noexcept { return places.empty() && values.empty(); }
    /// In (0, 1].
    double weight(const Eigen::Vector3d& position, double value) const;
};

/// What parseWeighting() reads, for the user.
inline constexpr std::string_view weightingSyntax =
    "point:x,y,z,reach[,floor], box:x0,y0,z0,x1,y1,z1,reach[,floor] or value:q,reach[,floor]";

/// Reads terms of weightingSyntax separated by ';', blanks around them allowed, none at all too. The reach of points
/// and values is above 0, that of boxes at least 0, floors are from 1e-6 to 1. The error (WrongUsage) names the term
/// and what is wrong with it.
TAN_API Result<Weighting> parseWeighting(std::string_view text);

/// The text that parseWeighting() reads as this weighting: places first, all floors given.
TAN_API std::string weightingText(const Weighting& weighting);

/// The weight of each of the dataset's points, the same bits on every machine; empty if the weighting is. Uses all
/// threads. Errors: not enough memory, cancelled.
TAN_API Result<std::vector<float>> pointWeights(const Weighting& weighting, const Dataset& dataset,
                                                const Progress& progress = {});

// What every dataset on a lattice must fulfil, whatever format it comes from. The errors say what is wrong and what to
// do; the caller names the file.

/// At least two points along each axis, fewer than 2^32, and a number of bytes that fits into 62 bits.
TAN_API Status checkLatticeSize(const std::array<std::uint64_t, 3>& size);

/// Positive, finite spacing, finite origin and bounds, and points that stay apart in double precision.
TAN_API Status checkLatticePlacement(const Lattice& lattice);

/// The largest magnitude of a coordinate: volumes are still finite then.
inline constexpr double farthestCoordinate = 1e90;

/// Whether one can compute with a position: finite, and no coordinate beyond the farthest.
inline bool isUsablePlace(const Eigen::Vector3d& place)
{
    return place.allFinite() && place.cwiseAbs().maxCoeff() <= farthestCoordinate;
}

/// No NaN, no infinity.
TAN_API Status checkFinite(const Lattice& lattice, const ScalarField& values);

/// What a curvilinear dataset must fulfil: finite positions and values, and cells with a volume. The error is a
/// sentence about "it".
TAN_API Status checkGrid(const Dataset& dataset);

} // namespace tetra
