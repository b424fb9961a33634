// Loops on a crew: every index once, for whichever thread asks, whatever a body does.
#include "render/threads/crew.h"
#include "render/threads/parallel.h"

#include <QtTest>

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <vector>

using namespace suffuse;

class TestCrew : public QObject {
    Q_OBJECT

private slots:
    void eachIndexOnce()
    {
        Crew crew(4);
        for (std::size_t count = 2; count < 300; ++count) {
            std::vector<std::atomic<int>> done(count);
            crew.run(count, 4, [&](std::size_t i) { ++done[i]; });
            QVERIFY(std::ranges::all_of(done, [](int times) { return times == 1; }));
        }
    }

    void findsACrewAsleep()
    {
        Crew crew(3);
        std::atomic<int> sum = 0;
        for (int loop = 0; loop < 3; ++loop) {
            crew.run(100, 3, [&](std::size_t i) { sum += int(i); });
            QThread::msleep(20);
        }
        QCOMPARE(sum.load(), 3 * 4950);
    }

    void keepsToTheThreadsAskedFor()
    {
        Crew crew(8);
        std::atomic<int> now = 0, most = 0;
        crew.run(200, 2, [&](std::size_t) {
            const int inside = ++now;
            for (int seen = most; inside > seen && !most.compare_exchange_weak(seen, inside);)
                ;
            QThread::usleep(20);
            --now;
        });
        QVERIFY(most <= 2);
    }

    void loopsWithinLoops()
    {
        Crew crew(4);
        const Threads threads(4, &crew), each = threads.within(20);
        std::atomic<int> done = 0;
        parallelFor(20, threads, [&](std::size_t) { parallelFor(20, 2, [&](std::size_t) { ++done; }); });
        QCOMPARE(done.load(), 400);
        QCOMPARE(each.crew(), nullptr);
        QCOMPARE(threads.within(1).crew(), &crew); // a single body may use what the loop would have
    }

    void handsAFailureOn()
    {
        Crew crew(4);
        const auto failing = [](std::size_t i) {
            if (i == 37)
                throw std::runtime_error("37");
        };
        QVERIFY_THROWS_EXCEPTION(std::runtime_error, crew.run(100, 4, failing));
        std::atomic<int> done = 0;
        crew.run(100, 4, [&](std::size_t) { ++done; }); // and goes on
        QCOMPARE(done.load(), 100);
    }
};

QTEST_APPLESS_MAIN(TestCrew)
#include "test_crew.moc"
