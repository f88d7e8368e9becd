// SPDX-License-Identifier: GPL-3.0-or-later
// The window on models whose files are damaged: it says so whatever part is damaged and whoever notices, and saves
// nothing that may be wrong.
#include "tests/core/history/model_fixture.h"
#include "tests/ui/sample_window.h"
#include "tests/waiting.h"

#include <tan/query.h>

#include <QSignalSpy>

using namespace tetra;
using format::SectionId;

class DamagedModelWindowTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init() { window_ = windowOnSample(); }
    void cleanup() { window_.reset(); }
    void anOldFileIsToldOfAlthoughThePictureIsRight();
    void nothingIsSavedOfAnOldFile();
    void whatAPanelFindsIsToldOf();
    void anotherModelIsNotBlamed();

private:
    std::filesystem::path path(const char* name) const { return window_->folderPath() + "/" + name; }
    /// A copy of the sample, old or of today, with one bit changed in its last tetrahedron or its last site.
    std::filesystem::path damagedSample(bool isOld, SectionId section) const;
    void open(const std::filesystem::path& path) const;
    QString damageMessage(const char* section) const;

    std::unique_ptr<WindowFixture> window_;
};

void DamagedModelWindowTest::initTestCase()
{
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName("damaged model");
    QLocale::setDefault(QLocale::c());
}

std::filesystem::path DamagedModelWindowTest::damagedSample(bool isOld, SectionId section) const
{
    FileParts parts(readBytes(window_->workbench.session().model()->path()));
    parts.setChunkBytes(64);
    if (isOld)
        parts.removeChunkSums();
    parts.elements<std::byte>(section).back() ^= std::byte(1);
    writeBytes(path("damaged.tan"), parts.content);
    return path("damaged.tan");
}

void DamagedModelWindowTest::open(const std::filesystem::path& path) const
{
    window_->window.open(QString::fromStdString(path.string()));
    QTRY_VERIFY(window_->workbench.session().model()->path() == path);
}

QString DamagedModelWindowTest::damageMessage(const char* section) const
{
    return QString("'%1' is damaged: the checksum of section '%2' is wrong. Copy the file again, or "
                   "build it again.")
        .arg(QString::fromStdString(path("damaged.tan").string()), section);
}

void DamagedModelWindowTest::anOldFileIsToldOfAlthoughThePictureIsRight()
{
    open(damagedSample(true, SectionId::OwnErrors)); // which a picture of one accuracy does not need
    QTRY_VERIFY2(window_->messages().contains(damageMessage("own errors")), qPrintable(window_->messages().join('\n')));
}

void DamagedModelWindowTest::nothingIsSavedOfAnOldFile()
{
    Workbench& workbench = window_->workbench;
    QSignalSpy failed(&workbench, &Workbench::failed);
    open(damagedSample(true, SectionId::OwnErrors));
    QTRY_VERIFY(!failed.isEmpty());
    QSignalSpy saveFailed(&workbench, &Workbench::saveFailed);
    const auto isRefused = [&](const char* name, const std::function<void(const std::filesystem::path&)>& save) {
        save(path(name));
        return waitFor([&] { return !saveFailed.isEmpty(); }) &&
               saveFailed.takeFirst().first().toString() == damageMessage("own errors") &&
               !std::filesystem::exists(path(name));
    };
    QVERIFY(isRefused("levels.csv", [&](const auto& target) { workbench.exporting().saveStatistics(target); }));
    QVERIFY(isRefused("picture.png", [&](const auto& target) {
        PictureOrder order;
        order.width = order.height = 20;
        order.target = target;
        workbench.exporting().savePicture(order);
    }));
    const std::shared_ptr<const Model> model = workbench.session().model();
    const MeshOrder order{model, nullptr, {}, path("mesh.ply")};
    QVERIFY(!writeMesh(*window_->host, order, {}).ok());
    const auto renderer = window_->workbench.host().renderer("isosurface");
    QVERIFY(renderer.ok());
    QVERIFY(!writeSurfaces(*window_->host, {{model, renderer->plugin, {}, {}, {}}, std::nullopt, path("mesh.ply")}, {})
                 .ok());
    QVERIFY(!std::filesystem::exists(path("mesh.ply")));
}

/// Of a file of today nobody looks at what is not read, and whoever reads it need not have a picture to make.
void DamagedModelWindowTest::whatAPanelFindsIsToldOf()
{
    open(damagedSample(false, SectionId::MeshSizes));
    const Model& model = *window_->workbench.session().model();
    meshSizeAt(model, {0});
    QTRY_VERIFY2(window_->messages().contains(damageMessage("mesh sizes")), qPrintable(window_->messages().join('\n')));
}

void DamagedModelWindowTest::anotherModelIsNotBlamed()
{
    const std::filesystem::path whole = window_->workbench.session().model()->path();
    open(damagedSample(true, SectionId::OwnErrors));
    QTRY_VERIFY(!window_->messages().isEmpty());
    window_->find<MessageBar>("messages").clear();
    open(whole);
    QTRY_VERIFY(window_->settled());
    QVERIFY(window_->workbench.session().model()->confirm().ok());
    QVERIFY2(window_->messages().isEmpty(), qPrintable(window_->messages().join('\n')));
}

QTEST_MAIN(DamagedModelWindowTest)
#include "damaged_model_test.moc"
