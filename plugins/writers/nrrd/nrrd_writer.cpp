// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/api/plugin.h"
#include "plugins/api/writer.h"

#include <algorithm>
#include <bit>
#include <vector>

#include <zlib.h>

namespace tetra {
namespace {

std::string vectorText(const Eigen::Vector3d& vector)
{
    return "(" + formatNumber(vector[0]) + "," + formatNumber(vector[1]) + "," + formatNumber(vector[2]) + ")";
}

/// The unit of each axis of the space; nothing if it could not be read again.
std::string unitText(const std::string& unit)
{
    if (unit.empty() || unit.find_first_of("\"\\") != std::string::npos || printable(unit) != unit)
        return {};
    const std::string quoted = "\"" + unit + "\"";
    return "space units: " + quoted + " " + quoted + " " + quoted + "\n";
}

/// The steps of the frame in the space that the dataset names, or in one without a name.
std::string placeText(const Lattice& lattice, const std::string& space)
{
    const auto step = [&](Eigen::Index axis) {
        return vectorText(lattice.directions.col(axis) * lattice.spacing[axis]);
    };
    const std::string named = space == "RAS"   ? "right-anterior-superior"
                              : space == "LAS" ? "left-anterior-superior"
                              : space == "LPS" ? "left-posterior-superior"
                                               : "";
    return (named.empty() ? "space dimension: 3\n" : "space: " + named + "\n") +
           "sizes: " + std::to_string(lattice.size[0]) + " " + std::to_string(lattice.size[1]) + " " +
           std::to_string(lattice.size[2]) + "\nspace directions: " + step(0) + " " + step(1) + " " + step(2) +
           "\nspace origin: " + vectorText(lattice.origin) + "\n";
}

std::string headerText(const Dataset& dataset, const std::string& encoding)
{
    std::string text = "NRRD0004\n";
    if (!dataset.source.name.empty())
        text += "content: " + printable(dataset.source.name) + "\n";
    text += "type: " + std::string(sampleTypeName(dataset.values.type())) + "\n";
    text += "dimension: 3\n" + placeText(dataset.lattice, dataset.space) + unitText(dataset.lengthUnit);
    text += "kinds: domain domain domain\n";
    text += std::string("endian: ") + (std::endian::native == std::endian::little ? "little" : "big") + "\n";
    text += "encoding: " + encoding + "\n";
    // A comment of such a length that samples begin at a multiple of their size: then they are used where they lie.
    constexpr std::size_t largestSample = 8, besides = 3; // the comment's mark and the last two ends of lines
    const std::size_t beyond = (text.size() + besides) % largestSample;
    return text + std::string(1 + (largestSample - beyond) % largestSample, '#') + "\n\n";
}

constexpr std::size_t pieceBytes = std::size_t(1) << 20;

/// Owns what zlib allocates.
struct Packer {
    Packer()
    {
        constexpr int gzipOnly = 16;
        constexpr int usualMemory = 8;
        ready = ::deflateInit2(&state, Z_DEFAULT_COMPRESSION, Z_DEFLATED, MAX_WBITS + gzipOnly, usualMemory,
                               Z_DEFAULT_STRATEGY) == Z_OK;
    }
    ~Packer() { ::deflateEnd(&state); }
    Packer(const Packer&) = delete;
    Packer& operator=(const Packer&) = delete;

    z_stream state{};
    bool ready = false;
};

/// Packs what `packer` was given and writes all that comes out.
Status pack(Packer& packer, int flush, std::span<std::byte> room, OutputFile& file)
{
    do {
        packer.state.next_out = reinterpret_cast<Bytef*>(room.data());
        packer.state.avail_out = static_cast<uInt>(room.size());
        ::deflate(&packer.state, flush);
        if (const Status written = file.bytes(room.first(room.size() - packer.state.avail_out)); !written)
            return written;
    } while (packer.state.avail_out == 0);
    return {};
}

/// Appends `content` as one gzip member (RFC 1952).
Status writeGzip(std::span<const std::byte> content, OutputFile& file)
{
    Packer packer;
    if (!packer.ready)
        return Error{ErrorKind::OutOfResource,
                     Message::say("Not enough memory to compress the data. Close other programs.")};
    std::vector<std::byte> room(pieceBytes);
    for (std::size_t done = 0; done < content.size();) {
        const std::size_t piece = std::min(pieceBytes, content.size() - done);
        packer.state.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(content.data() + done));
        packer.state.avail_in = static_cast<uInt>(piece);
        if (const Status packed = pack(packer, Z_NO_FLUSH, room, file); !packed)
            return packed;
        done += piece;
    }
    return pack(packer, Z_FINISH, room, file);
}

} // namespace

/// `.nrrd`: NRRD0004 with the data attached, raw or gzip. Reading it gives the same lattice and
/// samples, bit for bit, but for a rounding of directions that are not along the axes.
class NrrdWriter : public Writer {
public:
    std::vector<FileFormat> formats() const override
    {
        return {{WrittenContent::Dataset, Message::marked("NRRD volumes"), {".nrrd"}}};
    }

    std::vector<Parameter> parameters() const override
    {
        return {{"encoding",
                 Message::marked("Encoding"),
                 Message::marked("raw is quick to write and read, gzip is smaller."),
                 "",
                 std::string("raw"),
                 0,
                 0,
                 {Message::marked("raw"), Message::marked("gzip")}}};
    }

    Status writeDataset(const Dataset& dataset, OutputFile& file, const ParameterValues& values) const override
    {
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
        const auto samples = dataset.values.bytes();
        file.expect(samples.size());
        if (const Status written = file.text(headerText(dataset, encoding)); !written)
            return written;
        return encoding == "gzip" ? writeGzip(samples, file) : file.bytes(samples);
    }
};

} // namespace tetra

TAN_PLUGIN(tetra::NrrdWriter, tetra::Writer)
