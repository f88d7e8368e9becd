// SPDX-License-Identifier: GPL-3.0-or-later
// The system's reasons in errors are English under every locale: the texts around them are, and the window translates.
#include "core/base/file_writer.h"
#include "core/base/reserved_array.h"
#include "core/base/scratch_file.h"
#include "core/base/system_error.h"
#include "core/base/work_folder.h"
#include "tests/lacks.h"

#include <tan/base.h>

#include <QTemporaryDir>
#include <QTest>

#include <array>
#include <cerrno>
#include <clocale>
#include <cstring>
#include <fstream>
#include <string>
#include <utility>

#include <libintl.h>

using namespace tetra;

namespace {

constexpr const char* germanNoSuchFile = "Datei oder Verzeichnis nicht gefunden";

/// A catalogue of the C library's texts in German, as a language pack has it. gettext's format: the header, for each
/// text length and place of the original and of the translation, the texts.
std::string germanCatalogue()
{
    const std::array<std::pair<std::string, std::string>, 3> texts{
        {{"", "Content-Type: text/plain; charset=UTF-8\n"},
         {"Cannot allocate memory", "Nicht genügend Hauptspeicher verfügbar"},
         {"No such file or directory", germanNoSuchFile}}};
    constexpr std::uint32_t headerWords = 7;
    const auto count = static_cast<std::uint32_t>(texts.size());
    std::vector<std::uint32_t> words = {0x950412de, 0, count, 4 * headerWords, 4 * (headerWords + 2 * count), 0, 0};
    auto place = static_cast<std::uint32_t>(4 * (headerWords + 4 * count));
    std::string strings;
    const auto add = [&](const std::string& text) {
        const auto length = static_cast<std::uint32_t>(text.size());
        words.insert(words.end(), {length, place});
        place += length + 1;
        strings.append(text.c_str(), text.size() + 1);
    };
    for (const auto& text : texts)
        add(text.first);
    for (const auto& text : texts)
        add(text.second);
    return std::string(reinterpret_cast<const char*>(words.data()), 4 * words.size()) + strings;
}

template <class Value> QString textOfError(const Result<Value>& result)
{
    return result ? QString() : QString::fromStdString(result.error().text());
}

} // namespace

class SystemErrorTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        const std::filesystem::path catalogues = folder_.path().toStdString();
        std::filesystem::create_directories(catalogues / "de" / "LC_MESSAGES");
        std::ofstream(catalogues / "de" / "LC_MESSAGES" / "libc.mo", std::ios::binary) << germanCatalogue();
        if (std::setlocale(LC_ALL, "de_DE.UTF-8") == nullptr)
            QSKIP_WITHOUT("locale de_DE.UTF-8");
        ::unsetenv("LANGUAGE");
        ::bindtextdomain("libc", catalogues.c_str());
        QCOMPARE(std::strerror(ENOENT), germanNoSuchFile); // or nothing below could fail
    }
    void cleanupTestCase() { std::setlocale(LC_ALL, "C"); }

    void reasonsAreEnglish_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("reason");
        const std::filesystem::path missing = std::filesystem::path(folder_.path().toStdString()) / "no" / "such";
        const QString noSuchFile = "No such file or directory";
        QTest::newRow("reading") << textOfError(MappedFile::open(missing)) << noSuchFile;
        QTest::newRow("writing") << textOfError(FileWriter::create(missing)) << noSuchFile;
        QTest::newRow("a work folder") << textOfError(WorkFolder::open(missing, WorkFolder::Leftovers::Remove))
                                       << noSuchFile;
        QTest::newRow("a scratch file") << textOfError(ScratchFile::create(missing, 1)) << noSuchFile;
        SpoolFile spool(missing);
        QTest::newRow("a spool file") << textOfError(spool.append(std::array{std::byte(0)})) << noSuchFile;
        QTest::newRow("memory") << textOfError(reserveMemory(std::size_t(1) << 60, MarkedText{"a test"}))
                                << "Cannot allocate memory";
    }
    void reasonsAreEnglish()
    {
        QFETCH(QString, text);
        QFETCH(QString, reason);
        QVERIFY2(text.contains(reason), qPrintable(text));
    }

    void everyErrorHasAText()
    {
        QCOMPARE(systemErrorText(ENOENT).text(), std::string("No such file or directory"));
        QCOMPARE(systemErrorText(ENOSPC).text(), std::string("No space left on device"));
        QCOMPARE(systemErrorText(123456).text(), std::string("system error 123456"));
    }

private:
    QTemporaryDir folder_;
};

QTEST_APPLESS_MAIN(SystemErrorTest)
#include "system_error_test.moc"
