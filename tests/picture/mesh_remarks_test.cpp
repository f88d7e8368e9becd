// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/mesh_remarks.h"

#include <QTest>

using namespace tetra;

/// What is said of a mesh that is saved.
class MeshRemarksTest : public QObject {
    Q_OBJECT

private slots:
    void whatNumbersDoNotSay_data()
    {
        QTest::addColumn<bool>("irregular");
        QTest::addColumn<bool>("warped");
        QTest::addColumn<bool>("measured");
        QTest::addColumn<double>("scale");
        QTest::addColumn<QString>("told");
        QTest::newRow("a lattice") << false << false << false << 1.0 << "";
        QTest::newRow("nothing finer") << false << false << false << 1.5 << "no finer mesh";
        QTest::newRow("a moved boundary") << true << true << false << 1.0 << "outside the mesh";
        QTest::newRow("not moved") << true << false << false << 1.0 << "";
        QTest::newRow("measured") << true << true << true << 1.0 << "";
    }
    void whatNumbersDoNotSay()
    {
        QFETCH(const bool, irregular);
        QFETCH(const bool, warped);
        QFETCH(const bool, measured);
        QFETCH(const double, scale);
        QFETCH(const QString, told);
        ModelDescription model;
        model.domain = irregular ? DomainClass::Irregular : DomainClass::RegularLattice;
        model.warpingWeight = irregular ? 1 : 0;
        ExtractedMesh mesh;
        mesh.scale = scale;
        mesh.reached = Accuracy{1, warped ? 0.5 : 0};
        const auto remarks = meshRemarks(model, {}, mesh, measured, true);
        QCOMPARE(remarks.size(), told.isEmpty() ? 0U : 1U);
        if (!told.isEmpty())
            QVERIFY2(remarks.front().text().find(told.toStdString()) != std::string::npos,
                     remarks.front().text().c_str());
    }

    /// Files of triangles have no values between vertices.
    void whichArrayToInterpolate()
    {
        const std::string text = logarithmsRemark("log10(nut)").text();
        QVERIFY2(text.starts_with("Between vertices interpolate 'log10(nut)'") &&
                     text.find("'nut', interpolated itself") != std::string::npos,
                 text.c_str());
    }
};

QTEST_APPLESS_MAIN(MeshRemarksTest)
#include "mesh_remarks_test.moc"
