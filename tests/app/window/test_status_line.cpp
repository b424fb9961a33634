// What the status bar says, and where it is cut.
#include "app/session/settings/settings.h"
#include "app/session/translation.h"
#include "app/widgets/look/elided_sentences.h"
#include "app/window/layout/window_layout.h"
#include "tests/app/session.h"

#include <QApplication>
#include <QFontMetrics>
#include <QLabel>
#include <QScopeGuard>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>

using namespace suffuse;

namespace {

/// Whether what is written up to `right` ends in "…": ink at the foot of the line only.
bool endsInDots(QWidget &widget, int right)
{
    const QImage image = widget.grab().toImage();
    const QColor ground = widget.palette().color(QPalette::Window);
    const auto topOfInk = [&](int x) {
        for (int y = 2; y < image.height(); ++y)
            if (std::abs(qGray(image.pixel(x, y)) - qGray(ground.rgb())) > 60)
                return y;
        return -1;
    };
    int last = std::min(right, image.width() - 1);
    while (last > 0 && topOfInk(last) < 0)
        --last;
    return last > 0 && topOfInk(last) > image.height() / 2;
}

} // namespace

class TestStatusLine : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_BACKEND", "cpu");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }

    void init() { window_layout::reset(); }

    /// A hint that is too long ends behind a sentence, not within one.
    void hintsAreCutBehindASentence()
    {
        const QFontMetrics metrics(QApplication::font());
        const auto cut = [&](const QString &text, const QString &roomOf) {
            return elidedSentences(text, metrics, metrics.horizontalAdvance(roomOf));
        };
        const QString text = "Drag: paint. Shift+drag: 1.5 times. Ctrl+click: colour of the picture.";
        QCOMPARE(cut(text, text), text);
        QCOMPARE(cut(text, "Drag: paint. Shift+drag: 1.5 times. Ctrl+cl"),
                 QString("Drag: paint. Shift+drag: 1.5 times. …"));
        QCOMPARE(cut(text, "Drag: paint. Shift+drag"), QString("Drag: paint. …"));
        const QString wide = QStringLiteral("拖动绘画。右键打开调色板。按住 Ctrl 取颜色。");
        QCOMPARE(cut(wide, QStringLiteral("拖动绘画。右键打开调色板。按住")),
                 QStringLiteral("拖动绘画。右键打开调色板。…"));
        // A long sentence is not left out for a short one.
        const QString uneven = "Drag. Shift+drag from paint to paint: all that lies in between is taken";
        const QString line = cut(uneven, "Drag. Shift+drag from paint to paint: all that");
        QVERIFY2(line.startsWith("Drag. Shift+drag from paint") && line.endsWith(u'…'), qPrintable(line));
    }

    /// What the status bar has no room for is in the tool tip.
    void statusTextsEndInDotsWhereTheyAreCut()
    {
        Session s;
        s.window.resize(s.window.minimumSizeHint().width(), 700);
        QVERIFY(QTest::qWaitForWindowExposed(&s.window));
        QStatusBar &bar = *s.window.statusBar();
        const QString hint = s.canvas().tool()->hint();
        QLabel *line = nullptr;
        for (QLabel *label : bar.findChildren<QLabel *>())
            if (label->text() == hint)
                line = label;
        QVERIFY(line && line->isVisible());
        QVERIFY(line->fontMetrics().horizontalAdvance(hint) > line->width());
        QVERIFY(endsInDots(*line, line->width()));
        QCOMPARE(line->toolTip(), hint);
        const int right = line->geometry().right();
        const QString message(300, 'H');
        bar.showMessage(message);
        QVERIFY(!line->isVisible());
        QVERIFY(endsInDots(bar, right));
        QCOMPARE(bar.toolTip(), message);
        bar.showMessage("HHH");
        QVERIFY(!endsInDots(bar, right)); // all of it is there
        bar.clearMessage();
        QCOMPARE(bar.toolTip(), QString());
        QVERIFY(line->isVisible());
    }

    /// A message takes the room that there is, also within a sentence.
    void messagesFillTheirLine()
    {
        Session s;
        s.window.resize(1300, 700);
        QVERIFY(QTest::qWaitForWindowExposed(&s.window));
        QStatusBar &bar = *s.window.statusBar();
        int right = bar.width(); // where the numbers begin
        for (const auto *number : bar.findChildren<QLabel *>())
            if (number->objectName() != QLatin1String("hint") && number->isVisible())
                right = std::min(right, number->x());
        QString first = "H";
        while (bar.fontMetrics().horizontalAdvance(first) < 0.6 * right)
            first += 'H';
        bar.showMessage(first + ". " + QString(300, 'H') + '.');
        QVERIFY(endsInDots(bar, right));
        const QImage image = bar.grab().toImage();
        const int ground = qGray(image.pixel(right - 2, 4));
        bool isFull = false; // to the last tenth
        for (int x = int(0.9 * right); x < right; ++x)
            for (int y = 4; y < image.height() - 4; ++y)
                isFull = isFull || std::abs(qGray(image.pixel(x, y)) - ground) > 60;
        QVERIFY(isFull);
    }

    /// On a laptop's screen one reads all of what the status bar says of painting in the past.
    void whatIsSaidOfThePastFits()
    {
        for (const QString &code : translationCodes()) {
            settings::setLanguage(code);
            installTranslators();
            const auto back = qScopeGuard([] {
                settings::setLanguage("en");
                installTranslators();
            });
            Session s;
            s.window.resize(1366, 768);
            QVERIFY(QTest::qWaitForWindowExposed(&s.window));
            s.use(Command::Brush);
            s.paintLine({100, 100}, {300, 100});
            s.dry();
            const QString hint = s.canvas().tool()->hint();
            s.editor().clock().lookAt(s.painting().end() / 2);
            QVERIFY(s.editor().clock().isInPast());
            const QLabel *line = nullptr;
            for (const QLabel *label : s.window.statusBar()->findChildren<QLabel *>())
                if (label->toolTip().endsWith('\n' + hint))
                    line = label;
            QVERIFY2(line, qPrintable(code));
            QVERIFY(!line->text().isEmpty() && line->toolTip().startsWith(line->text()));
            QVERIFY2(line->fontMetrics().horizontalAdvance(line->text()) <= line->contentsRect().width(),
                     qPrintable(code));
        }
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestStatusLine)
#include "test_status_line.moc"
