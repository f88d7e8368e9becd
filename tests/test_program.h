// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/waiting.h"

#include <QTest>

#if defined(QT_WIDGETS_LIB)
#include <QApplication>
#elif defined(QT_GUI_LIB)
#include <QGuiApplication>
#endif

/// The tests of a folder are linked into one program, because a program of its own for each of two hundred costs more
/// time than compiling it. Each test is written as Qt describes it and ends with one of Qt's QTEST_...MAIN macros,
/// which here enter the test into its program's list. PROGRAM NAME [ARGUMENT...] runs one of them, with Qt's usual
/// arguments.
namespace tetra {

using TestMain = int (*)(int argc, char** argv);

/// Enters a test under the name of its source without "_test.cpp". Defined in test_program.cpp.
bool addTest(const char* source, TestMain run);

template <class Test> int runTest(int argc, char** argv)
{
    Test test;
    return QTest::qExec(&test, argc, argv);
}

/// A test may prepare its surroundings in a static initMain(), before there is an application.
template <class Test, class Application> int runTestIn(int argc, char** argv)
{
    QTest::Internal::callInitMain<Test>();
    const Application application(argc, argv);
    QCoreApplication::setAttribute(Qt::AA_Use96Dpi, true);
    return runTest<Test>(argc, argv);
}

} // namespace tetra

#undef QTEST_MAIN
#undef QTEST_GUILESS_MAIN
#undef QTEST_APPLESS_MAIN
#define TETRA_ADD_TEST(...) static const bool testIsAdded = tetra::addTest(__FILE__, __VA_ARGS__);
#define QTEST_APPLESS_MAIN(Test) TETRA_ADD_TEST(tetra::runTest<Test>)
#define QTEST_GUILESS_MAIN(Test) TETRA_ADD_TEST(tetra::runTestIn<Test, QCoreApplication>)
#if defined(QT_WIDGETS_LIB)
#define QTEST_MAIN(Test) TETRA_ADD_TEST(tetra::runTestIn<Test, QApplication>)
#elif defined(QT_GUI_LIB)
#define QTEST_MAIN(Test) TETRA_ADD_TEST(tetra::runTestIn<Test, QGuiApplication>)
#else
#define QTEST_MAIN(Test) QTEST_GUILESS_MAIN(Test)
#endif
