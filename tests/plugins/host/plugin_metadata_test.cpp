// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/api/metadata.h"
#include "plugins/api/tool.h"
#include "plugins/host/compatibility.h"
#include "plugins/host/plugin_file.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#ifdef __clang__
#define TAN_COMPILER_MAJOR __clang_major__
#else
#define TAN_COMPILER_MAJOR __GNUC__
#endif

using namespace tetra;

namespace {

QJsonObject own()
{
    return {{"id", "good"}, {"kind", "reader"}, {"version", "1.2.3"}, {"api", "1.0"}, {"name", "Good"}};
}

QString asQString(std::string_view text)
{
    return QString::fromUtf8(text.data(), qsizetype(text.size()));
}

QJsonObject whole(const QJsonObject& metadata)
{
    return {{"interface", asQString(interfaceId<Reader>)},
            {"qt", "6.4.2"},
            {"build", "linux-x86_64-gnu"},
            {"metadata", metadata}};
}

Result<PluginMetadata> parse(const QJsonObject& json)
{
    return parsePluginMetadata(QJsonDocument(json).toJson().toStdString());
}

HostBuild host()
{
    return {{1, 0, 0}, {6, 4, 2}, "linux-x86_64-gnu"};
}

} // namespace

class PluginMetadataTest : public QObject {
    Q_OBJECT

private slots:
    void readsWhatIsThere()
    {
        QJsonObject metadata = own();
        metadata["requires"] = QJsonArray{"other", "third"};
        metadata["description"] = "Reads.";
        metadata["somethingNew"] = 5;
        const auto parsed = parse(whole(metadata));
        QVERIFY2(parsed, parsed ? "" : parsed.error().text().c_str());
        QCOMPARE(parsed->id, std::string("good"));
        QCOMPARE(parsed->kind, PluginKind::Reader);
        QVERIFY((parsed->version == Version{1, 2, 3}));
        QVERIFY((parsed->api == Version{1, 0, 0}));
        QVERIFY((parsed->qt == Version{6, 4, 2}));
        QCOMPARE(parsed->requiredIds, (std::vector<std::string>{"other", "third"}));
        QCOMPARE(parsed->buildTag, std::string("linux-x86_64-gnu"));
    }

    void refusesMalformedMetadata_data()
    {
        QTest::addColumn<QString>("key");
        QTest::addColumn<QJsonValue>("value");
        for (const char* key : {"id", "kind", "version", "api", "name"}) {
            QTest::addRow("%s missing", key) << key << QJsonValue(QJsonValue::Undefined);
            QTest::addRow("%s a number", key) << key << QJsonValue(1);
            QTest::addRow("%s empty", key) << key << QJsonValue("");
        }
        QTest::newRow("id with capitals") << "id" << QJsonValue("Good");
        QTest::newRow("id with a space") << "id" << QJsonValue("good one");
        QTest::newRow("unknown kind") << "kind" << QJsonValue("wizard");
        QTest::newRow("version of words") << "version" << QJsonValue("one");
        QTest::newRow("api with a tail") << "api" << QJsonValue("1.0-beta");
        QTest::newRow("requires a text") << "requires" << QJsonValue("good");
        QTest::newRow("requires numbers") << "requires" << QJsonValue(QJsonArray{1});
    }
    void refusesMalformedMetadata()
    {
        QFETCH(QString, key);
        QFETCH(QJsonValue, value);
        QJsonObject metadata = own();
        metadata.remove(key);
        if (!value.isUndefined())
            metadata[key] = value;
        const auto parsed = parse(whole(metadata));
        QVERIFY(!parsed);
        QVERIFY2(parsed.error().text().find(key.toStdString()) != std::string::npos, parsed.error().text().c_str());
    }

    void refusesNoMetadataAtAll()
    {
        for (const char* text : {"", "{}", "7", "[]", "{\"metadata\": 5}", "{\"metadata\": {}}", "{\"metadata\": "})
            QVERIFY2(!parsePluginMetadata(text), text);
    }

    void compatibility_data()
    {
        QTest::addColumn<QString>("api");
        QTest::addColumn<QString>("qt");
        QTest::addColumn<QString>("build");
        QTest::addColumn<QString>("interface");
        QTest::addColumn<QString>("error"); // a word of it; empty means it fits
        const QString build = "linux-x86_64-gnu";
        const QString reader = asQString(interfaceId<Reader>);
        QTest::newRow("the same") << "1.0"
                                  << "6.4.2" << build << reader << "";
        QTest::newRow("without Qt") << "1.0"
                                    << "" << build << reader << "";
        QTest::newRow("a later patch of Qt") << "1.0"
                                             << "6.4.9" << build << reader << "";
        QTest::newRow("an earlier Qt") << "1.0"
                                       << "6.2.0" << build << reader << "";
        QTest::newRow("a later api") << "1.1"
                                     << "" << build << reader << "newer version of TAn";
        QTest::newRow("the next major api") << "2.0"
                                            << "" << build << reader << "newer version of TAn";
        QTest::newRow("the previous major api") << "0.9"
                                                << "" << build << reader << "newer version of the plugin";
        QTest::newRow("that of an earlier TAn") << "0.1"
                                                << "" << build << reader << "of an earlier TAn";
        QTest::newRow("a later Qt") << "1.0"
                                    << "6.5.0" << build << reader << "Qt 6.5.0";
        QTest::newRow("Qt 5") << "1.0"
                              << "5.15.2" << build << reader << "Qt 5.15.2";
        QTest::newRow("another compiler") << "1.0"
                                          << ""
                                          << "linux-x86_64-clang" << reader << "linux-x86_64-clang";
        QTest::newRow("no build tag") << "1.0"
                                      << ""
                                      << "" << reader << "tan_plugin_module()";
        QTest::newRow("another interface") << "1.0"
                                           << "" << build << "org.tan.Builder/1"
                                           << "org.tan.Builder/1";
        QTest::newRow("a later interface") << "1.0"
                                           << "" << build << "org.tan.Reader/99"
                                           << "org.tan.Reader/99";
        QTest::newRow("no number") << "1.0"
                                   << "" << build << "org.tan.Reader/"
                                   << "org.tan.Reader/";
        const char* const earlier = "built for an earlier version of TAn. Install a later version";
        QTest::newRow("an earlier interface") << "1.0"
                                              << "" << build << "org.tan.Reader/2" << earlier;
        QTest::newRow("the first interface") << "1.0"
                                             << "" << build << "org.tan.Reader/1" << earlier;
    }
    void compatibility()
    {
        QFETCH(QString, api);
        QFETCH(QString, qt);
        QFETCH(QString, build);
        QFETCH(QString, interface);
        QFETCH(QString, error);
        QJsonObject metadata = own();
        metadata["api"] = api;
        QJsonObject json = whole(metadata);
        json["qt"] = qt;
        json["build"] = build;
        json["interface"] = interface;
        const auto parsed = parse(json);
        QVERIFY(parsed);
        const Status status = checkCompatible(*parsed, host());
        QCOMPARE(status.ok(), error.isEmpty());
        if (!status)
            QVERIFY2(status.error().text().find(error.toStdString()) != std::string::npos,
                     status.error().text().c_str());
    }

    void anEditorImplementsTheInterfaceOfEditors()
    {
        QJsonObject metadata = own();
        metadata["kind"] = "editor";
        metadata["edits"] = "transfer-function";
        QJsonObject json = whole(metadata);
        json["interface"] = asQString(interfaceId<Editor>);
        const auto parsed = parse(json);
        QVERIFY(parsed);
        QVERIFY(checkCompatible(*parsed, host()));
        json["interface"] = asQString(interfaceId<Renderer>);
        QVERIFY(!checkCompatible(*parse(json), host()));
    }

    /// One of another number is refused: of an earlier one as such.
    void aToolImplementsTheInterfaceOfTools()
    {
        QJsonObject metadata = own();
        metadata["kind"] = "tool";
        QJsonObject json = whole(metadata);
        json["interface"] = asQString(interfaceId<Tool>);
        const auto parsed = parse(json);
        QVERIFY(parsed);
        QCOMPARE(parsed->kind, PluginKind::Tool);
        QVERIFY(checkCompatible(*parsed, host()));
        for (const char* other : {"org.tan.Tool/0", "org.tan.Tool/2", "org.tan.Renderer/4", ""}) {
            json["interface"] = other;
            const Status status = checkCompatible(*parse(json), host());
            QVERIFY2(!status, other);
            const bool isEarlier = QByteArray(other).endsWith("/0");
            QVERIFY2((status.error().message == builtForEarlierTan()) == isEarlier, status.error().text().c_str());
        }
    }

    void anEditorSaysWhatItEdits()
    {
        QJsonObject metadata = own();
        metadata["kind"] = "editor";
        QJsonObject json = whole(metadata);
        json["interface"] = asQString(interfaceId<Editor>);
        QVERIFY(parse(json).error().text().find("\"edits\"") != std::string::npos);
        metadata["edits"] = "example.curve";
        json["metadata"] = metadata;
        const auto parsed = parse(json);
        QCOMPARE(parsed->edits, std::string("example.curve"));
        QCOMPARE(parsed->title, std::string("Good"));
        metadata["title"] = "Curve";
        json["metadata"] = metadata;
        QCOMPARE(parse(json)->title, std::string("Curve"));
    }

    /// Of a program without windows nobody knows the Qt, and it uses no editors.
    void whereNoQtRunsNoneIsAskedFor()
    {
        QJsonObject json = whole(own());
        json["qt"] = "6.9.0";
        QVERIFY(!checkCompatible(*parse(json), host()));
        HostBuild withoutQt = host();
        withoutQt.qt = {};
        QVERIFY(checkCompatible(*parse(json), withoutQt));
    }

    /// Every part of the tag counts, and the refusal names both builds and what to do.
    void anotherBuildIsRefused()
    {
        const std::vector<std::vector<std::string>> parts = {
            {"linux-x86_64-64", "linux-x86_64-32", "linux-aarch64-64"},
            {"gnu-12", "gnu-13", "clang-12", "gnu-1"},
            {"libstdc++", "libc++"},
            {"tan-0.1.0", "tan-0.1.1", "tan-0.2.0", "tan-0.1.0/thread"}};
        std::vector<std::string> tags = {""};
        for (const auto& choices : parts) {
            std::vector<std::string> longer;
            for (const std::string& tag : tags)
                for (const std::string& choice : choices)
                    longer.push_back((tag.empty() ? "" : tag + "/") + choice);
            tags = longer;
        }
        QCOMPARE(tags.size(), std::size_t(3 * 4 * 2 * 4));
        auto plugin = *parse(whole(own()));
        for (const std::string& offered : tags)
            for (const std::string& built : tags) {
                plugin.buildTag = built;
                const Status status = checkCompatible(plugin, {{1, 0, 0}, {6, 4, 2}, offered});
                QCOMPARE(status.ok(), offered == built);
                if (!status)
                    QVERIFY2(status.error().text().find(built) != std::string::npos &&
                                 status.error().text().find(offered) != std::string::npos &&
                                 status.error().text().find("Rebuild") != std::string::npos,
                             status.error().text().c_str());
            }
    }

    /// What this program is built with: all that objects which pass between it and plugins depend on.
    void theTagOfThisBuildIsWhole()
    {
        const HostBuild build = thisBuild();
        const QStringList parts = QString::fromStdString(build.buildTag).split('/');
        QVERIFY2(parts.size() >= 4, build.buildTag.c_str());
        QVERIFY(parts[0].endsWith("-" + QString::number(8 * sizeof(void*))));
        QVERIFY(parts[1].endsWith("-" + QString::number(TAN_COMPILER_MAJOR)));
#ifdef _LIBCPP_VERSION
        QCOMPARE(parts[2], QString("libc++"));
#else
        QCOMPARE(parts[2], QString("libstdc++"));
#endif
        QCOMPARE(parts[3], "tan-" + QString::fromStdString(toText(build.api)));
    }

    void loadErrorsNameWhatIsMissing()
    {
        const std::string missing =
            "Cannot load library /p/x.so: (libvtk9.so.1: cannot open shared object file: No such file or directory)";
        QCOMPARE(explainLoadError(missing, "Install libvtk9.1.").text(),
                 std::string("The library libvtk9.so.1 is missing. Install libvtk9.1."));
        QVERIFY(explainLoadError(missing, "").text().find("apt-file search libvtk9.so.1") != std::string::npos);
        const std::string symbol =
            explainLoadError("Cannot load library /p/x.so: (/p/x.so: undefined symbol: _Zabc)", "").text();
        QVERIFY2(symbol.starts_with("It needs the function _Zabc,"), symbol.c_str());
        QCOMPARE(explainLoadError("libvtk9.so.1: cannot open shared object file: No such file or directory",
                                  "Install libvtk9.1.")
                     .text(),
                 std::string("The library libvtk9.so.1 is missing. Install libvtk9.1."));
        QVERIFY(
            explainLoadError("/p/x.so: undefined symbol: _Zabc", "").text().starts_with("It needs the function _Z"));
        QVERIFY(explainLoadError("file too short", "").text().find("file too short") != std::string::npos);
        QVERIFY(!explainLoadError("", "").empty());
    }

    void namesAndDescriptionsComeInOtherLanguages()
    {
        QJsonObject metadata = own();
        metadata["name[de]"] = "Leser";
        metadata["name[pt_BR]"] = "Leitor";
        metadata["description[de]"] = "Liest.";
        metadata["named"] = "no translation";
        const auto parsed = parse(whole(metadata));
        QVERIFY(parsed);
        QCOMPARE(parsed->names, (std::map<std::string, std::string>{{"de", "Leser"}, {"pt_BR", "Leitor"}}));
        QCOMPARE(parsed->descriptions, (std::map<std::string, std::string>{{"de", "Liest."}}));
    }
};

QTEST_APPLESS_MAIN(PluginMetadataTest)
#include "plugin_metadata_test.moc"
