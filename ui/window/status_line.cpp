// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/status_line.h"

#include "core/base/memory.h"
#include "core/data/value_scale.h"
#include "plugins/widgets/number_text.h"
#include "ui/session/message_text.h"
#include "ui/session/shown_mesh_text.h"

#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QProgressBar>
#include <QStatusBar>
#include <QStyle>

#include <chrono>

namespace tetra {
namespace {

/// Work that ends within this needs no sign that it goes on.
constexpr auto busyAfter = std::chrono::milliseconds(250);
constexpr auto memoryInterval = std::chrono::seconds(2);

/// A name that is too long for its place loses its middle, not its end.
class NameLabel : public QLabel {
protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        const QRect place = contentsRect().adjusted(margin(), 0, -margin(), 0);
        const auto alignment = QStyle::visualAlignment(layoutDirection(), Qt::AlignLeft | Qt::AlignVCenter);
        style()->drawItemText(&painter, place, static_cast<int>(alignment), palette(), isEnabled(),
                              fontMetrics().elidedText(text(), Qt::ElideMiddle, place.width()), foregroundRole());
    }
};

} // namespace

StatusLine::StatusLine(QStatusBar* bar) : QObject(bar), bar_(bar), file_(new NameLabel), busy_(new QProgressBar)
{
    file_->setObjectName("status.file");
    file_->setMargin(4);
    file_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    bar_->addWidget(file_, 1);
    busy_->setObjectName("status.busy");
    busy_->setRange(0, 0);
    busy_->setFixedSize(80, 12);
    bar_->addPermanentWidget(busy_);
    busy_->hide();
    picked_ = add("status.picked",
                  tr("Picked value and its position, in data units. Click elsewhere to pick another; Esc clears "
                     "the mark."));
    errors_ = add("status.errors", {});
    remarks_ = add("status.remarks", {});
    remarks_->setText(tr("part may be error"));
    sites_ = add("status.sites", tr("Vertices of the mesh shown"));
    tetrahedra_ = add("status.tetrahedra", {});
    triangles_ = add("status.triangles", tr("Triangles of all surfaces shown"));
    extraction_ = add("status.extraction", tr("Time to extract the mesh from the model"));
    frame_ = add("status.frame", tr("Time to draw the last picture; during movement, the frame rate, and the reduced "
                                    "size and number of tetrahedra"));
    memory_ = add("status.memory", tr("Memory used by the program, including mapped files"));
    backend_ = add("status.backend", {});

    busyShown_.setSingleShot(true);
    busyShown_.setInterval(busyAfter);
    connect(&busyShown_, &QTimer::timeout, busy_, &QWidget::show);
    connect(&memoryShown_, &QTimer::timeout, this, &StatusLine::showMemory);
    memoryShown_.start(memoryInterval);
    showMemory();
}

QLabel* StatusLine::add(const char* name, const QString& toolTip)
{
    auto* label = new QLabel;
    label->setObjectName(name);
    label->setToolTip(toolTip);
    label->setMargin(4);
    bar_->addPermanentWidget(label);
    label->hide();
    return label;
}

void StatusLine::setFile(const QString& name, const QString& path, bool isAtServer)
{
    busy_->setToolTip(isAtServer ? tr("The server is extracting the mesh, or the picture is being drawn")
                                 : tr("Drawing the picture at the chosen accuracy"));
    file_->setText(name);
    file_->setToolTip(path);
}

void StatusLine::clearScene()
{
    for (QLabel* label : {errors_, remarks_, sites_, tetrahedra_, triangles_, extraction_, frame_})
        label->hide();
}

void StatusLine::setScene(const BuiltScene& scene)
{
    setErrors(scene.mesh, *scene.model);
    sites_->setText(tr("%1 vertices").arg(countText(scene.mesh.keptSites)));
    tetrahedra_->setText(tr("%1 tetrahedra").arg(countText(scene.mesh.keptTetrahedra)));
    const QString pieces = piecesText(scene.mesh);
    tetrahedra_->setToolTip(pieces.isEmpty() ? tr("Tetrahedra of the mesh shown") : pieces);
    triangles_->setText(tr("%1 triangles").arg(countText(scene.triangles)));
    if (scene.extractionSeconds > 0)
        extraction_->setText(tr("extracted in %1").arg(durationText(scene.extractionSeconds)));
    for (QLabel* label : {errors_, sites_, tetrahedra_, triangles_, extraction_})
        label->show();
    triangles_->setVisible(scene.triangles > 0);
    showMemory();
}

void StatusLine::setErrors(const ShownMesh& mesh, const Model& model)
{
    errors_->setText(errorText(mesh));
    const QString promise = errorPromiseText(mesh.errorMeaning, mesh.errorInSpace.has_value());
    errors_->setToolTip(promise.isEmpty() ? meshText(mesh, model) : meshText(mesh, model) + '\n' + promise);
}

void StatusLine::setRemarks(std::span<const ErrorRemark> remarks, const ModelDescription& model)
{
    const bool ofLogarithms = holdsLogarithms(model.parameters);
    const TransferLimits range{model.range.minimum, model.range.maximum};
    QStringList texts;
    for (const ErrorRemark& remark : remarks)
        texts << translatedMessage(errorRemarkText(remark, ofLogarithms)) + ' ' +
                     translatedMessage(errorCureText(remark, range, ofLogarithms));
    const QString text = texts.join(QStringLiteral("\n\n"));
    remarks_->setToolTip(text);
    remarks_->setAccessibleDescription(text);
    remarks_->setVisible(!texts.isEmpty());
}

void StatusLine::setFrame(const FrameReport& report)
{
    frame_->setText(report.moving ? movingText(report) : tr("%1 per frame").arg(durationText(report.seconds)));
    frame_->show();
}

/// "15 frames/s, size 1/2, 62,000 tetrahedra".
QString StatusLine::movingText(const FrameReport& report)
{
    QStringList parts;
    if (report.framesPerSecond > 0)
        parts.append(tr("%1 frames/s").arg(report.framesPerSecond, 0, 'f', 0));
    if (report.reduction > 1)
        parts.append(tr("size 1/%1").arg(QLocale().toString(report.reduction, 'g', 3)));
    if (report.tetrahedra > 0)
        parts.append(tr("%1 tetrahedra").arg(countText(report.tetrahedra)));
    return parts.join(tr(", "));
}

void StatusLine::setBackend(const QString& name)
{
    backend_->setText(name);
    backend_->setToolTip(tr("Rendering back end: OpenGL or the CPU"));
    backend_->show();
}

void StatusLine::setPicked(const QString& text)
{
    picked_->setText(text);
    picked_->setVisible(!text.isEmpty());
}

void StatusLine::setBusy(bool busy)
{
    if (busy) {
        busyShown_.start();
    } else {
        busyShown_.stop();
        busy_->hide();
    }
}

void StatusLine::showMemory()
{
    const std::uint64_t bytes = residentBytes();
    memory_->setText(bytesText(bytes));
    memory_->setVisible(bytes > 0);
}

} // namespace tetra
