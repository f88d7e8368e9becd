// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/plugin_file.h"

#include "plugins/api/plugin_note.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include <link.h>

namespace tetra {
namespace {

/// Those of all libraries together; a linker writes less than a hundred bytes.
constexpr std::size_t mostBytesOfNotes = 1 << 20;

/// Of the note that plugins of Qt have; those for earlier versions of TAn are such.
constexpr std::string_view ownerOfQtNotes{"qt-project!\0", 12};

Error notTaken(Message text)
{
    return {ErrorKind::BadInput, std::move(text)};
}

Error noPlugin(const Message& why)
{
    return notTaken(Message::say("It is not a plugin, or is damaged: %1 Install it again, or remove the file.", why));
}

/// A part of the file, if all of it is there.
std::optional<std::string_view> partOf(std::string_view file, std::uint64_t offset, std::uint64_t size)
{
    if (offset > file.size() || size > file.size() - offset)
        return std::nullopt;
    return file.substr(static_cast<std::size_t>(offset), static_cast<std::size_t>(size));
}

template <class Value> std::optional<Value> valueAt(std::string_view file, std::uint64_t offset)
{
    static_assert(std::is_trivially_copyable_v<Value>);
    const auto bytes = partOf(file, offset, sizeof(Value));
    if (!bytes)
        return std::nullopt;
    Value value;
    std::memcpy(&value, bytes->data(), sizeof(Value));
    return value;
}

using Head = ElfW(Ehdr);
using Segment = ElfW(Phdr);

/// That of a shared library of machines with pointers and an order of bytes as this one has.
std::optional<Head> headOf(std::string_view file)
{
    constexpr unsigned char bits = sizeof(void*) == 8 ? ELFCLASS64 : ELFCLASS32;
    constexpr unsigned char order = std::endian::native == std::endian::little ? ELFDATA2LSB : ELFDATA2MSB;
    const auto head = valueAt<Head>(file, 0);
    if (!head || !file.starts_with(std::string_view(ELFMAG, SELFMAG)) || head->e_ident[EI_CLASS] != bits ||
        head->e_ident[EI_DATA] != order || head->e_type != ET_DYN || head->e_phentsize != sizeof(Segment))
        return std::nullopt;
    return head;
}

/// What the file consists of; none if a part of it or of the list of sections, which comes last, is not in the file:
/// loading one that is cut short can end the program.
std::optional<std::vector<Segment>> segmentsOf(std::string_view file, const Head& head)
{
    std::vector<Segment> segments;
    for (std::uint64_t i = 0; i < head.e_phnum; ++i) {
        const auto segment = valueAt<Segment>(file, std::uint64_t(head.e_phoff) + i * sizeof(Segment));
        if (!segment)
            return std::nullopt;
        const bool hasBytes = segment->p_type == PT_LOAD || segment->p_type == PT_NOTE || segment->p_filesz > 0;
        if (segment->p_type != PT_NULL && hasBytes && !partOf(file, segment->p_offset, segment->p_filesz))
            return std::nullopt;
        segments.push_back(*segment);
    }
    if (!partOf(file, head.e_shoff, std::uint64_t(head.e_shnum) * head.e_shentsize))
        return std::nullopt;
    return segments;
}

bool isLoadedWith(const Segment& loaded, const Segment& table)
{
    const std::uint64_t within = table.p_vaddr - loaded.p_vaddr;
    return loaded.p_type == PT_LOAD && table.p_vaddr >= loaded.p_vaddr && within <= loaded.p_filesz &&
           table.p_filesz <= loaded.p_filesz - within && table.p_offset == loaded.p_offset + within;
}

/// Whether the table for the loader is all in what is loaded of the file: it is read in memory, up to its end mark.
/// Without any the loader refuses the library.
bool isDynamicTableWhole(std::string_view file, std::span<const Segment> segments)
{
    using Entry = ElfW(Dyn);
    const auto isTable = [](const Segment& segment) { return segment.p_type == PT_DYNAMIC; };
    const auto table = std::ranges::find_if(segments, isTable);
    if (table == segments.end())
        return true;
    if (std::ranges::count_if(segments, isTable) > 1 || table->p_vaddr % alignof(Entry) != 0 ||
        std::ranges::none_of(segments, [&](const Segment& loaded) { return isLoadedWith(loaded, *table); }))
        return false;
    for (std::uint64_t at = 0; at + sizeof(Entry) <= table->p_filesz; at += sizeof(Entry))
        if (const auto entry = valueAt<Entry>(file, table->p_offset + at); entry && entry->d_tag == DT_NULL)
            return true;
    return false;
}

/// The parts of the file with notes.
std::vector<std::string_view> notesOf(std::string_view file, std::span<const Segment> segments)
{
    std::vector<std::string_view> notes;
    std::size_t total = 0;
    for (const Segment& segment : segments) {
        if (segment.p_type != PT_NOTE || segment.p_filesz > mostBytesOfNotes - total)
            continue;
        total += segment.p_filesz;
        notes.push_back(*partOf(file, segment.p_offset, segment.p_filesz));
    }
    return notes;
}

/// The text of our note, of which `content` is what follows its mark.
Result<std::string> textOf(std::string_view content)
{
    const auto size = valueAt<std::uint32_t>(content, 0), sum = valueAt<std::uint32_t>(content, sizeof(std::uint32_t));
    const auto text = size && sum && *size <= mostNoteBytes ? partOf(content, 2 * sizeof(std::uint32_t), *size)
                                                            : std::optional<std::string_view>();
    if (!text || noteChecksum(*text) != *sum)
        return noPlugin(Message::say("its metadata are damaged."));
    return std::string(*text);
}

/// The word that ends where `marker` begins in `text`; empty without one.
std::string_view wordBefore(std::string_view text, std::string_view marker)
{
    const auto end = text.find(marker);
    if (end == std::string_view::npos)
        return {};
    const auto before = text.substr(0, end).find_last_of(" (");
    return text.substr(before + 1, end - before - 1); // npos + 1 is 0
}

std::string_view wordAfter(std::string_view text, std::string_view marker)
{
    const auto begin = text.find(marker);
    if (begin == std::string_view::npos)
        return {};
    const std::string_view rest = text.substr(begin + marker.size());
    return rest.substr(0, rest.find_first_of(" ,)"));
}

Message advice(std::string_view own, const Message& general)
{
    return own.empty() ? general : Message::of(std::string(own), {});
}

} // namespace

Message builtForEarlierTan()
{
    return Message::say("It was built for an earlier version of TAn. Install a later version of the plugin, or build "
                        "it again with the headers of this TAn.");
}

Result<std::string> pluginText(std::span<const std::byte> library)
{
    const std::string_view file(reinterpret_cast<const char*>(library.data()), library.size());
    const auto head = headOf(file);
    if (!head)
        return noPlugin(Message::say("it is not a shared library for this machine."));
    const auto segments = segmentsOf(file, *head);
    if (!segments)
        return noPlugin(Message::say("it ends too early."));
    if (!isDynamicTableWhole(file, *segments))
        return noPlugin(Message::say("its table for the loader is damaged."));
    const auto notes = notesOf(file, *segments);
    // Linkers differ in how they pad notes, so they are not gone through: they are searched for ours.
    for (const std::string_view note : notes)
        if (const auto mark = note.find(pluginNoteMark); mark != std::string_view::npos)
            return textOf(note.substr(mark + pluginNoteMark.size()));
    for (const std::string_view note : notes)
        if (note.find(ownerOfQtNotes) != std::string_view::npos)
            return notTaken(builtForEarlierTan());
    return noPlugin(Message::say("it has no metadata."));
}

Result<std::string> pluginText(const std::filesystem::path& library)
{
    const auto file = MappedFile::open(library);
    if (!file && file.error().kind == ErrorKind::OutOfResource)
        return file.error();
    return file ? pluginText((*file)->bytes()) : noPlugin(file.error().message);
}

Message explainLoadError(std::string_view systemText, std::string_view remedy)
{
    if (const std::string library(wordBefore(systemText, ": cannot open shared object file")); !library.empty())
        return Message::say("The library %1 is missing. %2", library,
                            advice(remedy, Message::say("Install the package that contains it (on Debian, '%1' names "
                                                        "it), or remove the plugin.",
                                                        "apt-file search " + library)));
    if (const std::string symbol(wordAfter(systemText, "undefined symbol: ")); !symbol.empty())
        return Message::say("It needs the function %1, which no library here provides: it was built for another "
                            "version of TAn or of a library. %2",
                            symbol,
                            advice(remedy, Message::say("Rebuild it, or install the version for this program.")));
    return Message::say("It could not be loaded: %1 %2", systemText,
                        advice(remedy, Message::say("Install it again, or remove it.")));
}

} // namespace tetra
