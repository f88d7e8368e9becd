// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkTAnReader.h"

#include "mesh_pieces.h"

#include <tan/open.h>
#include <tan/query.h>

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnsignedIntArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>
#include <numeric>
#include <stop_token>
#include <system_error>
#include <thread>

namespace {

using namespace tetra;

constexpr double opening = 0.4, extracting = 0.8; ///< how far it is when the model is open, and when the mesh is there

std::filesystem::file_time_type timeOf(const std::string& place)
{
    std::error_code none;
    return isAddress(place) ? std::filesystem::file_time_type() : std::filesystem::last_write_time(place, none);
}

/// The first line of a token's file, without its end; without a file no token.
Result<std::string> tokenIn(const std::string& name)
{
    if (name.empty())
        return std::string();
    std::ifstream file(name);
    std::string line;
    if (!std::getline(file, line))
        return Error{ErrorKind::BadInput,
                     "Cannot read the token's file '" + name + "', or it is empty. Check its name and folder."};
    while (!line.empty() && (line.back() == '\r' || line.back() == ' '))
        line.pop_back();
    return line;
}

} // namespace

/// The model of an update, which the next one uses again.
struct vtkTAnReader::Opened {
    std::string place;
    std::string token;
    std::filesystem::file_time_type written{}; ///< of a file, when that was last changed
    FoundModel found;
    MeshExtractor extractor;

    static Result<std::unique_ptr<Opened>> open(const std::string& place, const std::string& token, double error,
                                                const tetra::Progress& progress)
    {
        const auto written = timeOf(place);
        auto found = openModel(place, {.accuracy = Accuracy{error, error}, .token = token}, progress);
        if (!found)
            return found.error();
        MeshExtractor extractor(found->model);
        return std::make_unique<Opened>(Opened{place, token, written, *std::move(found), std::move(extractor)});
    }

    /// Whether it is this model, as it lies there now, and has meshes of this error.
    bool serves(const std::string& otherPlace, const std::string& otherToken, double error) const
    {
        if (place != otherPlace || token != otherToken || written != timeOf(otherPlace))
            return false;
        return found.isWhole || meshSizeAt(*found.model, {error, error}).error <= error;
    }
};

vtkStandardNewMacro(vtkTAnReader);

namespace {

double finestError(vtkTAnReader& reader)
{
    return reader.GetFocus() ? std::min(reader.GetError(), reader.GetFocusError()) : reader.GetError();
}

/// `warps`: whether meshes of the model are warped, which the error limits, too.
MeshQuery queryOf(vtkTAnReader& reader, bool warps)
{
    MeshQuery query;
    query.error = reader.GetError();
    if (reader.GetFocus())
        query.error = SpaceRamp{Sphere{Eigen::Vector3d(reader.GetFocusCentre()), reader.GetFocusRadius()},
                                reader.GetFocusError(), reader.GetError(), reader.GetFocusFalloff()};
    if (warps)
        query.warping = query.error;
    if (reader.GetBudget() > 0)
        query.budget = static_cast<std::uint64_t>(reader.GetBudget());
    if (reader.GetRegion()) {
        const double* const bounds = reader.GetRegionBounds();
        query.window = Window{Box{{bounds[0], bounds[2], bounds[4]}, {bounds[1], bounds[3], bounds[5]}},
                              static_cast<WindowBorder>(reader.GetRegionBorder())};
    }
    return query;
}

/// The numbers of vertices and tetrahedra of the whole mesh.
tanpieces::MeshPiece wholeOf(const TetrahedralMesh& mesh)
{
    tanpieces::MeshPiece all;
    all.vertices.resize(mesh.positions.size());
    all.tetrahedra.resize(mesh.tetrahedra.size());
    std::iota(all.vertices.begin(), all.vertices.end(), 0U);
    std::iota(all.tetrahedra.begin(), all.tetrahedra.end(), 0U);
    return all;
}

template <class Array, class Value>
vtkNew<Array> arrayOf(const char* name, const std::vector<std::uint32_t>& vertices, const Value& valueOf)
{
    vtkNew<Array> array;
    array->SetName(name);
    array->SetNumberOfValues(static_cast<vtkIdType>(vertices.size()));
    auto* const values = array->GetPointer(0);
    for (std::size_t i = 0; i < vertices.size(); ++i)
        values[i] = valueOf(vertices[i]);
    return array;
}

void setPoints(vtkUnstructuredGrid& grid, const TetrahedralMesh& mesh, const tanpieces::MeshPiece& piece)
{
    vtkNew<vtkDoubleArray> places;
    places->SetNumberOfComponents(3);
    places->SetNumberOfTuples(static_cast<vtkIdType>(piece.vertices.size()));
    double* at = places->GetPointer(0);
    for (const std::uint32_t vertex : piece.vertices)
        at = std::copy_n(mesh.positions[vertex].data(), 3, at);
    vtkNew<vtkPoints> points;
    points->SetData(places);
    grid.SetPoints(points);
}

/// In as few bytes as hold the numbers.
template <class Array>
void setCells(vtkUnstructuredGrid& grid, const TetrahedralMesh& mesh, const tanpieces::MeshPiece& piece)
{
    using Number = typename Array::ValueType;
    std::vector<std::uint32_t> numbers(mesh.positions.size());
    for (std::size_t i = 0; i < piece.vertices.size(); ++i)
        numbers[piece.vertices[i]] = static_cast<std::uint32_t>(i);
    vtkNew<Array> offsets, corners;
    offsets->SetNumberOfValues(static_cast<vtkIdType>(piece.tetrahedra.size()) + 1);
    corners->SetNumberOfValues(4 * static_cast<vtkIdType>(piece.tetrahedra.size()));
    Number* offset = offsets->GetPointer(0);
    Number* corner = corners->GetPointer(0);
    Number written = 0;
    for (const std::uint32_t tetrahedron : piece.tetrahedra) {
        *offset++ = written;
        written += 4;
        for (const std::uint32_t vertex : mesh.tetrahedra[tetrahedron])
            *corner++ = static_cast<Number>(numbers[vertex]);
    }
    *offset = written;
    vtkNew<vtkCellArray> cells;
    cells->SetData(offsets, corners);
    grid.SetCells(VTK_TETRA, cells);
}

void addNumber(vtkFieldData& data, const char* name, double number)
{
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->InsertNextValue(number);
    data.AddArray(array);
}

void addText(vtkFieldData& data, const char* name, const std::string& text)
{
    if (text.empty())
        return;
    vtkNew<vtkStringArray> array;
    array->SetName(name);
    array->InsertNextValue(text);
    data.AddArray(array);
}

bool holdsLogarithms(const ModelDescription& about)
{
    return std::ranges::any_of(about.parameters, [](const auto& parameter) {
        return parameter.first == "import.scale" && parameter.second.starts_with("log");
    });
}

/// The name of the values, and of logarithms that of what they are of: "log10(nut)" and "nut".
std::string arrayName(const ModelDescription& about)
{
    constexpr std::array<std::string_view, 6> others = {"site",     "birth_error", "death_error",
                                                        "isovalue", "colour",      "Normals"};
    if (about.valueName.empty())
        return "value";
    return (std::ranges::find(others, about.valueName) != others.end() ? "value_" : "") + about.valueName;
}

std::string nameWithoutLogarithm(const std::string& name)
{
    constexpr std::string_view before = "log10(";
    return name.starts_with(before) && name.ends_with(')') ? name.substr(before.size(), name.size() - before.size() - 1)
                                                           : "10^" + name;
}

void addValues(vtkUnstructuredGrid& grid, const ModelDescription& about, const ExtractedMesh& found,
               const tanpieces::MeshPiece& piece)
{
    const std::string name = arrayName(about);
    const auto valueOf = [&](std::uint32_t vertex) { return found.mesh.values[vertex]; };
    grid.GetPointData()->SetScalars(arrayOf<vtkFloatArray>(name.c_str(), piece.vertices, valueOf));
    if (holdsLogarithms(about))
        grid.GetPointData()->AddArray(
            arrayOf<vtkFloatArray>(nameWithoutLogarithm(name).c_str(), piece.vertices, [&](std::uint32_t vertex) {
                return static_cast<float>(std::pow(10.0, static_cast<double>(valueOf(vertex))));
            }));
    if (found.sites.size() == found.mesh.positions.size()) // a server does not tell them
        grid.GetPointData()->AddArray(arrayOf<vtkUnsignedIntArray>(
            "site", piece.vertices, [&](std::uint32_t vertex) { return found.sites[vertex]; }));
}

/// What the mesh keeps, as `tan extract` writes it.
void addFacts(vtkUnstructuredGrid& grid, const Model& model, const MeshQuery& query, const ExtractedMesh& found)
{
    vtkFieldData& data = *grid.GetFieldData();
    const ModelDescription& about = model.description();
    addText(data, "model", model.path().filename().string());
    addText(data, "source", about.sourceName);
    addText(data, "unit", about.lengthUnit);
    if (query.error.isConstant())
        addNumber(data, "error", keptPercent(query.error.bounds().minimum, found.scale));
    if (about.warpingWeight > 0 && query.warping.isConstant())
        addNumber(data, "warping", keptPercent(query.warping.bounds().minimum, found.scale));
    addNumber(data, "error_scale", found.scale);
    if (found.reached) {
        addNumber(data, "reached_error", found.reached->error);
        if (about.warpingWeight > 0)
            addNumber(data, "reached_warping", found.reached->warping);
    }
}

void markOthers(vtkUnstructuredGrid& grid, const tanpieces::MeshPiece& piece)
{
    const auto marks = [](const std::vector<bool>& isOthers, unsigned char mark) {
        vtkNew<vtkUnsignedCharArray> array;
        array->SetName(vtkDataSetAttributes::GhostArrayName());
        array->SetNumberOfValues(static_cast<vtkIdType>(isOthers.size()));
        std::ranges::transform(isOthers, array->GetPointer(0), [&](bool is) { return is ? mark : 0; });
        return array;
    };
    grid.GetCellData()->AddArray(marks(piece.isOthers, vtkDataSetAttributes::DUPLICATECELL));
    grid.GetPointData()->AddArray(marks(piece.isOthersVertex, vtkDataSetAttributes::DUPLICATEPOINT));
}

/// Of the mesh the piece that the output is to have.
void fillGrid(vtkInformation& output, const Model& model, const MeshQuery& query, const ExtractedMesh& found,
              vtkUnstructuredGrid& grid)
{
    using Pipeline = vtkStreamingDemandDrivenPipeline;
    const int pieces = output.Get(Pipeline::UPDATE_NUMBER_OF_PIECES());
    tanpieces::MeshPiece piece;
    if (pieces > 1)
        piece = tanpieces::pieceOf(found.mesh, tanpieces::pieceOfEach(found.mesh, static_cast<std::uint32_t>(pieces)),
                                   static_cast<std::uint32_t>(output.Get(Pipeline::UPDATE_PIECE_NUMBER())),
                                   output.Get(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS()));
    else
        piece = wholeOf(found.mesh);
    setPoints(grid, found.mesh, piece);
    if (4 * piece.tetrahedra.size() < static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()))
        setCells<vtkTypeInt32Array>(grid, found.mesh, piece);
    else
        setCells<vtkTypeInt64Array>(grid, found.mesh, piece);
    addValues(grid, model.description(), found, piece);
    addFacts(grid, model, query, found);
    if (pieces > 1)
        markOthers(grid, piece);
}

} // namespace

vtkTAnReader::vtkTAnReader()
{
    this->SetNumberOfInputPorts(0);
}

vtkTAnReader::~vtkTAnReader() = default;

void vtkTAnReader::SetFileName(const char* name)
{
    const std::string given = name != nullptr ? name : "";
    if (given == this->FileName)
        return;
    this->FileName = given;
    this->Modified();
}

void vtkTAnReader::SetTokenFile(const char* name)
{
    const std::string given = name != nullptr ? name : "";
    if (given == this->TokenFile)
        return;
    this->TokenFile = given;
    this->Modified();
}

int vtkTAnReader::CanReadFile(const char* name)
{
    return name != nullptr && modelFacts(name) ? 1 : 0;
}

int vtkTAnReader::RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
    outputs->GetInformationObject(0)->Set(CAN_HANDLE_PIECE_REQUEST(), 1);
    return 1;
}

int vtkTAnReader::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
    if (this->FileName.empty()) {
        vtkErrorMacro(<< "No model is named. Give a file (.tan) or an address.");
        return 0;
    }
    std::stop_source stop;
    const std::thread::id here = std::this_thread::get_id();
    const tetra::Progress progress(stop.get_token(), [&](double fraction, const Message&) {
        if (std::this_thread::get_id() != here)
            return;
        this->UpdateProgress(fraction);
        if (this->GetAbortExecute())
            stop.request_stop();
    });
    const auto token = tokenIn(this->TokenFile);
    if (!token) {
        vtkErrorMacro(<< token.error().text());
        return 0;
    }
    if (const double finest = finestError(*this);
        !this->opened || !this->opened->serves(this->FileName, *token, finest)) {
        this->opened.reset();
        auto found = Opened::open(this->FileName, *token, finest, progress.part(0, opening));
        if (!found) {
            vtkErrorMacro(<< found.error().text());
            return 0;
        }
        this->opened = *std::move(found);
    }
    const Model& model = *this->opened->found.model;
    const MeshQuery query = queryOf(*this, model.description().warpingWeight > 0);
    const auto extracted = this->opened->extractor.extract(query, progress.part(opening, extracting));
    const Status right = extracted ? model.confirm(progress.withCallback({})) : Status(extracted.error());
    if (!right) {
        vtkErrorMacro(<< right.error().text());
        return 0;
    }
    fillGrid(*outputs->GetInformationObject(0), model, query, **extracted, *vtkUnstructuredGrid::GetData(outputs));
    return 1;
}

void vtkTAnReader::PrintSelf(std::ostream& os, vtkIndent indent)
{
    this->Superclass::PrintSelf(os, indent);
    os << indent << "FileName: " << this->FileName << "\n";
    os << indent << "TokenFile: " << this->TokenFile << "\n";
    os << indent << "Error: " << this->Error << "\n";
    os << indent << "Budget: " << this->Budget << "\n";
    os << indent << "Focus: " << this->Focus << ", centre " << this->FocusCentre[0] << " " << this->FocusCentre[1]
       << " " << this->FocusCentre[2] << ", radius " << this->FocusRadius << ", error " << this->FocusError
       << ", falloff " << this->FocusFalloff << "\n";
    os << indent << "Region: " << this->Region << ", border " << this->RegionBorder << "\n";
}
