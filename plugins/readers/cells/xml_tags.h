// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tetra {

/// A tag of an XML text: <name key="value" ...>, or </name>.
struct XmlTag {
    std::string_view name;
    std::vector<std::pair<std::string_view, std::string>> attributes; ///< their five entities replaced
    bool closes = false;                                              ///< </name> or <name/>
    bool opens = true;                                                ///< not </name>
    std::size_t end = 0;                                              ///< the place in the text behind the tag

    /// Empty if there is none.
    std::string attribute(std::string_view key) const;
};

/// The tags of an XML text one after the other; comments, declarations and what stands between tags are passed over.
/// As much of XML as files of data use, without copying the data. Views into the text.
class XmlTags {
public:
    explicit XmlTags(std::string_view text) : text_(text) {}
    /// Nothing at the end of the text, or where it is no XML: then broken().
    std::optional<XmlTag> next();
    bool broken() const { return broken_; }
    /// Goes on from a place in the text.
    void moveTo(std::size_t place) { at_ = place; }

private:
    std::optional<XmlTag> fail();

    std::string_view text_;
    std::size_t at_ = 0;
    bool broken_ = false;
};

} // namespace tetra
