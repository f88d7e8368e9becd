// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/points/csv_writer.h"

#include "core/base/file_writer.h"
#include "core/base/text.h"

#include <new>

namespace tetra {

std::vector<std::string> CsvWriter::nameFilters() const
{
    return {Message::marked("Table of points (*.csv)")};
}

double CsvWriter::score(const std::filesystem::path& path) const
{
    const std::string name = path.extension().string();
    return name == ".csv" || name == ".CSV" ? 1 : 0;
}

std::vector<Parameter> CsvWriter::parameters() const
{
    return {};
}

Status CsvWriter::write(const Dataset& dataset, const std::filesystem::path& path, const ParameterValues& /*values*/,
                        const Progress& progress) const
try {
    constexpr std::uint64_t pointsBetweenReports = 1 << 14;
    Result<FileWriter> file = FileWriter::create(path);
    if (!file)
        return file.error();
    std::string text = "x,y,z,value\n";
    for (std::uint64_t point = 0; point < dataset.pointCount(); ++point) {
        const Eigen::Vector3d position = dataset.position(point);
        for (const double coordinate : position)
            text += formatNumber(coordinate) + ",";
        text += formatNumber(dataset.values.at(point)) + "\n";
        if (point % pointsBetweenReports != 0 && point + 1 != dataset.pointCount())
            continue;
        if (progress.cancelled())
            return cancelledError(Message::marked("Writing"));
        if (const Status written = file->write(std::as_bytes(std::span(text))); !written)
            return written;
        text.clear();
        progress.report(static_cast<double>(point + 1) / static_cast<double>(dataset.pointCount()),
                        Message::marked("Writing"));
    }
    if (const Status intact = dataset.checkIntact(); !intact)
        return intact;
    return file->commit();
} catch (const std::bad_alloc&) {
    return Error{ErrorKind::OutOfResource, Message::say("Not enough memory to write the file. Close other programs.")};
}

} // namespace tetra
