// Export Drawing: what it says before it writes, what it writes, and that nothing is left half done.
#include "app/dialogs/export/drawing_dialog.h"
#include "app/session/settings/settings.h"
#include "app/widgets/asking/messages.h"
#include "app/widgets/look/section.h"
#include "model/formats/files.h"
#include "tests/app/selecting.h"
#include "tests/render/paintings.h"

#include <QComboBox>
#include <QDir>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QTemporaryDir>

using namespace suffuse;

class TestDrawingDialog : public QObject {
    Q_OBJECT

    /// Soft strokes, `count` of them.
    static void fill(Editor &editor, int count)
    {
        auto painting = std::make_shared<Painting>();
        painting->canvas.width = 300;
        painting->canvas.height = 200;
        for (int i = 0; i < count; ++i) {
            const Point centre{150.0 + i % 7, 100.0 + i % 11};
            Stroke stroke =
                test::stroke(StrokeId(i + 1), test::Shape::Looping, centre, 90, 6, test::styleOf(StyleKind::Uniform));
            stroke.name = QStringLiteral("Stroke %1").arg(i + 1);
            painting->strokes.push_back(std::make_shared<const Stroke>(std::move(stroke)));
        }
        editor.document().reset(painting);
    }
    QStringList files() const
    {
        return QDir(m_folder.path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
    }
    static void choose(DrawingDialog &dialog, DrawingKind kind)
    {
        dialog.kind()->setCurrentIndex(dialog.kind()->findData(int(kind)));
    }
    static QProgressBar *barOf(DrawingDialog &dialog) { return dialog.findChild<QProgressBar *>(); }

private slots:
    void initTestCase() { qputenv("SUFFUSE_SETTINGS", QDir(m_settings.path()).filePath("settings.ini").toLocal8Bit()); }

    void init()
    {
        settings::store().clear();
        for (const QString &name : files())
            QDir(m_folder.path()).remove(name);
    }

    void drawingsGiveThePaintingBack_data()
    {
        QTest::addColumn<int>("kind");
        for (const DrawingKind kind : {DrawingKind::Outlines, DrawingKind::Bands, DrawingKind::Hybrid})
            QTest::addRow("%d", int(kind)) << int(kind);
    }
    void drawingsGiveThePaintingBack()
    {
        QFETCH(int, kind);
        Editor editor;
        fill(editor, 2);
        for (const char *name : {"a.svg", "a.svgz", "a.pdf"}) {
            DrawingDialog dialog(editor);
            dialog.show();
            QVERIFY(!dialog.exportButton()->isEnabled()); // The difference is not known yet.
            QVERIFY(barOf(dialog)->isVisible());
            choose(dialog, DrawingKind(kind));
            QCOMPARE(dialog.bands()->isEnabled(), DrawingKind(kind) == DrawingKind::Bands);
            dialog.path()->setText(m_folder.filePath(name));
            QTRY_VERIFY_WITH_TIMEOUT(dialog.exportButton()->isEnabled(), waitMs);
            QVERIFY2(dialog.difference()->text().contains("of 255"), qPrintable(dialog.difference()->text()));
            QVERIFY(!barOf(dialog)->isVisible());
            QCOMPARE(files().contains(name), false);
            dialog.exportButton()->click();
            QTRY_VERIFY_WITH_TIMEOUT(!dialog.isVisible(), waitMs);
            QCOMPARE(dialog.result(), int(QDialog::Accepted));
            const Result<LoadedDocument> back = loadDocument(m_folder.filePath(name));
            QVERIFY(bool(back));
            QVERIFY(back->painting == *editor.document().painting());
        }
    }

    /// The ending chooses the format, and what it has nothing for is told anew.
    void pdfHasAPage()
    {
        Editor editor;
        fill(editor, 1);
        auto painting = std::make_shared<Painting>(*editor.document().painting());
        painting->groups = {{1, "Glow"}};
        painting->groups[0].blend = BlendMode::Plus;
        Stroke glowing = *painting->strokes[0];
        glowing.group = 1;
        painting->strokes = {std::make_shared<const Stroke>(glowing)};
        editor.document().reset(painting);
        DrawingDialog dialog(editor);
        dialog.show();
        choose(dialog, DrawingKind::Outlines);
        dialog.path()->setText(m_folder.filePath("p.svg"));
        QVERIFY(!dialog.page()->isEnabled());
        QTRY_VERIFY_WITH_TIMEOUT(dialog.exportButton()->isEnabled(), waitMs);
        QVERIFY(!dialog.difference()->text().contains("PDF"));
        dialog.path()->setText(m_folder.filePath("p.pdf"));
        QVERIFY(dialog.page()->isEnabled());
        QVERIFY(!dialog.exportButton()->isEnabled());
        QTRY_VERIFY_WITH_TIMEOUT(dialog.exportButton()->isEnabled(), waitMs);
        QVERIFY2(dialog.difference()->text().contains("PDF has no groups"), qPrintable(dialog.difference()->text()));
        dialog.page()->setCurrentIndex(dialog.page()->findData("A4"));
        dialog.exportButton()->click();
        QTRY_VERIFY_WITH_TIMEOUT(!dialog.isVisible(), waitMs);
        const Result<LoadedDocument> back = loadDocument(m_folder.filePath("p.pdf"));
        QVERIFY(bool(back));
        QVERIFY(back->painting == *painting);
        // Both are remembered.
        DrawingDialog next(editor);
        QVERIFY(next.path()->text().endsWith(".pdf"));
        QCOMPARE(next.page()->currentText(), QString("A4"));
        QVERIFY(next.page()->isEnabled());
    }

    /// A change of what is asked for takes the difference back until it is known anew.
    void changesAreComparedAnew()
    {
        Editor editor;
        fill(editor, 1);
        DrawingDialog dialog(editor);
        dialog.show();
        QTRY_VERIFY_WITH_TIMEOUT(dialog.exportButton()->isEnabled(), waitMs);
        const QString before = dialog.difference()->text();
        dialog.bands()->setValue(2);
        QVERIFY(!dialog.exportButton()->isEnabled());
        QVERIFY(dialog.difference()->text() != before);
        QTRY_VERIFY_WITH_TIMEOUT(dialog.exportButton()->isEnabled(), waitMs);
        QVERIFY(dialog.difference()->text().contains("of 255"));
        QVERIFY(dialog.difference()->text() != before);
        // Many changes at once end with the last of them.
        choose(dialog, DrawingKind::Outlines);
        choose(dialog, DrawingKind::Bands);
        dialog.bands()->setValue(16);
        QTRY_COMPARE_WITH_TIMEOUT(dialog.difference()->text(), before, waitMs);
    }

    /// Return does not wait for the comparison; what is asked for anew takes it back.
    void returnIsRememberedWhileItIsCompared()
    {
        Editor editor;
        fill(editor, 2);
        DrawingDialog hasty(editor);
        hasty.show();
        hasty.path()->setText(m_folder.filePath("hasty.svg"));
        QVERIFY(!hasty.exportButton()->isEnabled());
        QTest::keyClick(hasty.path(), Qt::Key_Return);
        QVERIFY2(hasty.hint()->text().contains("as soon as it is compared"), qPrintable(hasty.hint()->text()));
        QVERIFY(!files().contains("hasty.svg"));
        QTRY_VERIFY_WITH_TIMEOUT(!hasty.isVisible(), waitMs);
        QCOMPARE(hasty.result(), int(QDialog::Accepted));
        QVERIFY(files().contains("hasty.svg"));

        DrawingDialog changed(editor);
        changed.show();
        changed.path()->setText(m_folder.filePath("changed.svg"));
        QTest::keyClick(changed.path(), Qt::Key_Return);
        QVERIFY(!changed.hint()->text().isEmpty());
        changed.bands()->setValue(changed.bands()->value() + 1);
        QVERIFY(changed.hint()->text().isEmpty());
        QTRY_VERIFY_WITH_TIMEOUT(changed.exportButton()->isEnabled(), waitMs);
        QVERIFY(changed.isVisible() && !files().contains("changed.svg"));
    }

    void whatHasNoPathIsTold()
    {
        Editor editor;
        fill(editor, 1);
        auto painting = std::make_shared<Painting>(*editor.document().painting());
        Stroke faint = *painting->strokes[0];
        for (Segment &segment : faint.segments)
            segment.density *= 0.1f;
        painting->strokes[0] = std::make_shared<const Stroke>(faint);
        editor.document().reset(painting);
        DrawingDialog dialog(editor);
        dialog.show();
        QTRY_VERIFY_WITH_TIMEOUT(dialog.difference()->text().contains("left out"), waitMs);
    }

    void theLastDrawingIsRemembered()
    {
        Editor editor;
        fill(editor, 1);
        {
            DrawingDialog dialog(editor);
            dialog.show();
            choose(dialog, DrawingKind::Outlines);
            dialog.bands()->setValue(40);
            dialog.path()->setText(m_folder.filePath("b.svgz"));
            QTRY_VERIFY_WITH_TIMEOUT(dialog.exportButton()->isEnabled(), waitMs);
            dialog.exportButton()->click();
            QTRY_VERIFY_WITH_TIMEOUT(!dialog.isVisible(), waitMs);
        }
        DrawingDialog dialog(editor);
        QCOMPARE(dialog.kind()->currentData().toInt(), int(DrawingKind::Outlines));
        QCOMPARE(dialog.bands()->value(), 40);
        QVERIFY(dialog.path()->text().endsWith(".svgz"));
        QVERIFY(dialog.path()->text().startsWith(m_folder.path()));
    }

    void otherEndingsAreRefused()
    {
        Editor editor;
        fill(editor, 1);
        DrawingDialog dialog(editor);
        dialog.show();
        dialog.path()->setText(m_folder.filePath("c.png"));
        QTRY_VERIFY_WITH_TIMEOUT(dialog.exportButton()->isEnabled(), waitMs);
        dialog.exportButton()->click();
        QVERIFY(dialog.hint()->text().contains("svgz"));
        QVERIFY(dialog.isVisible());
        QCOMPARE(files(), QStringList());
    }

    void whatCannotBeWrittenIsSaid()
    {
        Editor editor;
        fill(editor, 1);
        DrawingDialog dialog(editor);
        dialog.show();
        dialog.path()->setText(m_folder.filePath("missing/d.svg"));
        QTRY_VERIFY_WITH_TIMEOUT(dialog.exportButton()->isEnabled(), waitMs);
        dialog.exportButton()->click();
        QTRY_VERIFY_WITH_TIMEOUT(!dialog.hint()->text().isEmpty(), waitMs);
        QVERIFY(dialog.isVisible());
        QVERIFY(dialog.exportButton()->isEnabled());
    }

    /// Who cancels while it is drawn waits for nothing.
    void cancelEndsAtOnce()
    {
        Editor editor;
        fill(editor, 200);
        auto dialog = std::make_unique<DrawingDialog>(editor);
        dialog->show();
        dialog->bands()->setValue(64);
        QTRY_VERIFY_WITH_TIMEOUT(barOf(*dialog)->value() > 0, waitMs);
        QElapsedTimer clock;
        clock.start();
        dialog->reject();
        QVERIFY(!dialog->isVisible());
        dialog.reset();
        qInfo("ended after %d ms", int(clock.elapsed()));
        QVERIFY(clock.elapsed() < 2000); // usually a few milliseconds; other programs may have the cores
        QCOMPARE(files(), QStringList());
    }

    void cancelLeavesTheOldFile()
    {
        Editor editor;
        fill(editor, 30);
        QFile old(m_folder.filePath("e.svgz"));
        QVERIFY(old.open(QIODevice::WriteOnly) && old.write("old") == 3);
        old.close();
        DrawingDialog dialog(editor);
        dialog.show();
        dialog.bands()->setValue(64);
        dialog.path()->setText(old.fileName());
        QTRY_VERIFY_WITH_TIMEOUT(dialog.exportButton()->isEnabled(), waitMs);
        MessageHooks hooks;
        hooks.confirm = [](const QString &) { return true; }; // it may be replaced
        setMessageHooks(hooks);
        const auto restore = qScopeGuard([] { setMessageHooks({}); });
        dialog.exportButton()->click();
        QVERIFY(dialog.isExporting());
        dialog.reject(); // stops the work, the dialog stays
        QVERIFY(dialog.isVisible());
        QTRY_VERIFY_WITH_TIMEOUT(!dialog.isExporting(), waitMs);
        QVERIFY(dialog.exportButton()->isEnabled());
        QCOMPARE(files(), QStringList{"e.svgz"});
        QVERIFY(old.open(QIODevice::ReadOnly));
        QCOMPARE(old.readAll(), QByteArray("old"));
    }

private:
    QTemporaryDir m_folder, m_settings;
};

QTEST_MAIN(TestDrawingDialog)
#include "test_drawing_dialog.moc"
