// Saving while it is painted on, failing, and other programs that write to the same file.
#include "app/session/settings/settings.h"
#include "app/widgets/asking/messages.h"
#include "model/formats/atomic_save.h"
#include "model/formats/files.h"
#include "tests/app/session.h"

#include <QDeadlineTimer>
#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QStatusBar>
#include <QTemporaryDir>

using namespace suffuse;

class TestSaving : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_BACKEND", "cpu");
    }

    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        qputenv("SUFFUSE_SETTINGS", path("settings.ini").toLocal8Bit());
        m_errors.clear();
        m_asked = m_askedSaving = 0;
        m_answer = ConflictAnswer::Cancel;
        MessageHooks hooks;
        hooks.error = [this](const QString &message) { m_errors << message; };
        hooks.unsaved = [](const QString &) { return SaveAnswer::Discard; };
        hooks.conflict = [this](const QString &, bool saving) {
            ++(saving ? m_askedSaving : m_asked);
            return m_answer;
        };
        setMessageHooks(hooks);
    }
    void cleanupTestCase() { setMessageHooks({}); }

    void paintingGoesOnMeanwhile()
    {
        Session s;
        s.paintLine({200, 300}, {700, 300});
        QVERIFY(s.window.saveTo(path("a.suffuse")));
        s.paintLine({200, 400}, {700, 400});
        const QByteArray snapshot = hashOf(s.painting());
        s.use(Command::Save);
        QVERIFY(s.editor().isSaving());
        QVERIFY(s.window.isWindowModified());
        s.paintLine({200, 500}, {700, 500});
        QTRY_VERIFY_WITH_TIMEOUT(!s.editor().isSaving(), waitMs);
        QCOMPARE(hashOf(*loadPainting(path("a.suffuse"))), snapshot);
        QVERIFY(s.window.isWindowModified());
        QVERIFY2(s.window.statusBar()->currentMessage().contains("a.suffuse"),
                 qPrintable(s.window.statusBar()->currentMessage()));
        s.use(Command::Undo); // to the step that was saved
        QVERIFY(!s.window.isWindowModified());
        s.use(Command::Undo);
        QVERIFY(s.window.isWindowModified());
        QCOMPARE(m_askedSaving + m_asked, 0);
    }

    void theLastOfManySavesWins()
    {
        Session s;
        QSignalSpy told(&s.editor(), &Editor::saved);
        for (int i = 0; i < 5; ++i) {
            s.paintLine({200, 100.0 + 100 * i}, {700, 120.0 + 100 * i});
            s.editor().startSaving(path("a.suffuse"), true);
        }
        QTRY_VERIFY_WITH_TIMEOUT(!s.editor().isSaving(), waitMs);
        QVERIFY(told.count() >= 1 && told.count() <= 5);
        QCOMPARE(hashOf(*loadPainting(path("a.suffuse"))), hashOf(s.painting()));
        QVERIFY(!s.window.isWindowModified());
    }

    /// A save that is ordered after another one was written, and before the window heard of that, expects the file as it
    /// was: the window's own bytes are not another program's.
    void theOwnSaveIsNotAnotherPrograms()
    {
        Session s;
        for (int i = 0; i < 4; ++i)
            s.paintLine({200, 100.0 + 100 * i}, {700, 120.0 + 100 * i});
        QVERIFY(s.window.saveTo(path("a.suffuse")));
        for (int i = 0; i < 3; ++i) {
            const auto before = hashOfFile(path("a.suffuse"));
            s.use(Command::Undo);
            s.use(Command::Save);
            QDeadlineTimer deadline(waitMs); // No event is handled meanwhile.
            while (hashOfFile(path("a.suffuse")) == before && !deadline.hasExpired())
                QThread::msleep(1);
            QVERIFY2(!deadline.hasExpired(), qPrintable(QString::number(i)));
        }
        QTRY_VERIFY_WITH_TIMEOUT(!s.editor().isSaving(), waitMs);
        QCOMPARE(m_askedSaving, 0);
        QCOMPARE(hashOf(*loadPainting(path("a.suffuse"))), hashOf(s.painting()));
        QVERIFY(!s.window.isWindowModified());
    }

    void whatFailsStaysModified()
    {
        Session s;
        s.paintLine({200, 300}, {700, 300});
        QVERIFY(s.window.saveTo(path("a.suffuse")));
        s.paintLine({200, 400}, {700, 400});
        int offered = 0;
        MessageHooks hooks;
        hooks.unsaved = [](const QString &) { return SaveAnswer::Discard; };
        hooks.saveFailed = [&](const QString &message) {
            ++offered;
            m_errors << message;
            return false;
        };
        setMessageHooks(hooks);
        QVERIFY(!s.window.saveTo(path("gone/a.suffuse")));
        QVERIFY(QDir().mkdir(path("folder.suffuse")));
        QVERIFY(!s.window.saveTo(path("folder.suffuse")));
        QCOMPARE(offered, 2);
        QVERIFY2(m_errors[0].contains("does not exist"), qPrintable(m_errors[0]));
        QVERIFY(s.window.isWindowModified());
        QVERIFY(s.window.windowTitle().startsWith("a.suffuse"));
        QVERIFY(s.window.saveTo(path("a.suffuse")));
        QVERIFY(!s.window.isWindowModified());
    }

    void closingWaitsForTheFile()
    {
        Session s;
        s.paintLine({200, 300}, {700, 300});
        s.editor().startSaving(path("a.suffuse"), true);
        QVERIFY(s.window.close());
        QCOMPARE(hashOf(*loadPainting(path("a.suffuse"))), hashOf(s.painting()));
    }

    void sameBytesAreNoChange()
    {
        Session s;
        s.paintLine({200, 300}, {700, 300});
        QVERIFY(s.window.saveTo(path("a.suffuse")));
        QVERIFY(put("a.suffuse", bytesOf("a.suffuse")));
        QTest::qWait(1'000);
        QCOMPARE(m_asked, 0);
        QVERIFY(!s.window.isWindowModified());
    }

    /// A question that comes up over another window would take the keys that are meant for that one.
    void aWindowBehindAsksWhenItsTurnComes()
    {
        Session s;
        s.paintLine({200, 300}, {700, 300});
        QVERIFY(s.window.saveTo(path("a.suffuse")));
        QWidget other;
        other.show();
        other.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&other));
        Painting changed;
        changed.canvas.width = 555;
        m_answer = ConflictAnswer::Reload;
        QVERIFY(savePainting(changed, path("a.suffuse")));
        QTRY_VERIFY_WITH_TIMEOUT(s.window.statusBar()->currentMessage().contains("a.suffuse") &&
                                     !s.window.statusBar()->currentMessage().startsWith("Sav"),
                                 waitMs);
        QCOMPARE(m_asked, 0);
        s.window.activateWindow();
        QTRY_COMPARE_WITH_TIMEOUT(m_asked, 1, waitMs);
        QTRY_COMPARE_WITH_TIMEOUT(s.painting().canvas.width, 555.0, waitMs);
    }

    void anotherProgramsBytesAreAskedAbout()
    {
        Session s;
        s.paintLine({200, 300}, {700, 300});
        QVERIFY(s.window.saveTo(path("a.suffuse")));
        const QByteArray first = bytesOf("a.suffuse");
        const QByteArray mine = hashOf(s.painting());
        Painting other;
        other.canvas.width = 555;

        m_answer = ConflictAnswer::Reload;
        QVERIFY(savePainting(other, path("a.suffuse")));
        QTRY_COMPARE_WITH_TIMEOUT(m_asked, 1, waitMs);
        QCOMPARE(s.painting().canvas.width, 555.0);
        QVERIFY(!s.window.isWindowModified());
        s.use(Command::Undo); // nothing is lost
        QCOMPARE(hashOf(s.painting()), mine);
        QVERIFY(s.window.isWindowModified());
        s.use(Command::Redo);
        QVERIFY(!s.window.isWindowModified());

        m_answer = ConflictAnswer::KeepMine; // the watcher has not lost the file that was put in place
        QVERIFY(put("a.suffuse", first));
        QTRY_COMPARE_WITH_TIMEOUT(m_asked, 2, waitMs);
        QCOMPARE(s.painting().canvas.width, 555.0);
        QVERIFY(s.window.isWindowModified());
        QVERIFY(s.window.saveTo(path("a.suffuse")));
        QCOMPARE(m_askedSaving, 0); // that was answered
        QCOMPARE(loadPainting(path("a.suffuse"))->canvas.width, 555.0);
        QVERIFY(mine != hashOf(s.painting()));
    }

    void savingLooksOnceMore()
    {
        Session s;
        s.paintLine({200, 300}, {700, 300});
        QVERIFY(s.window.saveTo(path("a.suffuse")));
        Painting other;
        other.canvas.width = 555;
        QVERIFY(savePainting(other, path("a.suffuse")));
        QVERIFY(!s.window.saveTo(path("a.suffuse"))); // before the watcher could say anything
        QCOMPARE(m_askedSaving, 1);
        QCOMPARE(loadPainting(path("a.suffuse"))->canvas.width, 555.0);
        QVERIFY(s.window.isWindowModified());
        m_answer = ConflictAnswer::KeepMine;
        QVERIFY(s.window.saveTo(path("a.suffuse")));
        QCOMPARE(m_askedSaving, 2);
        QCOMPARE(hashOf(*loadPainting(path("a.suffuse"))), hashOf(s.painting()));
    }

    void aFileThatIsGoneIsWrittenAnew()
    {
        Session s;
        s.paintLine({200, 300}, {700, 300});
        QVERIFY(s.window.saveTo(path("a.suffuse")));
        QVERIFY(QFile::remove(path("a.suffuse")));
        QTRY_VERIFY_WITH_TIMEOUT(s.window.isWindowModified(), waitMs);
        QVERIFY(s.window.saveTo(path("a.suffuse")));
        QVERIFY(QFile::exists(path("a.suffuse")));
        QVERIFY(!s.window.isWindowModified());
    }

    void damagedFilesOpenWithWhatIsWhole()
    {
        Session s;
        s.paintLine({200, 300}, {700, 300});
        QVERIFY(s.window.saveTo(path("a.suffuse")));
        QByteArray damaged = bytesOf("a.suffuse");
        const qsizetype at = damaged.indexOf("STRK");
        QVERIFY(at > 0);
        damaged[at + 20] = char(damaged[at + 20] ^ 1);
        QVERIFY(put("b.suffuse", damaged));
        Session other;
        QCOMPARE(other.window.openFile(path("b.suffuse")), &other.window);
        QCOMPARE(m_errors.size(), 1);
        QVERIFY2(m_errors[0].contains("b.suffuse"), qPrintable(m_errors[0]));
        QVERIFY(other.painting().strokes.empty());
        QCOMPARE(other.painting().canvas, s.painting().canvas);
        QVERIFY(other.editor().filePath().isEmpty());
        QVERIFY(other.window.isWindowModified());
        QVERIFY(other.window.windowTitle().startsWith("b.suffuse"));
        QCOMPARE(bytesOf("b.suffuse"), damaged);
    }

    void backupsAreKeptWhereWanted()
    {
        settings::setBackups(0);
        Session s;
        s.paintLine({200, 300}, {700, 300});
        QVERIFY(s.window.saveTo(path("a.suffuse")));
        s.paintLine({200, 400}, {700, 400});
        QVERIFY(s.window.saveTo(path("a.suffuse")));
        QVERIFY(!QFile::exists(backupName(path("a.suffuse"), 1)));
        settings::setBackups(2);
        s.paintLine({200, 500}, {700, 500});
        QVERIFY(s.window.saveTo(path("a.suffuse")));
        QCOMPARE(loadPainting(path("a.suffuse"))->strokes.size(), std::size_t(3));
        QCOMPARE(loadPainting(backupName(path("a.suffuse"), 1))->strokes.size(), std::size_t(2));
    }

private:
    QString path(const QString &name) const { return m_folder->filePath(name); }
    QByteArray bytesOf(const QString &name) const
    {
        QFile file(path(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    bool put(const QString &name, const QByteArray &bytes) const
    {
        QFile file(path(name));
        return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size();
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    QStringList m_errors;
    ConflictAnswer m_answer = ConflictAnswer::Cancel;
    int m_asked = 0, m_askedSaving = 0;
};

QTEST_MAIN(TestSaving)
#include "test_saving.moc"
