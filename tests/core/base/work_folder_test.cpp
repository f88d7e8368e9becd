// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/work_folder.h"

#include <QTemporaryDir>
#include <QTest>

#include <atomic>
#include <fstream>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

using namespace tetra;

namespace {

std::filesystem::path pathIn(const QTemporaryDir& folder)
{
    return std::filesystem::path(folder.path().toStdString()) / "model.tan.work";
}

} // namespace

class WorkFolderTest : public QObject {
    Q_OBJECT

private slots:
    void oneProgramAtATime()
    {
        const QTemporaryDir home;
        const std::filesystem::path path = pathIn(home);
        {
            const auto first = WorkFolder::open(path, WorkFolder::Leftovers::Remove);
            QVERIFY(first.ok());
            const auto second = WorkFolder::open(path, WorkFolder::Leftovers::Remove);
            QVERIFY(!second.ok());
            QCOMPARE(second.error().kind, ErrorKind::CannotWrite);
            QVERIFY(QString::fromStdString(second.error().text()).contains("another program is building this model"));
        }
        QVERIFY(!std::filesystem::exists(path));
    }

    void whatIsOfOthersStays()
    {
        const QTemporaryDir home;
        const std::filesystem::path path = pathIn(home);
        std::ofstream(path) << "a file";
        QVERIFY(!WorkFolder::open(path, WorkFolder::Leftovers::Remove).ok());
        QVERIFY(std::filesystem::remove(path));
        std::filesystem::create_directory(path);
        std::ofstream(path / "letter.txt") << "Dear Sir";
        const auto folder = WorkFolder::open(path, WorkFolder::Leftovers::Remove);
        QVERIFY(!folder.ok());
        QVERIFY(QString::fromStdString(folder.error().text()).contains("it is used for something else"));
        QVERIFY(std::filesystem::exists(path / "letter.txt"));
        QVERIFY(!std::filesystem::exists(path / ".tan-work"));
    }

    void aLinkIsRefused()
    {
        const QTemporaryDir home;
        const std::filesystem::path path = pathIn(home);
        const std::filesystem::path mine = path.parent_path() / "mine";
        std::filesystem::create_directory(mine);
        std::filesystem::create_directory_symlink(mine, path);
        const auto folder = WorkFolder::open(path, WorkFolder::Leftovers::Remove);
        QVERIFY(!folder.ok());
        QVERIFY2(folder.error().text().find("it is a link") != std::string::npos, folder.error().text().c_str());
        QVERIFY(std::filesystem::is_symlink(path) && std::filesystem::is_empty(mine));
    }

    void aNameThatIsTooLongIsToBeShorter()
    {
        const QTemporaryDir home;
        const auto folder =
            WorkFolder::open(pathIn(home).parent_path() / std::string(256, 'm'), WorkFolder::Leftovers::Remove);
        QVERIFY(!folder.ok());
        QVERIFY2(folder.error().text().ends_with("Choose a shorter name."), folder.error().text().c_str());
    }

    /// Many come while others leave: whoever was let in has the folder to himself, with its lock in it, to the end.
    void nobodyGetsAFolderThatIsBeingRemoved()
    {
        const QTemporaryDir home;
        const std::filesystem::path path = pathIn(home);
        std::atomic<int> inside = 0, opened = 0, shared = 0, lost = 0;
        std::mutex mutex;
        std::string wrongRefusal;
        const auto work = [&] {
            while (opened < 1000) {
                const auto folder = WorkFolder::open(path, WorkFolder::Leftovers::Remove);
                if (!folder) {
                    if (folder.error().text().find("another program") == std::string::npos) {
                        const std::lock_guard lock(mutex);
                        wrongRefusal = folder.error().text();
                    }
                    continue;
                }
                ++opened;
                shared += ++inside > 1;
                const std::filesystem::path file = path / "run";
                std::ofstream(file) << "content";
                std::this_thread::yield();
                lost += !std::filesystem::exists(path / ".tan-work") || !std::filesystem::exists(file);
                --inside;
            }
        };
        {
            std::vector<std::jthread> programs;
            for (int program = 0; program < 4; ++program)
                programs.emplace_back(work);
        }
        const QString found = QString("%1 shared, %2 lost of %3");
        QVERIFY2(shared == 0 && lost == 0, qPrintable(found.arg(shared.load()).arg(lost.load()).arg(opened.load())));
        QCOMPARE(QString::fromStdString(wrongRefusal), QString());
    }
};

QTEST_APPLESS_MAIN(WorkFolderTest)
#include "work_folder_test.moc"
