// What the schedule of frames promises, a row each: what happens, and what is done then. No thread, no timer, no
// window.
#include "tests/session/schedule_stage.h"

#include <QTest>

#include <random>

using namespace suffuse;

namespace {

/// Lines that every row of coarse frames begins with: a pixel takes 4 µs, and all is ready for a gesture.
const QStringList slowPainting{"0 coarse on > wait", "0 ask a > exact a", "40 done 40 > wait 140",
                               "140 rest > prepare coarse a", "150 done > wait"};
/// A gesture whose frames are coarse.
const QStringList slowGesture =
    slowPainting + QStringList{"200 ask b drag > estimate a b~", "201 differs 4 5000 > coarse b~ from a"};
/// A slow painting whose strokes are lifted.
const QStringList lifted{"0 ask a > exact a", "40 done 40 > wait", "100 lift a > prepare lift over exact"};

/// Lets anything happen, in any order, and watches each coarse frame: it is of the view that is shown, or of the one
/// that was asked for last.
class RandomWalk {
public:
    explicit RandomWalk(unsigned seed) : m_random(seed) {}

    void step()
    {
        m_ms += below(40);
        if (state.startsWith("wait"))
            below(3) ? ask() : happen(events[below(int(std::size(events)))]);
        else if (below(6) == 0)
            askMeanwhile();
        else
            work(below(12) == 0);
    }
    /// Nothing is asked any more, and nothing fails.
    void comeToRest()
    {
        m_ms += 10'000;
        if (state.startsWith("wait"))
            happen("rest");
        else
            work(false);
    }

    ScheduleStage stage;
    QString state = "wait"; ///< what the schedule does
    quint64 asked = 0;      ///< frames
    QString problem, log;

private:
    static constexpr const char *events[] = {"coarse on", "coarse off", "device on", "device off",
                                             "lift a",    "lift b",     "lift none"};

    static QString viewIn(const QString &task) { return task.section('@', 1).left(1); }
    int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(m_random); }
    void happen(const QString &event)
    {
        const QString triedBefore = viewIn(state);
        state = stage.after(QString("%1 %2").arg(m_ms).arg(event));
        if (state.startsWith("coarse ") && !QStringList{m_askedView, m_shownView, triedBefore}.contains(viewIn(state)))
            problem = "a coarse frame of another view";
        log += QString("%1 %2 > %3\n").arg(m_ms).arg(event, state);
    }
    void ask()
    {
        ++asked;
        m_askedView = QString::number(2 + below(2));
        const QString name = QString("ask %1@%2").arg(QChar('a' + below(4))).arg(m_askedView);
        happen(name + (below(3) ? " drag" : "") + (below(4) ? "" : " float a settled"));
    }
    void askMeanwhile()
    {
        const QString task = state;
        ask();
        if (state == "cancelled" && task.startsWith("exact "))
            happen("cancelled");
        else
            state = task;
    }
    void work(bool fails)
    {
        const bool isExact = state.startsWith("exact ");
        m_ms += 1 + below(60);
        if (state.startsWith("estimate")) {
            happen(QString("differs %1 %2").arg(below(6)).arg(below(side * side)));
        } else if (fails) {
            happen(isExact ? (state.endsWith("device") ? "unpublished" : "failed") : below(2) ? "unfit" : "failed");
        } else {
            if (state.contains('@') && !state.startsWith("prepare"))
                m_shownView = viewIn(state);
            happen(QString("done %1 %2").arg(below(40)).arg(below(side * side)));
        }
    }

    std::mt19937 m_random;
    int m_ms = 0;
    QString m_askedView, m_shownView;
};

} // namespace

class TestFrameSchedule : public QObject {
    Q_OBJECT

private slots:
    void promises_data();
    void promises();
    void whatIsSlow();
    void whateverHappensTheLastFrameIsExact_data();
    void whateverHappensTheLastFrameIsExact();

private:
    void requests();
    void coarseFrames();
    void coarseIsReady();
    void devices();
    void floatingFrames();
    void liftsAreReady();
};

/// The newest request is drawn, and what is drawn gives way to it where that helps.
void TestFrameSchedule::requests()
{
    const auto row = [](const char *name, const QStringList &lines) { QTest::newRow(name) << lines; };
    row("nothing is asked for", {"0 rest > wait", "60000 rest > wait"});
    row("a frame is drawn once", {"0 ask a > exact a", "9 done > wait", "5000 rest > wait"});
    row("the newest request supersedes those that wait",
        {"0 ask a > exact a", "1 ask b > busy", "2 ask c > busy", "9 done > exact c", "20 done > wait"});
    row("the same view's picture may take long", {"0 ask a > exact a", "500 ask b > busy", "600 done > exact b"});
    row("too long, and it gives way", {"0 ask a > exact a", "501 ask b > cancelled", "502 cancelled > exact b"});
    row("but never twice in a row", {"0 ask a > exact a", "501 ask b > cancelled", "502 cancelled > exact b",
                                     "1200 ask c > busy", "1300 done > exact c", "1900 ask d > cancelled"});
    row("a quick picture of the old view is finished", {"0 ask a > exact a", "10 done > wait", "20 ask a@2 > exact a@2",
                                                        "120 ask a@3 > busy", "121 done > exact a@3"});
    row("a slower one gives way to the view that is wanted",
        {"0 ask a > exact a", "10 done > wait", "20 ask a@2 > exact a@2", "121 ask a@3 > cancelled",
         "122 cancelled > exact a@3"});
    row("but not where no frame came for long", {"0 ask a > exact a", "10 done > wait", "300 ask a@2 > exact a@2",
                                                 "401 ask a@3 > busy", "402 done > exact a@3"});
    row("a view that keeps moving is shown coarsely until it stops",
        {"0 ask a > exact a", "40 done 40 > wait", "100 ask a@2 > exact a@2", "140 done 40 > wait",
         "150 ask a@3 > coarse a@3 from a@2", "155 done > wait 185", "166 ask a@4 > coarse a@4 from a@3",
         "170 done > wait 200", "200 rest > exact a@4", "240 done 40 > wait 5240"});
    row("where a picture is quick, a moving view is exact",
        {"0 ask a > exact a", "9 done 9 > wait", "100 ask a@2 > exact a@2", "109 done 9 > wait",
         "116 ask a@3 > exact a@3"});
    row("a single change of the view is exact", {"0 ask a > exact a", "40 done 40 > wait", "100 ask a@2 > exact a@2",
                                                 "140 done 40 > wait", "400 ask a@3 > exact a@3"});
    row("where a moving view cannot be coarse, it is exact",
        {"0 ask a > exact a", "40 done 40 > wait", "100 ask a@2 > exact a@2", "140 done 40 > wait",
         "150 ask a@3 > coarse a@3 from a@2", "155 failed > exact a@3", "195 done 40 > wait 5195",
         "200 ask a@4 > exact a@4"});
    row("unless it takes for ever", {"0 ask a > exact a", "10 done > wait", "300 ask a@2 > exact a@2",
                                     "401 ask a@3 > busy", "701 ask a@4 > cancelled", "702 cancelled > exact a@4"});
    row("an error answers a request, too",
        {"0 ask a > exact a", "1 failed > wait", "2 ask b > exact b", "3 done > wait"});
}

/// They stand in for exact frames of a gesture that would take longer than a frame has, and for no other.
void TestFrameSchedule::coarseFrames()
{
    const auto row = [](const char *name, const QStringList &lines) { QTest::newRow(name) << lines; };
    row("a slow gesture is coarse, and exact when it pauses",
        slowGesture +
            QStringList{"205 done > wait 235", "234 rest > wait 235", "235 rest > exact b", "275 done 40 > wait 395"});
    row("the window hears of a longer rest, once",
        slowGesture + QStringList{"205 done > wait 235", "235 rest > exact b", "275 done 40 > wait 395",
                                  "394 rest > wait 395", "395 rest > tell rest", "396 done > wait",
                                  "9000 rest > wait"});
    row("a frame that is wanted meanwhile comes first",
        slowGesture + QStringList{"205 done > wait 235", "235 rest > exact b", "275 done 40 > wait 395",
                                  "395 rest > tell rest", "396 ask c drag > cancelled", "397 done > coarse c~ from b"});
    row("what is no gesture does not rest",
        slowGesture + QStringList{"205 done > wait 235", "210 ask b > exact b", "250 done 40 > wait"});
    row("a pause begins with the last frame",
        slowGesture + QStringList{"205 done > wait 235", "220 ask c drag > coarse c~ from b~", "225 done > wait 255",
                                  "255 rest > exact c"});
    row("a hand that goes on stops the exact frame of its pause",
        slowGesture + QStringList{"205 done > wait 235", "235 rest > exact b", "236 ask c drag > cancelled",
                                  "237 cancelled > coarse c~ from b"});
    row("what a pause was stopped at comes in the next pause",
        slowGesture + QStringList{"205 done > wait 235", "235 rest > exact b", "236 ask c drag > cancelled",
                                  "237 cancelled > coarse c~ from b", "240 done > wait 270", "270 rest > exact c"});
    row("the gesture's end is exact at once",
        slowGesture + QStringList{"205 done > wait 235", "210 ask b > exact b", "250 done 40 > wait"});
    row("a newer frame comes before the pause",
        slowGesture + QStringList{"206 ask c drag > busy", "290 done > coarse c~ from b~", "291 done > wait 321"});
    row("a quick gesture is exact",
        slowPainting + QStringList{"200 ask b drag > estimate a b~", "201 differs 4 2000 > exact b~"});
    row("a stroke alone is quicker than its pixels",
        slowPainting + QStringList{"200 ask b drag > estimate a b~", "201 differs 2 9000 > exact b~"});
    row("unless it is slow twice in a row",
        slowPainting + QStringList{"200 ask b drag > estimate a b~", "201 differs 2 0 > exact b~",
                                   "221 done 20 500 > wait 321", "222 ask c drag > estimate b~ c~",
                                   "223 differs 2 0 > exact c~", "243 done 20 500 > wait 343",
                                   "244 ask d drag > coarse d~ from c~"});
    row("once may be another program's fault",
        slowPainting + QStringList{"200 ask b drag > estimate a b~", "201 differs 2 0 > exact b~",
                                   "221 done 20 500 > wait 321", "222 ask c drag > estimate b~ c~",
                                   "223 differs 2 0 > exact c~", "225 done 2 500 > wait 325",
                                   "226 ask d drag > estimate c~ d~", "227 differs 2 0 > exact d~",
                                   "247 done 20 500 > wait 347", "248 ask e drag > estimate d~ e~"});
    row("the next gesture is judged anew",
        slowGesture + QStringList{"205 done > wait 235", "210 ask b > exact b", "250 done 40 > wait",
                                  "260 ask c drag > estimate b c~", "261 differs 4 100 > exact c~"});
    row("without being wanted none is coarse",
        {"0 ask a > exact a", "40 done 40 > wait", "50 ask b drag > exact b~", "90 done 40 > wait 210",
         "100 ask c drag > exact c~", "140 done 40 > wait 260", "150 ask d drag > exact d~"});
    row("nor without a gesture", slowPainting + QStringList{"200 ask b > exact b", "240 done 40 > wait 340"});
    row("nor in another view", slowGesture + QStringList{"205 done > wait 235", "210 ask b@2 drag > exact b@2~"});
    row("nor the first frame", {"0 coarse on > wait", "0 ask a drag > exact a~"});
    row("nor after an error",
        slowPainting + QStringList{"200 ask b > exact b", "201 failed > wait", "202 ask c drag > exact c~"});
    row("nor where the source cannot, ever again",
        slowGesture + QStringList{"205 failed > exact b~", "245 done 40 > wait 365", "250 ask c drag > exact c~",
                                  "290 done 40 > wait 410", "300 ask d drag > exact d~"});
    row("nor where it cannot this time",
        slowGesture + QStringList{"205 unfit > exact b~", "245 done 40 > wait 345", "250 ask c drag > estimate b~ c~",
                                  "251 differs 4 5000 > coarse c~ from b~"});
    row("what is drawn in place of one gives way, too",
        slowGesture +
            QStringList{"203 unfit > exact b~", "702 ask c drag > cancelled", "703 cancelled > estimate a c~"});
}

/// Made ready while the hand rests, and let go when nobody wants it.
void TestFrameSchedule::coarseIsReady()
{
    const auto row = [](const char *name, const QStringList &lines) { QTest::newRow(name) << lines; };
    row("nothing is made ready for a quick painting", {"0 coarse on > wait", "0 ask a > exact a", "2 done 2 > wait"});
    row("nor before it is wanted", {"0 ask a > exact a", "40 done 40 > wait", "500 coarse on > wait 600"});
    row("making ready gives way to every request",
        {"0 coarse on > wait", "0 ask a > exact a", "40 done 40 > wait 140", "140 rest > prepare coarse a",
         "141 ask b > cancelled", "142 cancelled > exact b"});
    row("and is begun anew",
        {"0 coarse on > wait", "0 ask a > exact a", "40 done 40 > wait 140", "140 rest > prepare coarse a",
         "141 ask b > cancelled", "142 cancelled > exact b", "180 done 40 > wait 280", "280 rest > prepare coarse b"});
    row("or never, where it cannot be",
        {"0 coarse on > wait", "0 ask a > exact a", "40 done 40 > wait 140", "140 rest > prepare coarse a",
         "141 failed > wait", "200 ask b drag > exact b~"});
    row("what is unwanted is let go", slowPainting + QStringList{"200 coarse off > wait 5200", "5199 rest > wait 5200",
                                                                 "5200 rest > forget", "5201 done > wait"});
    row("but not what is wanted again",
        slowPainting + QStringList{"200 coarse off > wait 5200", "5000 coarse on > wait", "9000 rest > wait"});
}

/// A picture may stay on a device; where that fails it comes to memory, and so do all after it.
void TestFrameSchedule::devices()
{
    const auto row = [](const char *name, const QStringList &lines) { QTest::newRow(name) << lines; };
    row("pictures are where they are wanted",
        {"0 ask a > exact a", "1 done > wait", "2 device on > wait", "3 ask b > exact b device", "4 done > wait",
         "5 device off > wait", "6 ask c > exact c"});
    row("one that cannot be shown comes to memory, and so do all after it",
        {"0 device on > wait", "0 ask a > exact a device", "1 unpublished > exact a", "2 done > wait",
         "3 ask b > exact b"});
    row("where no newer one waits, either", {"0 device on > wait", "0 ask a > exact a device", "1 ask b > busy",
                                             "2 unpublished > exact a", "3 done > exact b"});
    row("frames of a device are never coarse",
        {"0 device on > wait", "0 coarse on > wait", "0 ask a > exact a device", "40 done 40 > wait",
         "50 ask b drag > exact b~ device", "90 done 40 > wait 210", "100 ask c drag > exact c~ device"});
    row("nor do they float", {"0 device on > wait", "0 ask a > exact a device", "40 done 40 > wait", "50 lift a > wait",
                              "60 ask a drag float a > exact a~ device"});
    row("when it is lost the CPU goes on as ever",
        {"0 device on > wait", "0 coarse on > wait", "0 ask a > exact a device", "40 done 40 > wait", "45 lost > wait",
         "50 ask b drag > exact b~ device", "90 done 40 > wait 190", "100 ask c drag > estimate b~ c~"});
}

/// A drag that maps strokes as a whole is composed of two pictures, and exact when the document has it and it pauses.
void TestFrameSchedule::floatingFrames()
{
    const auto row = [](const char *name, const QStringList &lines) { QTest::newRow(name) << lines; };
    const QStringList floating =
        lifted +
        QStringList{"120 done > wait", "200 ask a drag float a > float a~ over exact all", "202 done > wait 322"};
    row("the first frame replaces all, those after it what differs",
        floating + QStringList{"216 ask a drag float a > float a~", "218 done > wait 338"});
    row("and so does the first of another lift", floating + QStringList{"216 ask a drag float b > float a~ all"});
    row("what the document does not have stays afloat, and the window hears when the hand rests",
        floating + QStringList{"321 rest > wait 322", "322 rest > tell rest", "323 done > wait", "9000 rest > wait"});
    row("but no more when it moves again",
        floating + QStringList{"321 ask a drag float a > float a~", "324 done > wait 444", "443 rest > wait 444"});
    row("what it has is exact after a pause",
        floating + QStringList{"300 ask b drag float a settled > float b~", "302 done > wait 332", "332 rest > exact b",
                               "372 done 40 > wait 492"});
    row("but not where the hand has moved since",
        floating + QStringList{"300 ask b drag float a settled > float b~", "302 done > wait 332",
                               "310 ask b drag float a > float b~", "312 done > wait 432"});
    row("that gives way to a hand that goes on",
        floating + QStringList{"300 ask b drag float a settled > float b~", "302 done > wait 332", "332 rest > exact b",
                               "333 ask b drag float a > cancelled", "334 cancelled > float b~"});
    row("what is exact already does not float back",
        floating + QStringList{"300 ask b drag float a settled > float b~", "302 done > wait 332", "332 rest > exact b",
                               "372 done 40 > wait 492", "380 ask b float a settled > exact b"});
    row("what is given up is exact",
        floating + QStringList{"210 lift none > wait 330", "210 ask a > exact a", "250 done 40 > wait 5250"});
    row("the first frame in another view replaces all",
        floating + QStringList{"216 ask a@2 drag float a > float a@2~ all", "218 done > wait 338",
                               "232 ask a@2 drag float a > float a@2~"});
    row("over what floats no frame is coarse",
        lifted + QStringList{"120 done > wait", "130 coarse on > wait",
                             "200 ask a drag float a > float a~ over exact all", "202 done > wait 322",
                             "210 ask b drag > exact b~"});
    row("a hand that does not wait gets it at once",
        lifted + QStringList{"105 ask a drag float a > cancelled", "106 cancelled > float a~ over exact all"});
    row("where it cannot be composed the frame is exact",
        floating + QStringList{"216 ask b drag float a > float b~", "217 unfit > exact b~", "257 done 40 > wait 377",
                               "260 ask c drag float a > float c~ all"});
    row("where it never can, all are",
        floating + QStringList{"216 ask b drag float a > float b~", "217 failed > exact b~", "257 done 40 > wait 377",
                               "260 ask c drag float a > exact c~", "300 done 40 > wait 420"});
    row("or coarse, where that is wanted",
        slowPainting + QStringList{"160 lift a > prepare lift over exact", "170 done > wait",
                                   "180 ask b drag float a > float b~ over exact all", "181 done > wait 301",
                                   "190 ask c > exact c", "230 done 40 > wait", "240 ask d drag float a > float d~ all",
                                   "241 failed > estimate c d~", "242 differs 4 5000 > coarse d~ from c"});
}

/// The two pictures are made ready at the press, and finer while the hand rests.
void TestFrameSchedule::liftsAreReady()
{
    const auto row = [](const char *name, const QStringList &lines) { QTest::newRow(name) << lines; };
    row("at the press, at once", lifted + QStringList{"110 done > wait"});
    row("not before there is a frame", {"0 lift a > wait", "1 ask a > exact a", "9 done > prepare lift over exact"});
    row("a request comes first", lifted + QStringList{"101 ask b > cancelled", "102 cancelled > exact b"});
    row("quick pictures are drawn finer when the hand rests",
        {"0 ask a > exact a", "40 done 40 > wait", "100 lift a > prepare lift over exact",
         "101 ask a drag float a > cancelled", "102 cancelled > float a~ over exact all", "110 done > wait 210",
         "150 lift a > wait 210", "209 rest > wait 210", "210 rest > prepare lift", "250 done > wait 370"});
    row("over a coarse frame it is not what is shown",
        slowGesture +
            QStringList{"205 done > wait 235", "206 lift a > wait 236", "210 ask a drag float a > float a~ all"});
    row("what cannot be made ready does not float",
        lifted + QStringList{"110 unfit > wait", "120 ask a drag float a > exact a~",
                             "160 done 40 > prepare lift over exact"});
    row("nor ever what failed",
        lifted + QStringList{"110 failed > wait", "120 ask a drag float a > exact a~", "160 done 40 > wait 280"});
    row("the pictures are let go",
        lifted + QStringList{"120 done > wait", "130 lift none > wait 5130", "5130 rest > forget", "5131 done > wait"});
}

void TestFrameSchedule::promises_data()
{
    QTest::addColumn<QStringList>("lines");
    requests();
    coarseFrames();
    coarseIsReady();
    devices();
    floatingFrames();
    liftsAreReady();
}

void TestFrameSchedule::promises()
{
    QFETCH(QStringList, lines);
    ScheduleStage stage;
    for (const QString &line : lines) {
        const QString event = line.section(" > ", 0, 0), expected = line.section(" > ", 1);
        const QString found = stage.after(event);
        QVERIFY2(found == expected, qPrintable(QString("%1: %2, not %3").arg(event, found, expected)));
    }
}

void TestFrameSchedule::whatIsSlow()
{
    ScheduleStage stage;
    QVERIFY(!stage.schedule.isSlowFor(1e9)); // nothing is known
    QVERIFY(!stage.schedule.canFloat());
    stage.after("0 ask a");
    stage.after("40 done 40");
    QCOMPARE(stage.schedule.shownSerial(), quint64(1));
    QVERIFY(stage.schedule.canFloat());
    QVERIFY(stage.schedule.isSlowFor(3001));
    QVERIFY(!stage.schedule.isSlowFor(2999));
    stage.after("50 ask b");
    stage.after("60 done 10 500"); // so few pixels tell nothing
    QVERIFY(!stage.schedule.isSlowFor(2999));
    stage.after("70 ask c");
    stage.after("80 done 10 2000");
    QVERIFY(stage.schedule.isSlowFor(2401));
    stage.after("90 ask d");
    QCOMPARE(stage.schedule.shownSerial(), quint64(3));
    stage.after("91 failed");
    QCOMPARE(stage.schedule.shownSerial(), quint64(4)); // there is no better answer
}

void TestFrameSchedule::whateverHappensTheLastFrameIsExact_data()
{
    QTest::addColumn<unsigned>("seed");
    for (unsigned seed = 1; seed <= 200; ++seed)
        QTest::newRow(qPrintable(QString::number(seed))) << seed;
}

/// Once nothing happens any more, the last request is answered exactly.
void TestFrameSchedule::whateverHappensTheLastFrameIsExact()
{
    QFETCH(unsigned, seed);
    RandomWalk walk(seed);
    for (int i = 0; i < 300; ++i)
        walk.step();
    for (int i = 0; i < 100; ++i)
        walk.comeToRest();
    QVERIFY2(walk.problem.isEmpty(), qPrintable(walk.problem + '\n' + walk.log));
    QCOMPARE(walk.state, QString("wait"));
    QVERIFY2(walk.stage.schedule.shownSerial() == walk.asked, qPrintable(walk.log));
}

QTEST_GUILESS_MAIN(TestFrameSchedule)
#include "test_frame_schedule.moc"
