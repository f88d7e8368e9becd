// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/cache_dialog.h"

#include "ui/opening/model_cache.h"
#include "ui/session/files.h"
#include "ui/session/message_text.h"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

namespace tetra {

CacheDialog::CacheDialog(QWidget* parent)
    : QDialog(parent), folder_(new QLineEdit), limit_(new QSpinBox), used_(new QLabel),
      clear_(new QPushButton(tr("C&lear Now")))
{
    constexpr int mostGigabytes = 100'000;
    setObjectName("cacheDialog");
    setWindowTitle(tr("Model Cache"));
    const CacheChoice choice = cacheChoice(), usual = usualCache();
    auto* explanation =
        new QLabel(tr("Packed models and models on servers are unpacked or downloaded into this folder, and opened "
                      "from there the next time. When room is needed, those unused for longest are removed."));
    explanation->setWordWrap(true);
    folder_->setObjectName("cache.folder");
    folder_->setText(pathText(choice.folder));
    folder_->setPlaceholderText(pathText(usual.folder));
    folder_->setToolTip(tr("Cache folder (leave empty for the default)"));
    folder_->setMinimumWidth(folder_->fontMetrics().averageCharWidth() * 40);
    auto* choose = new QPushButton(tr("C&hoose…"));
    choose->setObjectName("cache.choose");
    choose->setToolTip(tr("Choose another folder"));
    limit_->setObjectName("cache.limit");
    limit_->setRange(1, mostGigabytes);
    limit_->setValue(choice.gigabytes > 0 ? choice.gigabytes : usual.gigabytes);
    limit_->setSuffix(tr(" GB"));
    limit_->setToolTip(tr("Maximum size of the cache"));
    used_->setObjectName("cache.used");
    clear_->setObjectName("cache.clear");
    clear_->setToolTip(tr("Remove all models in the folder that are not open"));
    auto* place = new QHBoxLayout;
    place->addWidget(folder_, 1);
    place->addWidget(choose);
    auto* use = new QHBoxLayout;
    use->addWidget(used_, 1);
    use->addWidget(clear_);
    auto* form = new QFormLayout;
    form->addRow(tr("&Folder:"), place);
    form->addRow(tr("At &most:"), limit_);
    form->addRow(tr("In use:"), use);
    qobject_cast<QLabel*>(form->labelForField(place))->setBuddy(folder_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(explanation);
    layout->addLayout(form);
    layout->addWidget(buttons);
    connect(choose, &QPushButton::clicked, this, &CacheDialog::chooseFolder);
    connect(clear_, &QPushButton::clicked, this, &CacheDialog::clear);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    showUsed();
}

void CacheDialog::accept()
{
    const int usual = usualCache().gigabytes;
    setCacheChoice({filePath(folder_->text().trimmed()), limit_->value() == usual ? 0 : limit_->value()});
    QDialog::accept();
}

void CacheDialog::chooseFolder()
{
    auto* dialog = new QFileDialog(this, tr("Model Cache"), folder_->text());
    dialog->setObjectName("cacheFolderDialog");
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::Directory);
    dialog->setOption(QFileDialog::ShowDirsOnly);
    connect(dialog, &QFileDialog::fileSelected, folder_, &QLineEdit::setText);
    dialog->open();
}

void CacheDialog::clear()
{
    const Status cleared = clearCache();
    showUsed();
    if (!cleared)
        used_->setText(translatedMessage(cleared.error().message));
}

void CacheDialog::showUsed()
{
    const auto bytes = cachedBytes();
    used_->setText(bytes ? sizeText(*bytes) : translatedMessage(bytes.error().message));
}

} // namespace tetra
