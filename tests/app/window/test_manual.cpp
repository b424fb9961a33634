// The manual's pages: every one is there in every language, leads somewhere, and calls things as the window does. And its
// window: contents, search, the way back, and the page about what has the keyboard.
#include "app/dialogs/manual/manual_window.h"
#include "app/dialogs/manual/page_view.h"
#include "app/session/commands/keys.h"
#include "app/session/settings/settings.h"
#include "app/session/translation.h"
#include "app/widgets/habits/help_page.h"
#include "app/widgets/look/theme.h"
#include "app/window/helping.h"
#include "tests/app/all_dialogs.h"
#include "tests/app/session.h"

#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QKeySequenceEdit>
#include <QLineEdit>
#include <QListWidget>
#include <QMenuBar>
#include <QRegularExpression>
#include <QScrollBar>
#include <QTemporaryDir>
#include <QTextBlock>
#include <QToolButton>
#include <QXmlStreamReader>
#include <QtTest>

using namespace suffuse;

namespace {

void speak(const QString &code)
{
    settings::setLanguage(code);
    installTranslators();
}

/// A title as it is read: without its mnemonic.
QString shown(QString title)
{
    static const QRegularExpression behind("\\(&.\\)");
    return title.remove(behind).remove('&').trimmed();
}

/// The ways through the menus to all commands and to all menus: "File ▸ Export…". A command's is listed under its id.
void addWays(const QList<QAction *> &actions, const QString &to, QMultiHash<QString, QString> &ways)
{
    for (const QAction *action : actions) {
        const QString way = to.isEmpty() ? shown(action->text()) : to + QStringLiteral(" ▸ ") + shown(action->text());
        ways.insert(way, action->menu() ? QStringLiteral("menu") : action->objectName());
        if (action->menu())
            addWays(action->menu()->actions(), way, ways);
    }
}

/// Everything that people read in the window in a language, or in English.
QSet<QString> wordsOf(const QString &code)
{
    QSet<QString> words;
    QFile file(QStringLiteral(SUFFUSE_SOURCE_DIR "/i18n/suffuse_%1.ts").arg(code == "en" ? "de" : code));
    if (!file.open(QIODevice::ReadOnly))
        return words;
    QXmlStreamReader xml(&file);
    while (!xml.atEnd())
        if (xml.readNextStartElement() && xml.name() == (code == "en" ? u"source" : u"translation"))
            words << shown(xml.readElementText(QXmlStreamReader::IncludeChildElements));
    return words;
}

/// A page without its code, in which stars and brackets are what they are.
QString proseOf(const QString &text)
{
    static const QRegularExpression code("^```.*?^```$|`[^`\\n]*`",
                                         QRegularExpression::MultilineOption | QRegularExpression::DotMatchesEverythingOption);
    return QString(text).remove(code);
}

/// The languages that have a manual of their own; the others are shown the English one.
QStringList manualCodes()
{
    QStringList codes;
    for (const QString &code : translationCodes())
        if (QFile::exists(QStringLiteral(":/manual/%1/index.md").arg(code)))
            codes << code;
    return codes;
}

QStringList found(const QString &pattern, const QString &text)
{
    QStringList all;
    for (auto it = QRegularExpression(pattern).globalMatch(text); it.hasNext();)
        all << it.next().captured(1);
    return all;
}

/// What stands in bold, which is how a page names what stands in the window.
QStringList namesIn(const ManualPage &page)
{
    QStringList names = found("\\*\\*([^*]+)\\*\\*", proseOf(page.text));
    for (QString &name : names)
        name = name.simplified(); // it may stand on two lines
    return names;
}

/// A page's skeleton: its headings, pictures, tables, lists and links, in their order, without words.
QStringList skeletonOf(const ManualPage &page)
{
    QStringList parts;
    for (const QString &line : page.text.split('\n')) {
        if (line.startsWith('#'))
            parts << line.section(' ', 0, 0);
        else if (line.startsWith("!["))
            parts << line.section('(', -1);
        else if (line.startsWith("- ") || line.startsWith("```"))
            parts << line.left(2);
        else if (line.startsWith('|') && page.name != "glossary") // whose words are in the order of the language
            parts << "|";
    }
    return parts;
}

Helping *helpingOf(MainWindow &window)
{
    return window.findChild<Helping *>();
}

} // namespace

class TestManual : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }

    void cleanup()
    {
        for (QWidget *window : QApplication::topLevelWidgets())
            if (qobject_cast<ManualWindow *>(window))
                delete window;
        speak("en");
    }

    void languages()
    {
        QTest::addColumn<QString>("code");
        for (const QString &code : manualCodes())
            QTest::newRow(qPrintable(code)) << code;
    }
    void everyPageIsListedAndLeadsSomewhere_data() { languages(); }
    void everyPageIsListedAndLeadsSomewhere()
    {
        QFETCH(QString, code);
        const ManualPages manual(code);
        QStringList listed;
        for (const ManualPage &page : manual.all())
            listed << page.name + ".md";
        QVERIFY(listed.size() > 14);
        QCOMPARE(listed.removeDuplicates(), 0);
        listed.sort();
        QCOMPARE(QDir(":/manual/" + code).entryList(QDir::Files, QDir::Name), listed);
        for (const ManualPage &page : manual.all()) {
            QVERIFY2(!page.title.isEmpty(), qPrintable(page.name));
            for (const QString &target : found("\\]\\(([^)]+)\\)", proseOf(page.text)))
                QVERIFY2(QFile::exists(QStringLiteral(":/manual/%1/%2").arg(code, target)),
                         qPrintable(page.name + ": " + target));
            QVERIFY2(!ManualPages::plainText(proseOf(page.text)).contains("**"), qPrintable(page.name));
            if (page.name != "index") // the contents call a page by its title
                QVERIFY2(manual.all()[0].text.contains(QStringLiteral("[%1](%2.md)").arg(page.title, page.name)),
                         qPrintable(page.title));
        }
    }

    void allLanguagesHaveTheSameParts()
    {
        QCOMPARE(manualCodes(), QStringList({"en", "zh_CN", "de"}));
        const ManualPages english("en");
        for (const QString &code : manualCodes()) {
            const ManualPages other(code);
            QCOMPARE(other.all().size(), english.all().size());
            for (std::size_t i = 0; i < english.all().size(); ++i) {
                QCOMPARE(other.all()[i].name, english.all()[i].name);
                if (other.all()[i].name != "glossary")
                    QVERIFY2(skeletonOf(other.all()[i]) == skeletonOf(english.all()[i]),
                             qPrintable(code + ": " + other.all()[i].name));
            }
        }
        QVERIFY(ManualPages("xx").all()[0].text == english.all()[0].text); // better than none
    }

    void everyPictureIsShown()
    {
        QString all;
        const ManualPages manual("en");
        for (const ManualPage &page : manual.all())
            all += page.text;
        const QStringList pictures = QDir(":/manual/pictures").entryList();
        QVERIFY(pictures.size() > 10);
        for (const QString &picture : pictures)
            QVERIFY2(all.contains("(../pictures/" + picture + ")"), qPrintable(picture));
    }

    /// A way through the menus is one of the menus; any other name is that of a command, or stands in the window.
    void namesAreThoseOfTheWindow_data() { languages(); }
    void namesAreThoseOfTheWindow()
    {
        QFETCH(QString, code);
        speak(code);
        Session s;
        QMultiHash<QString, QString> ways;
        addWays(s.window.menuBar()->actions(), {}, ways);
        QSet<QString> words = wordsOf(code);
        QVERIFY(words.size() > 1000);
        for (const QAction *action : s.window.findChild<Commands *>()->all())
            words << shown(action->text());
        int inMenus = 0;
        const ManualPages manual(code);
        for (const ManualPage &page : manual.all())
            for (const QString &name : namesIn(page)) {
                const bool isWay = name.contains(QStringLiteral(" ▸ "));
                inMenus += isWay;
                QVERIFY2(isWay ? ways.contains(name) : words.contains(name), qPrintable(page.name + ": " + name));
            }
        QVERIFY(inMenus > 50);
    }

    /// What English text calls by a way through the menus, the others do, too.
    void allLanguagesNameTheSameCommands()
    {
        std::vector<std::vector<QStringList>> named; // ids of each page in each language
        for (const QString &code : manualCodes()) {
            speak(code);
            Session s;
            QMultiHash<QString, QString> ways;
            addWays(s.window.menuBar()->actions(), {}, ways);
            const ManualPages manual(code);
            auto &pages = named.emplace_back();
            for (const ManualPage &page : manual.all()) {
                QStringList ids;
                for (const QString &name : namesIn(page))
                    if (ways.contains(name))
                        ids << ways.value(name);
                ids.sort();
                pages.push_back(ids);
            }
        }
        for (const auto &pages : named)
            for (std::size_t i = 0; i < pages.size(); ++i)
                QCOMPARE(pages[i].join(' '), named[0][i].join(' '));
    }

    void keysAreThoseOfTheCommands_data() { languages(); }
    void keysAreThoseOfTheCommands()
    {
        QFETCH(QString, code);
        speak(code);
        Session s;
        const ManualPages manual(code);
        static const QRegularExpression row("^\\| \\*\\*(.+)\\*\\* \\| (.+) \\|$");
        int rows = 0;
        for (const QString &line : manual.all()[manual.indexOf("keys")].text.split('\n'))
            if (const QRegularExpressionMatch match = row.match(line); match.hasMatch()) {
                QStringList keys = found("`([^`]+)`", match.captured(2)), none;
                QStringList *best = &none; // some titles are those of two commands
                QList<QStringList> candidates;
                for (const QAction *action : s.window.findChild<Commands *>()->all())
                    if (shown(action->text()) == match.captured(1)) {
                        QStringList own;
                        for (const QKeySequence &key : ownShortcutsOf(*action))
                            own << key.toString(QKeySequence::NativeText);
                        own.removeDuplicates();
                        candidates << own;
                    }
                for (QStringList &own : candidates)
                    if (own == keys)
                        best = &own;
                QVERIFY2(best != &none, qPrintable(line));
                ++rows;
            }
        QVERIFY(rows > 80);
    }

    void theSearchFindsWords_data()
    {
        QTest::addColumn<QString>("code");
        QTest::addColumn<QString>("words");
        QTest::addColumn<QString>("best");
        QTest::newRow("en") << "en" << "soft ERASURE" << "refining";
        QTest::newRow("de") << "de" << "druck" << "exchange";
        QTest::newRow("zh_CN") << "zh_CN" << QStringLiteral("蒙版") << "layers";
    }
    void theSearchFindsWords()
    {
        QFETCH(QString, code);
        QFETCH(QString, words);
        QFETCH(QString, best);
        const ManualPages manual(code);
        const std::vector<ManualHit> hits = manual.search(words);
        QStringList names;
        for (const ManualHit &hit : hits) {
            names << manual.all()[hit.page].name;
            QVERIFY2(hit.excerpt.contains(words.section(' ', -1), Qt::CaseInsensitive) ||
                         hit.excerpt.contains(words.section(' ', 0, 0), Qt::CaseInsensitive),
                     qPrintable(hit.excerpt));
        }
        QVERIFY2(names.contains(best), qPrintable(names.join(' ')));
        QVERIFY(manual.search("  ").empty());
        QVERIFY(manual.search("Quetzalcoatlus").empty());
        const ManualPage &titled = manual.all()[manual.indexOf("layers")];
        QCOMPARE(manual.all()[manual.search(titled.title).front().page].name, "layers"); // a title comes first
    }

    void pagesAreReadBackAndForth()
    {
        ManualWindow manual;
        manual.resize(900, 600);
        manual.show();
        QCOMPARE(manual.page(), "index");
        QVERIFY(!manual.back()->isEnabled() && !manual.forward()->isEnabled());
        emit manual.view()->anchorClicked(QUrl("numbers.md"));
        QCOMPARE(manual.page(), "numbers");
        QCOMPARE(manual.list()->currentItem()->text(), manual.pages().all()[manual.pages().indexOf("numbers")].title);
        QScrollBar &bar = *manual.view()->verticalScrollBar();
        QVERIFY(bar.maximum() > 500);
        bar.setValue(400);
        manual.turnTo("layers");
        QCOMPARE(bar.value(), 0);
        manual.back()->click();
        QCOMPARE(manual.page(), "numbers");
        QCOMPARE(bar.value(), 400);
        manual.back()->click();
        QCOMPARE(manual.page(), "index");
        manual.forward()->click();
        manual.forward()->click();
        QCOMPARE(manual.page(), "layers");
        QVERIFY(!manual.forward()->isEnabled());
    }

    /// Each of them is seen: as large as its file says, in a window that is wide enough, and no wider than a narrow one.
    void picturesFitTheWindow()
    {
        ManualWindow manual;
        manual.show();
        const auto widths = [&manual] {
            QList<double> all;
            const QTextDocument &document = *manual.view()->document();
            for (QTextBlock block = document.begin(); block.isValid(); block = block.next())
                for (auto it = block.begin(); !it.atEnd(); ++it)
                    if (it.fragment().charFormat().isImageFormat())
                        all << it.fragment().charFormat().toImageFormat().width();
            return all;
        };
        struct Width {
            int window, least, most; // logical pixels
        };
        static constexpr Width tried[] = {{1400, 450, 640}, {620, 80, 400}};
        for (const auto &[window, least, most] : tried) {
            manual.resize(window, 700);
            manual.turnTo("numbers");
            const QList<double> all = widths();
            QVERIFY(all.size() > 5);
            for (const double width : all)
                QVERIFY2(width >= least && width <= most, qPrintable(QString::number(width)));
            for (const ManualPage &page : manual.pages().all()) {
                manual.turnTo(page.name);
                QVERIFY2(manual.view()->horizontalScrollBar()->maximum() == 0, qPrintable(page.name));
            }
        }
    }

    void whatIsFoundIsMarked()
    {
        ManualWindow manual;
        manual.resize(900, 600);
        manual.show();
        const int contents = manual.list()->count();
        QTest::keyClicks(manual.search(), "granulation");
        QVERIFY(manual.list()->count() > 1 && manual.list()->count() < contents);
        QTest::keyClick(manual.search(), Qt::Key_Return);
        QVERIFY(manual.page() != "index");
        QVERIFY(!manual.view()->extraSelections().isEmpty());
        QCOMPARE(manual.view()->extraSelections().front().cursor.selectedText().toLower(), "granulation");
        manual.search()->setText("Quetzalcoatlus");
        QCOMPARE(manual.list()->count(), 1);
        QVERIFY(!manual.list()->item(0)->flags().testFlag(Qt::ItemIsSelectable));
        QTest::keyClick(manual.search(), Qt::Key_Return); // nothing to show
        manual.search()->clear();
        QCOMPARE(manual.list()->count(), contents);
    }

    void languageAndPaletteAreFollowed()
    {
        ManualWindow manual;
        manual.show();
        manual.turnTo("time");
        const QString title = manual.pages().all()[manual.pages().indexOf("time")].title;
        speak("de");
        QCoreApplication::sendPostedEvents();
        QCOMPARE(manual.page(), "time");
        QVERIFY(manual.pages().all()[manual.pages().indexOf("time")].title != title);
        QVERIFY(manual.view()->toPlainText().startsWith("Zeit und Filme"));
        const auto back = qScopeGuard([] { QApplication::setPalette(lightPalette()); });
        QApplication::setPalette(darkPalette());
        QCoreApplication::sendPostedEvents();
        QCOMPARE(manual.view()->palette().color(QPalette::Base), darkPalette().color(QPalette::Base));
        QVERIFY(manual.view()->toPlainText().startsWith("Zeit und Filme"));
    }

    /// Every dock, dialog and tool has a page of its own, and it is there.
    void everythingHasAPage()
    {
        Session s;
        const ManualPages manual("en");
        const auto isThere = [&manual](const QString &page) {
            return page == "index" || (!page.isEmpty() && manual.indexOf(page) != 0);
        };
        const QList<QDockWidget *> docks = s.window.findChildren<QDockWidget *>();
        QVERIFY(docks.size() > 6);
        for (QDockWidget *dock : docks) {
            QVERIFY2(isThere(helpPageOf(dock)), qPrintable(dock->objectName()));
            for (const QWidget *in : dock->findChildren<QWidget *>()) // found from wherever the keyboard is
                QCOMPARE(helpPageOf(in), helpPageOf(dock));
        }
        for (const DialogMaker &maker : allDialogs()) {
            const std::unique_ptr<QDialog> dialog = maker.make(s.window);
            QVERIFY2(isThere(helpPageOf(dialog.get())), maker.name);
        }
        for (int tool = int(Command::Brush); tool <= int(Command::Pan); ++tool) {
            s.use(Command(tool));
            const QString page = helpingOf(s.window)->pageAbout(&s.canvas());
            QVERIFY2(isThere(page), qPrintable(s.window.action(Command(tool)).text()));
        }
    }

    void f1OpensThePageAboutWhatHasTheKeyboard()
    {
        Session s;
        s.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        const auto pageAfterF1 = [&s](QWidget &in) {
            s.window.activateWindow();
            in.setFocus();
            QTest::keyClick(&in, Qt::Key_F1);
            for (QWidget *window : QApplication::topLevelWidgets())
                if (auto *manual = qobject_cast<ManualWindow *>(window); manual && manual->isVisible())
                    return manual->page();
            return QString();
        };
        s.use(Command::Eyedropper);
        QCOMPARE(pageAfterF1(s.canvas()), "colour");
        s.use(Command::Brush);
        QCOMPARE(pageAfterF1(s.canvas()), "brushes");
        s.window.findChild<QDockWidget *>("strokesDock")->raise();
        QCOMPARE(pageAfterF1(*s.window.findChild<QLineEdit *>("strokesSearch")), "layers");
        QCOMPARE(s.editor().undoStack().count(), 0);
    }

    /// A modal dialog blocks other windows, but not the manual that was asked for in it.
    void f1WorksInDialogs()
    {
        Session s;
        NewDialog dialog(&s.window);
        dialog.setModal(true);
        dialog.show();
        QTest::keyClick(&dialog, Qt::Key_F1);
        ManualWindow *manual = nullptr;
        for (QWidget *window : QApplication::topLevelWidgets())
            if (auto *found = qobject_cast<ManualWindow *>(window))
                manual = found;
        QVERIFY(manual && manual->isVisible());
        QCOMPARE(manual->page(), "first-painting");
        QVERIFY(dialog.isVisible());
        QTest::mouseClick(manual->back(), Qt::LeftButton); // it hears the mouse
        QCOMPARE(manual->page(), "index");
        dialog.reject();
        QVERIFY(manual->isVisible());
        s.use(Command::Manual); // from the menu: where it was
        QCOMPARE(manual->page(), "index");
        ShortcutsDialog shortcuts(s.window.findChild<Commands *>()->all(), {}, &s.window);
        shortcuts.show();
        manual->hide();
        QTest::keyClick(shortcuts.editor(), Qt::Key_F1); // a key like others there
        QVERIFY(!manual->isVisible());
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestManual)
#include "test_manual.moc"
