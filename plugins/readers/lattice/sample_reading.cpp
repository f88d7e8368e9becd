// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/sample_reading.h"

#include "plugins/readers/lattice/gzip_decoding.h"
#include "plugins/readers/lattice/raw_decoding.h"
#include "plugins/readers/lattice/text_decoding.h"

#include <tan/data.h>

#include <algorithm>
#include <numeric>
#include <string>

namespace tetra {

namespace {

std::string_view sampleText(std::span<const std::byte> bytes)
{
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

Message described(const SampleLayout& layout)
{
    const auto& size = layout.lattice.size;
    return Message::say("%1 x %2 x %3 samples of type %4, %5 bytes", size[0], size[1], size[2],
                        sampleTypeName(layout.type), layout.sampleBytes());
}

Error tooFew(const SampleLayout& layout, const Message& found)
{
    return {ErrorKind::BadInput, Message::say("it should hold %1, but there are only %2. It is cut short, or its "
                                              "description (sizes, type, bytes to skip) is wrong.",
                                              described(layout), found)};
}

Result<std::span<const std::byte>> skipLines(std::span<const std::byte> data, std::uint64_t lines)
{
    for (std::uint64_t line = 0; line < lines; ++line) {
        const std::size_t end = sampleText(data).find('\n');
        if (end == std::string_view::npos)
            return Error{
                ErrorKind::BadInput,
                Message::say("it has only %1 of the %2 lines that are to be skipped. Check 'line skip'.", line, lines)};
        data = data.subspan(end + 1);
    }
    return data;
}

/// The bytes that are the samples, in a file that is not compressed.
Result<std::span<const std::byte>> rawBytes(std::span<const std::byte> data, const SampleLayout& layout)
{
    const std::uint64_t wanted = layout.sampleBytes();
    const std::uint64_t skipped = std::min<std::uint64_t>(layout.skippedBytes, data.size());
    const std::uint64_t found = data.size() - skipped;
    if (found < wanted)
        return tooFew(layout, Message::say("%1 bytes", found));
    if (layout.atEndOfFile)
        return data.last(wanted);
    if (found > wanted)
        return Error{ErrorKind::BadInput,
                     Message::say("it should hold %1, but there are %2, %3 too many. Its description is wrong: check "
                                  "the sizes, the type and the bytes to skip.",
                                  described(layout), found, found - wanted)};
    return data.subspan(skipped);
}

/// Whether data that must be decoded can hold the samples at all.
Status checkEnough(std::span<const std::byte> data, const SampleLayout& layout)
{
    const bool gzip = layout.encoding == SampleEncoding::Gzip;
    const std::uint64_t most =
        gzip ? largestUnpackedSize(data.size()) : (data.size() + 1) / 2 * sampleSize(layout.type);
    if (most >= layout.sampleBytes())
        return {};
    return tooFew(layout, gzip ? Message::say("%1 bytes of compressed data", data.size())
                               : Message::say("%1 bytes of text", data.size()));
}

Status decode(std::span<const std::byte> data, const SampleLayout& layout, std::span<std::byte> samples,
              const Progress& progress)
{
    switch (layout.encoding) {
    case SampleEncoding::Raw: return copyRawSamples(data, layout.type, layout.order, samples, progress);
    case SampleEncoding::Text:
        return readTextSamples(sampleText(data.subspan(std::min<std::uint64_t>(layout.skippedBytes, data.size()))),
                               layout.type, samples, progress);
    case SampleEncoding::Gzip: break;
    }
    const Status unpacked = unpackGzip(data, layout.skippedBytes, samples, progress);
    if (unpacked)
        toNativeOrder(samples, layout.type, layout.order);
    return unpacked;
}

/// Whether the bytes are the samples as they stand in memory.
bool areInPlace(std::span<const std::byte> encoded, const SampleLayout& layout)
{
    const std::size_t size = sampleSize(layout.type);
    return layout.encoding == SampleEncoding::Raw && (size == 1 || layout.order == std::endian::native) &&
           reinterpret_cast<std::uintptr_t>(encoded.data()) % size == 0;
}

/// What follows the skipped lines; of raw data the samples alone.
Result<std::span<const std::byte>> encodedSamples(std::span<const std::byte> data, const SampleLayout& layout)
{
    const Result<std::span<const std::byte>> encoded = skipLines(data, layout.skippedLines);
    if (encoded && layout.encoding == SampleEncoding::Raw)
        return rawBytes(*encoded, layout);
    if (encoded)
        if (const Status enough = checkEnough(*encoded, layout); !enough)
            return enough.error();
    return encoded;
}

Result<ScalarField> decodedSamples(std::span<const std::byte> encoded, const SampleLayout& layout,
                                   const Progress& progress)
{
    Result<std::shared_ptr<std::byte>> samples = allocateSamples(layout.type, layout.lattice.pointCount());
    if (!samples)
        return samples.error();
    if (const Status decoded = decode(encoded, layout, {samples->get(), layout.sampleBytes()}, progress); !decoded)
        return decoded.error();
    return ScalarField(layout.type, layout.lattice.pointCount(), *std::move(samples));
}

} // namespace

Status checkSampleBytes(std::span<const std::byte> data, const SampleLayout& layout)
{
    const auto encoded = encodedSamples(data, layout);
    return encoded ? Status() : encoded.error();
}

SampleLayout layoutOfEach(const SampleLayout& layout, std::uint64_t files)
{
    SampleLayout one = layout;
    for (std::size_t axis = 3; axis-- > 0 && files > 1;) {
        const std::uint64_t part = std::gcd<std::uint64_t>(one.lattice.size[axis], files);
        one.lattice.size[axis] /= static_cast<std::uint32_t>(part);
        files /= part;
    }
    return one;
}

Status readSamplesInto(std::span<std::byte> samples, std::span<const std::byte> data, const SampleLayout& layout,
                       const Progress& progress)
{
    const auto encoded = encodedSamples(data, layout);
    return encoded ? decode(*encoded, layout, samples, progress) : encoded.error();
}

Result<ScalarField> readSamples(std::span<const std::byte> data, const SampleLayout& layout, const Progress& progress,
                                const std::shared_ptr<const void>& owner)
{
    const auto encoded = encodedSamples(data, layout);
    if (!encoded)
        return encoded.error();
    return owner && areInPlace(*encoded, layout)
               ? ScalarField::scanned(layout.type, layout.lattice.pointCount(), {owner, encoded->data()}, progress)
               : decodedSamples(*encoded, layout, progress);
}

} // namespace tetra
