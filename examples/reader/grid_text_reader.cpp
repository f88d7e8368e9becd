// SPDX-License-Identifier: GPL-3.0-or-later
#include <plugins/api/plugin.h>
#include <plugins/api/reader.h>

#include <tan/data.h>

#include <cerrno>
#include <fstream>
#include <iterator>

namespace {
using namespace tetra;

/// What is wrong in the file, and what to do. The program says which file it is.
Error refused(const Message& reason)
{
    return {ErrorKind::BadInput, reason};
}
} // namespace

/// Reads a lattice from text: three numbers of points, then a value for each point, x fastest.
class GridTextReader : public tetra::Reader {
public:
    std::vector<std::string> nameFilters() const override { return {Message::marked("Grid text (*.grid)")}; }
    double score(const std::filesystem::path& path, std::span<const std::byte>) const override
    {
        return path.extension() == ".grid" ? 1 : 0;
    }
    std::vector<Parameter> parameters() const override { return {}; }

    Result<Dataset> read(const std::filesystem::path& path, const ParameterValues&, const Progress&) const override
    {
        std::ifstream file(path);
        if (!file)
            return refused(Message::say("%1.", systemErrorText(errno)));
        const std::vector<std::string> words(std::istream_iterator<std::string>(file), {});
        Lattice lattice;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto size = axis < words.size() ? parseNumber<std::uint32_t>(words[axis]) : std::nullopt;
            if (!size || *size < 2 || *size > 1024)
                return refused(Message::say("it begins with three numbers of points, each from 2 to 1024."));
            lattice.size[axis] = *size;
        }
        const std::uint64_t count = lattice.pointCount();
        if (words.size() != count + 3)
            return refused(Message::say("it should have %1 values.", count));
        std::vector<float> samples;
        for (std::size_t i = 3; i < words.size(); ++i) {
            const auto value = parseNumber<float>(words[i]);
            if (!value)
                return refused(Message::say("'%1' is not a number.", printable(words[i])));
            samples.push_back(*value);
        }
        return latticeDataset(lattice, ScalarField::of(std::move(samples)), path.filename().string());
    }
};

TAN_PLUGIN(GridTextReader, tetra::Reader)
