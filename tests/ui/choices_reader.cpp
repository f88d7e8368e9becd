// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/api/plugin.h"
#include "plugins/api/reader.h"

#include <chrono>
#include <thread>

namespace tetra {

/// Knows files that end in ".choices" and gives a lattice of zeros that is named after what was chosen. The array
/// "slow" takes until it is cancelled.
class ChoicesReader : public Reader {
public:
    std::vector<std::string> nameFilters() const override { return {"Choices (*.choices)"}; }
    double score(const std::filesystem::path& path, std::span<const std::byte>) const override
    {
        return path.extension() == ".choices" ? 1 : 0;
    }
    std::vector<Parameter> parameters() const override
    {
        return {{.id = "array",
                 .label = Message::marked("Values"),
                 .explanation = Message::marked("Which."),
                 .unit = "",
                 .defaultValue = std::string("automatic")},
                {.id = "component",
                 .label = Message::marked("Component"),
                 .explanation = Message::marked("Which."),
                 .unit = "",
                 .defaultValue = std::string("magnitude")},
                {.id = "time",
                 .label = Message::marked("Time step"),
                 .explanation = Message::marked("Which."),
                 .unit = "",
                 .defaultValue = std::int64_t(1)},
                {.id = "part",
                 .label = Message::marked("Part"),
                 .explanation = Message::marked("Which."),
                 .unit = "",
                 .defaultValue = std::string()}};
    }
    Result<FileContents> probe(const std::filesystem::path&, const ParameterValues&, const Progress&) const override
    {
        FileContents contents{.domain = DomainClass::RegularLattice, .lattice = {.size = {5, 4, 3}}, .points = 60};
        contents.arrays = {{.name = "density"},
                           {.name = "velocity", .components = 3},
                           {.name = "heat", .perCell = true},
                           {.name = "slow"}};
        contents.timeSteps = {0, 0.5, 1.25};
        contents.blocks = {"rotor", "stator"};
        return contents;
    }
    Result<Dataset> read(const std::filesystem::path& path, const ParameterValues& values,
                         const Progress& progress) const override
    {
        const auto all = parameters();
        const auto array = parameterValue<std::string>(all, values, "array");
        while (array == "slow" && !progress.cancelled())
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        if (progress.cancelled())
            return cancelledError("Reading");
        const Lattice lattice{.size = {5, 4, 3}};
        std::shared_ptr<const std::byte> samples(new std::byte[lattice.pointCount()](),
                                                 std::default_delete<std::byte[]>());
        const std::string name = array + "/" + parameterValue<std::string>(all, values, "component") + "/" +
                                 std::to_string(parameterValue<std::int64_t>(all, values, "time")) + "/" +
                                 parameterValue<std::string>(all, values, "part");
        return Dataset{.lattice = lattice,
                       .values = ScalarField(SampleType::UInt8, lattice.pointCount(), std::move(samples)),
                       .source = {name, path, 0}};
    }
};

} // namespace tetra

TAN_PLUGIN(tetra::ChoicesReader, tetra::Reader)
