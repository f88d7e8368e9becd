// SPDX-License-Identifier: GPL-3.0-or-later
#include <plugins/api/reader.h>

#include <tan/data.h>

#include <QFile>
#include <QObject>

namespace {
using namespace tetra;

/// What is wrong in the file, and what to do. The program says which file it is.
Error refused(const Message& reason)
{
    return {ErrorKind::BadInput, reason};
}
} // namespace

/// Reads a lattice from text: three numbers of points, then a value for each point, x fastest.
class GridTextReader : public QObject, public tetra::Reader {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID TAN_READER_INTERFACE FILE "grid_text_reader.json")
    Q_INTERFACES(tetra::Reader)

public:
    std::vector<std::string> nameFilters() const override { return {Message::marked("Grid text (*.grid)")}; }
    double score(const std::filesystem::path& path, std::span<const std::byte>) const override
    {
        return path.extension() == ".grid" ? 1 : 0;
    }
    std::vector<Parameter> parameters() const override { return {}; }

    Result<Dataset> read(const std::filesystem::path& path, const ParameterValues&, const Progress&) const override
    {
        QFile file(QString::fromStdString(path.string()));
        if (!file.open(QIODevice::ReadOnly))
            return refused(Message::say("%1.", file.errorString().toStdString()));
        const QByteArrayList words = file.readAll().simplified().split(' ');
        Lattice lattice;
        for (int axis = 0; axis < 3; ++axis) {
            lattice.size[axis] = words.value(axis).toUInt();
            if (lattice.size[axis] < 2 || lattice.size[axis] > 1024)
                return refused(Message::say("it begins with three numbers of points, each from 2 to 1024."));
        }
        const std::uint64_t count = lattice.pointCount();
        if (std::uint64_t(words.size()) != count + 3)
            return refused(Message::say("it should have %1 values.", count));
        std::vector<float> samples(count);
        bool allNumbers = true;
        for (std::uint64_t i = 0; i < count && allNumbers; ++i)
            samples[i] = words[qsizetype(i) + 3].toFloat(&allNumbers);
        if (!allNumbers)
            return refused(Message::say("a value is no number."));
        return latticeDataset(lattice, ScalarField::of(std::move(samples)), path.filename().string());
    }
};

#include "grid_text_reader.moc"
