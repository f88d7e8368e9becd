// SPDX-License-Identifier: GPL-3.0-or-later
/// Libraries that are damaged, cut short or made to deceive: what they say of themselves is refused with a sentence,
/// and nothing of them is loaded.
#include "plugins/host/plugin_file.h"

#include "plugins/api/plugin_note.h"
#include "plugins/host/plugin_host.h"

#include <QTemporaryDir>
#include <QTest>

#include <cstring>
#include <fstream>
#include <random>
#include <tuple>

#include <dlfcn.h>
#include <link.h>

using namespace tetra;

namespace {

namespace fs = std::filesystem;

using Head = ElfW(Ehdr);
using Segment = ElfW(Phdr);

std::string contentOf(const fs::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

Result<std::string> textIn(std::string_view bytes)
{
    return pluginText(std::as_bytes(std::span(bytes)));
}

/// Why there is none; empty if there is one.
std::string refusalOf(std::string_view bytes)
{
    const auto text = textIn(bytes);
    return text ? "" : text.error().text();
}

constexpr std::string_view saying = "{\"interface\": \"org.tan.Reader/3\", \"metadata\": {\"id\": \"made\"}}";
constexpr PluginNote<saying.size()> ourNote(std::array{saying});

/// The smallest library with a note: a head, one segment and what lies in it.
struct SmallLibrary {
    Head head{};
    std::vector<Segment> segments{1};
    std::string notes{reinterpret_cast<const char*>(&ourNote), sizeof(ourNote)};

    SmallLibrary()
    {
        std::memcpy(head.e_ident, ELFMAG, SELFMAG);
        head.e_ident[EI_CLASS] = sizeof(void*) == 8 ? ELFCLASS64 : ELFCLASS32;
        head.e_ident[EI_DATA] = std::endian::native == std::endian::little ? ELFDATA2LSB : ELFDATA2MSB;
        head.e_type = ET_DYN;
        head.e_phoff = sizeof(Head);
        head.e_phentsize = sizeof(Segment);
        head.e_phnum = 1;
        segments[0].p_type = PT_NOTE;
        segments[0].p_offset = sizeof(Head) + sizeof(Segment);
        segments[0].p_filesz = notes.size();
    }
    std::string bytes() const
    {
        std::string all(reinterpret_cast<const char*>(&head), sizeof(Head));
        all.append(reinterpret_cast<const char*>(segments.data()), segments.size() * sizeof(Segment));
        return all + notes;
    }
};

/// Puts a number over four bytes of the note, behind its mark.
SmallLibrary withNumber(std::size_t place, std::uint32_t number)
{
    SmallLibrary library;
    std::memcpy(library.notes.data() + offsetof(decltype(ourNote), mark) + pluginNoteMark.size() + place, &number,
                sizeof(number));
    return library;
}

} // namespace

class PluginFileTest : public QObject {
    Q_OBJECT

private slots:
    void aLibrarySaysWhatItsJsonSays()
    {
        const auto text = pluginText(fs::path(TAN_FIXTURES "/good.so"));
        QVERIFY2(text, text ? "" : text.error().text().c_str());
        const std::string json = contentOf(TAN_SOURCE_DIR "/tests/plugins/host/fixtures/good.json");
        QVERIFY(!json.empty());
        QVERIFY2(text->find("\"metadata\": " + json) != std::string::npos, text->c_str());
        QVERIFY(text->starts_with("{\"interface\": \"org.tan.Reader/"));
        QCOMPARE(*textIn(SmallLibrary().bytes()), std::string(saying));
    }

    /// As others compute it.
    void theChecksumIsTheOneOfGzip() { QCOMPARE(noteChecksum("123456789"), 0xcbf43926U); }

    void randomBytesAreNoPlugin()
    {
        std::mt19937 random(44);
        const std::string start = SmallLibrary().bytes();
        for (int i = 0; i < 2000; ++i) {
            std::string bytes(random() % 600, '\0');
            for (char& byte : bytes)
                byte = static_cast<char>(random());
            if (i % 2 == 0) // behind a head that is in order
                bytes = start.substr(0, sizeof(Head) + random() % sizeof(Segment)) + bytes;
            const std::string refusal = refusalOf(bytes);
            QVERIFY2(refusal.starts_with("It is not a plugin, or is damaged: "), refusal.c_str());
        }
    }

    void whatIsCutShortIsRefused()
    {
        const std::string whole = contentOf(TAN_FIXTURES "/good.so");
        QVERIFY(whole.size() > 10000);
        for (std::size_t size = 0; size < whole.size(); size += size < 8192 ? 1 : 997)
            QVERIFY2(!refusalOf(std::string_view(whole).substr(0, size)).empty(), std::to_string(size).c_str());
        QVERIFY(!refusalOf(std::string_view(whole).substr(0, whole.size() - 1)).empty());
        QVERIFY(refusalOf(whole).empty());
    }

    /// Whichever byte is another: the text comes whole, or not at all.
    void aByteThatIsAnotherNeverChangesTheText()
    {
        const std::string whole = SmallLibrary().bytes();
        const std::size_t mark = whole.find(pluginNoteMark);
        for (std::size_t place = 0; place < whole.size(); ++place)
            for (const int change : {1, 0x80, 0xff}) {
                std::string bytes = whole;
                bytes[place] = static_cast<char>(bytes[place] ^ change);
                const auto text = textIn(bytes);
                QVERIFY(!text || *text == saying);
                const bool isOfText = place >= mark && place < mark + pluginNoteMark.size() + 8 + saying.size();
                QVERIFY2(!isOfText || !text, std::to_string(place).c_str());
            }
    }

    void numbersThatLeadOutOfTheFileAreRefused()
    {
        const auto refused = [](const SmallLibrary& library) {
            const std::string refusal = refusalOf(library.bytes());
            QVERIFY2(refusal.starts_with("It is not a plugin, or is damaged: "), refusal.c_str());
        };
        for (const std::uint64_t number : {std::uint64_t(1) << 20, std::uint64_t(1) << 31, ~std::uint64_t(0),
                                           ~std::uint64_t(0) - sizeof(Head), std::uint64_t(1) << 63}) {
            for (auto field : {&Segment::p_offset, &Segment::p_filesz}) {
                SmallLibrary library;
                library.segments[0].*field = static_cast<decltype(Segment::p_offset)>(number);
                refused(library);
                library.segments[0].p_type = PT_LOAD;
                refused(library);
            }
            SmallLibrary segments, sections;
            segments.head.e_phoff = static_cast<decltype(Head::e_phoff)>(number);
            refused(segments);
            sections.head.e_shoff = static_cast<decltype(Head::e_shoff)>(number);
            refused(sections);
        }
        SmallLibrary many;
        many.head.e_phnum = 0xffff;
        refused(many);
        for (const std::uint32_t size : {0U, std::uint32_t(saying.size()) - 1, std::uint32_t(saying.size()) + 1,
                                         std::uint32_t(mostNoteBytes) + 1, 0x7fffffffU, 0xffffffffU})
            refused(withNumber(0, size));
        refused(withNumber(4, 0));
    }

    /// The loader takes what this says as it is: what leads beside the table ends the program.
    void theTableForTheLoaderIsWhereItIsLoaded()
    {
        const std::string whole = contentOf(TAN_FIXTURES "/good.so");
        Head head;
        std::memcpy(&head, whole.data(), sizeof(head));
        const auto placeOf = [&](std::uint32_t type) {
            for (std::size_t place = head.e_phoff; place < head.e_phoff + head.e_phnum * sizeof(Segment);
                 place += sizeof(Segment))
                if (std::memcmp(whole.data() + place, &type, sizeof(type)) == 0)
                    return place;
            return std::string::npos;
        };
        const auto refusalWith = [&](std::size_t place, auto field, std::uint64_t number) {
            Segment segment;
            std::memcpy(&segment, whole.data() + place, sizeof(segment));
            segment.*field = static_cast<decltype(Segment::p_offset)>(number);
            std::string bytes = whole;
            std::memcpy(bytes.data() + place, &segment, sizeof(segment));
            return refusalOf(bytes);
        };
        const std::size_t table = placeOf(PT_DYNAMIC);
        QVERIFY(table != std::string::npos);
        Segment right;
        std::memcpy(&right, whole.data() + table, sizeof(right));
        QVERIFY(refusalWith(table, &Segment::p_vaddr, right.p_vaddr).empty());
        for (const std::uint64_t number :
             {std::uint64_t(0), std::uint64_t(right.p_vaddr) + 1, std::uint64_t(right.p_vaddr) + 8,
              std::uint64_t(right.p_vaddr) - 16, std::uint64_t(1) << 40, ~std::uint64_t(7)}) {
            const std::string refusal = refusalWith(table, &Segment::p_vaddr, number);
            QVERIFY2(refusal.find("its table for the loader is damaged") != std::string::npos, refusal.c_str());
        }
        for (const std::uint64_t number : {std::uint64_t(0), std::uint64_t(sizeof(ElfW(Dyn))), ~std::uint64_t(0)})
            QVERIFY(!refusalWith(table, &Segment::p_filesz, number).empty());
        QVERIFY(!refusalWith(table, &Segment::p_offset, right.p_offset + 16).empty());
        QVERIFY(!refusalWith(table, &Segment::p_offset, whole.size()).empty());
        const std::size_t unwinding = placeOf(PT_GNU_EH_FRAME); // what has bytes is in the file, whatever it is
        QVERIFY(unwinding != std::string::npos);
        QVERIFY(!refusalWith(unwinding, &Segment::p_offset, whole.size()).empty());
    }

    /// As many segments as there can be, each over all of a note that says nothing: it is looked at once.
    void manyLargeNotesAreNotReadForEver()
    {
        SmallLibrary library;
        library.notes.assign(std::size_t(1) << 20, 'x');
        library.segments.assign(0xffff, library.segments[0]);
        library.head.e_phnum = 0xffff;
        for (Segment& segment : library.segments) {
            segment.p_offset = sizeof(Head) + library.segments.size() * sizeof(Segment);
            segment.p_filesz = library.notes.size();
        }
        QVERIFY(refusalOf(library.bytes()).starts_with("It is not a plugin"));
    }

    void librariesOfOtherMachinesAreRefused()
    {
        for (const auto& [place, value] :
             {std::pair(int(EI_CLASS), sizeof(void*) == 8 ? ELFCLASS32 : ELFCLASS64),
              {EI_DATA, std::endian::native == std::endian::little ? ELFDATA2MSB : ELFDATA2LSB},
              {0, 'X'}}) {
            SmallLibrary library;
            library.head.e_ident[place] = static_cast<unsigned char>(value);
            QVERIFY(refusalOf(library.bytes()).find("for this machine") != std::string::npos);
        }
        SmallLibrary program;
        program.head.e_type = ET_EXEC;
        QVERIFY(refusalOf(program.bytes()).find("for this machine") != std::string::npos);
    }

    /// A host lists them with their reasons, and their code does not come into the process.
    void nothingOfThemIsLoaded()
    {
        const QTemporaryDir folder;
        const fs::path place = folder.path().toStdString();
        std::string damaged = contentOf(TAN_FIXTURES "/good.so");
        const std::size_t name = damaged.find("Fixture good");
        QVERIFY(name != std::string::npos);
        damaged[name] = 'f';
        std::string cut = contentOf(TAN_FIXTURES "/good.so");
        cut.resize(cut.size() - 1);
        std::ofstream(place / "damaged.so", std::ios::binary) << damaged;
        std::ofstream(place / "cut.so", std::ios::binary) << cut;
        fs::copy_file(TAN_FIXTURES "/of_qt.so", place / "of_qt.so");
        PluginHost host({.folders = {place}});
        QVERIFY(host.readers().empty());
        QVERIFY(host.complete());
        QCOMPARE(host.plugins().size(), std::size_t(3));
        for (const PluginStatus& plugin : host.plugins()) {
            QCOMPARE(plugin.state, PluginState::Refused);
            QVERIFY(!plugin.hasMetadata && !plugin.error.empty());
            QVERIFY2(::dlopen(plugin.path.c_str(), RTLD_NOW | RTLD_NOLOAD) == nullptr, plugin.path.c_str());
        }
    }
};

QTEST_APPLESS_MAIN(PluginFileTest)
#include "plugin_file_test.moc"
