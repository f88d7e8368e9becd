// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/ui/sample_files.h"
#include "ui/session/files.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/message_bar.h"
#include "ui/window/main_window.h"

#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

namespace tetra {

/// A window with everything behind it, fresh settings, and a folder for its files. It remembers no views but those that
/// are kept in `views`, if that is told. Widgets are found by object name.
class WindowFixture {
public:
    explicit WindowFixture(BackendChoice backend = BackendChoice::Cpu,
                           std::unique_ptr<PluginHost> plugins = hostOfThisBuild(),
                           const std::filesystem::path& views = {})
        : host(std::move(plugins)), workbench(*host, views.empty() ? filePath(folder.filePath("views")) : views),
          window(workbench, backend)
    {
        window.resize(1000, 700); // drawing is what takes the time in most of these tests
    }

    /// The test ends at once if there is no such widget or action.
    template <class Object> Object& find(const QString& name) const
    {
        auto* object = window.findChild<Object*>(name);
        if (object == nullptr)
            qFatal("there is no %s", qPrintable(name));
        return *object;
    }
    std::string folderPath() const { return folder.path().toStdString(); }
    QStringList messages() const { return find<MessageBar>("messages").texts(); }
    /// The scene of the last request is shown, finely.
    bool settled() const
    {
        return !workbench.scenes().sceneBuilder().busy() && viewport().scene() && viewport().settled();
    }
    Viewport& viewport() const { return find<Viewport>("viewport"); }

    QTemporaryDir folder;
    std::unique_ptr<PluginHost> host;
    mutable Workbench workbench;
    MainWindow window;
};

} // namespace tetra
