// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/guarded.h"
#include "core/build/model_build.h"
#include "core/history/build_facts.h"
#include "core/history/prefix_copy.h"
#include "core/opening/file_state.h"
#include "core/opening/opening_folder.h"
#include "core/opening/served_model.h"
#include "core/packed/packed_file.h"
#include "core/remote/remote_file.h"

#include <tan/open.h>
#include <tan/packed.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <random>
#include <utility>

#include <unistd.h>

namespace tetra {

namespace {

using format::LevelEntry;

// What is shown on the way: a first mesh that is there at once, then always several times as large a one, as long as
// these take little beside the whole.
constexpr std::uint32_t sitesShownFirst = 4'000;
constexpr std::uint32_t growthShown = 4;
constexpr std::uint32_t sitesShownLast = 500'000;
/// Of a model that is left at its server so much is fetched, if a mesh that is as small is in its file ...
constexpr std::uint64_t beginningBytes = 1 << 20;
/// ... and no more than this.
constexpr std::uint64_t mostBeginningBytes = 64 << 20;
constexpr std::string_view leftThere = "tan+";

std::string_view placeAtServer(std::string_view place) noexcept
{
    return place.starts_with(leftThere) ? place.substr(leftThere.size()) : place;
}

/// Whether a file is a packed model, by its table.
Result<bool> holdsPacked(const ByteSource& source, const Progress& progress)
{
    constexpr std::uint64_t atOnce = 16 << 10;
    Buffer<std::byte> front(std::min(source.size, atOnce));
    if (const Status read = source.read(0, front, progress); !read)
        return read.error();
    return beginsLikeModel(front) && isFrontOfPacked(front);
}

/// Told of what goes wrong with a file.
using WhenFailing = std::function<void(const Error& error)>;

/// A model's file that is not simply mapped: how far it goes, and how its beginnings are made into models.
class ModelSource {
public:
    explicit ModelSource(WhenFailing whenFailing) : whenFailing_(std::move(whenFailing)) {}
    virtual ~ModelSource() = default;
    ModelSource(const ModelSource&) = delete;
    ModelSource& operator=(const ModelSource&) = delete;

    virtual ModelFacts facts() const = 0;
    /// Of the header and all that it covers: with the checksums in the table, what was read of the file is known.
    virtual std::uint64_t checksum() const = 0;
    /// Of the model of a level.
    virtual std::uint64_t expectedBytes(std::size_t level) const = 0;
    Result<UnpackReport> make(std::size_t level, const std::filesystem::path& output, const Progress& progress) const
    {
        auto made = makeNow(level, output, progress);
        if (!made)
            whenFailing_(made.error());
        return made;
    }

private:
    virtual Result<UnpackReport> makeNow(std::size_t level, const std::filesystem::path& output,
                                         const Progress& progress) const = 0;

    WhenFailing whenFailing_;
};

class ExplicitSource final : public ModelSource {
public:
    ExplicitSource(ByteSource source, std::string name, ModelFront front, WhenFailing whenFailing)
        : ModelSource(std::move(whenFailing)), source_(std::move(source)), name_(std::move(name)),
          front_(std::move(front))
    {
    }

    ModelFacts facts() const override;
    std::uint64_t checksum() const override { return front_.layout.header.checksum; }
    std::uint64_t expectedBytes(std::size_t level) const override { return bytesOf(endAt(level)); }

private:
    Result<UnpackReport> makeNow(std::size_t level, const std::filesystem::path& output,
                                 const Progress& progress) const override
    {
        const Status copied = copyPrefix(source_, name_, front_, endAt(level), output, progress);
        return copied ? Result<UnpackReport>(UnpackReport()) : copied.error();
    }
    PrefixEnd endAt(std::size_t level) const
    {
        const format::Header& header = front_.layout.header;
        if (level + 1 >= front_.levels.size())
            return {header.siteCount, header.tetrahedronCount, header.finalKey};
        const LevelEntry& entry = front_.levels[level];
        return {entry.sites, entry.created, entry.key};
    }
    std::uint64_t bytesOf(const PrefixEnd& end) const
    {
        std::uint64_t bytes = 0;
        for (const ByteRange& range : prefixRanges(front_, end))
            bytes += range.size;
        return bytes;
    }

    ByteSource source_;
    std::string name_;
    ModelFront front_;
};

ModelFacts ExplicitSource::facts() const
{
    const format::Header& header = front_.layout.header;
    const ModelDescription& about = front_.description;
    ModelFacts facts;
    facts.fileBytes = facts.unpackedBytes = header.fileBytes;
    facts.description = about;
    facts.sites = header.siteCount;
    facts.tetrahedra = header.tetrahedronCount;
    const double extent = about.range.extent(), diagonal = about.bounds.diagonal().norm();
    const auto percent = [](double part, double whole) { return whole > 0 ? 100 * part / whole : 0; };
    const bool byKey = buildFacts(about).claimsTwoSides; // the warping that is told apart is of one side only
    for (std::size_t level = 0; level < std::max<std::size_t>(front_.levels.size(), 1); ++level) {
        LevelEntry entry{.key = header.finalKey, .error = header.finalKey};
        if (level < front_.levels.size())
            entry = front_.levels[level];
        const auto key = static_cast<double>(entry.key);
        const bool isByKey = byKey || front_.levels.empty();
        const double error = isByKey ? key : static_cast<double>(entry.error);
        const double warping = !(about.warpingWeight > 0) ? 0
                               : isByKey                  ? key / about.warpingWeight
                                                          : static_cast<double>(entry.warping);
        const PrefixEnd end = endAt(level);
        facts.levels.push_back({percent(error, extent), percent(warping, diagonal), end.sites, bytesOf(end)});
    }
    return facts;
}

class PackedSource final : public ModelSource {
public:
    PackedSource(std::shared_ptr<const PackedModel> packed, WhenFailing whenFailing)
        : ModelSource(std::move(whenFailing)), packed_(std::move(packed))
    {
    }

    ModelFacts facts() const override
    {
        ModelFacts facts;
        facts.form = ModelForm::Packed;
        facts.fileBytes = packed_->fileSize();
        facts.unpackedBytes = packed_->unpackedBytes();
        facts.description = packed_->description();
        facts.sites = packed_->siteCount();
        facts.tetrahedra = packed_->tetrahedronCount();
        for (const PackedLevel& level : packed_->levels())
            facts.levels.push_back({level.error, level.warping, level.sites, level.bytes});
        // The last one stands for the whole, which may be finer than what is known of its levels.
        LevelInFile& whole = facts.levels.back();
        const double extent = facts.description.range.extent();
        const auto key = static_cast<double>(packed_->file().header().finalKey);
        whole.bytes = facts.fileBytes;
        whole.sites = facts.sites;
        whole.error = std::min(whole.error, extent > 0 ? 100 * key / extent : 0);
        return facts;
    }
    std::uint64_t checksum() const override { return packed_->file().header().checksum; }
    std::uint64_t expectedBytes(std::size_t level) const override
    {
        // As the whole has, site by site.
        const PackedLevel& last = packed_->levels().back();
        const double share = static_cast<double>(packed_->levels()[level].sites) / last.sites;
        constexpr double most = 0x1p62; // of what a damaged file says
        return static_cast<std::uint64_t>(std::min(share * static_cast<double>(packed_->unpackedBytes()), most));
    }

private:
    Result<UnpackReport> makeNow(std::size_t level, const std::filesystem::path& output,
                                 const Progress& progress) const override
    {
        const auto sayThatItIsAll = [&](double fraction, const Message& activity) {
            progress.report(fraction,
                            activity.empty() ? activity : Message::say("Unpacking the whole model: %1", activity));
        };
        if (level + 1 == packed_->levels().size())
            return unpackModel(*packed_, output, progress.withCallback(sayThatItIsAll));
        const Status unpacked = unpackPrefix(*packed_, level, output, progress);
        return unpacked ? Result<UnpackReport>(UnpackReport()) : unpacked.error();
    }

    std::shared_ptr<const PackedModel> packed_;
};

Result<std::unique_ptr<const ModelSource>> openSource(ByteSource source, const std::string& name,
                                                      const Progress& progress, const WhenFailing& whenFailing)
{
    const Result<bool> isPacked = holdsPacked(source, progress);
    if (!isPacked.ok())
        return isPacked.error();
    if (*isPacked) {
        auto packed = PackedModel::open(std::move(source), name, progress);
        if (!packed)
            return packed.error();
        return std::unique_ptr<const ModelSource>(std::make_unique<PackedSource>(*std::move(packed), whenFailing));
    }
    auto front = readFront(source, name, progress);
    if (!front)
        return front.error();
    return std::unique_ptr<const ModelSource>(
        std::make_unique<ExplicitSource>(std::move(source), name, *std::move(front), whenFailing));
}

Result<std::unique_ptr<const ModelSource>> sourceOf(ByteSource source, const std::string& name,
                                                    const Progress& progress, const WhenFailing& whenFailing)
{
    auto opened = openSource(std::move(source), name, progress, whenFailing);
    if (!opened)
        whenFailing(opened.error());
    return opened;
}

/// A model's file, with what its levels may be kept under.
struct FoundSource {
    std::unique_ptr<const ModelSource> source;
    /// Of this state of this file, and of no other; empty where nothing tells its states apart.
    std::string state;
    std::optional<FileState> onDisk; ///< of a file of this machine
};

/// A file on a server. What is there and does not fit its checksums is asked for again the next time.
Result<FoundSource> sourceAtServer(const std::string& address, const OpenOptions& options, const OpeningFolder& folder,
                                   const Progress& progress)
{
    const auto file = RemoteFile::open(address, folder.folder,
                                       {.token = options.token, .afresh = options.afresh || folder.own}, progress);
    if (!file)
        return file.error();
    const auto unread = std::make_shared<std::atomic<bool>>(false);
    const auto watched = [unread](auto function) {
        return [unread, function = std::move(function)](auto... arguments) {
            const Status status = function(arguments...);
            if (!status)
                *unread = true;
            return status;
        };
    };
    ByteSource source = file->source();
    source.read = watched(std::move(source.read));
    source.fetch = watched(std::move(source.fetch));
    const auto forget = [file = *file, own = folder.own, unread](const Error& error) {
        if (error.kind == ErrorKind::BadInput && !*unread)
            file.forget();
    };
    auto opened = sourceOf(std::move(source), shownAddress(address), progress, forget);
    if (!opened)
        return opened.error();
    return FoundSource{*std::move(opened), file->state(), {}};
}

/// A file of this machine. It is in one state all the time that it is opened, or in none that is known.
Result<FoundSource> sourceOnDisk(const std::string& place, const Progress& progress)
{
    std::optional<FileState> state = stateOf(place);
    auto file = fileSource(place);
    if (!file)
        return file.error();
    if (state != stateOf(place))
        state.reset();
    auto opened = sourceOf(*std::move(file), place, progress, [](const Error&) {});
    if (!opened)
        return opened.error();
    return FoundSource{*std::move(opened), state ? "file " + state->text : std::string(), state};
}

/// Tells of "ftp://host/x.tan" and "host:8080/x.tan" more than that there is no such file.
Status checkPlace(const std::string& place)
{
    std::error_code problem;
    const bool looksLikeAddress =
        std::string_view(place).substr(0, place.find('/')).find(':') != std::string_view::npos;
    if (isAddress(place) || !looksLikeAddress || std::filesystem::exists(place, problem))
        return {};
    return Error{ErrorKind::BadInput, Message::say("There is no file '%1'. An address on a server begins with http:// "
                                                   "or https://.",
                                                   printable(place))};
}

/// Of a file of this machine.
Result<bool> isPackedFile(const std::string& place, const Progress& progress)
{
    const auto file = fileSource(place);
    return file ? holdsPacked(*file, progress) : file.error();
}

/// With `folder` for what of a file on a server is fetched.
Result<FoundSource> sourceAt(const std::string& place, const OpenOptions& options,
                             const std::optional<OpeningFolder>& folder, const Progress& progress)
{
    if (!isAddress(place)) {
        const Status found = checkPlace(place);
        return found ? sourceOnDisk(place, progress) : found.error();
    }
    const auto own = folder ? Result<OpeningFolder>(*folder) : openingFolder(options);
    return own ? sourceAtServer(placeOf(place, false), options, *own, progress) : own.error();
}

std::size_t levelFor(const std::vector<LevelInFile>& levels, const std::optional<Accuracy>& asked,
                     std::uint64_t mostBytes)
{
    std::size_t level = levels.size() - 1;
    if (asked) {
        const auto keeps = [&](const LevelInFile& one) {
            return one.error <= asked->error && one.warping <= asked->warping;
        };
        level = std::min(level, static_cast<std::size_t>(std::ranges::find_if(levels, keeps) - levels.begin()));
    }
    while (level > 0 && levels[level].bytes > mostBytes)
        --level;
    return level;
}

/// Makes models of a source's levels in the cache, or finds them there.
class LevelCache {
public:
    LevelCache(FoundSource found, const OpenOptions& options, OpeningFolder folder, std::filesystem::path place)
        : source_(std::move(found.source)), facts_(source_->facts()), onDisk_(std::move(found.onDisk)),
          folder_(std::move(folder)), place_(std::move(place))
    {
        if (!options.afresh && !folder_.own && !found.state.empty())
            state_ = "model " + found.state + ' ' + std::to_string(source_->checksum());
    }

    const ModelFacts& facts() const noexcept { return facts_; }
    bool has(std::size_t level) const { return isKept() && folder_.folder.find(keyOf(level)).has_value(); }
    /// With `whole` as the beginning of a model that stays where it is.
    Result<FoundModel> take(std::size_t level, const Progress& progress,
                            const std::shared_ptr<const WholeElsewhere>& whole = {}) const;

private:
    bool isKept() const { return !state_.empty(); }
    bool isWhole(std::size_t level) const { return level + 1 == facts_.levels.size(); }
    std::string keyOf(std::size_t level) const
    {
        if (!isKept()) {
            std::random_device random;
            return "model of one opening " + std::to_string(random()) + ' ' + std::to_string(random());
        }
        return state_ + (isWhole(level) ? "" : " up to site " + std::to_string(facts_.levels[level].sites));
    }
    Status make(std::size_t level, const std::filesystem::path& path, const Progress& progress) const;

    std::unique_ptr<const ModelSource> source_;
    const ModelFacts facts_;
    std::optional<FileState> onDisk_;
    OpeningFolder folder_;
    const std::filesystem::path place_;
    std::string state_; ///< what levels are kept under; empty if they are kept for nobody
};

/// What is kept under a state of the file is read when a change would have given it another one.
Status LevelCache::make(std::size_t level, const std::filesystem::path& path, const Progress& progress) const
{
    if (isKept() && onDisk_)
        if (const Status settled = waitUntilSettled(*onDisk_, progress); !settled)
            return settled;
    const auto made = source_->make(level, path, progress);
    return made ? Status() : made.error();
}

Result<FoundModel> LevelCache::take(std::size_t level, const Progress& progress,
                                    const std::shared_ptr<const WholeElsewhere>& whole) const
{
    struct Held {
        ~Held()
        {
            std::error_code ignored;
            if (!model->checkIntact()) // what a disk damaged is made again the next time
                std::filesystem::remove(file.path(), ignored);
        }
        CachedFile file;
        std::shared_ptr<const Model> model;
    };
    const auto makeLevel = [&](const std::filesystem::path& path, const Progress& making) {
        return make(level, path, making);
    };
    for (bool isRetry = false;; isRetry = true) {
        auto file = folder_.folder.take(keyOf(level), source_->expectedBytes(level), makeLevel, progress);
        if (!file)
            return file.error();
        auto model = Model::open(file->path(), place_, whole);
        if (!model && !isRetry) { // somebody damaged it
            std::error_code ignored;
            std::filesystem::remove(file->path(), ignored);
            continue;
        }
        if (!isKept()) // the open file stays
            ::unlink(file->path().c_str());
        if (!model)
            return model.error();
        const auto held = std::make_shared<const Held>(*std::move(file), *std::move(model));
        return FoundModel{.model = {held, held->model.get()},
                          .isWhole = whole || isWhole(level),
                          .sitesOfWhole = facts_.sites,
                          .readBytes = facts_.levels[level].bytes,
                          .fileBytes = facts_.fileBytes};
    }
}

/// The levels that are shown before one.
std::vector<std::size_t> levelsShown(const std::vector<LevelInFile>& levels, std::size_t target)
{
    std::vector<std::size_t> shown;
    for (std::size_t level = 0; level < target && levels[level].sites <= sitesShownLast; ++level) {
        const bool isNextTooLarge = level + 1 >= target || levels[level + 1].sites > sitesShownFirst;
        if (shown.empty() ? isNextTooLarge : levels[level].sites / growthShown >= levels[shown.back()].sites)
            shown.push_back(level);
    }
    return shown;
}

Result<LevelCache> levelsAt(const std::string& place, const OpenOptions& options, const Progress& progress)
{
    auto folder = openingFolder(options);
    if (!folder)
        return folder.error();
    auto source = sourceAt(place, options, *folder, progress);
    if (!source)
        return source.error();
    return LevelCache(*std::move(source), options, *std::move(folder), place);
}

Result<FoundModel> openFrom(const std::string& place, const OpenOptions& options, const Progress& progress)
{
    constexpr double frontEnd = 0.02, shownEnd = 0.3;
    const auto found = levelsAt(place, options, progress.part(0, frontEnd));
    if (!found)
        return found.error();
    const LevelCache& levels = *found;
    const std::size_t target = levelFor(levels.facts().levels, options.accuracy, options.mostBytes);
    double done = frontEnd;
    if (options.grown && !levels.has(target)) {
        const std::vector<std::size_t> shown = levelsShown(levels.facts().levels, target);
        for (const std::size_t level : shown) {
            const double end = done + (shownEnd - frontEnd) / static_cast<double>(shown.size());
            const auto model = levels.take(level, progress.part(std::exchange(done, end), end));
            if (!model)
                return model.error();
            options.grown(*model);
        }
    }
    return levels.take(target, progress.part(done, 1));
}

/// Of a model that is left at its server.
Result<FoundModel> openLeft(const std::string& place, const OpenOptions& options, const Progress& progress)
{
    constexpr double askedAt = 0.3, frontEnd = 0.5;
    const auto whole = ServedModel::ask(placeOf(place, false), options.token, progress.part(0, askedAt));
    if (!whole)
        return whole.error();
    const auto found = levelsAt(place, options, progress.part(askedAt, frontEnd));
    if (!found)
        return found.error();
    const LevelCache& levels = *found;
    const ModelFacts& facts = levels.facts();
    std::size_t first = levelFor(facts.levels, {}, beginningBytes);
    // A packed file's beginning of so many bytes would take long to unpack, or be all of it.
    const double bytesOfSite = double(facts.unpackedBytes) / std::max(facts.sites, 1U);
    while (facts.form == ModelForm::Packed && first > 0 &&
           double(facts.levels[first].sites) * bytesOfSite > double(beginningBytes))
        --first;
    if (facts.levels[first].bytes > mostBeginningBytes)
        return Error{
            ErrorKind::BadInput,
            Message::say(
                "The file of '%1' was made by a version of TAn that did not record where its coarse meshes end, so it "
                "cannot be left at the server. Build it again, or copy it there with 'tan pack' and 'tan unpack'.",
                shownAddress(place))};
    return levels.take(first, progress.part(frontEnd, 1), *whole);
}

/// Where the cache has not room on its disk, or breaks down meanwhile, without it: what is wrong there is told only if
/// that does not help.
Result<FoundModel> openAnywhere(const std::string& place, const OpenOptions& options, const Progress& progress)
{
    const auto open = [&](const OpenOptions& chosen, const Progress& opening) {
        return isLeftAtServer(place) ? openLeft(place, chosen, opening) : openFrom(place, chosen, opening);
    };
    auto found = open(options, progress);
    if (found || found.error().kind != ErrorKind::CannotWrite)
        return found;
    const auto own = folderOfItsOwn(options);
    if (!own)
        return found;
    OpenOptions elsewhere = options;
    elsewhere.cacheFolder = own->folder.path();
    elsewhere.cacheBytes = own->folder.limit();
    elsewhere.afresh = true;
    auto again = open(elsewhere, progress.part(1, 1));
    return again || again.error().kind != ErrorKind::CannotWrite ? again : found;
}

/// Of a file on this disk the beginning to a batch.
Status cutOnDisk(const std::string& place, const Accuracy& accuracy, const std::filesystem::path& output,
                 const Progress& progress)
{
    const auto model = Model::open(place);
    if (!model)
        return model.error();
    const PrefixEnd end = prefixFor(**model, accuracy);
    if (const Status intact = (*model)->checkIntact(); !intact)
        return intact;
    const auto file = fileSource(place);
    if (!file)
        return file.error();
    const auto front = readFront(*file, place, progress);
    return front ? copyPrefix(*file, place, *front, end, output, progress) : front.error();
}

Result<UnpackReport> copyFrom(const std::string& place, const std::optional<Accuracy>& accuracy,
                              const std::filesystem::path& output, std::uint32_t& sitesOfWhole,
                              const Progress& progress, const std::string& token)
{
    constexpr double frontEnd = 0.02;
    const auto found = sourceAt(place, {.token = token}, {}, progress.part(0, frontEnd));
    if (!found)
        return found.error();
    const ModelSource& source = *found->source;
    const ModelFacts facts = source.facts();
    sitesOfWhole = facts.sites;
    const Progress copying = progress.part(frontEnd, 1);
    if (accuracy && facts.form == ModelForm::Explicit && !isAddress(place)) {
        const Status cut = cutOnDisk(place, *accuracy, output, copying);
        return cut ? Result<UnpackReport>(UnpackReport()) : cut.error();
    }
    return source.make(levelFor(facts.levels, accuracy, ~std::uint64_t(0)), output, copying);
}

} // namespace

bool isAddress(std::string_view place) noexcept
{
    return isRemoteAddress(placeAtServer(place));
}

bool isLeftAtServer(std::string_view place) noexcept
{
    return place.starts_with(leftThere) && isAddress(place);
}

std::string placeOf(std::string_view place, bool leftAtServer)
{
    return (leftAtServer && isAddress(place) ? std::string(leftThere) : std::string()) +
           std::string(isAddress(place) ? placeAtServer(place) : place);
}

Result<ModelFacts> modelFacts(const std::string& place, const Progress& progress, const std::string& token)
{
    const auto read = [&]() -> Result<ModelFacts> {
        const auto found = sourceAt(place, {.token = token}, {}, progress);
        return found ? Result<ModelFacts>(found->source->facts()) : found.error();
    };
    return guarded(Message::marked("Not enough memory to read '%1'. Close other programs."), read, place);
}

Result<FoundModel> openModel(const std::string& place, const OpenOptions& options, const Progress& progress)
{
    if (const Status found = checkPlace(place); !found)
        return found.error();
    const auto open = [&]() -> Result<FoundModel> {
        const Result<bool> packed = isAddress(place) ? Result<bool>(true) : isPackedFile(place, progress);
        if (!packed.ok() && packed.error().kind == ErrorKind::OutOfResource)
            return packed.error();
        if (packed.ok() && *packed)
            return openAnywhere(place, options, progress);
        const auto model = Model::open(place); // which says best what else is wrong with the file
        if (!model)
            return model.error();
        return FoundModel{*model, true, (*model)->siteCount(), (*model)->fileSize(), (*model)->fileSize()};
    };
    return guarded(Message::marked("Not enough memory to open '%1'. Close other programs."), open, place);
}

Result<CopyReport> copyModel(const std::string& place, const std::optional<Accuracy>& accuracy,
                             const std::filesystem::path& output, const Progress& progress, const std::string& token)
{
    if (const Status safe = checkModelOutput(output); !safe)
        return safe.error();
    CopyReport report;
    const auto copied = guarded(
        Message::marked("Not enough memory to read '%1'. Close other programs."),
        [&] { return copyFrom(place, accuracy, output, report.sitesOfWhole, progress, token); }, place);
    if (!copied)
        return copied.error();
    const auto model = Model::open(output);
    if (!model)
        return model.error();
    report.sites = (*model)->siteCount();
    report.tetrahedra = (*model)->tetrahedronCount();
    report.fileBytes = (*model)->fileSize();
    report.derived = copied->derived;
    return report;
}

} // namespace tetra
