// SPDX-License-Identifier: GPL-3.0-or-later
// The samples of lattices that VTK reads lie in the world where their files say (D1), in the order of the file.
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

} // namespace

class VtkPlacesTest : public QObject {
    Q_OBJECT

private slots:
    /// Some of them; a process reads each.
    void ordersOfAxes()
    {
        const Eigen::Vector3d spacing(0.1, 4, 1.0 / 3), origin(10, -20.5, 1e3);
        const auto frames = signedPermutations();
        for (std::size_t frame = 0; frame < frames.size(); frame += 13) {
            const Eigen::Matrix3d& directions = frames[frame];
            const fs::path path = folder_.write("image.vti", imageData(directions, spacing, origin));
            const auto dataset = builtVtkReader().read(path, {}, {});
            QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
            QVERIFY(dataset->domain == DomainClass::RegularLattice);
            QVERIFY(dataset->lattice.size == testSize);
            QVERIFY(dataset->lattice.spacing == spacing);
            QVERIFY(dataset->lattice.origin == origin);
            QVERIFY(dataset->lattice.directions == directions);
            QVERIFY(distanceFromWorld(*dataset, 10) < 1e-3);
            QVERIFY(dataset->space.empty());
        }
    }

    void turnedAndSheared()
    {
        const Eigen::Vector3d spacing(3, 4, 5), origin(10, -20.5, 100);
        for (const auto& [angle, shear] : {std::pair{2.9, 0.0}, {0.7, 0.4}}) {
            const Eigen::Matrix3d directions = turned(angle, shear);
            const fs::path path = folder_.write("image.vti", imageData(directions, spacing, origin));
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

    /// Where files do not; others refuse it.
    void theUserSaysWhatTheFileDoesNot()
    {
        const ParameterValues place{{"spacing", std::string("0.1x0.2x0.3")}, {"origin", std::string("1,2,3")}};
        const auto image = builtVtkReader().read(folder_.write("image.vti", vtiText()), place, {});
        QVERIFY(!image.ok());
        QVERIFY(image.error().kind == ErrorKind::WrongUsage);
        QVERIFY2(image.error().text().find("'--spacing' out") != std::string::npos, image.error().text().c_str());
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
