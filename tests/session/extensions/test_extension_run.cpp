// Programs of extensions: what they make is one step, and whatever they do wrong changes nothing. SUFFUSE_TRIALS=100,
// or SUFFUSE_LONG=1, does wrong a hundred times.
#include "app/extensions/confinement.h"
#include "app/extensions/field_values.h"
#include "app/session/editor.h"
#include "app/session/extensions/extension_library.h"
#include "extension_folder.h"
#include "tests/trials.h"

#include <QElapsedTimer>
#include <QFileInfo>
#include <QRandomGenerator>

#include <thread>

#include <signal.h>

using namespace suffuse;

namespace {

const std::atomic<bool> notCancelled = false;

/// Takes what was passed as the result.
const QByteArray copies = "cp \"$SUFFUSE_PAINTING\" \"$SUFFUSE_RESULT\"\n";
/// Makes all strokes twice as dense as it is written for.
const QByteArray densifies =
    "sed 's/\"density\": *[0-9.]*/\"density\": 5/g' \"$SUFFUSE_PAINTING\" > \"$SUFFUSE_RESULT\"\n";

struct Misdeed {
    const char *name;
    QByteArray script;
    const char *says;        ///< a part of the error
    QByteArray members = {}; ///< of the manifest
};

const QByteArray &tightLimits()
{
    static const QByteArray limits = R"(, "limits": {"seconds": 30, "memory": 200, "written": 16})";
    return limits;
}

/// Those that need no time.
QList<Misdeed> misdeeds()
{
    return {
        {"fails", "echo no such paint >&2; exit 3", "exit code 3). The painting is as it was. It wrote: no such paint"},
        {"says what is wrong", "echo error: Select an area. >&2; exit 1", "misdeed-1: Select an area."},
        {"fails with a result", copies + "exit 1", "exit code 1"},
        {"is killed", copies + "kill -9 $$", "killed or crashed"},
        {"crashes", "kill -SEGV $$", "killed or crashed"},
        {"writes nothing", "exit 0", "it wrote no result"},
        {"writes an empty result", ": > \"$SUFFUSE_RESULT\"", "its result is empty"},
        {"writes rubbish", "head -c 100000 /dev/urandom > \"$SUFFUSE_RESULT\"", "Its result is not used"},
        {"writes other JSON", "echo '{\"format\": \"suffuse-text\"}' > \"$SUFFUSE_RESULT\"", "Its result is not used"},
        {"cuts its result off", "head -c 300 \"$SUFFUSE_PAINTING\" > \"$SUFFUSE_RESULT\"", "cut off"},
        {"writes impossible values",
         "sed 's/\"density\": *[0-9.]*/\"density\": -1/' \"$SUFFUSE_PAINTING\" > \"$SUFFUSE_RESULT\"",
         "density: -1 is not in"},
        {"uses an id twice", "sed 's/\"id\": *2,/\"id\": 1,/' \"$SUFFUSE_PAINTING\" > \"$SUFFUSE_RESULT\"",
         "Its result is not used"},
        {"links to another file", "ln -s \"$SUFFUSE_PAINTING\" \"$SUFFUSE_RESULT\"", "it wrote no result"},
        {"makes a pipe of it", "mkfifo \"$SUFFUSE_RESULT\"", "Its result is not used"},
        {"makes a folder of it", "mkdir \"$SUFFUSE_RESULT\"", "Its result is not used"},
        {"writes a large file", "head -c 40000000 /dev/zero > \"$SUFFUSE_RESULT\"", "wrote more than 16 MB", tightLimits()},
        {"fills the disk", "i=0; while :; do head -c 4000000 /dev/zero > big$i || exit 9; i=$((i+1)); done",
         "wrote more than 16 MB", tightLimits()},
        {"fills memory", "x=0123456789abcdef; while :; do x=$x$x; done", "The painting is as it was", tightLimits()},
        {"talks without end and fails", "head -c 5000000 /dev/zero | tr '\\0' x >&2; exit 4", "exit code 4"},
    };
}

} // namespace

class TestExtensionRun : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
        QVERIFY(QDir().mkpath(m_folder.filePath("temporary")));
        qputenv("TMPDIR", m_folder.filePath("temporary").toLocal8Bit());
        qInfo("%s", qPrintable(confinement().why));
    }

    /// What it makes is one step with its name, and the strokes that stay equal are shared.
    void aResultIsOneStep()
    {
        Editor editor;
        editor.newPainting({});
        editor.restore(*threeStrokes(), "begin");
        const PaintingPtr before = editor.document().painting();
        const int steps = editor.undoStack().count();
        ExtensionOrder order = orderFor(
            editor, "dense",
            "sed '0,/\"density\"/s/\"density\": *[0-9.]*/\"density\": 5/' \"$SUFFUSE_PAINTING\" > \"$SUFFUSE_RESULT\"\n"
            "echo 'progress: 0.5 half of it' >&2\n"
            "echo 'say: One stroke is denser.' >&2\n"
            "echo 'progress: 1' >&2\n");
        QStringList progress;
        const ExtensionOutcome outcome = runExtension(order, notCancelled, [&](double share, const QString &what) {
            progress << QString::number(share) + ' ' + what;
        });
        QVERIFY2(outcome.error.isEmpty(), qPrintable(outcome.error + outcome.log));
        QCOMPARE(progress, QStringList({"0.5 half of it", "1 "}));
        QCOMPARE(outcome.said, "One stroke is denser.");
        QVERIFY(editor.document().painting() == before);
        QVERIFY(applyExtension(editor, order, outcome));
        const PaintingPtr after = editor.document().painting();
        QCOMPARE(editor.undoStack().count(), steps + 1);
        QCOMPARE(editor.undoText(), "Test dense");
        QCOMPARE(after->find(1)->segments[0].density, 5.0f);
        QVERIFY(after->find(2) == before->find(2));
        QVERIFY(after->find(3) == before->find(3));
        editor.undo();
        QCOMPARE(hashOf(*editor.document().painting()), hashOf(*before));

        // Of a painting that is another one by now nothing is made.
        editor.redo();
        QVERIFY(!applyExtension(editor, order, outcome));
        QCOMPARE(editor.undoStack().count(), steps + 1);
    }

    /// What changes nothing is no step.
    void anEqualResultIsNoStep()
    {
        Editor editor;
        editor.newPainting({});
        editor.restore(*threeStrokes(), "begin");
        const int steps = editor.undoStack().count();
        for (const QByteArray form : {"text", "suffuse"}) {
            ExtensionOrder order = orderFor(editor, "same-" + form, copies, ", \"form\": \"" + form + "\"");
            const ExtensionOutcome outcome = runExtension(order, notCancelled);
            QVERIFY2(outcome.error.isEmpty(), qPrintable(outcome.error));
            QCOMPARE(hashOf(*outcome.painting), hashOf(*order.painting));
            QVERIFY(applyExtension(editor, order, outcome));
            QCOMPARE(editor.undoStack().count(), steps);
        }
    }

    /// A part goes out and comes back into its place.
    void onlyThePartIsPassed_data()
    {
        QTest::addColumn<QByteArray>("passes");
        QTest::addColumn<QList<int>>("denser");
        QTest::newRow("selection") << QByteArray("selection") << QList<int>{2};
        QTest::newRow("layer") << QByteArray("layer") << QList<int>{3};
        QTest::newRow("painting") << QByteArray("painting") << QList<int>{1, 2, 3};
    }
    void onlyThePartIsPassed()
    {
        QFETCH(const QByteArray, passes);
        QFETCH(const QList<int>, denser);
        ExtensionOrder order =
            orderWith(threeStrokes(), "part-" + passes, densifies, ", \"passes\": \"" + passes + "\"");
        order.selected = {2};
        order.layer = 7;
        const ExtensionOutcome outcome = runExtension(order, notCancelled);
        QVERIFY2(outcome.error.isEmpty(), qPrintable(outcome.error + outcome.log));
        QCOMPARE(orderOf(*outcome.painting), orderOf(*order.painting));
        for (const int id : {1, 2, 3})
            QCOMPARE(outcome.painting->find(StrokeId(id))->segments[0].density == 5.0f, denser.contains(id));
    }

    void nothingSelectedIsSaid()
    {
        ExtensionOrder order = orderWith(threeStrokes(), "none", copies, R"(, "passes": "selection")");
        QVERIFY(runExtension(order, notCancelled).error.contains("Select strokes first"));
    }

    /// The program is told what was chosen, and the file that it writes comes to where it was wanted.
    void valuesAndFilesArePassed()
    {
        ExtensionOrder order =
            orderWith(threeStrokes(), "files",
                      "printf '%s %s' \"$SUFFUSE_VALUE_gap\" \"$SUFFUSE_LANGUAGE\" > \"$SUFFUSE_VALUE_target\"\n"
                      "grep -q '\"gap\": 2.5' \"$SUFFUSE_JOB\"",
                      R"(, "returns": "nothing", "fields": [
 {"type": "number", "id": "gap", "label": "Gap", "least": 0, "most": 9, "default": 1},
 {"type": "file", "id": "target", "label": "File", "mode": "save", "endings": ["txt"]}])");
        const QString target = m_folder.filePath("written here.txt");
        order.values = {{"gap", 2.5}, {"target", target}};
        order.language = "de";
        ExtensionOutcome outcome = runExtension(order, notCancelled);
        QVERIFY2(outcome.error.isEmpty(), qPrintable(outcome.error + outcome.log));
        QVERIFY(!outcome.painting);
        QCOMPARE(bytesOf(target), "2.5 de");

        order.extension =
            extensionIn(writeExtension(m_folder.path(), "fails-late", "echo other > \"$SUFFUSE_VALUE_target\"; exit 1",
                                       R"(, "returns": "nothing", "fields": [
 {"type": "file", "id": "target", "label": "File", "mode": "save", "endings": ["txt"]}])"));
        outcome = runExtension(order, notCancelled);
        QVERIFY(!outcome.error.isEmpty());
        QCOMPARE(bytesOf(target), "2.5 de"); // it is as it was
    }

    void whateverGoesWrongChangesNothing()
    {
        Editor editor;
        editor.newPainting({});
        editor.restore(*threeStrokes(), "begin");
        const QByteArray hash = hashOf(*editor.document().painting());
        const int steps = editor.undoStack().count();
        const QList<Misdeed> all = misdeeds();
        const int times = trials(int(all.size()), 100);
        int unchanged = 0;
        for (int i = 0; i < times; ++i) {
            const Misdeed &misdeed = all[i % all.size()];
            const ExtensionOrder order =
                orderFor(editor, QStringLiteral("misdeed-%1").arg(i % all.size()), misdeed.script, misdeed.members);
            const ExtensionOutcome outcome = runExtension(order, notCancelled);
            QVERIFY2(outcome.error.contains(misdeed.says) || outcome.log.contains(misdeed.says),
                     qPrintable(QString(misdeed.name) + ": " + outcome.error + " | " + outcome.log.left(500)));
            QVERIFY2(outcome.error.startsWith("Test misdeed") && outcome.error.size() < 1000,
                     qPrintable(outcome.error));
            QVERIFY(!outcome.painting && outcome.log.size() < 40'000);
            QVERIFY(applyExtension(editor, order, outcome));
            unchanged += hashOf(*editor.document().painting()) == hash && editor.undoStack().count() == steps;
        }
        qInfo("%d of %d", unchanged, times);
        QCOMPARE(unchanged, times);
        QVERIFY(QDir(m_folder.filePath("temporary")).isEmpty()); // Each folder went with its run.
    }

    /// A program that is killed at any moment, by whomever.
    void killedAtRandom()
    {
        const PaintingPtr painting = threeStrokes();
        const QByteArray hash = hashOf(*painting);
        QRandomGenerator random(firstSeed() + 1);
        const int times = trials(4, 40);
        int killed = 0;
        for (int i = 0; i < times; ++i) {
            ExtensionOrder order =
                orderWith(painting, "killed",
                          "echo \"progress: 0.5 $$\" >&2; " + copies +
                              "sleep 0.0$(($$ % 9)); echo \"progress: 0.6\" >&2; " + copies + "kill -9 $$");
            const int wait = random.bounded(30);
            std::atomic<bool> cancel = false;
            std::jthread later;
            const ExtensionOutcome outcome = runExtension(order, cancel, [&](double share, const QString &) {
                if (share == 0.5)
                    later = std::jthread([&cancel, wait] {
                        std::this_thread::sleep_for(std::chrono::milliseconds(wait));
                        cancel = true;
                    });
            });
            later = {};
            killed += outcome.cancelled || outcome.error.contains("killed");
            QVERIFY(!outcome.painting);
            QCOMPARE(hashOf(*painting), hash);
        }
        QCOMPARE(killed, times);
    }

    /// One that hangs is ended with all that it started, whatever these do against it.
    void oneThatHangsIsEnded()
    {
        const QByteArray stubborn = "trap '' TERM INT HUP\n"
                                    "(setsid sh -c 'trap \"\" TERM; while :; do sleep 1000; done' &)\n"
                                    "echo \"say: $SUFFUSE_JOB\" >&2\n"
                                    "while :; do sleep 1000; done\n";
        ExtensionOrder order = orderWith(threeStrokes(), "hangs", stubborn, R"(, "limits": {"seconds": 1})");
        const ExtensionOutcome outcome = runExtension(order, notCancelled);
        QVERIFY2(outcome.error.contains("as long as it may take"), qPrintable(outcome.error));
        QVERIFY(!outcome.said.isEmpty());
        QCOMPARE(ProcessTree("SUFFUSE_JOB=" + outcome.said.toUtf8()).use().memory, 0); // none is left
        QVERIFY(!QFileInfo::exists(outcome.said));

        // The same by hand.
        order = orderWith(threeStrokes(), "stopped", "echo \"progress: 0.1\" >&2\n" + stubborn);
        std::atomic<bool> cancel = false;
        const ExtensionOutcome stopped = runExtension(order, cancel, [&](double, const QString &) { cancel = true; });
        QVERIFY(stopped.cancelled && stopped.error.isEmpty() && !stopped.painting);
    }

    /// What is left behind by a program that ends well goes with it, too.
    void nothingRunsOn()
    {
        ExtensionOrder order =
            orderWith(threeStrokes(), "leaves", "(setsid sleep 1000 &)\necho \"say: $SUFFUSE_JOB\" >&2\n" + copies);
        const ExtensionOutcome outcome = runExtension(order, notCancelled);
        QVERIFY2(outcome.error.isEmpty(), qPrintable(outcome.error));
        QCOMPARE(ProcessTree("SUFFUSE_JOB=" + outcome.said.toUtf8()).use().memory, 0);
    }

    /// Where bubblewrap works, a program writes nowhere else, and reaches nobody.
    void programsAreConfined()
    {
        if (confinement().bubblewrap.isEmpty())
            QSKIP("bubblewrap is not installed, or does not work here");
        const QString outside = m_folder.filePath("outside");
        ExtensionOrder order =
            orderWith(threeStrokes(), "escapes",
                      "touch '" + outside.toUtf8() +
                          "' 2>/dev/null && echo wrote >&2\n"
                          "echo x 2>/dev/null >> \"$SUFFUSE_PAINTING\" && echo changed >&2\n"
                          "[ \"$(tail -n +3 /proc/net/dev | grep -vc '^ *lo:')\" = 0 ] || echo network >&2\n"
                          "[ $(ls -d /proc/[0-9]* | wc -l) -lt 12 ] || echo processes >&2\n" +
                          copies);
        const ExtensionOutcome outcome = runExtension(order, notCancelled);
        QVERIFY2(outcome.error.isEmpty(), qPrintable(outcome.error));
        QCOMPARE(outcome.log, QString());
        QVERIFY(!QFileInfo::exists(outside));
    }

private:
    ExtensionOrder orderWith(const PaintingPtr &painting, const QString &id, const QByteArray &script,
                             const QByteArray &members = {})
    {
        ExtensionOrder order;
        order.extension = extensionIn(writeExtension(m_folder.path(), id, script, members));
        order.values = usualValues(order.extension);
        order.painting = painting;
        order.language = "en";
        return order;
    }
    ExtensionOrder orderFor(Editor &editor, const QString &id, const QByteArray &script, const QByteArray &members = {})
    {
        const Extension extension = extensionIn(writeExtension(m_folder.path(), id, script, members));
        return extensionOrder(editor, extension, usualValues(extension));
    }

    QTemporaryDir m_folder;
};

QTEST_GUILESS_MAIN(TestExtensionRun)
#include "test_extension_run.moc"
