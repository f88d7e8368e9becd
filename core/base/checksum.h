// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace tetra {

/// XXH3, 64 bits, seed 0: guards files against damage, not against intent.
TAN_INTERNAL std::uint64_t checksum(std::span<const std::byte> bytes) noexcept;

/// The same over bytes that arrive in pieces. Move-only; one thread at a time.
class TAN_INTERNAL Checksum {
public:
    Checksum();
    ~Checksum();
    Checksum(Checksum&&) noexcept;
    Checksum& operator=(Checksum&&) noexcept;

    void add(std::span<const std::byte> bytes) noexcept;
    /// Of everything added so far.
    std::uint64_t value() const noexcept;
    /// Forgets all of it.
    void reset() noexcept;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace tetra
