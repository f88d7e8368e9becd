// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// The fields of a MetaImage's header, up to ElementDataFile, and where what follows begins. The format:
/// https://itk.org/Wiki/ITK/MetaIO/Documentation; where its library goes other ways, as the library does.
struct MetaHeader {
    std::map<std::string, std::string, std::less<>> fields;
    std::size_t end = 0;

    bool has(std::string_view name) const { return fields.contains(name); }
    /// Empty if the field is not there.
    std::string_view text(std::string_view name) const;
    bool isTrue(std::string_view name) const;
};

/// The error says that the last line is missing.
Result<MetaHeader> metaHeaderOf(std::string_view bytes);

/// The library reads every number as a double and takes its whole part.
std::optional<std::int64_t> metaWholeNumber(std::string_view text);

/// The first `count` numbers of the last of these fields that is there: of several names for one thing the last counts,
/// as in the library. Nothing if none is. Errors: fewer numbers than that, or one that is not finite.
Result<std::optional<std::vector<double>>> metaNumbers(const MetaHeader& header,
                                                       const std::vector<std::string_view>& names, std::size_t count);

/// A header that cannot be right; `what` is a sentence.
Error wrongMetaHeader(const Message& what);

} // namespace tetra
