// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/folder.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <fstream>
#include <memory>
#include <vector>

using namespace tetra;
namespace fs = std::filesystem;

class FolderTest : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        home_ = std::make_unique<QTemporaryDir>();
        fs::create_directories(path("inner") / "deep");
        for (const char* name : {"file", ".hidden", "inner/kept", "inner/deep/file"})
            std::ofstream(path(name)) << "content";
    }

    void everythingButTheFolderItself()
    {
        std::error_code problem = std::make_error_code(std::errc::io_error);
        std::vector<fs::path> found = pathsIn(path(""), problem);
        std::ranges::sort(found);
        QVERIFY(!problem);
        QVERIFY((found == std::vector<fs::path>{path(".hidden"), path("file"), path("inner")}));
    }

    void noNameIsTheCurrentFolder()
    {
        const QString before = QDir::currentPath();
        QVERIFY(QDir::setCurrent(QString::fromStdString(path("inner").string())));
        std::error_code problem;
        std::vector<fs::path> found = pathsIn("", problem);
        QVERIFY(QDir::setCurrent(before));
        std::ranges::sort(found);
        QVERIFY(!problem);
        QVERIFY((found == std::vector<fs::path>{"deep", "kept"}));
    }

    void whatIsNoFolderIsSaid()
    {
        std::error_code problem;
        QVERIFY(pathsIn(path("nowhere"), problem).empty());
        QVERIFY(problem == std::errc::no_such_file_or_directory);
        QVERIFY(pathsIn(path("file"), problem).empty());
        QVERIFY(problem == std::errc::not_a_directory);
    }

    /// What is kept is that of the folder itself, not of those in it.
    void contentGoesButForOneName()
    {
        std::ofstream(path("kept")) << "content";
        removeContent(path(""), "kept");
        std::error_code problem;
        QVERIFY((pathsIn(path(""), problem) == std::vector<fs::path>{path("kept")}));
    }

    void linksAreNotFollowed()
    {
        const QTemporaryDir other;
        const fs::path others = fs::path(other.path().toStdString()) / "letter";
        std::ofstream(others) << "Dear Sir";
        fs::create_directory_symlink(others.parent_path(), path("inner/link"));
        removeContent(path(""), {});
        std::error_code problem;
        QVERIFY(pathsIn(path(""), problem).empty() && !problem);
        QVERIFY(fs::exists(others));
        fs::create_directory_symlink(others.parent_path(), path("link"));
        removeContent(path("link"), {});
        QVERIFY(fs::exists(others));
    }

private:
    fs::path path(const char* name) const
    {
        const fs::path home = home_->path().toStdString();
        return *name == '\0' ? home : home / name;
    }

    std::unique_ptr<QTemporaryDir> home_;
};

QTEST_GUILESS_MAIN(FolderTest)
#include "folder_test.moc"
