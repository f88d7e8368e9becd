// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/hdf5/helper/attributes.h"

#include <algorithm>

namespace tetra {
namespace {

constexpr hssize_t mostEntries = 1024;
constexpr std::size_t mostTextBytes = std::size_t(1) << 20;

/// An attribute with its type and the number of its entries.
struct OpenAttribute {
    Hdf5Id id, type, space;
    std::size_t entries = 0; ///< 0 for what is not there, or too long
};

OpenAttribute openAttribute(hid_t object, const char* name)
{
    OpenAttribute attribute;
    if (H5Aexists(object, name) <= 0)
        return attribute;
    attribute.id = Hdf5Id(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
    if (!attribute.id)
        return attribute;
    attribute.type = Hdf5Id(H5Aget_type(attribute.id), H5Tclose);
    attribute.space = Hdf5Id(H5Aget_space(attribute.id), H5Sclose);
    if (!attribute.type || !attribute.space)
        return attribute;
    const hssize_t entries = H5Sget_simple_extent_npoints(attribute.space);
    attribute.entries = entries > 0 && entries <= mostEntries ? static_cast<std::size_t>(entries) : 0;
    return attribute;
}

std::string unpadded(std::string text)
{
    text.resize(std::min(text.find('\0'), text.size()));
    text.erase(text.find_last_not_of(" \t\r\n") + 1);
    return text;
}

std::vector<std::string> fixedTexts(const OpenAttribute& attribute)
{
    const std::size_t bytes = H5Tget_size(attribute.type);
    if (bytes == 0 || bytes > mostTextBytes / attribute.entries)
        return {};
    std::string all(bytes * attribute.entries, '\0');
    if (H5Aread(attribute.id, attribute.type, all.data()) < 0)
        return {};
    std::vector<std::string> texts;
    for (std::size_t at = 0; at < attribute.entries; ++at)
        texts.push_back(unpadded(all.substr(at * bytes, bytes)));
    return texts;
}

std::vector<std::string> variableTexts(const OpenAttribute& attribute)
{
    std::vector<char*> pointers(attribute.entries, nullptr);
    if (H5Aread(attribute.id, attribute.type, static_cast<void*>(pointers.data())) < 0)
        return {};
    std::vector<std::string> texts;
    for (const char* text : pointers)
        texts.push_back(text == nullptr ? std::string() : unpadded(text));
    H5Dvlen_reclaim(attribute.type, attribute.space, H5P_DEFAULT, static_cast<void*>(pointers.data()));
    return texts;
}

bool isOfNumbers(const OpenAttribute& attribute)
{
    const H5T_class_t kind = attribute.entries == 0 ? H5T_NO_CLASS : H5Tget_class(attribute.type);
    return kind == H5T_INTEGER || kind == H5T_FLOAT;
}

} // namespace

bool hasAttribute(hid_t object, const char* name)
{
    return H5Aexists(object, name) > 0;
}

std::vector<std::string> attributeTexts(hid_t object, const char* name)
{
    const OpenAttribute attribute = openAttribute(object, name);
    if (attribute.entries == 0 || H5Tget_class(attribute.type) != H5T_STRING)
        return {};
    return H5Tis_variable_str(attribute.type) > 0 ? variableTexts(attribute) : fixedTexts(attribute);
}

std::string attributeText(hid_t object, const char* name)
{
    const auto texts = attributeTexts(object, name);
    return texts.empty() ? std::string() : texts.front();
}

std::string attributeLetters(hid_t object, const char* name)
{
    const OpenAttribute attribute = openAttribute(object, name);
    if (attribute.entries == 0 || attribute.entries > mostTextBytes || H5Tget_class(attribute.type) != H5T_STRING ||
        H5Tis_variable_str(attribute.type) > 0 || H5Tget_size(attribute.type) != 1)
        return attributeText(object, name);
    std::string letters(attribute.entries, '\0');
    return H5Aread(attribute.id, attribute.type, letters.data()) < 0 ? std::string() : unpadded(std::move(letters));
}

std::vector<long double> attributeNumbers(hid_t object, const char* name)
{
    const OpenAttribute attribute = openAttribute(object, name);
    if (!isOfNumbers(attribute))
        return {};
    std::vector<long double> numbers(attribute.entries);
    return H5Aread(attribute.id, H5T_NATIVE_LDOUBLE, numbers.data()) < 0 ? std::vector<long double>() : numbers;
}

bool isSingleAttribute(hid_t object, const char* name)
{
    const OpenAttribute attribute = openAttribute(object, name);
    return isOfNumbers(attribute) && H5Tget_class(attribute.type) == H5T_FLOAT && H5Tget_size(attribute.type) <= 4;
}

std::vector<std::vector<Hdf5Id>> dimensionScales(hid_t array)
{
    const OpenAttribute attribute = openAttribute(array, "DIMENSION_LIST");
    if (attribute.entries == 0 || H5Tget_class(attribute.type) != H5T_VLEN)
        return {};
    const Hdf5Id entry(H5Tget_super(attribute.type), H5Tclose);
    if (!entry || H5Tequal(entry, H5T_STD_REF_OBJ) <= 0)
        return {};
    std::vector<hvl_t> lists(attribute.entries, hvl_t{0, nullptr});
    const Hdf5Id inMemory(H5Tvlen_create(H5T_STD_REF_OBJ), H5Tclose);
    if (!inMemory || H5Aread(attribute.id, inMemory, lists.data()) < 0)
        return {};
    std::vector<std::vector<Hdf5Id>> scales(lists.size());
    for (std::size_t dimension = 0; dimension < lists.size(); ++dimension)
        for (std::size_t at = 0; at < std::min<std::size_t>(lists[dimension].len, mostEntries); ++at) {
            const auto* references = static_cast<const hobj_ref_t*>(lists[dimension].p);
            Hdf5Id scale(H5Rdereference2(array, H5P_DEFAULT, H5R_OBJECT, references + at), H5Oclose);
            if (scale && H5Iget_type(scale) == H5I_DATASET)
                scales[dimension].push_back(std::move(scale));
        }
    H5Dvlen_reclaim(inMemory, attribute.space, H5P_DEFAULT, lists.data());
    return scales;
}

} // namespace tetra
