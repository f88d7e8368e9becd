// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/sample_models.h"

#include "core/base/system_error.h"
#include "core/data/analytic_fields.h"
#include "core/model/model.h"
#include "plugins/host/dataset_opening.h"
#include "plugins/host/dataset_saving.h"
#include "plugins/host/model_building.h"
#include "ui/session/target_path.h"

#include <QStandardPaths>

#include <algorithm>

namespace tetra {
namespace {

/// How a sample of a kind of domain is saved, and in which size it is built within seconds.
struct SampleFile {
    const char* ending;
    std::uint32_t size;
};

SampleFile fileOf(DomainClass domain)
{
    switch (domain) {
    case DomainClass::RegularLattice: return {".nrrd", 48};
    case DomainClass::Curvilinear: return {".xyz", 32};
    case DomainClass::Irregular: return {".vtu", 48};
    case DomainClass::Scattered: return {".csv", 20};
    }
    return {".nrrd", 48};
}

Status makeFolder(const std::filesystem::path& folder)
{
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        return Error{ErrorKind::CannotWrite, "The folder '" + folder.string() +
                                                 "' for samples cannot be made: " + systemErrorText(error.value()) +
                                                 ". Make it writable, or free some space."};
    return {};
}

} // namespace

std::filesystem::path sampleFolder()
{
    return filePath(QStandardPaths::writableLocation(QStandardPaths::CacheLocation)) / "samples";
}

bool isOfSample(const std::filesystem::path& file)
{
    return file.parent_path() == sampleFolder();
}

Result<std::filesystem::path> sampleModel(PluginHost& host, const std::string& name,
                                          const std::filesystem::path& folder, const Progress& progress)
{
    const std::filesystem::path model = folder / (name + ".tan");
    if (Model::open(model))
        return model;
    if (const Status made = makeFolder(folder); !made)
        return made.error();
    SampleRequest request{.name = name, .size = 0, .type = {}, .seed = 1};
    const auto kinds = sampleKinds();
    const auto kind = std::ranges::find(kinds, name, &SampleKind::name);
    const SampleFile file = fileOf(kind == kinds.end() ? DomainClass::RegularLattice : kind->domain);
    request.size = file.size;
    const auto dataset = makeSample(request, progress.part(0, 0.05));
    if (!dataset)
        return dataset.error();
    // By way of a file, so that the model knows where it is from, and the dataset can be read again.
    const std::filesystem::path source = folder / (name + file.ending);
    if (const Status saved = saveDataset(host, *dataset, source, {}, progress.part(0.05, 0.1)); !saved)
        return saved.error();
    const auto read = openDataset(host, source, {}, progress.part(0.1, 0.15));
    if (!read)
        return read.error();
    const auto built = buildModel(host, *read, std::nullopt, {}, model, progress.part(0.15, 1));
    if (!built)
        return built.error();
    return model;
}

} // namespace tetra
