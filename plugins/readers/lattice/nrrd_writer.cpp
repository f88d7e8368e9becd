// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/nrrd_writer.h"

#include "core/base/file_writer.h"
#include "core/base/text.h"
#include "plugins/readers/lattice/field_text.h"
#include "plugins/readers/lattice/gzip_encoding.h"

#include <algorithm>
#include <bit>
#include <new>

namespace tetra {

namespace {

std::string vectorText(double x, double y, double z)
{
    return "(" + formatNumber(x) + "," + formatNumber(y) + "," + formatNumber(z) + ")";
}

std::string headerText(const Dataset& dataset, const std::string& encoding)
{
    const Lattice& lattice = dataset.lattice;
    const Eigen::Vector3d& spacing = lattice.spacing;
    std::string text = "NRRD0004\n";
    if (!dataset.source.name.empty())
        text += "content: " + printable(dataset.source.name) + "\n";
    text += "type: " + std::string(sampleTypeName(dataset.values.type())) + "\n";
    text += "dimension: 3\nspace dimension: 3\n";
    text += "sizes: " + std::to_string(lattice.size[0]) + " " + std::to_string(lattice.size[1]) + " " +
            std::to_string(lattice.size[2]) + "\n";
    text += "space directions: " + vectorText(spacing[0], 0, 0) + " " + vectorText(0, spacing[1], 0) + " " +
            vectorText(0, 0, spacing[2]) + "\n";
    text += "space origin: " + vectorText(lattice.origin[0], lattice.origin[1], lattice.origin[2]) + "\n";
    text += "kinds: domain domain domain\n";
    text += std::string("endian: ") + (std::endian::native == std::endian::little ? "little" : "big") + "\n";
    text += "encoding: " + encoding + "\n\n";
    return text;
}

Status writeRaw(std::span<const std::byte> content, FileWriter& file, const Progress& progress)
{
    constexpr std::size_t pieceBytes = std::size_t(4) << 20;
    for (std::size_t done = 0; done < content.size(); done += pieceBytes) {
        if (progress.cancelled())
            return cancelledError(Message::marked("Writing"));
        const std::size_t piece = std::min(pieceBytes, content.size() - done);
        if (const Status written = file.write(content.subspan(done, piece)); !written)
            return written;
        progress.report(static_cast<double>(done + piece) / static_cast<double>(content.size()),
                        Message::marked("Writing"));
    }
    return {};
}

} // namespace

std::vector<std::string> NrrdWriter::nameFilters() const
{
    return {Message::marked("NRRD volume (*.nrrd)")};
}

double NrrdWriter::score(const std::filesystem::path& path) const
{
    return lowerCase(path.extension().string()) == ".nrrd" ? 1 : 0;
}

std::vector<Parameter> NrrdWriter::parameters() const
{
    return {{"encoding",
             "Encoding",
             "raw is quick to write and to read, gzip is smaller.",
             "",
             std::string("raw"),
             0,
             0,
             {"raw", "gzip"}}};
}

Status NrrdWriter::write(const Dataset& dataset, const std::filesystem::path& path, const ParameterValues& values,
                         const Progress& progress) const
try {
    const auto encoding = parameterValue<std::string>(parameters(), values, "encoding");
    if (encoding != "raw" && encoding != "gzip")
        return Error{
            ErrorKind::WrongUsage,
            Message::say("NRRD files are written with the encoding raw or gzip, not '%1'.", printable(encoding))};
    if (dataset.domain != DomainClass::RegularLattice)
        return Error{ErrorKind::WrongUsage,
                     Message::say("NRRD files hold regular lattices, and '%1' is %2. Give the file another ending: "
                                  ".xyz for curvilinear grids, .csv for scattered points.",
                                  dataset.source.name, domainClassText(dataset.domain))};
    Result<FileWriter> file = FileWriter::create(path);
    if (!file)
        return file.error();
    const std::string header = headerText(dataset, encoding);
    if (const Status written = file->write(std::as_bytes(std::span(header))); !written)
        return written;
    const auto samples = dataset.values.bytes();
    const Status written =
        encoding == "gzip" ? writeGzip(samples, *file, progress) : writeRaw(samples, *file, progress);
    if (!written)
        return written;
    if (const Status intact = dataset.checkIntact(); !intact)
        return intact;
    return file->commit();
} catch (const std::bad_alloc&) {
    return Error{ErrorKind::OutOfResource, Message::say("Not enough memory to write the file. Close other programs.")};
}

} // namespace tetra
