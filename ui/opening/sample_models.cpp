// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/opening/sample_models.h"

#include "core/base/system_error.h"
#include "core/picture/png_file.h"
#include "core/picture/rendering_modes.h"
#include "core/picture/view_picture.h"
#include "plugins/api/boundary_parameters.h"
#include "plugins/api/scene_parameters.h"
#include "plugins/host/dataset_opening.h"
#include "plugins/host/file_saving.h"
#include "plugins/host/model_building.h"
#include "plugins/samples/samples.h"
#include "ui/scenes/picture_image.h"
#include "ui/session/files.h"

#include <tan/model.h>
#include <tan/version.h>
#include <tan/view.h>

#include <QCoreApplication>
#include <QStandardPaths>
#include <QTemporaryDir>

#include <algorithm>

namespace tetra {
namespace {

/// How a sample of a kind of domain is saved, and in which size it is built within seconds.
struct SampleFile {
    const char* ending;
    std::uint32_t size;
};

class SampleTexts {
    Q_DECLARE_TR_FUNCTIONS(Samples)
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

/// The kind of that name; nothing if there is none.
const SampleKind* kindOf(const std::string& name)
{
    const auto kinds = sampleKinds();
    const auto kind = std::ranges::find(kinds, name, &SampleKind::name);
    return kind == kinds.end() ? nullptr : &*kind;
}

/// "48 × 48 × 48 points"; of a mesh nothing is known before it is made.
QString sampleSizeText(const std::string& name)
{
    const SampleKind* kind = kindOf(name);
    const int size = static_cast<int>(fileOf(kind->domain).size);
    if (kind->domain == DomainClass::Scattered)
        return SampleTexts::tr("%1 points").arg(QLocale().toString(size * size * size));
    return SampleTexts::tr("%1 × %1 × %1 points").arg(size);
}

/// How a sample looks best in a small picture: grids and meshes by the values on their boundary, which shows their
/// shape.
struct ThumbnailStyle {
    std::string mode;
    bool boundary = false;
};

ThumbnailStyle thumbnailStyle(const SampleKind& kind)
{
    if (kind.domain == DomainClass::Curvilinear || kind.domain == DomainClass::Irregular)
        return {"isosurface", true};
    return {kind.name == "c60" || kind.name == "marschner-lobb" ? "isosurface" : "volume", false};
}

Result<Picture> drawThumbnail(PluginHost& host, const SampleKind& kind, const Progress& progress)
{
    constexpr std::uint32_t smallSize = 24;
    SampleRequest request{.name = kind.name, .size = smallSize, .type = {}, .seed = 1};
    if (kind.domain == DomainClass::Scattered)
        request.size = smallSize / 2;
    const auto dataset = makeSample(request, progress.part(0, 0.1));
    if (!dataset)
        return dataset.error();
    const QTemporaryDir folder;
    const std::filesystem::path file = filePath(folder.filePath("sample.tan"));
    if (const auto built = buildModel(host, *dataset, std::nullopt, {}, file, progress.part(0.1, 0.6)); !built)
        return built.error();
    const auto model = Model::open(file);
    if (!model)
        return model.error();
    const auto field = extentOf(*model);
    if (!field)
        return field.error();
    const auto modes = renderingModes(host);
    const ThumbnailStyle style = thumbnailStyle(kind);
    const auto mode = std::ranges::find(modes, style.mode, &Provided<Renderer>::id);
    if (mode == modes.end())
        return Error{ErrorKind::OutOfResource, host.explainMissing(PluginKind::Renderer)};
    ViewValue view = startingView(modes, **model, *field, double(thumbnailWidth) / thumbnailHeight);
    view.appearance.settings[outlineId] = false;
    view.appearance.settings[boundaryId] = std::string(style.boundary ? boundaryValues : boundaryOff);
    if (style.boundary)
        view.isovalues.clear();
    return drawPicture({.scene = {},
                        .camera = view.camera,
                        .background = {},
                        .width = thumbnailWidth,
                        .height = thumbnailHeight,
                        .transparent = true},
                       sceneOf(*model, mode->plugin, mode->plugin->parameters(*field), view), progress.part(0.6, 1));
}

Status makeFolder(const std::filesystem::path& folder)
{
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        return Error{ErrorKind::CannotWrite,
                     Message::say("The folder '%1' for samples cannot be made: %2. Make it writable, or free some "
                                  "space.",
                                  folder.string(), systemErrorText(error.value()))};
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
    const SampleKind* kind = kindOf(name);
    const SampleFile file = fileOf(kind == nullptr ? DomainClass::RegularLattice : kind->domain);
    request.size = file.size;
    const auto dataset = makeSample(request, progress.part(0, 0.05));
    if (!dataset)
        return dataset.error();
    // By way of a file, so that the model knows where it is from, and the dataset can be read again.
    const std::filesystem::path source = folder / (name + file.ending);
    if (const auto saved = saveDataset(host, *dataset, source, {}, progress.part(0.05, 0.1)); !saved)
        return saved.error();
    const auto read = openDataset(host, source, {}, progress.part(0.1, 0.15));
    if (!read)
        return read.error();
    const auto built = buildModel(host, *read, std::nullopt, {}, model, progress.part(0.15, 1));
    if (!built)
        return built.error();
    return model;
}

std::vector<SampleCard> sampleCards()
{
    const auto card = [](const char* name, const QString& title, const QString& description) {
        return SampleCard{name, title, QString(description).replace("%1", sampleSizeText(name))};
    };
    return {
        card("c60", SampleTexts::tr("Buckyball"),
             SampleTexts::tr("Electron density of a C60 molecule; regular grid, %1, computed by TAn. See the cage of "
                             "atoms as an isosurface, and how few tetrahedra are enough for an error of 1 %.")),
        card("hydrogen", SampleTexts::tr("Hydrogen atom"),
             SampleTexts::tr("Probability density of the 3d electron; regular grid, %1, computed by TAn. See the two "
                             "lobes and the ring, as a volume or as isosurfaces.")),
        card("blunt-body", SampleTexts::tr("Supersonic flow"),
             SampleTexts::tr("Density in front of a hemisphere; curvilinear grid, %1, computed by TAn. See the bow "
                             "shock, and how the grid follows the body.")),
        card("o-grid", SampleTexts::tr("Flow around a cylinder"),
             SampleTexts::tr("Pressure of the flow; curvilinear grid that closes on itself, %1, computed by TAn. See "
                             "the front, where the flow is stopped, and the sides, where it is fastest.")),
        card("bent-duct", SampleTexts::tr("Flow in a duct"),
             SampleTexts::tr("Speed in a bent duct; curvilinear grid, %1, computed by TAn. See how the flow keeps to "
                             "the outer wall of the bend.")),
        card("part", SampleTexts::tr("Plate with holes"),
             SampleTexts::tr("Stress in a plate with five holes and a closed cavity; irregular mesh, computed by TAn. "
                             "See how the boundary keeps its holes at every accuracy.")),
        card("scattered", SampleTexts::tr("Scattered points"),
             SampleTexts::tr("Waves that become finer outwards, sampled at random points in a ball; %1, computed by "
                             "TAn. See the volume: it needs no grid.")),
        card("marschner-lobb", SampleTexts::tr("Ripples"),
             SampleTexts::tr("The test signal of Marschner and Lobb; regular grid, %1, computed by TAn. See the fine "
                             "ripples, which vanish first as the error grows.")),
        card("stretched", SampleTexts::tr("Boundary layer"),
             SampleTexts::tr("A layer at a wall; rectilinear grid with growing spacing, %1, computed by TAn. See how "
                             "the tetrahedra crowd at the wall.")),
        card("noise", SampleTexts::tr("White noise"),
             SampleTexts::tr("Random values, the worst case for any method; regular grid, %1, computed by TAn. See the "
                             "statistics: even at a large error nearly all points are needed.")),
    };
}

Result<QImage> sampleThumbnail(PluginHost& host, const std::string& name, const std::filesystem::path& folder,
                               const Progress& progress)
{
    const SampleKind* kind = kindOf(name);
    if (kind == nullptr)
        return Error{ErrorKind::WrongUsage, Message::say("There is no sample called '%1'.", name)};
    const std::filesystem::path file = folder / "thumbnails" / TAN_VERSION / (name + ".png");
    if (QImage kept(pathText(file)); kept.width() == thumbnailWidth && kept.height() == thumbnailHeight)
        return kept;
    const auto drawn = drawThumbnail(host, *kind, progress);
    if (!drawn)
        return drawn.error();
    // Where it cannot be kept it is drawn again the next time.
    if (makeFolder(file.parent_path()))
        static_cast<void>(writePicture(*drawn, file, {.transparent = true}));
    return imageOf(*drawn);
}

} // namespace tetra
