// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/driving/driving_test.h"

#include <tan/data.h>

#include <algorithm>

namespace tetra {
namespace {

/// The sample without zeros, so that its values have logarithms.
Dataset positiveSample(std::uint32_t size)
{
    Dataset dataset = sampleDataset(size);
    const std::uint64_t count = dataset.values.count();
    const auto samples = allocateSamples(SampleType::UInt8, count);
    if (!samples)
        qFatal("there is no memory for the sample");
    for (std::uint64_t i = 0; i < count; ++i)
        samples->get()[i] = static_cast<std::byte>(std::max(1.0, dataset.values.at(i)));
    dataset.values = ScalarField(SampleType::UInt8, count, *samples);
    dataset.source.hash = contentHash(dataset.values, nullptr);
    return dataset;
}

} // namespace

void DrivingTest::makeFiles(const char* application)
{
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName(application);
    QLocale::setDefault(QLocale::c());
    QSettings().clear();
    const std::filesystem::path folder = folder_.path().toStdString();
    const Dataset data = positiveSample(10);
    model_ = QString::fromStdString(buildSampleModel(*hostOfThisBuild(), data, folder).string());
    writeNrrd(data, folder, data.source.name); // where the model's data are looked for
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
