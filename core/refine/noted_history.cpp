// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refine/noted_history.h"

#include <cstdint>
#include <cstring>

namespace tetra {

namespace {

/// Before the star and what is destroyed.
struct StepHead {
    std::uint64_t point = 0;
    float keyBefore = 0;
    std::uint32_t starSize = 0;
    std::uint32_t destroyedSize = 0;
    std::uint32_t unused = 0;

    std::size_t bytes() const
    {
        return sizeof(StepHead) + starSize * sizeof(HistoryTetrahedron) + destroyedSize * sizeof(std::uint32_t);
    }
};

/// As many as fit the vector, from the front of the bytes.
template <class T> void take(std::span<const std::byte>& bytes, std::span<T> some)
{
    if (!some.empty())
        std::memcpy(some.data(), bytes.data(), some.size_bytes());
    bytes = bytes.subspan(some.size_bytes());
}

} // namespace

Status NotedHistory::add(const HistoryStep& step)
{
    if (goesOn_)
        return {};
    if (state_ != nullptr) {
        const StepHead head{step.point, step.keyBefore, static_cast<std::uint32_t>(step.star.size()),
                            static_cast<std::uint32_t>(step.destroyed.size())};
        state_->note(std::as_bytes(std::span(&head, 1)));
        state_->note(std::as_bytes(step.star));
        state_->note(std::as_bytes(step.destroyed));
    }
    return next_.add(step);
}

Status NotedHistory::handAgain()
{
    Buffer<std::byte> read;
    std::vector<HistoryTetrahedron> star;
    std::vector<std::uint32_t> destroyed;
    return state_->readNotes([&](std::span<const std::byte> more) -> Status {
        const std::size_t left = read.size();
        read.resize(left + more.size());
        std::memcpy(read.data() + left, more.data(), more.size());
        std::span<const std::byte> rest = read;
        while (rest.size() >= sizeof(StepHead)) {
            StepHead head;
            std::memcpy(&head, rest.data(), sizeof head);
            if (rest.size() < head.bytes())
                break;
            rest = rest.subspan(sizeof head);
            star.resize(head.starSize);
            take(rest, std::span(star));
            destroyed.resize(head.destroyedSize);
            take(rest, std::span(destroyed));
            if (const Status added = next_.add({head.point, head.keyBefore, star, destroyed}); !added)
                return added;
        }
        std::memmove(read.data(), rest.data(), rest.size());
        read.resize(rest.size());
        return {};
    });
}

} // namespace tetra
