// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/plugin_guards.h"

#include "core/base/checksum.h"
#include "plugins/api/scene_parameters.h"
#include "plugins/host/plugin_call.h"

#include <algorithm>
#include <set>

namespace tetra {
namespace {

/// What the guards have in common.
class Guard {
public:
    explicit Guard(GuardTarget target) : target_(std::move(target)) {}

    const std::string& id() const noexcept { return target_.id; }
    template <class Work> auto call(Work&& work) const { return callPlugin(target_.id, std::forward<Work>(work)); }
    template <class Work> auto call(const Error& outOfMemory, Work&& work) const
    {
        return callPlugin(target_.id, std::forward<Work>(work), outOfMemory);
    }
    template <class Value, class Work> Value callOr(Value fallback, Work&& work) const
    {
        return callPluginOr(std::move(fallback), target_.id, target_.tell, std::forward<Work>(work));
    }

    /// Parameters, whose checks of texts are the plugin's code, too.
    template <class Work> std::vector<Parameter> parameters(Work&& work) const
    {
        auto all = callOr(std::vector<Parameter>(), std::forward<Work>(work));
        for (Parameter& parameter : all)
            if (parameter.mistake)
                parameter.mistake = [target = target_, mistake = parameter.mistake](const std::string& text) {
                    return callPluginOr(Message(), target.id, target.tell, [&] { return mistake(text); });
                };
        return all;
    }

private:
    GuardTarget target_;
};

class GuardedBuilder : public Builder {
public:
    GuardedBuilder(const Builder& plugin, GuardTarget target) : plugin_(plugin), guard_(std::move(target)) {}

    Acceptance accepts(const Dataset& dataset) const override
    {
        auto acceptance = guard_.call([&]() -> Result<Acceptance> { return plugin_.accepts(dataset); });
        return acceptance ? *acceptance : Acceptance{0, acceptance.error().message};
    }
    std::vector<Parameter> parameters() const override
    {
        return guard_.parameters([&] { return plugin_.parameters(); });
    }
    ParameterValues detail(double percent, DomainClass domain) const override
    {
        return guard_.callOr(ParameterValues(), [&] { return plugin_.detail(percent, domain); });
    }
    BuildAbilities abilities(const Dataset& dataset, const ParameterValues& values) const override
    {
        return guard_.callOr(BuildAbilities(), [&] { return plugin_.abilities(dataset, values); });
    }
    std::optional<BuildEstimate> estimate(const BuildSize& size, const ParameterValues& values,
                                          unsigned threads) const override
    {
        return guard_.callOr(std::optional<BuildEstimate>(), [&] { return plugin_.estimate(size, values, threads); });
    }
    Result<Dataset> taken(const Dataset& dataset, const ParameterValues& values,
                          const Progress& progress) const override
    {
        return guard_.call([&] { return plugin_.taken(dataset, values, progress); });
    }
    Result<BuildReport> build(const Dataset& dataset, const ParameterValues& values, BuildTarget& target,
                              const Progress& progress) const override
    {
        return guard_.call([&] { return plugin_.build(dataset, values, target, progress); });
    }
    ParameterValues settled(const Dataset& dataset, const ParameterValues& values) const override
    {
        return guard_.callOr(values, [&] { return plugin_.settled(dataset, values); });
    }

private:
    const Builder& plugin_;
    Guard guard_;
};

/// A reader says what is wrong in a file, and of which file it is said here; unless it speaks of another one itself.
Error inFile(const std::filesystem::path& path, const Error& error)
{
    if (error.kind == ErrorKind::Cancelled || !error.file.empty())
        return error;
    return {error.kind, Message::say("Cannot read '%1': %2", path.string(), error.message), path};
}

Error tooLittleMemoryToRead(const std::filesystem::path& path)
{
    return {ErrorKind::OutOfResource,
            Message::say("Not enough memory to read '%1'. Close other programs.", path.string()), path};
}

/// contentHash(), which may take long for a lattice.
Result<std::uint64_t> hashOf(const Dataset& dataset, const Progress& progress)
{
    constexpr std::size_t pieceBytes = std::size_t(16) << 20;
    if (dataset.positions || dataset.tetrahedra)
        return contentHash(dataset.values, dataset.positions, dataset.tetrahedra);
    const std::span<const std::byte> bytes = dataset.values.bytes();
    Checksum sum;
    for (std::size_t done = 0; done < bytes.size(); done += pieceBytes) {
        if (progress.cancelled())
            return cancelledError(Message::marked("Reading"));
        sum.add(bytes.subspan(done, std::min(pieceBytes, bytes.size() - done)));
        progress.report(static_cast<double>(done) / static_cast<double>(bytes.size()), Message::marked("Reading"));
    }
    return sum.value();
}

class GuardedReader : public Reader {
public:
    GuardedReader(const Reader& plugin, GuardTarget target) : plugin_(plugin), guard_(std::move(target)) {}

    std::vector<std::string> nameFilters() const override
    {
        return guard_.callOr(std::vector<std::string>(), [&] { return plugin_.nameFilters(); });
    }
    double score(const std::filesystem::path& path, std::span<const std::byte> firstBytes) const override
    {
        return guard_.callOr(0.0, [&] { return plugin_.score(path, firstBytes); });
    }
    std::vector<Parameter> parameters() const override
    {
        return guard_.parameters([&] { return plugin_.parameters(); });
    }
    Result<Dataset> read(const std::filesystem::path& path, const ParameterValues& values,
                         const Progress& progress) const override
    {
        return finished(path, progress, [&](const Progress& part) { return plugin_.read(path, values, part); });
    }
    Result<Dataset> readAround(const Eigen::AlignedBox3d& region, const std::filesystem::path& path,
                               const ParameterValues& values, const Progress& progress) const override
    {
        return finished(path, progress,
                        [&](const Progress& part) { return plugin_.readAround(region, path, values, part); });
    }
    std::vector<std::filesystem::path> companions(const std::filesystem::path& path,
                                                  const ParameterValues& values) const override
    {
        return guard_.callOr(std::vector<std::filesystem::path>(), [&] { return plugin_.companions(path, values); });
    }
    Result<FileContents> probe(const std::filesystem::path& path, const ParameterValues& values,
                               const Progress& progress) const override
    {
        const auto contents =
            guard_.call(tooLittleMemoryToRead(path), [&] { return plugin_.probe(path, values, progress); });
        return contents ? contents : inFile(path, contents.error());
    }

private:
    /// What is read, with what a reader may leave out.
    template <class Read>
    Result<Dataset> finished(const std::filesystem::path& path, const Progress& progress, const Read& read) const
    {
        constexpr double readEnd = 0.9; // what is left is for the hash
        return guard_.call(tooLittleMemoryToRead(path), [&]() -> Result<Dataset> {
            auto dataset = read(progress.part(0, readEnd));
            if (!dataset)
                return inFile(path, dataset.error());
            Source& source = dataset->source;
            if (source.name.empty())
                source.name = path.filename().string();
            if (source.path.empty())
                source.path = path;
            source.valueName = printable(source.valueName); // it goes into other files
            std::ranges::sort(source.taken, {}, &Taken::part);
            if (source.hash == 0) {
                const auto hash = hashOf(*dataset, progress.part(readEnd, 1));
                if (!hash)
                    return hash.error();
                source.hash = *hash;
            }
            if (const Status intact = dataset->checkIntact(); !intact)
                return intact.error();
            progress.report(1, Message::marked("Reading"));
            return dataset;
        });
    }

    const Reader& plugin_;
    Guard guard_;
};

class GuardedWriter : public Writer {
public:
    GuardedWriter(const Writer& plugin, GuardTarget target) : plugin_(plugin), guard_(std::move(target)) {}

    std::vector<FileFormat> formats() const override
    {
        return guard_.callOr(std::vector<FileFormat>(), [&] { return plugin_.formats(); });
    }
    std::vector<Parameter> parameters() const override
    {
        return guard_.parameters([&] { return plugin_.parameters(); });
    }
    Status writeDataset(const Dataset& dataset, OutputFile& file, const ParameterValues& values) const override
    {
        return guard_.call(tooLittleMemory(file), [&] { return plugin_.writeDataset(dataset, file, values); });
    }
    Status writeMesh(const MeshContent& mesh, OutputFile& file, const ParameterValues& values) const override
    {
        return guard_.call(tooLittleMemory(file), [&] { return plugin_.writeMesh(mesh, file, values); });
    }
    Status writeSurface(const SurfaceContent& surface, OutputFile& file, const ParameterValues& values) const override
    {
        return guard_.call(tooLittleMemory(file), [&] { return plugin_.writeSurface(surface, file, values); });
    }

private:
    static Error tooLittleMemory(const OutputFile& file)
    {
        return {ErrorKind::OutOfResource,
                Message::say("Not enough memory to write '%1'. Close other programs.", file.target().string())};
    }

    const Writer& plugin_;
    Guard guard_;
};

bool hasType(const Parameter& parameter, const ParameterValues& values)
{
    const auto found = values.find(parameter.id);
    return found != values.end() && haveOneType(found->second, parameter.defaultValue);
}

Status checkChoice(const Parameter& parameter, const ParameterValue& value)
{
    const auto* text = std::get_if<std::string>(&value);
    if (text == nullptr || parameter.choices.empty() || std::ranges::count(parameter.choices, *text) > 0)
        return {};
    std::string choices;
    for (const std::string& choice : parameter.choices)
        choices += (choices.empty() ? "" : ", ") + choice;
    return Error{ErrorKind::WrongUsage,
                 Message::say("'%1' is not a choice for '%2'. Available: %3.", *text, parameter.id, choices)};
}

Status checkScene(const std::string& id, const Scene* scene)
{
    const auto mistake = [&](const Message& what) {
        return Error{
            ErrorKind::BadInput,
            Message::say(
                "The plugin '%1' made a scene that cannot be shown: %2 This is a fault of the plugin; tell its author.",
                id, what)};
    };
    if (scene == nullptr)
        return mistake(Message::say("there is none."));
    std::set<std::string> ids;
    for (const Drawable& drawable : scene->drawables) {
        if (drawable.id.empty())
            return mistake(Message::say("a drawable has no name."));
        if (!ids.insert(drawable.id).second)
            return mistake(Message::say("two drawables are called '%1'.", drawable.id));
    }
    return {};
}

/// Values that are missing or of another type are the defaults for the mesh.
class GuardedSession : public RendererSession {
public:
    GuardedSession(const Renderer& plugin, const RendererMeshes& meshes, Guard guard)
        : plugin_(plugin), meshes_(meshes), guard_(std::move(guard))
    {
    }

    Result<std::shared_ptr<const Scene>> prepare(const RendererView& view, const Progress& progress) override
    {
        using Scenes = Result<std::shared_ptr<const Scene>>;
        return guard_.call([&]() -> Scenes {
            RendererView whole = view;
            if (Status complete = completeValues(whole.values); !complete)
                return complete.error();
            if (!session_)
                session_ = plugin_.open(meshes_);
            if (!session_)
                return checkScene(guard_.id(), nullptr).error();
            Scenes scene = session_->prepare(whole, progress);
            if (!scene)
                return scene;
            if (Status good = checkScene(guard_.id(), scene->get()); !good)
                return good.error();
            return signedScene(*scene);
        });
    }

private:
    Status completeValues(ParameterValues& values)
    {
        if (!parameters_)
            parameters_ = plugin_.parameters(extentOf(*meshes_.mesh, meshes_.bounds));
        for (const Parameter& parameter : *parameters_) {
            if (!hasType(parameter, values))
                values[parameter.id] = parameter.defaultValue;
            if (Status good = checkChoice(parameter, values[parameter.id]); !good)
                return good;
        }
        return {};
    }

    const Renderer& plugin_;
    RendererMeshes meshes_;
    Guard guard_;
    /// Says whose it is. The same object again for the same scene, as far as the plugin gives one out again.
    std::shared_ptr<const Scene> signedScene(const std::shared_ptr<const Scene>& scene)
    {
        if (scene != given_) {
            auto copy = std::make_shared<Scene>(*scene); // shares its meshes
            copy->maker = guard_.id();
            given_ = scene;
            signed_ = std::move(copy);
        }
        return signed_;
    }

    std::optional<std::vector<Parameter>> parameters_; ///< for the mesh
    std::shared_ptr<const Scene> given_;               ///< by the plugin at last
    std::shared_ptr<const Scene> signed_;              ///< what became of it
    std::unique_ptr<RendererSession> session_;         ///< of the plugin, once there is something to do
};

class GuardedRenderer : public Renderer {
public:
    GuardedRenderer(const Renderer& plugin, GuardTarget target) : plugin_(plugin), guard_(std::move(target)) {}

    std::vector<Parameter> parameters(const FieldExtent& field) const override
    {
        return guard_.parameters([&] { return plugin_.parameters(field); });
    }
    RendererNeeds needs() const override
    {
        return guard_.callOr(RendererNeeds(), [&] { return plugin_.needs(); });
    }
    std::unique_ptr<RendererSession> open(const RendererMeshes& meshes) const override
    {
        return std::make_unique<GuardedSession>(plugin_, meshes, guard_);
    }

private:
    const Renderer& plugin_;
    Guard guard_;
};

} // namespace

std::unique_ptr<const Builder> guarded(const Builder& plugin, GuardTarget target)
{
    return std::make_unique<GuardedBuilder>(plugin, std::move(target));
}

std::unique_ptr<const Reader> guarded(const Reader& plugin, GuardTarget target)
{
    return std::make_unique<GuardedReader>(plugin, std::move(target));
}

std::unique_ptr<const Writer> guarded(const Writer& plugin, GuardTarget target)
{
    return std::make_unique<GuardedWriter>(plugin, std::move(target));
}

std::unique_ptr<const Renderer> guarded(const Renderer& plugin, GuardTarget target)
{
    return std::make_unique<GuardedRenderer>(plugin, std::move(target));
}

} // namespace tetra
