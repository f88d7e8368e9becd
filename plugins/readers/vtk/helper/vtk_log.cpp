// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/helper/vtk_log.h"

#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <string_view>

namespace tetra {
namespace {

constexpr std::size_t most = 8; ///< messages of each kind; a damaged file can make millions

/// What VTK calls a warning though values are missing after it: "Error reading ascii data. Possible mismatch ...".
bool meansError(std::string_view text)
{
    return text.find("rror reading") != std::string_view::npos || text.find("mismatch") != std::string_view::npos;
}

/// "ERROR: In FILE, line 12\nvtkClass (0x1234): What is wrong.\n\n" without all but the last part, in one line.
std::string essence(std::string_view text)
{
    if (text.find(": In ") < text.find('\n'))
        text.remove_prefix(std::min(text.find('\n') + 1, text.size()));
    if (const auto place = text.find("): "); place < text.find('\n'))
        text.remove_prefix(place + 3);
    std::string line;
    for (const char c : text)
        if (c != '\n' && c != '\r' && c != '\t')
            line += c;
        else if (!line.empty() && line.back() != ' ')
            line += ' ';
    while (!line.empty() && line.back() == ' ')
        line.pop_back();
    return line;
}

class LogWindow : public vtkOutputWindow {
public:
    vtkTypeMacro(LogWindow, vtkOutputWindow);
    static LogWindow* New();
    VtkLog* log = nullptr;

    void DisplayText(const char*) override {}
    void DisplayErrorText(const char* text) override { add(log->errors, text); }
    void DisplayWarningText(const char* text) override { addWarning(text); }
    void DisplayGenericWarningText(const char* text) override { addWarning(text); }
    void DisplayDebugText(const char*) override {}

private:
    void addWarning(const char* text) { add(text != nullptr && meansError(text) ? log->errors : log->warnings, text); }
    static void add(std::vector<std::string>& list, const char* text)
    {
        const std::string line = essence(text == nullptr ? "" : text);
        if (list.size() < most && std::ranges::find(list, line) == list.end())
            list.push_back(line);
    }
};

vtkStandardNewMacro(LogWindow);

} // namespace

void sendVtkMessagesTo(VtkLog& log)
{
    const auto window = vtkSmartPointer<LogWindow>::New();
    window->log = &log;
    vtkOutputWindow::SetInstance(window);
}

Status statusOf(const VtkLog& log)
{
    if (log.errors.empty())
        return {};
    return Error{ErrorKind::BadInput, "VTK says: " + log.errors.front() +
                                          (log.errors.front().ends_with('.') ? "" : ".") +
                                          " The file is damaged or incomplete: copy or write it anew."};
}

} // namespace tetra
