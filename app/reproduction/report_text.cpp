// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reproduction/report_text.h"

#include "app/command_line/table.h"

namespace tetra {

namespace {

std::string markdownRow(const std::vector<std::string>& cells)
{
    std::string line = "|";
    for (const std::string& cell : cells)
        line += " " + cell + " |";
    return line + "\n";
}

} // namespace

std::string textOf(const std::vector<ReportTable>& tables)
{
    std::string text;
    for (const ReportTable& part : tables) {
        text += (text.empty() ? "" : "\n") + part.title + "\n" + (part.rows.empty() ? "" : table(part.rows));
        for (const std::string& remark : part.remarks)
            text += remark + "\n";
    }
    return text;
}

std::string markdownOf(const std::string& heading, const std::vector<ReportTable>& tables)
{
    std::string text = "# " + heading + "\n";
    for (const ReportTable& part : tables) {
        text += "\n## " + part.title + "\n\n";
        for (std::size_t row = 0; row < part.rows.size(); ++row) {
            text += markdownRow(part.rows[row]);
            if (row == 0)
                text += markdownRow(std::vector<std::string>(part.rows[row].size(), "---:"));
        }
        for (const std::string& remark : part.remarks)
            text += (part.rows.empty() ? "" : "\n") + remark + "\n";
    }
    return text;
}

} // namespace tetra
