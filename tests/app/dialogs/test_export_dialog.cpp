// File ▸ Export…: any area, moment and size, as the renderer draws them; whole pictures or nothing.
#include "app/dialogs/export/clock_box.h"
#include "app/dialogs/export/export_dialog.h"
#include "app/dialogs/export/preset_row.h"
#include "app/dialogs/export/print_rows.h"
#include "app/session/settings/settings.h"
#include "app/widgets/look/section.h"
#include "app/widgets/numbers/length_units.h"
#include "app/widgets/numbers/time_text.h"
#include "app/window/main_window.h"
#include "model/painting/influence.h"
#include "render/backends.h"
#include "tests/app/file_dialogs.h"
#include "tests/app/panel_bench.h"
#include "tests/files.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QJsonArray>
#include <QJsonObject>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QToolTip>

#include <cmath>
#include <cstring>
#include <set>

using namespace suffuse;

namespace {

const Rect shown = Rect::of(40, 80, 100, 50);

/// What a PFM holds: red, green and blue of each pixel, from the top.
struct Pfm {
    int width = 0, height = 0;
    std::vector<float> rgb;
};

Pfm pfmIn(const QString &path)
{
    QFile file(path);
    Pfm pfm;
    if (!file.open(QIODevice::ReadOnly) || file.readLine() != "PF\n")
        return pfm;
    const QList<QByteArray> size = file.readLine().trimmed().split(' ');
    pfm.width = size.value(0).toInt();
    pfm.height = size.value(1).toInt();
    file.readLine(); // the order of bytes
    const QByteArray bytes = file.readAll();
    const qsizetype row = qsizetype(sizeof(float)) * 3 * pfm.width;
    pfm.rgb.resize(std::size_t(3 * pfm.width) * std::size_t(pfm.height));
    for (int y = 0; y < pfm.height && bytes.size() == row * pfm.height; ++y) // rows go upwards
        std::memcpy(pfm.rgb.data() + 3 * pfm.width * y, bytes.constData() + row * (pfm.height - 1 - y),
                    std::size_t(row));
    return pfm;
}

/// The same from the renderer.
Pfm rendered(Editor &editor, const Rect &area, Microseconds time, int width)
{
    Pfm pfm{width, heightForWidth(area, width), {}};
    const auto renderer = makeRenderer({.backend = Backend::Auto});
    RenderRequest request;
    request.painting = editor.document().painting();
    request.time = time;
    request.view = View::ofArea(area, pfm.width, pfm.height);
    FloatPicture picture;
    if (!renderer || !(*renderer)->render(request, picture))
        return {};
    for (std::size_t i = 0; i < picture.rgba.size(); ++i)
        if (i % 4 < 3)
            pfm.rgb.push_back(picture.rgba[i]);
    return pfm;
}

} // namespace

class TestExportDialog : public QObject {
    Q_OBJECT

    static void enter(QAbstractSpinBox &box, const QString &text)
    {
        box.setFocus();
        box.selectAll();
        QTest::keyClicks(&box, text);
        QTest::keyClick(&box, Qt::Key_Tab);
    }

private slots:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(m_folder->isValid());
        qputenv("SUFFUSE_SETTINGS", m_folder->filePath("settings.ini").toUtf8());
    }

    /// Arithmetic works in pixels as in every other number.
    void sizesAreCalculated()
    {
        Bench bench;
        ExportDialog dialog(bench.editor, {});
        dialog.show();
        QVERIFY(QTest::qWaitForWindowActive(&dialog));
        const int width = dialog.widthBox()->value(), height = dialog.heightBox()->value();
        enter(*dialog.widthBox(), "512*2");
        QCOMPARE(dialog.widthBox()->value(), 1024);
        enter(*dialog.widthBox(), "512/2 px");
        QCOMPARE(dialog.widthBox()->value(), 256);
        enter(*dialog.widthBox(), "*2");
        QCOMPARE(dialog.widthBox()->value(), 512);
        QCOMPARE(dialog.heightBox()->value(), heightForWidth({0, 0, double(width), double(height)}, 512));
        const int tall = dialog.heightBox()->value();
        enter(*dialog.heightBox(), "/2");
        QVERIFY(std::abs(dialog.heightBox()->value() - tall / 2.0) <= 1);
        enter(*dialog.widthBox(), "1000/3");
        QCOMPARE(dialog.widthBox()->value(), 333);
        enter(*dialog.widthBox(), "many");
        QCOMPARE(dialog.widthBox()->value(), 333);
        dialog.quality()->setEnabled(true);
        enter(*dialog.quality(), "30*3");
        QCOMPARE(dialog.quality()->value(), 90);
    }

    /// Widths and heights in pixels and on paper stand below each other.
    void sizesAreAligned()
    {
        Bench bench;
        ExportDialog dialog(bench.editor, {});
        dialog.show();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog));
        const auto place = [&](const QWidget *box) {
            const int left = box->mapTo(&dialog, QPoint()).x();
            return std::pair(left, left + box->width());
        };
        const PrintRows &print = *dialog.findChild<PrintRows *>();
        QCOMPARE(place(dialog.widthBox()), place(print.widthBox()));
        QCOMPARE(place(dialog.heightBox()), place(print.heightBox()));
        QCOMPARE(place(print.dpiBox()).first, place(print.widthBox()).first);
        QCOMPARE(place(print.dpiBox()).second, place(print.unitBox()).second);
    }

    /// Nothing is written with another size than the one that was asked for.
    void returnOnWhatCannotBeReadExportsNothing()
    {
        Bench bench;
        ExportDialog dialog(bench.editor, {});
        dialog.path()->setText(m_folder->filePath("never.png"));
        dialog.show();
        QVERIFY(QTest::qWaitForWindowActive(&dialog));
        const int width = dialog.widthBox()->value();
        for (const char *text : {"2000*", "8in", "0"}) {
            QToolTip::hideText();
            dialog.widthBox()->setFocus();
            dialog.widthBox()->selectAll();
            QTest::keyClicks(dialog.widthBox(), text);
            QTest::keyClick(dialog.widthBox(), Qt::Key_Return);
            QTRY_VERIFY(QToolTip::text().contains(QLatin1String(text) == QLatin1String("8in") ? "in" : text));
            QVERIFY(dialog.isVisible() && dialog.widthBox()->hasFocus());
            QVERIFY(!QFile::exists(m_folder->filePath("never.png")));
            QCOMPARE(dialog.widthBox()->value(), width);
        }
        dialog.heightBox()->setFocus(); // what is left is what was there, and it says so
        QCOMPARE(dialog.widthBox()->value(), width);
    }

    void exportWritesThePicture()
    {
        Bench bench;
        ExportDialog dialog(bench.editor, shown);
        dialog.show();
        QCOMPARE(dialog.widthBox()->value(), 1024);
        dialog.widthBox()->setValue(64);
        QCOMPARE(dialog.heightBox()->value(), 48);
        const QString path = m_folder->filePath("picture.pfm"); // needs no image module
        dialog.path()->setText(path);
        dialog.depth()->setCurrentIndex(dialog.depth()->findData(int(ImageDepth::Float)));
        QTest::mouseClick(dialog.exportButton(), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(dialog.result(), int(QDialog::Accepted), 20000);
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray bytes = file.readAll();
        QVERIFY(bytes.startsWith("PF\n64 48\n"));
        QVERIFY(bytes.size() >= 64 * 48 * 12);
    }

    /// Typing an ending chooses the format, and choosing a format changes the ending.
    void theFormatIsShown()
    {
        Bench bench;
        ExportDialog dialog(bench.editor, shown);
        dialog.show();
        QCOMPARE(dialog.format()->currentText(), QString("PNG"));
        for (const auto &[name, format] :
             {std::pair("a.tif", "TIFF"), std::pair("a.JPG", "JPEG"), std::pair("b/a 1.0.exr", "EXR")}) {
            dialog.path()->selectAll();
            QTest::keyClicks(dialog.path(), name);
            QCOMPARE(dialog.format()->currentText(), QString(format));
        }
        const auto choose = [&](const char *format) {
            dialog.format()->setFocus();
            QTest::keyClick(dialog.format(), Qt::Key_Home);
            while (dialog.format()->currentText() != format)
                QTest::keyClick(dialog.format(), Qt::Key_Down);
        };
        choose("WebP");
        QCOMPARE(dialog.path()->text(), QString("b/a 1.0.webp"));
        QVERIFY(dialog.quality()->isEnabled());
        dialog.path()->setText("edited.doc");
        QCOMPARE(dialog.format()->currentIndex(), -1);
        QVERIFY(!dialog.format()->placeholderText().isEmpty());
        dialog.path()->setText("edited 1.0"); // It has no ending, so the format stays.
        QCOMPARE(dialog.format()->currentText(), QString("WebP"));
        choose("PNG");
        QCOMPARE(dialog.path()->text(), QString("edited 1.0.png"));
    }

    /// Who wants a drawing is told where it is written.
    void drawingsAreExportedElsewhere()
    {
        Bench bench;
        ExportDialog dialog(bench.editor, shown);
        dialog.show();
        dialog.path()->setText(m_folder->filePath("a.svg"));
        QTest::mouseClick(dialog.exportButton(), Qt::LeftButton);
        const QList<QLabel *> labels = dialog.findChildren<QLabel *>();
        QVERIFY(std::ranges::any_of(labels, [](const QLabel *label) {
            return label->isVisible() && label->text().contains("Export Drawing");
        }));
        QVERIFY(dialog.isVisible() && !QFileInfo::exists(m_folder->filePath("a.svg")));
    }

    void exportOfAnyAreaAndMoment_data()
    {
        using Area = AreaRow::Choice;
        using Moment = MomentRow::Choice;
        QTest::addColumn<int>("choice");
        QTest::addColumn<int>("moment");
        QTest::newRow("all") << int(Area::Canvas) << int(Moment::Dried);
        QTest::newRow("painted, now") << int(Area::Painted) << int(Moment::Now);
        QTest::newRow("selected, at a time") << int(Area::Selected) << int(Moment::Time);
        QTest::newRow("shown, at a time") << int(Area::Shown) << int(Moment::Time);
        QTest::newRow("numbers, now") << int(Area::Numbers) << int(Moment::Now);
    }
    void exportOfAnyAreaAndMoment()
    {
        QFETCH(const int, choice);
        QFETCH(const int, moment);
        Bench bench;
        auto red = std::make_shared<Painting>(*bench.editor.document().painting());
        red->strokes = {};
        for (const StrokePtr &stroke : bench.editor.document().painting()->strokes) {
            Stroke copy = *stroke;
            for (Segment &segment : copy.segments)
                segment.colour = {1, 0, 0, 1};
            red->strokes.push_back(std::make_shared<const Stroke>(std::move(copy)));
        }
        bench.editor.document().reset(red);
        bench.editor.clock().setManual(true);
        bench.editor.clock().setTime(300'000);
        bench.select({2});
        const Painting &painting = *bench.editor.document().painting();
        const Rect painted = influenceOf(painting, painting.end()), byNumbers = Rect::of(45.5, 90.25, 60, 20);
        const Rect selected = influenceOf(bench.stroke(2), painting.end());
        const Rect areas[] = {
            painting.canvas.area(),
            {std::floor(painted.left), std::floor(painted.top), std::ceil(painted.right), std::ceil(painted.bottom)},
            {std::floor(selected.left), std::floor(selected.top), std::ceil(selected.right),
             std::ceil(selected.bottom)},
            shown,
            byNumbers};
        const Rect &area = areas[choice];
        const Microseconds times[] = {painting.end(), 300'000, 125'000};

        ExportDialog dialog(bench.editor, shown);
        dialog.show();
        QVERIFY(QTest::qWaitForWindowActive(&dialog));
        if (AreaRow::Choice(choice) == AreaRow::Choice::Numbers) {
            const char *typed[] = {"45.5", "90.25", "60", "20"};
            for (std::size_t i = 0; i < 4; ++i)
                enter(*dialog.area()->numbers()[i], typed[i]);
        } else {
            dialog.area()->choose(AreaRow::Choice(choice));
        }
        QCOMPARE(dialog.area()->choice(), AreaRow::Choice(choice));
        QCOMPARE(dialog.area()->area(), area);
        QCOMPARE(dialog.area()->numbers()[0]->value(), area.left);
        QCOMPARE(dialog.area()->numbers()[3]->value(), area.height());
        QCOMPARE(dialog.widthBox()->value(), int(std::round(area.width()))); // a pixel a unit
        dialog.widthBox()->setValue(64);
        QCOMPARE(dialog.heightBox()->value(), std::max(heightForWidth(area, 64), 1));
        if (MomentRow::Choice(moment) == MomentRow::Choice::Time)
            enter(*dialog.moment()->clock(), "0:00.125");
        else
            dialog.moment()->box()->setCurrentIndex(moment);
        QCOMPARE(int(dialog.moment()->choice()), moment);
        QCOMPARE(dialog.moment()->clock()->time(), times[moment]);

        const QString path = m_folder->filePath("area.pfm");
        dialog.path()->setText(path);
        dialog.depth()->setCurrentIndex(dialog.depth()->findData(int(ImageDepth::Float)));
        QTest::mouseClick(dialog.exportButton(), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(dialog.result(), int(QDialog::Accepted), 20000);
        const Pfm written = pfmIn(path), expected = rendered(bench.editor, area, times[moment], 64);
        QCOMPARE(QSize(written.width, written.height), QSize(expected.width, expected.height));
        QVERIFY(!expected.rgb.empty());
        QVERIFY(written.rgb == expected.rgb);
        QVERIFY(std::set<float>(written.rgb.begin(), written.rgb.end()).size() > 10); // there is paint in it
    }

    void aNameWithoutEndingGetsThatOfTheFormat()
    {
        Bench bench;
        ExportDialog dialog(bench.editor, shown);
        dialog.show();
        dialog.path()->setText(m_folder->filePath("first.pfm"));
        const int format = dialog.format()->currentIndex();
        dialog.path()->setText(m_folder->filePath("no ending v1.0"));
        QCOMPARE(dialog.format()->currentIndex(), format);
        dialog.widthBox()->setValue(16);
        QTest::mouseClick(dialog.exportButton(), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(dialog.result(), int(QDialog::Accepted), 20000);
        QCOMPARE(pfmIn(m_folder->filePath("no ending v1.0.pfm")).width, 16);
    }

    void exportKeepsTheScaleForAnotherArea()
    {
        Bench bench(0);
        ExportDialog dialog(bench.editor, shown);
        using enum AreaRow::Choice;
        for (const AreaRow::Choice missing : {Painted, Selected}) {
            dialog.area()->choose(missing);
            QCOMPARE(dialog.area()->choice(), Canvas);
        }
        dialog.widthBox()->setValue(2048);
        dialog.area()->choose(Shown);
        QCOMPARE(dialog.widthBox()->value(), 200);
        dialog.area()->numbers()[2]->setValue(0.01);
        QCOMPARE(dialog.area()->choice(), Numbers);
        QCOMPARE(dialog.widthBox()->value(), 1);
        dialog.area()->choose(Canvas);
        QCOMPARE(dialog.widthBox()->value(), 2048);
    }

    void limitsAreSaidAndOne()
    {
        Bench bench;
        ExportDialog dialog(bench.editor, shown);
        const int width = dialog.widthBox()->maximum(), height = dialog.heightBox()->maximum();
        QVERIFY(qint64(width) * height <= maxPicturePixels); // what suffuse-cli has, too
        QVERIFY(qint64(width + 1) * heightForWidth(bench.editor.document().painting()->canvas.area(), width + 1) >
                maxPicturePixels);
        QVERIFY(dialog.limits()->text().contains(QLocale().toString(width)));
        QVERIFY(dialog.limits()->text().contains(QLocale().toString(height)));
        dialog.widthBox()->setValue(20'000);
        dialog.path()->setText(m_folder->filePath("small.webp"));
        QCOMPARE(dialog.widthBox()->maximum(), 16383);
        QCOMPARE(dialog.widthBox()->value(), 16383);
        QVERIFY(dialog.limits()->text().contains(QLocale().toString(16383)));
        dialog.area()->setNumbers(Rect::of(0, 0, 10, 40)); // a high one: its height is the limit
        QCOMPARE(dialog.heightBox()->maximum(), 16383 / 4 * 4);
    }

    void printSizeAndResolution()
    {
        Bench bench;
        ExportDialog dialog(bench.editor, shown);
        PrintRows &print = *dialog.print();
        print.unitBox()->setCurrentIndex(0);
        QCOMPARE(print.dpi(), 150.0);
        dialog.widthBox()->setValue(3000);
        QCOMPARE(print.widthBox()->value(), 508.0);
        QCOMPARE(print.heightBox()->value(), 381.0); // 4:3
        print.dpiBox()->setValue(600);               // pixels were set: they stay
        QCOMPARE(dialog.widthBox()->value(), 3000);
        QCOMPARE(print.widthBox()->value(), 127.0);
        print.widthBox()->setValue(254);
        QCOMPARE(dialog.widthBox()->value(), 6000);
        QCOMPARE(dialog.heightBox()->value(), 4500);
        print.dpiBox()->setValue(150); // the print size was set: it stays
        QCOMPARE(dialog.widthBox()->value(), 1500);
        QCOMPARE(print.widthBox()->value(), 254.0);
        print.heightBox()->setValue(95.2);
        QCOMPARE(dialog.heightBox()->value(), heightForWidth({0, 0, 1024, 768}, dialog.widthBox()->value()));
        QVERIFY(std::abs(print.heightBox()->value() - 95.2) < 0.2);
        print.unitBox()->setCurrentIndex(1);
        dialog.widthBox()->setValue(450);
        QCOMPARE(print.widthBox()->value(), 3.0);
        ExportDialog next(bench.editor, shown);
        QCOMPARE(next.print()->unitBox()->currentIndex(), 1);
    }

    void sizesOnPaperAreTypedInAnyUnit()
    {
        Bench bench;
        ExportDialog dialog(bench.editor, shown);
        dialog.show();
        QVERIFY(QTest::qWaitForWindowActive(&dialog));
        PrintRows &print = *dialog.print();
        print.unitBox()->setCurrentIndex(0);
        enter(*print.widthBox(), "4in");
        QCOMPARE(print.widthBox()->value(), 101.6);
        QCOMPARE(dialog.widthBox()->value(), 600);
        enter(*print.widthBox(), "12.7cm");
        QCOMPARE(print.widthBox()->value(), 127.0);
        print.unitBox()->setCurrentIndex(1);
        QCOMPARE(print.widthBox()->text(), QString("5")); // The unit stands beside it.
        enter(*print.widthBox(), "50.8 mm");
        QCOMPARE(print.widthBox()->value(), 2.0);
        QCOMPARE(dialog.widthBox()->value(), 300);
    }

    /// The area's numbers count as the rulers do and say so, and what nobody touches keeps what is not shown.
    void areasSayTheirUnit()
    {
        const CanvasAids usual = settings::canvasAids();
        CanvasAids aids = usual;
        aids.rulerUnits = RulerUnits::Millimetres;
        settings::setCanvasAids(aids);
        Bench bench;
        QWidget window;
        new LengthUnits(window, 150);
        {
            ExportDialog dialog(bench.editor, shown, &window);
            dialog.show();
            QVERIFY(QTest::qWaitForWindowActive(&dialog));
            const Rect area = Rect::of(10, 20, 1240, 1754);
            dialog.area()->setNumbers(area);
            const auto &numbers = dialog.area()->numbers();
            QCOMPARE(numbers[2]->text(), QString("209.97"));
            QTest::keyClick(numbers[2], Qt::Key_Tab);
            numbers[2]->interpretText();
            QCOMPARE(dialog.area()->area(), area);
            const auto labels = numbers[2]->parentWidget()->findChildren<QLabel *>();
            QVERIFY(std::ranges::any_of(labels, [](const QLabel *label) { return label->text() == "mm"; }));
        }
        settings::setCanvasAids(usual);
    }

    /// A sheet that was made for paper is exported at its size on paper, whatever another painting was printed at last,
    /// and also when it was saved in between.
    void theSizeOnPaperIsKept()
    {
        ExportSettings other;
        other.path = "/elsewhere/other.png";
        other.numbers = Rect::of(0, 0, 10, 10);
        other.dpi = 300;
        exports::remember({}, other);
        Editor made;
        Canvas canvas = Editor::usualCanvas();
        canvas.width = 709, canvas.height = 531; // 120 × 90 mm at 150 units an inch
        made.newPainting(canvas, 150);
        QCOMPARE(made.resolution(), 150.0);
        const QString file = m_folder->filePath("paper.suffuse");
        made.startSaving(file);
        QTRY_VERIFY_WITH_TIMEOUT(made.filePath() == file && !made.isSaving(), 20000);
        Editor editor;
        QCOMPARE(editor.resolution(), usualResolution);
        QVERIFY(editor.open(file));
        QCOMPARE(editor.resolution(), 150.0);

        ExportDialog dialog(editor, shown);
        dialog.show();
        PrintRows &print = *dialog.print();
        print.unitBox()->setCurrentIndex(0);
        QCOMPARE(print.dpi(), 150.0);
        QCOMPARE(print.widthBox()->value(), 120.1);
        QCOMPARE(print.heightBox()->value(), 89.9);
        dialog.path()->setText(m_folder->filePath("paper.png"));
        QTest::mouseClick(dialog.exportButton(), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(dialog.result(), int(QDialog::Accepted), 20000);
        const QImage written(m_folder->filePath("paper.png"));
        QCOMPARE(written.size(), QSize(709, 531));
        QVERIFY(std::abs(1000.0 * written.width() / written.dotsPerMeterX() - 120) < 0.1);

        ExportDialog finer(editor, shown); // More pixels for the same paper.
        finer.print()->unitBox()->setCurrentIndex(0);
        QCOMPARE(finer.print()->dpi(), 150.0); // its own last export
        editor.newPainting(canvas, 150);
        ExportDialog fresh(editor, shown);
        fresh.print()->dpiBox()->setValue(300);
        QCOMPARE(fresh.widthBox()->value(), 1418);
        QCOMPARE(fresh.print()->widthBox()->value(), 120.1);
        editor.newPainting(canvas);
        QCOMPARE(ExportDialog(editor, shown).print()->dpi(), 150.0); // the last export of any painting
    }

    void whatWasExportedLastIsKept()
    {
        Bench bench;
        const QString file = m_folder->filePath("kept.suffuse"), picture = m_folder->filePath("out/kept.tif");
        QVERIFY(QDir(m_folder->path()).mkpath("out"));
        bench.editor.startSaving(file);
        QTRY_VERIFY_WITH_TIMEOUT(bench.editor.filePath() == file && !bench.editor.isSaving(), 20000);
        ExportSettings settings;
        {
            ExportDialog dialog(bench.editor, shown);
            dialog.show();
            dialog.path()->setText(picture);
            dialog.depth()->setCurrentIndex(dialog.depth()->findData(int(ImageDepth::Bits16)));
            dialog.area()->setNumbers(Rect::of(45.5, 90.25, 60, 20));
            dialog.widthBox()->setValue(120);
            dialog.print()->dpiBox()->setValue(150);
            dialog.transparent()->setChecked(true);
            dialog.moment()->choose(MomentRow::Choice::Time, 125'000);
            settings = dialog.settings();
            QTest::mouseClick(dialog.exportButton(), Qt::LeftButton);
            QTRY_COMPARE_WITH_TIMEOUT(dialog.result(), int(QDialog::Accepted), 20000);
        }
        QCOMPARE(settings.image({}).dpi, 150.0);
        ExportDialog again(bench.editor, shown);
        QVERIFY(again.settings() == settings);
        Bench other; // another painting has format and resolution, not area, size and moment
        ExportDialog elsewhere(other.editor, shown);
        QVERIFY(elsewhere.path()->text().endsWith(".tif"));
        QCOMPARE(elsewhere.depth()->currentData().toInt(), int(ImageDepth::Bits16));
        QCOMPARE(elsewhere.print()->dpi(), 150.0);
        QCOMPARE(elsewhere.area()->choice(), AreaRow::Choice::Canvas);
        QCOMPARE(elsewhere.widthBox()->value(), 1024);
        QCOMPARE(elsewhere.moment()->choice(), MomentRow::Choice::Dried);
    }

    void browsingAppendsTheEnding()
    {
        Bench bench;
        ExportDialog dialog(bench.editor, shown);
        dialog.show();
        QPushButton *browse = nullptr;
        for (auto *button : dialog.findChildren<QPushButton *>())
            if (button->text().remove('&').startsWith("Browse"))
                browse = button;
        QVERIFY(browse);
        dialog.path()->setText(m_folder->filePath("picture.tiff"));
        int answered = 0;
        for (const auto &[name, wanted] :
             {std::pair("edited v1.0", "edited v1.0.tiff"), {"22.11.2026", "22.11.2026.tiff"}, {"a.webp", "a.webp"}}) {
            whenAskedForFile(&dialog, answered, m_folder->filePath(name));
            browse->click();
            QCOMPARE(dialog.path()->text(), m_folder->filePath(wanted));
        }
        QCOMPARE(answered, 3);
    }

    void momentsFollowTheCanvas()
    {
        Bench bench;
        bench.editor.clock().setManual(true);
        ExportDialog dialog(bench.editor, shown);
        const ClockBox &clock = *dialog.moment()->clock();
        QCOMPARE(clock.text(), clockText(bench.editor.document().painting()->end()));
        dialog.moment()->box()->setCurrentIndex(int(MomentRow::Choice::Now));
        bench.editor.clock().setTime(250'000);
        QCOMPARE(clock.text(), clockText(250'000));
        QCOMPARE(dialog.moment()->moment(), Microseconds(250'000));
        dialog.moment()->clock()->stepUp();
        QCOMPARE(dialog.moment()->choice(), MomentRow::Choice::Time);
        bench.editor.clock().setTime(500'000);
        QCOMPARE(dialog.moment()->moment(), Microseconds(350'000));
    }

    void timesAreTypedAsClocksShowThem_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("seconds"); ///< NaN: refused
        QTest::newRow("as shown") << clockText(62'345'000) << 62.345;
        QTest::newRow("before the beginning") << clockText(-2'500'000) << -2.5;
        QTest::newRow("seconds") << "62.345" << 62.345;
        QTest::newRow("decimal comma") << "1:02,5" << 62.5;
        QTest::newRow("unit") << " 3 s" << 3.0;
        QTest::newRow("hours") << "1:00:01" << 3601.0;
        QTest::newRow("many seconds") << "1:90" << 150.0;
        QTest::newRow("nothing") << "" << qQNaN();
        QTest::newRow("no number") << "soon" << qQNaN();
        QTest::newRow("too many colons") << "1:2:3:4" << qQNaN();
        QTest::newRow("half a minute") << "1.5:00" << qQNaN();
        QTest::newRow("hex") << "0x10" << qQNaN();
    }
    void timesAreTypedAsClocksShowThem()
    {
        QFETCH(const QString, text);
        QFETCH(const double, seconds);
        const std::optional<Microseconds> time = timeOfClock(text);
        QCOMPARE(time.has_value(), !std::isnan(seconds));
        if (time)
            QCOMPARE(*time, toMicroseconds(seconds));
    }

    void exportRefusesWithAReason()
    {
        Bench bench;
        ExportDialog dialog(bench.editor, shown);
        dialog.show();
        dialog.widthBox()->setValue(32);
        const auto refused = [&](const QString &name) {
            dialog.path()->setText(m_folder->filePath(name));
            QTest::mouseClick(dialog.exportButton(), Qt::LeftButton);
            return QTest::qWaitFor([&] { return dialog.hint()->isVisible() && !dialog.isExporting(); }, 20000);
        };
        QVERIFY(refused("picture.doc"));
        QVERIFY(dialog.hint()->text().contains("png"));
        QVERIFY(refused("no/such/folder/picture.pfm"));
        QVERIFY(dialog.hint()->text().contains("folder"));
        QVERIFY(dialog.isVisible());
        QCOMPARE(QDir(m_folder->path()).entryList(QDir::Files).filter("picture").size(), 0);
    }

    void cancelledExportLeavesNothing()
    {
        Bench bench(200);
        ExportDialog dialog(bench.editor, shown);
        dialog.show();
        dialog.widthBox()->setValue(4000);
        dialog.path()->setText(m_folder->filePath("large.pfm"));
        dialog.depth()->setCurrentIndex(dialog.depth()->findData(int(ImageDepth::Float)));
        QTest::mouseClick(dialog.exportButton(), Qt::LeftButton);
        QVERIFY(dialog.isExporting());
        dialog.reject();
        QTRY_VERIFY_WITH_TIMEOUT(!dialog.isExporting(), 60000);
        QVERIFY(dialog.isVisible()); // it can be tried again
        QVERIFY(dialog.exportButton()->isEnabled());
        QCOMPARE(QDir(m_folder->path()).entryList(QDir::Files).filter("large").size(), 0);
    }

private:
    std::unique_ptr<QTemporaryDir> m_folder;
};

QTEST_MAIN(TestExportDialog)
#include "test_export_dialog.moc"
