// SPDX-License-Identifier: GPL-3.0-or-later
// What only the compiled core tells: which functions its objects share, and which of the system's they call.
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

namespace {

struct ObjectFile {
    QString path;
    bool fast = false; ///< its arithmetic may give other results than that of the rest
};

bool changesResults(const QStringList& options)
{
    static const QStringList fast = {"-ffast-math",
                                     "-Ofast",
                                     "-funsafe-math-optimizations",
                                     "-ffinite-math-only",
                                     "-fno-signed-zeros",
                                     "-fassociative-math",
                                     "-freciprocal-math"};
    const qsizetype contracted = options.lastIndexOf("-ffp-contract=fast");
    return contracted > options.lastIndexOf("-ffp-contract=off") ||
           std::ranges::any_of(fast, [&](const QString& option) { return options.contains(option); });
}

/// Those that were made for the library, by the list of all commands of the build.
QList<ObjectFile> objectsOfCore()
{
    QFile file(TAN_BINARY_DIR "/compile_commands.json");
    if (!file.open(QIODevice::ReadOnly))
        return {};
    QList<ObjectFile> objects;
    for (const QJsonValue& entry : QJsonDocument::fromJson(file.readAll()).array()) {
        const QStringList words = QProcess::splitCommand(entry["command"].toString());
        const QString object = words.value(words.indexOf("-o") + 1);
        const QString path = entry["directory"].toString() + "/" + object;
        if (object.contains("/tan-core-objects.dir/") && QFileInfo::exists(path))
            objects << ObjectFile{path, changesResults(words)};
    }
    return objects;
}

QString outputOf(const QString& program, const QStringList& arguments)
{
    QProcess process;
    process.start(program, arguments);
    return process.waitForFinished(-1) && process.exitCode() == 0 ? QString::fromUtf8(process.readAllStandardOutput())
                                                                  : QString();
}

/// The symbols of a kind, by nm's letters, and the objects that have them.
QMap<QString, QStringList> symbolsOf(const QStringList& objects, const QString& kinds)
{
    QMap<QString, QStringList> found;
    static const QRegularExpression line("^(.+): (\\S+) ([A-Za-z])\\b");
    for (const QString& text : outputOf(TAN_NM, QStringList{"-A", "-P"} + objects).split('\n'))
        if (const auto match = line.match(text); match.hasMatch() && kinds.contains(match.captured(3)))
            found[match.captured(2)] << match.captured(1);
    return found;
}

/// Whether a function of an object adds, compares or converts floating-point numbers. Of processors whose instructions
/// are not known here all do.
bool calculates(const QString& object, const QString& function)
{
    static const QRegularExpression arithmetic("\\bv?(add|sub|mul|div|sqrt|min|max|cmp\\w*|u?comi|fn?m(add|sub)\\w*|"
                                               "round|cvt\\w*)[sp][sd]\\b|\\bf(add|mul|sub|div|"
                                               "u?comi)p?");
    const QString code = outputOf(TAN_OBJDUMP, {"-d", "--no-show-raw-insn", "--disassemble=" + function, object});
    return !code.contains("file format elf64-x86-64") || code.contains(arithmetic);
}

/// Inline functions with arithmetic that are in an object of fast arithmetic and in another one, of which the linker
/// keeps either; those of other libraries may be in any program.
QStringList sharedFunctions(const QList<ObjectFile>& objects)
{
    QStringList fast, others, shared;
    for (const ObjectFile& object : objects)
        (object.fast ? fast : others) << object.path;
    if (fast.isEmpty())
        return {};
    const auto ofOthers = symbolsOf(others, "W"), ofFast = symbolsOf(fast, "W");
    for (const QString& function : ofFast.keys()) {
        const bool inOthers = ofOthers.contains(function);
        if ((inOthers || !function.contains("5tetra")) &&
            (calculates(ofFast[function].first(), function) ||
             (inOthers && calculates(ofOthers[function].first(), function))))
            shared << function + ": " + (ofFast[function] + ofOthers[function]).join(", ");
    }
    return shared;
}

} // namespace

class ObjectFilesTest : public QObject {
    Q_OBJECT

private slots:
    void theirOwnFunctionsAloneAreFast()
    {
        if (!TAN_OPTIMISED)
            QSKIP("skipped: the compiler was not asked to inline anything");
        const QList<ObjectFile> objects = objectsOfCore();
        QVERIFY(std::ranges::count(objects, true, &ObjectFile::fast) >= 8);
        QVERIFY(std::ranges::count(objects, false, &ObjectFile::fast) >= 8);
        const QStringList shared = sharedFunctions(objects);
        QVERIFY2(shared.isEmpty(), qPrintable("\n" + shared.join("\n")));
    }

    void findsTheFunctionThatIsShared_data()
    {
        QTest::addColumn<QString>("option");
        QTest::addColumn<QString>("type");
        QTest::addColumn<bool>("found");
        QTest::newRow("finite numbers only") << "-ffinite-math-only"
                                             << "double" << true;
        QTest::newRow("fused") << "-ffp-contract=fast"
                               << "float" << true;
        QTest::newRow("the same arithmetic") << "-fno-math-errno"
                                             << "double" << false;
        QTest::newRow("no floating-point numbers") << "-ffp-contract=fast"
                                                   << "int" << false;
    }
    void findsTheFunctionThatIsShared()
    {
        QFETCH(QString, option);
        QFETCH(QString, type);
        QFETCH(bool, found);
        const QTemporaryDir folder;
        QList<ObjectFile> objects;
        for (const char* name : {"one", "other"}) {
            QFile source(folder.filePath(name + QString(".cpp")));
            QVERIFY(source.open(QIODevice::WriteOnly));
            const QString code("inline %1 both(%1 x) { return x * x + x; }\n%1 %2(%1 x) { return both(x); }\n");
            source.write(code.arg(type, name).toUtf8());
            source.close();
            const QString object = folder.filePath(name + QString(".o"));
            QStringList options = {"-O0", "-ffp-contract=off", "-c", source.fileName(), "-o", object};
            if (objects.isEmpty())
                options.insert(2, option);
            QCOMPARE(QProcess::execute(TAN_COMPILER, options), 0);
            objects << ObjectFile{object, changesResults(options)};
        }
        const QStringList shared = sharedFunctions(objects);
        QCOMPARE(shared.size(), found ? 1 : 0);
        QVERIFY(!found || shared.first().contains("both"));
    }

    /// Numbers have a decimal point and errors are English in every country.
    void nothingFollowsTheLocale()
    {
        QStringList objects;
        for (const ObjectFile& object : objectsOfCore())
            objects << object.path;
        QVERIFY(!objects.isEmpty());
        const auto called = symbolsOf(objects, "U");
        QVERIFY(called.contains("memcpy")); // so they are found
        for (const char* function : {"strerror",
                                     "strerror_r",
                                     "strerror_l",
                                     "__xpg_strerror_r",
                                     "setlocale",
                                     "printf",
                                     "fprintf",
                                     "sprintf",
                                     "snprintf",
                                     "vsnprintf",
                                     "__printf_chk",
                                     "__fprintf_chk",
                                     "__sprintf_chk",
                                     "__snprintf_chk",
                                     "__vsnprintf_chk",
                                     "strtod",
                                     "strtof",
                                     "strtold",
                                     "atof",
                                     "sscanf",
                                     "__isoc99_sscanf",
                                     "_ZNSolsEd",
                                     "_ZNSo9_M_insertIdEERSoT_",
                                     "_ZNSirsERd",
                                     "_ZNSi10_M_extractIdEERSiRT_"})
            QVERIFY2(!called.contains(function), qPrintable(QString(function) + ": " + called[function].join(", ")));
    }
};

QTEST_GUILESS_MAIN(ObjectFilesTest)
#include "object_files_test.moc"
