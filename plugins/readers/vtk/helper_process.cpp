// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/helper_process.h"

#include "plugins/readers/vtk/vtk_exchange.h"

#include <QFile>
#include <QProcess>

#include <dlfcn.h>

namespace tetra {
namespace {

namespace fs = std::filesystem;

constexpr int milliseconds = 50; ///< between two looks at whether it is to be cancelled
constexpr auto install = "Install VTK with 'apt install libvtk9.1' (other systems: VTK 9).";

/// Reads what the helper writes, until it ends or the user cancels.
class HelperOutput {
public:
    HelperOutput(QProcess& process, const Progress& progress) : process_(process), progress_(progress) {}

    bool read(void* to, std::size_t bytes)
    {
        char* place = static_cast<char*>(to);
        while (bytes > 0) {
            if (process_.bytesAvailable() == 0 && !waitForMore())
                return false;
            const qint64 count = process_.read(place, static_cast<qint64>(bytes));
            if (count < 0)
                return false;
            place += count;
            bytes -= static_cast<std::size_t>(count);
        }
        return true;
    }

private:
    bool waitForMore()
    {
        while (!progress_.cancelled()) {
            if (process_.waitForReadyRead(milliseconds) || process_.bytesAvailable() > 0)
                return true;
            if (process_.state() == QProcess::NotRunning)
                return process_.bytesAvailable() > 0;
        }
        return false;
    }

    QProcess& process_;
    const Progress& progress_;
};

/// Its text up to the first end of line.
std::string firstLine(const QByteArray& text)
{
    return text.left(text.indexOf('\n')).trimmed().toStdString();
}

/// Why the helper gave no answer.
Error explainEnd(QProcess& process, const std::string& file)
{
    process.waitForFinished(2000);
    const QByteArray said = process.readAllStandardError();
    constexpr auto loader = "error while loading shared libraries: ";
    if (const auto place = said.indexOf(loader); place >= 0)
        return {ErrorKind::BadInput, "The VTK readers are not installed: " +
                                         firstLine(said.mid(place + qsizetype(std::string_view(loader).size()))) +
                                         ". " + install};
    return {ErrorKind::BadInput, "Cannot read '" + file +
                                     "': VTK broke down over it. The file is damaged, larger than memory, or of a kind "
                                     "that VTK reads badly. Write it anew, or as another format (.vtu, .vti)."};
}

Error notStarted(const fs::path& helper, const QString& reason)
{
    std::error_code ignored;
    if (!fs::exists(helper, ignored))
        return {ErrorKind::BadInput,
                "The VTK readers are not installed. Install the package tan-vtk-readers, which comes with TAn: "
                "'apt install ./tan-vtk-readers_*.deb' where the file lies "
                "(of a build of your own: build it anew after 'apt install libvtk9-dev'), or "
                "convert the file to NRRD or CSV."};
    return {ErrorKind::BadInput,
            "The VTK readers cannot be started: '" + helper.string() + "': " + reason.toStdString()};
}

/// Reads messages up to the answer.
Result<VtkAnswer> receive(QProcess& process, const std::string& file, const Progress& progress)
{
    HelperOutput output(process, progress);
    ExchangeInput input([&](void* to, std::size_t bytes) { return output.read(to, bytes); });
    Result<VtkAnswer> answer = Error{};
    for (bool last = false; !last && input.good();) {
        VtkMessage message{};
        exchange(input, message);
        last = message != VtkMessage::Progress;
        if (message == VtkMessage::Progress) {
            double fraction = 0;
            exchange(input, fraction);
            if (input.good())
                progress.report(fraction, "Reading");
        } else if (message == VtkMessage::Findings) {
            VtkFindings findings;
            exchange(input, findings);
            answer = VtkAnswer(std::move(findings));
        } else if (message == VtkMessage::Contents) {
            FileContents contents;
            exchange(input, contents);
            answer = VtkAnswer(std::move(contents));
        } else {
            Error error;
            exchange(input, error);
            answer = std::move(error);
        }
    }
    if (progress.cancelled())
        return cancelledError("Reading");
    if (!input.good())
        return explainEnd(process, file);
    return answer;
}

} // namespace

fs::path vtkHelperBesidePlugin()
{
    Dl_info info{};
    if (dladdr(reinterpret_cast<const void*>(&vtkHelperBesidePlugin), &info) == 0 || info.dli_fname == nullptr)
        return "tan-read-vtk";
    return fs::absolute(info.dli_fname).parent_path() / "tan-read-vtk";
}

Result<VtkAnswer> askVtkHelper(const fs::path& helper, VtkRequest request, const Progress& progress)
{
    QProcess process;
    process.setProgram(QFile::decodeName(helper.c_str()));
    process.start();
    if (!process.waitForStarted())
        return notStarted(helper, process.errorString());
    ExchangeOutput output([&](const void* data, std::size_t bytes) {
        return process.write(static_cast<const char*>(data), static_cast<qint64>(bytes)) >= 0;
    });
    exchange(output, request);
    process.closeWriteChannel();
    auto answer = receive(process, request.path, progress);
    // The answer is whole: nothing that the helper still has to tidy up is worth waiting for.
    process.kill();
    process.waitForFinished();
    return answer;
}

} // namespace tetra
