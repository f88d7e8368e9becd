// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/data.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tetra {

/// What the samples of a page are.
struct TiffSamples {
    std::uint32_t width = 0, height = 0;
    std::uint16_t samples = 1, bits = 1;
    std::uint16_t format = 1; ///< as SampleFormat of the file: 1 unsigned, 2 signed, 3 floating point
    std::uint16_t photometric = 1;
    bool operator==(const TiffSamples&) const = default;
};

/// A page whose pixels were found to lie in the file.
struct TiffPage {
    TiffSamples samples{};
    std::uint64_t directory = 0; ///< where it is described
    bool isReduced = false;      ///< a smaller copy of another page, or a mask
    bool hasCopies = false;      ///< smaller copies of it are described apart (SubIFDs)
    /// Of pixels that lie one after the other, as they are in memory but for the order of bytes: where. Other pages may
    /// follow that nothing describes.
    std::optional<std::uint64_t> pixelsAt{};
};

/// What the first page says of the file.
struct TiffTexts {
    std::string description{};
    std::array<std::optional<double>, 2> pixelsPerUnit{};
    std::uint16_t resolutionUnit = 2; ///< 1 none, 2 inch, 3 centimetre
};

/// What is wanted of a page.
struct TiffWanted {
    SampleType type = SampleType::UInt8;    ///< of what is made of the samples
    std::optional<std::uint16_t> component; ///< of the samples of a pixel, from 0; none: the magnitude of `colours`
    std::uint16_t colours = 3;              ///< the first ones
    double offset = 0;                      ///< added to what is stored
};

/// A TIFF file that libtiff has opened, and all its pages.
class TiffFile {
public:
    /// Walks the chain of pages; every page and each of its strips or tiles must lie in the file. The error says what
    /// is wrong with "it".
    static Result<TiffFile> open(const std::filesystem::path& path);
    ~TiffFile();
    TiffFile(TiffFile&&) noexcept;
    TiffFile& operator=(TiffFile&&) noexcept;

    std::span<const TiffPage> pages() const;
    const TiffTexts& texts() const;
    std::uint64_t bytes() const;

    /// Reads one page into `target`, width x height samples of wanted.type. `page` is a number in pages(), or, if
    /// TiffPage::pixelsAt of the only one is known, that of a page behind it that nothing describes. Numbers of 64 bits
    /// that no double holds are counted in `rounded`. The error says what is wrong with "it".
    Status read(std::uint64_t page, const TiffWanted& wanted, std::byte* target, std::uint64_t& rounded) const;

private:
    struct Content;
    explicit TiffFile(std::unique_ptr<Content> content);
    std::unique_ptr<Content> content_;
};

/// The type that holds such samples exactly; nothing if TAn reads none such. Of whole numbers of 64 bits doubles.
std::optional<SampleType> typeOf(const TiffSamples& samples);

} // namespace tetra
