// SPDX-License-Identifier: GPL-3.0-or-later
// Sections never reach into each other, whatever whoever fills them does.
#include "core/history/section_writer.h"

#include <QTemporaryDir>
#include <QTest>

#include <array>

using namespace tetra;
using format::SectionId;

class SectionWriterTest : public QObject {
    Q_OBJECT

private slots:
    void whatDoesNotFitItsPlanIsRefused()
    {
        const std::array<PlannedSection, 2> planned = {PlannedSection{SectionId::Text, 1, 16},
                                                       PlannedSection{SectionId::SitePoints, 4, 4}};
        const std::vector<std::byte> bytes(17);
        for (const std::size_t fitting : {0u, 15u, 16u}) {
            SectionWriter writer = begun();
            QVERIFY(writer.plan(planned).ok());
            QVERIFY(writer.add(SectionId::Text, std::span(bytes).first(fitting)).ok());
            isRefused(writer.add(SectionId::Text, std::span(bytes).first(17 - fitting)));
            std::vector<std::byte> read(17);
            isRefused(writer.read(SectionId::Text, 0, read));
        }
        SectionWriter writer = begun();
        QVERIFY(writer.plan(planned).ok());
        QVERIFY(writer.add(SectionId::Text, std::span(bytes).first(16)).ok());
        isRefused(writer.finish({})); // the other one has not been filled
        QVERIFY(!std::filesystem::exists(path()));
    }

private:
    std::filesystem::path path() const { return folder_.filePath("model.tan").toStdString(); }
    SectionWriter begun() const { return SectionWriter(FileWriter::create(path()).value()); }
    static void isRefused(const Status& status)
    {
        QVERIFY(!status.ok());
        QCOMPARE(status.error().kind, ErrorKind::CannotWrite);
    }

    QTemporaryDir folder_;
};

QTEST_APPLESS_MAIN(SectionWriterTest)
#include "section_writer_test.moc"
