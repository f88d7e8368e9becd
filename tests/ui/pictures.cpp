// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/pictures.h"

#include <QDir>
#include <QFileInfo>
#include <QPainter>

#include <algorithm>
#include <cstdlib>
#include <initializer_list>

namespace tetra {
namespace {

constexpr int striking = 24;

int largestChannelDifference(QRgb a, QRgb b)
{
    return std::max({std::abs(qRed(a) - qRed(b)), std::abs(qGreen(a) - qGreen(b)), std::abs(qBlue(a) - qBlue(b))});
}

/// Four times as bright as the largest difference of a channel; of where both have pixels.
QImage differencePicture(const QImage& a, const QImage& b)
{
    QImage result(a.size().boundedTo(b.size()), QImage::Format_RGB32);
    for (int y = 0; y < result.height(); ++y)
        for (int x = 0; x < result.width(); ++x) {
            const int grey = std::min(255, 4 * largestChannelDifference(a.pixel(x, y), b.pixel(x, y)));
            result.setPixel(x, y, qRgb(grey, grey, grey));
        }
    return result;
}

QImage sideBySide(std::initializer_list<QImage> pictures)
{
    constexpr int gap = 4;
    QSize size(-gap, 0);
    for (const QImage& picture : pictures)
        size = {size.width() + gap + picture.width(), std::max(size.height(), picture.height())};
    QImage result(size, QImage::Format_RGB32);
    result.fill(Qt::gray);
    QPainter painter(&result);
    int left = 0;
    for (const QImage& picture : pictures) {
        painter.drawImage(left, 0, picture);
        left += picture.width() + gap;
    }
    return result;
}

QString differenceText(const QImage& picture, const QImage& baseline)
{
    if (picture.size() != baseline.size())
        return QString("%1 x %2 pixels instead of %3 x %4")
            .arg(picture.width())
            .arg(picture.height())
            .arg(baseline.width())
            .arg(baseline.height());
    const PictureDifference found = difference(picture, baseline);
    return QString("mean difference %1 of 255, %2 % of the pixels strikingly different")
        .arg(found.meanChannel)
        .arg(100 * found.strikingPixels);
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

QString compareWithBaseline(const QImage& picture, const QString& name, const PictureTolerance& tolerance)
{
    const QString baselinePath = QString(TAN_SOURCE_DIR "/tests/ui/baselines/%1.png").arg(name);
    const QDir kept(TAN_BINARY_DIR "/tests/failed-pictures");
    kept.mkpath(".");
    const QString keptPath = kept.filePath(name + ".png");
    const QString comparisonPath = kept.filePath(name + "-difference.png");
    const QImage now = picture.convertToFormat(QImage::Format_RGB32);
    const QImage baseline = QImage(baselinePath).convertToFormat(QImage::Format_RGB32);
    if (baseline.size() == now.size()) {
        const PictureDifference found = difference(now, baseline);
        if (found.meanChannel <= tolerance.meanChannel && found.strikingPixels <= tolerance.strikingPixels)
            return {};
    }
    now.save(keptPath);
    QString told = baseline.isNull() ? QString("there is no baseline") : differenceText(now, baseline);
    if (!baseline.isNull() && sideBySide({baseline, now, differencePicture(now, baseline)}).save(comparisonPath))
        told += "; look at " + comparisonPath;
    if (!qEnvironmentVariableIsSet("TAN_UPDATE_BASELINES"))
        return told + "; it is kept in " + keptPath;
    qInfo("%s becomes the baseline: %s", qPrintable(name), qPrintable(told));
    QDir().mkpath(QFileInfo(baselinePath).absolutePath());
    return now.save(baselinePath) ? QString() : "cannot write " + baselinePath;
}

} // namespace tetra
