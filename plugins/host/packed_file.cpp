// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/packed_file.h"

#include "core/base/system_error.h"
#include "core/base/work_folder.h"
#include "plugins/host/input_file.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace tetra {
namespace {

namespace fs = std::filesystem;

Error cannotUnpack(const fs::path& path, ErrorKind kind, const Message& reason)
{
    return {kind, Message::say("Cannot read '%1': %2", path.string(), reason), path};
}

Error damagedGzip(const fs::path& path)
{
    return cannotUnpack(
        path, ErrorKind::BadInput,
        Message::say(
            "it is compressed with gzip, and damaged or cut short. The copy may be incomplete: copy the file again."));
}

/// zlib's own reader of such files, which joins several that stand behind one another, and compares their checksums.
class GzipFile {
public:
    static Result<GzipFile> open(const fs::path& path)
    {
        if (const auto regular = MappedFile::open(path); !regular) // says why not
            return regular.error();
        const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
        const int problem = descriptor < 0 ? errno : ENOMEM; // all that zlib can lack
        if (descriptor >= 0)
            if (gzFile file = gzdopen(descriptor, "rb"); file != nullptr) {
                constexpr unsigned buffer = 1 << 18;
                gzbuffer(file, buffer);
                return GzipFile(path, file);
            }
        if (descriptor >= 0)
            ::close(descriptor);
        const Message reason = systemErrorText(problem);
        if (isLackOfResources(problem))
            return cannotUnpack(path, ErrorKind::OutOfResource, Message::say("%1. %2", reason, resourceRemedy));
        return cannotUnpack(path, ErrorKind::BadInput, Message::say("%1.", reason));
    }

    /// How many bytes came, less than the room there is only at the end.
    Result<std::size_t> read(std::span<std::byte> room)
    {
        const int count = gzread(file_.get(), room.data(), static_cast<unsigned>(room.size()));
        int problem = Z_OK;
        gzerror(file_.get(), &problem);
        // A file that ends too early is only told by the state.
        if (count < 0 || (static_cast<std::size_t>(count) < room.size() && problem != Z_OK && problem != Z_STREAM_END))
            return problem == Z_MEM_ERROR ? cannotUnpack(path_, ErrorKind::OutOfResource,
                                                         Message::say("there is not enough memory to unpack it."))
                                          : damagedGzip(path_);
        return static_cast<std::size_t>(count);
    }

    std::uint64_t packedPlace() const
    {
        return static_cast<std::uint64_t>(std::max<z_off_t>(0, gzoffset(file_.get())));
    }

private:
    GzipFile(fs::path path, gzFile file) : path_(std::move(path)), file_(file, gzclose_r) {}

    fs::path path_;
    std::unique_ptr<gzFile_s, decltype(&gzclose_r)> file_;
};

/// Writes all of it; the error is the system's, 0 if there is none.
int writeBytes(int descriptor, std::span<const std::byte> bytes)
{
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR)
            return errno;
        bytes = bytes.subspan(static_cast<std::size_t>(std::max<ssize_t>(0, written)));
    }
    return 0;
}

Error noRoom(const fs::path& path, const fs::path& folder, int systemError)
{
    return cannotUnpack(path, isLackOfResources(systemError) ? ErrorKind::OutOfResource : ErrorKind::CannotWrite,
                        Message::say("it is compressed with gzip, and cannot be unpacked into '%1': %2. Free some "
                                     "space there, set TMPDIR to a folder with more, or unpack it yourself (gunzip).",
                                     folder.string(), systemErrorText(systemError)));
}

} // namespace

bool isPackedByGzip(std::span<const std::byte> firstBytes) noexcept
{
    return firstBytes.size() > 2 && firstBytes[0] == std::byte(0x1f) && firstBytes[1] == std::byte(0x8b);
}

std::string unpackingProgram(std::span<const std::byte> firstBytes)
{
    using namespace std::string_view_literals;
    const std::string_view bytes(reinterpret_cast<const char*>(firstBytes.data()), firstBytes.size());
    constexpr std::array<std::pair<std::string_view, const char*>, 6> kinds = {{{"BZh"sv, "bunzip2"},
                                                                                {"\xfd"
                                                                                 "7zXZ"sv,
                                                                                 "unxz"},
                                                                                {"\x28\xb5\x2f\xfd"sv, "unzstd"},
                                                                                {"PK\x03\x04"sv, "unzip"},
                                                                                {"7z\xbc\xaf\x27\x1c"sv, "7z x"},
                                                                                {"\x1f\x9d"sv, "uncompress"}}};
    for (const auto& [start, program] : kinds)
        if (bytes.starts_with(start))
            return program;
    constexpr std::size_t tarMark = 257;
    return bytes.size() > tarMark && bytes.substr(tarMark).starts_with("ustar") ? "tar -xf" : "";
}

fs::path unpackedName(const fs::path& path)
{
    std::string ending = path.extension().string();
    std::ranges::transform(ending, ending.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    fs::path name = path;
    return ending == ".gz" || ending == ".gzip" ? name.replace_extension() : name;
}

Result<Buffer<std::byte>> firstUnpackedBytes(const fs::path& path)
{
    auto file = GzipFile::open(path);
    if (!file)
        return file.error();
    Buffer<std::byte> bytes(shownToReaders);
    const auto count = file->read(bytes);
    if (!count)
        return count.error();
    bytes.resize(*count);
    return bytes;
}

Result<UnpackedFiles> UnpackedFiles::make(const fs::path& path)
{
    std::error_code problem;
    const fs::path temporary = fs::temp_directory_path(problem);
    if (problem)
        return noRoom(path, "TMPDIR", problem.value());
    constexpr const char* start = "tan-unpacked-";
    WorkFolder::removeLeft(temporary, start);
    std::string name = (temporary / start).string() + "XXXXXX";
    if (::mkdtemp(name.data()) == nullptr)
        return noRoom(path, temporary, errno);
    auto folder = WorkFolder::open(name, WorkFolder::Leftovers::Remove);
    if (!folder) {
        ::rmdir(name.c_str());
        return cannotUnpack(path, folder.error().kind, folder.error().message);
    }
    UnpackedFiles files;
    files.path_ = folder->path();
    files.folder_ = std::make_shared<WorkFolder>(*std::move(folder));
    return files;
}

Result<fs::path> UnpackedFiles::unpack(const fs::path& packed, const fs::path& name, const Progress& progress) const
{
    constexpr std::size_t step = 1 << 20;
    auto file = GzipFile::open(packed);
    if (!file)
        return file.error();
    const fs::path temporary = path_.parent_path();
    const fs::path unpacked = path_ / name;
    const int target = ::open(unpacked.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, S_IRUSR | S_IWUSR);
    if (target < 0)
        return noRoom(packed, temporary, errno);
    const std::shared_ptr<const void> closing(nullptr, [target](const void*) { ::close(target); });

    std::error_code problem;
    const auto space = fs::space(temporary, problem);
    const std::uint64_t room = problem ? ~std::uint64_t(0) : space.available / 2;
    const std::uint64_t packedBytes = std::max<std::uint64_t>(1, fs::file_size(packed, problem));
    Buffer<std::byte> bytes(step);
    for (std::uint64_t written = 0;;) {
        if (progress.cancelled())
            return cancelledError(Message::marked("Unpacking"));
        const auto count = file->read(bytes);
        if (!count)
            return count.error();
        if (const int failure = writeBytes(target, std::span(bytes).first(*count)); failure != 0)
            return noRoom(packed, temporary, failure);
        written += *count;
        if (written > room)
            return cannotUnpack(
                packed, ErrorKind::OutOfResource,
                Message::say("it is compressed with gzip, and unpacks to more than %1, half of the space in '%2'. Free "
                             "some space there, set TMPDIR to a folder with more, or unpack it yourself (gunzip).",
                             neededBytesText(room), temporary.string()));
        if (*count < bytes.size())
            return unpacked;
        progress.report(std::min(1., double(file->packedPlace()) / double(packedBytes)), Message::marked("Unpacking"));
    }
}

Result<fs::path> UnpackedFiles::link(const fs::path& file, const fs::path& name) const
{
    std::error_code problem;
    const fs::path link = path_ / name;
    const fs::path target = fs::absolute(file, problem);
    if (!problem)
        fs::create_symlink(target, link, problem);
    return problem ? Result<fs::path>(noRoom(file, path_.parent_path(), problem.value())) : link;
}

} // namespace tetra
