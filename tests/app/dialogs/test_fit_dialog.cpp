// Picture to Strokes: what is fitted, what is inserted and undone, and what is said where nothing can be.
#include "app/dialogs/fit/fit_dialog.h"
#include "app/dialogs/fit/fit_rows.h"
#include "app/dialogs/fit/fit_view.h"
#include "app/session/commands/underlay_commands.h"
#include "app/session/editor.h"
#include "app/session/files/import_strokes.h"
#include "app/session/files/picture_file.h"
#include "app/session/fitting/fit_layer.h"
#include "app/session/settings/settings.h"
#include "app/widgets/asking/messages.h"
#include "app/widgets/look/section.h"
#include "app/widgets/numbers/number_field.h"
#include "app/widgets/numbers/slider_field.h"
#include "model/shaping/transform.h"
#include "render/backends.h"
#include "undo/edits.h"

#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QPainter>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include <set>

using namespace suffuse;

namespace {

constexpr int longMs = 60'000;
constexpr QSize pictureSize(48, 32);

/// A sky that darkens upwards, and a sun.
QImage sunset()
{
    QImage image(pictureSize, QImage::Format_RGB32);
    QPainter painter(&image);
    QLinearGradient sky(0, 0, 0, pictureSize.height());
    sky.setColorAt(0, QColor(30, 60, 120));
    sky.setColorAt(1, QColor(230, 150, 90));
    painter.fillRect(image.rect(), sky);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(250, 230, 120));
    painter.drawEllipse(QPointF(30, 20), 8, 8);
    return image;
}

void setCanvas(Editor &editor, double width, double height)
{
    Canvas canvas;
    canvas.width = width, canvas.height = height;
    editor.newPainting(canvas);
}

/// The painting as it is seen at a moment, or at its end, R, G, B.
QImage drawn(const Editor &editor, const Rect &area, QSize size, std::optional<Microseconds> moment = {})
{
    RenderRequest request;
    request.painting = editor.unsettled().snapshot();
    request.time = moment.value_or(request.painting->end());
    request.view = View::ofArea(area, size.width(), size.height());
    Picture8 picture;
    auto renderer = makeRenderer({.backend = Backend::Cpu, .threads = 1});
    if (!renderer || !(*renderer)->render(request, picture))
        return {};
    QImage image(size, QImage::Format_RGB32);
    for (int y = 0; y < size.height(); ++y)
        for (int x = 0; x < size.width(); ++x)
            image.setPixel(x, y, picture.argb[std::size_t(y) * std::size_t(size.width()) + std::size_t(x)]);
    return image;
}

/// A short upright stroke, painted at that second and dry after so many.
StrokePtr strokeAt(double x, double second, float drying)
{
    Stroke stroke;
    stroke.id = 1;
    stroke.origin = {x, 30};
    Segment segment;
    segment.bezier = {Offset{0, 0}, Offset{0, 5}, Offset{0, 10}, Offset{0, 15}};
    segment.colour = {0, 1, 1, 1};
    segment.diffusion = 4;
    segment.density = 8;
    segment.maxAge = drying;
    segment.born = toMicroseconds(second);
    stroke.segments = {segment};
    return std::make_shared<const Stroke>(std::move(stroke));
}

/// The mean difference of two pictures of one size, in 255ths.
double difference(const QImage &a, const QImage &b)
{
    double sum = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
            sum += std::abs(qRed(p) - qRed(q)) + std::abs(qGreen(p) - qGreen(q)) + std::abs(qBlue(p) - qBlue(q));
        }
    return sum / (3.0 * a.width() * a.height());
}

std::set<std::tuple<float, float, float>> coloursOf(const Painting &painting)
{
    std::set<std::tuple<float, float, float>> colours;
    for (const StrokePtr &stroke : painting.strokes)
        for (const Segment &s : stroke->segments)
            if (!stroke->fill)
                colours.emplace(s.colour.red, s.colour.yellow, s.colour.blue);
    return colours;
}

} // namespace

class TestFitDialog : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(m_folder->isValid());
        qputenv("SUFFUSE_SETTINGS", pathOf("settings.ini").toUtf8());
        settings::store().clear();
        settings::store().setValue("fit/strokes", 12);
        QVERIFY(sunset().save(pathOf("sunset.png")));
        m_givesUp = true;
        m_asked = 0;
        MessageHooks hooks;
        hooks.confirm = [this](const QString &) {
            ++m_asked;
            return m_givesUp;
        };
        setMessageHooks(hooks);
    }
    void cleanupTestCase() { setMessageHooks({}); }

    void fittedInsertedUndone_data()
    {
        QTest::addColumn<QSizeF>("canvas");
        QTest::addColumn<QRectF>("area");
        QTest::newRow("all of the canvas") << QSizeF(300, 200) << QRectF(0, 0, 300, 200);
        QTest::newRow("a band of it") << QSizeF(300, 300) << QRectF(0, 50, 300, 200);
    }
    void fittedInsertedUndone()
    {
        QFETCH(QSizeF, canvas);
        QFETCH(QRectF, area);
        const Rect place = Rect::of(area.x(), area.y(), area.width(), area.height());
        Editor editor;
        setCanvas(editor, canvas.width(), canvas.height());
        const Painting before = *editor.document().painting();
        FitDialog dialog(editor, nullptr);
        QVERIFY(!dialog.insertButton()->isEnabled() && !dialog.stopButton()->isEnabled());
        QVERIFY(dialog.takeFile(pathOf("sunset.png")));
        QCOMPARE(dialog.source()->currentText(), QStringLiteral("sunset.png"));
        QTRY_VERIFY_WITH_TIMEOUT(!dialog.job().isRunning(), longMs);
        const FitNews news = dialog.job().news();
        QVERIFY2(news.peakRatio > 22, qPrintable(dialog.status()->text()));
        QVERIFY(news.strokes > 0 && news.strokes <= 12);
        QCOMPARE(dialog.progress()->value(), dialog.progress()->maximum());
        QCOMPARE(dialog.view()->shown(), news.picture);
        QCOMPARE(*editor.document().painting(), before); // until Insert

        QVERIFY(dialog.insertButton()->isEnabled());
        dialog.insertButton()->click();
        QCOMPARE(dialog.result(), int(QDialog::Accepted));
        const Painting &painting = *editor.document().painting();
        QCOMPARE(painting.strokes.size(), std::size_t(news.strokes) + 1); // and the sheet below them
        QVERIFY(editor.selection().strokes.empty()); // Their outlines would cover the picture.
        QCOMPARE(painting.groups.front().name, QStringLiteral("sunset"));
        QCOMPARE(painting.groups.front().parent, GroupId(0));
        QCOMPARE(editor.undoStack().count(), 1);
        const double apart = difference(drawn(editor, place, pictureSize), news.picture);
        QVERIFY2(apart < 1.5, qPrintable(QString::number(apart)));
        if (canvas.height() > area.height()) { // Nothing runs over the edge of the picture.
            editor.clock().setTime(painting.end());
            const QImage above = drawn(editor, Rect::of(0, 0, 300, 49), {30, 5});
            QCOMPARE(above.pixel(20, 4), above.pixel(0, 0));
            QCOMPARE(above.pixel(29, 4), above.pixel(0, 0));
        }
        editor.undo();
        QCOMPARE(*editor.document().painting(), before);
        QVERIFY(!editor.canUndo());
    }

    /// What comes is painted after what is there, as one who paints on would paint it.
    void insertedStrokesComeAfterWhatIsThere_data()
    {
        QTest::addColumn<double>("moment"); // s
        QTest::newRow("in the present") << 1e9;
        QTest::newRow("in the past") << 6.0;
        QTest::newRow("while paint spreads") << 5.05;
    }
    void insertedStrokesComeAfterWhatIsThere()
    {
        QFETCH(double, moment);
        Editor editor;
        setCanvas(editor, 300, 200);
        Painting own = *editor.document().painting();
        for (const double second : {0.0, 5.0, 20.0})
            own.strokes.push_back(strokeAt(20 + 10 * second, second, 2));
        editor.newPainting(own.canvas);
        QCOMPARE(addStrokes(editor, own, {}, "Paint"), QString());
        const Microseconds end = editor.document().painting()->end(), now = std::min(end, toMicroseconds(moment));
        editor.clock().lookAt(now);
        const QImage before = drawn(editor, own.canvas.area(), {60, 40}, now);

        FitResult fit; // as of a picture that takes a minute to paint, in a corner that nobody painted
        fit.name = "picture";
        fit.painting.canvas.width = 300, fit.painting.canvas.height = 200;
        for (int i = 0; i < 600; ++i)
            fit.painting.strokes.push_back(strokeAt(250, 0.1 * i, 0.5));
        const Rect corner = Rect::of(240, 160, 60, 40);
        const QString said = insertFit(editor, fit, corner);
        const Painting &painting = *editor.document().painting();
        QCOMPARE(painting.strokes.size(), std::size_t(3 + 601));
        std::vector<StrokePtr> layer; // In the past it lies below what was painted later.
        for (const StrokePtr &stroke : painting.strokes)
            if (stroke->group != 0)
                layer.push_back(stroke);
        QCOMPARE(layer.size(), std::size_t(601));
        const Microseconds first = layer.front()->born();
        Microseconds last = first;
        const bool isPresent = now == end;
        const Microseconds seen = isPresent ? painting.end() : now;
        for (const StrokePtr &stroke : layer) {
            QVERIFY(stroke->born() >= last && stroke->driesAt() <= seen);
            last = stroke->born();
        }
        QVERIFY(last > first);
        QVERIFY(isPresent ? first >= end : first > toMicroseconds(moment - 1.1) && first >= toMicroseconds(4.9));
        QCOMPARE(editor.clock().time(), seen);
        QCOMPARE(said.contains("quickly"), !isPresent);
        QVERIFY(!said.contains("brought back"));
        QImage after = drawn(editor, own.canvas.area(), {60, 40}, seen);
        QCOMPARE(after.copy(0, 0, 46, 40), before.copy(0, 0, 46, 40));
        QVERIFY(difference(after, before) > 0);
        editor.undo();
        QCOMPARE(editor.document().painting()->strokes.size(), std::size_t(3));
    }

    void cancelLeavesAllAsItWas()
    {
        Editor editor;
        setCanvas(editor, 300, 200);
        const PaintingPtr before = editor.document().snapshot();
        const int steps = editor.undoStack().count();
        FitDialog dialog(editor, nullptr);
        dialog.rows()->detail()->setCurrentIndex(dialog.rows()->detail()->count() - 1);
        QVERIFY(dialog.takeFile(pathOf("sunset.png")));
        QVERIFY(dialog.job().isRunning());
        QTRY_VERIFY_WITH_TIMEOUT(!dialog.view()->shown().isNull(), longMs);
        dialog.reject();
        QVERIFY(!dialog.job().isRunning());
        QCOMPARE(dialog.result(), int(QDialog::Rejected));
        QCOMPARE(editor.document().snapshot(), before);
        QCOMPARE(editor.undoStack().count(), steps);
    }

    /// Minutes of work do not go by a key, and neither by a click.
    void whatWasWorkedOutIsNotGivenUpUnasked()
    {
        Editor editor;
        setCanvas(editor, 300, 200);
        m_givesUp = false;
        FitDialog none(editor, nullptr);
        none.show();
        QTest::keyClick(&none, Qt::Key_Escape); // There is nothing to lose.
        QVERIFY(!none.isVisible());
        QCOMPARE(m_asked, 0);
        FitDialog dialog(editor, nullptr);
        dialog.show();
        QVERIFY(dialog.takeFile(pathOf("sunset.png")));
        QTRY_VERIFY_WITH_TIMEOUT(!dialog.job().isRunning(), longMs);
        QTest::keyClick(&dialog, Qt::Key_Escape);
        QCOMPARE(m_asked, 1);
        QVERIFY(dialog.isVisible() && dialog.insertButton()->isEnabled());
        dialog.close();
        QCOMPARE(m_asked, 2);
        QVERIFY(dialog.isVisible());
        m_givesUp = true;
        QTest::keyClick(&dialog, Qt::Key_Escape);
        QCOMPARE(m_asked, 3);
        QVERIFY(!dialog.isVisible());
        QVERIFY(editor.document().painting()->strokes.empty());
    }

    /// 1366 × 768 pixels at two a logical one, less title and task bar.
    void itFitsOnALowScreenWithAllOfItsRows()
    {
        Editor editor;
        FitDialog dialog(editor, nullptr);
        dialog.rows()->more()->setChecked(true);
        dialog.show();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
        QVERIFY2(dialog.minimumSizeHint().height() <= 330, qPrintable(QString::number(dialog.minimumSizeHint().height())));
        QVERIFY(dialog.minimumSizeHint().width() <= 683);
        dialog.resize(683, 330);
        QCoreApplication::processEvents();
        const auto areas = dialog.findChildren<QScrollArea *>();
        QVERIFY(!areas.isEmpty());
        for (QScrollArea *area : areas)
            area->ensureWidgetVisible(dialog.rows()->seed());
        const QPoint seed = dialog.rows()->seed()->mapTo(&dialog, dialog.rows()->seed()->rect().center());
        QVERIFY(QRect(0, 0, 683, 330).contains(seed) && !dialog.rows()->seed()->visibleRegion().isEmpty());
        QVERIFY(dialog.rect().contains(dialog.insertButton()->mapTo(&dialog, dialog.insertButton()->rect().center())));
    }

    void underlayIsTaken()
    {
        Editor editor;
        setCanvas(editor, 400, 400);
        QCOMPARE(underlay::importFile(editor, pathOf("sunset.png")), QString());
        underlay::setArea(editor, Rect::of(100, 200, 150, 100));
        const int steps = editor.undoStack().count();
        FitDialog dialog(editor, nullptr);
        QCOMPARE(dialog.source()->currentText(), QStringLiteral("Underlay"));
        QTRY_VERIFY_WITH_TIMEOUT(!dialog.job().isRunning(), longMs);
        dialog.accept();
        const Painting &painting = *editor.document().painting();
        QCOMPARE(editor.undoStack().count(), steps + 1);
        QCOMPARE(painting.groups.front().name, QStringLiteral("Underlay"));
        const Rect sheet = controlBox(*painting.strokes[0]);
        QVERIFY(std::abs(sheet.left - 100) < 1e-3 && std::abs(sheet.top - 200) < 1e-3);
        QVERIFY(std::abs(sheet.right - 250) < 1e-3 && std::abs(sheet.bottom - 300) < 1e-3);
        QVERIFY(painting.underlay); // which stays
    }

    void stoppedAndGoneOnWith()
    {
        Editor editor;
        setCanvas(editor, 300, 200);
        FitDialog dialog(editor, nullptr);
        dialog.rows()->detail()->setCurrentIndex(dialog.rows()->detail()->count() - 1);
        QVERIFY(dialog.takeFile(pathOf("sunset.png")));
        QTRY_VERIFY_WITH_TIMEOUT(dialog.job().news().strokes > 0, longMs);
        QCOMPARE(dialog.stopButton()->text().remove('&'), QStringLiteral("Stop"));
        dialog.stopButton()->click();
        QVERIFY(!dialog.job().isRunning());
        QCOMPARE(dialog.stopButton()->text().remove('&'), QStringLiteral("Go On"));
        QVERIFY(dialog.insertButton()->isEnabled()); // what there is
        const std::size_t some = dialog.job().result().painting.strokes.size();
        QVERIFY(some > 0);
        dialog.stopButton()->click();
        QVERIFY(dialog.job().isRunning());
        dialog.stopButton()->click();
        QVERIFY(dialog.job().result().painting.strokes.size() >= some); // it did not begin anew
    }

    void moreGoesOnAndFewerBeginAnew()
    {
        FitWish before;
        before.strokes = 100;
        FitWish more = before;
        more.strokes = 200, more.steps *= 2, more.paints = 8, more.leastWidth = 3;
        QVERIFY(more.goesOnFrom(before));
        QVERIFY(!before.goesOnFrom(more));
        FitWish other = before;
        other.style = StyleKind::Uniform;
        QVERIFY(!other.goesOnFrom(before));
        other = before;
        other.seed = 2;
        QVERIFY(!other.goesOnFrom(before));

        Editor editor;
        setCanvas(editor, 300, 200);
        FitDialog dialog(editor, nullptr);
        QVERIFY(dialog.takeFile(pathOf("sunset.png")));
        QTRY_VERIFY_WITH_TIMEOUT(!dialog.job().isRunning(), longMs);
        const double ratio = dialog.job().news().peakRatio;
        emit dialog.rows()->strokes()->edited(30, nullptr);
        QVERIFY(dialog.job().isRunning());
        QTRY_VERIFY_WITH_TIMEOUT(!dialog.job().isRunning(), longMs);
        QVERIFY(dialog.job().news().strokes > 12);
        QVERIFY2(dialog.job().news().peakRatio > ratio, qPrintable(dialog.status()->text()));
        emit dialog.rows()->strokes()->edited(6, nullptr);
        QTRY_VERIFY_WITH_TIMEOUT(!dialog.job().isRunning(), longMs);
        QVERIFY(dialog.job().news().strokes <= 6);
    }

    /// Also where it is stopped before the fit itself has come to its paints.
    void fewPaintsBecomeSwatches()
    {
        Editor editor;
        setCanvas(editor, 300, 200);
        const std::size_t swatches = editor.document().painting()->swatches.size();
        settings::store().setValue("fit/colours", 1);
        settings::store().setValue("fit/paints", 3);
        FitDialog dialog(editor, nullptr);
        QVERIFY(dialog.rows()->paints()->isEnabled());
        QVERIFY(dialog.takeFile(pathOf("sunset.png")));
        QTRY_VERIFY_WITH_TIMEOUT(dialog.job().news().strokes > 3, longMs);
        dialog.accept();
        const Painting &painting = *editor.document().painting();
        const std::size_t paints = coloursOf(painting).size();
        QVERIFY(paints > 0 && paints <= 3);
        QCOMPARE(painting.swatches.size(), swatches + paints);
        QVERIFY(painting.swatches.back().linked);
        editor.undo();
        QCOMPARE(editor.document().painting()->swatches.size(), swatches);
    }

    void theOriginalIsShown()
    {
        Editor editor;
        setCanvas(editor, 300, 200);
        FitDialog dialog(editor, nullptr);
        QVERIFY(!dialog.originalButton()->isEnabled());
        QVERIFY(dialog.takeFile(pathOf("sunset.png")));
        QTRY_VERIFY_WITH_TIMEOUT(!dialog.job().isRunning(), longMs);
        QVERIFY(difference(dialog.job().news().original, sunset()) < 1);
        QTest::mousePress(dialog.originalButton(), Qt::LeftButton);
        QCOMPARE(dialog.view()->shown(), dialog.job().news().original);
        QTest::mouseRelease(dialog.originalButton(), Qt::LeftButton);
        dialog.originalButton()->setChecked(false);
        dialog.view()->showOriginal(false);
        QCOMPARE(dialog.view()->shown(), dialog.job().news().picture);
        QTest::mousePress(dialog.view(), Qt::LeftButton);
        QCOMPARE(dialog.view()->shown(), dialog.job().news().original);
        QTest::mouseRelease(dialog.view(), Qt::LeftButton);
        QCOMPARE(dialog.view()->shown(), dialog.job().news().picture);
    }

    /// Twelve strokes become fewer, between those below and above, in one step that is undone.
    void selectedStrokesBecomeFewer()
    {
        Editor editor;
        addStripes(editor);
        const Painting before = *editor.document().painting();
        const int steps = editor.undoStack().count();
        const QImage shown = drawn(editor, before.canvas.area(), {90, 60});
        Result<RefitTask> task = RefitTask::ofSelection(editor);
        QVERIFY2(task, task ? "" : qPrintable(task.error()));
        QCOMPARE(task->count(), std::size_t(12));
        FitDialog dialog(editor, std::move(*task), nullptr);
        QCOMPARE(dialog.source()->currentText(), QStringLiteral("As they look"));
        QCOMPARE(dialog.rows()->wish().strokes, 3); // a quarter
        QTRY_VERIFY_WITH_TIMEOUT(!dialog.job().isRunning(), longMs);
        QVERIFY2(dialog.status()->text().contains("of 255"), qPrintable(dialog.status()->text()));
        QCOMPARE(*editor.document().painting(), before); // until Replace
        dialog.insertButton()->click();
        QCOMPARE(dialog.result(), int(QDialog::Accepted));
        const Painting &painting = *editor.document().painting();
        QVERIFY(painting.strokes.size() >= 3 && painting.strokes.size() <= 5);
        QCOMPARE(painting.strokes.front(), before.strokes.front());
        QCOMPARE(painting.strokes.back(), before.strokes.back());
        QCOMPARE(editor.selection().strokes.size(), painting.strokes.size() - 2);
        QVERIFY2(dialog.said().contains("in place of 12") && dialog.said().contains("of 255"), qPrintable(dialog.said()));
        QCOMPARE(editor.undoStack().count(), steps + 1);
        const double apart = difference(drawn(editor, before.canvas.area(), {90, 60}), shown);
        QVERIFY2(apart < 3, qPrintable(QString::number(apart)));
        QCOMPARE(settings::store().value("fit/strokes").toInt(), 12); // that of pictures
        editor.undo();
        QCOMPARE(*editor.document().painting(), before);
    }

    /// Strokes that take the picture farther from what was wanted are not put there without a word.
    void worseStrokesAreTold()
    {
        Editor editor;
        addStripes(editor);
        const Rect sheet = editor.document().painting()->canvas.area();
        QVERIFY(drawn(editor, sheet, {90, 60}).save(pathOf("wanted.png")));
        const Result<EncodedImage> wanted = readPictureFile(pathOf("wanted.png"));
        QVERIFY(wanted);
        const Result<RefitTask> task = RefitTask::ofSelection(editor);
        QVERIFY(task);
        FitResult fit;
        fit.painting.canvas.width = 20, fit.painting.canvas.height = 20;
        fit.painting.strokes.push_back(strokeAt(10, 0, 1));
        const QString said = task->apply(editor, fit, *wanted, "wanted.png");
        QVERIFY2(said.contains("farther than before"), qPrintable(said));
        editor.undo();
        const QString own = task->apply(editor, fit, {}, {}); // Nothing is nearer to how it looks than it is itself.
        QVERIFY2(!own.contains("farther than before") && own.contains("off by"), qPrintable(own));
    }

    /// Or they are made to look like a picture, which must have the shape of the sheet; cancelled, nothing changes.
    void selectedStrokesBecomeAPicture()
    {
        Editor editor;
        addStripes(editor);
        const PaintingPtr before = editor.document().snapshot();
        FitDialog dialog(editor, *RefitTask::ofSelection(editor), nullptr);
        QVERIFY(dialog.takeFile(pathOf("sunset.png"))); // 48 × 32, as the sheet
        QTRY_VERIFY_WITH_TIMEOUT(!dialog.job().isRunning(), longMs);
        QVERIFY2(dialog.hint()->text().isEmpty() && dialog.job().news().strokes > 0, qPrintable(dialog.hint()->text()));
        QVERIFY(QImage(50, 50, QImage::Format_RGB32).save(pathOf("square.png")));
        QVERIFY(dialog.takeFile(pathOf("square.png")));
        QTRY_VERIFY_WITH_TIMEOUT(dialog.hint()->text().contains("square.png"), longMs);
        dialog.source()->setCurrentIndex(0);
        emit dialog.source()->activated(0);
        QTRY_VERIFY_WITH_TIMEOUT(dialog.job().news().strokes > 0, longMs);
        dialog.reject();
        QCOMPARE(editor.document().snapshot(), before);
        editor.document().setSelection({});
        const Result<RefitTask> nothing = RefitTask::ofSelection(editor);
        QVERIFY(!nothing && nothing.error().contains("choose others"));
    }

    void whatIsNoPictureIsTold_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("bytes");
        QTest::newRow("empty") << "empty.png" << QByteArray();
        QTest::newRow("text") << "text.png" << QByteArray("This is no picture.");
        QTest::newRow("cut off") << "cut.png" << QByteArray("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16);
    }
    void whatIsNoPictureIsTold()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, bytes);
        QFile file(pathOf(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(bytes);
        file.close();
        Editor editor;
        setCanvas(editor, 300, 200);
        FitDialog dialog(editor, nullptr);
        const QSignalSpy ended(&dialog.job(), &FitJob::ended);
        if (dialog.takeFile(pathOf(name)))
            QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, longMs);
        QVERIFY2(dialog.hint()->text().contains(name), qPrintable(dialog.hint()->text()));
        QVERIFY(!dialog.insertButton()->isEnabled() && !dialog.stopButton()->isEnabled());
        dialog.accept(); // inserts nothing
        QVERIFY(editor.document().painting()->strokes.empty());
        QVERIFY(!dialog.takeFile(pathOf("there is none.png")));
        QVERIFY(dialog.hint()->text().contains("there is none.png"));
        // After that, a picture is welcome.
        QVERIFY(dialog.takeFile(pathOf("sunset.png")));
        QVERIFY(dialog.hint()->text().isEmpty());
        QTRY_VERIFY_WITH_TIMEOUT(dialog.job().news().strokes > 0, longMs);
    }

private:
    bool m_givesUp = true;
    int m_asked = 0;
    /// A wide stroke, twelve that lie side by side and are selected, and one across them.
    static void addStripes(Editor &editor)
    {
        setCanvas(editor, 90, 60);
        std::vector<StrokePtr> strokes;
        for (int k = 0; k < 14; ++k) {
            const bool isOdd = k == 0 || k == 13;
            Stroke stroke;
            stroke.id = editor.document().takeStrokeId();
            stroke.origin = isOdd ? Point{45, 10} : Point{20, 20 + 1.5 * k};
            Segment segment;
            segment.bezier = isOdd ? std::array<Offset, 4>{Offset{0, 0}, {0, 13}, {0, 27}, {0, 40}}
                                   : std::array<Offset, 4>{Offset{0, 0}, {15, 2}, {30, 2}, {50, 0}};
            segment.maxAge = 1;
            segment.diffusion = k == 0 ? 30 : 2;
            segment.density = k == 0 ? 10 : 3;
            segment.colour = k == 0 ? Colour{0.1f, 0.2f, 0.8f, 0.6f} : k == 13 ? Colour{0.8f, 0.8f, 0.8f, 0.9f}
                                                                               : Colour{0.9f, 0.2f, 0.1f, 0.8f};
            stroke.segments.push_back(segment);
            strokes.push_back(std::make_shared<const Stroke>(stroke));
        }
        editor.push(addStrokes(editor.document(), strokes, false), "Stripes");
        Selection middle;
        for (int k = 1; k < 13; ++k)
            middle.strokes.insert(strokes[std::size_t(k)]->id);
        editor.document().setSelection(middle);
        editor.clock().setTime(editor.document().painting()->end());
    }

    QString pathOf(const QString &name) const { return m_folder->filePath(name); }

    std::unique_ptr<QTemporaryDir> m_folder;
};

QTEST_MAIN(TestFitDialog)
#include "test_fit_dialog.moc"
