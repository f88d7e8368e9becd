// SPDX-License-Identifier: GPL-3.0-or-later
// Files of nodes whose places VTK rounds to single precision, read beside it: in text and binary, as they should be
// and otherwise.
#include "plugins/readers/vtk/fluent_nodes.h"
#include "plugins/readers/vtk/foam_points.h"

#include <QTemporaryDir>
#include <QTest>

#include <zlib.h>

#include <filesystem>
#include <fstream>

using namespace tetra;
namespace fs = std::filesystem;

namespace {

const std::vector<double> places{0.1, -2000000.7, 3e-9, 1.23456789012345, 5, -0.0};

std::string bytesOf(const std::vector<double>& numbers)
{
    return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double)};
}

std::string foamHeader(const std::string& more)
{
    return "/*--- (a banner) ---*/\nFoamFile\n{\n    version 2.0;\n    " + more +
           "    class vectorField;\n    object points;\n}\n// * * * //\n\n";
}

const std::string foamText =
    foamHeader("format ascii;\n") + "2\n(\n(0.1 -2000000.7 3e-9)\n(1.23456789012345 5 -0)\n)\n\n// ***** //\n";

} // namespace

class ExactPlacesTest : public QObject {
    Q_OBJECT

private slots:
    void pointsOfOpenFoam()
    {
        const std::string binary =
            foamHeader("format binary;\n    arch \"LSB;label=32;scalar=64\";\n") + "2\n(" + bytesOf(places) + ")\n";
        for (const std::string& content : {foamText, binary}) {
            QVERIFY(readFoamPoints(write(content), 2) == places);
            QVERIFY(readFoamPoints(write(content), 100) == places);
            QVERIFY(!readFoamPoints(write(content), 1));
            QVERIFY(!readFoamPoints(
                write(content.substr(0, content.find("-2000000") == std::string::npos ? content.size() - 12
                                                                                      : content.find("5 -0"))),
                2));
        }
        const std::string packed = folder_.filePath("points.gz").toStdString();
        const gzFile file = gzopen(packed.c_str(), "wb");
        gzwrite(file, foamText.data(), unsigned(foamText.size()));
        gzclose(file);
        QVERIFY(readFoamPoints(packed, 2) == places);
    }

    void whatIsNoFileOfPointsIsNone()
    {
        for (const std::string& content :
             {std::string(), std::string("2\n((0 0 0)(1 1 1))"), foamHeader("format ascii;\n"),
              foamHeader("format ascii;\n") + "2{(0 0 0)}", foamHeader("format ascii;\n") + "2((0 0 0)(1 x 1))",
              foamHeader("format ascii;\n") + "18446744073709551615((0 0 0))",
              foamHeader("format binary;\n arch \"LSB;label=32;scalar=32\";\n") + "2\n(" + bytesOf(places) + ")",
              std::string("FoamFile { format ascii;"), std::string("/* FoamFile")})
            QVERIFY2(!readFoamPoints(write(content), 2), content.c_str());
        QVERIFY(!readFoamPoints(folder_.filePath("missing").toStdString(), 2));
    }

    void nodesOfFluent()
    {
        const std::string text = "(0 \"a case\")\n(2 3)\n(10 (0 1 2 0 3))\n(10 (1 2 2 1 3)(\n1.23456789012345 5 "
                                 "-0\n))\n(10 (2 1 1 1 3)\n(\n0.1 -2000000.7 3e-9))\n(12 (0 1 1 0))\n";
        QVERIFY(readFluentNodes(text, 2) == places);
        const std::string binary =
            "(10 (0 1 2 0 3))\n(3010 (1 1 2 1 3)\n(" + bytesOf(places) + ")\nEnd of Binary Section   3010)\n";
        QVERIFY(readFluentNodes(binary, 2) == places);
        QVERIFY(!readFluentNodes(text, 3));
        QVERIFY(!readFluentNodes(text, 1));
        QVERIFY(!readFluentNodes(text.substr(0, text.find("3e-9")), 2));
        QVERIFY(!readFluentNodes(binary.substr(0, 50), 2));
        QVERIFY(!readFluentNodes("(10 (1 0 1 1 3)(0 0 0 1 1 1))", 2));
        QVERIFY(!readFluentNodes("(10 (1 1 2 1 2)(0 0 1 1))", 2)); // in a plane
        QVERIFY(!readFluentNodes("(10 (", 1));
        QVERIFY(!readFluentNodes("", 1));
    }

private:
    fs::path write(const std::string& content)
    {
        const fs::path path = folder_.filePath("points").toStdString();
        std::ofstream(path, std::ios::binary) << content;
        return path;
    }

    QTemporaryDir folder_;
};

QTEST_GUILESS_MAIN(ExactPlacesTest)
#include "exact_places_test.moc"
