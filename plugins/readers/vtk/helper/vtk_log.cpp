// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/helper/vtk_log.h"

#include "plugins/process/process_limits.h"

#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <iostream>
#include <string_view>

namespace tetra {
namespace {

constexpr std::string_view failure = Message::marked("It could not be read.");
constexpr std::size_t most = 8; ///< messages of each kind; a damaged file can make millions

/// What VTK calls a warning though values are missing after it: "Error reading ascii data. Possible mismatch ...".
bool meansError(std::string_view text)
{
    return text.find("rror reading") != std::string_view::npos || text.find("mismatch") != std::string_view::npos;
}

/// What follows a failure, whatever it was: "Algorithm vtkHDFReader(0x1234) returned failure for request: ..." with all
/// that VTK knows of the request.
bool isOnlyAFailure(std::string_view text)
{
    return text.find("returned failure for request") != std::string_view::npos;
}

/// "ERROR: In FILE, line 12\nvtkClass (0x1234): What is wrong.\n\n" without all but the last part, in one line.
std::string essence(std::string_view text)
{
    if (text.find(": In ") < text.find('\n'))
        text.remove_prefix(std::min(text.find('\n') + 1, text.size()));
    if (const auto place = text.find("): "); place < text.find('\n'))
        text.remove_prefix(place + 3);
    if (isOnlyAFailure(text))
        return std::string(failure);
    std::string line;
    for (const char c : text)
        if (c != '\n' && c != '\r' && c != '\t')
            line += c;
        else if (!line.empty() && line.back() != ' ')
            line += ' ';
    while (!line.empty() && line.back() == ' ')
        line.pop_back();
    for (auto place = line.find("(0x"); place != std::string::npos; place = line.find("(0x", place)) { // addresses
        const auto end = line.find_first_not_of("0123456789abcdef", place + 3);
        if (end == std::string::npos || line[end] != ')')
            place += 3;
        else
            line.erase(place, end + 1 - place);
    }
    return line;
}

void addLine(std::vector<std::string>& list, const std::string& line)
{
    if (list.size() < most && std::ranges::find(list, line) == list.end())
        list.push_back(line);
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
        addLine(list, essence(text == nullptr ? "" : text));
    }
};

vtkStandardNewMacro(LogWindow);

} // namespace

void sendVtkMessagesTo(VtkLog& log)
{
    const auto window = vtkSmartPointer<LogWindow>::New();
    window->log = &log;
    vtkOutputWindow::SetInstance(window);
    std::cerr.rdbuf(nullptr); // what libraries write there besides is for nobody
}

Status statusOf(const VtkLog& log)
{
    if (log.errors.empty())
        return {};
    for (const std::string& error : log.errors)
        for (const std::string_view memory : {"llocat", "out of memory", "ot enough memory"})
            if (error.find(memory) != std::string::npos)
                return memoryLimitMet("VTK");
    const auto reason = std::ranges::find_if(log.errors, [](const std::string& e) { return e != failure; });
    const std::string& said = reason == log.errors.end() ? log.errors.front() : *reason;
    const Message message = said == failure ? Message::of(said, {}) : Message(said.ends_with('.') ? said : said + ".");
    return vtkError(message);
}

Error vtkError(const Message& said)
{
    return {ErrorKind::BadInput, Message::say("VTK says: %1 TAn cannot tell whether the file is damaged or of a kind "
                                              "that VTK does not read. Compare it with its original, or export it in "
                                              "another format (.vtu, .vti).",
                                              said)};
}

} // namespace tetra
