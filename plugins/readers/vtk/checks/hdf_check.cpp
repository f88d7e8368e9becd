// SPDX-License-Identifier: GPL-3.0-or-later
// The format: https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html#vtkhdf-file-format
#include "plugins/readers/vtk/checks/format_checks.h"

#include <string_view>

namespace tetra {

Result<CheckedFile> checkVtkHdf(const std::filesystem::path& path)
{
    using namespace std::string_view_literals;
    constexpr std::size_t looked = std::size_t(64) << 20;
    constexpr std::size_t userBlock = 4096; // that may stand before the signature
    const auto file = MappedFile::open(path);
    if (!file)
        return file.error();
    const std::string_view bytes(reinterpret_cast<const char*>((*file)->bytes().data()), (*file)->bytes().size());
    if (bytes.starts_with("\x0e\x03\x13\x01"sv))
        return Error{ErrorKind::BadInput, Message::say("it is an HDF4 file, which is not read. Convert it, for "
                                                       "instance with h4toh5 and ParaView, to .vti or .vtu.")};
    if (bytes.substr(0, userBlock).find("\x89HDF\r\n\x1a\n"sv) == std::string_view::npos)
        return Error{ErrorKind::BadInput,
                     Message::say("it does not begin as HDF5 files do. It is damaged, or of another format.")};
    const std::string_view names = bytes.substr(0, looked);
    if (names.find("VTKHDF"sv) == std::string_view::npos)
        return Error{ErrorKind::BadInput, Message::say("it is an HDF5 file of another program: it has no group VTKHDF, "
                                                       "by which VTK knows its own. Write it as .vti or .vtu.")};
    for (const std::string_view type : {"PartitionedDataSetCollection"sv, "MultiBlockDataSet"sv, "OverlappingAMR"sv,
                                        "HyperTreeGrid"sv, "NSteps"sv, "PolyData"sv})
        if (names.find(type) != std::string_view::npos &&
            (type != "PolyData"sv || names.find("UnstructuredGrid"sv) == std::string_view::npos))
            return Error{ErrorKind::BadInput,
                         type == "NSteps"sv
                             ? Message::say("it is a VTK HDF file of several time steps, a kind that came after VTK "
                                            "9.1. Write one time step as .vti or .vtu.")
                             : Message::say("it is a VTK HDF file of the type %1, which came after VTK 9.1. Write it "
                                            "as .vti or .vtu.",
                                            type)};
    return CheckedFile{.bytes = bytes.size(), .unpackedBytes = boundedProduct(usualPacking, bytes.size())};
}

} // namespace tetra
