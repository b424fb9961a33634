// The menus as a whole: what can be typed is typed once.
#include "app/panels/strokes/strokes_panel.h"
#include "app/session/settings/settings.h"
#include "app/session/translation.h"
#include "tests/app/session.h"

#include <QApplication>
#include <QMenu>
#include <QMenuBar>
#include <QTemporaryDir>
#include <QtTest>

using namespace suffuse;

namespace {

/// The letter after the ampersand; none: 0.
QChar mnemonicOf(const QString &text)
{
    for (qsizetype i = 0; i + 1 < text.size(); ++i)
        if (text[i] == '&') {
            if (text[i + 1] != '&')
                return text[i + 1].toLower();
            ++i;
        }
    return {};
}

/// What shares a letter in a menu and in those below it: "Edit: Cu&t, Se&ttings…".
QStringList repeatedIn(const QList<QAction *> &actions, const QString &where)
{
    QStringList found;
    QHash<QChar, QString> taken;
    for (const QAction *action : actions) {
        const QChar letter = mnemonicOf(action->text());
        if (action->isVisible() && !letter.isNull()) {
            if (taken.contains(letter))
                found << QStringLiteral("%1: %2, %3").arg(where, taken[letter], action->text());
            taken.insert(letter, action->text());
        }
        if (action->menu())
            found << repeatedIn(action->menu()->actions(), action->text());
    }
    return found;
}

} // namespace

class TestMenus : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }

    void noMnemonicTwice_data()
    {
        QTest::addColumn<QString>("code");
        for (const QString &code : translationCodes())
            QTest::newRow(qPrintable(code)) << code;
    }

    void noMnemonicTwice()
    {
        QFETCH(QString, code);
        settings::setLanguage(code);
        installTranslators();
        const auto back = qScopeGuard([] {
            settings::setLanguage("en");
            installTranslators();
        });
        Session s;
        QVERIFY(s.window.menuBar()->actions().size() > 5);
        const QStringList repeated = repeatedIn(s.window.menuBar()->actions(), "menu bar");
        QVERIFY2(repeated.isEmpty(), qPrintable(repeated.join("\n")));
        s.paintLine({200, 200}, {400, 250});
        s.paintLine({200, 250}, {400, 300});
        s.use(Command::SelectAll);
        s.use(Command::GroupStrokes);
        s.use(Command::NextPanel); // and the panels are up to date
        auto *panel = s.window.findChild<StrokesPanel *>();
        const QModelIndex row = panel->viewIndexOf(1);
        for (const QModelIndex &index : {row, row.parent()}) {
            QMenu menu;
            panel->makeMenu(menu, index);
            QVERIFY(index.isValid() && menu.actions().size() > 10);
            const QStringList inRow = repeatedIn(menu.actions(), "menu of a row");
            QVERIFY2(inRow.isEmpty(), qPrintable(inRow.join("\n")));
        }
    }

    /// Qt's own German leaves it in English, while the texts speak of the key by its name.
    void theReturnKeyHasAName()
    {
        for (const auto &[code, name] :
             {std::pair("de", "Eingabe"), std::pair("zh_CN", "回车"), std::pair("fr", "Entrée"), std::pair("es", "Intro"),
              std::pair("ja", "Enter"), std::pair("en", "Return")}) {
            settings::setLanguage(code);
            installTranslators();
            QCOMPARE(QKeySequence(Qt::Key_Return).toString(QKeySequence::NativeText), QString(name));
            QCOMPARE(QKeySequence(Qt::Key_Return).toString(QKeySequence::PortableText), QString("Return"));
        }
    }

    /// What stands in the Edit menu can be typed there.
    void appearanceAndArtworkHaveALetter()
    {
        Session s;
        for (const Command command : {Command::PasteAppearance, Command::RecolourArtwork})
            QVERIFY2(!mnemonicOf(s.window.action(command).text()).isNull(),
                     qPrintable(s.window.action(command).text()));
    }

    /// And the keyboard goes back to the canvas, where F takes the Bucket and opens no menu.
    void oneEscClosesAMenu()
    {
        Session s;
        s.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        s.canvas().setFocus();
        QMenuBar &bar = *s.window.menuBar();
        QAction *view = bar.actions().at(2);
        QTest::mouseClick(&bar, Qt::LeftButton, {}, bar.actionGeometry(view).center());
        QTRY_COMPARE(QApplication::activePopupWidget(), view->menu());
        QTest::keyClick(view->menu(), Qt::Key_Right); // The next menu opens in its place.
        QTRY_COMPARE(QApplication::activePopupWidget(), bar.actions().at(3)->menu());
        QTest::keyClick(QApplication::activePopupWidget(), Qt::Key_Escape);
        QTRY_COMPARE(s.window.focusWidget(), &s.canvas());
        QVERIFY(!QApplication::activePopupWidget());
        QVERIFY(!bar.activeAction());
    }

    void f11FillsTheScreenAndGivesItBack()
    {
        Session s;
        s.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        s.canvas().setFocus();
        for (const bool full : {true, false}) {
            QTest::keyClick(&s.canvas(), Qt::Key_F11);
            QTRY_COMPARE(s.window.isFullScreen(), full);
            QTRY_COMPARE(s.window.action(Command::FullScreen).isChecked(), full);
        }
        QCOMPARE(s.editor().undoStack().count(), 0);
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestMenus)
#include "test_menus.moc"
