// SPDX-License-Identifier: GPL-3.0-or-later
// What is said where OpenGL is missing or too old.
#include "core/render/gl/egl_context.h"
#include "core/render/gl/scene_painter.h"

#include <QTest>

#include <cstring>

using namespace tetra;

namespace {

bool mentions(const Error& error, const char* text)
{
    return error.text().find(text) != std::string::npos;
}

/// An OpenGL of version 3.2: every function exists, and only glGetIntegerv does anything.
void doNothing() {}
void getVersion32(unsigned name, int* value)
{
    *value = name == 0x821B ? 3 : 2; // GL_MAJOR_VERSION
}

} // namespace

class GlErrorsTest : public QObject {
    Q_OBJECT

private slots:
    void withoutEgl()
    {
        const auto context = EglContext::make("libEGL-that-does-not-exist.so");
        QVERIFY(!context.ok());
        QVERIFY(mentions(context.error(), "libEGL-that-does-not-exist.so"));
        QVERIFY(mentions(context.error(), "CPU back end"));
    }

    void libraryThatIsNotEgl()
    {
        const auto context = EglContext::make("libm.so.6");
        QVERIFY(!context.ok());
        QVERIFY(mentions(context.error(), "eglGetProcAddress"));
    }

    void theScreensCardComesFirst()
    {
        const EglDevice software{true, false}, screen{false, true}, other{false, false};
        using Order = std::vector<std::size_t>;
        QCOMPARE(cardOrder({software, other, screen, other}, ""), (Order{2, 1, 3}));
        QCOMPARE(cardOrder({software, other, screen, other}, "0"), (Order{2, 1, 3}));
        QCOMPARE(cardOrder({screen, software, other}, "1"), (Order{2, 0}));
        QCOMPARE(cardOrder({other, other}, ""), (Order{0, 1})); // a machine without a screen
        QCOMPARE(cardOrder({screen}, "1"), (Order{0}));
        QCOMPARE(cardOrder({software}, ""), Order());
    }

    void withoutFunctions()
    {
        const auto painter = ScenePainter::make([](const char*) -> void* { return nullptr; });
        QVERIFY(!painter.ok());
        QVERIFY(mentions(painter.error(), "3.3"));
    }

    void oldVersion()
    {
        const auto painter = ScenePainter::make([](const char* name) {
            return std::strcmp(name, "glGetIntegerv") == 0 ? reinterpret_cast<void*>(&getVersion32)
                                                           : reinterpret_cast<void*>(&doNothing);
        });
        QVERIFY(!painter.ok());
        QVERIFY(mentions(painter.error(), "3.2"));
        QVERIFY(mentions(painter.error(), "3.3"));
    }
};

QTEST_GUILESS_MAIN(GlErrorsTest)
#include "gl_errors_test.moc"
