// SPDX-License-Identifier: GPL-3.0-or-later
/// Good and bad plugins (fixtures) in folders of their own: each bad one gets its text, and the host always starts.
#include "plugins/host/plugin_host.h"

#include "plugins/host/plugin_folders.h"

#include <tan/version.h>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <atomic>
#include <chrono>
#include <fstream>
#include <latch>
#include <thread>

#include <unistd.h>

using namespace tetra;

namespace {

namespace fs = std::filesystem;

/// A folder with some of the fixtures.
class Folder {
public:
    explicit Folder(const std::vector<std::string>& fixtures = {})
    {
        for (const std::string& name : fixtures)
            add(name, name);
    }
    void add(const std::string& fixture, const std::string& as) const
    {
        fs::copy_file(fs::path(TAN_FIXTURES) / (fixture + ".so"), path() / (as + ".so"));
    }
    fs::path path() const { return fs::path(folder_.path().toStdString()); }

private:
    QTemporaryDir folder_;
};

PluginStatus statusOf(const PluginHost& host, const std::string& id)
{
    for (const PluginStatus& plugin : host.plugins())
        if (plugin.metadata.id == id)
            return plugin;
    return {};
}

} // namespace

#define COMPARE_STATE(host, id, expected)                                                                              \
    QCOMPARE(pluginStateName(statusOf(host, id).state), std::string_view(expected))

class PluginHostTest : public QObject {
    Q_OBJECT

private slots:
    void loadsWhenFirstUsed()
    {
        const Folder folder({"good"});
        PluginHost host({.folders = {folder.path()}});
        COMPARE_STATE(host, "good", "found");
        QCOMPARE(host.builders().size(), std::size_t(0));
        COMPARE_STATE(host, "good", "found");
        const auto readers = host.readers();
        QCOMPARE(readers.size(), std::size_t(1));
        QCOMPARE(readers[0].id, std::string("good"));
        QCOMPARE(readers[0].plugin->score("a.fixture", {}), 1.0);
        COMPARE_STATE(host, "good", "loaded");
    }

    void ofTheUsersFolderNothingOfOthersIsLoaded_data()
    {
        QTest::addColumn<QString>("place");
        QTest::addColumn<bool>("isForeign");
        for (const char* place : {"tan", "tan/plugins", "tan/plugins/good.so"}) {
            QTest::addRow("everyone may write to %s", place) << QString(place) << false;
            QTest::addRow("%s belongs to another user", place) << QString(place) << true;
        }
    }
    void ofTheUsersFolderNothingOfOthersIsLoaded()
    {
        QFETCH(QString, place);
        QFETCH(bool, isForeign);
        if (isForeign && ::geteuid() != 0)
            QSKIP("skipped: only root can give files away");
        const QTemporaryDir data;
        const fs::path plugins = fs::path(data.path().toStdString()) / "tan/plugins";
        fs::create_directories(plugins);
        fs::copy_file(fs::path(TAN_FIXTURES) / "good.so", plugins / "good.so");
        const auto host = [&] {
            return std::make_unique<PluginHost>(PluginHostOptions{.folders = {plugins}, .ownFolder = plugins});
        };
        COMPARE_STATE(*host(), "good", "found");
        const fs::path changed = fs::path(data.path().toStdString()) / place.toStdString();
        if (isForeign)
            QCOMPARE(::chown(changed.c_str(), 65534, 65534), 0);
        else
            fs::permissions(changed, fs::perms::others_write, fs::perm_options::add);
        const auto refused = host();
        COMPARE_STATE(*refused, "good", "refused");
        const std::string error = statusOf(*refused, "good").error.text();
        QVERIFY2(error.find("could put any program there") != std::string::npos, error.c_str());
        QVERIFY2(error.find(changed.string()) != std::string::npos, error.c_str());
        QVERIFY(refused->readers().empty());
        // Where somebody asks for a folder by name it is that user's own affair.
        COMPARE_STATE(PluginHost({.folders = {plugins}}), "good", "found");
    }

    void relativeFoldersAreIgnored()
    {
        const QByteArray data = qgetenv("XDG_DATA_HOME"), home = qgetenv("HOME"), dirs = qgetenv("XDG_DATA_DIRS");
        qputenv("XDG_DATA_HOME", "relative");
        qputenv("HOME", "/home/somebody");
        qputenv("XDG_DATA_DIRS", "/one:two:/three");
        const fs::path own = userPluginFolder();
        ignoreRelativeFolders();
        const bool isGone = qEnvironmentVariableIsEmpty("XDG_DATA_HOME");
        const QByteArray kept = qgetenv("XDG_DATA_DIRS");
        qunsetenv("HOME");
        const fs::path homeless = userPluginFolder();
        qputenv("XDG_DATA_HOME", "/data");
        const fs::path absolute = userPluginFolder();
        for (const auto& [name, value] : {std::pair("XDG_DATA_HOME", data), {"HOME", home}, {"XDG_DATA_DIRS", dirs}})
            value.isNull() ? (void)qunsetenv(name) : (void)qputenv(name, value);
        QCOMPARE(own, fs::path("/home/somebody/.local/share/tan/plugins"));
        QVERIFY(isGone);
        QCOMPARE(kept, QByteArray("/one:/three"));
        QCOMPARE(homeless, fs::path());
        QCOMPARE(absolute, fs::path("/data/tan/plugins"));
    }

    void loadsWhatIsNeededBefore()
    {
        const Folder folder({"dependent", "good"});
        PluginHost host({.folders = {folder.path()}});
        QCOMPARE(host.readers().size(), std::size_t(2));
        COMPARE_STATE(host, "good", "loaded");
        COMPARE_STATE(host, "dependent", "loaded");
    }

    void refusesBadPluginsWithAText_data()
    {
        QTest::addColumn<QStringList>("fixtures");
        QTest::addColumn<QString>("id");
        QTest::addColumn<QStringList>("words");
        QTest::newRow("another interface version")
            << QStringList{"wrong_api"} << "wrong-api" << QStringList{"2.0.0", TAN_VERSION};
        QTest::newRow("circle") << QStringList{"circular_a", "circular_b"} << "circular-b" << QStringList{"circle"};
        QTest::newRow("half a circle") << QStringList{"circular_a"} << "circular-a" << QStringList{"circular-b"};
        QTest::newRow("missing dependency")
            << QStringList{"missing_dependency"} << "missing-dependency" << QStringList{"nowhere"};
        QTest::newRow("malformed metadata")
            << QStringList{"malformed"} << "malformed" << QStringList{"\"id\"", "string"};
        QTest::newRow("kind and interface differ")
            << QStringList{"lying"} << "lying" << QStringList{"org.tan.Builder/2"};
        QTest::newRow("a plugin of Qt, as they were for earlier versions of TAn")
            << QStringList{"of_qt"} << "of_qt"
            << QStringList{"built for an earlier version of TAn", "Install a later version of the plugin",
                           "build it again"};
        QTest::newRow("an earlier interface")
            << QStringList{"earlier"} << "earlier" << QStringList{"built for an earlier version of TAn"};
        QTest::newRow("another build") << QStringList{"wrong_build"} << "wrong-build"
                                       << QStringList{"plan9-mips-cfront"};
    }
    void refusesBadPluginsWithAText()
    {
        QFETCH(QStringList, fixtures);
        QFETCH(QString, id);
        QFETCH(QStringList, words);
        Folder folder({"good"});
        for (const QString& fixture : fixtures)
            folder.add(fixture.toStdString(), fixture.toStdString());
        PluginHost host({.folders = {folder.path()}});
        COMPARE_STATE(host, id.toStdString(), "refused");
        const QString error = QString::fromStdString(statusOf(host, id.toStdString()).error.text());
        for (const QString& word : words)
            QVERIFY2(error.contains(word), qPrintable(error));
        QCOMPARE(host.readers().size(), std::size_t(1));
        COMPARE_STATE(host, "good", "loaded");
    }

    void refusesAtLoadingWithAText_data()
    {
        QTest::addColumn<QStringList>("fixtures");
        QTest::addColumn<QString>("id");
        QTest::addColumn<QStringList>("words");
        QTest::newRow("missing library") << QStringList{"missing_library"} << "missing-library"
                                         << QStringList{"libtan-fixture-missing.so", "Install libfixture."};
        QTest::newRow("needs one with a missing library")
            << QStringList{"needs_missing_library", "missing_library"} << "needs-missing-library"
            << QStringList{"\"missing-library\"", "libtan-fixture-missing.so"};
        QTest::newRow("implements another kind")
            << QStringList{"impostor"} << "impostor" << QStringList{"does not implement org.tan.Builder/2"};
        QTest::newRow("throws when made") << QStringList{"throwing"} << "throwing" << QStringList{"no luck"};
        QTest::newRow("throws a number when made")
            << QStringList{"throwing_anything"} << "throwing-anything" << QStringList{"without giving a reason"};
    }
    void refusesAtLoadingWithAText()
    {
        QFETCH(QStringList, fixtures);
        QFETCH(QString, id);
        QFETCH(QStringList, words);
        Folder folder({"good"});
        for (const QString& fixture : fixtures)
            folder.add(fixture.toStdString(), fixture.toStdString());
        PluginHost host({.folders = {folder.path()}});
        COMPARE_STATE(host, id.toStdString(), "found");
        QCOMPARE(host.builders().size(), std::size_t(0));
        QCOMPARE(host.readers().size(), std::size_t(1));
        COMPARE_STATE(host, id.toStdString(), "refused");
        const QString error = QString::fromStdString(statusOf(host, id.toStdString()).error.text());
        for (const QString& word : words)
            QVERIFY2(error.contains(word), qPrintable(error));
    }

    /// What it says of itself is there, what it would begin with is not.
    void aLibraryWithoutTheFunctionOfPlugins()
    {
        const Folder folder;
        std::ifstream file(fs::path(TAN_FIXTURES) / "good.so", std::ios::binary);
        std::string bytes(std::istreambuf_iterator<char>(file), {});
        const std::string name("\0tanPlugin\0", 11), other("\0tanPlugon\0", 11);
        QVERIFY(bytes.find(name) != std::string::npos);
        for (std::size_t place = 0; (place = bytes.find(name, place)) != std::string::npos;)
            bytes.replace(place, other.size(), other);
        std::ofstream(folder.path() / "incomplete.so", std::ios::binary) << bytes;
        PluginHost host({.folders = {folder.path()}});
        COMPARE_STATE(host, "good", "found");
        QVERIFY(host.readers().empty());
        COMPARE_STATE(host, "good", "refused");
        QVERIFY(statusOf(host, "good").error.text().starts_with("It has no function tanPlugin, so it is not a comp"));
    }

    void folderOfTheProgramIsUnknown()
    {
        for (const char* unknown : {"", "bin"})
            QVERIFY(pluginFolders(unknown).size() < pluginFolders("/nowhere/bin").size());
    }

    void tellsWhyOneOfAllIsMissing()
    {
        const Folder folder({"good", "missing_library", "throwing", "wrong_build"});
        PluginHost host({.folders = {folder.path()}});
        std::vector<std::string> told;
        host.whenFailing([&](const Error& error) { told.push_back(error.text()); });
        QCOMPARE(host.readers().size(), std::size_t(1));
        QCOMPARE(told.size(), std::size_t(2));
        QVERIFY2(told[0].find("libtan-fixture-missing.so") != std::string::npos, told[0].c_str());
        QVERIFY2(told[1].find("no luck") != std::string::npos, told[1].c_str());
        QCOMPARE(host.readers().size(), std::size_t(1));
        QCOMPARE(told.size(), std::size_t(2)); // once each
        QVERIFY(!host.reader("throwing"));
        QCOMPARE(told.size(), std::size_t(2)); // the caller has been given the error
    }

    void whoeverHeardIsNotCalledAfterwards()
    {
        const Folder folder({"missing_library"});
        PluginHost host({.folders = {folder.path()}});
        std::latch begun(1);
        std::latch goOn(1);
        std::atomic<bool> ended = false;
        host.whenFailing([&](const Error&) {
            begun.count_down();
            goOn.wait();
            ended = true;
        });
        const std::jthread loading([&] { host.readers(); });
        begun.wait();
        const std::jthread later([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
            goOn.count_down();
        });
        host.whenFailing({}); // what it used may go now
        QVERIFY(ended);
    }

    void theFirstOfTwoWithOneIdWins()
    {
        const Folder first({"good"});
        const Folder second({"good"});
        PluginHost host({.folders = {first.path(), second.path()}});
        const auto plugins = host.plugins();
        QCOMPARE(plugins.size(), std::size_t(2));
        QCOMPARE(plugins[0].path.parent_path(), first.path());
        QCOMPARE(plugins[0].state, PluginState::Found);
        QCOMPARE(plugins[1].state, PluginState::Refused);
        QVERIFY(plugins[1].error.text().find(plugins[0].path.string()) != std::string::npos);
        QCOMPARE(host.readers().size(), std::size_t(1));
    }

    void oneFileInTwoFoldersIsOnePlugin()
    {
        const Folder first({"good"});
        const Folder second;
        fs::create_symlink(first.path() / "good.so", second.path() / "again.so");
        const PluginHost host({.folders = {first.path(), second.path(), first.path()}});
        QCOMPARE(host.plugins().size(), std::size_t(1));
    }

    void filesThatAreNoPlugins()
    {
        const Folder folder({"good"});
        std::ofstream(folder.path() / "empty.so").close();
        std::ofstream(folder.path() / "text.so") << "This is not a library.";
        std::ofstream(folder.path() / "readme.txt") << "Ignored.";
        folder.add("good", "truncated");
        fs::resize_file(folder.path() / "truncated.so", 1000);
        fs::create_symlink("nowhere.so", folder.path() / "dangling.so");
        fs::create_directory(folder.path() / "folder.so");
        fs::copy_file(TAN_BINARY_DIR "/lib/libtan-core.so", folder.path() / "ordinary.so");
        PluginHost host({.folders = {folder.path()}});
        for (const char* id : {"empty", "text", "truncated", "dangling", "ordinary"}) {
            COMPARE_STATE(host, id, "refused");
            QVERIFY2(statusOf(host, id).error.text().find("not a plugin") != std::string::npos,
                     statusOf(host, id).error.text().c_str());
        }
        QCOMPARE(host.plugins().size(), std::size_t(6));
        QCOMPARE(host.readers().size(), std::size_t(1));
    }

    void disabledPluginsAreNotUsed()
    {
        const Folder folder({"good", "dependent"});
        PluginHost host({.folders = {folder.path()}, .disabled = {"good"}});
        COMPARE_STATE(host, "good", "disabled");
        COMPARE_STATE(host, "dependent", "refused");
        QVERIFY(host.readers().empty());
        QVERIFY(!host.explainMissing(PluginKind::Reader).empty());
    }

    void asksByNameGetAnswersInWords()
    {
        const Folder folder({"good", "lying"});
        PluginHost host({.folders = {folder.path()}});
        const auto unknown = host.builder("unknown");
        QVERIFY(!unknown);
        QCOMPARE(unknown.error().kind, ErrorKind::WrongUsage);
        QVERIFY2(unknown.error().text().find("None is installed") != std::string::npos, unknown.error().text().c_str());
        QVERIFY(host.builder("lying").error().text().find("org.tan.Builder/2") != std::string::npos);
        QVERIFY(!host.builder("good"));
    }

    void foldersMayBeMissing()
    {
        const PluginHost host({.folders = {"/nowhere/at/all", ""}});
        QVERIFY(host.plugins().empty());
    }

    void threadsMayAskAtOnce()
    {
        const Folder folder({"good", "dependent", "missing_library", "needs_missing_library"});
        PluginHost host({.folders = {folder.path()}});
        std::vector<std::size_t> counts(8);
        {
            std::vector<std::jthread> threads;
            for (std::size_t& count : counts)
                threads.emplace_back([&] { count = host.readers().size(); });
        }
        QCOMPARE(counts, std::vector<std::size_t>(8, 2));
    }

    void theEnvironmentAddsFolders()
    {
        const Folder folder;
        qputenv("TAN_PLUGIN_PATH", QByteArray::fromStdString(folder.path().string()) + ":/nowhere::");
        qputenv("TAN_PLUGIN_DISABLE", "one, two,,");
        const auto folders = pluginFolders(TAN_BINARY_DIR "/bin");
        QCOMPARE(folders.at(0), fs::canonical(folder.path()));
        QCOMPARE(folders.at(1), fs::path("/nowhere"));
        QCOMPARE(folders.at(2), fs::weakly_canonical(userPluginFolder()));
        QCOMPARE(folders.at(3), fs::path(TAN_BINARY_DIR "/lib/tan/plugins"));
        QCOMPARE(disabledPlugins(), (std::vector<std::string>{"one", "two"}));
        qunsetenv("TAN_PLUGIN_PATH");
        qunsetenv("TAN_PLUGIN_DISABLE");
    }

    /// Where the user's data are, as the XDG base directory specification says.
    void aUserHasPluginsOfTheirOwn()
    {
        const QByteArray before = qgetenv("XDG_DATA_HOME");
        const QTemporaryDir data;
        qputenv("XDG_DATA_HOME", data.path().toUtf8());
        const fs::path folder = fs::path(data.path().toStdString()) / "tan/plugins";
        QCOMPARE(userPluginFolder(), folder);
        fs::create_directories(folder);
        fs::copy_file(fs::path(TAN_FIXTURES) / "good.so", folder / "good.so");
        PluginHost host({.folders = pluginFolders("/nowhere/bin")});
        QCOMPARE(host.readers().size(), std::size_t(1));
        qputenv("XDG_DATA_HOME", before);
    }
};

QTEST_GUILESS_MAIN(PluginHostTest)
#include "plugin_host_test.moc"
