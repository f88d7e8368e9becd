// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/hdf5/helper/hdf5_arrays.h"

#include "plugins/readers/hdf5/helper/attributes.h"

#include <algorithm>
#include <limits>
#include <set>

#include <sys/resource.h>

namespace tetra {
namespace {

/// More than anybody wrote.
constexpr int mostDepth = 64;
constexpr std::size_t mostObjects = 200'000;

/// No other file can be opened from here on, whatever the library finds in this one.
void openNoMoreFiles()
{
    const rlimit none{0, 0};
    setrlimit(RLIMIT_NOFILE, &none);
}

struct GroupLinks {
    std::vector<std::string> hard;
    std::vector<std::string> external;
};

herr_t addLink(hid_t, const char* name, const H5L_info_t* link, void* to)
{
    auto& links = *static_cast<GroupLinks*>(to);
    if (link->type == H5L_TYPE_HARD)
        links.hard.emplace_back(name);
    else if (link->type == H5L_TYPE_EXTERNAL)
        links.external.emplace_back(name);
    return links.hard.size() + links.external.size() < mostObjects ? 0 : 1;
}

/// All groups from one on.
class Walk {
public:
    explicit Walk(hid_t file) : file_(file) {}

    Hdf5Listing listing()
    {
        if (H5O_info_t top{}; H5Oget_info_by_name(file_, "/", &top, H5P_DEFAULT) >= 0)
            seen_.insert(top.addr);
        visit("", openGroup(file_, "/"), 0);
        if (isCutShort_)
            listing_.leftOut.push_back(Message::say("It holds more than %1 groups and arrays, or groups nested more "
                                                    "than %2 levels deep: not all of them were examined.",
                                                    mostObjects, mostDepth));
        if (!external_.empty())
            listing_.leftOut.push_back(Message::say("Its links into other files are not followed: %1.", external_));
        return std::move(listing_);
    }

private:
    void visit(const std::string& prefix, const Hdf5Id& group, int depth)
    {
        GroupLinks links;
        if (!group || depth > mostDepth) {
            isCutShort_ |= bool(group);
            return;
        }
        H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, nullptr, addLink, &links);
        for (const std::string& name : links.external)
            addExternal(prefix + "/" + name);
        const std::string signal = attributeText(group, "signal");
        for (const std::string& name : links.hard) {
            H5O_info_t info{};
            if (H5Oget_info_by_name(group, name.c_str(), &info, H5P_DEFAULT) < 0 || !seen_.insert(info.addr).second)
                continue;
            if (seen_.size() > mostObjects) {
                isCutShort_ = true;
                return;
            }
            const std::string path = prefix + "/" + name;
            if (info.type == H5O_TYPE_GROUP)
                visit(path, Hdf5Id(H5Gopen2(group, name.c_str(), H5P_DEFAULT), H5Gclose), depth + 1);
            else if (info.type == H5O_TYPE_DATASET)
                add(path, Hdf5Id(H5Dopen2(group, name.c_str(), H5P_DEFAULT), H5Dclose), name == signal);
        }
    }

    void add(const std::string& path, const Hdf5Id& array, bool isSignal)
    {
        const Hdf5Id type(array ? H5Dget_type(array) : H5I_INVALID_HID, H5Tclose);
        const Hdf5Id creation(array ? H5Dget_create_plist(array) : H5I_INVALID_HID, H5Pclose);
        if (!type || !creation)
            return;
        Hdf5Array found{.path = path, .element = elementTypeOf(type)};
        const auto old = attributeNumbers(array, "signal"); // as NeXus once said it
        found.isShown = isSignal || (old.size() == 1 && old[0] == 1);
        // The library would look for the files of a virtual one to tell its size.
        found.liesElsewhere = H5Pget_layout(creation) == H5D_VIRTUAL || H5Pget_external_count(creation) > 0;
        const Hdf5Id space(found.liesElsewhere ? H5I_INVALID_HID : H5Dget_space(array), H5Sclose);
        const int rank = space ? H5Sget_simple_extent_ndims(space) : 0;
        std::vector<hsize_t> size(static_cast<std::size_t>(std::max(rank, 0)));
        if (rank > 0 && H5Sget_simple_extent_dims(space, size.data(), nullptr) == rank)
            found.size.assign(size.begin(), size.end());
        listing_.arrays.push_back(std::move(found));
    }

    void addExternal(const std::string& path)
    {
        constexpr int mostNamed = 12;
        if (++externals_ > mostNamed)
            return;
        const Message name("'" + printable(path) + "'");
        external_ = external_.empty() ? name : Message::say("%1, %2", external_, name);
    }

    hid_t file_;
    std::set<haddr_t> seen_{};
    Hdf5Listing listing_{};
    Message external_{};
    int externals_ = 0;
    bool isCutShort_ = false;
};

bool has(hid_t file, const char* name)
{
    return H5Lexists(file, name, H5P_DEFAULT) > 0;
}

/// Of formats inside HDF5 whose rules would be broken by taking their arrays as they are.
Status checkFormat(hid_t file)
{
    const auto hasOwnReader = [](const char* format, const char* ending) -> Status {
        return Error{ErrorKind::BadInput,
                     Message::say("it is a file of %1, which TAn recognises by its name. Give it the ending %2.",
                                  format, ending)};
    };
    if (has(file, "VTKHDF"))
        return hasOwnReader("VTK HDF", ".vtkhdf");
    if (has(file, " hdf5version") && has(file, " format"))
        return hasOwnReader("CGNS", ".cgns");
    if (has(file, "INFOS_GENERALES"))
        return hasOwnReader("MED", ".med");
    if (hasAttribute(file, "_NCProperties"))
        return hasOwnReader("NetCDF-4", ".nc");
    if (has(file, "minc-2.0"))
        return Error{ErrorKind::BadInput, Message::say("it is a MINC 2 file, whose numbers are scaled slice by slice; "
                                                       "this is not read. Convert it with mnc2nii.")};
    return {};
}

std::string lastPart(const std::string& path)
{
    return path.substr(path.rfind('/') + 1);
}

Error noVolume(const Hdf5Listing& listing)
{
    std::vector<const Hdf5Array*> all;
    for (const Hdf5Array& array : listing.arrays)
        all.push_back(&array);
    if (all.empty() && !listing.leftOut.empty())
        return {ErrorKind::BadInput, Message::say("it holds no arrays of its own. %1 Open the file that holds them.",
                                                  listing.leftOut.back())};
    if (all.empty())
        return {ErrorKind::BadInput, Message::say("it holds no arrays. Write it with values.")};
    return {ErrorKind::BadInput,
            Message::say("none of its arrays has numbers along three dimensions with two points or more: %1. TAn takes "
                         "volumes: choose a file that holds one, or write one, for instance with h5py.",
                         arraysText(all))};
}

Error noSuchArray(const std::vector<const Hdf5Array*>& volumes, const std::string& wanted)
{
    return {ErrorKind::WrongUsage,
            Message::say("it has no array '%1'. Choose one of these: %2.", printable(wanted), arraysText(volumes))};
}

/// By a path that may lead over links inside the file to an array that is listed by another one.
const Hdf5Array* findByPath(hid_t file, const Hdf5Listing& listing, const std::string& wanted)
{
    const std::string path = wanted.starts_with('/') ? wanted : "/" + wanted;
    if (const auto found = std::ranges::find(listing.arrays, path, &Hdf5Array::path); found != listing.arrays.end())
        return &*found;
    H5O_info_t info{};
    if (H5Oget_info_by_name(file, path.c_str(), &info, H5P_DEFAULT) < 0)
        return nullptr;
    const auto found = std::ranges::find_if(listing.arrays, [&](const Hdf5Array& array) {
        H5O_info_t other{};
        return H5Oget_info_by_name(file, array.path.c_str(), &other, H5P_DEFAULT) >= 0 && other.addr == info.addr;
    });
    return found == listing.arrays.end() ? nullptr : &*found;
}

Status checkChosen(const Hdf5Array& array)
{
    if (array.liesElsewhere)
        return Error{ErrorKind::BadInput,
                     Message::say("the values of its array '%1' lie in other files or arrays, which are not opened. "
                                  "Copy them into an array of their own, for instance with h5py.",
                                  printable(array.path))};
    if (array.element.kind == NumberKind::None)
        return Error{
            ErrorKind::WrongUsage,
            Message::say("its array %1 holds no numbers that can be read. Choose another one.", arrayText(array))};
    if (!isVolume(array))
        return Error{ErrorKind::WrongUsage, Message::say("its array %1 does not extend along three dimensions with two "
                                                         "points or more. Choose one that does.",
                                                         arrayText(array))};
    return {};
}

std::uint64_t pointsOf(const Hdf5Array& array)
{
    std::uint64_t points = 1;
    for (const std::uint64_t length : array.size)
        points = length != 0 && points > std::numeric_limits<std::uint64_t>::max() / length
                     ? std::numeric_limits<std::uint64_t>::max()
                     : points * length;
    return points;
}

ChosenArray largestOf(const std::vector<const Hdf5Array*>& arrays)
{
    const auto largest = std::ranges::max_element(arrays, {}, [](const Hdf5Array* one) { return pointsOf(*one); });
    return {*largest, arrays.size() > 1};
}

} // namespace

Result<Hdf5Id> openHdf5(const std::string& path)
{
    Hdf5Id file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
    if (!file && H5Fis_hdf5(path.c_str()) == 0)
        return Error{ErrorKind::BadInput,
                     Message::say("it does not begin like an HDF5 file. It is damaged, or of another format.")};
    if (!file) {
        H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT); // the question has cleared the reason
        return hdf5Error(Message::say("the whole file"));
    }
    openNoMoreFiles();
    if (const Status fits = checkFormat(file); !fits)
        return fits.error();
    return file;
}

Hdf5Listing listingOf(hid_t file)
{
    return Walk(file).listing();
}

bool isVolume(const Hdf5Array& array)
{
    return array.element.kind != NumberKind::None && !array.liesElsewhere &&
           std::ranges::find(array.size, 0U) == array.size.end() &&
           std::ranges::count_if(array.size, [](std::uint64_t length) { return length > 1; }) >= 3;
}

Message arrayText(const Hdf5Array& array)
{
    std::string size;
    for (const std::uint64_t length : array.size)
        size += (size.empty() ? "" : " x ") + std::to_string(length);
    const Message name("'" + printable(array.path) + "'");
    const std::string type = printable(array.element.text);
    if (array.liesElsewhere)
        return Message::say("%1 (in other files)", name);
    return Message("'" + printable(array.path) + "' (" + (size.empty() ? "" : size + ", ") + type + ")");
}

Message arraysText(const std::vector<const Hdf5Array*>& arrays)
{
    constexpr std::size_t mostNamed = 12;
    Message all;
    for (std::size_t at = 0; at < std::min(mostNamed, arrays.size()); ++at)
        all = all.empty() ? arrayText(*arrays[at]) : Message::say("%1, %2", all, arrayText(*arrays[at]));
    return arrays.size() > mostNamed ? Message::say("%1 and %2 more", all, arrays.size() - mostNamed) : all;
}

Result<ChosenArray> chooseArray(hid_t file, const Hdf5Listing& listing, const Hdf5Request& request)
{
    std::vector<const Hdf5Array*> volumes, shown, named;
    for (const Hdf5Array& array : listing.arrays) {
        if (lastPart(array.path) == request.array)
            named.push_back(&array);
        if (isVolume(array))
            volumes.push_back(&array);
        if (isVolume(array) && array.isShown)
            shown.push_back(&array);
    }
    if (isAutomatic(request) && volumes.empty())
        return noVolume(listing);
    if (isAutomatic(request))
        return largestOf(shown.empty() ? volumes : shown);
    const auto number = parseNumber<std::uint64_t>(request.array);
    const Hdf5Array* found = findByPath(file, listing, request.array);
    if (found == nullptr && named.size() == 1)
        found = named.front();
    if (found == nullptr && number && *number >= 1 && *number <= volumes.size())
        found = volumes[*number - 1];
    if (found == nullptr)
        return volumes.empty() ? noVolume(listing) : noSuchArray(volumes, request.array);
    if (const Status fits = checkChosen(*found); !fits)
        return fits.error();
    return ChosenArray{found, false};
}

} // namespace tetra
