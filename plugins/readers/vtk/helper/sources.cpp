// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/helper/sources.h"

#include "plugins/readers/vtk/helper/image_sources.h"
#include "plugins/readers/vtk/helper/mesh_sources.h"
#include "plugins/readers/vtk/helper/xml_sources.h"

#include <vtkGenericDataObjectReader.h>
#include <vtkHDFReader.h>

namespace tetra {
namespace {

VtkSource legacySource(const std::string& path)
{
    const auto reader = vtkSmartPointer<vtkGenericDataObjectReader>::New();
    reader->SetFileName(path.c_str());
    reader->ReadAllScalarsOn();
    reader->ReadAllVectorsOn();
    reader->ReadAllTensorsOn();
    reader->ReadAllFieldsOn();
    reader->ReadAllNormalsOff();
    reader->ReadAllTCoordsOff();
    reader->ReadAllColorScalarsOn();
    return {.reader = reader};
}

} // namespace

Result<VtkSource> makeSource(const VtkRequest& request)
{
    switch (request.format) {
    case VtkFormat::Xml: return makeXmlSource(request);
    case VtkFormat::Legacy: return legacySource(request.path);
    case VtkFormat::Hdf: {
        const auto reader = vtkSmartPointer<vtkHDFReader>::New();
        reader->SetFileName(request.path.c_str());
        return VtkSource{.reader = reader};
    }
    case VtkFormat::MetaImage:
    case VtkFormat::Nifti:
    case VtkFormat::Mrc:
    case VtkFormat::Tiff:
    case VtkFormat::Dicom: return makeImageSource(request);
    default: return makeMeshSource(request);
    }
}

} // namespace tetra
