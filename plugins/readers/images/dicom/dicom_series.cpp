// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/images/dicom/dicom_series.h"

#include "plugins/readers/images/slice_names.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace tetra {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view tableOfDisk = "1.2.840.10008.1.3.10", segmentation = "1.2.840.10008.5.1.4.1.1.66.4";

/// Objects that stand beside pictures and have none, or none of numbers.
Message whyNoPictures(const DicomHeader& header)
{
    if (header.kind == tableOfDisk)
        return Message::say(
            "it is the table of contents of a disk (DICOMDIR). Open one of the pictures in the folders next to it.");
    if (header.kind == segmentation)
        return Message::say("it is a segmentation, whose pictures are outlines of objects, not numbers. Export it as "
                            "NRRD, for instance with 3D Slicer.");
    if (header.hasFloats)
        return Message::say("its pixels are floating-point numbers (FloatPixelData), which TAn does not read from "
                            "DICOM files. Export it as NRRD, for instance with 3D Slicer.");
    if (!header.hasPixels)
        return Message::say("it holds no picture (%1). If it should have one, it is cut short: copy it again. "
                            "Otherwise open a picture of the series that it belongs to.",
                            header.modality.empty() ? "-" : printable(header.modality));
    return {};
}

Message nameOf(const std::vector<DicomHeader>& headers)
{
    const DicomHeader& first = headers.front();
    std::size_t pictures = 0;
    for (const DicomHeader& header : headers)
        pictures += header.frames.size();
    const Message count = Message::say("%1 pictures", pictures);
    const Message kind = first.modality.empty() ? count : Message::say("%1, %2", printable(first.modality), count);
    const Message all =
        first.seriesNumber.empty() ? kind : Message::say("SeriesNumber %1, %2", printable(first.seriesNumber), kind);
    return first.description.empty() ? all : Message::say("%1 (%2)", printable(first.description), all);
}

/// "1: T1 axial (SeriesNumber 3, MR, 176 pictures); 2: ..."
Message seriesList(const std::vector<DicomSeries>& all)
{
    constexpr std::size_t mostNamed = 20;
    Message list;
    for (std::size_t at = 0; at < std::min(mostNamed, all.size()); ++at) {
        const Message one = Message::say("%1: %2", at + 1, all[at].name);
        list = at == 0 ? one : Message::say("%1; %2", list, one);
    }
    return all.size() > mostNamed ? Message::say("%1 and %2 more", list, all.size() - mostNamed) : list;
}

void addSeries(std::map<std::string, std::vector<DicomHeader>> bySeries, const std::string& opened, DicomFolder& folder)
{
    std::vector<std::pair<std::string, std::vector<DicomHeader>>> all;
    for (auto& [series, headers] : bySeries)
        all.emplace_back(series, std::move(headers));
    std::ranges::sort(all, {}, [](const auto& entry) {
        const DicomHeader& first = entry.second.front();
        return std::tuple(parseNumber<std::int64_t>(first.seriesNumber).value_or(0), first.description, entry.first);
    });
    for (auto& [series, headers] : all) {
        if (series == opened)
            folder.opened = folder.series.size();
        folder.series.push_back({nameOf(headers), std::move(headers)});
    }
}

} // namespace

Result<DicomFolder> dicomFolder(const fs::path& path, const TellProgress& progress)
{
    DicomHeader own = dicomHeader(path);
    if (!own.fault.empty())
        return Error{ErrorKind::BadInput, own.fault};
    if (const Message noPictures = whyNoPictures(own); !noPictures.empty())
        return Error{ErrorKind::BadInput, noPictures};
    std::error_code problem;
    const std::vector<fs::path> beside = pathsIn(path.parent_path(), problem);
    const std::vector<fs::path> numbered = numberedBeside(path);
    const std::set<fs::path> alike(numbered.begin(), numbered.end());
    std::map<std::string, std::vector<DicomHeader>> bySeries;
    DicomFolder folder;
    const std::string series = own.series;
    bySeries[series].push_back(std::move(own));
    for (std::size_t at = 0; at < beside.size(); ++at) {
        constexpr std::size_t betweenTold = 32;
        if (at % betweenTold == 0)
            progress(static_cast<double>(at) / static_cast<double>(beside.size()));
        std::error_code ignored;
        if (beside[at] == path || !fs::is_regular_file(beside[at], ignored))
            continue;
        const bool isAlike = alike.contains(beside[at]);
        const std::string name = printable(beside[at].filename().string());
        if (!looksLikeDicom(beside[at])) {
            if (isAlike)
                return Error{
                    ErrorKind::BadInput,
                    Message::say(
                        "the file '%1' of its series: it is not a DICOM file, or ends too early. Copy the file again.",
                        name)};
            continue;
        }
        DicomHeader header = dicomHeader(beside[at]);
        const bool mayBeSlice = header.rows > 0 || header.series == series || (isAlike && header.series.empty());
        if (header.fault.empty() && mayBeSlice && !header.hasPixels && !header.hasFloats)
            header.fault = whyNoPictures(header); // it is cut between two elements
        if (!header.fault.empty()) {
            if (isAlike || header.series == series)
                return Error{ErrorKind::BadInput, Message::say("the file '%1' of its series: %2", name, header.fault)};
            folder.unreadable.push_back(Message::say("The file '%1' next to it was not read: %2", name, header.fault));
        } else if (whyNoPictures(header).empty()) {
            bySeries[header.series].push_back(std::move(header));
        }
    }
    for (auto& [name, headers] : bySeries) // in no order of the folder
        std::ranges::sort(headers, {}, &DicomHeader::path);
    addSeries(std::move(bySeries), series, folder);
    return folder;
}

Result<std::size_t> chosenSeries(const DicomFolder& folder, const std::string& wanted)
{
    if (wanted.empty())
        return folder.opened;
    const auto number = parseNumber<std::size_t>(wanted);
    if (number && *number >= 1 && *number <= folder.series.size())
        return *number - 1;
    for (std::size_t series = 0; series < folder.series.size(); ++series)
        if (folder.series[series].headers.front().series == wanted)
            return series;
    const auto isDescribed = [&](const DicomSeries& series) { return series.headers.front().description == wanted; };
    if (std::ranges::count_if(folder.series, isDescribed) == 1)
        return static_cast<std::size_t>(std::ranges::find_if(folder.series, isDescribed) - folder.series.begin());
    if (folder.series.size() == 1)
        return Error{ErrorKind::WrongUsage,
                     Message::say("its folder holds one series, and '%1' was requested. Leave 'series' out.",
                                  printable(wanted))};
    return Error{ErrorKind::WrongUsage,
                 Message::say("its folder holds %1 series, and '%2' was requested. Choose one with 'series', by its "
                              "number from 1 or its description: %3.",
                              folder.series.size(), printable(wanted), seriesList(folder.series))};
}

} // namespace tetra
