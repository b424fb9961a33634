// The pressure curve and the pen's page of the settings.
#include "app/dialogs/pen_page.h"
#include "app/dialogs/settings_dialog.h"
#include "app/session/settings/settings.h"
#include "app/widgets/brush/pen_pad.h"
#include "app/widgets/curves/response_editor.h"
#include "tests/app/session.h"
#include "tests/app/synthetic_pen.h"

#include <QCheckBox>
#include <QComboBox>
#include <QTemporaryDir>
#include <QtTest>

using namespace suffuse;

class TestPenSettings : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toUtf8());
    }
    void init() { settings::store().clear(); }

    void settingsKeepThePen()
    {
        QCOMPARE(settings::penSettings(), PenSettings{});
        const PenSettings pen{{{{0, 0.1f}, {0.3f, 0.25f}, {1, 0.9f}}}, true};
        settings::setPenSettings(pen);
        QCOMPARE(settings::penSettings(), pen);
        Session s;
        QCOMPARE(s.canvas().penSettings(), pen);
        for (const QStringList &damaged : {QStringList{"0 0"}, {"0 0", "nan 1"}, {"1 0", "0 1"}, {"a", "b"}, {}}) {
            settings::store().setValue("pen/pressure", damaged);
            QCOMPARE(settings::penSettings().pressure, ResponseCurve{});
        }
    }

    void curvesAreEdited()
    {
        ResponseEditor editor;
        editor.resize(220, 220);
        editor.show();
        const auto drag = [&](QPointF from, QPointF to) {
            QTest::mousePress(&editor, Qt::LeftButton, {}, from.toPoint());
            QTest::mouseMove(&editor, ((from + to) / 2).toPoint());
            QTest::mouseMove(&editor, to.toPoint());
            QTest::mouseRelease(&editor, Qt::LeftButton, {}, to.toPoint());
        };
        QSignalSpy edited(&editor, &ResponseEditor::edited);
        drag(editor.toWidget({0.4, 0.7}), editor.toWidget({0.5, 0.8})); // another point
        QCOMPARE(editor.curve().points.size(), std::size_t(3));
        QVERIFY(std::abs(editor.curve().points[1].x - 0.5f) < 0.02f &&
                std::abs(editor.curve().points[1].y - 0.8f) < 0.02f);
        drag(editor.toWidget({0.5, 0.8}), editor.toWidget({1, 0.2})); // not past the next one
        QVERIFY(editor.curve().isValid());
        QVERIFY(editor.curve().points[1].x < 1);
        drag(editor.toWidget({0, 0}), editor.toWidget({0, 0.25}));
        QVERIFY(std::abs(editor.curve().points[0].y - 0.25f) < 0.02f);
        QTest::keyClick(&editor, Qt::Key_Up);
        QVERIFY(std::abs(editor.curve().points[0].y - 0.26f) < 0.02f);
        QTest::keyClick(&editor, Qt::Key_PageUp);
        QTest::keyClick(&editor, Qt::Key_Delete);
        QCOMPARE(editor.curve().points.size(), std::size_t(2));
        QTest::keyClick(&editor, Qt::Key_Delete); // two stay
        QCOMPARE(editor.curve().points.size(), std::size_t(2));
        QVERIFY(edited.count() > 5);
    }

    /// Esc gives a drag of the curve up, and only then closes the dialog, which keeps nothing.
    void escapeOnThePage()
    {
        SettingsDialog dialog;
        dialog.show();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog));
        PenPage &page = *dialog.pen();
        for (QTabWidget *tabs : dialog.findChildren<QTabWidget *>())
            tabs->setCurrentWidget(&page);
        ResponseEditor &curve = *page.curve();
        curve.setFocus();
        QTest::mousePress(&curve, Qt::LeftButton, {}, curve.toWidget({1, 1}).toPoint());
        QTest::mouseMove(&curve, curve.toWidget({1, 0.4}).toPoint());
        QVERIFY(!(page.settings() == PenSettings{}));
        QTest::keyClick(&curve, Qt::Key_F11); // is none of the curve's keys
        QTest::keyClick(&curve, Qt::Key_Escape);
        QCOMPARE(page.settings(), PenSettings{});
        QCOMPARE(page.feel()->currentIndex(), 1);
        QVERIFY(dialog.isVisible());
        QTest::mouseRelease(&curve, Qt::LeftButton, {}, curve.toWidget({1, 0.4}).toPoint());
        QCOMPARE(page.settings(), PenSettings{});
        QTest::keyClick(&curve, Qt::Key_F11);
        QCOMPARE(page.settings(), PenSettings{});
        QVERIFY(dialog.isVisible() && !dialog.isFullScreen());
        page.fingersMoveView()->setChecked(true);
        QTest::keyClick(&curve, Qt::Key_Escape);
        QVERIFY(!dialog.isVisible());
        QCOMPARE(settings::penSettings(), PenSettings{});
    }

    void thePageIsTriedAndKept()
    {
        {
            SettingsDialog dialog;
            dialog.show();
            PenPage &page = *dialog.pen();
            QCOMPARE(page.feel()->currentIndex(), 1);
            emit page.feel()->activated(2);
            page.fingersMoveView()->setChecked(true);
            dialog.reject();
        }
        QCOMPARE(settings::penSettings(), PenSettings{});
        SettingsDialog dialog;
        dialog.show();
        PenPage &page = *dialog.pen();
        const auto tried = [&] {
            SyntheticPen pen;
            page.pad()->clear();
            pen.press(*page.pad(), {40, 60}, 0.4);
            for (int i = 1; i < 20; ++i)
                pen.move(*page.pad(), {40.0 + 6 * i, 60}, 0.4);
            pen.release(*page.pad(), {154, 60});
            return strongest(*page.pad()->strokes().at(0));
        };
        page.pad()->resize(260, 120);
        const float even = tried();
        emit page.feel()->activated(2);
        const float firm = tried();
        emit page.feel()->activated(0);
        const float soft = tried();
        QVERIFY2(firm < even && even < soft, qPrintable(QString("%1 %2 %3").arg(firm).arg(even).arg(soft)));
        page.fingersMoveView()->setChecked(true);
        dialog.accept();
        QVERIFY(settings::penSettings().fingersMoveView);
        QCOMPARE(settings::penSettings().pressure.points.size(), std::size_t(3));
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestPenSettings)
#include "test_pen_settings.moc"
