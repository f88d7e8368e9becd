// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/plugins/readers/netcdf/netcdf_test_files.h"

#include "plugins/host/plugin_guards.h"

#include <QtGlobal>

#include <algorithm>

namespace tetra {

const Reader& builtNetCdfReader()
{
    static const NetCdfReader reader(std::filesystem::path(TAN_BINARY_DIR) / "lib/tan/plugins/tan-read-netcdf");
    static const auto guard = guarded(reader, {"netcdf", [](const Error&) {}});
    return *guard;
}

NetCdfTestFile::NetCdfTestFile(const std::filesystem::path& path, int mode)
{
    check(nc_create(path.c_str(), NC_CLOBBER | mode, &file_));
    current_ = file_;
}

NetCdfTestFile::~NetCdfTestFile()
{
    nc_close(file_);
}

int NetCdfTestFile::group(const char* name)
{
    check(nc_def_grp(current_, name, &current_));
    return current_;
}

int NetCdfTestFile::dimension(const char* name, std::size_t length)
{
    int id = -1;
    define();
    check(nc_def_dim(current_, name, length == 0 ? NC_UNLIMITED : length, &id));
    return id;
}

int NetCdfTestFile::define(const char* name, int type, const std::vector<int>& dimensions)
{
    int id = -1;
    define();
    check(nc_def_var(current_, name, type, static_cast<int>(dimensions.size()), dimensions.data(), &id));
    return id;
}

void NetCdfTestFile::text(int variable, const char* name, const std::string& text)
{
    define();
    check(nc_put_att_text(variable == NC_GLOBAL ? file_ : current_, variable, name, text.size(), text.data()));
}

void NetCdfTestFile::define() const
{
    nc_redef(file_); // an error where it is in that mode already
}

void NetCdfTestFile::putBytes(int variable, const void* values, std::size_t count) const
{
    nc_enddef(file_);
    int rank = 0;
    check(nc_inq_varndims(current_, variable, &rank));
    std::vector<int> dimensions(static_cast<std::size_t>(rank));
    check(nc_inq_vardimid(current_, variable, dimensions.data()));
    std::vector<std::size_t> first(dimensions.size(), 0), counts(dimensions.size(), 1);
    std::size_t rest = count;
    for (std::size_t at = dimensions.size(); at-- > 0;) {
        check(nc_inq_dimlen(current_, dimensions[at], &counts[at]));
        if (at == 0)
            counts[at] = rest;
        rest /= std::max<std::size_t>(1, counts[at]);
    }
    check(nc_put_vara(current_, variable, first.data(), counts.data(), values));
}

void NetCdfTestFile::check(int code)
{
    if (code != NC_NOERR)
        qFatal("cannot write a test file: %s", nc_strerror(code));
}

std::string takenOf(const std::vector<Taken>& taken, TakenPart part)
{
    const auto found = std::ranges::find(taken, part, &Taken::part);
    return found == taken.end() ? "" : found->what.text() + (found->guessed ? " ?" : "");
}

} // namespace tetra
