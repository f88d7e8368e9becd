// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/checksum.h"
#include "core/base/file_writer.h"

#include <tan/base.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace tetra {

class SavedState;

/// The members of an object on their way into a file or back. Objects have one function for both,
///
///     void archive(StateArchive& archive) { archive(some_, others_); }
///
/// so that the two cannot differ: of plain types, arrays, vectors and maps of them, and objects with such a function.
/// Bytes are as they are in memory: only the same program reads them. May throw std::bad_alloc.
class StateArchive {
public:
    template <class... Members> void operator()(Members&... members) { (part(members), ...); }
    /// Some of an array that has its size otherwise.
    template <class T> void elements(std::span<T> some)
    {
        if (isThere(some.size_bytes()))
            bytes(std::as_writable_bytes(some));
    }
    /// A vector that only ever grows at its end: each time only what is new is written. The calls of an archive come in
    /// the same order every time.
    template <class T> void grown(std::vector<T>& vector)
    {
        static_assert(std::is_trivially_copyable_v<T>);
        const std::uint64_t size = grownBytes(vector.size() * sizeof(T));
        if (isLoading())
            vector.resize(size / sizeof(T));
        grownPart(std::as_writable_bytes(std::span(vector)));
    }

    bool isLoading() const noexcept { return mode_ == Mode::Load; }

private:
    friend class SavedState;
    enum class Mode { Measure, Save, Load };

    StateArchive(SavedState& state, Mode mode) : state_(state), mode_(mode) {}

    template <class T> void part(T& member)
    {
        static_assert(!std::is_pointer_v<T>);
        if constexpr (requires { member.archive(*this); })
            member.archive(*this);
        else if constexpr (std::is_trivially_copyable_v<T>)
            bytes(std::as_writable_bytes(std::span(&member, 1)));
        else if constexpr (requires { typename T::mapped_type; })
            map(member);
        else if constexpr (requires { member.resize(1); })
            vector(member);
        else
            for (auto& element : member)
                part(element);
    }
    template <class T> void vector(T& member)
    {
        using Element = typename T::value_type;
        if constexpr (std::is_same_v<T, std::vector<bool>>) {
            std::vector<std::uint8_t> plain(member.begin(), member.end());
            vector(plain);
            if (isLoading())
                member.assign(plain.begin(), plain.end());
        } else {
            const std::uint64_t size =
                count(member.size(), std::is_trivially_copyable_v<Element> ? sizeof(Element) : 1);
            if (isLoading())
                member.resize(size);
            if constexpr (std::is_trivially_copyable_v<Element>)
                bytes(std::as_writable_bytes(std::span(member)));
            else
                for (Element& element : member)
                    part(element);
        }
    }
    template <class T> void map(T& member)
    {
        std::vector<std::pair<typename T::key_type, typename T::mapped_type>> entries(member.begin(), member.end());
        std::uint64_t size = count(entries.size(), sizeof(typename T::key_type));
        entries.resize(size);
        for (auto& [key, value] : entries)
            (*this)(key, value);
        if (isLoading())
            member = T(entries.begin(), entries.end());
    }

    void bytes(std::span<std::byte> some);
    /// Whether there is as much to read; a file without it does not fit the object.
    bool isThere(std::uint64_t size);
    /// How many elements a vector has, of at least so many bytes each.
    std::uint64_t count(std::uint64_t size, std::size_t bytesEach);
    std::uint64_t grownBytes(std::uint64_t size) const;
    void grownPart(std::span<std::byte> all);

    SavedState& state_;
    Mode mode_;
    std::uint64_t bytes_ = 0;  ///< so far
    std::uint32_t stream_ = 0; ///< of the next vector that grows
};

/// What a long build leaves in its work folder while it runs, so that one that is killed goes on from there: a file
/// with the state of an object, replaced as a whole now and then, and a journal to which what only grows is appended.
/// Whenever the power fails, there is a whole state and the journal that it needs. A disk without room for it does no
/// harm: then there is none. One thread.
class SavedState {
public:
    /// What is said where the content of a work folder is not of the work that asks for it (WrongUsage).
    static Error ofOtherWork(const std::filesystem::path& folder);

    /// In `folder`, where there may be one to go on from. `fingerprint` stands for all that the object depends on, the
    /// program's version included. Errors: it is damaged (BadInput), of another fingerprint (WrongUsage), or cannot be
    /// read. Reads all of it.
    static Result<std::unique_ptr<SavedState>> open(const std::filesystem::path& folder, std::uint64_t fingerprint);
    ~SavedState();
    SavedState(const SavedState&) = delete;
    SavedState& operator=(const SavedState&) = delete;

    /// Whether there is one to go on from.
    bool found() const noexcept { return found_; }
    /// Makes the object what it was when it was saved last. Of no use after an error: it does not fit the object.
    template <class Object> Status load(Object& object)
    {
        StateArchive archive(*this, StateArchive::Mode::Load);
        object.archive(archive);
        return endOfLoading(archive);
    }

    /// To be called between the steps of the work: saves the object if it is time to, or the work is cancelled. That is
    /// so rarely that it takes no more than one part in `share` of the time, the first time as well.
    template <class Object> void pause(Object& object, bool cancelled)
    {
        if (!givenUp_ && (cancelled || Clock::now() >= next_))
            save([&object](StateArchive& archive) { object.archive(archive); }, cancelled);
    }

    /// Notes what can be read again, in the same order, once the object was saved.
    void note(std::span<const std::byte> bytes);
    /// What had been noted when the object was saved that is gone on from, in pieces of any length.
    Status readNotes(const std::function<Status(std::span<const std::byte>)>& visit);

private:
    friend class StateArchive;
    using Clock = std::chrono::steady_clock;
    /// Bytes of the journal.
    struct Extent {
        std::uint64_t stream = 0;
        std::uint64_t offset = 0;
        std::uint64_t size = 0;
    };
    /// After the object's bytes and the extents in the file; then comes a checksum of all.
    struct Foot {
        std::array<char, 8> magic{};
        std::uint64_t fingerprint = 0;
        std::uint64_t objectSize = 0;
        std::uint64_t extentCount = 0;
        std::uint64_t journalSize = 0;
        std::uint64_t journalChecksum = 0;
    };
    static constexpr std::uint64_t notes = ~std::uint64_t(0);
    static constexpr std::chrono::milliseconds shortest{200}; ///< from one time to the next
    static constexpr int share = 25;

    SavedState(const std::filesystem::path& folder, std::uint64_t fingerprint);
    Status find();
    Status checkJournal(const Foot& foot);
    void save(const std::function<void(StateArchive& archive)>& archiveObject, bool atOnce);
    bool comesTooEarly(std::uint64_t bytes);
    bool write(const std::function<void(StateArchive& archive)>& archiveObject, bool atOnce);
    bool hasRoom(std::uint64_t bytes) const;
    void appendNoted();
    void append(std::uint64_t stream, std::span<const std::byte> bytes);
    Status endOfLoading(const StateArchive& archive);
    Status readJournal(std::uint64_t offset, std::span<std::byte> bytes) const;
    void giveUp() noexcept;
    Error damaged() const;

    std::filesystem::path folder_, path_, journalPath_;
    std::uint64_t fingerprint_;
    bool found_ = false;
    bool givenUp_ = false; ///< nothing is saved any more
    const Clock::time_point start_ = Clock::now();
    Clock::time_point next_;
    bool putOff_ = false; ///< the first time

    int file_ = -1;          ///< that is gone on from
    std::uint64_t end_ = 0;  ///< of the object's bytes there
    Buffer<std::byte> read_; ///< of them, some
    std::uint64_t readAt_ = 0;
    bool readFailed_ = false;

    int journal_ = -1;
    std::uint64_t journalSize_ = 0;
    Checksum journalSum_;
    std::vector<Extent> extents_;
    Buffer<std::byte> noted_; ///< not yet in the journal

    FileWriter* writer_ = nullptr; ///< while it is saved
    Checksum sum_;
};

} // namespace tetra
