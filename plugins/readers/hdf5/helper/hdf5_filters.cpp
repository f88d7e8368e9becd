// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/hdf5/helper/hdf5_filters.h"

#include <algorithm>
#include <array>

namespace tetra {
namespace {

struct KnownFilter {
    H5Z_filter_t number;
    const char* name;
};

/// From the list of The HDF Group: https://github.com/HDFGroup/hdf5_plugins/blob/master/docs/RegisteredFilterPlugins.md
constexpr std::array<KnownFilter, 15> knownFilters = {{{H5Z_FILTER_SZIP, "szip"},
                                                       {305, "LZO"},
                                                       {307, "bzip2"},
                                                       {32000, "LZF"},
                                                       {32001, "Blosc"},
                                                       {32004, "LZ4"},
                                                       {32008, "bitshuffle"},
                                                       {32013, "ZFP"},
                                                       {32014, "fpzip"},
                                                       {32015, "Zstandard"},
                                                       {32017, "SZ"},
                                                       {32019, "JPEG"},
                                                       {32023, "FCIDECOMP"},
                                                       {32024, "SZ3"},
                                                       {32026, "Blosc2"}}};

bool canUnpack(H5Z_filter_t filter)
{
    unsigned abilities = 0;
    return H5Zfilter_avail(filter) > 0 && H5Zget_filter_info(filter, &abilities) >= 0 &&
           (abilities & H5Z_FILTER_CONFIG_DECODE_ENABLED) != 0;
}

/// "Blosc"; what the file calls it, or nothing, for one that nobody here knows.
std::string nameOf(H5Z_filter_t filter, const char* inFile)
{
    const auto known = std::ranges::find(knownFilters, filter, &KnownFilter::number);
    return known != knownFilters.end() ? std::string(known->name) : std::string(inFile);
}

} // namespace

Status checkFilters(hid_t creation, const std::string& array)
{
    const int filters = H5Pget_nfilters(creation);
    for (int at = 0; at < filters; ++at) {
        std::array<char, 64> inFile{};
        unsigned flags = 0;
        std::size_t count = 0;
        const H5Z_filter_t filter = H5Pget_filter2(creation, static_cast<unsigned>(at), &flags, &count, nullptr,
                                                   inFile.size() - 1, inFile.data(), nullptr);
        if (filter < 0)
            return Error{
                ErrorKind::BadInput,
                Message::say(
                    "its array '%1' does not state how it is packed. The file is damaged: copy or export it again.",
                    printable(array))};
        if (canUnpack(filter))
            continue;
        const std::string name = nameOf(filter, inFile.data());
        const Message number = Message::say("number %1", filter);
        return Error{
            ErrorKind::BadInput,
            Message::say(
                "its array '%1' is packed with the filter %2, which is not part of HDF5 and is not read. Write it with "
                "gzip or unpacked: 'h5repack -f GZIP=4 old.h5 new.h5' does so where the filter is installed.",
                printable(array), name.empty() ? number : Message::say("%1 (%2)", printable(name), number))};
    }
    return {};
}

} // namespace tetra
