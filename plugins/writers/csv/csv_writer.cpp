// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/api/plugin.h"
#include "plugins/api/writer.h"

namespace tetra {

namespace {

/// As the name of a column: in quotation marks where it has a character that could end it.
std::string columnName(const std::string& name)
{
    if (name.empty())
        return "value";
    if (name.find_first_of(",;\t\" ") == std::string::npos)
        return name;
    std::string quoted = "\"";
    for (const char c : name)
        quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

} // namespace

/// `.csv`: the points of any dataset as a table with the columns x, y, z and that of the values, called as the dataset
/// calls them. Numbers are the shortest that are
/// read as the same again. What connects the points is lost.
class CsvWriter : public Writer {
public:
    std::vector<FileFormat> formats() const override
    {
        return {{WrittenContent::Dataset, Message::marked("Tables of points"), {".csv"}}};
    }

    Status writeDataset(const Dataset& dataset, OutputFile& file, const ParameterValues& /*values*/) const override
    {
        constexpr std::uint64_t pointsAtOnce = 1 << 12, bytesOfPoint = 40;
        file.expect(bytesOfPoint * dataset.pointCount());
        std::string text = "x,y,z," + columnName(dataset.source.valueName) + "\n";
        for (std::uint64_t point = 0; point < dataset.pointCount(); ++point) {
            const Eigen::Vector3d position = dataset.position(point);
            for (const double coordinate : position)
                text += formatNumber(coordinate) + ",";
            text += formatNumber(dataset.values.at(point)) + "\n";
            if (point % pointsAtOnce != 0 && point + 1 != dataset.pointCount())
                continue;
            if (const Status written = file.text(text); !written)
                return written;
            text.clear();
        }
        return {};
    }
};

} // namespace tetra

TAN_PLUGIN(tetra::CsvWriter, tetra::Writer)
