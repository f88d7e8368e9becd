// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/checks/file_check.h"

#include "plugins/readers/vtk/checks/format_checks.h"

#include <algorithm>
#include <string_view>

namespace tetra {
namespace {

namespace fs = std::filesystem;

std::uint64_t fileBytes(const fs::path& path)
{
    std::error_code problem;
    const auto size = fs::file_size(path, problem);
    return problem ? 0 : size;
}

std::string_view textOf(const MappedFile& file)
{
    return {reinterpret_cast<const char*>(file.bytes().data()), file.bytes().size()};
}

} // namespace

Result<fs::path> fileBelow(const fs::path& home, const fs::path& folder, const std::string& name)
{
    const fs::path base = home.lexically_normal();
    const fs::path file = (folder / name).lexically_normal();
    const fs::path within = file.lexically_relative(base.empty() ? "." : base);
    if (name.empty() || name.find('\0') != std::string::npos || within.empty() || *within.begin() == "..")
        return Error{ErrorKind::BadInput, Message::say("it refers to the file '%1', which is not in its folder or "
                                                       "below it. Put it there, and correct its name.",
                                                       printable(name))};
    return file;
}

bool isToldByHeaders(const fs::path& path)
{
    constexpr std::uint64_t most = 64ULL << 20U; // as 'tan info' reads files that are not larger
    return fileBytes(path) > most;
}

Result<CheckedFile> checkBeforeVtk(const VtkRequest& request)
{
    const fs::path path = request.path;
    switch (request.format) {
    case VtkFormat::Xml: return checkXml(path);
    case VtkFormat::Legacy: return checkLegacy(path);
    case VtkFormat::EnSight: return checkEnSight(path, std::max<std::int64_t>(1, request.timeStep));
    case VtkFormat::OpenFoam: return checkFoam(path);
    case VtkFormat::Fluent: return checkFluent(path);
    case VtkFormat::Hdf: return checkVtkHdf(path);
    case VtkFormat::Cgns:
        if (request.contentsOnly && isToldByHeaders(path))
            return CheckedFile{.bytes = fileBytes(path)};
        if (const auto file = MappedFile::open(path); !file)
            return file.error();
        else if (const Status whole = checkHdfIsWhole(textOf(**file)); !whole)
            return whole.error();
        return CheckedFile{.bytes = fileBytes(path), .unpackedBytes = boundedProduct(usualPacking, fileBytes(path))};
    default: return CheckedFile{.bytes = fileBytes(path)};
    }
}

} // namespace tetra
