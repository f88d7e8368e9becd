// SPDX-License-Identifier: GPL-3.0-or-later
// Takes arbitrary bytes for the coded part of a packed mesh, whose sizes and sums are right. What comes of it is a mesh
// whose corners exist, and which comes back once more.
#include "core/base/checksum.h"
#include "core/packed/packed_mesh.h"
#include "tests/fuzz/fuzz_input.h"

#include <array>
#include <cstring>

namespace {

using namespace tetra;

constexpr std::array<std::uint8_t, 8> magic = {0x89, 'T', 'A', 'N', 'M', 0x0d, 0x0a, 0x1a};

template <class Number> void append(std::vector<std::byte>& bytes, Number number)
{
    const auto* begin = reinterpret_cast<const std::byte*>(&number);
    bytes.insert(bytes.end(), begin, begin + sizeof number);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    constexpr std::uint64_t most = 4000;
    constexpr std::size_t scaleBytes = 6 * sizeof(double);
    const bool withScale = size > 0 && (bytes[0] & 2) != 0;
    const std::size_t front = 5 + (withScale ? scaleBytes : 0);
    if (size < front)
        return 0;
    std::vector<std::byte> packed;
    append(packed, magic);
    append(packed, std::uint32_t(1));
    append(packed, std::uint32_t(bytes[0] & 3));
    append(packed, std::uint64_t(bytes[1] | bytes[2] << 8) % most);
    append(packed, std::uint64_t(bytes[3] | bytes[4] << 8) % most);
    append(packed, std::uint64_t(0)); // no facts
    append(packed, std::uint64_t(size - front));
    const auto* scale = reinterpret_cast<const std::byte*>(bytes + 5);
    packed.insert(packed.end(), scale, scale + (front - 5));
    const auto* coded = reinterpret_cast<const std::byte*>(bytes + front);
    packed.insert(packed.end(), coded, coded + (size - front));
    append(packed, checksum(packed));
    const auto unpacked = unpackMesh(packed, most);
    if (!unpacked)
        return 0;
    const TetrahedralMesh& mesh = unpacked->mesh;
    require(mesh.values.size() == mesh.positions.size(), "each vertex has a value");
    for (const auto& corners : mesh.tetrahedra)
        require(*std::ranges::max_element(corners) < mesh.positions.size(), "corners exist");
    const auto again = packMesh(mesh, unpacked->birthErrors, unpacked->deathErrors, "");
    require(again.ok(), "what was unpacked can be packed");
    const auto same = unpackMesh(*again, most);
    require(same.ok() && same->mesh.tetrahedra.size() == mesh.tetrahedra.size() &&
                same->mesh.positions.size() == mesh.positions.size(),
            "and comes back");
    return 0;
}
