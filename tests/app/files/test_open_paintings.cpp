// Paintings that are open, and the list of those that were: in several windows, and in several running instances.
#include "app/panels/inspector/along/along_dialog.h"
#include "app/session/files/journal.h"
#include "app/session/settings/settings.h"
#include "app/widgets/asking/messages.h"
#include "app/widgets/numbers/number_field.h"
#include "model/formats/files.h"
#include "tests/app/session.h"

#include <QDir>
#include <QFile>
#include <QPointer>
#include <QProcess>
#include <QScopeGuard>
#include <QStatusBar>
#include <QTemporaryDir>

using namespace suffuse;

namespace {

constexpr char addRecent[] = "--add-recent-files"; ///< then the files: another instance, as this program plays it

/// Whoever else has the settings open writes them as a whole.
QByteArray iniOf(const QStringList &recent)
{
    return "[General]\nrecentFiles=" + recent.join(", ").toUtf8() + "\n";
}

} // namespace

class TestOpenPaintings : public QObject {
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
        MessageHooks hooks;
        hooks.error = [this](const QString &message) { m_errors << message; };
        hooks.unsaved = [](const QString &) { return SaveAnswer::Discard; };
        setMessageHooks(hooks);
    }
    void cleanup() { QVERIFY2(m_errors.isEmpty(), qPrintable(m_errors.join('\n'))); }
    void cleanupTestCase() { setMessageHooks({}); }

    void otherInstancesEntriesStay()
    {
        const QStringList files = make({"a", "b", "c-longer"});
        settings::addRecentFile(files[0]);
        settings::store().sync();
        QFile ini(path("settings.ini"));
        QVERIFY(ini.open(QIODevice::WriteOnly));
        ini.write(iniOf({files[1], files[0]})); // another instance opened b
        ini.close();
        QCOMPARE(settings::recentFiles(), QStringList({files[1], files[0]})); // in this one's menu, too
        settings::addRecentFile(files[2]);
        QCOMPARE(settings::recentFiles(), QStringList({files[2], files[1], files[0]}));
        QVERIFY(ini.open(QIODevice::ReadOnly));
        const QByteArray stored = ini.readAll();
        for (const QString &file : files)
            QVERIFY2(stored.contains(file.toUtf8()), stored.constData());
    }

    void manyInstancesAtOnce()
    {
        const QStringList files =
            make({"1", "22", "333", "4444", "55555", "666666", "7777777", "88888888", "999999999"});
        std::vector<std::unique_ptr<QProcess>> instances;
        for (int i = 0; i < 3; ++i) {
            instances.push_back(std::make_unique<QProcess>());
            instances.back()->start(QCoreApplication::applicationFilePath(),
                                    QStringList(addRecent) + files.mid(3 * i, 3));
        }
        for (const auto &instance : instances) {
            QVERIFY(instance->waitForFinished(waitMs));
            QCOMPARE(instance->exitCode(), 0);
        }
        const QStringList recent = settings::recentFiles();
        for (const QString &file : files)
            QVERIFY2(recent.contains(file), qPrintable(recent.join(' ')));
    }

    /// The usual list counts until somebody alters it, and what others altered stays.
    void listsAreAlteredAsTheyAreStored()
    {
        settings::updateList("aList", [](QStringList names) { return names << "mine"; }, {"usual"});
        QCOMPARE(settings::store().value("aList").toStringList(), QStringList({"usual", "mine"}));
        QFile ini(path("settings.ini"));
        QVERIFY(ini.open(QIODevice::WriteOnly));
        ini.write("[General]\naList=usual, mine, another one's\n");
        ini.close();
        settings::updateList("aList", [](QStringList names) { return names << "mine too"; }, {"usual"});
        QCOMPARE(settings::store().value("aList").toStringList(),
                 QStringList({"usual", "mine", "another one's", "mine too"}));
    }

    void oneFileIsListedOnce()
    {
        const QStringList files = make({"a"});
        QVERIFY(QFile::link(files[0], path("link.suffuse")));
        settings::addRecentFile(files[0]);
        settings::addRecentFile(path("link.suffuse"));
        QCOMPARE(settings::recentFiles(), QStringList(path("link.suffuse")));
    }

    void anOpenPaintingIsRaised()
    {
        Session a, b;
        a.paintLine({200, 300}, {700, 300});
        QVERIFY(a.window.saveTo(path("a.suffuse")));
        a.paintLine({200, 400}, {700, 400});
        b.paintLine({200, 500}, {700, 500});
        const QByteArray painted = hashOf(a.painting()), other = hashOf(b.painting());
        QVERIFY(QFile::link(path("a.suffuse"), path("link.suffuse")));
        const auto windows = QApplication::topLevelWidgets().size();
        const QString around = "../" + QFileInfo(m_folder->path()).fileName() + "/a.suffuse";
        for (const QString &name : {QString("a.suffuse"), QString("link.suffuse"), around}) {
            const QString file = path(name);
            a.window.showMinimized();
            QCOMPARE(b.window.openFile(file), &a.window);
            QVERIFY(!a.window.isMinimized());
            QVERIFY(a.window.statusBar()->currentMessage().contains(QFileInfo(file).fileName()));
            QCOMPARE(a.window.openFile(file), &a.window);
        }
        QCOMPARE(QApplication::topLevelWidgets().size(), windows);
        QCOMPARE(hashOf(a.painting()), painted); // nothing is lost
        QCOMPARE(hashOf(b.painting()), other);
        QVERIFY(a.window.close());
        a.editor().newPainting({});
        Session c;
        QCOMPARE(c.window.openFile(path("a.suffuse")), &c.window);
    }

    /// Who cancels when asked about one window keeps the others, too, whichever was opened first.
    void whoCancelsQuittingKeepsAllWindows()
    {
        Session a, b, c;
        for (Session *s : {&a, &c}) {
            s->paintLine({200, 300}, {700, 300});
            QVERIFY(s->window.saveTo(path(s == &a ? "a.suffuse" : "c.suffuse")));
        }
        b.paintLine({200, 300}, {700, 300});
        int asked = 0;
        MessageHooks hooks;
        hooks.unsaved = [&](const QString &) {
            ++asked;
            return SaveAnswer::Cancel;
        };
        setMessageHooks(hooks);
        a.use(Command::Quit);
        QCOMPARE(asked, 1);
        for (const Session *s : {&a, &b, &c})
            QVERIFY(s->window.isVisible());
        hooks.unsaved = [](const QString &) { return SaveAnswer::Discard; };
        setMessageHooks(hooks);
        c.use(Command::Quit);
        for (const Session *s : {&a, &b, &c})
            QVERIFY(!s->window.isVisible());
    }

    /// Ctrl+Q in a window that stays open beside the picture: all that it shows, and what is typed in it, is work that
    /// is asked about, once.
    void quittingKnowsWhatIsTypedBeside_data()
    {
        QTest::addColumn<SaveAnswer>("answer");
        QTest::newRow("cancel") << SaveAnswer::Cancel;
        QTest::newRow("save") << SaveAnswer::Save;
        QTest::newRow("discard") << SaveAnswer::Discard;
    }
    void quittingKnowsWhatIsTypedBeside()
    {
        QFETCH(SaveAnswer, answer);
        const QTemporaryDir journals;
        Journal::setFolder(journals.path());
        const auto forget = qScopeGuard([] { Journal::setFolder({}); });
        Session s;
        s.paintLine({200, 300}, {700, 300});
        s.dry();
        const QString file = path("beside.suffuse");
        QVERIFY(s.window.saveTo(file));
        const QByteArray saved = hashOf(s.painting());
        s.use(Command::SelectAll);
        s.use(Command::AlongStrokes);
        QPointer<AlongDialog> dialog = s.window.findChild<AlongDialog *>();
        QVERIFY(dialog && QTest::qWaitForWindowActive(dialog));
        dialog->scale()->setFocus();
        QTest::qWait(1); // the field selects its text when it gets the focus
        dialog->scale()->selectAll();
        QTest::keyClicks(dialog->scale(), "2");
        QVERIFY(!s.editor().isModified()); // nothing but the text as yet
        int asked = 0;
        MessageHooks hooks;
        hooks.unsaved = [&](const QString &) {
            ++asked;
            return answer;
        };
        setMessageHooks(hooks);
        QTest::keyClick(dialog->scale(), Qt::Key_Q, Qt::ControlModifier);
        QCOMPARE(asked, 1);
        QCOMPARE(s.window.isVisible(), answer == SaveAnswer::Cancel);
        const auto stored = loadPainting(file);
        QVERIFY(stored);
        QCOMPARE(hashOf(*stored) == saved, answer != SaveAnswer::Save);
        if (answer == SaveAnswer::Cancel) { // Nothing has happened, and the window beside still takes it all back.
            QVERIFY(hashOf(s.painting()) != saved);
            QTest::keyClick(dialog, Qt::Key_Escape);
            QCOMPARE(hashOf(s.painting()), saved);
        } else { // Nothing is left that the next start would offer to recover.
            QTRY_VERIFY(!dialog || !dialog->isVisible());
            const auto hasNone = [&] { return QDir(journals.path()).isEmpty(); };
            QTRY_VERIFY2(hasNone(), qPrintable(QDir(journals.path()).entryList().join(" ")));
            QTest::qWait(20); // Nor does a late change begin one again.
            QTRY_VERIFY2(hasNone(), qPrintable(QDir(journals.path()).entryList().join(" ")));
        }
    }

private:
    QString path(const QString &name) const { return m_folder->filePath(name); }
    QStringList make(const QStringList &names) const
    {
        QStringList files;
        for (const QString &name : names) {
            files << path(name + ".suffuse");
            if (QFile file(files.last()); !file.open(QIODevice::WriteOnly))
                return {};
        }
        return files;
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    QStringList m_errors;
};

int main(int argc, char **argv)
{
    if (argc > 1 && QByteArray(argv[1]) == addRecent) {
        QCoreApplication app(argc, argv);
        for (const QString &file : app.arguments().mid(2))
            settings::addRecentFile(file);
        return 0;
    }
    QApplication app(argc, argv);
    TestOpenPaintings test;
    return QTest::qExec(&test, argc, argv);
}

#include "test_open_paintings.moc"
