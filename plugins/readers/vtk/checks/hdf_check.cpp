// SPDX-License-Identifier: GPL-3.0-or-later
// The format: https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html#vtkhdf-file-format
#include "plugins/readers/vtk/checks/format_checks.h"

#include <algorithm>
#include <string_view>

namespace tetra {
namespace {

std::uint64_t numberAt(std::string_view bytes, std::size_t place)
{
    std::uint64_t number = 0;
    for (std::size_t byte = 8; byte-- > 0;)
        number = number << 8U | static_cast<unsigned char>(bytes[place + byte]);
    return number;
}

/// Whether it is a list of the parts of a virtual array: a version, how many there are, and of the first the names of a
/// file and of an array in it.
bool isListOfParts(std::string_view object)
{
    constexpr std::size_t names = 9;
    constexpr std::uint64_t most = 1U << 20U;
    if (object.size() < names + 4 || object[0] != 0 || numberAt(object, 1) < 1 || numberAt(object, 1) > most)
        return false;
    const std::string_view file = object.substr(names, object.substr(names).find('\0'));
    const std::string_view array = object.substr(std::min(names + file.size() + 1, object.size()));
    const auto isText = [](std::string_view text) {
        return !text.empty() && std::ranges::none_of(text, [](char c) { return static_cast<unsigned char>(c) < ' '; });
    };
    return isText(file) && isText(array.substr(0, array.find('\0'))) && array.find('\0') != std::string_view::npos;
}

} // namespace

Status checkHdfIsWhole(std::string_view bytes)
{
    using namespace std::string_view_literals;
    constexpr std::size_t header = 16, sizeAt = 8;
    for (auto heap = bytes.find("GCOL\1"sv); heap != std::string_view::npos; heap = bytes.find("GCOL\1"sv, heap + 1)) {
        std::string_view objects = bytes.substr(heap);
        if (objects.size() < header)
            break;
        objects = objects.substr(header, numberAt(objects, sizeAt));
        while (objects.size() > header && (objects[0] != 0 || objects[1] != 0)) { // number 0 is free room
            const std::uint64_t size = numberAt(objects, sizeAt);
            if (isListOfParts(objects.substr(header, size)))
                return Error{ErrorKind::BadInput,
                             Message::say("the values of one of its arrays lie in other files or arrays, which are not "
                                          "opened. Copy them into an array of their own, for instance with h5py.")};
            objects.remove_prefix(std::min<std::uint64_t>(
                header + (std::min<std::uint64_t>(size, objects.size()) + 7) / 8 * 8, objects.size()));
        }
    }
    return {};
}

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
        return Error{ErrorKind::BadInput, Message::say("it is an HDF4 file, which is not read. Convert it to .vti or "
                                                       ".vtu, for instance with h4toh5 and ParaView.")};
    if (bytes.substr(0, userBlock).find("\x89HDF\r\n\x1a\n"sv) == std::string_view::npos)
        return Error{ErrorKind::BadInput,
                     Message::say("it does not begin like an HDF5 file. It is damaged, or of another format.")};
    if (const Status whole = checkHdfIsWhole(bytes); !whole)
        return whole.error();
    const std::string_view names = bytes.substr(0, looked);
    if (names.find("VTKHDF"sv) == std::string_view::npos)
        return Error{ErrorKind::BadInput,
                     Message::say("it is an HDF5 file of another program: it does not have the group VTKHDF, by which "
                                  "VTK recognises its own. Write it as .vti or .vtu.")};
    for (const std::string_view type : {"PartitionedDataSetCollection"sv, "MultiBlockDataSet"sv, "OverlappingAMR"sv,
                                        "HyperTreeGrid"sv, "NSteps"sv, "PolyData"sv})
        if (names.find(type) != std::string_view::npos &&
            (type != "PolyData"sv || names.find("UnstructuredGrid"sv) == std::string_view::npos))
            return Error{
                ErrorKind::BadInput,
                type == "NSteps"sv
                    ? Message::say("it is a VTK HDF file with several time steps, which VTK 9.1 does not read. Write "
                                   "one time step as .vti or .vtu.")
                    : Message::say(
                          "it is a VTK HDF file of the type %1, which VTK 9.1 does not read. Write it as .vti or .vtu.",
                          type)};
    return CheckedFile{.bytes = bytes.size(), .unpackedBytes = boundedProduct(usualPacking, bytes.size())};
}

} // namespace tetra
