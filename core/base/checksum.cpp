// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/checksum.h"

// With the definitions in view the state is a plain member: creating one cannot fail on its own.
#define XXH_STATIC_LINKING_ONLY
#include <xxhash.h>

namespace tetra {

struct Checksum::State {
    XXH3_state_t content;
};

std::uint64_t checksum(std::span<const std::byte> bytes) noexcept
{
    return XXH3_64bits(bytes.data(), bytes.size());
}

Checksum::Checksum() : state_(std::make_unique<State>())
{
    XXH3_64bits_reset(&state_->content);
}

Checksum::~Checksum() = default;
Checksum::Checksum(Checksum&&) noexcept = default;
Checksum& Checksum::operator=(Checksum&&) noexcept = default;

void Checksum::add(std::span<const std::byte> bytes) noexcept
{
    XXH3_64bits_update(&state_->content, bytes.data(), bytes.size());
}

std::uint64_t Checksum::value() const noexcept
{
    return XXH3_64bits_digest(&state_->content);
}

} // namespace tetra
