// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/ui/sample_files.h"
#include "tests/ui/window_fixture.h"
#include "tests/waiting.h"

#include <QSettings>
#include <QTest>

namespace tetra {

/// A window that is shown, with no settings of before and a sample of `side`^3 points open. The test ends at once if it
/// does not open.
inline std::unique_ptr<WindowFixture> windowOnSample(std::uint32_t side = 16, QSize size = {1000, 650})
{
    QSettings().clear();
    auto fixture = std::make_unique<WindowFixture>();
    fixture->window.resize(size);
    fixture->window.show();
    const auto path = buildSampleModel(*fixture->host, sampleDataset(side), fixture->folderPath());
    fixture->window.open(QString::fromStdString(path));
    if (!waitFor([&] { return fixture->workbench.session().model() && fixture->settled(); }))
        qFatal("the sample did not open");
    return fixture;
}

} // namespace tetra
