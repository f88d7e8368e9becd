// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// An adaptive binary range coder: each decision has a BitModel, the probability of its being 0 as far as is known.
/// What the coder makes of the same decisions with the same models are the same bytes on every machine. FORMAT.md,
/// "Packed form", has it step by step.

/// The probability that a decision is 0, in 65536ths, learnt from what it was: quickly at first, then slowly.
class BitModel {
public:
    std::uint32_t zero() const noexcept { return zero_; }
    void learn(bool one) noexcept
    {
        const std::uint32_t rate = rates[seen_];
        if (one)
            zero_ = static_cast<std::uint16_t>(zero_ - (zero_ >> rate));
        else
            zero_ = static_cast<std::uint16_t>(zero_ + ((65536 - zero_) >> rate));
        zero_ = std::clamp<std::uint16_t>(zero_, least, most);
        seen_ = static_cast<std::uint8_t>(std::min<std::size_t>(seen_ + std::size_t(1), rates.size() - 1));
    }

private:
    static constexpr std::uint16_t least = 64, most = 65472;
    static constexpr std::array<std::uint8_t, 24> rates = {1, 2, 2, 3, 3, 3, 3, 4, 4, 4, 4, 4,
                                                           4, 4, 4, 5, 5, 5, 5, 5, 5, 5, 5, 6};
    std::uint16_t zero_ = 32768;
    std::uint8_t seen_ = 0;
};

class RangeEncoder {
public:
    void bit(BitModel& model, bool one)
    {
        const std::uint32_t bound = (range_ >> 16) * model.zero();
        if (one) {
            low_ += bound;
            range_ -= bound;
        } else {
            range_ = bound;
        }
        model.learn(one);
        while (range_ < (1u << 24))
            shift();
    }

    /// `count` bits, the highest first, that nothing is known of; at most 64.
    void raw(std::uint64_t bits, unsigned count)
    {
        while (count > 0) {
            const unsigned now = std::min(count, 8u);
            count -= now;
            range_ >>= now;
            low_ += std::uint64_t(range_) * (bits >> count & ((1u << now) - 1));
            while (range_ < (1u << 24))
                shift();
        }
    }

    /// The bytes so far; the encoder is as new then.
    std::vector<std::byte> finish()
    {
        for (int i = 0; i < 5; ++i)
            shift();
        std::vector<std::byte> bytes = std::move(bytes_);
        for (int i = 0; i < mayBeMissing && !bytes.empty() && bytes.back() == std::byte(0); ++i)
            bytes.pop_back(); // the decoder reads zeros beyond the end
        *this = RangeEncoder();
        return bytes;
    }

    /// So many zeros at most are left out at the end.
    static constexpr int mayBeMissing = 4;

    /// About how many bytes there are so far.
    std::size_t size() const noexcept { return bytes_.size() + pending_; }

private:
    void shift()
    {
        if (low_ < 0xff000000u || low_ > 0xffffffffu) {
            const auto carry = static_cast<std::uint8_t>(low_ >> 32);
            if (begun_)
                bytes_.push_back(std::byte(cache_ + carry));
            for (; pending_ > 0; --pending_)
                bytes_.push_back(std::byte(0xff + carry));
            cache_ = static_cast<std::uint8_t>(low_ >> 24);
            begun_ = true;
        } else {
            ++pending_;
        }
        low_ = (low_ & 0x00ffffffu) << 8;
        range_ <<= 8;
    }

    std::uint64_t low_ = 0;
    std::uint32_t range_ = 0xffffffff;
    std::uint8_t cache_ = 0;
    bool begun_ = false;
    std::size_t pending_ = 0; ///< bytes 0xff that a carry may still change
    std::vector<std::byte> bytes_;
};

/// Any bytes decode to something; overrun() tells that they were too few.
class RangeDecoder {
public:
    explicit RangeDecoder(std::span<const std::byte> bytes) : bytes_(bytes)
    {
        for (int i = 0; i < 4; ++i)
            code_ = code_ << 8 | next();
    }

    bool bit(BitModel& model)
    {
        const std::uint32_t bound = (range_ >> 16) * model.zero();
        const bool one = code_ >= bound;
        if (one) {
            code_ -= bound;
            range_ -= bound;
        } else {
            range_ = bound;
        }
        model.learn(one);
        while (range_ < (1u << 24))
            shift();
        return one;
    }

    std::uint64_t raw(unsigned count)
    {
        std::uint64_t bits = 0;
        while (count > 0) {
            const unsigned now = std::min(count, 8u);
            count -= now;
            range_ >>= now;
            const std::uint32_t part = std::min(code_ / range_, (1u << now) - 1);
            code_ -= part * range_;
            bits = bits << now | part;
            while (range_ < (1u << 24))
                shift();
        }
        return bits;
    }

    /// Whether more was decoded than the bytes hold: they are no work of the encoder.
    bool overrun() const noexcept { return place_ > bytes_.size() + RangeEncoder::mayBeMissing; }

private:
    std::uint32_t next() noexcept
    {
        const std::size_t place = place_++;
        return place < bytes_.size() ? static_cast<std::uint32_t>(bytes_[place]) : 0;
    }
    void shift() noexcept
    {
        code_ = code_ << 8 | next();
        range_ <<= 8;
    }

    std::span<const std::byte> bytes_;
    std::size_t place_ = 0;
    std::uint32_t code_ = 0;
    std::uint32_t range_ = 0xffffffff;
};

/// A decision by either coder: with the encoder the one that it is told, with the decoder the one that comes.
inline bool codedBit(RangeEncoder& coder, BitModel& model, bool one)
{
    coder.bit(model, one);
    return one;
}
inline bool codedBit(RangeDecoder& coder, BitModel& model, bool)
{
    return coder.bit(model);
}

/// Numbers below 2^64 whose size is learnt: how many bits they have, by a tree of decisions; then the bits below the
/// highest one, of which the first few have models, too.
class NumberModel {
public:
    template <class Coder> std::uint64_t code(Coder& coder, std::uint64_t number)
    {
        // The number + 1 as 1 followed by `length` bits; 2^64 - 1 does not occur.
        unsigned length = static_cast<unsigned>(std::bit_width(number + 1)) - 1;
        length = codeLength(coder, length);
        std::uint64_t bits = number + 1;
        std::uint64_t known = 1;
        unsigned left = length;
        for (unsigned depth = 0; depth < modelled && left > 0; ++depth) {
            --left;
            BitModel& model = mantissas_[std::min<unsigned>(length, lengths - 1)][known & (shapes - 1)];
            const bool one = codedBit(coder, model, (bits >> left & 1) != 0);
            known = known << 1 | (one ? 1 : 0);
        }
        return (known << left | rawBits(coder, bits, left)) - 1;
    }

private:
    static constexpr unsigned lengths = 64, modelled = 3, shapes = 8;

    static std::uint64_t rawBits(RangeEncoder& coder, std::uint64_t bits, unsigned count)
    {
        const std::uint64_t low = count == 0 ? 0 : bits & (~std::uint64_t(0) >> (64 - count));
        coder.raw(low, count);
        return low;
    }
    static std::uint64_t rawBits(RangeDecoder& coder, std::uint64_t, unsigned count) { return coder.raw(count); }

    /// Six decisions, the highest bit first.
    template <class Coder> unsigned codeLength(Coder& coder, unsigned length)
    {
        unsigned node = 1;
        for (unsigned bit = 6; bit-- > 0;)
            node = node << 1 | (codedBit(coder, lengths_[node], (length >> bit & 1) != 0) ? 1u : 0u);
        return node & 63;
    }

    std::array<BitModel, 64> lengths_;
    std::array<std::array<BitModel, shapes>, lengths> mantissas_;
};

} // namespace tetra
