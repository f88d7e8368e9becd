// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

namespace tetra {

/// Bytes that stand in a text as they are or in base64 (RFC 4648), one part after the other.
class EncodedBytes {
public:
    EncodedBytes(std::string_view text, bool base64) : text_(text), base64_(base64) {}
    /// The next ones; false if there are not so many, or what stands there is no base64.
    bool take(std::span<std::byte> bytes);
    /// What follows is encoded by itself: bytes of the last group that were not taken are none.
    void startAnew() { pending_ = 0; }

private:
    bool decodeGroup();

    std::string_view text_;
    bool base64_;
    std::array<std::byte, 3> group_{};
    std::size_t pending_ = 0; ///< at the end of the group
    std::size_t groupSize_ = 0;
};

} // namespace tetra
