// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/opening/import_texts.h"

#include "core/base/memory.h"
#include "plugins/widgets/number_text.h"
#include "ui/session/message_text.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>
#include <thread>

namespace tetra {
namespace {

class ImportTexts {
    Q_DECLARE_TR_FUNCTIONS(ImportTexts)
};

constexpr std::uint32_t largestSize = 1 << 20; // the product of three is a number of 64 bits

std::optional<std::array<std::uint32_t, 3>> sizeOf(const std::string& text)
{
    static const QRegularExpression separators("[xX*,×\\s]+");
    const QStringList words = QString::fromStdString(text).split(separators, Qt::SkipEmptyParts);
    std::array<std::uint32_t, 3> size{};
    bool understood = words.size() == 3;
    for (qsizetype axis = 0; understood && axis < 3; ++axis) {
        const uint points = words[axis].toUInt(&understood);
        understood = understood && points >= 2 && points <= largestSize;
        size[static_cast<std::size_t>(axis)] = points;
    }
    return understood ? std::optional(size) : std::nullopt;
}

SampleType typeOf(const std::string& name)
{
    for (int type = 0; type <= static_cast<int>(SampleType::Float64); ++type)
        if (sampleTypeName(static_cast<SampleType>(type)) == name)
            return static_cast<SampleType>(type);
    return SampleType::UInt8;
}

template <class T> T valueOf(const ParameterValues& values, const std::string& id, T byDefault)
{
    const auto found = values.find(id);
    const T* value = found != values.end() ? std::get_if<T>(&found->second) : nullptr;
    return value != nullptr ? *value : byDefault;
}

QString sizeText(const std::array<std::uint32_t, 3>& size)
{
    return QString("%1 × %2 × %3").arg(size[0]).arg(size[1]).arg(size[2]);
}

QString typeText(SampleType type)
{
    return translatedText(std::string(sampleTypeName(type)));
}

/// No more digits than an estimate has.
QString roughBytesText(std::uint64_t bytes)
{
    constexpr std::uint64_t mebibyte = 1 << 20;
    constexpr std::uint64_t gibibyte = 1 << 30;
    if (bytes >= gibibyte)
        return bytesText(bytes);
    const std::uint64_t step = bytes >= 100 * mebibyte ? 10 : 1;
    const std::uint64_t steps = std::max<std::uint64_t>(1, (bytes + step * mebibyte / 2) / (step * mebibyte));
    return ImportTexts::tr("%1 MiB").arg(countText(steps * step));
}

QString roughDurationText(double seconds)
{
    constexpr double minute = 60;
    return seconds < minute - 1 ? ImportTexts::tr("%1 s").arg(std::max(1, static_cast<int>(std::ceil(seconds))))
                                : durationText(seconds);
}

} // namespace

std::optional<StoredSamples> storedSamplesOf(const ParameterValues& values)
{
    const auto size = sizeOf(valueOf<std::string>(values, "size", ""));
    if (!size)
        return std::nullopt;
    const bool big = valueOf<std::string>(values, "byte-order", "little") == "big";
    return StoredSamples{.size = *size,
                         .type = typeOf(valueOf<std::string>(values, "type", "uint8")),
                         .order = big ? std::endian::big : std::endian::little,
                         .skippedBytes = static_cast<std::uint64_t>(
                             std::max<std::int64_t>(valueOf<std::int64_t>(values, "skip", 0), 0))};
}

ImportCheck checkRawSize(const StoredSamples& samples, std::uint64_t fileBytes)
{
    const std::uint64_t wanted = samples.skippedBytes + std::uint64_t(samples.size[0]) * samples.size[1] *
                                                            samples.size[2] * sampleSize(samples.type);
    const QString product = sizeText(samples.size) + " × " + typeText(samples.type);
    const QString sum = samples.skippedBytes == 0 ? product : countText(samples.skippedBytes) + " + " + product;
    if (wanted == fileBytes)
        return {true, ImportTexts::tr("%1 = %2 bytes: exactly the size of the file.").arg(sum, countText(wanted))};
    const QString text = wanted > fileBytes ? ImportTexts::tr("%1 = %2 bytes; the file has %3 (%4 missing).")
                                            : ImportTexts::tr("%1 = %2 bytes; the file has %3 (%4 too many).");
    const std::uint64_t difference = std::max(wanted, fileBytes) - std::min(wanted, fileBytes);
    return {false, text.arg(sum, countText(wanted), countText(fileBytes), countText(difference))};
}

QString suggestionText(const ParameterValues& suggestion)
{
    const auto samples = storedSamplesOf(suggestion);
    return samples ? sizeText(samples->size) + ", " + typeText(samples->type) : QString();
}

ImportCheck countPart(const Lattice& lattice, const DatasetPart& part)
{
    const auto taken = partOfLattice(lattice, part);
    if (!taken)
        return {false,
                ImportTexts::tr(
                    "A volume needs at least two points along each axis. Choose a larger region or a smaller stride.")};
    if (part.isWhole())
        return {true,
                ImportTexts::tr("All %1 = %2 points.").arg(sizeText(lattice.size), countText(lattice.pointCount()))};
    return {true, ImportTexts::tr("%1 = %2 of %3 points.")
                      .arg(sizeText(taken->size), countText(taken->pointCount()), countText(lattice.pointCount()))};
}

unsigned usableThreads()
{
    return std::max(1U, std::thread::hardware_concurrency());
}

QString estimateText(const BuildSize& size, const BuildEstimate& estimate)
{
    const QString needs = size.density.known()
                              ? ImportTexts::tr("The build takes about %1 of memory, %2 of disk and %3.")
                              : ImportTexts::tr("The build takes up to %1 of memory, %2 of disk and %3.");
    const auto inOneLine = [](QString amount) { return amount.replace(' ', QChar::Nbsp); };
    const QString text =
        needs.arg(inOneLine(roughBytesText(estimate.memoryBytes)), inOneLine(roughBytesText(estimate.diskBytes)),
                  inOneLine(roughDurationText(estimate.seconds)));
    const std::uint64_t usable = usableBytes();
    if (usable != 0 && estimate.memoryBytes > usable)
        return text + " " + ImportTexts::tr("This machine has %1 of memory.").arg(bytesText(usable));
    return text;
}

QString modelSizeText(const BuildEstimate& estimate)
{
    return ImportTexts::tr("%1, %2").arg(roughBytesText(estimate.modelBytes), roughDurationText(estimate.seconds));
}

} // namespace tetra
