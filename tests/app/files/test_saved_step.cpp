// Which step is on disk, whatever is done and fails meanwhile.
#include "app/session/files/saved_step.h"

#include <QTest>

using namespace suffuse;

class TestSavedStep : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_stack.clear();
        m_step.set(true);
    }

    void aFailedSaveLeavesTheStep()
    {
        m_step.savingBegins(1);
        QVERIFY(m_step.savingEnds(1, false));
        QVERIFY(m_step.isNow() && m_stack.isClean());
        push();
        QVERIFY(!m_step.isNow());
        m_step.savingBegins(2);
        m_step.savingEnds(2, true);
        QVERIFY(m_step.isNow());
        push();
        m_step.savingBegins(3);
        push();
        m_step.savingEnds(3, false);
        QVERIFY(!m_step.isNow() && !m_stack.isClean());
        go(1);
        QVERIFY(m_step.isNow());
        QVERIFY(m_stack.isClean()); // the history's mark comes back with it
        go(2);
        QVERIFY(!m_step.isNow());
    }

    void paintingGoesOnMeanwhile()
    {
        push();
        m_step.savingBegins(1);
        push();
        m_step.savingEnds(1, true);
        QVERIFY(!m_step.isNow());
        go(1);
        QVERIFY(m_step.isNow());
    }

    /// Undone steps that give way to a new one are on disk, but nowhere here.
    void stepsThatGoAreLost()
    {
        push();
        push();
        m_step.set(true);
        m_step.savingBegins(1);
        go(1);
        push(); // also a second step, but another one
        QVERIFY(!m_step.isNow());
        m_step.savingEnds(1, true);
        QVERIFY(!m_step.isNow());
        go(0);
        QVERIFY(!m_step.isNow());
    }

    void ofSeveralSavesTheLastThatWorkedCounts()
    {
        push();
        m_step.savingBegins(1);
        push();
        m_step.savingBegins(2);
        push();
        m_step.savingBegins(3); // the second gives way
        m_step.savingEnds(1, true);
        QVERIFY(m_step.isSaving());
        m_step.savingEnds(3, false);
        QVERIFY(!m_step.isSaving() && !m_step.isNow());
        go(2);
        QVERIFY(!m_step.isNow());
        go(1);
        QVERIFY(m_step.isNow());
        QVERIFY(!m_step.savingEnds(2, true)); // nobody waits for it
    }

private:
    void push()
    {
        m_step.willPush();
        m_stack.push(new QUndoCommand(QStringLiteral("step")));
        m_step.follow();
    }
    void go(int index)
    {
        m_stack.setIndex(index);
        m_step.follow();
    }

    QUndoStack m_stack;
    SavedStep m_step{m_stack};
};

QTEST_GUILESS_MAIN(TestSavedStep)
#include "test_saved_step.moc"
