// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/work/latest_job.h"
#include "ui/work/long_task.h"

#include <QSignalSpy>
#include <QTest>

#include <pthread.h>

#include <atomic>
#include <latch>
#include <system_error>
#include <thread>

using namespace tetra;

/// How work leaves the GUI thread: the newest request wins, cancelled ones drop, progress and remaining time are told.
class WorkTest : public QObject {
    Q_OBJECT
private slots:
    void theNewestJobWins();
    void aRunningJobIsAskedToStop();
    void aPatientJobIsFinishedFirst();
    void patienceEnds();
    void destroyingStopsTheJob();
    void whatAJobHeldGoesWhileOthersMayGiveJobs();
    void aTaskTellsProgressAndItsEnd();
    void aCancelledTaskStillEnds();
    void aReplacedTaskDoesNotTellItsEnd();
    void aReplacedTaskThatEndsLastIsNotHeardOf();
    void whatWaitsIsDoneInOrderAndTold();
    void whatComesWithAnOutcomeWaitsForItsTurn();
    void whatWaitsIsDoneBeforeTheEnd();
    void whereNoThreadCanBeHadTheWorkIsDoneAtOnce();
};

namespace {

/// Runs until it is told to stop.
void untilStopped(const std::stop_token& stop)
{
    std::mutex mutex;
    std::unique_lock lock(mutex);
    std::condition_variable_any().wait(lock, stop, [] { return false; });
}

/// Threads ask for stacks that no machine has.
class NoThreads {
public:
    NoThreads()
    {
        pthread_getattr_default_np(&before_);
        pthread_attr_t attributes;
        pthread_attr_init(&attributes);
        pthread_attr_setstacksize(&attributes, std::size_t(1) << 50);
        pthread_setattr_default_np(&attributes);
        pthread_attr_destroy(&attributes);
    }
    ~NoThreads()
    {
        pthread_setattr_default_np(&before_);
        pthread_attr_destroy(&before_);
    }
    NoThreads(const NoThreads&) = delete;
    NoThreads& operator=(const NoThreads&) = delete;

private:
    pthread_attr_t before_;
};

} // namespace

void WorkTest::theNewestJobWins()
{
    LatestJob jobs;
    std::latch begun(1);
    std::latch goOn(1);
    std::atomic<int> sum = 0;
    jobs.submit([&](const std::stop_token&) {
        begun.count_down();
        goOn.wait();
        sum += 1;
    });
    begun.wait();
    jobs.submit([&](const std::stop_token&) { sum += 10; });
    jobs.submit([&](const std::stop_token&) { sum += 100; });
    goOn.count_down();
    QTRY_COMPARE(sum.load(), 101);
}

void WorkTest::aRunningJobIsAskedToStop()
{
    LatestJob jobs;
    std::atomic<int> stopped = 0;
    std::latch begun(1);
    jobs.submit([&](const std::stop_token& stop) {
        begun.count_down();
        untilStopped(stop);
        ++stopped;
    });
    begun.wait();
    jobs.submit([&](const std::stop_token&) { ++stopped; });
    QTRY_COMPARE(stopped.load(), 2);
}

void WorkTest::aPatientJobIsFinishedFirst()
{
    LatestJob jobs;
    std::atomic<bool> wasStopped = true;
    std::atomic<bool> next = false;
    std::latch begun(1);
    std::latch goOn(1);
    jobs.submit(
        [&](const std::stop_token& stop) {
            begun.count_down();
            goOn.wait();
            wasStopped = stop.stop_requested();
        },
        std::chrono::hours(1));
    begun.wait();
    jobs.submit([&](const std::stop_token&) { next = true; });
    goOn.count_down();
    QTRY_VERIFY(next);
    QVERIFY(!wasStopped);
}

void WorkTest::patienceEnds()
{
    LatestJob jobs;
    std::atomic<bool> next = false;
    std::latch begun(1);
    jobs.submit(
        [&](const std::stop_token& stop) {
            begun.count_down();
            untilStopped(stop);
        },
        std::chrono::milliseconds(20));
    begun.wait();
    jobs.submit([&](const std::stop_token&) { next = true; });
    QTRY_VERIFY(next);
}

void WorkTest::destroyingStopsTheJob()
{
    std::atomic<bool> ended = false;
    {
        LatestJob jobs;
        std::latch begun(1);
        jobs.submit([&](const std::stop_token& stop) {
            begun.count_down();
            untilStopped(stop);
            ended = true;
        });
        begun.wait();
    }
    QVERIFY(ended);
}

/// Freeing it may take long, or give the next job; a lock that was held meanwhile would stand still here.
void WorkTest::whatAJobHeldGoesWhileOthersMayGiveJobs()
{
    LatestJob jobs;
    std::atomic<bool> next = false;
    std::shared_ptr<int> held(new int, [&](const int* pointer) {
        delete pointer;
        jobs.cancel();
        jobs.submit([&](const std::stop_token&) { next = true; });
    });
    jobs.submit([held = std::move(held)](const std::stop_token&) {});
    QTRY_VERIFY(next);
}

void WorkTest::aTaskTellsProgressAndItsEnd()
{
    LongTask task;
    QSignalSpy progressed(&task, &LongTask::progressed);
    QSignalSpy finished(&task, &LongTask::finished);
    std::latch goOn(1);
    bool done = false;
    task.start([&](const Progress& progress) -> std::function<void()> {
        progress.report(0.5, "Counting");
        goOn.wait();
        return [&] { done = true; };
    });
    QVERIFY(task.running());
    QTRY_VERIFY(!progressed.empty() && progressed.last()[0].value<TaskProgress>().fraction == 0.5);
    QCOMPARE(progressed.last()[0].value<TaskProgress>().activity.text(), std::string("Counting"));
    goOn.count_down();
    QTRY_VERIFY(done);
    QCOMPARE(finished.count(), 1);
    QVERIFY(!task.running());
}

void WorkTest::aCancelledTaskStillEnds()
{
    LongTask task;
    bool wasCancelled = false;
    task.start([&](const Progress& progress) -> std::function<void()> {
        while (!progress.cancelled())
            std::this_thread::yield();
        return [&, cancelled = progress.cancelled()] { wasCancelled = cancelled; };
    });
    task.cancel();
    QTRY_VERIFY(wasCancelled);
}

void WorkTest::aReplacedTaskDoesNotTellItsEnd()
{
    LongTask task;
    QSignalSpy finished(&task, &LongTask::finished);
    int told = 0;
    for (const int number : {1, 2})
        task.start(
            [&told, number](const Progress&) -> std::function<void()> { return [&told, number] { told += number; }; });
    QTRY_COMPARE(told, 2);
    QCOMPARE(finished.count(), 1);
}

void WorkTest::aReplacedTaskThatEndsLastIsNotHeardOf()
{
    LongTask task;
    QSignalSpy finished(&task, &LongTask::finished);
    std::latch goOn(1);
    std::atomic<bool> firstEnded = false;
    int told = 0;
    task.start([&](const Progress&) -> std::function<void()> {
        goOn.wait();
        firstEnded = true;
        return [&told] { told += 1; };
    });
    task.start([&](const Progress&) -> std::function<void()> { return [&told] { told += 2; }; });
    QTRY_COMPARE(told, 2);
    QVERIFY(!task.running());
    goOn.count_down();
    QTRY_VERIFY(firstEnded);
    QCoreApplication::processEvents();
    QCOMPARE(told, 2);
    QCOMPARE(finished.count(), 1);
}

void WorkTest::whatWaitsIsDoneInOrderAndTold()
{
    LongTask task;
    QSignalSpy finished(&task, &LongTask::finished);
    std::latch goOn(1);
    QList<int> done;
    QList<int> told;
    for (const int number : {1, 2, 3})
        task.enqueue([&, number](const Progress&) -> std::function<void()> {
            goOn.wait();
            done.append(number);
            return [&told, number] { told.append(number); };
        });
    QVERIFY(task.running());
    QCOMPARE(task.waiting(), 2);
    task.cancel(); // of the one that runs, and nobody else
    goOn.count_down();
    QTRY_COMPARE(told, (QList<int>{1, 2, 3}));
    QCOMPARE(done, told);
    QCOMPARE(finished.count(), 3);
    QVERIFY(!task.running() && task.waiting() == 0);
}

void WorkTest::whatComesWithAnOutcomeWaitsForItsTurn()
{
    LongTask task;
    QList<int> told;
    const auto tells = [&told](int number) -> LongTask::Work {
        return [&told, number](const Progress&) { return [&told, number] { told.append(number); }; };
    };
    task.enqueue([&](const Progress&) -> std::function<void()> {
        return [&] {
            told.append(1);
            task.enqueue(tells(3));
        };
    });
    task.enqueue(tells(2));
    QTRY_COMPARE(told, (QList<int>{1, 2, 3}));
}

/// What is short is done whole; what looks at its progress ends.
void WorkTest::whatWaitsIsDoneBeforeTheEnd()
{
    std::atomic<int> written = 0;
    bool wasCancelled = false;
    {
        LongTask task;
        std::latch begun(1);
        task.enqueue([&](const Progress& progress) -> std::function<void()> {
            begun.count_down();
            while (!progress.cancelled())
                std::this_thread::yield();
            ++written;
            return [] {};
        });
        task.enqueue([&](const Progress& progress) -> std::function<void()> {
            wasCancelled = progress.cancelled();
            ++written;
            return [] {};
        });
        begun.wait();
    }
    QCOMPARE(written.load(), 2);
    QVERIFY(wasCancelled);
}

void WorkTest::whereNoThreadCanBeHadTheWorkIsDoneAtOnce()
{
    const NoThreads none;
    QVERIFY_THROWS_EXCEPTION(std::system_error, std::jthread([] {}));
    LongTask task;
    const QSignalSpy finished(&task, &LongTask::finished);
    bool worked = false;
    bool told = false;
    task.start([&](const Progress&) {
        worked = true;
        return [&] { told = true; };
    });
    QVERIFY(worked && !told);
    QTRY_VERIFY(told);
    QCOMPARE(finished.count(), 1);
    QVERIFY(!task.running());

    LatestJob jobs;
    bool done = false;
    jobs.submit([&](const std::stop_token&) { done = true; });
    QVERIFY(done);
}

QTEST_GUILESS_MAIN(WorkTest)
#include "work_test.moc"
