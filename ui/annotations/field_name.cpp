// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/annotations/field_name.h"

#include "ui/session/message_text.h"

#include <tan/model.h>

#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>

namespace tetra {
namespace {

class FieldTexts {
    Q_DECLARE_TR_FUNCTIONS(Annotations)
};

/// "region 0,0,0,31,31,15" or "stride 2,2,1": what was taken of the dataset.
bool isPart(const QString& text)
{
    return text.startsWith("region ") || text.startsWith("stride ");
}

} // namespace

QString fieldName(const ModelDescription& description)
{
    if (!description.valueName.empty())
        return shownText(description.valueName);
    for (const auto& [name, text] : description.parameters)
        if (name.ends_with(".array") && !text.empty())
            return shownText(text);
    // "file.bin, array" where readers know more than the file's name.
    QStringList source = shownText(description.sourceName).split(", ");
    source.erase(std::remove_if(source.begin() + 1, source.end(), isPart), source.end());
    const QString name = source.size() > 1 ? source.last() : QFileInfo(source.first()).completeBaseName();
    return name.isEmpty() ? FieldTexts::tr("Value") : name;
}

} // namespace tetra
