// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/plugins/readers/hdf5/hdf5_test_files.h"

#include "plugins/host/plugin_guards.h"

#include <QtGlobal>

#include <algorithm>

namespace tetra {

const Reader& builtHdf5Reader()
{
    static const Hdf5Reader reader(std::filesystem::path(TAN_BINARY_DIR) / "lib/tan/plugins/tan-read-hdf5");
    static const auto guard = guarded(reader, {"hdf5", [](const Error&) {}});
    return *guard;
}

Hdf5TestFile::Hdf5TestFile(const std::filesystem::path& path, hsize_t userBlock)
{
    const hid_t creation = H5Pcreate(H5P_FILE_CREATE);
    mustBeDone(H5Pset_userblock(creation, userBlock) >= 0);
    file_ = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation, H5P_DEFAULT);
    mustBeDone(file_ >= 0);
    H5Pclose(creation);
}

Hdf5TestFile::~Hdf5TestFile()
{
    H5Fclose(file_);
}

void Hdf5TestFile::group(const std::string& path)
{
    const hid_t group = H5Gcreate2(file_, path.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    mustBeDone(group >= 0);
    H5Gclose(group);
}

void Hdf5TestFile::define(const std::string& path, const std::vector<hsize_t>& size, const Hdf5Storage& storage)
{
    const int rank = static_cast<int>(size.size());
    const hid_t creation = H5Pcreate(H5P_DATASET_CREATE), link = H5Pcreate(H5P_LINK_CREATE);
    H5Pset_create_intermediate_group(link, 1);
    if (!storage.chunk.empty())
        mustBeDone(H5Pset_chunk(creation, rank, storage.chunk.data()) >= 0);
    if (storage.isPacked)
        mustBeDone(H5Pset_shuffle(creation) >= 0 && H5Pset_deflate(creation, 6) >= 0 &&
                   H5Pset_fletcher32(creation) >= 0);
    if (!storage.fill.empty())
        mustBeDone(H5Pset_fill_value(creation, H5T_NATIVE_DOUBLE, storage.fill.data()) >= 0);
    if (!storage.isFilled)
        H5Pset_fill_time(creation, H5D_FILL_TIME_NEVER);
    const hid_t space = H5Screate_simple(rank, size.data(), nullptr);
    const hid_t array = H5Dcreate2(file_, path.c_str(), storage.type, space, link, creation, H5P_DEFAULT);
    mustBeDone(array >= 0);
    H5Dclose(array);
    H5Sclose(space);
    H5Pclose(link);
    H5Pclose(creation);
}

void Hdf5TestFile::write(const std::string& path, hid_t type, const void* values)
{
    const hid_t array = H5Dopen2(file_, path.c_str(), H5P_DEFAULT);
    mustBeDone(H5Dwrite(array, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0);
    H5Dclose(array);
}

void Hdf5TestFile::attribute(const std::string& object, const char* name, hid_t type, std::size_t count,
                             const void* values)
{
    const hsize_t size = count;
    const hid_t space = H5Screate_simple(1, &size, nullptr);
    const hid_t attribute =
        H5Acreate_by_name(file_, object.c_str(), name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    mustBeDone(attribute >= 0 && H5Awrite(attribute, type, values) >= 0);
    H5Aclose(attribute);
    H5Sclose(space);
}

void Hdf5TestFile::texts(const std::string& object, const char* name, const std::vector<std::string>& texts)
{
    const hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, H5T_VARIABLE);
    std::vector<const char*> pointers;
    for (const std::string& text : texts)
        pointers.push_back(text.c_str());
    attribute(object, name, type, pointers.size(), static_cast<const void*>(pointers.data()));
    H5Tclose(type);
}

void Hdf5TestFile::letters(const std::string& object, const char* name, const std::string& text)
{
    attribute(object, name, H5T_C_S1, text.size(), text.data());
}

void Hdf5TestFile::attachScales(const std::string& array, const std::vector<std::string>& scales)
{
    std::vector<hobj_ref_t> references(scales.size());
    std::vector<hvl_t> lists;
    for (std::size_t at = 0; at < scales.size(); ++at) {
        mustBeDone(H5Rcreate(&references[at], file_, scales[at].c_str(), H5R_OBJECT, -1) >= 0);
        lists.push_back({1, &references[at]});
    }
    const hid_t type = H5Tvlen_create(H5T_STD_REF_OBJ);
    attribute(array, "DIMENSION_LIST", type, lists.size(), lists.data());
    H5Tclose(type);
}

void mustBeDone(bool isDone)
{
    if (!isDone)
        qFatal("cannot write a test file");
}

std::string takenOf(const std::vector<Taken>& taken, TakenPart part)
{
    const auto found = std::ranges::find(taken, part, &Taken::part);
    return found == taken.end() ? "" : found->what.text() + (found->guessed ? " ?" : "");
}

std::string textOf(const std::vector<Message>& messages)
{
    std::string all;
    for (const Message& message : messages)
        all += message.text() + "\n";
    return all;
}

} // namespace tetra
