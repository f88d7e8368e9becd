// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/core/packed/packed_checksums.h"

#include <tan/model.h>
#include <tan/packed.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace tetra {

inline std::vector<std::byte> bytesOfFile(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    std::vector<std::byte> bytes;
    for (std::istreambuf_iterator<char> at(file), end; at != end; ++at)
        bytes.push_back(static_cast<std::byte>(*at));
    return bytes;
}

inline void putFile(const std::filesystem::path& path, std::span<const std::byte> bytes)
{
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

/// A damaged packed file.
struct DamagedPacked {
    const char* what = "";
    bool sumsAreRight = false; ///< as somebody may make them who means harm
    std::vector<std::byte> bytes;
};

/// Damages a whole packed file in one of many ways.
class PackedDamage {
public:
    explicit PackedDamage(std::span<const std::byte> whole) : whole_(whole)
    {
        format::Header header;
        std::memcpy(static_cast<void*>(&header), whole.data(), sizeof header);
        for (std::size_t number = 0; number < header.sectionCount; ++number) {
            format::Section section;
            tableEntry_ = sizeof header + number * sizeof section; // the chunks are the last one
            std::memcpy(static_cast<void*>(&section), whole.data() + tableEntry_, sizeof section);
            chunksAt_ = section.offset;
        }
        for (std::size_t at = chunksAt_; at < whole.size(); at += chunks_.back().size()) {
            format::PackedChunkHead head;
            std::memcpy(static_cast<void*>(&head), whole.data() + at, sizeof head);
            chunks_.push_back(whole.subspan(at, sizeof head + head.bytes));
        }
    }

    DamagedPacked damaged(std::mt19937_64& random) const
    {
        std::vector<std::byte> bytes(whole_.begin(), whole_.end());
        const auto below = [&](std::size_t end) { return static_cast<std::size_t>(random() % end); };
        const auto flipOne = [&](std::size_t begin, std::size_t end) {
            bytes[begin + below(end - begin)] ^= std::byte(1 << below(8));
        };
        switch (below(12)) {
        case 0:
        case 1:
            for (std::size_t flips = 1 + below(3); flips > 0; --flips)
                flipOne(0, bytes.size());
            return {"flipped bits", false, std::move(bytes)};
        case 2: flipOne(0, chunksAt_); return {"a flipped bit before the chunks", false, std::move(bytes)};
        case 3: {
            const std::size_t begin = below(bytes.size());
            std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(begin),
                        std::min(bytes.size() - begin, 1 + below(4096)), std::byte(0));
            return {"zeros", false, std::move(bytes)};
        }
        case 4:
        case 5: bytes.resize(below(bytes.size())); return {"cut", false, std::move(bytes)};
        case 6:
            bytes.resize(bytes.size() + 1 + below(100), std::byte(7));
            return {"bytes behind its end", false, std::move(bytes)};
        case 7:
            return changedOrder("exchanged chunks", below(2) == 0, [&](std::vector<std::size_t>& order) {
                std::swap(order[below(order.size())], order[below(order.size())]);
            });
        case 8:
            return changedOrder("a chunk twice", true, [&](std::vector<std::size_t>& order) {
                const std::size_t twice = below(order.size());
                order.insert(order.begin() + static_cast<std::ptrdiff_t>(below(order.size() + 1)), twice);
            });
        case 9:
            return changedOrder("a chunk left out", true, [&](std::vector<std::size_t>& order) {
                order.erase(order.begin() + static_cast<std::ptrdiff_t>(below(order.size())));
            });
        case 10: {
            for (std::size_t flips = 1 + below(3); flips > 0; --flips)
                flipOne(chunksAt_ + sizeof(format::PackedChunkHead), bytes.size());
            repairPackedChecksums(bytes);
            return {"chunks with flipped bits and right sums", true, std::move(bytes)};
        }
        default: {
            // Numbers of 1 to 8 bytes, where such begin: header, table, facts, levels, sums; the text, too.
            const std::size_t size = std::size_t(1) << below(4);
            const std::size_t at = below((chunksAt_ - size) / size + 1) * size;
            constexpr std::array<std::uint64_t, 6> special = {0, 1, ~0ull, 0x7fffffffffffffff, 0x7fc000007fc00000, 512};
            std::uint64_t number = 0;
            std::memcpy(&number, bytes.data() + at, size);
            switch (below(4)) {
            case 0: number = special[below(special.size())]; break;
            case 1: number = random(); break;
            case 2: number += below(9) - 4; break;
            default: number ^= std::uint64_t(1) << below(8 * size);
            }
            std::memcpy(bytes.data() + at, &number, size);
            repairPackedChecksums(bytes);
            return {"a number before the chunks changed, with right sums", true, std::move(bytes)};
        }
        }
    }

private:
    template <class Change> DamagedPacked changedOrder(const char* what, bool sumsAreRight, const Change& change) const
    {
        std::vector<std::size_t> order(chunks_.size());
        for (std::size_t i = 0; i < order.size(); ++i)
            order[i] = i;
        change(order);
        std::vector<std::byte> bytes(whole_.begin(), whole_.begin() + static_cast<std::ptrdiff_t>(chunksAt_));
        for (const std::size_t chunk : order)
            bytes.insert(bytes.end(), chunks_[chunk].begin(), chunks_[chunk].end());
        if (sumsAreRight) {
            format::Header header;
            format::Section section;
            std::memcpy(static_cast<void*>(&header), bytes.data(), sizeof header);
            std::memcpy(static_cast<void*>(&section), bytes.data() + tableEntry_, sizeof section);
            header.fileBytes = bytes.size();
            section.bytes = bytes.size() - chunksAt_;
            std::memcpy(bytes.data(), &header, sizeof header);
            std::memcpy(bytes.data() + tableEntry_, &section, sizeof section);
            repairPackedChecksums(bytes);
        }
        return {what, sumsAreRight, std::move(bytes)};
    }

    std::span<const std::byte> whole_;
    std::size_t tableEntry_ = 0, chunksAt_ = 0;
    std::vector<std::span<const std::byte>> chunks_; ///< with their heads
};

/// What came of a damaged file.
enum class DamageOutcome {
    Refused,
    Same,    ///< damaged where it means nothing: the model came back byte for byte
    Another, ///< its sums were made right: another model, and it is said which sections are not the original's
};

/// Opens and unpacks damaged forms of one packed file, and judges what comes of them.
class DamageJudge {
public:
    /// Everything is written in `folder`, which is empty and stays so.
    DamageJudge(const std::filesystem::path& packed, std::filesystem::path folder)
        : whole_(bytesOfFile(packed)), damage_(whole_), folder_(std::move(folder)), packed_(*PackedModel::open(packed))
    {
        require(unpackModel(*packed_, folder_ / "model.tan").ok(), "the whole file cannot be unpacked");
        model_ = bytesOfFile(folder_ / "model.tan");
        std::filesystem::remove(folder_ / "model.tan");
    }

    /// Damages it, unpacks it and one of its levels. Failures are added to failures().
    DamageOutcome judge(std::mt19937_64& random)
    {
        const DamagedPacked damaged = damage_.damaged(random);
        what_ = damaged.what;
        const std::filesystem::path place = folder_ / "damaged.tan";
        putFile(place, damaged.bytes);
        const DamageOutcome outcome = judgeFile(damaged, place, random);
        std::filesystem::remove(place);
        require(std::filesystem::is_empty(folder_), "files are left");
        for (const auto& left : std::filesystem::directory_iterator(folder_))
            std::filesystem::remove_all(left);
        return outcome;
    }
    const std::vector<std::string>& failures() const noexcept { return failures_; }

private:
    void require(bool isSo, const std::string& problem)
    {
        if (!isSo)
            failures_.push_back(std::string(what_) + ": " + problem);
    }
    void requireRefusal(const Error& error)
    {
        require(error.kind == ErrorKind::BadInput && error.text().ends_with('.'), "refused by '" + error.text() + "'");
    }

    DamageOutcome judgeFile(const DamagedPacked& damaged, const std::filesystem::path& place, std::mt19937_64& random)
    {
        const auto opened = PackedModel::open(place);
        if (!opened) {
            requireRefusal(opened.error());
            return DamageOutcome::Refused;
        }
        judgePrefix(**opened, damaged, random() % (*opened)->levels().size());
        const std::filesystem::path output = folder_ / "model.tan";
        const auto unpacked = unpackModel(**opened, output);
        if (!unpacked) {
            requireRefusal(unpacked.error());
            require(!std::filesystem::exists(output), "a model is left although it was refused");
            return DamageOutcome::Refused;
        }
        const bool isSame = bytesOfFile(output) == model_;
        require(isSame || (damaged.sumsAreRight && !unpacked->derived.empty()), "another model, and nothing is said");
        requireIntact(output);
        std::filesystem::remove(output);
        return isSame ? DamageOutcome::Same : DamageOutcome::Another;
    }

    void judgePrefix(const PackedModel& opened, const DamagedPacked& damaged, std::size_t level)
    {
        const std::filesystem::path output = folder_ / "prefix.tan";
        const Status made = unpackPrefix(opened, level, output);
        if (!made) {
            requireRefusal(made.error());
            require(!std::filesystem::exists(output), "a prefix is left although it was refused");
            return;
        }
        requireIntact(output);
        if (!damaged.sumsAreRight)
            require(bytesOfFile(output) == prefix(level), "another prefix");
        std::filesystem::remove(output);
    }

    void requireIntact(const std::filesystem::path& path)
    {
        const auto model = Model::open(path);
        require(model.ok() && (*model)->checkIntact().ok(), "what was made is no sound model");
    }

    const std::vector<std::byte>& prefix(std::size_t level)
    {
        std::vector<std::byte>& bytes = prefixes_[level];
        if (bytes.empty()) {
            require(unpackPrefix(*packed_, level, folder_ / "right.tan").ok(), "a level of the whole file");
            bytes = bytesOfFile(folder_ / "right.tan");
            std::filesystem::remove(folder_ / "right.tan");
        }
        return bytes;
    }

    const std::vector<std::byte> whole_;
    const PackedDamage damage_;
    const std::filesystem::path folder_;
    const std::shared_ptr<const PackedModel> packed_;
    std::vector<std::byte> model_;
    std::map<std::size_t, std::vector<std::byte>> prefixes_;
    const char* what_ = "undamaged";
    std::vector<std::string> failures_;
};

} // namespace tetra
