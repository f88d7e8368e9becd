// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/helper/image_sources.h"

#include "plugins/api/placement_parameters.h"
#include "plugins/readers/vtk/checks/metaimage_header.h"
#include "plugins/readers/vtk/checks/slice_names.h"

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

/// VTK takes no notice of the directions.
Result<VtkSource> metaImageSource(const std::string& path)
{
    const auto place = metaImagePlace(fs::path(path));
    if (!place)
        return place.error();
    VtkSource source = imageSource<vtkMetaImageReader>(path);
    if (!*place)
        return source;
    source.untold = (*place)->untold;
    const auto put = [stated = (*place)->lattice](Lattice& lattice) {
        const auto size = lattice.size;
        lattice = stated;
        lattice.size = size;
    };
    source.finish = [put, stated = **place](VtkFindings& found) {
        put(found.lattice);
        found.space = stated.space;
        found.lengthUnit = stated.lengthUnit;
        found.remarks.insert(found.remarks.end(), stated.remarks.begin(), stated.remarks.end());
    };
    source.finishContents = [put](FileContents& contents) { put(contents.lattice); };
    return source;
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
    return {.reader = reader, .untold = untoldPlacement(false, false, false)};
}

/// The samples, times `slope` plus `intercept`: in double precision for the wider types, else single.
void rescale(VtkFindings& found, double slope, double intercept)
{
    if (found.kind != VtkDataKind::Lattice && found.kind != VtkDataKind::Grid)
        return;
    const SampleType from = found.type;
    const Buffer<std::byte> before = std::move(found.samples);
    const std::size_t count = before.size() / sampleSize(from);
    const bool wide = from == SampleType::Float64 || from == SampleType::Int32 || from == SampleType::UInt32;
    found.type = wide ? SampleType::Float64 : SampleType::Float32;
    found.samples = Buffer<std::byte>(count * sampleSize(found.type));
    visitSampleType(from, [&]<class T>() {
        const T* samples = reinterpret_cast<const T*>(before.data());
        for (std::size_t i = 0; i < count; ++i) {
            const double value = static_cast<double>(samples[i]) * slope + intercept;
            if (wide)
                reinterpret_cast<double*>(found.samples.data())[i] = value;
            else
                reinterpret_cast<float*>(found.samples.data())[i] = static_cast<float>(value);
        }
    });
    found.remarks.push_back(Message::say("The samples were multiplied and shifted as the header of the file asks."));
}

Result<VtkSource> niftiSource(const std::string& path)
{
    const auto reader = vtkSmartPointer<vtkNIFTIImageReader>::New();
    if (reader->CanReadFile(path.c_str()) == 0)
        return Error{ErrorKind::BadInput, Message::say("its header is not that of a NIfTI file.")};
    reader->SetFileName(path.c_str());
    const auto finish = [reader](VtkFindings& found) {
        const double slope = reader->GetRescaleSlope();
        if (slope != 0 && (slope != 1 || reader->GetRescaleIntercept() != 0))
            rescale(found, slope, reader->GetRescaleIntercept());
    };
    return VtkSource{.reader = reader, .finish = finish, .knowsContents = true};
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
    case VtkFormat::MetaImage: return metaImageSource(request.path);
    case VtkFormat::Nifti: return niftiSource(request.path);
    case VtkFormat::Mrc: return imageSource<vtkMRCReader>(request.path);
    case VtkFormat::Tiff: return tiffSource(request.path);
    default: return dicomSource(request.path);
    }
}

} // namespace tetra
