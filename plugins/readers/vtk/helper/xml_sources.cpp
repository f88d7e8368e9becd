// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/helper/xml_sources.h"

#include "plugins/readers/vtk/checks/format_checks.h"

#include <vtkDataArraySelection.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLMultiBlockDataReader.h>
#include <vtkXMLPImageDataReader.h>
#include <vtkXMLPPolyDataReader.h>
#include <vtkXMLPRectilinearGridReader.h>
#include <vtkXMLPStructuredGridReader.h>
#include <vtkXMLPUnstructuredGridReader.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLRectilinearGridReader.h>
#include <vtkXMLStructuredGridReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <map>
#include <string_view>

namespace tetra {
namespace {

using Make = vtkSmartPointer<vtkXMLReader> (*)();

template <class Reader> vtkSmartPointer<vtkXMLReader> make()
{
    return vtkSmartPointer<Reader>::New();
}

const std::map<std::string_view, Make> readers = {{"ImageData", make<vtkXMLImageDataReader>},
                                                  {"RectilinearGrid", make<vtkXMLRectilinearGridReader>},
                                                  {"StructuredGrid", make<vtkXMLStructuredGridReader>},
                                                  {"PolyData", make<vtkXMLPolyDataReader>},
                                                  // Of lists, and packed by LZ4 or LZMA: others are read without VTK.
                                                  {"UnstructuredGrid", make<vtkXMLUnstructuredGridReader>},
                                                  {"PImageData", make<vtkXMLPImageDataReader>},
                                                  {"PRectilinearGrid", make<vtkXMLPRectilinearGridReader>},
                                                  {"PStructuredGrid", make<vtkXMLPStructuredGridReader>},
                                                  {"PUnstructuredGrid", make<vtkXMLPUnstructuredGridReader>},
                                                  {"PPolyData", make<vtkXMLPPolyDataReader>},
                                                  {"vtkMultiBlockDataSet", make<vtkXMLMultiBlockDataReader>}};

/// Only the wanted array, if it is named and there; all others stay on.
void selectOnly(vtkDataArraySelection& points, vtkDataArraySelection& cells, const std::string& wanted)
{
    vtkDataArraySelection* const lists[] = {&points, &cells};
    for (vtkDataArraySelection* list : lists)
        if (list->ArrayExists(wanted.c_str()) != 0) {
            points.DisableAllArrays();
            cells.DisableAllArrays();
            list->EnableArray(wanted.c_str());
            for (const char* kept : {"vtkGhostType", "vtkGhostLevels"}) {
                points.EnableArray(kept);
                cells.EnableArray(kept);
            }
            return;
        }
}

} // namespace

Result<VtkSource> makeXmlSource(const VtkRequest& request)
{
    const std::string type = xmlType(request.path);
    const auto found = readers.find(type);
    if (found == readers.end())
        return Error{
            ErrorKind::BadInput,
            type.empty()
                ? Message::say("it is not a VTK file: its beginning does not state a type of data. Write it again.")
                : Message::say(
                      "it holds data of the type '%1', which are not a volume. Write them as a grid, a mesh or points.",
                      printable(type))};
    const vtkSmartPointer<vtkXMLReader> reader = found->second();
    reader->SetFileName(request.path.c_str());
    VtkSource source{.reader = reader, .knowsContents = type != "vtkMultiBlockDataSet" && !type.starts_with('P')};
    source.selectArrays = [reader, wanted = request.array, whole = request.contentsOnly] {
        if (!whole)
            selectOnly(*reader->GetPointDataArraySelection(), *reader->GetCellDataArraySelection(), wanted);
    };
    return source;
}

} // namespace tetra
