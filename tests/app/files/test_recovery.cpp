// What a start offers after a crash: everything that was finished, once, and never what was saved or closed.
#include "app/session/files/journal.h"
#include "app/session/settings/settings.h"
#include "app/session/translation.h"
#include "app/widgets/asking/messages.h"
#include "app/window/files/recovery.h"
#include "tests/app/selecting.h"

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTimer>
#include <QTreeWidget>

using namespace suffuse;

class TestRecovery : public QObject {
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
        qputenv("SUFFUSE_SETTINGS", m_folder->filePath("settings.ini").toLocal8Bit());
        Journal::setFolder(m_folder->filePath("journals"));
        MessageHooks hooks;
        hooks.error = [this](const QString &message) { m_errors << message; };
        hooks.unsaved = [](const QString &) { return SaveAnswer::Discard; };
        hooks.confirm = [](const QString &) { return true; };
        setMessageHooks(hooks);
        m_errors.clear();
        m_answered = 0;
    }
    void cleanup()
    {
        Journal::setFolder({});
        QVERIFY2(m_errors.isEmpty(), qPrintable(m_errors.join('\n')));
    }
    void cleanupTestCase() { setMessageHooks({}); }

    void whatWasPaintedComesBack()
    {
        Session lost;
        lost.paintLine({200, 300}, {700, 350});
        lost.paintLine({200, 400}, {700, 450});
        lost.use(Command::Undo);
        lost.paintLine({200, 500}, {700, 550});
        crash(lost);
        Session s;
        answer(&RecoveryDialog::recoverButton, [&](RecoveryDialog &dialog) {
            QCOMPARE(dialog.list()->topLevelItemCount(), 1);
            QCOMPARE(dialog.list()->topLevelItem(0)->text(2), QString("2"));
        });
        offerRecovery(s.window, crashed());
        QCOMPARE(m_answered, 1);
        QCOMPARE(hashOf(s.painting()), hashOf(lost.painting()));
        QVERIFY(s.window.isWindowModified());
        QVERIFY(s.editor().filePath().isEmpty());
        QVERIFY2(s.window.windowTitle().contains("(recovered)"), qPrintable(s.window.windowTitle()));
        s.window.journal().flush();
        QVERIFY(journalsIn(crashed()).isEmpty());       // the new window has it in a journal of its own
        crash(s);                                       // and would not lose it either
        const Journals again = findJournals(crashed()); // the first window's is there, too: it did not really die
        QCOMPARE(again.lost.size(), std::size_t(2));
        for (const LostDocument &document : again.lost)
            QCOMPARE(hashOf(document.content.painting), hashOf(lost.painting()));
    }

    /// It is no part of the picture, and yet what a sheet of paper is.
    void theSizeOnPaperIsRecovered()
    {
        Session lost;
        lost.editor().newPainting(Editor::usualCanvas(), 300);
        lost.paintLine({200, 300}, {700, 350});
        QVERIFY(lost.window.saveTo(m_folder->filePath("sheet.suffuse"))); // The journal says it again then.
        lost.paintLine({200, 400}, {700, 450});
        crash(lost);
        QCOMPARE(findJournals(crashed()).lost.at(0).content.head.resolution, 300.0);
        Session s;
        answer(&RecoveryDialog::recoverButton, [](RecoveryDialog &) {});
        offerRecovery(s.window, crashed());
        QCOMPARE(s.editor().extras().resolution, 300.0);
    }

    /// What the program adds to names is said in the language of the moment, not in that of the crash.
    void namesFollowTheLanguage()
    {
        const auto speak = [](const char *code) {
            settings::setLanguage(code);
            installTranslators();
        };
        const auto back = qScopeGuard([&] { speak("en"); });
        Session named, untitled;
        named.paintLine({200, 300}, {700, 350});
        QVERIFY(named.window.saveTo(m_folder->filePath("flowers.suffuse")));
        named.paintLine({200, 400}, {700, 450});
        untitled.paintLine({200, 500}, {700, 550});
        crash(named);
        crash(untitled);
        const Journals journals = findJournals(crashed());
        QCOMPARE(journals.lost.size(), std::size_t(2));
        Editor first, second;
        for (const LostDocument &lost : journals.lost)
            (lost.name().isEmpty() ? second : first)
                .openRecovered(lost.content.painting, lost.name(), lost.content.head.path);
        QCOMPARE(first.displayName(), QString("flowers.suffuse (recovered)"));
        QCOMPARE(second.displayName(), QString("Untitled (recovered)"));
        first.openRecovered(*first.document().painting(), first.ownName(), {}); // after another crash
        speak("de");
        QCOMPARE(first.displayName(), QString("flowers.suffuse (wiederhergestellt)"));
        QCOMPARE(second.displayName(), QString("Unbenannt (wiederhergestellt)"));
        QCOMPARE(first.ownName(), QString("flowers.suffuse"));
        QVERIFY(second.ownName().isEmpty());
        RecoveryDialog dialog(journals.lost);
        QStringList listed{dialog.list()->topLevelItem(0)->text(0), dialog.list()->topLevelItem(1)->text(0)};
        listed.sort();
        QCOMPARE(listed, (QStringList{"Unbenannt", "flowers.suffuse"}));
    }

    /// Not only when it has rested for a while.
    void aDragIsFinishedWhenTheButtonIsLetGo()
    {
        Selecting s({line(1, {300, 300}, {500, 400}), line(2, {300, 600}, {500, 700})});
        s.select({1});
        QSignalSpy edited(&s.editor(), &Editor::edited);
        s.pressAndMove({{400, 350}, {450, 380}}, none);
        QCOMPARE(edited.count(), 0);
        s.send(QEvent::MouseButtonRelease, s.logical(s.canvas().view().toPixels({450, 380})), none);
        QCoreApplication::processEvents();
        QVERIFY(!s.editor().isDragging());
        QCOMPARE(edited.count(), 1);
        QVERIFY(near(s.box(1).left, 350));
        crash(s);
        const Journals found = findJournals(crashed());
        QCOMPARE(found.lost.size(), std::size_t(1));
        QCOMPARE(hashOf(found.lost[0].content.painting), hashOf(s.painting()));
    }

    void eachPaintingGetsAWindow()
    {
        Session one, two;
        one.paintLine({200, 300}, {700, 350});
        QVERIFY(one.window.saveTo(m_folder->filePath("flowers.suffuse")));
        one.paintLine({200, 400}, {700, 450});
        two.paintLine({200, 500}, {700, 550});
        crash(one);
        crash(two);
        Session s;
        answer(&RecoveryDialog::recoverButton,
               [](RecoveryDialog &dialog) { QCOMPARE(dialog.list()->topLevelItemCount(), 2); });
        offerRecovery(s.window, crashed());
        QStringList titles;
        QList<MainWindow *> opened;
        for (QWidget *widget : QApplication::topLevelWidgets())
            if (auto *window = qobject_cast<MainWindow *>(widget);
                window && window->windowTitle().contains("(recovered)")) {
                titles << window->windowTitle();
                opened << window;
            }
        titles.sort();
        QCOMPARE(titles.size(), 2);
        QVERIFY2(titles[1].startsWith("flowers.suffuse (recovered)"), qPrintable(titles[1]));
        for (MainWindow *window : opened) {
            if (window->windowTitle().startsWith("flowers"))
                QCOMPARE(window->editor().suggestedPath(), m_folder->filePath("flowers.suffuse"));
            if (window != &s.window)
                delete window;
        }
    }

    void laterAndDiscard()
    {
        Session lost;
        lost.paintLine({200, 300}, {700, 350});
        crash(lost);
        Session s;
        answer(&RecoveryDialog::laterButton);
        offerRecovery(s.window, crashed());
        QCOMPARE(journalsIn(crashed()).size(), 1);
        QVERIFY(s.painting().strokes.empty());
        answer(&RecoveryDialog::discardButton);
        offerRecovery(s.window, crashed());
        QVERIFY(journalsIn(crashed()).isEmpty());
        QCOMPARE(m_answered, 2);
        offerRecovery(s.window, crashed()); // asks nothing any more
    }

    void savedAndClosedOnesAreNotOffered()
    {
        Session s;
        s.paintLine({200, 300}, {700, 350});
        QVERIFY(s.window.saveTo(m_folder->filePath("a.suffuse")));
        crash(s);
        QCOMPARE(journalsIn(crashed()).size(), 1);
        offerRecovery(s.window, crashed());
        QVERIFY(journalsIn(crashed()).isEmpty());
        s.paintLine({200, 400}, {700, 450});
        QVERIFY(s.window.close());
        s.window.journal().flush();
        QVERIFY(journalsIn(Journal::folder()).isEmpty());
    }

    /// Undone to what the file holds, there is nothing to recover.
    void undoneToTheSavedStateIsNotOffered()
    {
        Session s;
        s.paintLine({200, 300}, {700, 350});
        QVERIFY(s.window.saveTo(m_folder->filePath("a.suffuse")));
        s.paintLine({200, 400}, {700, 450});
        s.use(Command::Undo);
        crash(s);
        QVERIFY(findJournals(crashed()).lost.empty());
        s.use(Command::Redo);
        crash(s);
        QCOMPARE(findJournals(crashed()).lost.size(), std::size_t(1));
    }

    void previewsAppear()
    {
        Session lost;
        lost.paintLine({200, 300}, {700, 350});
        crash(lost);
        Journals journals = findJournals(crashed());
        RecoveryDialog dialog(std::move(journals.lost));
        dialog.show();
        const qint64 before = dialog.list()->topLevelItem(0)->icon(0).cacheKey();
        QTRY_VERIFY_WITH_TIMEOUT(dialog.list()->topLevelItem(0)->icon(0).cacheKey() != before, waitMs);
        dialog.list()->clearSelection();
        QVERIFY(!dialog.recoverButton()->isEnabled() && !dialog.discardButton()->isEnabled());
    }

    void journalsThatCannotBeWrittenAreToldOnce()
    {
        QFile file(m_folder->filePath("no-folder"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        Journal::setFolder(m_folder->filePath("no-folder/journals"));
        Session s;
        for (int i = 0; i < 3; ++i) {
            s.paintLine({200, 300.0 + 50 * i}, {700, 350.0 + 50 * i});
            s.window.journal().flush();
        }
        QTRY_COMPARE_WITH_TIMEOUT(m_errors.size(), 1, waitMs);
        QCOMPARE(s.painting().strokes.size(), std::size_t(3));
        QTest::qWait(100);
        QCOMPARE(m_errors.size(), 1);
        m_errors.clear();
    }

private:
    QString crashed() const { return m_folder->filePath("crashed"); }
    static QStringList journalsIn(const QString &folder) { return QDir(folder).entryList({"*.journal*"}, QDir::Files); }

    /// What would be on the disk if the program died now: this process still holds its own journals. All of them stand
    /// still before they are copied: each has a thread that writes it, and puts files in other ones' place.
    void crash(Session &session)
    {
        for (QWidget *widget : QApplication::topLevelWidgets())
            if (auto *window = qobject_cast<MainWindow *>(widget))
                window->journal().flush();
        session.window.journal().flush();
        QVERIFY(QDir().mkpath(crashed()));
        for (const QString &name : journalsIn(Journal::folder())) {
            QFile::remove(crashed() + '/' + name);
            QVERIFY(QFile::copy(Journal::folder() + '/' + name, crashed() + '/' + name));
        }
    }

    /// Clicks a button of the dialog that is about to come.
    void answer(QPushButton *(RecoveryDialog::*button)() const, const std::function<void(RecoveryDialog &)> &look = {})
    {
        auto *timer = new QTimer(this);
        connect(timer, &QTimer::timeout, this, [this, timer, button, look] {
            auto *dialog = qobject_cast<RecoveryDialog *>(QApplication::activeModalWidget());
            if (!dialog)
                return;
            timer->deleteLater();
            timer->stop();
            ++m_answered;
            if (look)
                look(*dialog);
            QTest::mouseClick((dialog->*button)(), Qt::LeftButton);
        });
        timer->start(50);
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    QStringList m_errors;
    int m_answered = 0;
};

QTEST_MAIN(TestRecovery)
#include "test_recovery.moc"
