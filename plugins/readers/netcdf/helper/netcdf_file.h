// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

struct NetCdfDimension {
    std::string name;
    std::uint64_t length = 0;
};

struct NetCdfVariable {
    int group = 0; ///< the library's numbers
    int id = 0;
    std::string name;
    std::string path;                      ///< "group/name"; of the uppermost group the name alone
    int type = 0;                          ///< the library's nc_type; those defined by users are above all others
    std::vector<std::size_t> dimensions{}; ///< numbers of NetCdfFile::dimensions(), the slowest first
};

/// A part of a variable: of each dimension the first index and how many.
struct NetCdfPart {
    std::vector<std::size_t> first;
    std::vector<std::size_t> count;
};

/// An open file as the NetCDF library sees it: groups, dimensions, variables, attributes. One thread. Errors
/// (BadInput) give the library's reason in a sentence about "it".
class NetCdfFile {
public:
    static Result<std::shared_ptr<const NetCdfFile>> open(const std::string& path);
    NetCdfFile(const NetCdfFile&) = delete;
    NetCdfFile& operator=(const NetCdfFile&) = delete;
    ~NetCdfFile();

    const std::vector<NetCdfDimension>& dimensions() const noexcept { return dimensions_; }
    const std::vector<NetCdfVariable>& variables() const noexcept { return variables_; }
    /// Those of the file as a whole, of one dimension's name; nothing if there is none.
    std::optional<std::uint64_t> length(std::string_view dimension) const;
    /// By path; else null.
    const NetCdfVariable* find(std::string_view path) const;
    /// The variable that a name means in the group of another one: there, or in the groups around.
    const NetCdfVariable* findFrom(const NetCdfVariable& from, std::string_view name) const;

    /// An attribute that is text, without what pads it; empty without one.
    std::string text(const NetCdfVariable& variable, const char* attribute) const;
    /// An attribute of numbers, which `long double` holds exactly; empty without one.
    std::vector<long double> numbers(const NetCdfVariable& variable, const char* attribute) const;
    /// The nc_type of an attribute; 0 without one.
    int attributeType(const NetCdfVariable& variable, const char* attribute) const;
    /// Whether the library fills what nobody writes of a variable. Files of classic formats do not say, and are taken
    /// to be filled, as they are unless a program asks otherwise.
    bool fillsUnwritten(const NetCdfVariable& variable) const;
    bool hasGlobal(const char* attribute) const;
    std::string globalText(const char* attribute) const;

    /// Whether values are numbers that a sample can be made of.
    static bool isNumeric(const NetCdfVariable& variable) noexcept;
    /// The type of a variable's values in words of C: "int64".
    static std::string_view typeName(int type) noexcept;
    std::uint64_t valueCount(const NetCdfVariable& variable) const noexcept;
    NetCdfPart whole(const NetCdfVariable& variable) const;

    /// The numbers as they are stored, in the machine's order, into `count` times the size of the type.
    Status readStored(const NetCdfVariable& variable, const NetCdfPart& part, void* to) const;
    /// The numbers as they are stored, as doubles. Refused before memory is taken if there are more than `most`.
    Result<std::vector<double>> readDoubles(const NetCdfVariable& variable, const NetCdfPart& part) const;
    Result<std::vector<std::int64_t>> readIntegers(const NetCdfVariable& variable) const;
    /// A variable of characters: one text for each row of its last dimension, without what pads it.
    Result<std::vector<std::string>> readTexts(const NetCdfVariable& variable) const;

private:
    explicit NetCdfFile(int id) : id_(id) {}
    Status list(int group, const std::string& prefix, int depth);
    Status listVariable(int group, int id, const std::string& prefix);
    Status listDimensions(int group);

    int id_;
    std::vector<NetCdfDimension> dimensions_;
    std::vector<int> dimensionIds_;
    std::vector<NetCdfVariable> variables_;
};

/// Bytes of a value of an nc_type; 0 for those that are not numbers.
std::size_t netCdfTypeBytes(int type) noexcept;

std::uint64_t valueCount(const NetCdfPart& part) noexcept;

} // namespace tetra
