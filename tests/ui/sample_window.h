// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/ui/sample_files.h"
#include "tests/ui/window_fixture.h"
#include "tests/waiting.h"

#include <QSettings>
#include <QTest>

namespace tetra {

/// A window that is shown, with no settings of before and a small sample open. The test ends at once if it does not
/// open.
inline std::unique_ptr<WindowFixture> windowOnSample()
{
    QSettings().clear();
    auto fixture = std::make_unique<WindowFixture>();
    fixture->window.show();
    const auto path = buildSampleModel(*fixture->host, sampleDataset(16), fixture->folderPath());
    fixture->window.open(QString::fromStdString(path));
    if (!waitFor([&] { return fixture->workbench.session().model() && fixture->settled(); }))
        qFatal("the sample did not open");
    return fixture;
}

} // namespace tetra
