// SPDX-License-Identifier: GPL-3.0-or-later
/// D3: tables as other programs export them: which columns are the places and the values is found by their names and
/// told. Every value is a function of its place, and every other column is something else.
#include "plugins/readers/points/point_reader.h"
#include "plugins/readers/points/units.h"
#include "tests/lacks.h"
#include "tests/plugins/as_loaded.h"
#include "tests/plugins/readers/world_function.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace tetra;

namespace {

constexpr double scale = 10;
constexpr int pointCount = 60;

/// A place for each row, not in the order of any coordinate.
Eigen::Vector3d placeOf(int row)
{
    return {(row * 7 % 60) * 0.5 - 3, (row * 11 % 60) * 0.25 + 1, (row * 13 % 60) * 0.125 - 2};
}

/// Rows of the columns that `kinds` names: x, y, z, v the value, w another quantity, i a counter from 0, j from 1, k
/// whole numbers in another order, c a constant, t a text, e nothing.
QByteArray rows(const QByteArray& kinds, const QByteArray& separator, int first = 0, int last = pointCount)
{
    QByteArray text;
    for (int row = first; row < last; ++row) {
        const Eigen::Vector3d place = placeOf(row);
        for (qsizetype column = 0; column < kinds.size(); ++column) {
            const auto number = [](double value) { return QByteArray::number(value, 'g', 17); };
            text += column > 0 ? separator : QByteArray();
            switch (kinds[column]) {
            case 'x': text += number(place[0]); break;
            case 'y': text += number(place[1]); break;
            case 'z': text += number(place[2]); break;
            case 'v': text += number(worldFunction(place, scale)); break;
            case 'w': text += number(1000 + row * 17 % 60 + 0.25); break;
            case 'i': text += QByteArray::number(row); break;
            case 'j': text += QByteArray::number(row + 1); break;
            case 'k': text += QByteArray::number((row * 23 + 5) % 60); break;
            case 'c': text += "7"; break;
            case 't': text += "2020-01-01T00:00:00Z"; break;
            default: break;
            }
        }
        text += "\n";
    }
    return text;
}

QString textOf(const std::vector<Taken>& taken)
{
    QStringList texts;
    for (const Taken& part : taken)
        texts << QString::fromStdString(takenText(part).text());
    return texts.join("; ");
}

QString textOf(const std::vector<Message>& messages)
{
    QStringList texts;
    for (const Message& message : messages)
        texts << QString::fromStdString(message.text());
    return texts.join(" ");
}

} // namespace

class PointColumnsTest : public QObject {
    Q_OBJECT

private:
    std::filesystem::path write(const QByteArray& content, const char* name = "points.csv")
    {
        const QString path = folder_.filePath(name);
        QFile file(path);
        if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size())
            qFatal("cannot write %s", qPrintable(path));
        return path.toStdString();
    }

    /// Read and judged: all places, the function there; probe() says what read() does.
    void check(const std::filesystem::path& path, const ParameterValues& values, const QString& taken,
               const QString& leftOut, std::uint64_t points = pointCount)
    {
        const Reader& reader = asLoaded<PointReader>();
        const auto dataset = reader.read(path, values, {});
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QCOMPARE(dataset->pointCount(), points);
        QVERIFY2(distanceFromWorld(*dataset, scale) < 1e-12, qPrintable(textOf(dataset->source.taken)));
        QCOMPARE(textOf(dataset->source.taken), taken);
        QCOMPARE(textOf(dataset->source.leftOut), leftOut);
        const auto contents = reader.probe(path, values, {});
        QVERIFY(contents);
        QCOMPARE(textOf(contents->taken), taken);
        QCOMPARE(textOf(contents->leftOut), leftOut);
    }

    QTemporaryDir folder_;

private slots:
    void exportsOfOtherProgramsAreUnderstood_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("taken");
        QTest::addColumn<QString>("length");
        QTest::addColumn<QString>("leftOut");
        const auto row = [](const char* name, const QByteArray& text, const char* taken, const char* length = "",
                            const char* leftOut = "") {
            QTest::newRow(name) << text << QString(taken) << QString(length) << QString(leftOut);
        };
        row("pandas", ",x,y,z,temperature\n" + rows("ixyzv", ","), "array: temperature; places: x, y, z");
        row("pandas, no names", ",0,1,2,3\n" + rows("ixyzv", ","),
            "array: column 5 (a guess); places: column 2, column 3, column 4 (a guess)");
        row("Fluent",
            "nodenumber,    x-coordinate,    y-coordinate,    z-coordinate,     temperature\n" + rows("jxyzv", ",    "),
            "array: temperature; places: x-coordinate, y-coordinate, z-coordinate");
        row("Fluent, cells", "cellnumber x-coordinate y-coordinate z-coordinate pressure\n" + rows("jxyzv", " "),
            "array: pressure; places: x-coordinate, y-coordinate, z-coordinate");
        row("Mechanical",
            "Node Number\tX Location (mm)\tY Location (mm)\tZ Location (mm)\tEquivalent Stress (MPa)\n" +
                rows("kxyzv", "\t"),
            "array: Equivalent Stress; places: X Location, Y Location, Z Location; unit of the values: MPa", "mm");
        row("CFX", "\n[Name]\nPlane 1\n\n[Data]\nX [ m ], Y [ m ], Z [ m ], Temperature [ K ]\n" + rows("xyzv", ", "),
            "array: Temperature; places: X, Y, Z; unit of the values: K", "m");
        row("CFX, two parts and faces",
            "[Name]\nPlane 1\n\n[Data]\nNode Number, X [ m ], Y [ m ], Z [ m ], Pressure [ Pa ]\n" +
                rows("ixyzv", ", ", 0, 20) + "\n[Faces]\n0, 1, 2\n1, 2, 3\n\n[Name]\nPlane 2\n\n[Data]\n" +
                "Node Number, X [ m ], Y [ m ], Z [ m ], Pressure [ Pa ]\n" + rows("ixyzv", ", ", 20) +
                "\n[Faces]\n20, 21, 22\n21, 22, 23\n",
            "array: Pressure; places: X, Y, Z; unit of the values: Pa", "m", "Its section '[Faces]' is not read.");
        row("ParaView's spreadsheet",
            "\"Block Number\",\"Point ID\",\"p\",\"Points_0\",\"Points_1\",\"Points_2\",\"Points_Magnitude\"\n" +
                rows("civxyzw", ","),
            "array: p; places: Points_0, Points_1, Points_2");
        row("ParaView's ids",
            "\"vtkOriginalPointIds\",\"Points:0\",\"Points:1\",\"Points:2\",\"p\"\n" + rows("kxyzv", ","),
            "array: p; places: Points:0, Points:1, Points:2");
        row("STAR-CCM+", "\"Temperature (K)\",\"X (m)\",\"Y (m)\",\"Z (m)\"\n" + rows("vxyz", ","),
            "array: Temperature; places: X, Y, Z; unit of the values: K", "m");
        row("COMSOL",
            "% Model:   a.mph\n% Dimension:  3\n% Nodes:   60\n% Length unit:        mm\n"
            "% x                       y                        z                        T (K)\n" +
                rows("xyzv", "      "),
            "array: T; places: x, y, z; unit of the values: K", "mm");
        row("COMSOL, a time",
            "% x                 y                  z               p (Pa) @ t=2\n" + rows("xyzv", "   "),
            "array: p (Pa) @ t=2; places: x, y, z");
        row("Abaqus", "COORD1 COORD2 COORD3 S\n" + rows("xyzv", " "), "array: S; places: COORD1, COORD2, COORD3");
        row("ERDDAP",
            "time,latitude,longitude,depth,sea_temp\nUTC,degrees_north,degrees_east,m,degree_C\n" + rows("tyxzv", ","),
            "array: sea_temp; places: longitude, latitude, depth; unit of the values: degree_C", "",
            "Its coordinates are in different units (degrees_east, degrees_north, m) and are used as they are. Its "
            "depths ('depth') are used for z as they are: if they are positive, the data are upside down.");
        row("R", "\"x\" \"y\" \"z\" \"v\"\n" + rows("jxyzv", " "), "array: v; places: x, y, z");
        row("a trailing comma", "x,y,z,v,\n" + rows("xyzve", ","), "array: v; places: x, y, z");
        row("a trailing comma of rows", "x,y,z,v\n" + rows("xyzve", ","), "array: v; places: x, y, z");
        row("units below", "x;y;z;T\nm;m;m;K\n" + rows("xyzv", ";"), "array: T; places: x, y, z; unit of the values: K",
            "m");
        row("units in brackets below", "id,x,y,z,T\n-,[km],[km],[km],[deg C]\n" + rows("kxyzv", ","),
            "array: T; places: x, y, z; unit of the values: deg C", "km");
        row("units between blanks", "x (m) y (m) z (m) T (K)\n" + rows("xyzv", " "),
            "array: T; places: x, y, z; unit of the values: K", "m");
        row("projected", "id,Easting,Northing,Elevation,Cu_ppm\n" + rows("kxyzv", ","),
            "array: Cu_ppm; places: Easting, Northing, Elevation");
        row("coordinates last, a constant first", "p,T,x,y,z\n" + rows("cvxyz", ","), "array: T; places: x, y, z");
        row("two quantities", "x,y,z,T,p\n" + rows("xyzvw", ","), "array: T (a guess); places: x, y, z");
        row("two units of one quantity", "x,y,z,T (K),T (C)\n" + rows("xyzvw", ","),
            "array: T (K) (a guess); places: x, y, z; unit of the values: K");
        row("rises by one", "x,y,z,number of it,T\n" + rows("xyziv", ","), "array: T (a guess); places: x, y, z");
        row("two systems", "lon,lat,depth,x,y,z,T\n" + rows("wwwxyzv", ","), "array: T (a guess); places: x, y, z");
        row("a text", "x,y,z,name,T\n" + rows("xyztv", ","), "array: T; places: x, y, z");
        row("a year among the names", "x,y,z,2019\n" + rows("xyzv", ","), "array: 2019; places: x, y, z");
        row("a velocity is no place", "x velocity,y velocity,z velocity,X,Y,Z,T\n" + rows("cccxyzv", ","),
            "array: T; places: X, Y, Z");
        row("no names", rows("xyzv", " "), "array: column 4 (a guess); places: column 1, column 2, column 3 (a guess)");
        row("no names, a counter", rows("jxyzv", " "),
            "array: column 5 (a guess); places: column 2, column 3, column 4 (a guess)");
        row("no names, a constant", rows("xyzcv", " "),
            "array: column 5 (a guess); places: column 1, column 2, column 3 (a guess)");
        row("a comment of four words", "# made by hand yesterday\n" + rows("xyzv", " "),
            "array: yesterday (a guess); places: made, by, hand (a guess)");
        row("GSLIB", "Copper of a mine\n5 20 30 40\nX\nY\nZ\nhole id\nCu (ppm)\n" + rows("xyzkv", " "),
            "array: Cu; places: X, Y, Z; unit of the values: ppm");
        row("GSLIB, the title a comment",
            "# of a mine\n4\nEasting (m)\nNorthing (m)\nRL (m)\nGrade\n" + rows("xyzv", "  "),
            "array: Grade; places: Easting, Northing, RL", "m");
        row("Leica", "60\n" + rows("xyzvccc", " "),
            "array: column 4 (a guess); places: column 1, column 2, column 3 (a guess)");
        row("Leica, two scans", "20\n" + rows("xyzv", " ", 0, 20) + "40\n" + rows("xyzv", " ", 20),
            "array: column 4 (a guess); places: column 1, column 2, column 3 (a guess)");
    }
    void exportsOfOtherProgramsAreUnderstood()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, taken);
        QFETCH(QString, length);
        QFETCH(QString, leftOut);
        const auto path = write(text, "table.dat");
        check(path, {}, taken, leftOut);
        const auto dataset = asLoaded<PointReader>().read(path, {}, {});
        QVERIFY(dataset);
        QCOMPARE(QString::fromStdString(dataset->lengthUnit), length);
        const auto contents = asLoaded<PointReader>().probe(path, {}, {});
        QCOMPARE(contents->untold.empty(), !length.isEmpty());
        QVERIFY(asLoaded<PointReader>().score(path, std::as_bytes(std::span(text.data(), 400))) > 0.5);
    }

    void placesAreKnownByTheirNames_data()
    {
        QTest::addColumn<QByteArray>("names");
        for (const char* names : {"x,y,z",
                                  "X,Y,Z",
                                  "x (m),y (m),z (m)",
                                  "x_m,y_m,z_m",
                                  "Points:0,Points:1,Points:2",
                                  "Points_0,Points_1,Points_2",
                                  "x-coordinate,y-coordinate,z-coordinate",
                                  "x coordinate,y coordinate,z coordinate",
                                  "X Coordinate (m),Y Coordinate (m),Z Coordinate (m)",
                                  "x location,y location,z location",
                                  "coord_x,coord_y,coord_z",
                                  "coords_x,coords_y,coords_z",
                                  "pos_x,pos_y,pos_z",
                                  "position x,position y,position z",
                                  "PosX,PosY,PosZ",
                                  "xcoord,ycoord,zcoord",
                                  "xCoord,yCoord,zCoord",
                                  "Node X,Node Y,Node Z",
                                  "[X],[Y],[Z]",
                                  "cx,cy,cz",
                                  "xc,yc,zc",
                                  "x_utm,y_utm,z_utm",
                                  "Position[0],Position[1],Position[2]",
                                  "pos.x,pos.y,pos.z",
                                  "Centroid X [mm],Centroid Y [mm],Centroid Z [mm]",
                                  "x/m,y/m,z/m",
                                  "X / m,Y / m,Z / m",
                                  "x,y,depth",
                                  "X,Y,Elevation (m)",
                                  "easting,northing,height",
                                  "UTM_Easting,UTM_Northing,Altitude",
                                  "EASTING,NORTHING,RL",
                                  "lon,lat,depth",
                                  "Longitude,Latitude,Altitude (m)",
                                  "longitude_deg,latitude_deg,minus_depth_km",
                                  "decimalLongitude,decimalLatitude,depth",
                                  "lon,lat,level",
                                  "long,lat,z",
                                  "coordinates 0,coordinates 1,coordinates 2",
                                  "x_start,y_start,z_start"})
            QTest::newRow(names) << QByteArray(names);
    }
    void placesAreKnownByTheirNames()
    {
        QFETCH(QByteArray, names);
        const QByteArrayList axes = names.split(',');
        const QByteArray text = "Q," + axes[2] + ",node," + axes[0] + "," + axes[1] + "\n" + rows("vzixy", ",");
        const auto dataset = asLoaded<PointReader>().read(write(text), {}, {});
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QCOMPARE(dataset->source.valueName, std::string("Q"));
        QVERIFY(distanceFromWorld(*dataset, scale) < 1e-12);
        QCOMPARE(dataset->position(3), placeOf(3));
    }

    void countersAreKnownByTheirNames()
    {
        for (const char* name : {"",
                                 "#",
                                 "id",
                                 "ID",
                                 "index",
                                 "node",
                                 "Node Number",
                                 "nodenumber",
                                 "point id",
                                 "PointId",
                                 "Point ID",
                                 "Block Number",
                                 "Cell ID",
                                 "element",
                                 "row",
                                 "number",
                                 "Unnamed: 0",
                                 "vtkOriginalPointIds",
                                 "GlobalNodeId",
                                 "Element No",
                                 "Node ID [ ]",
                                 "cell-partition",
                                 "sample_id"}) {
            const QByteArray text = QByteArray(name) + ",x,y,z,Q,R\n" + rows("kxyzvw", ",");
            const auto dataset = asLoaded<PointReader>().read(write(text), {}, {});
            QVERIFY2(dataset && dataset->source.valueName == "Q", name);
        }
        for (const char* name : {"Mach number", "Refractive index", "temperature", "U:0"}) {
            const QByteArray text = QByteArray(name) + ",x,y,z,R\n" + rows("vxyzw", ",");
            const auto dataset = asLoaded<PointReader>().read(write(text), {}, {});
            QVERIFY2(dataset && dataset->source.valueName == name, name);
        }
    }

    void whatIsLeftIsTakenAsAGuess()
    {
        const auto taken = [&](const QByteArray& names, const QByteArray& kinds) {
            const auto dataset = asLoaded<PointReader>().read(write(names + "\n" + rows(kinds, ",")), {}, {});
            return dataset ? QString::fromStdString(takenText(dataset->source.taken[0]).text())
                           : QString::fromStdString(dataset.error().text());
        };
        QCOMPARE(taken("x,y,z,id", "xyzk"), "array: id (a guess)");
        QCOMPARE(taken("x,y,z,T", "xyzc"), "array: T (a guess)");
        QCOMPARE(taken("x,y,z,T", "xyzi"), "array: T (a guess)");
        QCOMPARE(taken("x,y,z,id,T", "xyzkc"), "array: T (a guess)");
        QCOMPARE(taken("x,y,z,T,S", "xyzci"), "array: S (a guess)");
        QCOMPARE(taken("x,y,z,depth", "xyzw"), "array: depth");
        QCOMPARE(taken("x,y,z,time,T", "xyzww"), "array: T (a guess)");
    }

    void namesWithoutPlacesAreRefused()
    {
        const auto path = write("id,easting,northing,Cu_ppm\n" + rows("kxyv", ","));
        for (const bool probed : {false, true}) {
            const auto error = probed ? asLoaded<PointReader>().probe(path, {}, {}).error()
                                      : asLoaded<PointReader>().read(path, {}, {}).error();
            QCOMPARE(error.kind, ErrorKind::WrongUsage); // the window asks
            QCOMPARE(QString::fromStdString(error.text()).section("points.csv': ", 1),
                     QString("which of its columns are x, y and z? It has 'id', 'easting', 'northing', 'Cu_ppm'. Name "
                             "three of them with '--positions', or in Import Options, as in --positions 1,2,3."));
        }
        const auto texts = asLoaded<PointReader>().read(write("Name,City,Age,Street\na,b,3,c\nd,e,4,f\n"), {}, {});
        QVERIFY(
            QString::fromStdString(texts.error().text())
                .endsWith("it has numbers in 1 of its columns, and points need at least four: x, y, z and a value."));
        QVERIFY(!asLoaded<PointReader>().read(write("ux,uy,uz,T\n" + rows("xyzv", ",")), {}, {}));
    }

    void whoChoosesIsNotTold()
    {
        const auto path = write("a,b,c,T (K),T (C),id\n" + rows("yxzwvk", ","));
        const auto chosen = [](const char* array) {
            return ParameterValues{{"positions", std::string("b,a,c")}, {"array", std::string(array)}};
        };
        check(path, chosen("T (C)"), "array: T (C); places: b, a, c; unit of the values: C", "");
        check(path, chosen("5"), "array: T (C); places: b, a, c; unit of the values: C", "");
        for (const char* name : {"q", "Q K", "q (K)", "Q [K]", "Q [ K ]"})
            check(write(",x,y,z,S (C),Q (K)\n" + rows("kxyzwv", ",")), {{"array", std::string(name)}},
                  "array: Q; places: x, y, z; unit of the values: K", "");
        QVERIFY(!asLoaded<PointReader>().read(path, chosen("T (Pa)"), {}));
        QVERIFY(!asLoaded<PointReader>().read(path, chosen("T Pa"), {}));
    }

    void columnsAreListedWithTheirUnits()
    {
        const auto path = write(",name,x (mm),y (mm),z (mm),T (K),p [Pa]\n" + rows("itxyzvw", ","));
        const auto contents = asLoaded<PointReader>().probe(path, {}, {});
        QVERIFY(contents);
        QCOMPARE(contents->arrays.size(), std::size_t(3)); // no text
        QCOMPARE(contents->arrays[0].name, std::string("column 1"));
        QCOMPARE(contents->arrays[1].name, std::string("T"));
        QCOMPARE(contents->arrays[1].unit, std::string("K"));
        QCOMPARE(contents->arrays[2].unit, std::string("Pa"));
        QVERIFY(asLoaded<PointReader>().read(path, {{"array", std::string("column 1")}}, {}));
        const auto dataset = asLoaded<PointReader>().read(path, {{"unit", std::string("cm")}}, {});
        QCOMPARE(dataset->lengthUnit, std::string("cm"));
    }

    /// A counter has no unit, which leaves no trace between blanks.
    void unitsBelowTheNamesMayLackThatOfTheCounter()
    {
        const QString taken = "array: T; places: x, y, z; unit of the values: K";
        for (const char* units : {"- m m m K", "m m m K", "[m] [m] [m] [K]", "(-) (m) (m) (m) (K)"}) {
            const auto path = write(QByteArray("nodenumber x y z T\n") + units + "\n" + rows("jxyzv", " "));
            check(path, {}, taken, "");
            QCOMPARE(asLoaded<PointReader>().read(path, {}, {})->lengthUnit, std::string("m"));
        }
        check(write("nodenumber,x,y,z,T,\n,m,m,m,K,\n" + rows("jxyzve", ",")), {}, taken, "");
        check(write("nodenumber x y z T S\nm m m K\n" + rows("jxyzvw", " ")), {}, "array: T (a guess); places: x, y, z",
              "The line of units below its names has 4 of them for 6 columns.");
        check(write("x y z T\nm m m\n" + rows("xyzv", " ")), {}, "array: T; places: x, y, z",
              "The line of units below its names has 3 of them for 4 columns.");
    }

    /// What is found in the first rows must not depend on how many there are.
    void longTablesAreJudgedByTheirFirstRows()
    {
        QByteArray text = "x,y,z,a,T\n";
        for (int row = 0; row < 10'050; ++row) // a varies only behind what is looked at
            text += QByteArray::number(row % 100) + "," + QByteArray::number(row / 100) + "," +
                    QByteArray::number(row * 7 % 10) + "," + (row < 10'010 ? "1" : "2") + "," +
                    QByteArray::number(row * 0.5) + "\n";
        const auto path = write(text);
        const auto dataset = asLoaded<PointReader>().read(path, {}, {});
        QVERIFY(dataset);
        QCOMPARE(dataset->source.valueName, std::string("T"));
        const auto contents = asLoaded<PointReader>().probe(path, {}, {});
        QVERIFY(contents->taken == dataset->source.taken);
    }

    void scansAreCounted()
    {
        const auto mistake = [&](const QByteArray& text) {
            const auto read = asLoaded<PointReader>().read(write(text, "a.pts"), {}, {});
            return read ? QString() : QString::fromStdString(read.error().text()).section("a.pts': ", 1);
        };
        QCOMPARE(mistake("60\n" + rows("xyzv", " ", 0, 59)),
                 "line 1 announces 60 points, and there are 59. The copy may be incomplete: copy the file again.");
        QCOMPARE(mistake("59\n" + rows("xyzv", " ")), "line 1 announces 59 points, and there are more.");
        QCOMPARE(mistake("20\n" + rows("xyzv", " ", 0, 20) + "40\n" + rows("xyzv", " ", 20, 50)),
                 "line 22 announces 40 points, and there are 30. The copy may be incomplete: copy the file again.");
        const auto two = asLoaded<PointReader>().read(
            write("20\n" + rows("xyzv", " ", 0, 20) + "40\n" + rows("xyzv", " ", 20), "a.pts"), {}, {});
        QCOMPARE(textOf(two->remarks), "The points of its 2 parts were put together.");
        QVERIFY(mistake("[Name]\nPlane\n").contains("no section '[Data]'"));
        QVERIFY(mistake("[Data]\nx,y,z,T\n" + rows("xyzv", ",") + "[Data]\nx,y,z\n1,2,3\n").contains("has 3 columns"));
    }

    void unitsAreKnown()
    {
        for (const char* unit : {"m", "mm", "kg/m^3", "m/s", "W m-2", "deg C", "degC",
                                 "\xc2\xb0"
                                 "C",
                                 "K", "MPa", "degrees_north", "kg m^-3", "m s^-1", "J kg^-1 K^-1", "ppm", "%", "ft"})
            QVERIFY2(isUnit(unit), unit);
        for (const char* text : {"", "magnitude", "component 0", "1", "mean", "x", "UTM"})
            QVERIFY2(!isUnit(text), text);
        for (const char* unit : {"m", "mm", "km", "um", "ft", "metres", "inch", "millimeters"})
            QVERIFY2(isLengthUnit(unit), unit);
        for (const char* unit : {"K", "s", "deg", "Pa", "hot", "min"})
            QVERIFY2(!isLengthUnit(unit), unit);
    }

    void sharedTablesAreRead_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("taken");
        QTest::addColumn<double>("least");
        QTest::addColumn<double>("most");
        const auto row = [](const char* file, const char* taken, double least, double most) {
            QTest::newRow(file) << file << taken << least << most;
        };
        row("pandas_index.csv", "array: temperature; places: x, y, z", 2, 34.4102586);
        row("cfx.csv", "array: Temperature; places: X, Y, Z; unit of the values: K", 2, 34.4102586);
        row("paraview_export.csv", "array: temperature; places: Points_0, Points_1, Points_2", 2, 34.4102586);
        row("ansys.txt", "array: Total Deformation; places: X Location, Y Location, Z Location; unit of the values: mm",
            7.75655, 65.8716);
        row("units.csv", "array: T; places: x, y, z; unit of the values: K", 7.75655, 65.8716);
        row("coords_last.csv", "array: T; places: x, y, z", 7.75655, 65.8716);
        row("leica.pts", "array: column 4 (a guess); places: column 1, column 2, column 3 (a guess)", 200, 3441);
    }
    void sharedTablesAreRead()
    {
        QFETCH(QString, file);
        QFETCH(QString, taken);
        QFETCH(double, least);
        QFETCH(double, most);
        const auto path = sharedCases() / "tables" / file.toStdString();
        if (!std::filesystem::exists(path))
            QSKIP_WITHOUT("cases of tables");
        const auto dataset = asLoaded<PointReader>().read(path, {}, {});
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QCOMPARE(textOf(dataset->source.taken), taken);
        QVERIFY(std::abs(dataset->values.range().minimum - least) < 1e-5);
        QVERIFY(std::abs(dataset->values.range().maximum - most) < 1e-4);
    }
};

QTEST_GUILESS_MAIN(PointColumnsTest)
#include "point_columns_test.moc"
