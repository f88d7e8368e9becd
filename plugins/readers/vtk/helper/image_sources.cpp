// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/helper/image_sources.h"

#include "plugins/api/placement_parameters.h"
#include "plugins/readers/vtk/checks/slice_names.h"

#include <vtkDICOMImageReader.h>
#include <vtkStringArray.h>
#include <vtkTIFFReader.h>

namespace tetra {
namespace {

namespace fs = std::filesystem;

VtkSource tiffSource(const std::string& path)
{
    const auto reader = vtkSmartPointer<vtkTIFFReader>::New();
    const std::vector<fs::path> slices = numberedBeside(path);
    if (slices.size() < 2) {
        reader->SetFileName(path.c_str());
    } else {
        const auto names = vtkSmartPointer<vtkStringArray>::New();
        for (const fs::path& slice : slices)
            names->InsertNextValue(slice.string());
        reader->SetFileNames(names);
    }
    return {.reader = reader, .untold = untoldPlacement(false, false, false)};
}

VtkSource dicomSource(const std::string& path)
{
    const auto reader = vtkSmartPointer<vtkDICOMImageReader>::New();
    reader->SetDirectoryName(fs::path(path).parent_path().c_str());
    return {.reader = reader};
}

} // namespace

Result<VtkSource> makeImageSource(const VtkRequest& request)
{
    return request.format == VtkFormat::Tiff ? tiffSource(request.path) : dicomSource(request.path);
}

} // namespace tetra
