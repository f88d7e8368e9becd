// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/output_check.h"

namespace tetra {

Status checkOutput(const std::filesystem::path& output, std::span<const std::filesystem::path> inputs)
{
    for (const std::filesystem::path& input : inputs) {
        std::error_code problem; // of files that do not exist: they are not the same
        if (std::filesystem::equivalent(output, input, problem))
            return Error{ErrorKind::WrongUsage,
                         Message::say("The output '%1' is the input '%2'. Give the output another name.",
                                      output.string(), input.string())};
    }
    return {};
}

Status checkMeshOutput(const std::filesystem::path& output, const Model& model)
{
    return checkMeshOutput(output, model.description().sourceName);
}

Status checkMeshOutput(const std::filesystem::path& output, const std::string& source)
{
    std::error_code problem; // a source is "part.vtu", or "part.vtu, temperature"
    const std::string name = output.filename().string();
    const bool isCalledLikeIt =
        source.starts_with(name) && (source.size() == name.size() || source[name.size()] == ',');
    if (!isCalledLikeIt || !std::filesystem::exists(output, problem))
        return {};
    return Error{ErrorKind::WrongUsage,
                 Message::say("'%1' exists and has the same name as the dataset that the model was built from, so it "
                              "is not overwritten. Give the output another name, or remove that file first.",
                              output.string())};
}

} // namespace tetra
