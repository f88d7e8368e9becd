// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/cells/encoded_bytes.h"

#include <cstdint>
#include <cstring>

namespace tetra {

namespace {

constexpr int notBase64 = -1;

int valueOf(char c)
{
    if (c >= 'A' && c <= 'Z')
        return c - 'A';
    if (c >= 'a' && c <= 'z')
        return c - 'a' + 26;
    if (c >= '0' && c <= '9')
        return c - '0' + 52;
    return c == '+' ? 62 : c == '/' ? 63 : notBase64;
}

bool isBlank(char c)
{
    return c == ' ' || c == '\n' || c == '\r' || c == '\t';
}

} // namespace

bool EncodedBytes::take(std::span<std::byte> bytes)
{
    if (!base64_) {
        if (bytes.size() > text_.size())
            return false;
        if (!bytes.empty())
            std::memcpy(bytes.data(), text_.data(), bytes.size());
        text_.remove_prefix(bytes.size());
        return true;
    }
    for (std::byte& byte : bytes) {
        if (pending_ == 0 && !decodeGroup())
            return false;
        byte = group_[groupSize_ - pending_--];
    }
    return true;
}

bool EncodedBytes::decodeGroup()
{
    std::uint32_t bits = 0;
    std::size_t read = 0, padding = 0;
    std::size_t at = 0;
    for (; at < text_.size() && read < 4; ++at) {
        const char c = text_[at];
        if (isBlank(c))
            continue;
        const int value = c == '=' ? 0 : valueOf(c);
        if (value == notBase64 || (padding > 0 && c != '='))
            return false;
        padding += c == '=';
        bits = bits << 6 | static_cast<std::uint32_t>(value);
        ++read;
    }
    text_.remove_prefix(at);
    if (read < 4 || padding > 2)
        return false;
    group_ = {static_cast<std::byte>(bits >> 16 & 0xff), static_cast<std::byte>(bits >> 8 & 0xff),
              static_cast<std::byte>(bits & 0xff)};
    groupSize_ = pending_ = 3 - padding;
    return true;
}

} // namespace tetra
