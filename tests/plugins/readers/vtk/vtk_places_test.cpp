// SPDX-License-Identifier: GPL-3.0-or-later
// The samples of lattices that VTK reads lie in the world where their files say (D1), in the order of the file.
#include "plugins/readers/vtk/checks/metaimage_header.h"
#include "tests/lacks.h"
#include "tests/plugins/as_loaded.h"
#include "tests/plugins/readers/vtk/vtk_test_files.h"
#include "tests/plugins/readers/world_function.h"

#include <QTest>

using namespace tetra;
namespace fs = std::filesystem;

namespace {

constexpr std::array<std::uint32_t, 3> testSize{3, 4, 2};

QByteArray numbersText(const double* numbers, int count)
{
    QByteArray text;
    for (int i = 0; i < count; ++i)
        text += (i > 0 ? " " : "") + QByteArray::fromStdString(formatNumber(numbers[i]));
    return text;
}

/// A line of text for each number of a MetaImage's header, with the function of the world as samples.
QByteArray metaImage(const Eigen::Matrix3d& directions, const Eigen::Vector3d& spacing, const Eigen::Vector3d& origin,
                     const QByteArray& matrixName = "TransformMatrix", const QByteArray& offsetName = "Offset",
                     const QByteArray& spacingName = "ElementSpacing")
{
    return "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n" + matrixName + " = " +
           numbersText(directions.data(), 9) + "\n" + // a direction in each row
           offsetName + " = " + numbersText(origin.data(), 3) + "\n" + spacingName + " = " +
           numbersText(spacing.data(), 3) + "\nDimSize = 3 4 2\nElementType = MET_FLOAT\nElementDataFile = LOCAL\n" +
           samplesOfWorld(testSize, directions * spacing.asDiagonal(), origin, 10);
}

QByteArray imageData(const Eigen::Matrix3d& directions, const Eigen::Vector3d& spacing, const Eigen::Vector3d& origin)
{
    const Eigen::Matrix3d rows = directions.transpose(); // stored row by row, each column a direction
    const QByteArray floats = samplesOfWorld(testSize, directions * spacing.asDiagonal(), origin, 10);
    QByteArray values;
    for (qsizetype i = 0; i < floats.size(); i += 4) {
        float value = 0;
        std::memcpy(&value, floats.data() + i, sizeof value);
        values += QByteArray::fromStdString(formatNumber(value)) + " ";
    }
    return "<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
           "<ImageData WholeExtent=\"0 2 0 3 0 1\" Origin=\"" +
           numbersText(origin.data(), 3) + "\" Spacing=\"" + numbersText(spacing.data(), 3) + "\" Direction=\"" +
           numbersText(rows.data(), 9) +
           "\">\n<Piece Extent=\"0 2 0 3 0 1\"><PointData Scalars=\"v\"><DataArray type=\"Float32\" Name=\"v\" "
           "format=\"ascii\">" +
           values + "</DataArray></PointData></Piece>\n</ImageData>\n</VTKFile>\n";
}

/// Turned about an axis at an angle, and the third one leaning if it is sheared.
Eigen::Matrix3d turned(double angle, double shear)
{
    Eigen::Matrix3d directions = Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    directions.col(2) = (directions.col(2) + shear * directions.col(0)).normalized();
    return directions;
}

/// What the header says, as far as a lattice can lie there.
Result<Lattice> placeOf(const QByteArray& file)
{
    const auto header = metaHeaderOf({file.constData(), static_cast<std::size_t>(file.size())});
    if (!header)
        return header.error();
    const auto place = metaImagePlace(*header);
    if (!place)
        return place.error();
    const Status fits = checkLatticePlacement((*place)->lattice);
    return fits ? Result<Lattice>((*place)->lattice) : fits.error();
}

} // namespace

class VtkPlacesTest : public QObject {
    Q_OBJECT

private slots:
    void sharedCasesLieWhereTheySay_data()
    {
        QTest::addColumn<QString>("file");
        QTest::newRow("backwards along x and y") << "flip_xy.mha";
        QTest::newRow("backwards along z") << "flip_z.mha";
    }
    void sharedCasesLieWhereTheySay()
    {
        QFETCH(QString, file);
        const fs::path path = sharedCases() / "metaimage" / file.toStdString();
        if (!fs::exists(path))
            QSKIP_WITHOUT("../shared/cases");
        const auto dataset = builtVtkReader().read(path, {}, {});
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QVERIFY(distanceFromWorld(*dataset, 10) < 1e-4);
        QCOMPARE(dataset->space, std::string("LPS"));
        QVERIFY(dataset->remarks.empty());
    }

    /// Without BinaryData samples are binary.
    void sharedCaseWithoutBinaryData()
    {
        const fs::path folder = sharedCases() / "metaimage";
        if (!fs::exists(folder))
            QSKIP_WITHOUT("../shared/cases");
        const auto dataset = builtVtkReader().read(folder / "nobinary.mhd", {}, {});
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QFile raw(QString::fromStdString((folder / "vol.raw").string()));
        QVERIFY(raw.open(QIODevice::ReadOnly));
        const auto bytes = dataset->values.bytes();
        QVERIFY(raw.readAll() == QByteArrayView(reinterpret_cast<const char*>(bytes.data()), qsizetype(bytes.size())));
        QVERIFY(dataset->lattice.isAlongAxes());
        QVERIFY(dataset->lattice.spacing == Eigen::Vector3d(1, 2, 3));
    }

    /// Some of them; a process reads each.
    void ordersOfAxes()
    {
        const Eigen::Vector3d spacing(0.1, 4, 1.0 / 3), origin(10, -20.5, 1e3);
        const auto frames = signedPermutations();
        for (std::size_t frame = 0; frame < frames.size(); frame += 13)
            for (const bool isMeta : {true, false}) {
                const Eigen::Matrix3d& directions = frames[frame];
                const fs::path path = isMeta ? folder_.write("image.mha", metaImage(directions, spacing, origin))
                                             : folder_.write("image.vti", imageData(directions, spacing, origin));
                const auto dataset = builtVtkReader().read(path, {}, {});
                QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
                QVERIFY(dataset->domain == DomainClass::RegularLattice);
                QVERIFY(dataset->lattice.size == testSize);
                QVERIFY(dataset->lattice.spacing == spacing);
                QVERIFY(dataset->lattice.origin == origin);
                QVERIFY(dataset->lattice.directions == directions);
                QVERIFY(distanceFromWorld(*dataset, 10) < 1e-3);
                QCOMPARE(dataset->space, std::string(isMeta ? "LPS" : ""));
            }
    }

    void everyOrderOfAxesInAHeader()
    {
        const Eigen::Vector3d spacing(0.1, 4, 1.0 / 3), origin(10, -20.5, 1e3);
        for (const Eigen::Matrix3d& directions : signedPermutations()) {
            const auto place = placeOf(metaImage(directions, spacing, origin));
            QVERIFY2(place.ok(), place.ok() ? "" : place.error().text().c_str());
            QVERIFY(place->spacing == spacing);
            QVERIFY(place->origin == origin);
            QVERIFY(place->directions == directions);
        }
    }

    void turnedAndSheared()
    {
        const Eigen::Vector3d spacing(3, 4, 5), origin(10, -20.5, 100);
        for (const auto& [angle, shear] : {std::pair{2.9, 0.0}, {0.7, 0.4}})
            for (const bool isMeta : {true, false}) {
                const Eigen::Matrix3d directions = turned(angle, shear);
                const fs::path path = isMeta ? folder_.write("image.mha", metaImage(directions, spacing, origin))
                                             : folder_.write("image.vti", imageData(directions, spacing, origin));
                const auto dataset = builtVtkReader().read(path, {}, {});
                QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
                QVERIFY(dataset->domain == DomainClass::RegularLattice);
                QVERIFY(dataset->lattice.spacing == spacing);
                QVERIFY(distanceFromWorld(*dataset, 10) < 1e-4);
                const auto contents = builtVtkReader().probe(path, {}, {});
                QVERIFY2(contents.ok(), contents.ok() ? "" : contents.error().text().c_str());
                QVERIFY(contents->lattice.directions.isApprox(dataset->lattice.directions, 1e-15));
                QVERIFY(contents->lattice.origin.isApprox(dataset->lattice.origin, 1e-12));
            }
    }

    void imagesThatBeginLater()
    {
        const Eigen::Matrix3d directions = turned(0.5, 0.2);
        const Eigen::Vector3d spacing(3, 4, 5), first(2, 0, -1);
        QByteArray file = imageData(directions, spacing, {1, 2, 3});
        file.replace("0 2 0 3 0 1", "2 4 0 3 -1 0");
        const fs::path path = folder_.write("image.vti", file);
        const auto dataset = builtVtkReader().read(path, {}, {});
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        const Eigen::Vector3d begin = Eigen::Vector3d(1, 2, 3) + directions * spacing.cwiseProduct(first);
        QVERIFY((dataset->position(0) - begin).norm() < 1e-12);
        const auto contents = builtVtkReader().probe(path, {}, {});
        QVERIFY(contents.ok());
        QVERIFY((contents->lattice.origin - begin).norm() < 1e-12);
    }

    void metaImagesHaveOtherNamesForThem()
    {
        const Eigen::Matrix3d directions = turned(0.5, 0);
        for (const char* matrix : {"Orientation", "Rotation"})
            for (const char* offset : {"Position", "Origin"}) {
                const auto place = placeOf(metaImage(directions, {1, 2, 3}, {4, 5, 6}, matrix, offset, "ElementSize"));
                QVERIFY2(place.ok(), place.ok() ? "" : place.error().text().c_str());
                QVERIFY(place->spacing == Eigen::Vector3d(1, 2, 3));
                QVERIFY(place->origin == Eigen::Vector3d(4, 5, 6));
                QVERIFY(place->directions.isApprox(directions, 1e-15));
            }
    }

    /// Few digits in a header make lengths that are not quite 1; places are those of the numbers.
    void directionsOfOtherLengths()
    {
        const Eigen::Matrix3d rounded = (turned(0.5, 0) * 100).array().round() / 100;
        const auto dataset =
            builtVtkReader().read(folder_.write("image.mha", metaImage(rounded, {1, 2, 3}, {4, 5, 6})), {}, {});
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QVERIFY(distanceFromWorld(*dataset, 10) < 1e-4);
    }

    void orientationThatContradictsIsTold_data()
    {
        QTest::addColumn<QByteArray>("stated");
        QTest::addColumn<bool>("contradicts");
        QTest::newRow("by where axes begin") << QByteArray("RAI") << false;
        QTest::newRow("by where they end") << QByteArray("LPS") << false;
        QTest::newRow("unknown") << QByteArray("??? ") << false;
        QTest::newRow("another") << QByteArray("RPI") << true;
    }
    void orientationThatContradictsIsTold()
    {
        QFETCH(QByteArray, stated);
        QFETCH(bool, contradicts);
        QByteArray file = metaImage(Eigen::Matrix3d::Identity(), {1, 2, 3}, {4, 5, 6});
        file.replace("DimSize", "AnatomicalOrientation = " + stated + "\nDistanceUnits = um\nDimSize");
        const auto dataset = builtVtkReader().read(folder_.write("image.mha", file), {}, {});
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QVERIFY(distanceFromWorld(*dataset, 10) < 1e-4);
        QCOMPARE(dataset->lengthUnit, std::string("um"));
        QCOMPARE(dataset->remarks.size(), std::size_t(contradicts ? 1 : 0));
        if (contradicts)
            QVERIFY(dataset->remarks[0].text().find("'RPI', which by its matrix is 'RAI'") != std::string::npos);
    }

    void hostileHeaders_data()
    {
        QTest::addColumn<QByteArray>("from");
        QTest::addColumn<QByteArray>("to");
        QTest::addColumn<QByteArray>("words");
        const auto row = [](const char* name, const QByteArray& from, const QByteArray& to, const QByteArray& words) {
            QTest::newRow(name) << from << to << words;
        };
        const QByteArray matrix = "TransformMatrix = 1 0 0 0 1 0 0 0 1";
        row("no direction", matrix, "TransformMatrix = 1 0 0 0 0 0 0 0 1", "positive number");
        row("in a plane", matrix, "TransformMatrix = 1 0 0 0 1 0 .7071067811865476 .7071067811865476 0", "in a plane");
        row("not a number", matrix, "TransformMatrix = 1 0 0 0 nan 0 0 0 1", "not 9 finite numbers");
        row("without end", matrix, "TransformMatrix = 1 0 0 0 inf 0 0 0 1", "not 9 finite numbers");
        row("huge", matrix, "TransformMatrix = 1e308 1e308 0 0 1 0 0 0 1", "");
        row("too few", matrix, "TransformMatrix = 1 0 0 0 1 0", "not 9 finite numbers");
        row("words", matrix, "TransformMatrix = one 0 0 0 1 0 0 0 1", "not 9 finite numbers");
        row("offset of two", "Offset = 0 0 0", "Offset = 0 0", "not 3 finite numbers");
        row("offset not a number", "Offset = 0 0 0", "Offset = 0 nan 0", "not 3 finite numbers");
        row("offset too far", "Offset = 0 0 0", "Offset = 0 1e300 0", "too large or small");
        row("no spacing", "ElementSpacing = 1 1 1", "ElementSpacing = 1 0 1", "positive number");
        row("spacing of two", "ElementSpacing = 1 1 1", "ElementSpacing = 1 1", "not 3 finite numbers");
    }
    void hostileHeaders()
    {
        QFETCH(QByteArray, from);
        QFETCH(QByteArray, to);
        QFETCH(QByteArray, words);
        const QByteArray file = metaImage(Eigen::Matrix3d::Identity(), {1, 1, 1}, {0, 0, 0});
        const auto place = placeOf(with(file, from, to));
        QVERIFY(!place.ok());
        QVERIFY(place.error().kind == ErrorKind::BadInput);
        QVERIFY2(place.error().text().find(words.constData()) != std::string::npos, place.error().text().c_str());
    }
    void hostileHeadersAreRefused()
    {
        const QByteArray file = metaImage(Eigen::Matrix3d::Identity(), {1, 1, 1}, {0, 0, 0});
        for (const auto& [matrix, words] :
             {std::pair{"1 0 0 0 1 0 1 1 0", "in a plane"}, {"1 0 0 0 nan 0 0 0 1", "not 9 finite"}}) {
            const auto dataset =
                builtVtkReader().read(folder_.write("image.mha", with(file, "1 0 0 0 1 0 0 0 1", matrix)), {}, {});
            QVERIFY(!dataset.ok());
            QVERIFY2(dataset.error().text().find(words) != std::string::npos, dataset.error().text().c_str());
        }
    }

    /// ITK mirrors then.
    void negativeSpacingsRunBackwards()
    {
        const auto dataset =
            builtVtkReader().read(folder_.write("image.mha", metaImage(turned(0.3, 0), {1, -2, 3}, {4, 5, 6})), {}, {});
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QVERIFY(dataset->lattice.spacing == Eigen::Vector3d(1, 2, 3));
        QVERIFY(dataset->lattice.isLeftHanded());
        QVERIFY(distanceFromWorld(*dataset, 10) < 1e-4);
    }

    /// TIFF files do not, as far as they are read here; others refuse it.
    void theUserSaysWhatTheFileDoesNot()
    {
        const ParameterValues place{{"spacing", std::string("0.1x0.2x0.3")}, {"origin", std::string("1,2,3")}};
        const auto image = builtVtkReader().read(folder_.write("image.vti", vtiText()), place, {});
        QVERIFY(!image.ok());
        QVERIFY(image.error().kind == ErrorKind::WrongUsage);
        QVERIFY2(image.error().text().find("'--spacing' out") != std::string::npos, image.error().text().c_str());
        QByteArray header = metaImage(Eigen::Matrix3d::Identity(), {1, 1, 1}, {4, 5, 6});
        const fs::path told = folder_.write("told.mha", header);
        QVERIFY(!builtVtkReader().read(told, place, {}).ok());
        QVERIFY(builtVtkReader().read(told, {}, {})->remarks.empty());
        for (const char* const field : {"ElementSpacing", "Offset"}) {
            const auto first = header.indexOf(field);
            QVERIFY(first >= 0);
            header.remove(first, header.indexOf('\n', first) + 1 - first);
        }
        const fs::path untold = folder_.write("untold.mha", header);
        const auto stated = builtVtkReader().read(untold, place, {});
        QVERIFY2(stated.ok(), stated.ok() ? "" : stated.error().text().c_str());
        QVERIFY(stated->lattice.spacing == Eigen::Vector3d(0.1, 0.2, 0.3));
        QVERIFY(stated->lattice.origin == Eigen::Vector3d(1, 2, 3) && stated->remarks.empty());
        const auto assumed = builtVtkReader().read(untold, {}, {});
        QVERIFY(assumed.ok() && assumed->remarks.size() == 1);
        QVERIFY(assumed->remarks[0].text().find("1 x 1 x 1 is assumed") != std::string::npos);
        QVERIFY(
            (builtVtkReader().probe(untold, {}, {})->untold == std::vector<std::string>{"spacing", "origin", "unit"}));
        const fs::path path = sharedCases() / "tiff" / "imagej_spacing.tif";
        if (!fs::exists(path))
            QSKIP_WITHOUT("../shared/cases");
        const auto placed = builtVtkReader().read(path, place, {});
        QVERIFY2(placed.ok(), placed.ok() ? "" : placed.error().text().c_str());
        QVERIFY(placed->lattice.spacing == Eigen::Vector3d(0.1, 0.2, 0.3));
        QVERIFY(placed->lattice.origin == Eigen::Vector3d(1, 2, 3));
        const auto contents = builtVtkReader().probe(path, place, {});
        QVERIFY(contents.ok());
        QVERIFY(contents->lattice.spacing == placed->lattice.spacing);
    }

    /// The cells around a hole are as positive as those of other lattices.
    void mirroredLatticesWithHoles()
    {
        QByteArray file = imageData(Eigen::Vector3d(1, 1, -1).asDiagonal(), {1, 1, 1}, {0, 0, 0});
        const auto first = file.indexOf("ascii\">") + 7;
        file.replace(first, file.indexOf(' ', first) - first, "nan");
        const auto dataset = complete(builtVtkReader().read(folder_.write("image.vti", file), {}, {}));
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QVERIFY(dataset->domain == DomainClass::Irregular);
        const auto measured =
            complete(builtVtkReader().read(folder_.write("image.vti", file), {{"unit", std::string("mm")}}, {}));
        QVERIFY(measured.ok() && measured->lengthUnit == "mm");
        for (const Message& remark : dataset->remarks)
            QVERIFY2(remark.text().find("inverted") == std::string::npos, remark.text().c_str());
        QVERIFY(distanceFromWorld(*dataset, 10) < 1e-4);
    }

private:
    VtkFolder folder_;
};

QTEST_GUILESS_MAIN(VtkPlacesTest)
#include "vtk_places_test.moc"
