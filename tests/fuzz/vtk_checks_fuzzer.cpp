// SPDX-License-Identifier: GPL-3.0-or-later
// Feeds what looks through files before VTK reads them: a byte for the format, two for the length of the first file,
// and two files, of which most formats need the first one only.
#include "plugins/readers/vtk/checks/file_check.h"
#include "plugins/readers/vtk/tecplot_text.h"
#include "tests/fuzz/fuzz_folder.h"
#include "tests/fuzz/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace tetra;
    using enum VtkFormat;
    constexpr std::array formats = {Xml, Legacy, Hdf, Fluent, EnSight, EnSight, Tecplot};
    constexpr std::size_t headBytes = 3;
    if (size < headBytes)
        return 0;
    static const FuzzFolder folder;
    const std::size_t kind = bytes[0] % formats.size();
    const std::span files = std::as_bytes(std::span(bytes, size)).subspan(headBytes);
    const std::size_t firstBytes = std::min<std::size_t>(bytes[1] + 256 * bytes[2], files.size());
    const auto first = files.first(firstBytes);
    const auto second = files.subspan(firstBytes);
    if (formats[kind] == Tecplot) {
        const auto read = readTecplot({reinterpret_cast<const char*>(files.data()), files.size()});
        if (!read)
            requireText(read.error());
        return 0;
    }
    VtkRequest request;
    request.format = formats[kind];
    if (request.format == EnSight) {
        const std::string type = kind % 2 == 0 ? "ensight gold" : "ensight";
        request.path =
            folder.write("run.case", asBytes("FORMAT\ntype: " + type +
                                             "\nGEOMETRY\nmodel: run.geo\nVARIABLE\nscalar per node: a run.a\n"
                                             "vector per element: b run.a\n"));
        folder.write("run.geo", first);
        folder.write("run.a", second);
    } else {
        request.path = folder.write("flow.cas", first);
        folder.write("flow.dat", second);
    }
    if (const auto checked = checkBeforeVtk(request); !checked)
        requireText(checked.error());
    return 0;
}
