// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/hdf5/helper/hdf5_id.h"

#include "plugins/readers/hdf5/helper/lzf_filter.h"

#include <cstdlib>

namespace tetra {
namespace {

/// The innermost entry of the library's stack is where the failure was found.
herr_t keepInnermost(unsigned depth, const H5E_error2_t* error, void* reason)
{
    if (depth == 0 && error->desc != nullptr)
        *static_cast<std::string*>(reason) = error->desc;
    return 0;
}

} // namespace

Hdf5Id openGroup(hid_t file, const std::string& path)
{
    return {H5Gopen2(file, path.c_str(), H5P_DEFAULT), H5Gclose};
}

Hdf5Id openArray(hid_t file, const std::string& path)
{
    return {H5Dopen2(file, path.c_str(), H5P_DEFAULT), H5Dclose};
}

void confineHdf5()
{
    setenv("HDF5_USE_FILE_LOCKING", "FALSE", 1); // folders that may not be written to
    H5open();
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    H5PLset_loading_state(0);
    H5Lunregister(H5L_TYPE_EXTERNAL);
    registerLzfFilter();
}

Error hdf5Error(const Message& where)
{
    std::string reason = "unknown error"; // as the library calls what it has no words for
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keepInnermost, &reason);
    return {ErrorKind::BadInput,
            Message::say("the HDF5 library says of %1: %2. Copy or export the file again.", where, printable(reason))};
}

} // namespace tetra
