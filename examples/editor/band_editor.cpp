// SPDX-License-Identifier: GPL-3.0-or-later
#include <plugins/api/editor.h>
#include <plugins/api/plugin.h>

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSignalBlocker>

namespace {
using namespace tetra;

/// Two numbers for the first band that the present rendering mode has. The value is JSON: {"low": 1, "high": 2}.
class BandWidget : public QWidget {
public:
    explicit BandWidget(EditorHost& host) : host_(host), low_(new QDoubleSpinBox), high_(new QDoubleSpinBox)
    {
        auto* form = new QFormLayout(this);
        form->addRow("Low", low_);
        form->addRow("High", high_);
        low_->setObjectName("example.band.low");
        high_->setObjectName("example.band.high");
        for (QDoubleSpinBox* box : {low_, high_})
            connect(box, &QDoubleSpinBox::valueChanged, this, [this] { edit(); });
        host_.whenChanged(this, [this](EditorChange change) {
            if (change == EditorChange::Model || change == EditorChange::Value)
                show();
        });
        show();
    }

private:
    /// Shows what the window has: after every change, an undo for instance.
    void show()
    {
        const auto parameters = host_.parameters();
        parameter_ = parameters.empty() ? std::string() : parameters.front().id;
        setEnabled(!parameter_.empty());
        if (parameter_.empty())
            return;
        const auto& value = std::get<OwnValue>(host_.value(parameter_));
        const QJsonObject band = QJsonDocument::fromJson(QByteArray::fromStdString(value.text)).object();
        const ValueRange range = host_.range();
        for (const auto& [box, key] : {std::pair(low_, "low"), std::pair(high_, "high")}) {
            const QSignalBlocker blocker(box);
            box->setRange(range.minimum, range.maximum);
            box->setSingleStep(range.extent() / 100);
            box->setValue(band.value(key).toDouble(range.minimum));
        }
    }

    /// Proposes the numbers: one step that can be undone.
    void edit()
    {
        const QJsonObject band{{"low", low_->value()}, {"high", high_->value()}};
        host_.setValue(parameter_, OwnValue{"example.band", QJsonDocument(band).toJson().toStdString()});
    }

    EditorHost& host_;
    QDoubleSpinBox* low_;
    QDoubleSpinBox* high_;
    std::string parameter_;
};
} // namespace

/// The plugin: its metadata say that it edits parameters of the type "example.band".
class BandEditor : public tetra::Editor {
public:
    QWidget* makeWidget(tetra::EditorHost& host) const override { return new BandWidget(host); }
};

TAN_PLUGIN(BandEditor, tetra::Editor)
