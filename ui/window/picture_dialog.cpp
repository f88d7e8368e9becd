// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/picture_dialog.h"

#include "core/picture/session_document.h"
#include "ui/dialogs/picture_orders.h"
#include "ui/panels/picture_form.h"
#include "ui/session/files.h"
#include "ui/session/shown_mesh_text.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/file_dialogs.h"
#include "ui/widgets/first_focus.h"
#include "ui/window/keep_session.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QPushButton>
#include <QSettings>

namespace tetra {
namespace {

constexpr const char* metadataKey = "picture/metadata";

} // namespace

PictureDialog::PictureDialog(Workbench& workbench, Viewport& viewport, const KeepSession& session, QWidget* parent)
    : QDialog(parent), workbench_(workbench), viewport_(viewport), session_(session), form_(new PictureForm("picture")),
      metadata_(new QCheckBox(tr("Store &how it was made in the file")))
{
    setObjectName("pictureOptions");
    setWindowTitle(tr("Save Picture"));
    metadata_->setObjectName("picture.metadata");
    metadata_->setChecked(QSettings().value(metadataKey, true).toBool());
    metadata_->setToolTip(tr("Program, model, accuracy, camera, transfer function and isovalues, so that the picture "
                             "can be reproduced: opening it as PNG offers its view"));
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(form_);
    layout->addWidget(metadata_);
    layout->addStretch();
    layout->addWidget(makeButtons());
}

QWidget* PictureDialog::makeButtons()
{
    auto* buttons = new QDialogButtonBox;
    const auto add = [buttons](const char* name, const QString& text, QDialogButtonBox::ButtonRole role) {
        QPushButton* button = buttons->addButton(text, role);
        button->setObjectName(QString("picture.") + name);
        return button;
    };
    save_ = add("save", tr("&Save…"), QDialogButtonBox::ActionRole);
    QPushButton* copy = add("copy", tr("&Copy"), QDialogButtonBox::ActionRole);
    QPushButton* close = add("close", tr("Cl&ose"), QDialogButtonBox::RejectRole);
    save_->setDefault(true);
    copy->setToolTip(tr("Copy it to the clipboard"));
    connect(save_, &QPushButton::clicked, this, &PictureDialog::save);
    connect(copy, &QPushButton::clicked, this, &PictureDialog::copy);
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
    return buttons;
}

void PictureDialog::ask()
{
    form_->setView(pixelsOf(viewport_), workbench_.session().view().annotations);
    show();
    focusFirst(*this, *save_);
    raise();
    activateWindow();
}

PictureOrder PictureDialog::order(const std::filesystem::path& target) const
{
    PictureOrder order = pictureOrder(workbench_, viewport_, form_->settings());
    order.target = target;
    auto document = session_.document();
    if (const auto& preview = workbench_.scenes().previewedView(); document && preview) {
        const AnnotationState annotations = document->view.annotations;
        document->view = *preview;
        document->view.annotations = annotations;
        document->view.camera = viewport_.shownCamera();
    }
    if (metadata_->isChecked() && document && !target.empty()) {
        const auto& shown = workbench_.session().shown();
        order.texts = pictureTexts(*document, shown ? errorText(*shown).toStdString() : std::string(),
                                   std::filesystem::absolute(target).parent_path());
    }
    return order;
}

void PictureDialog::save()
{
    if (!workbench_.session().model())
        return;
    form_->remember();
    QSettings().setValue(metadataKey, metadata_->isChecked());
    askForPictureFile(this, "pictureDialog", workbench_.opening().proposedPath(".png"), [this](const QString& path) {
        if (workbench_.session().model())
            workbench_.exporting().savePicture(order(filePath(path)));
        accept();
    });
}

void PictureDialog::copy()
{
    if (!workbench_.session().model())
        return;
    form_->remember();
    workbench_.exporting().savePicture(order({}));
    accept();
}

} // namespace tetra
