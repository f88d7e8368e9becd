// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/ui/driving/driver.h"

namespace tetra {

/// What tests of commands and of controls share: the files, and a window that lasts until something closes it.
class DrivingTest : public QObject {
    Q_OBJECT
protected:
    /// Makes a small model and a dataset, with the settings of `application`.
    void makeFiles(const char* application);
    /// As it is at first; the same one as before if it is there still.
    DrivenWindow& startWindow();
    void endWindow() { window_.reset(); }
    /// What of `names` no driver drives, what has no name, and which drivers drive nothing; empty if all is well.
    static QStringList gaps(const Drivers& drivers, const QStringList& names);

private:
    QTemporaryDir folder_;
    QString model_;
    QString volume_;
    std::unique_ptr<DrivenWindow> window_;
};

} // namespace tetra
