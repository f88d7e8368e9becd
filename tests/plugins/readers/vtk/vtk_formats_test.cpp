// SPDX-License-Identifier: GPL-3.0-or-later
// Which files are VTK's, and what is said where VTK is missing (S6). Needs no VTK.
#include "plugins/readers/vtk/vtk_format.h"
#include "tests/plugins/readers/vtk/vtk_test_files.h"

#include <QTest>

using namespace tetra;

namespace {

VtkGuess guess(const QByteArray& name, const QByteArray& start)
{
    return guessVtkFormat(name.toStdString(), std::as_bytes(std::span(start.constData(), std::size_t(start.size()))));
}

} // namespace

class VtkFormatsTest : public QObject {
    Q_OBJECT

private slots:
    void formatsAreKnownByNameAndSignature()
    {
        QVERIFY(guess("a.bin", vtiText()).format == VtkFormat::Xml);
        QVERIFY(guess("a.dat", legacyText()).format == VtkFormat::Legacy);
        QVERIFY(guess("a.unknown", "II*" + QByteArray(9, '\0')).format == VtkFormat::Tiff);
        QVERIFY(guess("IM0001", QByteArray(128, '\0') + "DICM").format == VtkFormat::Dicom);
        QVERIFY(guess("HEAD.NII.GZ", "\x1f\x8b").format == VtkFormat::Nifti);
        QVERIFY(guess("a.ex2", "CDF\1").format == VtkFormat::Exodus);
        QVERIFY(guess("a.vtu", "whatever").format == VtkFormat::Xml);
        QVERIFY(guess("a.nrrd", "NRRD0004").format == VtkFormat::None);
        QVERIFY(guess("a.csv", "x,y,z,v").format == VtkFormat::None);
        QVERIFY(guess("vtk", "x").format == VtkFormat::None);
    }

    /// Other readers' files are left to them.
    void scoresLeaveRoom()
    {
        QCOMPARE(guess("a.vtu", vtuText()).score, 0.9);
        QVERIFY(guess("a.g", "PLOT3D?").score < 0.2);
        QVERIFY(guess("a.xyz", "3 4 5\n0.1 0.2\n").score > 0.8);
        QVERIFY(guess("a.xyz", "3\nwater\nO 0 0 0\n").score < 0.2);
        QVERIFY(guess("a.xyz", "1 2 3 4\n5 6 7 8\n").score < 0.2);
        QVERIFY(guess("a.e", "no NetCDF").score < 0.2);
        QCOMPARE(guess("a.nrrd", "NRRD0004").score, 0.);
    }

    void filtersNameTheFormats()
    {
        const auto filters = VtkReader().nameFilters();
        QVERIFY(filters.size() > 10);
        for (const std::string& filter : filters)
            QVERIFY2(filter.find("(*.") != std::string::npos && filter.ends_with(')'), filter.c_str());
    }

    /// The program works without VTK, and says what to install.
    void withoutTheHelperItSaysWhatToInstall()
    {
        const VtkFolder folder;
        const VtkReader reader(folder.path() / "tan-read-vtk");
        const QByteArray text = vtuText();
        const double score =
            reader.score("a.vtu", std::as_bytes(std::span(text.constData(), std::size_t(text.size()))));
        QVERIFY(score > 0 && score < 0.5); // a reader that needs no VTK comes first
        const auto dataset = reader.read(folder.write("a.vti", vtiText()), {}, {});
        QVERIFY(!dataset.ok());
        QVERIFY2(dataset.error().text.find("apt install ./tan-vtk-readers") != std::string::npos,
                 dataset.error().text.c_str());
        QVERIFY2(dataset.error().text.find("The VTK readers are not installed") != std::string::npos,
                 dataset.error().text.c_str());
    }

    /// A helper whose libraries are missing, as the dynamic linker reports it; and one that breaks down.
    void aHelperThatFailsIsAnError()
    {
        const VtkFolder folder;
        const auto script = [&](const QByteArray& text) {
            const auto path = folder.write("helper", "#!/bin/sh\n" + text);
            std::filesystem::permissions(path, std::filesystem::perms::owner_all);
            return VtkReader(path).read(folder.write("a.vti", vtiText()), {}, {});
        };
        const auto missing = script("echo 'helper: error while loading shared libraries: libvtkIOXML-9.1.so.1: cannot "
                                    "open shared object file: No such file or directory' >&2\nexit 127\n");
        QVERIFY(!missing.ok());
        QVERIFY2(missing.error().text.find("libvtkIOXML-9.1.so.1") != std::string::npos, missing.error().text.c_str());
        QVERIFY2(missing.error().text.find("apt install libvtk9.1") != std::string::npos, missing.error().text.c_str());
        const auto crashed = script("kill -SEGV $$\n");
        QVERIFY(!crashed.ok());
        QVERIFY2(crashed.error().text.find("a.vti") != std::string::npos, crashed.error().text.c_str());
        const auto garbled = script("head -c 100000 /dev/zero\n");
        QVERIFY(!garbled.ok());
    }

    void aWrongComponentIsAMistake()
    {
        for (const Parameter& parameter : VtkReader().parameters())
            if (parameter.id == "component") {
                QVERIFY(parameter.mistake("magnitude").empty());
                QVERIFY(parameter.mistake("2").empty());
                QVERIFY(!parameter.mistake("x").empty());
                return;
            }
        QFAIL("there is no parameter 'component'");
    }
};

QTEST_GUILESS_MAIN(VtkFormatsTest)
#include "vtk_formats_test.moc"
