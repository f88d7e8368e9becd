// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/output_check.h"

#include "plugins/host/input_file.h"

namespace tetra {

Status checkOutput(const std::filesystem::path& output, std::span<const std::filesystem::path> inputs)
{
    for (const std::filesystem::path& input : inputs) {
        std::error_code problem; // of files that do not exist: they are not the same
        if (std::filesystem::equivalent(output, input, problem))
            return Error{ErrorKind::WrongUsage, "The output '" + output.string() + "' is the input '" + input.string() +
                                                    "'. Give the output another name."};
    }
    return {};
}

Status checkModelOutput(const std::filesystem::path& output)
{
    const auto bytes = firstBytesOf(output);
    if (!bytes || isModelFile(output))
        return {}; // nothing to lose: missing, empty or a model; what cannot be written is told by writing
    return Error{ErrorKind::WrongUsage, "'" + output.string() +
                                            "' exists and is no TAn model, so it is not overwritten. Give the model "
                                            "another name, or remove that file first."};
}

} // namespace tetra
