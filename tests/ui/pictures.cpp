// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/pictures.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <cstdlib>

namespace tetra {
namespace {

constexpr double meanTolerance = 1;
constexpr double strikingTolerance = 0.005;
constexpr int striking = 24;

int largestChannelDifference(QRgb a, QRgb b)
{
    return std::max({std::abs(qRed(a) - qRed(b)), std::abs(qGreen(a) - qGreen(b)), std::abs(qBlue(a) - qBlue(b))});
}

QImage differencePicture(const QImage& a, const QImage& b)
{
    QImage result(a.size(), QImage::Format_RGB32);
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const int grey = std::min(255, 4 * largestChannelDifference(a.pixel(x, y), b.pixel(x, y)));
            result.setPixel(x, y, qRgb(grey, grey, grey));
        }
    return result;
}

} // namespace

PictureDifference difference(const QImage& a, const QImage& b)
{
    PictureDifference result;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const QRgb p = a.pixel(x, y);
            const QRgb q = b.pixel(x, y);
            result.meanChannel +=
                std::abs(qRed(p) - qRed(q)) + std::abs(qGreen(p) - qGreen(q)) + std::abs(qBlue(p) - qBlue(q));
            result.strikingPixels += largestChannelDifference(p, q) > striking;
        }
    const double pixels = static_cast<double>(a.width()) * a.height();
    return {result.meanChannel / (3 * pixels), result.strikingPixels / pixels};
}

QString compareWithBaseline(const QImage& picture, const QString& name)
{
    const QString baselinePath = QString(TAN_SOURCE_DIR "/tests/ui/baselines/%1.png").arg(name);
    if (qEnvironmentVariableIsSet("TAN_UPDATE_BASELINES")) {
        QDir().mkpath(QFileInfo(baselinePath).absolutePath());
        return picture.save(baselinePath) ? QString() : "cannot write " + baselinePath;
    }
    const QDir failures(TAN_BINARY_DIR "/tests/failed-pictures");
    failures.mkpath(".");
    const auto keep = [&] {
        picture.save(failures.filePath(name + ".png"));
        return "; see " + failures.filePath(name + ".png") + " beside " + baselinePath;
    };
    const QImage baseline(baselinePath);
    if (baseline.isNull())
        return "there is no baseline" + keep();
    if (baseline.size() != picture.size())
        return QString("%1 x %2 pixels instead of %3 x %4")
                   .arg(picture.width())
                   .arg(picture.height())
                   .arg(baseline.width())
                   .arg(baseline.height()) +
               keep();
    const PictureDifference found = difference(picture, baseline);
    if (found.meanChannel <= meanTolerance && found.strikingPixels <= strikingTolerance)
        return {};
    differencePicture(picture, baseline).save(failures.filePath(name + "-difference.png"));
    return QString("mean difference %1 of 255, %2 % of the pixels strikingly different")
               .arg(found.meanChannel)
               .arg(100 * found.strikingPixels) +
           keep();
}

} // namespace tetra
