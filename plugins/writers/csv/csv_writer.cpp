// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/api/writer.h"

#include <QObject>

namespace tetra {

/// `.csv`: the points of any dataset as a table with the columns x, y, z and value. Numbers are the shortest that are
/// read as the same again. What connects the points is lost.
class CsvWriter : public QObject, public Writer {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID TAN_WRITER_INTERFACE FILE "csv_writer.json")
    Q_INTERFACES(tetra::Writer)

public:
    std::vector<FileFormat> formats() const override
    {
        return {{WrittenContent::Dataset, Message::marked("Tables of points"), {".csv"}}};
    }

    Status writeDataset(const Dataset& dataset, OutputFile& file, const ParameterValues& /*values*/) const override
    {
        constexpr std::uint64_t pointsAtOnce = 1 << 12, bytesOfPoint = 40;
        file.expect(bytesOfPoint * dataset.pointCount());
        std::string text = "x,y,z,value\n";
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

#include "csv_writer.moc"
