// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/api/editor.h"
#include "plugins/api/reader.h"
#include "plugins/api/renderer.h"
#include "plugins/host/compatibility.h"
#include "plugins/host/load_error.h"

#include <QJsonArray>
#include <QTest>

namespace tetra {
namespace {

QJsonObject own()
{
    return {{"id", "good"}, {"kind", "reader"}, {"version", "1.2.3"}, {"api", "1.0"}, {"name", "Good"}};
}

QJsonObject whole(const QJsonObject& metadata)
{
    return {{"IID", TAN_READER_INTERFACE},
            {"version", 0x060402},
            {"build", QJsonArray{"linux-x86_64-gnu"}},
            {"MetaData", metadata}};
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
        const auto parsed = parsePluginMetadata(whole(metadata));
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
        const auto parsed = parsePluginMetadata(whole(metadata));
        QVERIFY(!parsed);
        QVERIFY2(parsed.error().text().find(key.toStdString()) != std::string::npos, parsed.error().text().c_str());
    }

    void refusesNoMetadataAtAll() { QVERIFY(!parsePluginMetadata({})); }

    void compatibility_data()
    {
        QTest::addColumn<QString>("api");
        QTest::addColumn<int>("qt");
        QTest::addColumn<QString>("build");
        QTest::addColumn<QString>("interface");
        QTest::addColumn<QString>("error"); // a word of it; empty means it fits
        const QString build = "linux-x86_64-gnu";
        const QString reader = TAN_READER_INTERFACE;
        QTest::newRow("the same") << "1.0" << 0x060402 << build << reader << "";
        QTest::newRow("a later patch of Qt") << "1.0" << 0x060409 << build << reader << "";
        QTest::newRow("an earlier Qt") << "1.0" << 0x060200 << build << reader << "";
        QTest::newRow("a later api") << "1.1" << 0x060402 << build << reader << "newer version of TAn";
        QTest::newRow("the next major api") << "2.0" << 0x060402 << build << reader << "newer version of TAn";
        QTest::newRow("the previous major api")
            << "0.9" << 0x060402 << build << reader << "newer version of the plugin";
        QTest::newRow("a later Qt") << "1.0" << 0x060500 << build << reader << "Qt 6.5.0";
        QTest::newRow("Qt 5") << "1.0" << 0x050f02 << build << reader << "Qt 5.15.2";
        QTest::newRow("another compiler")
            << "1.0" << 0x060402 << "linux-x86_64-clang" << reader << "linux-x86_64-clang";
        QTest::newRow("no build tag") << "1.0" << 0x060402 << "" << reader << "tan_plugin()";
        QTest::newRow("another interface") << "1.0" << 0x060402 << build << "org.tan.Builder/1"
                                           << "org.tan.Builder/1";
        QTest::newRow("a later interface") << "1.0" << 0x060402 << build << "org.tan.Reader/2"
                                           << "org.tan.Reader/2";
    }
    void compatibility()
    {
        QFETCH(QString, api);
        QFETCH(int, qt);
        QFETCH(QString, build);
        QFETCH(QString, interface);
        QFETCH(QString, error);
        QJsonObject metadata = own();
        metadata["api"] = api;
        QJsonObject json = whole(metadata);
        json["version"] = qt;
        json["build"] = QJsonArray{build};
        json["IID"] = interface;
        const auto parsed = parsePluginMetadata(json);
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
        QJsonObject json = whole(metadata);
        json["IID"] = TAN_EDITOR_INTERFACE;
        const auto parsed = parsePluginMetadata(json);
        QVERIFY(parsed);
        QVERIFY(checkCompatible(*parsed, host()));
        json["IID"] = TAN_RENDERER_INTERFACE;
        QVERIFY(!checkCompatible(*parsePluginMetadata(json), host()));
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
        const auto parsed = parsePluginMetadata(whole(metadata));
        QVERIFY(parsed);
        QCOMPARE(parsed->names, (std::map<std::string, std::string>{{"de", "Leser"}, {"pt_BR", "Leitor"}}));
        QCOMPARE(parsed->descriptions, (std::map<std::string, std::string>{{"de", "Liest."}}));
    }
};

} // namespace tetra

QTEST_APPLESS_MAIN(tetra::PluginMetadataTest)
#include "plugin_metadata_test.moc"
