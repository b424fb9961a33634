// Earlier versions: kept when one takes another one's place, never twice, and brought back as a step like any other.
#include "app/dialogs/backups_dialog.h"
#include "app/session/settings/settings.h"
#include "app/widgets/asking/messages.h"
#include "model/formats/atomic_save.h"
#include "model/formats/files.h"
#include "tests/app/file_dialogs.h"
#include "tests/app/session.h"

#include <QDir>
#include <QFile>
#include <QPushButton>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTreeWidget>

using namespace suffuse;

class TestBackups : public QObject {
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
        m_questions.clear();
        m_answered = 0;
        m_mayRevert = true;
        MessageHooks hooks;
        hooks.error = [this](const QString &message) { m_errors << message; };
        hooks.unsaved = [](const QString &) { return SaveAnswer::Discard; };
        hooks.confirm = [this](const QString &question) {
            m_questions << question;
            return m_mayRevert;
        };
        setMessageHooks(hooks);
    }
    void cleanup() { QVERIFY2(m_errors.isEmpty(), qPrintable(m_errors.join('\n'))); }
    void cleanupTestCase() { setMessageHooks({}); }

    /// With settings that nobody has touched.
    void anUnmodifiedSaveWritesNothing()
    {
        Session s;
        saveVersions(s, 3);
        QCOMPARE(strokesIn(backupName(path("a.suffuse"), 1)), 2);
        QCOMPARE(strokesIn(backupName(path("a.suffuse"), 2)), 1);
        QVERIFY(!QFile::exists(backupName(path("a.suffuse"), 3)));
        QFile file(path("a.suffuse"));
        QVERIFY(file.open(QIODevice::ReadWrite));
        QVERIFY(file.setFileTime(QDateTime::fromSecsSinceEpoch(1'000'000), QFileDevice::FileModificationTime));
        file.close();
        s.canvas().zoomBy(1.3); // is nothing that was painted
        for (int i = 0; i < 3; ++i) {
            s.use(Command::Save);
            QTRY_VERIFY_WITH_TIMEOUT(!s.editor().isSaving(), waitMs);
        }
        QCOMPARE(QFileInfo(path("a.suffuse")).lastModified().toSecsSinceEpoch(), qint64(1'000'000));
        QCOMPARE(strokesIn(backupName(path("a.suffuse"), 1)), 2);
        QCOMPARE(strokesIn(backupName(path("a.suffuse"), 2)), 1);
        QVERIFY(s.window.statusBar()->currentMessage().contains("a.suffuse"));
        QVERIFY(!s.window.isWindowModified());
        // What is gone is written, however little was done.
        QVERIFY(QFile::remove(path("a.suffuse")));
        s.use(Command::Save);
        QTRY_VERIFY_WITH_TIMEOUT(!s.editor().isSaving(), waitMs);
        QCOMPARE(strokesIn(path("a.suffuse")), 3);
    }

    /// Under whatever name and by whatever way they are written.
    void equalBytesNeverRotate()
    {
        Session s;
        saveVersions(s, 3);
        const QByteArray bytes = bytesOf("a.suffuse");
        for (int i = 0; i < 3; ++i) {
            s.editor().startSaving(path("a.suffuse"), true);
            QTRY_VERIFY_WITH_TIMEOUT(!s.editor().isSaving(), waitMs);
        }
        QCOMPARE(bytesOf("a.suffuse"), bytes);
        QCOMPARE(strokesIn(backupName(path("a.suffuse"), 1)), 2);
        QCOMPARE(strokesIn(backupName(path("a.suffuse"), 2)), 1);
        // A save that failed after the backup was made leaves one that the next save need not make again.
        for (int i = 0; i < 3; ++i)
            QVERIFY(keepBackups(path("a.suffuse"), 2));
        QCOMPARE(strokesIn(backupName(path("a.suffuse"), 1)), 3);
        QCOMPARE(strokesIn(backupName(path("a.suffuse"), 2)), 2);
    }

    void damageIsMendedBySaving()
    {
        Session s;
        s.paintLine({200, 300}, {700, 300});
        QVERIFY(s.window.saveTo(path("a.suffuse")));
        const QByteArray whole = bytesOf("a.suffuse");
        s.window.hide();
        QByteArray damaged = whole;
        damaged[3] = char(damaged[3] ^ 4); // of the signature
        QFile file(path("a.suffuse"));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(damaged) == damaged.size());
        file.close();
        Session t;
        QVERIFY(t.window.openFile(path("a.suffuse")));
        QCOMPARE(hashOf(t.painting()), hashOf(s.painting()));
        QCOMPARE(t.editor().filePath(), path("a.suffuse"));
        QVERIFY2(t.window.statusBar()->currentMessage().contains("first bytes"),
                 qPrintable(t.window.statusBar()->currentMessage()));
        t.use(Command::Save);
        QTRY_VERIFY_WITH_TIMEOUT(!t.editor().isSaving(), waitMs);
        QVERIFY(loadPainting(path("a.suffuse")));
        QVERIFY(t.editor().leftOut().isEmpty());
    }

    void aBackupIsRestoredAsAStep()
    {
        Session s;
        saveVersions(s, 3);
        const QByteArray newest = hashOf(s.painting()), file = bytesOf("a.suffuse");
        whenAsked<BackupsDialog>(this, m_answered, [this](BackupsDialog &dialog) {
            QTreeWidget &list = *dialog.list();
            QCOMPARE(list.topLevelItemCount(), 2);
            QTRY_COMPARE_WITH_TIMEOUT(list.topLevelItem(1)->text(1), QString("1"), waitMs); // read on a thread
            QCOMPARE(list.topLevelItem(0)->text(1), QString("2"));
            QVERIFY(list.topLevelItem(0)->isSelected());
            QVERIFY(!list.topLevelItem(1)->text(0).isEmpty() && !list.topLevelItem(1)->text(2).isEmpty());
            const QImage picture =
                list.topLevelItem(1)->icon(0).pixmap(list.iconSize()).toImage().convertToFormat(QImage::Format_ARGB32);
            QVERIFY(picture.pixelColor(picture.rect().center()).alpha() > 0);
            list.setCurrentItem(list.topLevelItem(1));
            QTest::mouseClick(dialog.restoreButton(), Qt::LeftButton);
        });
        s.use(Command::RestoreBackup);
        QCOMPARE(m_answered, 1);
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        QCOMPARE(s.editor().filePath(), path("a.suffuse"));
        QVERIFY(s.window.isWindowModified());
        QCOMPARE(bytesOf("a.suffuse"), file);
        QCOMPARE(s.editor().clock().time(), s.painting().end());
        QVERIFY(s.window.statusBar()->currentMessage().contains("is back"));
        s.use(Command::Undo); // then it is not
        QCOMPARE(s.window.statusBar()->currentMessage(), QString());
        QCOMPARE(hashOf(s.painting()), newest);
        QVERIFY(!s.window.isWindowModified());
        s.use(Command::Redo);
        s.use(Command::Save);
        QTRY_VERIFY_WITH_TIMEOUT(!s.editor().isSaving(), waitMs);
        QCOMPARE(strokesIn(path("a.suffuse")), 1);
        QCOMPARE(strokesIn(backupName(path("a.suffuse"), 1)), 3); // nothing is lost
    }

    /// Then there is no step that undo could take back, and it would take back the one before.
    void aBackupThatIsWhatIsSeen()
    {
        Session s;
        saveVersions(s, 3);
        for (int i = 0; i < 2; ++i) {
            m_answered = 0;
            whenAsked<BackupsDialog>(this, m_answered, [](BackupsDialog &dialog) {
                dialog.list()->setCurrentItem(dialog.list()->topLevelItem(1));
                QTest::mouseClick(dialog.restoreButton(), Qt::LeftButton);
            });
            s.use(Command::RestoreBackup);
            QCOMPARE(m_answered, 1);
            QCOMPARE(s.painting().strokes.size(), std::size_t(1));
            const QString said = s.window.statusBar()->currentMessage();
            QVERIFY2(said.contains(i == 0 ? "is back" : "nothing has changed"), qPrintable(said));
        }
        const int steps = s.editor().undoStack().index();
        s.use(Command::Undo);
        QCOMPARE(s.painting().strokes.size(), std::size_t(3));
        QCOMPARE(s.editor().undoStack().index(), steps - 1);
    }

    /// In the past an edit would be put to its place in time.
    void aBackupIsRestoredFromThePast()
    {
        Session s;
        saveVersions(s, 2);
        s.editor().clock().lookAt(100'000);
        QVERIFY(s.editor().clock().isInPast());
        const auto backup = loadPainting(backupName(path("a.suffuse"), 1));
        s.editor().restore(*backup, "Restore");
        QVERIFY(s.painting() == *backup);
        QVERIFY(!s.editor().clock().isInPast());
    }

    void withoutBackupsTheDialogSaysSo()
    {
        Session s;
        QVERIFY(!s.window.action(Command::RestoreBackup).isEnabled()); // it has no file
        QVERIFY(!s.window.action(Command::Revert).isEnabled());
        QVERIFY(s.window.saveTo(path("a.suffuse")));
        QVERIFY(s.window.action(Command::RestoreBackup).isEnabled());
        QVERIFY(s.window.action(Command::Revert).isEnabled());
        BackupsDialog dialog(path("a.suffuse"));
        QCOMPARE(dialog.list()->topLevelItemCount(), 0);
        QVERIFY(!dialog.restoreButton()->isEnabled());
    }

    void whatCannotBeReadIsNotOffered()
    {
        Session s;
        saveVersions(s, 2);
        QFile file(backupName(path("a.suffuse"), 1));
        QVERIFY(QFile::remove(file.fileName()) && file.open(QIODevice::WriteOnly) && file.write("?") == 1);
        file.close();
        BackupsDialog dialog(path("a.suffuse"));
        QTRY_VERIFY_WITH_TIMEOUT(!dialog.list()->topLevelItem(0)->text(1).isEmpty(), waitMs);
        QVERIFY(!dialog.restoreButton()->isEnabled());
    }

    /// Its painting opens, with the backup in its place: saving saves the painting.
    void backupsOfOneMinuteAreToldApart()
    {
        Session s;
        saveVersions(s, 3);
        for (const int n : {1, 2}) {
            QFile file(backupName(path("a.suffuse"), n));
            QVERIFY(file.open(QIODevice::ReadWrite));
            const QDateTime saved(QDate(2026, 3, 4), QTime(9, 30, n == 1 ? 11 : 47));
            QVERIFY(file.setFileTime(saved, QFileDevice::FileModificationTime));
        }
        const auto restore = qScopeGuard([] { QLocale::setDefault(QLocale::English); });
        for (const char *locale : {"en_US", "en_GB", "de_DE", "zh_CN", "fi_FI"}) {
            QLocale::setDefault(QLocale(locale));
            BackupsDialog dialog(path("a.suffuse"));
            auto *list = dialog.findChild<QTreeWidget *>();
            QCOMPARE(list->topLevelItemCount(), 2);
            for (const int n : {1, 2}) {
                const QString text = list->topLevelItem(n - 1)->text(0);
                QVERIFY2(text.contains(n == 1 ? "11" : "47"), qPrintable(locale + (": " + text)));
            }
        }
    }

    void aBackupOpenedByName()
    {
        {
            Session s;
            saveVersions(s, 3);
        }
        Session t;
        QCOMPARE(t.window.openFile(backupName(path("a.suffuse"), 2)), &t.window);
        QCOMPARE(t.painting().strokes.size(), std::size_t(1));
        QCOMPARE(t.editor().filePath(), path("a.suffuse"));
        QVERIFY(t.window.isWindowModified());
        QCOMPARE(settings::recentFiles(), QStringList(path("a.suffuse")));
        t.use(Command::Save);
        QTRY_VERIFY_WITH_TIMEOUT(!t.editor().isSaving(), waitMs);
        QCOMPARE(strokesIn(path("a.suffuse")), 1);
        QCOMPARE(strokesIn(backupName(path("a.suffuse"), 1)), 3);
        // Where the painting is open, in its window.
        Session u;
        QCOMPARE(u.window.openFile(backupName(path("a.suffuse"), 1)), &t.window);
        QCOMPARE(t.painting().strokes.size(), std::size_t(3));
        t.use(Command::Undo);
        QCOMPARE(t.painting().strokes.size(), std::size_t(1));
    }

    /// Files of other kinds are left out then, and the painting itself, too.
    void theOpenDialogShowsBackups()
    {
        Session s;
        saveVersions(s, 2);
        QString filter;
        bool isListed = false, isPaintingListed = true;
        whenAsked<QFileDialog>(this, m_answered, [&](QFileDialog &dialog) {
            for (const QString &one : dialog.nameFilters())
                if (one.contains("~*"))
                    filter = one;
            dialog.selectNameFilter(filter);
            const auto *list = dialog.findChild<QAbstractItemView *>(QStringLiteral("listView"));
            const auto isThere = [list](const QString &name) {
                const QModelIndex folder = list->rootIndex();
                for (int row = 0; row < list->model()->rowCount(folder); ++row)
                    if (list->model()->index(row, 0, folder).data().toString() == name)
                        return true;
                return false;
            };
            isListed = QTest::qWaitFor([&] { return isThere("a.suffuse~"); }, waitMs); // a thread reads the folder
            isPaintingListed = isThere("a.suffuse");
            dialog.reject();
        });
        s.use(Command::Open);
        QCOMPARE(m_answered, 1);
        QVERIFY(!filter.isEmpty());
        QVERIFY(isListed);
        QVERIFY(!isPaintingListed);
    }

    void aBackupWhosePaintingIsGone()
    {
        {
            Session s;
            saveVersions(s, 2);
        }
        QVERIFY(QFile::remove(path("a.suffuse")));
        Session t;
        QCOMPARE(t.window.openFile(backupName(path("a.suffuse"), 1)), &t.window);
        QCOMPARE(t.painting().strokes.size(), std::size_t(1));
        QCOMPARE(t.editor().suggestedPath(), path("a.suffuse"));
        QVERIFY(t.window.isWindowModified());
    }

    void namesOfBackups()
    {
        QCOMPARE(backedUpFile("/x/a.suffuse~"), QString("/x/a.suffuse"));
        QCOMPARE(backedUpFile("/x/a.suffuse~20"), QString("/x/a.suffuse"));
        for (const char *other : {"/x/a.suffuse", "/x/a.suffuse~1", "/x/a.suffuse~21", "/x/a~b.suffuse", "~", ""})
            QCOMPARE(backedUpFile(other), QString());
        for (int i = 1; i <= mostBackups; ++i)
            QCOMPARE(backedUpFile(backupName("/x/a.json", i)), QString("/x/a.json"));
    }

    void revertAsksAndCanBeUndone()
    {
        Session s;
        s.paintLine({200, 300}, {700, 300});
        QVERIFY(s.window.saveTo(path("a.suffuse")));
        const QByteArray saved = hashOf(s.painting());
        s.use(Command::Revert); // nothing to lose: no question, no step
        QVERIFY(m_questions.isEmpty());
        QCOMPARE(s.editor().undoStack().count(), 1);
        s.paintLine({200, 400}, {700, 400});
        const QByteArray painted = hashOf(s.painting());
        m_mayRevert = false;
        s.use(Command::Revert);
        QCOMPARE(m_questions.size(), 1);
        QCOMPARE(hashOf(s.painting()), painted);
        m_mayRevert = true;
        s.use(Command::Revert);
        QCOMPARE(hashOf(s.painting()), saved);
        QVERIFY(!s.window.isWindowModified());
        s.use(Command::Undo);
        QCOMPARE(hashOf(s.painting()), painted);
        QVERIFY(s.window.isWindowModified());
        s.use(Command::Redo);
        QVERIFY(!s.window.isWindowModified());
        QCOMPARE(s.editor().filePath(), path("a.suffuse"));
    }

    void revertLeavesThePaintingWhereTheFileIsNoMore()
    {
        Session s;
        s.paintLine({200, 300}, {700, 300});
        QVERIFY(s.window.saveTo(path("a.suffuse")));
        s.paintLine({200, 400}, {700, 400});
        const QByteArray painted = hashOf(s.painting());
        QVERIFY(QFile::remove(path("a.suffuse")));
        s.use(Command::Revert);
        QCOMPARE(m_errors.size(), 1);
        m_errors.clear();
        QCOMPARE(hashOf(s.painting()), painted);
        QVERIFY(s.window.isWindowModified());
    }

private:
    /// Each with a stroke more.
    void saveVersions(Session &s, int count)
    {
        for (int i = 0; i < count; ++i) {
            s.paintLine({200, 200.0 + 80 * i}, {700, 220.0 + 80 * i});
            QVERIFY(s.window.saveTo(path("a.suffuse")));
        }
    }
    QString path(const QString &name) const { return m_folder->filePath(name); }
    static int strokesIn(const QString &file)
    {
        const auto painting = loadPainting(file);
        return painting ? int(painting->strokes.size()) : -1;
    }
    QByteArray bytesOf(const QString &name) const
    {
        QFile file(path(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    QStringList m_errors, m_questions;
    int m_answered = 0;
    bool m_mayRevert = true;
};

QTEST_MAIN(TestBackups)
#include "test_backups.moc"
