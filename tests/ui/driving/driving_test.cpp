// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/driving/driving_test.h"

#include <algorithm>

namespace tetra {

void DrivingTest::makeFiles(const char* application)
{
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName(application);
    QLocale::setDefault(QLocale::c());
    QSettings().clear();
    const std::filesystem::path folder = folder_.path().toStdString();
    model_ = QString::fromStdString(buildSampleModel(*hostOfThisBuild(), sampleDataset(10), folder).string());
    volume_ = QString::fromStdString(writeNrrd(sampleDataset(8), folder).string());
}

DrivenWindow& DrivingTest::startWindow()
{
    if (window_ && window_->window.isVisible())
        window_->startAnew();
    else
        window_ = std::make_unique<DrivenWindow>(model_, volume_);
    return *window_;
}

QStringList DrivingTest::gaps(const Drivers& drivers, const QStringList& names)
{
    QStringList found;
    for (const QString& name : names)
        if (std::ranges::count_if(drivers, [&](const Driver& driver) { return driver.drives(name); }) != 1)
            found.append("not driven by one driver: " + name);
    for (const Driver& driver : drivers)
        if (std::ranges::none_of(names, [&](const QString& name) { return driver.drives(name); }))
            found.append("drives nothing: " + driver.name);
    return found;
}

} // namespace tetra
