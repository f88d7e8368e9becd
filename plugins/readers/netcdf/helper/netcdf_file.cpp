// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/netcdf/helper/netcdf_file.h"

#include "plugins/process/process_limits.h"

#include <netcdf.h>

#include <algorithm>
#include <array>
#include <limits>

namespace tetra {
namespace {

/// Groups in one another, after which a file is none that anybody wrote.
constexpr int mostDepth = 64;

Error libraryError(int code, const Message& where)
{
    return {ErrorKind::BadInput, Message::say("the NetCDF library says of %1: %2. Copy or export the file again.",
                                              where, nc_strerror(code))};
}

Error variableError(int code, const NetCdfVariable& variable)
{
    return libraryError(code, Message::say("its variable '%1'", printable(variable.path)));
}

/// Without blanks and zeros at its end.
std::string unpadded(std::string text)
{
    text.resize(std::min(text.find('\0'), text.size()));
    text.erase(text.find_last_not_of(" \t\r\n") + 1);
    return text;
}

std::string textOf(int group, int variable, const char* attribute)
{
    nc_type type = NC_NAT;
    std::size_t length = 0;
    if (nc_inq_att(group, variable, attribute, &type, &length) != NC_NOERR || length == 0)
        return {};
    if (type == NC_CHAR) {
        std::string text(length, '\0');
        return nc_get_att_text(group, variable, attribute, text.data()) == NC_NOERR ? unpadded(std::move(text))
                                                                                    : std::string();
    }
    if (type != NC_STRING)
        return {};
    std::vector<char*> texts(length, nullptr);
    if (nc_get_att_string(group, variable, attribute, texts.data()) != NC_NOERR)
        return {};
    const std::string first = texts[0] == nullptr ? std::string() : unpadded(texts[0]);
    nc_free_string(length, texts.data());
    return first;
}

/// A virtual array has its values in other files, which are not opened: the library gives zeros for them. It calls
/// their storage virtual or, as 4.9.0 does, unknown.
Status checkIsHere(const NetCdfVariable& variable)
{
    int storage = NC_CONTIGUOUS;
    if (nc_inq_var_chunking(variable.group, variable.id, &storage, nullptr) != NC_NOERR || storage == NC_CONTIGUOUS ||
        storage == NC_CHUNKED || storage == NC_COMPACT)
        return {};
    return Error{ErrorKind::BadInput,
                 Message::say("the values of its array '%1' lie in other files or arrays, which are "
                              "not opened. Copy them into an array of their own, for instance with "
                              "h5py.",
                              printable(variable.name))};
}

} // namespace

std::size_t netCdfTypeBytes(int type) noexcept
{
    switch (type) {
    case NC_BYTE:
    case NC_UBYTE: return 1;
    case NC_SHORT:
    case NC_USHORT: return 2;
    case NC_INT:
    case NC_UINT:
    case NC_FLOAT: return 4;
    case NC_INT64:
    case NC_UINT64:
    case NC_DOUBLE: return 8;
    default: return 0;
    }
}

std::uint64_t valueCount(const NetCdfPart& part) noexcept
{
    constexpr std::uint64_t most = std::uint64_t(1) << 62;
    std::uint64_t product = 1;
    for (const std::size_t count : part.count)
        product = count != 0 && product > most / count ? most : product * count;
    return product;
}

Result<std::shared_ptr<const NetCdfFile>> NetCdfFile::open(const std::string& path)
{
    int id = -1;
    allowOneFile(); // the library would follow links of HDF5
    if (const int code = nc_open(path.c_str(), NC_NOWRITE, &id); code != NC_NOERR)
        return Error{
            ErrorKind::BadInput,
            code == NC_ENOTNC
                ? Message::say("it does not begin like a NetCDF file. It is of another format, or damaged.")
                : Message::say("the NetCDF library cannot open it: %1. Copy or export it again.", nc_strerror(code))};
    const std::shared_ptr<NetCdfFile> file(new NetCdfFile(id));
    if (const Status listed = file->list(id, {}, 0); !listed)
        return listed.error();
    return std::shared_ptr<const NetCdfFile>(file);
}

NetCdfFile::~NetCdfFile()
{
    nc_close(id_);
}

Status NetCdfFile::list(int group, const std::string& prefix, int depth)
{
    if (const Status listed = listDimensions(group); !listed)
        return listed;
    int count = 0;
    if (const int code = nc_inq_varids(group, &count, nullptr); code != NC_NOERR)
        return libraryError(code, Message::say("its variables"));
    std::vector<int> ids(static_cast<std::size_t>(count));
    if (const int code = nc_inq_varids(group, &count, ids.data()); code != NC_NOERR)
        return libraryError(code, Message::say("its variables"));
    for (const int id : ids)
        if (const Status listed = listVariable(group, id, prefix); !listed)
            return listed;
    if (nc_inq_grps(group, &count, nullptr) != NC_NOERR || count == 0 || depth >= mostDepth)
        return {};
    std::vector<int> groups(static_cast<std::size_t>(count));
    if (const int code = nc_inq_grps(group, &count, groups.data()); code != NC_NOERR)
        return libraryError(code, Message::say("its groups"));
    for (const int inner : groups) {
        std::array<char, NC_MAX_NAME + 1> name{};
        if (const int code = nc_inq_grpname(inner, name.data()); code != NC_NOERR)
            return libraryError(code, Message::say("its groups"));
        if (const Status listed = list(inner, prefix + name.data() + "/", depth + 1); !listed)
            return listed;
    }
    return {};
}

Status NetCdfFile::listDimensions(int group)
{
    int count = 0;
    if (const int code = nc_inq_dimids(group, &count, nullptr, 0); code != NC_NOERR)
        return libraryError(code, Message::say("its dimensions"));
    std::vector<int> ids(static_cast<std::size_t>(count));
    if (const int code = nc_inq_dimids(group, &count, ids.data(), 0); code != NC_NOERR)
        return libraryError(code, Message::say("its dimensions"));
    for (const int id : ids) {
        std::array<char, NC_MAX_NAME + 1> name{};
        std::size_t length = 0;
        if (const int code = nc_inq_dim(group, id, name.data(), &length); code != NC_NOERR)
            return libraryError(code, Message::say("its dimensions"));
        dimensionIds_.push_back(id);
        dimensions_.push_back({name.data(), length});
    }
    return {};
}

Status NetCdfFile::listVariable(int group, int id, const std::string& prefix)
{
    std::array<char, NC_MAX_NAME + 1> name{};
    nc_type type = NC_NAT;
    int rank = 0;
    if (const int code = nc_inq_var(group, id, name.data(), &type, &rank, nullptr, nullptr); code != NC_NOERR)
        return libraryError(code, Message::say("its variables"));
    std::vector<int> ids(static_cast<std::size_t>(rank));
    if (const int code = nc_inq_vardimid(group, id, ids.data()); code != NC_NOERR)
        return libraryError(code, Message::say("its variables"));
    NetCdfVariable variable{.group = group, .id = id, .name = name.data(), .path = prefix + name.data(), .type = type};
    for (const int dimension : ids) {
        const auto found = std::ranges::find(dimensionIds_, dimension);
        if (found == dimensionIds_.end())
            return Error{ErrorKind::BadInput,
                         Message::say("its variable '%1' has a dimension that none of its enclosing groups has. It is "
                                      "damaged: copy or export it again.",
                                      printable(variable.path))};
        variable.dimensions.push_back(static_cast<std::size_t>(found - dimensionIds_.begin()));
    }
    variables_.push_back(std::move(variable));
    return {};
}

std::optional<std::uint64_t> NetCdfFile::length(std::string_view dimension) const
{
    const auto found = std::ranges::find(dimensions_, dimension, &NetCdfDimension::name);
    return found == dimensions_.end() ? std::nullopt : std::optional(found->length);
}

const NetCdfVariable* NetCdfFile::find(std::string_view path) const
{
    if (path.starts_with('/'))
        path.remove_prefix(1);
    const auto found = std::ranges::find(variables_, path, &NetCdfVariable::path);
    return found == variables_.end() ? nullptr : &*found;
}

const NetCdfVariable* NetCdfFile::findFrom(const NetCdfVariable& from, std::string_view name) const
{
    for (std::string_view group(from.path);;) {
        const auto slash = group.rfind('/');
        group = slash == std::string_view::npos ? std::string_view() : group.substr(0, slash);
        const std::string path = group.empty() ? std::string(name) : std::string(group) + "/" + std::string(name);
        if (const NetCdfVariable* found = find(path); found != nullptr || group.empty())
            return found;
    }
}

std::string NetCdfFile::text(const NetCdfVariable& variable, const char* attribute) const
{
    return textOf(variable.group, variable.id, attribute);
}

bool NetCdfFile::hasGlobal(const char* attribute) const
{
    return nc_inq_att(id_, NC_GLOBAL, attribute, nullptr, nullptr) == NC_NOERR;
}

std::string NetCdfFile::globalText(const char* attribute) const
{
    return textOf(id_, NC_GLOBAL, attribute);
}

int NetCdfFile::attributeType(const NetCdfVariable& variable, const char* attribute) const
{
    nc_type type = NC_NAT;
    return nc_inq_atttype(variable.group, variable.id, attribute, &type) == NC_NOERR ? type : 0;
}

bool NetCdfFile::fillsUnwritten(const NetCdfVariable& variable) const
{
    int isUnfilled = 0;
    return nc_inq_var_fill(variable.group, variable.id, &isUnfilled, nullptr) != NC_NOERR || isUnfilled == 0;
}

std::vector<long double> NetCdfFile::numbers(const NetCdfVariable& variable, const char* attribute) const
{
    nc_type type = NC_NAT;
    std::size_t length = 0;
    if (nc_inq_att(variable.group, variable.id, attribute, &type, &length) != NC_NOERR || netCdfTypeBytes(type) == 0)
        return {};
    const auto read = [&]<class T>(T, int (*get)(int, int, const char*, T*)) {
        std::vector<T> values(length);
        if (get(variable.group, variable.id, attribute, values.data()) != NC_NOERR)
            values.clear();
        return std::vector<long double>(values.begin(), values.end());
    };
    if (type == NC_FLOAT || type == NC_DOUBLE)
        return read(double{}, nc_get_att_double);
    return type == NC_UINT64 ? read(0ULL, nc_get_att_ulonglong) : read(0LL, nc_get_att_longlong);
}

bool NetCdfFile::isNumeric(const NetCdfVariable& variable) noexcept
{
    return netCdfTypeBytes(variable.type) != 0;
}

std::string_view NetCdfFile::typeName(int type) noexcept
{
    constexpr std::array<std::string_view, 13> names = {"nothing", "int8",   "char",  "int16",  "int32",
                                                        "float",   "double", "uint8", "uint16", "uint32",
                                                        "int64",   "uint64", "text"};
    return type >= 0 && type < int(names.size()) ? names[static_cast<std::size_t>(type)] : "a type of its own";
}

std::uint64_t NetCdfFile::valueCount(const NetCdfVariable& variable) const noexcept
{
    return tetra::valueCount(whole(variable));
}

NetCdfPart NetCdfFile::whole(const NetCdfVariable& variable) const
{
    NetCdfPart part;
    for (const std::size_t dimension : variable.dimensions) {
        part.first.push_back(0);
        part.count.push_back(dimensions_[dimension].length);
    }
    return part;
}

Status NetCdfFile::readStored(const NetCdfVariable& variable, const NetCdfPart& part, void* to) const
{
    if (const Status here = checkIsHere(variable); !here)
        return here;
    if (const int code = nc_get_vara(variable.group, variable.id, part.first.data(), part.count.data(), to);
        code != NC_NOERR)
        return variableError(code, variable);
    return {};
}

Result<std::vector<double>> NetCdfFile::readDoubles(const NetCdfVariable& variable, const NetCdfPart& part) const
{
    std::vector<double> values(tetra::valueCount(part));
    if (values.empty())
        return values;
    if (const Status here = checkIsHere(variable); !here)
        return here.error();
    const int code =
        nc_get_vara_double(variable.group, variable.id, part.first.data(), part.count.data(), values.data());
    if (code != NC_NOERR && code != NC_ERANGE)
        return variableError(code, variable);
    return values;
}

Result<std::vector<std::int64_t>> NetCdfFile::readIntegers(const NetCdfVariable& variable) const
{
    static_assert(sizeof(long long) == sizeof(std::int64_t));
    const NetCdfPart part = whole(variable);
    std::vector<long long> values(tetra::valueCount(part));
    if (const Status here = checkIsHere(variable); !here)
        return here.error();
    if (!values.empty())
        if (const int code =
                nc_get_vara_longlong(variable.group, variable.id, part.first.data(), part.count.data(), values.data());
            code != NC_NOERR)
            return variableError(code, variable);
    return std::vector<std::int64_t>(values.begin(), values.end());
}

Result<std::vector<std::string>> NetCdfFile::readTexts(const NetCdfVariable& variable) const
{
    if (variable.type != NC_CHAR || variable.dimensions.empty())
        return std::vector<std::string>();
    const NetCdfPart part = whole(variable);
    std::string all(tetra::valueCount(part), '\0');
    if (!all.empty())
        if (const int code =
                nc_get_vara_text(variable.group, variable.id, part.first.data(), part.count.data(), all.data());
            code != NC_NOERR)
            return variableError(code, variable);
    const std::size_t row = part.count.back();
    std::vector<std::string> texts;
    for (std::size_t begin = 0; row > 0 && begin + row <= all.size(); begin += row)
        texts.push_back(unpadded(all.substr(begin, row)));
    return texts;
}

} // namespace tetra
