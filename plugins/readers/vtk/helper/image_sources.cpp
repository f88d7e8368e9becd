// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/helper/image_sources.h"

#include "plugins/readers/vtk/helper/slice_names.h"

#include <vtkDICOMImageReader.h>
#include <vtkMRCReader.h>
#include <vtkMetaImageReader.h>
#include <vtkNIFTIImageReader.h>
#include <vtkStringArray.h>
#include <vtkTIFFReader.h>

namespace tetra {
namespace {

namespace fs = std::filesystem;

template <class Reader> VtkSource imageSource(const std::string& path)
{
    const auto reader = vtkSmartPointer<Reader>::New();
    reader->SetFileName(path.c_str());
    return {.reader = reader, .knowsContents = true};
}

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
    return {.reader = reader};
}

Result<VtkSource> niftiSource(const std::string& path)
{
    const auto reader = vtkSmartPointer<vtkNIFTIImageReader>::New();
    if (reader->CanReadFile(path.c_str()) == 0)
        return Error{ErrorKind::BadInput, "its header is not that of a NIfTI file."};
    reader->SetFileName(path.c_str());
    return VtkSource{.reader = reader, .knowsContents = true};
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
    switch (request.format) {
    case VtkFormat::MetaImage: return imageSource<vtkMetaImageReader>(request.path);
    case VtkFormat::Nifti: return niftiSource(request.path);
    case VtkFormat::Mrc: return imageSource<vtkMRCReader>(request.path);
    case VtkFormat::Tiff: return tiffSource(request.path);
    default: return dicomSource(request.path);
    }
}

} // namespace tetra
